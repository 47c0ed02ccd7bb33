"""Which figure a run has.

The papers are GM: Goryacheva, Makhovskaya, acta mechanica et automatica 5(4), 2011, and, in `sphere`, Johnson 1997.
"""

import numpy as np

from . import halfspace, sphere
from .curves import add_key, draw_curves, draw_panels, find_curves
from .labels import point_label, scale_of
from .results import NothingToDraw
from .style import plt
from .surface import draw_pressure_maps, draw_stresses

# results in the order in which they are worth drawing; others follow
MAIN_RESULTS = ("friction_force", "friction_coefficient", "contact_width", "contact_area", "contact_radius", "approach",
                "penetration", "load", "adhesion_area", "adhesion_radius")
CHECKS = ("error_estimate", "energy_imbalance", "residual", "contact_violation")
MOST_PANELS = 6


def choose_figure(results):
    """The procedure that draws a run: by its profiles, by its model and what was swept, or the general one."""
    several = [axis.name for axis in results.axes if axis.values.size > 1]
    if set(halfspace.STRESSES) <= set(results.profiles) and len(results.profile_axes) == 2:
        return halfspace.draw_stress_maps
    if "pressure" in results.profiles and results.model in PRESSURE_FIGURES:
        return PRESSURE_FIGURES[results.model]
    if "pressure" in results.profiles:
        if (results.model, several) == ("sphere", ["tangential_force"]):
            return sphere.draw_shear_traction
        return draw_pressure_maps if len(results.profile_axes) == 2 else draw_stresses
    if not several:
        raise NothingToDraw(f"{results.path}: one point without profiles of the pressure: nothing to draw")
    return FIGURES.get((results.model, frozenset(several)), draw_sweep)


def draw_width_and_friction(results):
    """Contact width and friction force against load (GM Fig. 5)."""
    return draw_panels(results, "load", ["contact_width", "friction_force"])


def draw_coefficient(results):
    """Friction coefficient against velocity (GM Fig. 6)."""
    return draw_panels(results, "velocity", ["friction_coefficient"])


def draw_friction(results):
    """Friction force against load, a panel for each velocity (GM Fig. 8)."""
    velocities = results.axes[results.axis_names.index("velocity")]
    count = velocities.values.size
    if count > MOST_PANELS:
        return draw_panels(results, "load", ["friction_force"])
    force = results.fields["friction_force"]
    scale = scale_of(force.values, force.unit)
    columns = min(count, 3)
    figure, panels = plt.subplots(-(-count // columns), columns, squeeze=False,
                                  figsize=(3.3 * columns + 0.4, 2.9 * -(-count // columns) + 0.2))
    for panel in panels.flat[count:]:
        panel.remove()
    for place, panel in zip(range(count), panels.flat):
        part = results.at("velocity", place)
        curves = find_curves(part, "load")
        draw_curves(panel, part, "load", "friction_force", curves, scale)
        panel.set_title(point_label([(velocities, velocities.values[place])], results.model))
    add_key(figure, panels.flat[0], part, "load", curves)
    return figure


def draw_sweep(results):
    """Every result worth drawing against the variable that varies fastest among those with several values."""
    several = [axis.name for axis in results.axes if axis.values.size > 1]
    return draw_panels(results, several[-1], choose_results(results))


def choose_results(results):
    """Names of the results that vary, the main ones first."""
    names = [name for name in MAIN_RESULTS if name in results.fields]
    names += [name for name in results.fields if name not in MAIN_RESULTS + CHECKS]
    varying = [name for name in names if _varies(results.fields[name].values)]
    if not varying:
        raise NothingToDraw(f"{results.path}: no result varies: nothing to draw")
    return varying[:MOST_PANELS]


def _varies(values):
    finite = values[np.isfinite(values)]
    return finite.size > 1 and np.ptp(finite) > 1e-12 * np.max(np.abs(finite))


# figures of their own, by model and the variables with several values; all others have that of draw_sweep
FIGURES = {
    ("wavy_sliding", frozenset({"load", "stress"})): draw_width_and_friction,
    ("wavy_sliding", frozenset({"load", "stress", "velocity"})): draw_friction,
    ("wavy_sliding", frozenset({"stress", "velocity"})): draw_coefficient,
    ("sphere", frozenset({"contact_radius", "lambda"})): sphere.draw_radii_against_load,
    ("sphere", frozenset({"load"})): sphere.draw_load,
    ("sphere", frozenset({"interaction", "lambda", "load"})): sphere.draw_area,
    ("sphere", frozenset({"interaction", "lambda", "load", "slip_energy_ratio"})): sphere.draw_area_left,
    ("sphere", frozenset({"interaction", "tangential_displacement"})): sphere.draw_peeling,
    ("sphere", frozenset({"tangential_force"})): sphere.draw_stick_radius,
    ("sphere", frozenset({"lambda"})): sphere.draw_pull_off,
    ("sphere", frozenset({"contact_radius", "work_of_adhesion"})): sphere.draw_load_and_radius,
    ("wave_2d_elastic", frozenset({"mean_pressure"})): halfspace.draw_area,
    ("wave_1d", frozenset({"mean_pressure"})): halfspace.draw_wave,
    ("hertz", frozenset({"radius_1x"})): halfspace.draw_half_axes,
    ("hertz", frozenset({"radius_2y"})): halfspace.draw_half_axes,
}
# figures of the pressure on the surface, by model; all others have those of `surface`
PRESSURE_FIGURES = {
    "wave_1d": halfspace.draw_pressures,
    "rigid_punch": halfspace.draw_pressures,
    "wave_2d_elastic": halfspace.draw_contact_maps,
}
