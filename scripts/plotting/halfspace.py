# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of the elastic half-plane and half-space."""

import math

import numpy as np
from matplotlib.colors import Normalize
from matplotlib.lines import Line2D

from .curves import draw_panels, draw_profiles, find_curves
from .labels import axis_label, point_label, scale_of
from .style import COLOURS, DASHES, adhesion_colours, adhesion_ticks, make_panels, plt
from .surface import ADHESION_KEY, choose_points, draw_outline, label_rows, relative_gap

# bi-sinusoidal wave: mean pressure over that of full contact at which the summits' contacts merge (docs/theory/periodic_contact.md)
MERGING = 0.2286
# how far the asymptotes are drawn
LIGHT, HEAVY = 0.35, 0.45
OPEN = "#d9e2ec"
# the depth is z in scenes, and y in files of models
STRESSES = {"stress_xx_map": r"$\sigma_{xx}$", "stress_zz_map": r"$\sigma_{zz}$", "stress_xz_map": r"$\sigma_{xz}$",
            "stress_yy_map": r"$\sigma_{yy}$", "stress_xy_map": r"$\sigma_{xy}$", "largest_shear_stress_map": r"largest shear $\tau$"}
COMPONENTS = 4
MOST_ROWS = 3
# pressures above this multiple of the largest mean pressure are cut off, as at the edge of a punch
TALLEST = 4.0
# maps show this share of the places within their levels; where the rest is larger by this factor the levels are 1, 2, 5, 10 ...
SHOWN, STEEP = 0.99, 10.0


def draw_area(results):
    """Share of the area in contact against mean pressure, its error bound, and the asymptotes of Johnson, Greenwood, Higginson; with
    adhesion, which has no such, the shares in contact and in adhesion, penetration and largest pressure."""
    if len(results.several) > 1:
        return draw_panels(results, "mean_pressure", ["contact_fraction"])
    # files of earlier versions have no adhesion
    if "cells_per_zone" in results.fields and np.any(np.isfinite(results.fields["cells_per_zone"].values)):
        return draw_panels(results, "mean_pressure", ["contact_fraction", "adhesion_fraction", "penetration", "peak_pressure"])
    q = _share_of_full(results).ravel()
    order = np.argsort(q)
    names = ("contact_fraction", "contact_fraction_error")
    q, area, error = q[order], *(results.fields[name].values.ravel()[order] for name in names)
    figure, (axes, below) = plt.subplots(2, 1, sharex=True, figsize=(5.0, 4.6), height_ratios=(4, 1))
    axes.plot(q, area, color=COLOURS[2], linewidth=1, label="solved")
    axes.fill_between(q, area - error, area + error, color=COLOURS[2], alpha=0.3, linewidth=0)
    # a band of the width of the curve says little
    below.fill_between(q, 0, 1e3 * error, color=COLOURS[2], alpha=0.5, linewidth=0)
    below.set_ylim(bottom=0)
    below.set_ylabel("Error\nbound (10$^{-3}$)")
    light, heavy = np.linspace(0, LIGHT, 200), np.linspace(HEAVY, 1, 50)
    axes.plot(light, np.pi * (3 * light / (8 * np.pi)) ** (2 / 3), color=COLOURS[1], linestyle=DASHES[0], linewidth=1,
              label=r"light: $\pi\,(3p/8\pi p^*)^{2/3}$")
    axes.plot(heavy, 1 - 3 / (2 * np.pi) * (1 - heavy), color="0.3", linestyle=DASHES[3], linewidth=1,
              label=r"close to full: $1 - (3/2\pi)(1 - p/p^*)$")
    axes.axvline(MERGING, color="0.6", linewidth=0.6, zorder=0)
    axes.annotate(f"contacts merge\nat {MERGING} $p^*$", (MERGING, 0.03), xytext=(8, 4), textcoords="offset points",
                  fontsize="small", color="0.4")
    axes.set_xlim(0, max(1.0, np.nanmax(q, initial=0.0)))
    axes.set_ylim(0, 1.05)
    below.set_xlabel("Mean pressure $p/p^*$")
    axes.set_ylabel("Contact area $A/l^2$")
    axes.legend(loc="lower right", bbox_to_anchor=(0.98, 0.12))
    return figure


def draw_contact_maps(results):
    """Contact of a bi-sinusoidal wave, coloured by its pressure: two periods in each direction, from the quarter of one."""
    points = choose_points(results)
    axes = [_mirror(axis.values, -1.0) for axis in results.profile_axes]
    factor, unit = scale_of(axes[-1], results.profile_axes[-1].unit)
    # from two halves of a period to two periods
    y, x = (np.concatenate([axis, axis + axis[-1] - axis[0] + axis[1] - axis[0]]) * factor for axis in axes)
    full, area = (results.fields[name].values for name in ("full_contact_pressure", "contact_fraction"))
    pressure, share = results.profiles["pressure"].values, _share_of_full(results)
    shown = [np.tile(_mirror(_mirror(pressure[i] / full[i]).T).T, (2, 2)) for i in points]
    highest, lowest = (max(np.nanmax(sign * values, initial=0.0) for values in shown) for sign in (1, -1))
    colours, norm = plt.get_cmap("YlOrRd").with_extremes(bad=OPEN), Normalize(0, highest or 1.0)
    words, ticks = "Pressure over $p^*$; blue: no contact", None
    if lowest > 0:
        colours, norm = adhesion_colours(-lowest, highest)
        words, ticks = f"Pressure over $p^*$; {ADHESION_KEY}", adhesion_ticks(-lowest, highest)
    figure, panels = make_panels(len(points), (2.75, 2.5), (3.4, 3.2), shared=True)
    for panel, index, values in zip(panels, points, shown):
        image = panel.pcolormesh(x, y, np.where(values != 0, values, np.nan), cmap=colours, norm=norm, shading="nearest",
                                 rasterized=True)
        if lowest > 0:
            gap = relative_gap(results, index)
            draw_outline(panel, x, y, np.tile(_mirror(_mirror(gap).T).T, (2, 2)))
        panel.set_aspect("equal")
        panel.locator_params(nbins=5)
        panel.set_title(f"$p/p^*$ = {share[index]:.3g}, $A/l^2$ = {area[index]:.3f}", fontsize="small")
        if panel.get_subplotspec().is_last_row():
            panel.set_xlabel(axis_label("x", unit))
        label_rows(panel, axis_label("y", unit))
    figure.colorbar(image, ax=panels, label=words, ticks=ticks, shrink=0.85)
    return figure


def stresses_of(results):
    """Names of the maps of the stresses in the plane; none if they are not all there."""
    names = [name for name in STRESSES if name in results.profiles]
    return names if len(names) == COMPONENTS else []


def draw_pressures(results):
    """Pressure along the surface, a curve for each point of the sweep."""
    is_wave = "full_contact_pressure" in results.fields
    figure, axes = draw_profiles(results, "pressure", _touching, _share_label(results) if is_wave else None)
    pressure = results.profiles["pressure"]
    mean = "mean_contact_pressure" if "mean_contact_pressure" in results.fields else "mean_pressure"
    highest = min(np.nanmax(pressure.values, initial=0.0), TALLEST * np.nanmax(results.values(mean), initial=0.0))
    # tension of adhesion
    lowest = np.nanmin(pressure.values, initial=0.0)
    axes.set_ylim(*(1.05 * np.array([lowest, highest or 1.0]) * scale_of(pressure.values, pressure.unit)[0]))
    return figure


def draw_stress_maps(results):
    """Stresses in the plane over place and depth: a row for each point of the sweep, a column for each component."""
    points = choose_points(results)
    if len(points) > MOST_ROWS:
        points = [points[0], points[len(points) // 2], points[-1]]
    y, x = results.profile_axes
    x_factor, x_unit = scale_of(x.values, x.unit)
    names = stresses_of(results)
    fields = [results.profiles[name].values for name in names]
    levels, shear_levels = (choose_levels(np.concatenate([np.abs(values[index]).ravel() for values in part for index in points]))
                            for part in (fields[:-1], fields[-1:]))
    factor, unit = scale_of(levels, results.profiles["stress_xx_map"].unit)
    shape = abs(np.ptp(y.values) / np.ptp(x.values))
    figure, panels = plt.subplots(len(points), len(names), sharex=True, sharey=True, squeeze=False,
                                  figsize=(2.6 * len(names) + 0.6, (2.3 * shape + 0.35) * len(points) + 1.2))
    for row, index in zip(panels, points):
        for panel, name, values in zip(row, names, fields):
            edges, colours = (shear_levels, "YlOrRd") if values is fields[-1] else (np.append(-levels[::-1], levels), "RdBu_r")
            image = panel.contourf(x.values * x_factor, y.values * x_factor, values[index] * factor, levels=edges * factor,
                                   extend="both", colors=plt.get_cmap(colours)(np.linspace(0, 1, edges.size + 1)))
            panel.set_aspect("equal")
            if panel.get_subplotspec().is_first_row():
                panel.set_title(STRESSES[name])
                _add_levels(figure, panels, panel, image, unit)
            if panel.get_subplotspec().is_last_row():
                panel.set_xlabel(axis_label("x", x_unit))
        label = "depth " + axis_label(y.name, x_unit)
        label_rows(row[0], "\n".join(part for part in (point_label(results.describe(index), results.model), label) if part))
    panels[0, 0].invert_yaxis()
    return figure


def choose_levels(sizes):
    """Levels of positive numbers, the least of them above 0: even, or 1, 2, 5, 10 ... over two decades where few are large."""
    sizes = sizes[np.isfinite(sizes)]
    usual = np.quantile(sizes, SHOWN) if sizes.size else 0.0
    if not usual > 0:
        return np.array([0.5, 1.0])
    power = math.floor(math.log10(usual))
    steps = np.array([1.0, 2.0, 5.0])
    if sizes.max() > STEEP * usual:
        ladder = np.concatenate([10.0 ** (power + k) * steps for k in (-2, -1, 0)])
        return ladder[ladder <= usual][-7:]
    step = next(s for s in np.append(steps, 10.0) * 10.0 ** (power - 1) if usual / s <= 10)
    return step * np.arange(1, math.ceil(usual / step) + 1)


def draw_half_axes(results):
    """Half-axes of the ellipse of contact, largest pressure and approach against a principal radius."""
    radius = results.several[-1]
    major = "major_half_width" if "major_half_width" in results.fields else "contact_half_width"
    figure = draw_panels(results, radius.name, [major, "peak_pressure", "approach"])
    axes = figure.axes[0]
    factor, unit = scale_of(results.fields[major].values, "m")
    minor = results.fields["minor_half_width"].values
    along, order = results.axis_names.index(radius.name), np.argsort(radius.values)
    majors = list(axes.lines)
    for curve, line in zip(find_curves(results, radius.name), majors):
        values = np.moveaxis(minor, along, -1)[curve.index][order]
        axes.plot(line.get_xdata(), values * factor, color=line.get_color(), linestyle=DASHES[2])
    if np.isfinite(minor).any():
        axes.set_yscale("log")
        axes.relim()
        axes.autoscale(axis="y")
    axes.set_ylabel(f"Half-axis ({unit})")
    axes.legend(handles=[Line2D([], [], color="0.2", label="major $a$"),
                         Line2D([], [], color="0.2", linestyle=DASHES[2], label="minor $b$")])
    for panel in figure.axes:
        if radius.values.max() < 0:
            # a concave radius: logarithmic, too
            panel.set_xscale("symlog", linthresh=-radius.values.max(), subs=range(2, 10))
    return figure


def _add_levels(figure, panels, panel, image, unit):
    """The key of the levels of the signed stresses below their first column, and that of the shear below the last."""
    column = panel.get_subplotspec().colspan.start
    if 0 < column < COMPONENTS - 1:
        return
    part, words = (panels[:, :-1], "Stress") if column == 0 else (panels[:, -1], "Shear stress")
    bar = figure.colorbar(image, ax=part, location="bottom", aspect=50 if column == 0 else 15, spacing="uniform")
    bar.set_ticks(image.levels[::1 if column else max(1, image.levels.size // 12)])
    bar.ax.xaxis.set_major_formatter("{x:.3g}")
    bar.ax.tick_params(labelsize="x-small")
    bar.set_label(f"{words} ({unit})" if unit else words)


def _touching(pressure):
    """Pressure with the places next to the contact, but without those farther away."""
    near = np.convolve(pressure != 0, np.ones(3), mode="same") > 0
    return np.where(near, pressure, np.nan)


def _mirror(values, sign=1.0):
    """Values of a half of a period, continued to its other side."""
    return np.concatenate([sign * values[::-1], values])


def _share_of_full(results):
    """Mean pressure over that of full contact."""
    return results.values("mean_pressure") / results.fields["full_contact_pressure"].values


def _share_label(results):
    """What names the curve of a point: its mean pressure over that of full contact."""
    share = _share_of_full(results)
    return lambda index: f"$p/p^*$ = {share[index]:.3g}"
