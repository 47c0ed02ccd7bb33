# SPDX-License-Identifier: GPL-3.0-or-later
"""A scene of Python as the library takes it: the text of an input, and values that no text has, such as arrays."""

from collections.abc import Mapping

import h5py
import numpy as np

from .errors import InputError
from .fit_text import block, plain
from .values import in_unit, numbers_of


def split_scene(groups, title=None, sweep=None, together=()):
    """The text of the input of a scene, and the values that come later by their names: arrays, tables and quantities with a unit.

    Sweeps stand in the text, where numbers alone are given, so that the text says what was swept.
    """
    job = groups.get("job", {})
    if not isinstance(job, dict):
        block("job", job)
    text, later = block("job", {"title": title, **job}), {}
    for group, values in groups.items():
        if group == "job":
            continue
        if not isinstance(values, dict):
            block(group, values)
        values = {plain(name): value for name, value in values.items()}
        stays = {name: value for name, value in values.items() if not is_later(value)}
        later.update({f"{group}%{name}": value for name, value in values.items() if name not in stays})
        # a group whose values all come later is there as well
        text += block(group, stays) or (f"&{group}\n/\n" if len(stays) < len(values) else "")
    for name, values in (sweep or {}).items():
        if together or has_unit(values):
            later[plain(name)] = values
        else:
            text += block("sweep", {"variable": plain(name), "values": values})
    return text, later


def is_later(value):
    """Is a value one that no text has?"""
    if value is None or isinstance(value, (str, bool, int, float)):
        return False
    if has_unit(value) or is_table(value):
        return True
    if isinstance(value, (list, tuple)):
        # words stand in the text, and so does what is neither, which is refused there
        return len(value) > 0 and not all(isinstance(one, str) for one in value)
    return hasattr(value, "dims") or np.ndim(value) > 0


def has_unit(value):
    """Is it a quantity, or an array that states its unit?"""
    return hasattr(value, "magnitude") or hasattr(value, "dims")


def is_table(value):
    """Has it columns by their names?"""
    return isinstance(value, Mapping) or hasattr(value, "columns") and hasattr(value, "keys")


def array_of(value, variable, name):
    """An array of the columns of a table, in the order of its variable; anything else stays as it is."""
    if not is_table(value):
        return value
    if variable is None or not variable.columns:
        raise InputError(f"{name}: given a table, allowed: {variable.allowed if variable else 'a number, a word or an array'}")
    missing = [column for column in variable.columns if column not in value]
    if missing:
        raise InputError(f"{name}: the table has no {', '.join(missing)}, allowed: columns {', '.join(variable.columns)}")
    columns = [numbers_of(in_unit(value[column], unit, f"{name}: column {column}")[0], f"{name}: column {column}")
               for column, unit in zip(variable.columns, variable.column_units)]
    if any(column.ndim != 1 for column in columns) or len({column.size for column in columns}) != 1:
        raise InputError(f"{name}: given columns of the shapes {', '.join(str(column.shape) for column in columns)}, allowed: one length for all")
    return np.ascontiguousarray(columns)


def write_arrays(groups, table, folder):
    """The groups of a scene as the text of a fit has them: numbers in SI units, lists, and the names of datasets that are written here."""
    written = {}
    for group, values in groups.items():
        if group == "job" or not isinstance(values, dict):
            continue
        written[group] = {}
        for name, value in values.items():
            name = plain(name)
            written[group][name] = value
            if not is_later(value):
                continue
            key = f"{group}%{name}"
            variable = table.get(key)
            value, _ = in_unit(array_of(value, variable, key), variable.unit, key)
            if np.ndim(value) > 0 and variable.kind == "array" and not (variable.is_list and np.ndim(value) == 1):
                value = write_dataset(folder/f"{group}_{name}.h5", name, numbers_of(value, key), variable.columns)
            written[group][name] = value
    return written


def write_dataset(path, name, values, columns):
    """Write an array, or the columns of a group, and give back its name for an input."""
    with h5py.File(path, "w") as file:
        if columns and values.ndim == 2 and len(values) == len(columns):
            for column, numbers in zip(columns, values):
                file[f"{name}/{column}"] = numbers
        else:
            file[name] = values
    return f"{path}:/{name}"
