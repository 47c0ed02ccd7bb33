# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of profiles that the user has chosen: along the surface, or one profile against another, as the stress against the gap."""

import difflib

import numpy as np

from .curves import add_legend
from .labels import axis_label, point_label, scale_of
from .results import BadFile, NothingToDraw
from .style import COLOURS, make_panels
from .surface import choose_points


def are_profiles(results, names):
    """Does one of these names belong to a profile, or to the positions of one?"""
    return bool({field.name for field in _fields(results)} & set(names))


def draw_along(results, x_name, y_names):
    """A panel for each profile against the positions or another profile, a curve for each point of the sweep."""
    if len(results.profile_axes) != 1:
        raise NothingToDraw(f"{results.path}: profiles over two axes: --cut draws them along lines")
    position = results.profile_axes[0]
    fields = {field.name: field for field in _fields(results)}
    x_name = x_name or position.name
    for name in [x_name, *y_names]:
        if name not in fields:
            near = difflib.get_close_matches(name, fields, n=1, cutoff=0.5)
            question = f"; did you mean {near[0]}?" if near else f", allowed: {', '.join(fields)}"
            raise BadFile(f"{results.path}: no profile of this name, given {name}{question}")
    points = choose_points(results)
    x_factor, x_unit = scale_of(fields[x_name].values, fields[x_name].unit)
    figure, panels = make_panels(len(y_names))
    for panel, y_name in zip(panels, y_names):
        factor, unit = scale_of(fields[y_name].values, fields[y_name].unit)
        for number, index in enumerate(points):
            x, y = (fields[name].values if name == position.name else fields[name].values[index] for name in (x_name, y_name))
            panel.plot(x * x_factor, y * factor, color=COLOURS[number % len(COLOURS)],
                       label=point_label([(axis, value) for axis, value in results.describe(index) if axis.values.size > 1], results.model) or "_")
        panel.axhline(0, color="0.7", linewidth=0.6, zorder=0)
        if x_name == position.name:
            panel.set_xlim(np.min(position.values) * x_factor, np.max(position.values) * x_factor)
        panel.set_xlabel(axis_label(x_name, x_unit))
        panel.set_ylabel(axis_label(y_name, unit))
    handles, labels = panels[0].get_legend_handles_labels()
    if len(labels) > 1:
        add_legend(figure, panels[0], handles, labels)
    return figure


def _fields(results):
    """The profiles of one surface and their positions."""
    return [*results.profile_axes, *results.profiles.values()]
