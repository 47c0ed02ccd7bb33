# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of `surface_sliding`."""

import copy

import numpy as np
from matplotlib.lines import Line2D

from . import heat
from .curves import add_key, draw_curves, draw_profiles, find_curves
from .labels import axis_label, scale_of, scales_of
from .results import Field
from .style import is_logarithmic, make_panels
from .surface import draw_pressure_maps


def draw_friction(results):
    """Friction coefficient and share in contact against the variable that varies fastest, and the friction beside that of full contact."""
    along = results.several[-1].name
    figure, panels = make_panels(3)
    curves = find_curves(results, along)
    names = ("friction_coefficient", "contact_fraction")
    scales = scales_of([results.fields[name] for name in names])
    for panel, name in zip(panels, names):
        draw_curves(panel, results, along, name, curves, scales[name])
    draw_beside_full(panels[2], results, along, curves)
    add_key(figure, panels[0], results, along, curves)
    return figure


def draw_beside_full(panel, results, along, curves):
    """Friction over nominal area, and dashed that of full contact."""
    place = results.axis_names.index(along)
    in_full = "full_contact_friction_stress" if "full_contact_friction_stress" in results.fields else "full_contact_friction"
    axis, friction, full = results.axes[place], results.fields["friction_stress"], results.fields[in_full]
    order = np.argsort(axis.values)
    is_log = is_logarithmic(axis.values)
    x_factor, x_unit = (1.0, scale_of([], axis.unit)[1]) if is_log else scale_of(axis.values, axis.unit)
    factor, unit = scale_of(friction.values, friction.unit)
    for curve in curves:
        style = {key: value for key, value in curve.style.items() if key != "linestyle"}
        for field, line in ((friction, "-"), (full, "--")):
            values = np.moveaxis(field.values, place, -1)[curve.index][order] * factor
            panel.plot(axis.values[order] * x_factor, np.where(values > 0, values, np.nan), linestyle=line, **style)
    if is_log:
        panel.set_xscale("log")
    panel.set_yscale("log")
    panel.set_xlim(np.min(axis.values) * x_factor, np.max(axis.values) * x_factor)
    panel.set_xlabel(axis_label(along, x_unit))
    panel.set_ylabel(axis_label("friction_stress", unit))
    panel.legend([Line2D([], [], color="0.3"), Line2D([], [], color="0.3", linestyle="--")], ["friction", "in full contact"])


def draw_contacts(results):
    """Pressure on the surface, or with heat its temperature; that of a wave with its crest in the middle, that of a line as a curve."""
    shown = centre_crest(results) if results.words.get("kind") != "heights" else results
    if heat.has_temperature(shown):
        return heat.draw_flashes(shown)
    if len(shown.profile_axes) == 2:
        return draw_pressure_maps(shown)
    return draw_profiles(shown, "pressure")[0]


def centre_crest(results):
    """The same results with the crest at 0 in the middle of the period."""
    moved = copy.copy(results)
    moved.profile_axes = [Field(axis.name, axis.unit, axis.values - axis.values.size // 2 * np.mean(np.diff(axis.values)))
                          for axis in results.profile_axes]
    shifts = [axis.values.size // 2 for axis in results.profile_axes]
    places = tuple(range(-len(shifts), 0))
    moved.profiles = {name: Field(name, field.unit, np.roll(field.values, shifts, places)) for name, field in results.profiles.items()}
    return moved
