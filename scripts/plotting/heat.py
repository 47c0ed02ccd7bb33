# SPDX-License-Identifier: GPL-3.0-or-later
"""Flash temperatures on one period of the surface."""

import numpy as np

from .labels import axis_label, scale_of
from .style import COLOURS, make_panels
from .surface import choose_points, label_rows, panel_title


def has_temperature(results):
    """Is there a profile of the temperature?"""
    return "temperature" in results.profiles and np.isfinite(results.profiles["temperature"].values).any()


def draw_flashes(results):
    """Rise of the temperature above its mean, a map or a curve with a scale of its own for each point of the sweep."""
    points = choose_points(results)
    x = results.profile_axes[-1]
    x_factor, x_unit = scale_of(x.values, x.unit)
    is_map = len(results.profile_axes) == 2
    figure, panels = make_panels(len(points), (4.3, 3.3), (4.6, 3.6), shared=is_map)
    for panel, index in zip(panels, points):
        temperature = results.profiles["temperature"].values[index]
        rise = temperature - np.mean(temperature)
        if is_map:
            y = results.profile_axes[0].values * x_factor
            image = panel.pcolormesh(x.values * x_factor, y, rise, cmap="inferno", shading="nearest", rasterized=True)
            outline_edge(panel, results, index, x.values * x_factor, y)
            panel.set_aspect("equal")
            label_rows(panel, axis_label("y", x_unit))
            figure.colorbar(image, ax=panel, label="flash temperature (K)", shrink=0.9)
        else:
            panel.plot(x.values * x_factor, rise, color=COLOURS[0])
            label_rows(panel, "flash temperature (K)")
        panel.set_title(panel_title(results, index))
        panel.set_xlabel(axis_label("x", x_unit))
    return figure


def outline_edge(panel, results, index, x, y):
    """The edge of contact, white on dark."""
    gap = results.profiles["gap"].values[index]
    if (gap > 0).any() and not (gap > 0).all():
        panel.contour(x, y, (gap > 0).astype(float), levels=[0.5], colors="white", linewidths=0.9)
