# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of what the user has chosen: several files together, any result against any other, and points of a table.

Several files have a colour each, and dashes for their curves. Where all have the same curves, those of the same other swept values, a
colour stands for the curve, and what files with few values have found are points upon the curve of the one with many.
"""

import difflib
import os.path

import numpy as np

from .adhesion import RELATIVE, add_pull_off
from .along import are_profiles, draw_along
from .curves import add_legend, find_curves, leave_out_pole, load_of, passes_zero, without_pole
from .doubts import is_doubted, shade_doubts
from .labels import axis_label, point_label, scale_of
from .results import RENAMED, BadFile, Field, NothingToDraw
from .jumps import draw_curve, find_jumps, way_of
from .printable import literal
from .rubber import contact_share
from .sphere import draw_limits
from .style import COLOURS, DASHES, MISSED, is_logarithmic, label_few_decades, make_panels

try:
    from ..importing.problems import BadInput, FileFailure
    from ..importing.quantities import read_unit
    from ..importing.tables import read_table
except ImportError:
    # not as a part of the package, but beside it
    from importing.problems import BadInput, FileFailure
    from importing.quantities import read_unit
    from importing.tables import read_table

# curves of so many values or less have a mark at each
MOST_MARKED = 30
# of several files with the same curves
LINES, MARKS = ("-", "--", ":", "-."), "os^Dv"
# limits of a pull-off in time, each with its dashes
TIMED_LIMITS = {"relaxed_pull_off_load": ":", "frozen_pull_off_load": "--", "glassy_pull_off_load": "-."}
# what ends a word of a title
BREAKS = " ,;:("


def draw_chosen(runs, x_name, y_names, table):
    """The figure, and its title: what the titles of the runs have in common."""
    from .figures import choose_results

    if are_profiles(runs[0], [name for name in [x_name, *(y_names or [])] if name]):
        if len(runs) > 1 or table or not y_names:
            raise BadFile(f"{runs[0].path}: profiles are drawn of one file, with --y and without --data")
        return draw_along(runs[0], x_name, y_names), runs[0].title
    for results in runs:
        _add_share(results)
        _add_conductances(results)
        add_pull_off(results)
    x_name = x_name or _last_swept(runs[0])
    y_names = y_names or _default_results(runs, x_name, choose_results)
    for results in runs:
        for name in [x_name, *y_names]:
            _check_name(results, name)
    points = _read_table(table, {name: _field_of(runs[0], name).unit for name in [x_name, *y_names]}) if table else {}
    for name in [x_name, *y_names]:
        if not any(np.isfinite(values).any() for values in [*(results.values(name) for results in runs), points.get(name, [])]):
            raise NothingToDraw(f"{runs[0].path}: {name} has no value at any point: nothing to draw")
    scales = {name: _common_scale(runs, name, points) for name in [x_name, *y_names]}
    figure, panels = make_panels(len(y_names))
    title, names = _split_titles(runs)
    looks = _looks_of(runs, names, x_name)
    for panel, y_name in zip(panels, y_names):
        for results, look in zip(runs, looks):
            _draw_run(panel, results, (x_name, y_name), scales, look)
        if y_name in points:
            panel.plot(points[x_name] * scales[x_name][0], points[y_name] * scales[y_name][0], "o", color=MISSED, markersize=4,
                       fillstyle="none", label=literal(table.stem))
        if y_name == "pull_off_load" and len(runs) == 1:
            _draw_timed_limits(panel, runs[0], x_name, scales)
        _finish_panel(panel, runs, x_name, y_name, scales)
    handles, labels = panels[0].get_legend_handles_labels()
    if len(labels) > 1:
        add_legend(figure, panels[0], handles, labels)
    return figure, title


def _add_share(results):
    """Give strips the share of the nominal area in contact, which other models have as a result."""
    if results.model == "wavy_sliding" and "contact_fraction" not in results.fields:
        share = contact_share(results)
        if share is not None:
            results.fields[share.name] = share


def _add_conductances(results):
    """Give theories of rough surfaces the conductances of Wang and Mueser under the names that they have on cells."""
    for name in ("electrical_conductance", "thermal_conductance"):
        if name not in results.fields and (field := results.fields.get(f"{name}_wang_mueser")):
            results.fields[name] = Field(name, field.unit, field.values)


def _looks_of(runs, names, x_name):
    """For each run a label and a style for each of its curves."""
    curves = [find_curves(results, _along(results, x_name)) for results in runs]
    counts = [_axis(results, _along(results, x_name)).values.size for results in runs]
    marks = [{"marker": "o", "markersize": 3} if count <= MOST_MARKED else {} for count in counts]
    if len(runs) == 1:
        return [[(curve.label, {**curve.style, **marks[0]}) for curve in curves[0]]]
    same = all(_others(results, x_name) == _others(runs[0], x_name) for results in runs) and len(curves[0]) <= len(COLOURS)
    are_points = [count <= MOST_MARKED < max(counts) for count in counts]
    if same and (len(curves[0]) > 1 or any(are_points)):
        styles = [{"linestyle": LINES[place % len(LINES)], **mark} for place, mark in enumerate(marks)]
        for place in np.flatnonzero(are_points):
            styles[place] = {"linestyle": "none", "marker": MARKS[place % len(MARKS)], "markersize": 4, "fillstyle": "none"}
    else:
        styles = [{"color": COLOURS[place % len(COLOURS)], **mark} for place, mark in enumerate(marks)]
    looks = []
    for place, (name, style, some) in enumerate(zip(names, styles, curves)):
        looks.append([])
        for number, curve in enumerate(some):
            colour = number if len(some) > 1 else place % len(COLOURS)
            rest = {"color": COLOURS[colour]} if "linestyle" in style else {"linestyle": DASHES[(place + number) % len(DASHES)]}
            looks[-1].append((", ".join(part for part in (literal(name), curve.label) if part), {**style, **rest}))
    return looks


def _draw_run(panel, results, names, scales, look):
    """The curves of a run."""
    x_name, y_name = names
    along = _along(results, x_name)
    k = results.axis_names.index(along)
    doubted = is_doubted(results)
    for curve, (label, style) in zip(find_curves(results, along), look):
        x, y = (np.moveaxis(results.values(name), k, -1)[curve.index] for name in names)
        if y_name == "friction_coefficient":
            y = without_pole(y, load_of(results, k, curve.index))
        order = np.argsort(results.axes[k].values)
        if doubted is not None:
            shade_doubts(panel, x[order] * scales[x_name][0], y[order] * scales[y_name][0],
                         np.moveaxis(doubted, k, -1)[curve.index][order])
        draw_curve(panel, x[order] * scales[x_name][0], y[order] * scales[y_name][0], find_jumps(results, k, curve.index),
                   way_of(results), label=label or "_", **style)


def _draw_timed_limits(panel, results, x_name, scales):
    """Beside the pull-off loads of a single curve those of the relaxed, the frozen and the instantaneous solid, as far as there are."""
    if [axis.name for axis in results.several] != [x_name]:
        return
    x = results.values(x_name).ravel()
    order = np.argsort(x)
    for name, dashes in TIMED_LIMITS.items():
        limit = results.values(name).ravel() if name in results.fields else np.full(x.size, np.nan)
        if np.isfinite(limit).any():
            panel.plot(x[order] * scales[x_name][0], limit[order] * scales["pull_off_load"][0], color="0.5", linestyle=dashes, linewidth=1,
                       label=name.split("_")[0])
    if len(panel.lines) > 1:
        panel.lines[0].set_label("in time")


def _finish_panel(panel, runs, x_name, y_name, scales):
    """Labels, and lines through 0."""
    if all(_is_logarithmic(results, x_name) for results in runs):
        panel.set_xscale("log")
        label_few_decades(panel, np.concatenate([results.values(x_name).ravel() for results in runs]) * scales[x_name][0])
    else:
        low, high = panel.get_xlim()
        if low < 0 < high:
            panel.axvline(0, color="0.7", linewidth=0.6, zorder=0)
    if y_name == "friction_coefficient" and any(passes_zero(_loads(results)) for results in runs):
        leave_out_pole(panel, np.concatenate([results.values(y_name).ravel() for results in runs]) * scales[y_name][0])
    elif not any(np.nanmin(results.values(y_name), initial=0.0) < 0 for results in runs) and panel.dataLim.y0 >= 0:
        panel.set_ylim(bottom=0)
    if y_name == RELATIVE and not any("approach" in [*results.axis_names, *results.constants] for results in runs):
        draw_limits(panel, "load")
    low, high = panel.get_ylim()
    if low < 0 < high:
        panel.axhline(0, color="0.7", linewidth=0.6, zorder=0)
    panel.set_xlabel(axis_label(x_name, scales[x_name][1]))
    panel.set_ylabel(axis_label(y_name, scales[y_name][1]))


def _is_logarithmic(results, name):
    """Is a swept variable spread over decades, or Maugis's lambda, which follows from one?"""
    return (name in results.axis_names or name == "lambda") and is_logarithmic(np.unique(results.values(name)))


def _loads(results):
    """All loads of a run; none where it has no load, or one that is given."""
    known = "load" in [*results.fields, *results.axis_names]
    return results.values("load").ravel() if known else np.empty(0)


def _along(results, x_name):
    """The swept variable along the curves."""
    return x_name if x_name in results.axis_names else _last_swept(results)


def _others(results, x_name):
    """What tells the curves of a run apart, in words."""
    others = [axis for axis in results.several if axis.name != _along(results, x_name)]
    return [[point_label([(axis, value)], results.model) for value in axis.values] for axis in others]


def _last_swept(results):
    """The swept variable with several values that varies fastest."""
    if not results.several:
        raise NothingToDraw(f"{results.path}: one point: nothing to draw")
    return results.several[-1].name


def _default_results(runs, x_name, choose_results):
    """The result worth drawing most that all runs have."""
    common = [name for name in choose_results(runs[0]) if name != x_name and all(name in results.fields for results in runs)]
    if not common:
        raise NothingToDraw(f"{runs[0].path}: no result of all files varies: nothing to draw; --y says what to draw")
    return common[:1]


def _check_name(results, name):
    """Is there a quantity of this name?"""
    known = [*results.axis_names, *results.fields]
    if name in known:
        if not results.several:
            raise NothingToDraw(f"{results.path}: one point: nothing to draw")
        return
    if RENAMED.get(name) in known:
        raise BadFile(f"{results.path}: {name} is called {RENAMED[name]} now")
    if name in results.states or name == "status":
        raise BadFile(f"{results.path}: {name} is a state, not a number")
    if name in results.constants:
        raise BadFile(f"{results.path}: {name} has one value in the whole run")
    near = difflib.get_close_matches(name, known, n=1, cutoff=0.5)
    question = f"; did you mean {near[0]}?" if near else f", allowed: {', '.join(known)}"
    raise BadFile(f"{results.path}: no variable or result of this name, given {name}{question}")


def _axis(results, name):
    return results.axes[results.axis_names.index(name)]


def _field_of(results, name):
    """A result or a swept variable."""
    return results.fields[name] if name in results.fields else _axis(results, name)


def _common_scale(runs, name, points):
    """Factor and unit of a quantity in all runs and the table."""
    fields = [_field_of(results, name) for results in runs]
    for results, field in zip(runs, fields):
        if field.unit != fields[0].unit:
            units = ["reduced units" if unit == "-" else unit for unit in (field.unit, fields[0].unit)]
            raise BadFile(f"{results.path}: {name} is in {units[0]}, but in {units[1]} in {runs[0].path}")
    values = np.concatenate([*(np.ravel(field.values) for field in fields), points.get(name, [])])
    return scale_of(values, fields[0].unit)


def _split_titles(runs):
    """What all titles begin with, and what is left of each; the models or names of files where that tells nothing."""
    titles = [results.title for results in runs]
    if len(runs) == 1:
        return titles[0], [""]
    common = os.path.commonprefix(titles)
    # whole words
    while common[-1:] not in BREAKS and not all(title[len(common):][:1] in BREAKS for title in titles):
        common = common[:-1]
    rests = [title[len(common):].strip(" ,;():") for title in titles]
    if len(set(rests)) < len(runs) or not all(rests):
        # one of them may say what all are about
        title = common if common in titles else ""
        models = [results.model for results in runs]
        return title, models if len(set(models)) == len(runs) else [results.path.stem for results in runs]
    return common.strip(" ,;(:"), rests


def _read_table(path, units):
    """Columns of a table by the names in `units`, in these units; a column without a unit has that of the results."""
    if not path.is_file():
        raise BadFile(f"{path}: no such file")
    try:
        table = read_table(path, needs_names=True)
        places = {name: table.place_of(name) for name in units}
        first, *others = units
        given = ", ".join(head.text for head in table.heads)
        if places[first] is None:
            near = difflib.get_close_matches(first, [head.name for head in table.heads], n=1, cutoff=0.5)
            raise BadFile(f"{path}: no column {first}, given {given}" + (f"; is it {near[0]}?" if near else ""))
        if all(places[name] is None for name in others):
            raise BadFile(f"{path}: no column {' or '.join(others)}, given {given}")
        return {name: _in_unit(table.column(place), table.unit(place), units[name], f"{path}: column {name}")
                for name, place in places.items() if place is not None}
    except (BadInput, FileFailure) as problem:
        raise BadFile(str(problem)) from None


def _in_unit(values, stated, wanted, column):
    """Values of a column in the unit of the results."""
    if not stated or stated == wanted:
        return values
    unit, own = read_unit(stated), read_unit(wanted)
    if unit is None or own is None or unit.powers != own.powers:
        raise BadFile(f"{column} is in {stated}, the results in {'reduced units' if wanted == '-' else wanted}")
    exponent = unit.exponent - own.exponent
    return values * 10.0**exponent if exponent >= 0 else values / 10.0**-exponent
