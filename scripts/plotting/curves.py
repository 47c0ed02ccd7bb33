# SPDX-License-Identifier: GPL-3.0-or-later
"""Results against a swept variable, one curve for each value of the others."""

from dataclasses import dataclass

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.lines import Line2D
from matplotlib.ticker import MaxNLocator

from .doubts import hatch_doubts, is_doubted
from .jumps import draw_curve, find_jumps, way_of
from .labels import NO_ADHESION, axis_label, point_label, scale_of, scales_of
from .results import NOT_CONVERGED
from .style import COLOURS, DASHES, MISSED, has_few_decades, is_logarithmic, label_few_decades, make_panels, norm_of, plt

MOST_CURVES = 60
MOST_PANELS = 6
MOST_IN_LEGEND = len(COLOURS)
# a legend with more entries, or longer ones, stands beside the panels
MOST_INSIDE, LONGEST_INSIDE = 4, 24
# a coefficient with a pole is drawn up to so many medians
UP_TO = 4.0


@dataclass
class Curve:
    """A curve: where it lies in the sweep, and how it is drawn."""

    index: tuple
    label: str
    style: dict


def draw_panels(results, abscissa, ordinates):
    """A panel for each result; of a single one for each value of the slowest of three other swept variables."""
    others = [axis for axis in results.several if axis.name != abscissa]
    if len(ordinates) == 1 and len(others) > 2 and others[0].values.size <= MOST_PANELS:
        parts = [(results.at(others[0].name, k), ordinates[0], point_label([(others[0], value)], results.model))
                 for k, value in enumerate(others[0].values)]
    else:
        parts = [(results, ordinate, "") for ordinate in ordinates]
    figure, panels = make_panels(len(parts))
    scales = scales_of([results.fields[ordinate] for ordinate in ordinates])
    for panel, (part, ordinate, title) in zip(panels, parts):
        curves = find_curves(part, abscissa)
        draw_curves(panel, part, abscissa, ordinate, curves, scales[ordinate])
        panel.set_title(title)
    add_key(figure, panels[0], part, abscissa, curves)
    return figure


def draw_profiles(results, name, find_values=None, find_label=None):
    """One profile along one axis, a curve for each point of the sweep; its values and labels may be other ones."""
    x, profile = results.profile_axes[-1], results.profiles[name]
    x_factor, x_unit = scale_of(x.values, x.unit)
    factor, unit = scale_of(profile.values, profile.unit)
    points = list(np.ndindex(*results.status.shape))
    colours = COLOURS if len(points) <= len(COLOURS) else plt.get_cmap("viridis")(np.linspace(0, 1, len(points)))
    figure, axes = plt.subplots(figsize=(5.6, 3.4))
    for index, colour in zip(points, colours):
        values = find_values(profile.values[index]) if find_values else profile.values[index]
        label = find_label(index) if find_label else point_label(results.describe(index), results.model)
        axes.plot(x.values * x_factor, values * factor, color=colour, label=label or "_")
    axes.set_xlim(x.values[0] * x_factor, x.values[-1] * x_factor)
    axes.set_xlabel(axis_label(x.name, x_unit))
    axes.set_ylabel(axis_label(name, unit))
    if axes.get_legend_handles_labels()[1]:
        axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5))
    return figure, axes


def draw_curves(axes, results, abscissa, ordinate, curves, scale=None):
    """Draw one result against one swept variable; its factor and unit may be given."""
    along = results.axis_names.index(abscissa)
    x_axis, field = results.axes[along], results.fields[ordinate]
    logarithmic = is_logarithmic(x_axis.values)
    x_factor, x_unit = scale_of(x_axis.values, x_axis.unit)
    if logarithmic and not has_few_decades(x_axis.values):
        x_factor, x_unit = 1.0, scale_of([], x_axis.unit)[1]
    y_factor, y_unit = scale or scale_of(field.values, field.unit)
    order = np.argsort(x_axis.values)
    x = x_axis.values[order] * x_factor
    missed = np.zeros(x.size, dtype=bool)
    has_pole = False
    doubted, drawn, doubts = is_doubted(results), [], []
    for curve in curves:
        y = np.moveaxis(field.values, along, -1)[curve.index][order] * y_factor
        if ordinate == "friction_coefficient":
            load = load_of(results, along, curve.index)[order]
            y = without_pole(y, load)
            has_pole = has_pole or passes_zero(load)
        if ordinate in results.errors:
            error = np.moveaxis(results.fields[results.errors[ordinate]].values, along, -1)[curve.index][order] * y_factor
            axes.fill_between(x, y - error, y + error, color=curve.style["color"], alpha=0.2, linewidth=0)
        draw_curve(axes, x, y, find_jumps(results, along, curve.index), way_of(results), label=curve.label,
                   marker="o" if x.size <= 30 else None, markersize=3, **curve.style)
        drawn.append(y)
        if doubted is not None:
            doubts.append(np.moveaxis(doubted, along, -1)[curve.index][order])
        missed |= np.moveaxis(results.status, along, -1)[curve.index][order] == NOT_CONVERGED
    if doubts:
        hatch_doubts(axes, x, drawn, doubts, logarithmic)
    if missed.any():
        axes.plot(x[missed], np.full(missed.sum(), 0.015), "x", color=MISSED, markersize=4, clip_on=False,
                  transform=axes.get_xaxis_transform(), label="not converged")
    if logarithmic:
        axes.set_xscale("log")
        label_few_decades(axes, x)
    else:
        axes.xaxis.set_major_locator(MaxNLocator(6, steps=[1, 2, 2.5, 5, 10]))
    axes.set_xlim(x[0], x[-1])
    axes.set_xlabel(axis_label(abscissa, x_unit))
    axes.set_ylabel(axis_label(ordinate, y_unit))
    if has_pole:
        leave_out_pole(axes, field.values * y_factor)
    elif np.nanmin(field.values, initial=0.0) < 0:
        axes.axhline(0, color="0.7", linewidth=0.6, zorder=0)
    elif np.nanmax(field.values, initial=0.0) > 0:
        axes.set_ylim(bottom=0)
    if has_pole:
        axes.axhline(0, color="0.7", linewidth=0.6, zorder=0)
    if x[0] < 0 < x[-1]:
        axes.axvline(0, color="0.7", linewidth=0.6, zorder=0)


def load_of(results, along, index):
    """The load along a curve, swept or found."""
    if "load" in results.fields:
        return np.moveaxis(results.fields["load"].values, along, -1)[index]
    if results.axes[along].name == "load":
        return results.axes[along].values
    # one load for the whole curve
    return np.ones(results.axes[along].values.size)


def without_pole(y, load):
    """A quotient by the load, broken where the load changes its sign: what lies between is no curve."""
    y = np.array(y, dtype=float)
    changes = np.flatnonzero(np.sign(load[1:]) * np.sign(load[:-1]) < 0)
    # the curve ends with the smaller of the two loads, whose value is the larger
    y[[i if abs(load[i]) < abs(load[i + 1]) else i + 1 for i in changes]] = np.nan
    return y


def passes_zero(load):
    """Does the load of a curve vanish somewhere, or change its sign?"""
    load = load[np.isfinite(load)]
    return load.size > 0 and load.min() <= 0 <= load.max()


def leave_out_pole(axes, values):
    """Limit the axis of a quotient next to a pole: to what is usual on either side of it."""
    lowest, highest = (UP_TO * _median(side[side > 0]) for side in (-values, values))
    if lowest > 0:
        axes.set_ylim(-max(lowest, highest), max(lowest, highest))
    elif highest > 0:
        axes.set_ylim(0, highest)


def relimit(axes):
    """Let the y axis hold what is drawn, whatever it was limited to before."""
    axes.relim()
    axes.autoscale(axis="y")


def _median(values):
    finite = values[np.isfinite(values)]
    return np.median(finite) if finite.size else 0.0


def find_curves(results, abscissa):
    """The curves of a sweep: colour for the slowest variable, dashes for the next where its values are few."""
    others = [axis for axis in results.axes if axis.name != abscissa]
    indices = list(np.ndindex(*(axis.values.size for axis in others)))
    if len(indices) > MOST_CURVES:
        indices = [indices[i] for i in np.linspace(0, len(indices) - 1, MOST_CURVES).round().astype(int)]
    curves = []
    for place, index in enumerate(indices):
        pairs = [(axis, axis.values[i]) for axis, i in zip(others, index)]
        label = point_label(pairs, results.model)
        style = _style(others, index, place, len(indices))
        if label.endswith(NO_ADHESION):
            # as published (GM)
            style["linestyle"] = DASHES[0]
        curves.append(Curve(index, label, style))
    return curves


def _has_dashes(others):
    """Are there two more swept variables, with few enough values for a colour and for dashes each?"""
    return len(others) == 2 and others[1].values.size <= len(DASHES) and others[0].values.size <= len(COLOURS)


def _style(others, index, place, count):
    if _has_dashes(others):
        return {"color": COLOURS[index[0]], "linestyle": DASHES[index[1]]}
    if count <= MOST_IN_LEGEND:
        return {"color": COLOURS[place]}
    if len(others) == 1:
        values = others[0].values
        return {"color": plt.get_cmap("viridis")(norm_of(values)(values[index[0]]))}
    return {"color": plt.get_cmap("viridis")(place / (count - 1))}


def add_key(figure, axes, results, abscissa, curves):
    """A legend, of colours and dashes apart where there are both, or a colour bar where the curves are many."""
    others = [axis for axis in results.axes if axis.name != abscissa]
    if not others:
        if len(axes.get_legend_handles_labels()[1]) > 1:
            add_legend(figure, axes, *_named(axes))
    elif _has_dashes(others) and len(curves) > MOST_INSIDE:
        words = [(point_label([(others[0], value)], results.model), {"color": COLOURS[k]})
                 for k, value in enumerate(others[0].values)]
        words += [(point_label([(others[1], value)], results.model), {"color": "0.4", "linestyle": DASHES[k]})
                  for k, value in enumerate(others[1].values)]
        add_legend(figure, axes, [Line2D([], [], **style) for _, style in words], [word for word, _ in words])
    elif len(curves) <= MOST_IN_LEGEND:
        add_legend(figure, axes, *_named(axes))
    elif len(others) == 1:
        factor, unit = scale_of(others[0].values, others[0].unit)
        norm = norm_of(others[0].values * factor)
        figure.colorbar(ScalarMappable(norm, "viridis"), ax=figure.axes, label=axis_label(others[0].name, unit))


def add_legend(figure, axes, handles, labels):
    """A legend where there is room: in a panel if it is short, else beside all of them."""
    if len(labels) <= MOST_INSIDE and max(map(len, labels), default=0) <= LONGEST_INSIDE:
        axes.legend(handles, labels)
    else:
        width, height = figure.get_size_inches()
        figure.set_size_inches(width + 0.4 + 0.06 * min(max(map(len, labels)), 40), height)
        figure.legend(handles, labels, loc="outside right center")


def _named(axes):
    """Handles and labels of what has a name."""
    handles, labels = axes.get_legend_handles_labels()
    named = [(h, n) for h, n in zip(handles, labels) if n and not n.startswith("_")]
    return [h for h, _ in named], [n for _, n in named]
