# SPDX-License-Identifier: GPL-3.0-or-later
"""The text of the input of a fit, as `adfric fit` reads it."""

import keyword

import numpy as np

from .errors import InputError
from .tables import models
from .values import in_unit, is_logical, is_number, is_whole_number, number_of, numbers_of, single_of, whole_number_of


def block(group, values):
    """A namelist group with the values that are given; None is the default. Empty where nothing is given."""
    if not isinstance(values, dict):
        raise InputError(f"{group}: given {values!r}, allowed: a dictionary of the variables of &{group}")
    lines = [f"  {name} = {literal(value, name)}\n" for name, value in values.items() if value is not None]
    return f"&{group}\n{''.join(lines)}/\n" if lines else ""


def literal(value, name):
    """A value as it stands in an input."""
    if not isinstance(name, str) or not name.isidentifier():
        raise InputError(f"{name!r}: no name of a variable")
    value = single_of(value)
    if isinstance(value, str):
        return quoted(value, name)
    if is_logical(value):
        return ".true." if value else ".false."
    if is_whole_number(value):
        return str(whole_number_of(value, name))
    if is_number(value):
        return written(number_of(value, name), name)
    if isinstance(value, (list, tuple)) and value and all(isinstance(one, str) for one in value):
        return ", ".join(quoted(one, name) for one in value)
    values = numbers_of(value, name)
    if values.ndim != 1 or values.size == 0:
        raise InputError(f"{name}: given an array of shape {values.shape}, allowed in a fit: numbers, words and lists of numbers")
    return ", ".join(written(float(one), name) for one in values)


def quoted(text, name):
    """A text in quotes."""
    if not text.isprintable():
        raise InputError(f"{name}: given {text!r}, allowed: a text of one line, without control characters")
    return "'" + text.replace("'", "''") + "'"


def written(number, name):
    """A number with all its digits."""
    if not np.isfinite(number):
        raise InputError(f"{name}: given {number}, allowed: a number")
    return repr(number)


def free_blocks(free):
    """A group for each free variable."""
    names = free_names(free)
    for name, given in zip(names, free.values() if isinstance(free, dict) else [None]*len(names)):
        yield block("free", {"variable": name, **(given or {})})


def free_names(free):
    """Names of the free variables."""
    names = [free] if isinstance(free, str) else list(free)
    for name in names:
        if not isinstance(name, str):
            raise InputError(f"free: given {name!r}, allowed: names of variables")
    return [plain(name) for name in names]


def plain(name):
    """A name without the underscore that makes it none of Python's words."""
    return name[:-1] if name.endswith("_") and keyword.iskeyword(name[:-1]) else name


def variable_blocks(model, variables):
    """The groups of the variables of a model."""
    if not isinstance(model, str) or model not in models():
        # the library says which there are
        return
    table = models()[model].variables
    groups = {}
    for name, value in variables.items():
        name = plain(name)
        pairs = {f"{name}%{inner}": part for inner, part in value.items()} if isinstance(value, dict) else {name: value}
        for key, part in pairs.items():
            variable = table.get(key) or next((one for one in table.values() if f"{one.group}%{one.name}" == key), None)
            if variable is None:
                # the library says what was meant
                group, _, inner = key.rpartition("%")
                groups.setdefault(group or groups_of(table)[0], {})[inner] = part
                continue
            value_in_unit, _ = in_unit(part, variable.unit, key)
            groups.setdefault(variable.group, {})[variable.name] = value_in_unit
    for group, values in groups.items():
        yield block(group, values)


def groups_of(table):
    """Names of the groups of a model."""
    return list(dict.fromkeys(variable.group for variable in table.values()))
