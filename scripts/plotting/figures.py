# SPDX-License-Identifier: GPL-3.0-or-later
"""Which figure a run has.

The papers are GM: Goryacheva, Makhovskaya, acta mechanica et automatica 5(4), 2011, and, in `sphere`, Johnson 1997.
"""

import numpy as np

from . import adhesion, fit, halfspace, history, rough, rubber, samples, sliding, sphere, split
from .curves import draw_panels
from .results import NothingToDraw
from .surface import draw_pressure_maps, draw_stresses

# Names are those of scenes and, beside them, those of models: files of either are drawn.
# results in the order in which they are worth drawing; others follow
MAIN_RESULTS = ("friction_force", "friction_stress", "friction_coefficient", "contact_width", "contact_area", "contact_radius",
                "approach", "penetration", "load", "adhesion_area", "adhesion_radius")
CHECKS = ("error_estimate", "energy_imbalance", "residual", "contact_violation")
MOST_RESULTS = 6
# kinds of surfaces whose heights are drawn below the pressure
ROUGH_LINES = ("profile", "cosines")
# results of partial slip
SLIP = ("stick_fraction", "tangential_displacement", "tangential_stiffness", "friction_loss_per_cycle", "cycle_energy")
# results drawn against a swept variable, as far as they vary, by model and variable, or by model; for others it is all that vary
SHOWN = {
    "adhesive_indenter_time": ("pull_off_load", "pull_off_approach"),
    ("hertz", "tangential_force"): SLIP,
    ("indenter", "tangential_force"): SLIP,
    ("attracted_indenter", "lambda"): ("pull_off_load", "pull_off_excess"),
    ("wave_1d", "tangential_stress"): SLIP,
    ("wave_2d_elastic", "tangential_stress"): SLIP,
    ("surface_elastic", "tangential_stress"): SLIP,
    ("indenter", "base_approach"): ("contact_area", "contact_radius", "approach", "load", "adhesion_radius", "contact_stiffness"),
    ("hertz", "velocity"): ("friction_coefficient", "contact_half_width", "contact_shift", "peak_pressure"),
    ("wavy_sliding", "load"): ("contact_width", "crest_contact_width", "friction_stress", "friction_force"),
    ("wavy_sliding", "velocity"): ("friction_coefficient",),
    ("sphere", "load"): ("friction_force", "friction_area"),
    ("surface_sliding", "mean_pressure"): ("friction_coefficient", "contact_fraction", "peak_pressure", "contact_shift"),
    ("surface_elastic", "mean_pressure"): ("friction_stress", "contact_fraction", "adhesion_fraction", "peak_pressure"),
    ("wave_1d", "mean_pressure"): ("contact_fraction", "peak_pressure", "mean_gap", "largest_gap"),
    ("wave_1d", "penetration"): ("mean_pressure", "contact_fraction", "adhesion_fraction", "peak_pressure"),
    ("wave_1d", "adhesion_stress"): ("pull_off_pressure", "adhesion_hysteresis"),
    ("wave_1d", "stress"): ("pull_off_pressure", "hysteresis_loss"),
    ("wave_2d_elastic", "penetration"): ("mean_pressure", "contact_fraction", "adhesion_fraction", "peak_pressure"),
    ("surface_elastic", "penetration"): ("mean_pressure", "contact_fraction", "adhesion_fraction", "peak_pressure"),
    ("wave_1d", "velocity"): ("friction_coefficient", "contact_fraction", "contact_shift", "peak_pressure"),
}


def choose_figure(results):
    """The procedure that draws a run: by its profiles, or by its model and the variable that varies fastest."""
    if fit.is_fit(results):
        return fit.draw_fit
    if results.model.endswith("_history") or results.model in ("indenter_time", "surface_time") or (
            results.model == "adhesive_indenter_time" and not results.several):
        return history.draw_history
    if "pressure" in results.profiles or halfspace.stresses_of(results):
        return choose_profiles(results)
    along = results.several[-1].name if results.several else None
    if along is None:
        raise NothingToDraw(f"{results.path}: one point without profiles of the pressure: nothing to draw")
    if along in samples.AXES:
        return lambda found: samples.draw_samples(found, choose_results(found)[0])
    if split.has_parts(results):
        return split.draw_split
    if rough.has_theories(results):
        return rough.draw_theories
    return FIGURES.get((results.model, along), draw_sweep)


def choose_profiles(results):
    """The procedure that draws the profiles of a run."""
    if len(results.profile_axes) == 2 and halfspace.stresses_of(results):
        return halfspace.draw_stress_maps
    if results.model in PRESSURE_FIGURES:
        return PRESSURE_FIGURES[results.model]
    if results.model == "sphere" and results.several and results.several[-1].name == "tangential_force":
        return sphere.draw_shear_stress
    if results.words.get("kind") in ROUGH_LINES and {"displacement", "gap"} <= set(results.profiles) and len(results.profile_axes) == 1:
        return rubber.draw_lines
    return draw_pressure_maps if len(results.profile_axes) == 2 else draw_stresses


def draw_sweep(results):
    """The results worth drawing against the variable that varies fastest."""
    return draw_panels(results, results.several[-1].name, choose_results(results))


def choose_results(results):
    """Names of the results that vary, the main ones first."""
    shown = SHOWN.get((results.model, results.several[-1].name), SHOWN.get(results.model, ())) if results.several else ()
    varying = [name for name in shown if name in results.fields and _varies(results.fields[name].values)]
    if varying:
        return varying
    names = [name for name in MAIN_RESULTS if name in results.fields]
    names += [name for name in results.fields if name not in MAIN_RESULTS + CHECKS and name not in results.beside]
    varying = [name for name in names if _varies(results.fields[name].values)]
    if not varying:
        raise NothingToDraw(f"{results.path}: no result varies: nothing to draw")
    return varying[:MOST_RESULTS]


def _varies(values):
    finite = values[np.isfinite(values)]
    return finite.size > 1 and np.ptp(finite) > 1e-12 * np.max(np.abs(finite))


# figures with more in them than results against a variable, by model and the variable that varies fastest
FIGURES = {
    ("wavy_sliding", "velocity"): rubber.draw_velocities,
    ("surface_sliding", "velocity"): sliding.draw_friction,
    ("surface_sliding", "temperature"): sliding.draw_friction,
    ("sphere", "contact_radius"): sphere.draw_radii,
    ("sphere", "slip_energy_ratio"): sphere.draw_area_left,
    ("sphere", "tangential_displacement"): sphere.draw_peeling,
    ("sphere", "tangential_force"): sphere.draw_stick_radius,
    ("sphere", "lambda"): sphere.draw_pull_off,
    ("wave_2d_elastic", "mean_pressure"): halfspace.draw_area,
    ("wave_2d_elastic", "adhesion_stress"): adhesion.draw_pull_off,
    ("wave_2d_elastic", "adhesion_range"): adhesion.draw_pull_off,
    ("wave_2d_elastic", "stress"): adhesion.draw_pull_off,
    ("wave_2d_elastic", "range"): adhesion.draw_pull_off,
    ("surface_elastic", "root_mean_square_height"): adhesion.draw_stickiness,
    ("hertz", "radius_1x"): halfspace.draw_half_axes,
    ("hertz", "radius_2y"): halfspace.draw_half_axes,
}
# figures of the pressure on the surface, by model; all others have those of `surface`
PRESSURE_FIGURES = {
    "wave_1d": halfspace.draw_pressures,
    "rigid_punch": halfspace.draw_pressures,
    "wave_2d_elastic": halfspace.draw_contact_maps,
    "surface_sliding": sliding.draw_contacts,
}
