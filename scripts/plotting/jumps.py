# SPDX-License-Identifier: GPL-3.0-or-later
"""Jumps of surfaces that adhere: where a curve leaps from one branch to another there is no state in between."""

import numpy as np

# what is held while such surfaces come together and part; sweeps of it can jump
CONTROLS = ("penetration", "mean_pressure")
# results that tell a jump
TELLING = ("mean_pressure", "penetration", "contact_fraction", "mean_gap")
# a step is a jump if it is so many times those beside it, more than the 2.4 of a fold, and this part of the range
STEEP, LARGE = 4.0, 0.02
FEWEST = 8
# jumps of less than this part of a curve along both axes have no arrow
SHOWN = 0.1
ARROWS = {"adhered": -1, "approach": 1, "loading": 1}


def find_jumps(results, along, index):
    """Between which neighbours of a curve, in the order of its variable, does it jump? One place less than the curve has."""
    order = np.argsort(results.axes[along].values)
    jumps = np.zeros(order.size - 1, dtype=bool)
    if results.axes[along].name not in CONTROLS or "adhesion_fraction" not in results.fields:
        return jumps
    for name in TELLING:
        if name in results.fields:
            jumps |= _leaps(np.moveaxis(results.fields[name].values, along, -1)[index][order])
    return jumps


def _leaps(values):
    """Which steps are jumps of one quantity?"""
    steps = np.abs(np.diff(values))
    if np.isfinite(values).sum() < FEWEST:
        return np.zeros(steps.size, dtype=bool)
    beside = np.fmax(np.append(0.0, steps[:-1]), np.append(steps[1:], 0.0))
    # a step next to a missing value or at an end has one neighbour at most
    has_both = np.isfinite(np.append(np.nan, steps[:-1])) & np.isfinite(np.append(steps[1:], np.nan))
    return has_both & (steps > STEEP * beside) & (steps > LARGE * np.ptp(values[np.isfinite(values)]))


def draw_curve(panel, x, y, jumps, way=0, **style):
    """A curve in the order of its variable; its jumps are thin lines, with an arrow the way that its branch is passed."""
    behind = np.flatnonzero(jumps) + 1
    # dashes above lines that are not broken: where the two are one, both are seen
    style.setdefault("zorder", 2.0 if style.get("linestyle", "-") == "-" else 2.5)
    line, = panel.plot(np.insert(x, behind, np.nan), np.insert(y, behind, np.nan), **style)
    for k in np.flatnonzero(jumps):
        ends = np.array([[x[k], y[k]], [x[k + 1], y[k + 1]]])
        panel.plot(*ends.T, color=line.get_color(), linewidth=0.7, linestyle=":", zorder=1.8)
        if way and any(abs(z[k + 1] - z[k]) > SHOWN * np.ptp(z[np.isfinite(z)]) for z in (x, y)):
            middle = ends.mean(axis=0)
            start, end = ends[::way]
            panel.annotate("", middle + 0.04 * (end - start), middle - 0.04 * (end - start), zorder=1.9,
                           arrowprops={"arrowstyle": "-|>", "color": line.get_color(), "linewidth": 0, "mutation_scale": 9,
                                       "shrinkA": 0, "shrinkB": 0})


def way_of(results):
    """How a sweep of a branch is passed: 1 for rising values, -1 for falling ones, 0 where the file does not say."""
    if "turning_pressure" in results.constants or "turning_pressure" in results.axis_names:
        return -1
    return ARROWS.get(str(results.words.get("branch")), 0)
