# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of the sphere, in the manner of J: K. L. Johnson, Proc. R. Soc. Lond. A 453 (1997) 163."""

import numpy as np
from matplotlib.lines import Line2D

from .curves import add_legend, draw_panels, draw_profiles, find_curves
from .labels import axis_label, scale_of
from .results import Field
from .style import DASHES, plt

# pull-off loads in pi w R, by what is given (J 2.11)
LIMITS = {"load": {"DMT": -2.0, "JKR": -3 / 2}, "approach": {"DMT": 0.0, "JKR": -5 / 6}}
# the reduced unit of force, pi w R, is so many times that of stress times that of length squared (J 2.11)
REDUCED_FORCE = 2.0
STABLE, UNSTABLE = {"linewidth": 1.4}, {"linewidth": 0.6}
# Hertz's radius in reduced units (J 2.11)
HERTZ = {"color": "0.6", "linestyle": DASHES[2], "linewidth": 1.0}
# radii of contact and adhesion that differ by less are one
SAME_RADIUS = 1e-6


def draw_radii(results):
    """Radius of contact, which is swept, and that of adhesion where it is another one, against load on both branches (J Fig. 3)."""
    along = results.axis_names.index("contact_radius")
    contact, load, adhesion = results.axes[along], results.fields["load"], results.fields["adhesion_radius"]
    radii = {"a": results.values("contact_radius")}
    if np.any(adhesion.values > (1 + SAME_RADIUS) * radii["a"]):
        radii["c"] = adhesion.values
    x_factor, x_unit = scale_of(load.values, load.unit)
    y_factor, y_unit = scale_of([np.nanmax(values, initial=0.0) for values in radii.values()], contact.unit)
    figure, axes = plt.subplots(figsize=(4.8, 3.6))
    # all curves up to one load
    largest = np.min(np.nanmax(load.values, axis=along, initial=-np.inf))
    curves = find_curves(results, "contact_radius")
    for curve in curves:
        x = np.moveaxis(load.values, along, -1)[curve.index]
        stable = _is_stable(results, along, curve.index)
        for here, style in ((stable, STABLE), (~stable, UNSTABLE)):
            for values, dashes in zip(radii.values(), ("-", DASHES[0])):
                y = np.where(here & (x <= largest), np.moveaxis(values, along, -1)[curve.index], np.nan)
                axes.plot(x * x_factor, y * y_factor, color=curve.style["color"], linestyle=dashes, **style)
    axes.axvline(0, color="0.7", linewidth=0.6, zorder=0)
    is_reduced = load.unit == "-"
    if is_reduced:
        pressed = np.linspace(0, largest, 200)
        axes.plot(pressed, np.cbrt(pressed), zorder=1, **HERTZ)
    axes.set_ylim(bottom=0)
    axes.set_xlabel(axis_label("load", x_unit))
    axes.set_ylabel(axis_label("contact_radius", y_unit) if len(radii) == 1 else
                    "Radius of contact $a$, of adhesion $c$" + (f" ({y_unit})" if y_unit else ""))
    words = [(curve.label, curve.style) for curve in curves if curve.label]
    if len(radii) > 1:
        words += [(f"${name}$", {"color": "0.4", "linestyle": dashes}) for name, dashes in zip(radii, ("-", DASHES[0]))]
    words.append(("unstable under a given load", {"color": "0.4", **UNSTABLE}))
    if is_reduced:
        words.append(("Hertz, $a^3 = P$", HERTZ))
    add_legend(figure, axes, [Line2D([], [], **style) for _, style in words], [word for word, _ in words])
    return figure


def draw_area_left(results):
    """Area of friction over that of the least alpha, against g0 (J Fig. 8)."""
    area = results.fields["friction_area"]
    if "interaction" not in results.axis_names:
        return draw_panels(results, "slip_energy_ratio", ["friction_area"])
    results.fields["area_left"] = Field("area_left", "-", _ratio(area.values, _first(results, area.values, "interaction")))
    return draw_panels(results, "slip_energy_ratio", ["area_left"])


def draw_peeling(results):
    """Tangential force, and friction area over that at rest, against tangential displacement, and the area against the force (J Fig. 9);
    in sliding, and in the drop at its onset, a thin line."""
    along = results.axis_names.index("tangential_displacement")
    displacement = results.axes[along].values
    area = results.fields["friction_area"].values
    whole = _first(results, area, "tangential_displacement")
    results.fields["relative_area"] = Field("relative_area", "-", _ratio(area, whole))
    # the force that is applied and that of sliding have other names in files of models
    applied, sliding = ("tangential_force", "friction_force") if "tangential_force" in results.fields else ("friction_force", "sliding_force")
    names = [applied, "relative_area"]
    figure = draw_panels(results, "tangential_displacement", [*names, "relative_area"])
    force, strength = results.fields.get(sliding), results.constants.get("shear_strength")
    slides = {}
    if force:
        slides[applied] = force.values
    if force and strength:
        unit = REDUCED_FORCE if force.unit == "-" else 1.0
        slides["relative_area"] = _ratio(unit * force.values / strength.values, whole)
    x_factor, _ = scale_of(displacement, results.axes[along].unit)
    for panel, name in zip(figure.axes, names):
        field = results.fields[name]
        factor, _ = scale_of(field.values, field.unit)
        for curve in find_curves(results, "tangential_displacement") if name in slides else ():
            known, level = (np.moveaxis(values, along, -1)[curve.index] for values in (field.values, slides[name]))
            if np.isfinite(known).any() and np.isfinite(level).any():
                last = displacement[np.isfinite(known)].max()
                panel.plot(np.array([last, last, displacement.max()]) * x_factor,
                           np.array([known[displacement == last][0], np.nanmax(level), np.nanmax(level)]) * factor,
                           **{**curve.style, **UNSTABLE, "linestyle": DASHES[0]})
    _draw_area_of_force(figure.axes[2], results, along, applied, slides)
    return figure


def _draw_area_of_force(panel, results, along, applied, slides):
    """Friction area over that at rest against tangential force, up to the onset of sliding, and the drop there."""
    panel.clear()
    force = results.fields[applied]
    factor, unit = scale_of(force.values, force.unit)
    for curve in find_curves(results, "tangential_displacement"):
        x, y = (np.moveaxis(results.fields[name].values, along, -1)[curve.index] for name in (applied, "relative_area"))
        panel.plot(x * factor, y, **curve.style)
        known = np.flatnonzero(np.isfinite(x))
        if not slides or not known.size:
            continue
        ends = [np.moveaxis(slides[name], along, -1)[curve.index] for name in (applied, "relative_area")] if len(slides) > 1 else []
        if ends and all(np.isfinite(values).any() for values in ends):
            last = known[-1]
            panel.plot(np.array([x[last], np.nanmax(ends[0])]) * factor, [y[last], np.nanmax(ends[1])],
                       **{**curve.style, **UNSTABLE, "linestyle": DASHES[0], "marker": "o", "markersize": 3, "markevery": [1]})
    panel.set_xlim(left=0)
    panel.set_ylim(bottom=0)
    panel.set_xlabel(axis_label(applied, unit))
    panel.set_ylabel(axis_label("relative_area", ""))


def draw_stick_radius(results):
    """Radius of the part that sticks, over that of friction, against tangential force (J Fig. 11); the area if it varies."""
    e, b = (results.fields[name].values for name in ("stick_radius", "friction_radius"))
    results.fields["relative_stick_radius"] = Field("relative_stick_radius", "-", _ratio(e, b))
    names = ["relative_stick_radius"]
    if np.nanmax(b, initial=0.0) > (1 + SAME_RADIUS) * np.nanmin(b, initial=np.inf):
        names.append("friction_area")
    return draw_panels(results, "tangential_force", names)


def draw_shear_stress(results):
    """Shear stress along the radius, a curve for each point of the sweep (J Fig. 6)."""
    figure, axes = draw_profiles(results, "shear_stress")
    axes.set_ylim(bottom=0)
    return figure


def draw_pull_off(results):
    """Pull-off load against lambda, with the limits of the simpler theories."""
    figure = draw_panels(results, "lambda", ["pull_off_load"])
    axes = figure.axes[0]
    if results.fields["pull_off_load"].unit != "-":
        return figure
    axes.set_ylabel(axis_label("relative_pull_off_load", ""))
    draw_limits(axes, "approach" if {"approach", "operating_approach"} & {*results.axis_names, *results.constants} else "load")
    return figure


def lambda_of(stress, radius, energy, modulus):
    """Maugis's parameter [-] of a sphere: stress [Pa], radius [m], work of adhesion [J/m^2], E* [Pa] (J 2.12)."""
    return stress * (9 * radius / (2 * np.pi * energy * modulus**2)) ** (1 / 3)


def relative_pull_off(load, radius, energy):
    """A load [N] over pi w R."""
    return load / (np.pi * energy * radius)


def draw_limits(axes, given):
    """The pull-off of the simpler theories in pi w R, under a given `load` or `approach`."""
    for name, limit in LIMITS[given].items():
        axes.axhline(limit, color="0.6", linewidth=0.6, linestyle=DASHES[0], zorder=0)
        axes.annotate(name, (0.97, limit), xycoords=("axes fraction", "data"), xytext=(0, 4), textcoords="offset points",
                      ha="right", va="bottom", fontsize="small", color="0.4")
    axes.set_ylim(*(-2.1, -1.4) if given == "load" else (-1.1, 0.1))


def _first(results, values, name):
    """Values at the least value of a swept variable, at all of its places."""
    along = results.axis_names.index(name)
    return np.take(values, [results.axes[along].values.argmin()], axis=along)


def _ratio(part, whole):
    """NaN where there is no whole."""
    return np.divide(part, whole, out=np.full(part.shape, np.nan), where=np.broadcast_to(np.nan_to_num(whole) > 0, part.shape))


def _is_stable(results, along, index):
    """Which points of a curve are stable under their load; all, where the file does not say."""
    if "stable" not in results.states:
        return np.full(results.axes[along].values.size, True)
    return np.moveaxis(results.states["stable"], along, -1)[index] == "stable"
