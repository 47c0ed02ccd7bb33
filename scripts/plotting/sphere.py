"""Figures of the sphere, in the manner of J: K. L. Johnson, Proc. R. Soc. Lond. A 453 (1997) 163."""

import numpy as np
from matplotlib.lines import Line2D

from .curves import add_legend, draw_curves, draw_panels, find_curves
from .labels import axis_label, point_label, scale_of
from .results import Field
from .style import COLOURS, DASHES, norm_of, plt

# pull-off loads in pi w R, by what is given (J 2.11)
LIMITS = {"load": {"DMT": -2.0, "JKR": -3 / 2}, "approach": {"DMT": 0.0, "JKR": -5 / 6}}
BRANCHES = {"stable": {"linewidth": 1.4}, "unstable": {"linewidth": 0.6}}


def draw_radii_against_load(results):
    """Radii of contact and adhesion against load, both branches; the radius of contact is swept (J Fig. 3)."""
    along = results.axis_names.index("contact_radius")
    contact, load = results.axes[along], results.fields["load"]
    curves = find_curves(results, "contact_radius")
    adhesion = results.fields["adhesion_radius"]
    x_factor, x_unit = scale_of(load.values, load.unit)
    y_factor, y_unit = scale_of([np.nanmax(adhesion.values, initial=0.0), contact.values.max()], contact.unit)
    figure, axes = plt.subplots(figsize=(4.8, 3.6))
    # all curves up to one load
    largest = np.min(np.nanmax(load.values, axis=along, initial=-np.inf))
    for curve in curves:
        x, c = (np.moveaxis(field.values, along, -1)[curve.index] for field in (load, adhesion))
        stable = _is_stable(results, along, curve.index)
        for branch, style in BRANCHES.items():
            here = (stable if branch == "stable" else ~stable) & (x <= largest)
            for radius, dashes in ((contact.values, "-"), (c, (0, (4, 2)))):
                axes.plot(x * x_factor, np.where(here, radius, np.nan) * y_factor, color=curve.style["color"],
                          linestyle=dashes, **style)
    axes.axvline(0, color="0.7", linewidth=0.6, zorder=0)
    axes.set_ylim(bottom=0)
    axes.set_xlabel(axis_label("load", x_unit))
    axes.set_ylabel("Radius of contact $a$, of adhesion $c$" + (f" ({y_unit})" if y_unit else ""))
    words = [(curve.label, curve.style) for curve in curves]
    words += [("$a$", {"color": "0.4"}), ("$c$", {"color": "0.4", "linestyle": (0, (4, 2))}),
              ("unstable", {"color": "0.4", "linewidth": BRANCHES["unstable"]["linewidth"]})]
    _add_words(axes, words)
    return figure


def draw_load_and_radius(results):
    """Radius of contact against load for several works of adhesion; the radius is swept, so both branches are there."""
    along = results.axis_names.index("contact_radius")
    contact, load = results.axes[along], results.fields["load"]
    x_factor, x_unit = scale_of(load.values, load.unit)
    y_factor, y_unit = scale_of(contact.values, contact.unit)
    figure, axes = plt.subplots(figsize=(4.8, 3.6))
    largest = np.min(np.nanmax(load.values, axis=along, initial=-np.inf))
    words = []
    for curve in find_curves(results, "contact_radius"):
        x = np.moveaxis(load.values, along, -1)[curve.index]
        stable = _is_stable(results, along, curve.index)
        for branch, style in BRANCHES.items():
            here = (stable if branch == "stable" else ~stable) & (x <= largest)
            axes.plot(x * x_factor, np.where(here, contact.values, np.nan) * y_factor, color=curve.style["color"], **style)
        words.append((f"{curve.label}{_main_theory(results, along, curve.index, stable)}", curve.style))
    words.append(("unstable under a given load", {"color": "0.4", "linewidth": BRANCHES["unstable"]["linewidth"]}))
    axes.axvline(0, color="0.7", linewidth=0.6, zorder=0)
    axes.set_ylim(bottom=0)
    axes.set_xlabel(axis_label("load", x_unit))
    axes.set_ylabel(axis_label("contact_radius", y_unit))
    _add_words(axes, words)
    return figure


def draw_load(results):
    """Friction force against load (J Fig. 5); without friction, radius and approach."""
    names = ["friction_force"] if _has_values(results, "friction_force") else ["contact_radius", "approach"]
    return draw_panels(results, "load", [name for name in names if name in results.fields])


def draw_area(results):
    """Contact area against load for several alpha, one line style for each lambda (J Fig. 7)."""
    figure, axes = plt.subplots(figsize=(4.8, 3.6))
    curves = _draw_family(axes, results, "load", "friction_area")
    _add_family_key(axes, results, curves)
    return figure


def draw_area_left(results):
    """Contact area over that without interaction against g0 for several alpha, a panel for each load (J Fig. 8)."""
    alpha = results.axis_names.index("interaction")
    area = results.fields["friction_area"]
    whole = np.take(area.values, [results.axes[alpha].values.argmin()], axis=alpha)
    results.fields["area_left"] = Field("area_left", "-", _ratio(area.values, whole))
    loads = results.axes[results.axis_names.index("load")]
    figure, panels = plt.subplots(1, loads.values.size, squeeze=False, sharey=True,
                                  figsize=(2.6 * loads.values.size + 0.8, 3.2))
    for k, panel in enumerate(panels.flat):
        part = results.at("load", k)
        curves = _draw_family(panel, part, "slip_energy_ratio", "area_left")
        panel.set_title(point_label([(loads, loads.values[k])], results.model))
        panel.set_xlim(left=0)
        if k:
            panel.set_ylabel("")
    _add_family_key(panels.flat[0], part, curves)
    return figure


def draw_peeling(results):
    """Tangential force and contact area against tangential displacement, then those of sliding, thin (J Fig. 9)."""
    along = results.axis_names.index("tangential_displacement")
    displacement = results.axes[along].values
    area = results.fields["friction_area"].values
    whole = np.take(area, [displacement.argmin()], axis=along)
    results.fields["relative_area"] = Field("relative_area", "-", _ratio(area, whole))
    names = ["friction_force", "relative_area"]
    figure = draw_panels(results, "tangential_displacement", names)
    slides = dict(zip(names, _sliding(results, area, whole)))
    x_factor, _ = scale_of(displacement, results.axes[along].unit)
    for panel, name in zip(figure.axes, names):
        field = results.fields[name]
        factor, _ = scale_of(field.values, field.unit)
        for curve in find_curves(results, "tangential_displacement"):
            known, level = (np.moveaxis(values, along, -1)[curve.index] for values in (field.values, slides[name]))
            if np.isfinite(known).any() and np.isfinite(level).any():
                last = displacement[np.isfinite(known)].max()
                panel.plot(np.array([last, last, displacement.max()]) * x_factor,
                           np.array([known[displacement == last][0], np.nanmax(level), np.nanmax(level)]) * factor,
                           **{**curve.style, "linewidth": 0.6, "linestyle": (0, (4, 2))})
    return figure


def draw_stick_radius(results):
    """Radius of the part that sticks, over that of friction, against tangential force (J Fig. 11); the area if it varies."""
    e, b = (results.fields[name].values for name in ("stick_radius", "friction_radius"))
    results.fields["relative_stick_radius"] = Field("relative_stick_radius", "-", _ratio(e, b))
    area = results.fields["friction_area"].values
    if np.nanmax(area, initial=0.0) > (1 + 1e-9) * np.nanmin(area, initial=np.inf):
        # what T is measured by changes with it
        return draw_panels(results, "tangential_force", ["relative_stick_radius", "friction_area"])
    along = results.axis_names.index("tangential_force")
    figure, axes = plt.subplots(figsize=(4.6, 3.4))
    for curve in find_curves(results, "tangential_force"):
        ratio = np.moveaxis(results.fields["relative_stick_radius"].values, along, -1)[curve.index]
        axes.plot(_share_of_sliding(ratio), ratio, label=curve.label or "_", **curve.style)
    axes.set_xlim(0, 1)
    axes.set_ylim(bottom=0)
    axes.set_xlabel(axis_label("relative_force", ""))
    axes.set_ylabel(axis_label("relative_stick_radius", ""))
    return figure


def draw_shear_traction(results):
    """Shear traction along the radius, a curve for each tangential force (J Fig. 6)."""
    r, shear, b = results.profile_axes[-1].values, results.profiles["shear_stress"], results.fields["friction_radius"].values
    factor, unit = scale_of(shear.values, shear.unit)
    label = axis_label("shear_traction", unit)
    if shear.unit == "-" and "shear_strength" in results.constants:
        factor, label = 1 / results.constants["shear_strength"].values, axis_label("relative_shear_traction", "")
    forces = results.axes[results.axis_names.index("tangential_force")].values
    figure, axes = plt.subplots(figsize=(5.2, 3.4))
    norm = norm_of(forces)
    places = list(np.ndindex(*b.shape))
    share = _share_of_sliding(_ratio(results.fields["stick_radius"].values, b))
    for place, index in enumerate(places):
        colour = COLOURS[place] if len(places) <= len(COLOURS) else plt.get_cmap("viridis")(norm(forces.flat[place]))
        radius = np.divide(r, b[index], out=np.full(r.size, np.nan), where=b[index] > 0)
        axes.plot(radius, shear.values[index] * factor, color=colour,
                  label=f"{share[index]:.3g}")
    axes.set_xlim(0, 1)
    axes.set_ylim(bottom=0)
    axes.set_xlabel("Radius $r/b$")
    axes.set_ylabel(label)
    axes.legend(loc="center left", bbox_to_anchor=(1.02, 0.5), title=r"$T/(\pi b^2 \tau_0)$", title_fontsize="small")
    return figure


def draw_pull_off(results):
    """Pull-off load against lambda, with the limits of the simpler theories."""
    figure = draw_panels(results, "lambda", ["pull_off_load"])
    axes = figure.axes[0]
    if results.fields["pull_off_load"].unit != "-":
        return figure
    axes.set_ylabel(axis_label("relative_pull_off_load", ""))
    given = "load" if np.ptp(results.fields["load"].values) == 0 else "approach"
    for name, limit in LIMITS[given].items():
        axes.axhline(limit, color="0.6", linewidth=0.6, linestyle=DASHES[0], zorder=0)
        axes.annotate(name, (0.97, limit), xycoords=("axes fraction", "data"), xytext=(0, 4), textcoords="offset points",
                      ha="right", va="bottom", fontsize="small", color="0.4")
    axes.set_ylim(*(-2.1, -1.4) if given == "load" else (-1.1, 0.1))
    return figure


def _draw_family(axes, results, abscissa, ordinate):
    """Curves with a colour for each alpha and dashes for each lambda."""
    curves = find_curves(results, abscissa)
    draw_curves(axes, results, abscissa, ordinate, curves)
    return curves


def _add_family_key(axes, results, curves):
    """The key of `_draw_family`, colours and dashes apart; a lambda so large that JKR was used is called so."""
    if "linestyle" not in curves[0].style:
        if len(curves) <= len(COLOURS):
            add_legend(axes.figure, axes, *axes.get_legend_handles_labels())
        return
    names = [axis for axis in results.axes if axis.values.size > 1]
    colours, dashes = names[:2]
    words = [(point_label([(colours, value)], results.model), {"color": COLOURS[i]}) for i, value in enumerate(colours.values)]
    words += [(_theory(results, dashes, i) or point_label([(dashes, value)], results.model),
               {"color": "0.4", "linestyle": DASHES[i]}) for i, value in enumerate(dashes.values)]
    _add_words(axes, words)


def _theory(results, axis, i):
    """'JKR' where that theory was used for nearly every solved point of a value of an axis."""
    if "theory_used" not in results.states:
        return None
    used = np.take(results.states["theory_used"], i, axis=results.axis_names.index(axis.name))
    return "JKR" if np.sum(used == "jkr") > 0.9 * np.sum(used != None) else None  # noqa: E711


def _main_theory(results, along, index, stable):
    """The theory of all stable points of a curve as words to add, if there is one."""
    if "theory_used" not in results.states:
        return ""
    used = {word for word in np.moveaxis(results.states["theory_used"], along, -1)[index][stable] if word}
    names = {"hertz": "Hertz", "jkr": "JKR", "dmt": "DMT", "maugis_dugdale": "Maugis-Dugdale"}
    return f", {names[used.pop()]}" if len(used) == 1 else ""


def _add_words(axes, words):
    add_legend(axes.figure, axes, [Line2D([], [], **style) for _, style in words], [word for word, _ in words])


def _sliding(results, area, whole):
    """Force and relative area of sliding, where the file has the force: the area is the force over the strength."""
    if "sliding_force" not in results.fields:
        return [np.full(area.shape, np.nan)] * 2
    force = results.fields["sliding_force"].values
    gamma = _ratio(*(results.fields[name].values for name in ("stick_radius", "friction_radius")))
    strength = _ratio(results.fields["friction_force"].values, _share_of_sliding(gamma) * area)
    return [force, _ratio(force, strength * whole)]


def _share_of_sliding(gamma):
    """T/(pi b^2 tau0) where the part that sticks has the radius gamma b (J 3.4)."""
    return 2 / np.pi * (np.arccos(gamma) + gamma * np.sqrt(1 - gamma**2))


def _ratio(part, whole):
    """NaN where there is no whole."""
    whole = np.nan_to_num(whole)
    return np.divide(part, whole, out=np.full(part.shape, np.nan), where=np.broadcast_to(whole, part.shape) > 0)


def _is_stable(results, along, index):
    """Which points of a curve are stable under their load; all, where the file does not say."""
    if "stable" not in results.states:
        return np.full(results.axes[along].values.size, True)
    return np.moveaxis(results.states["stable"], along, -1)[index] == "stable"


def _has_values(results, name):
    return name in results.fields and np.isfinite(results.fields[name].values).any()
