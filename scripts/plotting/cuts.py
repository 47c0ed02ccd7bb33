# SPDX-License-Identifier: GPL-3.0-or-later
"""Maps along straight lines: `scripts/plot FILE.h5 --cut y=0 y=x`."""

import re

import numpy as np

from .curves import add_legend
from .labels import axis_label, point_label, scale_of
from .results import BadFile, NothingToDraw
from .style import COLOURS, plt
from .surface import choose_points

# profiles that are drawn, a row each
SHOWN = ("pressure", "gap")
NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
CUT = re.compile(rf"(?:([xy])=({NUMBER})|(y=x))")
# positions that differ by less than this part of the largest one are one
SAME = 1e-9


def draw_cuts(results, cuts):
    """Pressure and gap along each line, a curve for each point of the sweep; the places are those of the samples next to the line."""
    names = [name for name in SHOWN if name in results.profiles]
    if len(results.profile_axes) != 2 or not names:
        raise NothingToDraw(f"{results.path}: no map of the pressure: nothing to cut")
    y, x = results.profile_axes
    lines = [find_line(cut, x.values, y.values) for cut in cuts]
    points = choose_points(results)
    factor, unit = scale_of(x.values, x.unit)
    figure, panels = plt.subplots(len(names), len(cuts), squeeze=False, sharex="col", sharey="row",
                                  figsize=(3.4 * len(cuts) + 0.2, 2.4 * len(names) + 0.4))
    for row, name in zip(panels, names):
        profile = results.profiles[name]
        size, profile_unit = scale_of(profile.values, profile.unit)
        for panel, cut, (along, rows, columns) in zip(row, cuts, lines):
            for number, index in enumerate(points):
                panel.plot(along * factor, profile.values[index][rows, columns] * size, color=COLOURS[number % len(COLOURS)],
                           label=label_of(results, index))
            panel.axhline(0, color="0.7", linewidth=0.6, zorder=0)
            panel.set_xlim(along[0] * factor, along[-1] * factor)
            if panel.get_subplotspec().is_first_row():
                panel.set_title(f"${cut.replace('=', ' = ')}$")
            if panel.get_subplotspec().is_last_row():
                panel.set_xlabel(distance_label(cut, x.name, y.name, unit))
        row[0].set_ylabel(axis_label(name, profile_unit))
    add_legend(figure, panels[0, 0], *panels[0, 0].get_legend_handles_labels())
    return figure


def find_line(cut, x, y):
    """Distances along a line, and the rows and columns of the samples next to it."""
    found = CUT.fullmatch(cut.replace(" ", ""))
    if not found:
        raise BadFile(f"--cut: not a line, given {cut}, allowed: y=NUMBER, x=NUMBER [m], y=x")
    name, number, _ = found.groups()
    if name is None:
        if x.size != y.size or np.max(np.abs(x - y)) > SAME * np.max(np.abs(x)):
            raise BadFile("--cut y=x: the samples along x are not those along y")
        places = np.arange(x.size)
        return np.sqrt(2.0) * x, places, places
    held, along = (y, x) if name == "y" else (x, y)
    # a value stands in the middle of its cell
    width = np.max(np.abs(np.diff(held)))
    if not held.min() - width <= float(number) <= held.max() + width:
        raise BadFile(f"--cut {cut}: beyond the map, given {number}, allowed: {held.min():g} to {held.max():g}")
    place = np.full(along.size, np.argmin(np.abs(held - float(number))))
    places = np.arange(along.size)
    return (along, place, places) if name == "y" else (along, places, place)


def distance_label(cut, x_name, y_name, unit):
    """What runs along the axis of a cut."""
    if cut.replace(" ", "") == "y=x":
        return f"Distance along $y = x$ ({unit})" if unit else "Distance along $y = x$"
    return axis_label(x_name if cut.strip().startswith("y") else y_name, unit)


def label_of(results, index):
    """What names the curve of a point: of a wave its mean pressure over that of full contact."""
    full = results.fields.get("full_contact_pressure")
    if full is None:
        return point_label(results.describe(index), results.model)
    return f"$p/p^*$ = {results.values('mean_pressure')[index] / full.values[index]:.3g}"
