# SPDX-License-Identifier: GPL-3.0-or-later
"""Measured points as a fit takes them: tables in memory, and stacks of curves in a file of their own."""

import os
import re
from collections.abc import Mapping
from dataclasses import dataclass

import h5py
import numpy as np

from .errors import InputError
from .files import name_of
from .tables import models
from .values import in_unit, numbers_of

# what the variables of &data call the columns, with the names that columns have by default
NAMED = {"abscissa_column": "abscissa", "ordinate_column": "ordinate", "sigma_column": "sigma", "abscissa_sigma_column": None,
         "branch_column": "branch", "segment_column": "segment"}
WITH_UNIT = re.compile(r"\s*(.*?)\s*\[([^\[\]]*)\]\s*")


@dataclass
class Table:
    """Columns of numbers; shape (n_columns, n)."""

    name: str
    columns: list
    units: list
    values: np.ndarray


def group_of(given, defaults, model, name, folder):
    """The variables of a `&data` group, and the table that it names; None where that is a file."""
    options = dict(defaults)
    if isinstance(given, Mapping) and "file" in given:
        options.update(given)
        given = options.pop("file")
    if isinstance(given, (str, bytes, os.PathLike)):
        return {**options, "file": name_of(given, name)}, None
    columns = columns_of(given, options, model, name)
    ordinate = columns.get(options.get("ordinate_column") or options.get("ordinate"))
    if ordinate is not None and ordinate[0].ndim > 1:
        return {**options, "file": write_stack(columns, options, name, folder)}, None
    return {**options, "file": name}, table_of(columns, name)


def columns_of(given, options, model, name):
    """Numbers and units by the name of the column."""
    if hasattr(given, "dims") and hasattr(given, "to_dataset"):
        # an array of xarray with its coordinates
        given = given.to_dataset(name=given.name or options.get("ordinate_column") or options.get("ordinate") or "ordinate")
    if hasattr(given, "data_vars"):
        given = columns_of_dataset(given, options, name)
    if not hasattr(given, "keys"):
        raise InputError(f"{name}: given {type(given).__name__}, allowed: columns by their names, the path of a table, or a list of these")
    columns = {}
    for key in given.keys():
        if not isinstance(key, str):
            raise InputError(f"{name}: given the column {key!r}, allowed: names")
        stated = WITH_UNIT.fullmatch(key)
        column, unit = (stated[1], stated[2].strip()) if stated else (key, "")
        columns[column] = column_of(given[key], column, unit, options, model, name)
    return columns


def column_of(values, column, unit, options, model, name):
    """The numbers of a column, and their unit, which is empty for SI units."""
    label = f"{name}: column {column}"
    if hasattr(values, "magnitude") or hasattr(getattr(values, "data", None), "magnitude"):
        values, _ = in_unit(values, unit_of(column, options, model), label)
        unit = ""
    stated = getattr(values, "attrs", {}).get("units") if not unit else None
    if stated is not None:
        unit = str(stated)
    if hasattr(values, "to_numpy"):
        values = values.to_numpy()
    return numbers_of(values, label), "" if unit in ("1", "-") else unit


def unit_of(column, options, model):
    """The unit in which a fit takes a column."""
    known = models()[model] if isinstance(model, str) and model in models() else None
    names = {options.get("abscissa_column") or options.get("abscissa"): options.get("abscissa"),
             options.get("abscissa_sigma_column"): options.get("abscissa"),
             options.get("ordinate_column") or options.get("ordinate"): options.get("ordinate"),
             options.get("sigma_column") or "sigma": options.get("ordinate")}
    names.update(variable_columns(options))
    wanted = names.get(column)
    if wanted is not None and hasattr(model, "unit"):
        return model.unit(wanted)
    if known is None or wanted is None:
        return "1"
    if wanted == options.get("ordinate") and wanted in known.results and column != options.get("abscissa_column"):
        return known.results[wanted].unit
    return known.variables[wanted].unit if wanted in known.variables else "1"


def variable_columns(options):
    """Columns of the variables that have a value for each point, and the names of these."""
    variables, columns = (words_of(options.get(name) or ()) for name in ("variables", "variable_columns"))
    return dict(zip(columns or variables, variables))


def words_of(given):
    """One word, or several."""
    return [given] if isinstance(given, str) else list(given)


def columns_of_dataset(given, options, name):
    """The columns of a dataset of xarray: those that a fit can use, each over the dimension of the points, the last one of the ordinate."""
    key = options.get("ordinate_column") or options.get("ordinate")
    if key not in given:
        raise InputError(f"{name}: the dataset has no {key}, allowed: {', '.join(map(str, given.data_vars))}")
    dimensions = given[key].dims
    if not dimensions:
        raise InputError(f"{name}: {key} is a single number, allowed: an array")
    wanted = {options.get(option) or (options.get(usual) or usual) for option, usual in NAMED.items()
              if options.get(option) or usual} | {"contact"} | set(variable_columns(options))
    columns = {}
    for column in wanted:
        if column not in given or not given[column].dims:
            continue
        values = given[column]
        if set(values.dims) == set(dimensions):
            columns[column] = values.transpose(*dimensions)
        elif values.dims == dimensions[-1:]:
            columns[column] = values
        else:
            columns[column] = values.broadcast_like(given[key]).transpose(*dimensions).assign_attrs(values.attrs)
    return columns


def table_of(columns, name):
    """A table of columns of one length."""
    lengths = {column: values.size for column, (values, _) in columns.items()}
    if any(values.ndim != 1 for values, _ in columns.values()) or len(set(lengths.values())) != 1:
        shapes = ", ".join(f"{column} {values.shape}" for column, (values, _) in columns.items())
        raise InputError(f"{name}: given columns of the shapes {shapes or 'none'}, allowed: one length for all")
    return Table(name, list(columns), [unit for _, unit in columns.values()],
                 np.ascontiguousarray([values for values, _ in columns.values()]))


def write_stack(columns, options, name, folder):
    """Write a stack of curves where the library reads it; give back its name for `&data file`."""
    ordinate = options.get("ordinate_column") or options.get("ordinate")
    path = folder/f"{re.sub(r'[^a-z0-9]', '_', name)}.h5"
    with h5py.File(path, "w") as file:
        for column, (values, unit) in columns.items():
            file[column] = values
            if unit:
                file[column].attrs["units"] = unit
    return f"{path}:/{ordinate}"
