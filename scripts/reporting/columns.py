# SPDX-License-Identifier: GPL-3.0-or-later
"""Results as the scripts of a page want them: names with labels, and a column of numbers for each."""

from dataclasses import dataclass, field

import numpy as np

from .shared import SAMPLE_AXES, UP_TO, choose_results, find_jumps, fit, is_doubted, is_logarithmic, load_of, passes_zero, scale_of
from .words import number_of, words_of

# a quotient by the load, which has a pole where the load vanishes
QUOTIENT = "friction_coefficient"
# what is worth seeing first on a surface
FIRST_PROFILE = "pressure"


@dataclass
class Table:
    """One run: what its script is told, and the columns, each of one number for each point of the sweep.

    about     axes, names, words and limits, all plain
    columns   numbers by name, in the units of the labels
    """

    about: dict
    columns: dict = field(default_factory=dict)


def varies(values):
    """Has something more than one value?"""
    finite = values[np.isfinite(values)]
    return finite.size > 1 and np.ptp(finite) > 1e-12 * np.max(np.abs(finite))


def ordered_results(results):
    """Names of the results that vary, those first that figures show."""
    first = list(choose_results(results))
    if fit.is_fit(results):
        # the values that were looked for
        first = [name for name in results.fields if f"{name}_bound" in results.fields and varies(results.fields[name].values)] or first
    rest = [name for name, one in results.fields.items() if name not in first and varies(one.values)]
    # what is said beside another result comes last
    return first + sorted(rest, key=lambda name: name in results.beside)


def small(values):
    """Numbers of half the size, which are enough for a screen; what is no number stays so."""
    return np.ascontiguousarray(np.ravel(values), dtype=np.float32)


def axis_about(axis, is_sampled=False):
    """An axis: values in the unit of its label, and a text for each."""
    factor, unit = scale_of(axis.values, axis.unit)
    return {"name": axis.name, "label": words_of(axis.name, unit), "words": words_of(axis.name).lower(), "unit": unit,
            "values": [float(value) for value in axis.values * factor], "log": is_logarithmic(axis.values),
            "texts": [f"{words_of(axis.name).lower()} {number_of(value, axis.unit, axis.values)}" for value in axis.values],
            "sampled": is_sampled}


def table_of(results, title=""):
    """The table of a run."""
    axes = [axis_about(axis, axis.name in SAMPLE_AXES) for axis in results.axes]
    table = Table({"title": title, "axes": axes, "names": {}, "along": _last_several(results), "errors": {}, "states": {}, "owners": {},
                   "limits": {}, "jumps": []})
    for name, (values, axis) in results.companions.items():
        along = results.axis_names.index(axis)
        shape = [-1 if k == along else 1 for k in range(results.status.ndim)]
        _add(table, name, values.unit, np.broadcast_to(values.values.reshape(shape), results.status.shape))
        table.about["owners"][name] = along
    for name in ordered_results(results):
        _add(table, name, results.fields[name].unit, results.fields[name].values)
    table.about["errors"] = {name: error for name, error in results.errors.items() if {name, error} <= set(table.about["names"])}
    for name, error in table.about["errors"].items():
        # an error has the unit of what it belongs to
        factor, unit = scale_of(results.fields[name].values, results.fields[name].unit)
        table.columns[error] = small(results.fields[error].values * factor)
        table.about["names"][error].update(label=words_of(error, unit), unit=unit)
    _add_states(table, results)
    _add_jumps(table, results)
    if QUOTIENT in table.about["names"] and (limits := _limits_of_quotient(results)):
        table.about["limits"][QUOTIENT] = limits
    return table


def _last_several(results):
    """The axis that varies fastest of those with several values."""
    several = [k for k, axis in enumerate(results.axes) if axis.values.size > 1]
    return several[-1] if several else 0


def _add(table, name, unit, values):
    """A column, and what its label is."""
    factor, unit = scale_of(values, unit)
    table.columns[name] = small(values * factor)
    table.about["names"][name] = {"label": words_of(name, unit), "words": words_of(name).lower(), "unit": unit}


def _add_states(table, results):
    """Status, doubts, and results that are words, each as numbers of a list."""
    table.columns["status of point"] = np.ravel(results.status).astype(np.int8)
    doubted = is_doubted(results)
    table.columns["doubted"] = np.zeros(results.status.size, np.int8) if doubted is None else np.ravel(doubted).astype(np.int8)
    for name, values in results.states.items():
        words = sorted({word for word in values.ravel() if word is not None})
        places = {word: place for place, word in enumerate(words)}
        if len(words) > 1 or (name == "doubt" and words != ["none"]):
            table.about["states"][name] = {"words": [word.replace("_", " ") for word in words], "title": words_of(name).lower()}
            table.columns[f"word of {name}"] = np.array([places.get(word, -1) for word in values.ravel()], np.int8)


def _add_jumps(table, results):
    """Where curves along an axis leap: marks of points after which, in the order of the axis, a curve is broken."""
    for along, axis in enumerate(results.axes):
        if axis.values.size < 2:
            continue
        order = np.argsort(axis.values)
        marks = np.zeros(np.moveaxis(results.status, along, -1).shape, np.int8)
        for index in np.ndindex(*marks.shape[:-1]):
            marks[index][order[:-1]] = find_jumps(results, along, index)
        if marks.any():
            table.columns[f"jump along {axis.name}"] = np.ravel(np.moveaxis(marks, -1, along))
            table.about["jumps"].append(axis.name)


def _limits_of_quotient(results):
    """Where the axis of a quotient ends, if one of its curves has a pole; and marks where a curve is broken."""
    values = results.fields[QUOTIENT].values
    along = _last_several(results)
    if not any(passes_zero(load_of(results, along, index)) for index in np.ndindex(*np.moveaxis(values, along, -1).shape[:-1])):
        return None
    below, above = (UP_TO * float(np.median(side[side > 0])) if np.any(side > 0) else 0.0 for side in (-values, values))
    if below > 0:
        return [-max(below, above), max(below, above)]
    return [0.0, above] if above > 0 else None


def profile_tables(results):
    """A table of the profiles of a run, whose axes are those of the sweep and of the surface; None without profiles along one axis."""
    if not results.profiles or len(results.profile_axes) != 1:
        return None
    shape = results.status.shape + (results.profile_axes[0].values.size,)
    axes = [axis_about(axis) for axis in [*results.axes, results.profile_axes[0]]]
    axes[-1]["log"] = False
    table = Table({"title": "", "axes": axes, "names": {}, "along": len(axes) - 1, "errors": {}, "states": {}, "owners": {}, "limits": {},
                   "jumps": []})
    for name, profile in sorted(results.profiles.items(), key=lambda pair: pair[0] != FIRST_PROFILE):
        if profile.values.shape == shape:
            _add(table, name, profile.unit, profile.values)
    table.columns["status of point"] = np.zeros(int(np.prod(shape)), np.int8)
    table.columns["doubted"] = np.zeros(int(np.prod(shape)), np.int8)
    return table if table.about["names"] else None
