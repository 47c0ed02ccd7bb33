# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of `wavy_sliding` on rough lines, and of materials with a temperature."""

import numpy as np

from .curves import add_key, draw_curves, draw_panels, find_curves
from .labels import axis_label, scale_of, scales_of
from .results import Field
from .style import COLOURS, make_panels, plt
from .surface import choose_points, panel_title

MOST_LINES = 3
GAS_CONSTANT = 8.31446261815324


def draw_velocities(results):
    """Friction and the share in contact against velocity; where temperatures are several, friction against their common velocity, too."""
    share = contact_share(results)
    names = ["friction_coefficient"]
    if share is not None and np.nanmax(share.values, initial=0.0) > 0:
        results.fields[share.name] = share
        names += [share.name]
    factors = shift_factors(results)
    if factors is None or factors.size < 2:
        return draw_panels(results, "velocity", names)
    figure, panels = make_panels(len(names) + 1)
    curves = find_curves(results, "velocity")
    scales = scales_of([results.fields[name] for name in names])
    for panel, name in zip([panels[0], *panels[2:]], names):
        draw_curves(panel, results, "velocity", name, curves, scales[name])
    draw_collapse(panels[1], results, curves, factors)
    # the last panel has room where the velocity is large
    add_key(figure, panels[-1], results, "velocity", curves)
    return figure


def draw_collapse(panel, results, curves, factors):
    """Friction against a_T V."""
    along, warm = results.axis_names.index("velocity"), [axis.name for axis in results.axes if axis.name != "velocity"]
    velocity = results.axes[along].values
    order = np.argsort(velocity)
    values = np.moveaxis(results.fields["friction_coefficient"].values, along, -1)
    for curve in curves:
        factor = factors[curve.index[warm.index("temperature")]]
        panel.plot(factor * velocity[order], values[curve.index][order], **curve.style)
    panel.set_xscale("log")
    panel.set_ylim(bottom=0)
    panel.set_xlabel(r"Sliding velocity at $T_0$, $a_T V$ (m/s)")
    panel.set_ylabel(axis_label("friction_coefficient", ""))


def contact_share(results):
    """The share of the nominal area in contact, from a period or from the load over its mean pressure; None where neither is known."""
    if "contact_fraction" in results.fields:
        return results.fields["contact_fraction"]
    if "contact_area" not in results.fields:
        return None
    area = results.fields["contact_area"]
    if area.unit == "m" and "period" in results.constants:
        nominal = results.constants["period"].values
    elif {"mean_pressure", "load"} <= {*results.constants, *results.fields} and "mean_pressure" in results.constants:
        pressure = results.constants["mean_pressure"].values
        if not pressure > 0:
            return None
        nominal = results.fields["load"].values / pressure
    else:
        return None
    return Field("contact_fraction", "-", area.values / nominal)


def shift_factors(results):
    """The factors a_T of the swept temperatures; None where no temperature is swept."""
    axis = next((axis for axis in results.several if axis.name == "temperature"), None)
    given = {name: field.values for name, field in results.constants.items()}
    if axis is None or "reference_temperature" not in given:
        return None
    reference = given["reference_temperature"]
    if {"wlf_c1", "wlf_c2"} <= set(given):
        away = axis.values - reference
        return 10.0 ** (-given["wlf_c1"] * away / (given["wlf_c2"] + away))
    if "activation_energy" in given:
        return np.exp(given["activation_energy"] / GAS_CONSTANT * (1 / axis.values - 1 / reference))
    return None


def draw_lines(results):
    """Pressure along a rough line, and below it the heights on the foundation, for each point of the sweep."""
    points = choose_points(results)
    points = [points[i] for i in np.unique(np.linspace(0, len(points) - 1, min(MOST_LINES, len(points))).round().astype(int))]
    x = results.profile_axes[0]
    x_factor, x_unit = scale_of(x.values, x.unit)
    places = x.values * x_factor
    displacement, gap, pressure = (results.profiles[name] for name in ("displacement", "gap", "pressure"))
    height_factor, height_unit = scale_of(displacement.values, displacement.unit)
    factor, unit = scale_of(pressure.values, pressure.unit)
    figure, panels = plt.subplots(2, len(points), squeeze=False, sharex=True, figsize=(3.4 * len(points) + 0.6, 4.6))
    deepest = np.nanmax([np.nanmax(displacement.values[index], initial=0.0) for index in points]) * height_factor
    highest = np.nanmax([np.nanmax((gap.values - displacement.values)[index], initial=0.0) for index in points]) * height_factor
    margin = 0.05 * (highest + deepest) or 1.0
    for (above, below), index in zip(panels.T, points):
        above.plot(places, pressure.values[index] * factor, color=COLOURS[0], linewidth=0.8)
        above.axhline(0, color="0.7", linewidth=0.6, zorder=0)
        above.set_title(panel_title(results, index))
        # positive into the foundation: downwards
        surface = -displacement.values[index] * height_factor
        below.fill_between(places, surface, -deepest - margin, color="0.85", linewidth=0, label="foundation")
        below.plot(places, surface + gap.values[index] * height_factor, color=COLOURS[1], linewidth=0.8, label="heights")
        below.set_xlabel(axis_label(x.name, x_unit) + ", direction of sliding")
        below.set_xlim(places[0], places[-1])
        below.set_ylim(-deepest - margin, highest + margin)
    panels[0, 0].set_ylabel(axis_label("pressure", unit))
    panels[1, 0].set_ylabel(f"Height ({height_unit})")
    handles, labels = panels[1, 0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside lower center", ncols=2)
    return figure
