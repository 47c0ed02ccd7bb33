"""Results against a swept variable, one curve for each value of the others."""

from dataclasses import dataclass

import numpy as np
from matplotlib.cm import ScalarMappable

from .labels import axis_label, point_label, scale_of
from .results import NOT_CONVERGED
from .style import COLOURS, DASHES, MISSED, is_logarithmic, norm_of, plt

MOST_CURVES = 60
MOST_IN_LEGEND = len(COLOURS)


@dataclass
class Curve:
    """A curve: where it lies in the sweep, and how it is drawn."""

    index: tuple
    label: str
    style: dict


def draw_panels(results, abscissa, ordinates):
    """A panel for each result."""
    curves = find_curves(results, abscissa)
    columns = min(len(ordinates), 2 if len(ordinates) in (2, 4) else 3)
    rows = -(-len(ordinates) // columns)
    size = (4.6, 3.4) if len(ordinates) == 1 else (3.3 * columns, 2.7 * rows + 0.2)
    figure, panels = plt.subplots(rows, columns, squeeze=False, figsize=size)
    for panel in panels.flat[len(ordinates):]:
        panel.remove()
    for panel, ordinate in zip(panels.flat, ordinates):
        draw_curves(panel, results, abscissa, ordinate, curves)
    add_key(figure, panels.flat[0], results, abscissa, curves)
    return figure


def draw_curves(axes, results, abscissa, ordinate, curves):
    """Draw one result against one swept variable."""
    along = results.axis_names.index(abscissa)
    x_axis, field = results.axes[along], results.fields[ordinate]
    logarithmic = is_logarithmic(x_axis.values)
    x_factor, x_unit = (1.0, scale_of([], x_axis.unit)[1]) if logarithmic else scale_of(x_axis.values, x_axis.unit)
    y_factor, y_unit = scale_of(field.values, field.unit)
    order = np.argsort(x_axis.values)
    x = x_axis.values[order] * x_factor
    missed = np.zeros(x.size, dtype=bool)
    for curve in curves:
        y = np.moveaxis(field.values, along, -1)[curve.index][order] * y_factor
        axes.plot(x, y, label=curve.label, marker="o" if x.size <= 30 else None, markersize=3, **curve.style)
        missed |= np.moveaxis(results.status, along, -1)[curve.index][order] == NOT_CONVERGED
    if missed.any():
        axes.plot(x[missed], np.full(missed.sum(), 0.015), "x", color=MISSED, markersize=4, clip_on=False,
                  transform=axes.get_xaxis_transform(), label="not converged")
    if logarithmic:
        axes.set_xscale("log")
    axes.set_xlim(x[0], x[-1])
    axes.set_xlabel(axis_label(abscissa, x_unit))
    axes.set_ylabel(axis_label(ordinate, y_unit))
    if np.nanmin(field.values, initial=0.0) < 0:
        axes.axhline(0, color="0.7", linewidth=0.6, zorder=0)
    elif np.nanmax(field.values, initial=0.0) > 0:
        axes.set_ylim(bottom=0)
    if x[0] < 0 < x[-1]:
        axes.axvline(0, color="0.7", linewidth=0.6, zorder=0)


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
        curves.append(Curve(index, label, _style(others, index, place, len(indices))))
    return curves


def _style(others, index, place, count):
    few_dashes = len(others) == 2 and others[1].values.size <= len(DASHES) and others[0].values.size <= len(COLOURS)
    if few_dashes:
        return {"color": COLOURS[index[0]], "linestyle": DASHES[index[1]]}
    if count <= MOST_IN_LEGEND:
        return {"color": COLOURS[place]}
    if len(others) == 1:
        values = others[0].values
        return {"color": plt.get_cmap("viridis")(norm_of(values)(values[index[0]]))}
    return {"color": plt.get_cmap("viridis")(place / (count - 1))}


def add_key(figure, axes, results, abscissa, curves):
    """A legend, or a colour bar where the curves are many."""
    others = [axis for axis in results.axes if axis.name != abscissa]
    if not others:
        if len(axes.get_legend_handles_labels()[1]) > 1:
            axes.legend(*_named(axes))
    elif len(curves) <= 2 * MOST_IN_LEGEND and "linestyle" in curves[0].style or len(curves) <= MOST_IN_LEGEND:
        axes.legend(*_named(axes))
    elif len(others) == 1:
        factor, unit = scale_of(others[0].values, others[0].unit)
        norm = norm_of(others[0].values * factor)
        figure.colorbar(ScalarMappable(norm, "viridis"), ax=figure.axes, label=axis_label(others[0].name, unit))


def _named(axes):
    """Handles and labels of what has a name."""
    handles, labels = axes.get_legend_handles_labels()
    named = [(h, n) for h, n in zip(handles, labels) if n and not n.startswith("_")]
    return [h for h, _ in named], [n for _, n in named]
