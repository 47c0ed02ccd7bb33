# SPDX-License-Identifier: GPL-3.0-or-later
"""Samples and tables of cases: a result against each of the variables that change together, a point for each sample."""

import numpy as np

from .labels import axis_label, scale_of
from .style import label_few_decades, make_panels

# axes along which several variables change without an order
AXES = ("sample", "case")
MOST_PANELS = 6
# values that are spread over more than this ratio are drawn on a logarithmic axis
WIDE = 30.0


def draw_samples(results, ordinate):
    """A panel for each variable of the axis that varies fastest; the colour of a point is the variable of the next panel."""
    axis = results.several[-1].name
    variables = [field for field, along in results.companions.values() if along == axis][:MOST_PANELS]
    along = results.axis_names.index(axis)
    values = np.moveaxis(results.fields[ordinate].values, along, -1).reshape(-1, results.axes[along].values.size)
    factor, unit = scale_of(results.fields[ordinate].values, results.fields[ordinate].unit)
    figure, panels = make_panels(len(variables))
    for place, (panel, variable) in enumerate(zip(panels, variables)):
        colour = variables[(place + 1) % len(variables)]
        x_factor, x_unit = scale_of(variable.values, variable.unit)
        c_factor, c_unit = scale_of(colour.values, colour.unit)
        for row in values:
            dots = panel.scatter(variable.values*x_factor, row*factor, c=colour.values*c_factor, s=12, cmap="viridis",
                                 norm="log" if _is_wide(colour.values) else None)
        if len(variables) > 1:
            figure.colorbar(dots, ax=panel, label=axis_label(colour.name, c_unit))
        if _is_wide(variable.values):
            panel.set_xscale("log")
            label_few_decades(panel, variable.values*x_factor)
        if _is_wide(values):
            panel.set_yscale("log")
        panel.set_xlabel(axis_label(variable.name, x_unit))
        panel.set_ylabel(axis_label(ordinate, unit))
    width, height = figure.get_size_inches()
    figure.set_size_inches(width + 0.7*min(len(variables), 3), height)
    return figure


def _is_wide(values):
    """Are these positive values spread over more than a few times their size?"""
    finite = values[np.isfinite(values)]
    return finite.size > 1 and bool(finite.min() > 0 and finite.max() > WIDE*finite.min())
