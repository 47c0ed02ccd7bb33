# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of histories: with friction, with adhesion, in time, and of periodic surfaces."""

import numpy as np

from .labels import axis_label, point_label, scale_of
from .style import COLOURS, make_panels, plt

# what is drawn, against what
PANELS = (("time", "contact_fraction"), ("time", "penetration"), ("time", "load"), ("time", "contact_radius"), ("tangential_displacement", "tangential_force"), ("approach", "load"), ("time", "approach"), ("step", "stick_radius"), ("step", "stick_major_half_width"),
          ("step", "stick_half_width"), ("step", "friction_loss"), ("step", "contact_radius"), ("step", "adhesion_loss"))
# most values of a swept variable that are all written at its axis
MOST_TICKS = 6


def draw_history(results):
    """Force against displacement, both ways, and what sticks and what is lost, step by step; a curve for each point of the sweep."""
    fields = dict(results.profiles)
    step = results.profile_axes[-1]
    # a history in time has no need of steps
    known = [pair for pair in PANELS if pair[1] in fields and (pair[0] in fields or pair[0] == "step" and "time" not in fields)]
    shown = [pair for pair in known if pair != ("approach", "load") or _varies(fields["load"].values)]
    has_moduli = bool(results.several) and "storage_modulus" in results.fields and np.isfinite(results.fields["storage_modulus"].values).any()
    figure, panels = make_panels(len(shown) + has_moduli)
    points = list(np.ndindex(*results.status.shape))
    colours = COLOURS if len(points) <= len(COLOURS) else plt.get_cmap("viridis")(np.linspace(0, 1, len(points)))
    for panel, (abscissa, ordinate) in zip(panels, shown):
        x, y = step if abscissa == "step" else fields[abscissa], fields[ordinate]
        x_factor, x_unit = scale_of(x.values, x.unit)
        y_factor, y_unit = scale_of(y.values, y.unit)
        for index, colour in zip(points, colours):
            values = x.values if abscissa == "step" else x.values[index]
            # a path without adhesion begins without force and contact
            start = [] if abscissa in ("step", "time") or "time" in fields or "adhesion_radius" in fields else [0.0]
            panel.plot(np.append(start, values) * x_factor, np.append(start, y.values[index]) * y_factor, color=colour,
                       label=point_label(results.describe(index), results.model) or "_")
        panel.set_xlabel(axis_label(abscissa, x_unit))
        panel.set_ylabel(axis_label(ordinate, y_unit))
        if results.model == "surface_time":
            panel.set_xscale("log", nonpositive="mask")
        elif abscissa != "step":
            panel.axhline(0, color="0.7", linewidth=0.6, zorder=0)
            panel.axvline(0, color="0.7", linewidth=0.6, zorder=0)
    if has_moduli:
        _draw_moduli(panels[len(shown)], results)
    known_curves = panels[0].get_legend_handles_labels()
    if known_curves[1] and "adhesion_loss" in fields:
        # where force goes both ways curves take all of its panel
        figure.legend(*known_curves, loc="outside lower center", ncols=3)
    elif known_curves[1]:
        panels[0].legend()
    return figure


def _varies(values):
    finite = values[np.isfinite(values)]
    return finite.size > 1 and np.ptp(finite) > 1e-9 * np.max(np.abs(finite))


def _draw_moduli(panel, results):
    """Storage and loss modulus against what is swept, the last of several."""
    along = results.axis_names.index(results.several[-1].name)
    swept = results.axes[along]
    moduli = [results.fields[name] for name in ("storage_modulus", "loss_modulus")]
    x_factor, x_unit = scale_of(swept.values, swept.unit)
    y_factor, y_unit = scale_of(moduli[0].values, moduli[0].unit)
    for modulus, word, colour in zip(moduli, ("storage", "loss"), COLOURS):
        rows = np.moveaxis(modulus.values, along, -1).reshape(-1, swept.values.size)
        for k, row in enumerate(rows):
            panel.plot(swept.values * x_factor, row * y_factor, "o-", color=colour, markersize=3, label=word if k == 0 else "_")
    if swept.name == "frequency":
        panel.set_xscale("log")
    if swept.values.size <= MOST_TICKS:
        # each value by itself: powers of ten may all lie outside
        panel.minorticks_off()
        panel.set_xticks(swept.values * x_factor, [f"{value:g}" for value in swept.values * x_factor])
    panel.set_xlabel(axis_label(swept.name, x_unit))
    panel.set_ylabel("Modulus" + (f" ({y_unit})" if y_unit else ""))
    panel.set_ylim(bottom=0)
    panel.legend()
