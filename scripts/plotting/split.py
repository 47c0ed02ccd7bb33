# SPDX-License-Identifier: GPL-3.0-or-later
"""Friction as the sum of losses, with the part that adhesion adds to them, and interface."""

import numpy as np

from .curves import draw_curves, find_curves
from .labels import axis_label, scale_of
from .style import COLOURS, is_logarithmic, make_panels

PARTS = ("hysteretic_friction_stress", "interfacial_friction_stress")
LABELS = ("losses", "interface")
# losses at the same load without adhesion, and the labels of both parts of the losses
WITHOUT, BOTH = "friction_stress_without_adhesion", ("losses without adhesion", "losses by adhesion")
BESIDE = ("interfacial_share", "contact_fraction", "velocity_slope", "flash_temperature")
NEEDED = {"interfacial_share", "contact_fraction"}
MOST_CURVES = 3


def has_parts(results):
    """Does a sweep of the velocity have both parts, in few curves?"""
    return (set(PARTS) | NEEDED <= set(results.fields) and bool(results.several) and results.several[-1].name == "velocity"
            and np.all(results.several[-1].values > 0) and len(find_curves(results, "velocity")) <= MOST_CURVES)


def draw_split(results):
    """Both parts as areas, one above the other, a panel for each curve; then the share, the contact and the slope of all."""
    curves = find_curves(results, "velocity")
    beside = [name for name in BESIDE if name in results.fields and np.any(np.isfinite(results.fields[name].values))]
    figure, panels = make_panels(len(curves) + len(beside))
    for panel, curve in zip(panels, curves):
        draw_parts(panel, results, curve, len(curves) > 1)
    for panel, name in zip(panels[len(curves):], beside):
        field = results.fields[name]
        draw_curves(panel, results, "velocity", name, curves, scale_of(field.values, field.unit))
    if len(curves) > 1:
        panels[len(curves)].legend()
    return figure


def draw_parts(panel, results, curve, has_title):
    """Losses, and the interface above them; with adhesion both parts of the losses."""
    place = results.axis_names.index("velocity")
    axis = results.axes[place]
    order = np.argsort(axis.values)
    x_unit = scale_of([], axis.unit)[1]
    total = results.fields["friction_stress"]
    factor, unit = scale_of(total.values, total.unit)
    losses, interface = (np.moveaxis(results.fields[name].values, place, -1)[curve.index][order] * factor for name in PARTS)
    below = 0
    if WITHOUT in results.fields:
        below = np.moveaxis(results.fields[WITHOUT].values, place, -1)[curve.index][order] * factor
        panel.fill_between(axis.values[order], 0, below, color=COLOURS[1], alpha=0.7, linewidth=0, label=BOTH[0])
    panel.fill_between(axis.values[order], below, losses, color=COLOURS[1] if WITHOUT not in results.fields else COLOURS[3], alpha=0.7, linewidth=0,
                       label=BOTH[1] if WITHOUT in results.fields else LABELS[0])
    panel.fill_between(axis.values[order], losses, losses + interface, color=COLOURS[2], alpha=0.5, linewidth=0, label=LABELS[1])
    panel.plot(axis.values[order], losses + interface, color=COLOURS[0])
    if is_logarithmic(axis.values):
        panel.set_xscale("log")
    panel.set_xlim(np.min(axis.values), np.max(axis.values))
    panel.set_ylim(0, 1.05 * factor * np.nanmax(total.values))
    panel.set_xlabel(axis_label("velocity", x_unit))
    panel.set_ylabel(axis_label("friction_stress", unit))
    if has_title:
        panel.set_title(curve.label)
    panel.legend()
