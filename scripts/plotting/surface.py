# SPDX-License-Identifier: GPL-3.0-or-later
"""Stresses on one period of the surface."""

import numpy as np
from matplotlib.patches import Patch

from .labels import axis_label, point_label, scale_of
from .results import REASONS, SOLVED
from .style import COLOURS, adhesion_colours, adhesion_ticks, make_panels, pressure_colours

MOST_PANELS = 6
# a gap below this part of the largest one is contact
CLOSED = 1e-9
# the contact is outlined where the gap is this part of the largest one: a smooth line just outside
OUTLINE = 1e-3
# what maps with adhesion show
ADHESION_KEY = "grey: no adhesion; black line: edge of contact"


def draw_stresses(results):
    """Pressure and shear stress along the one axis, a panel for each point of the sweep."""
    points = choose_points(results)
    x = results.profile_axes[0]
    x_factor, x_unit = scale_of(x.values, x.unit)
    names = [name for name in ("pressure", "shear_stress")
             if name in results.profiles and np.isfinite(results.profiles[name].values).any()]
    factor, unit = scale_of([np.nanmax(np.abs(results.profiles[name].values), initial=0.0) for name in names],
                            results.profiles["pressure"].unit)
    figure, panels = make_panels(len(points), (3.4, 2.9), shared=True)
    for panel, index in zip(panels, points):
        shade_contact(panel, results, index, x.values * x_factor)
        for name, colour in zip(names, COLOURS):
            panel.plot(x.values * x_factor, results.profiles[name].values[index] * factor, color=colour,
                       label=axis_label(name, ""))
        panel.axhline(0, color="0.7", linewidth=0.6, zorder=0)
        panel.set_title(panel_title(results, index))
        panel.set_xlabel(axis_label(x.name, x_unit))
        panel.set_xlim(x.values[0] * x_factor, x.values[-1] * x_factor)
        label_rows(panel, f"Stress ({unit})" if unit else "Stress")
    handles, labels = panels[0].get_legend_handles_labels()
    figure.legend([*handles, Patch(color="0.9")], [*labels, "Contact"], loc="outside lower center", ncols=3)
    return figure


def draw_pressure_maps(results):
    """Pressure over the two axes, a map for each point of the sweep."""
    points = choose_points(results)
    pressure = results.profiles["pressure"]
    y, x = results.profile_axes
    x_factor, x_unit = scale_of(x.values, x.unit)
    factor, unit = scale_of(pressure.values, pressure.unit)
    shown = np.array([pressure.values[index] for index in points]) * factor
    lowest, highest = np.nanmin(shown, initial=0.0), np.nanmax(shown, initial=0.0)
    adheres = "adhesion_fraction" in results.fields and lowest < 0
    colours, norm = (adhesion_colours if adheres else pressure_colours)(lowest, highest)
    figure, panels = make_panels(len(points), (3.4, 3.2), (3.7, 3.5), shared=True)
    for panel, index, values in zip(panels, points, shown):
        shown_here = np.where(values != 0, values, np.nan) if adheres else values
        image = panel.pcolormesh(x.values * x_factor, y.values * x_factor, shown_here, cmap=colours, norm=norm,
                                 shading="nearest", rasterized=True)
        outline_contact(panel, results, index, x.values * x_factor, y.values * x_factor)
        panel.set_aspect("equal")
        panel.set_title(panel_title(results, index))
        panel.set_xlabel(axis_label(x.name, x_unit) + (", direction of sliding" if results.model == "wavy_sliding" else ""))
        label_rows(panel, axis_label(y.name, x_unit))
    words = axis_label("pressure", unit)
    if adheres:
        words += f"; {ADHESION_KEY}"
        # one row of maps is too low for one line
        if panels[0].get_subplotspec().get_gridspec().nrows == 1:
            words = words.replace("; ", "\n")
    ticks = adhesion_ticks(lowest, highest) if adheres else None
    figure.colorbar(image, ax=panels, label=words, ticks=ticks, shrink=0.85)
    return figure


def choose_points(results):
    """The points of the sweep that are drawn: all, or some evenly spread."""
    points = list(np.ndindex(*results.status.shape))
    if len(points) <= MOST_PANELS:
        return points
    return [points[i] for i in np.linspace(0, len(points) - 1, MOST_PANELS).round().astype(int)]


def label_rows(panel, label):
    """Label the y axis where a row begins."""
    if panel.get_subplotspec().is_first_col():
        panel.set_ylabel(label)


def panel_title(results, index):
    """Swept values and friction coefficient of a point, of one that adheres without friction the share in contact; or why it is empty."""
    words = [point_label(results.describe(index), results.model)]
    if results.status[index] != SOLVED:
        words.append(REASONS[int(results.status[index])])
    elif "friction_coefficient" in results.fields and np.isfinite(results.fields["friction_coefficient"].values[index]):
        words.append(rf"$\mu$ = {format_coefficient(results.fields['friction_coefficient'].values[index])}")
    elif "adhesion_fraction" in results.fields:
        words.append(f"$A/A_0$ = {results.fields['contact_fraction'].values[index]:.3f}")
    return "; ".join(word for word in words if word)


def format_coefficient(value):
    """Three digits, and powers of ten as they are printed."""
    text = f"{value:.3g}"
    if "e" not in text:
        return text
    digits, exponent = text.split("e")
    return rf"${digits} \times 10^{{{int(exponent)}}}$"


def relative_gap(results, index):
    """The gap as part of the largest one of the file; NaN if the file has no gap."""
    if "gap" not in results.profiles:
        return np.full_like(results.profiles["pressure"].values[index], np.nan)
    gaps = results.profiles["gap"].values
    return gaps[index] / (np.nanmax(gaps, initial=0.0) or 1.0)


def shade_contact(panel, results, index, x):
    panel.fill_between(x, 0, 1, where=relative_gap(results, index) <= CLOSED, transform=panel.get_xaxis_transform(),
                       color="0.92", linewidth=0, zorder=-1)


def outline_contact(panel, results, index, x, y):
    draw_outline(panel, x, y, relative_gap(results, index))


def draw_outline(panel, x, y, gap):
    """The edge of the contact on a map of relative gaps."""
    if (gap < OUTLINE).any() and (gap > OUTLINE).any():
        panel.contour(x, y, gap, levels=[OUTLINE], colors="black", linewidths=0.7)
