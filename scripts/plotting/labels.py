# SPDX-License-Identifier: GPL-3.0-or-later
"""Words, symbols and units beside the axes and curves."""

import math

import numpy as np

SYMBOLS = {
    "adhesion_fraction": "A_a/A_0",
    "adhesion_radius": "c",
    "adhesion_ratio": "X",
    "adhesion_stress": r"\sigma_0",
    "amplitude": "D",
    "approach": r"\delta",
    "area_left": "A/A^*",
    "contact_area": "A",
    "contact_fraction": "A/A_0",
    "contact_half_width": "a",
    "contact_modulus": "E^*",
    "contact_radius": "a",
    "contact_temperature": "T_c",
    "flash_temperature": r"\Delta T",
    "contact_width": "a + b",
    "crest_contact_width": "a + b",
    "coulomb_coefficient": r"\mu",
    "critical_slip": "s_0",
    "edge_fraction": "x",
    "edge_slip": "s",
    "friction_area": r"\pi b^2",
    "friction_coefficient": r"\mu",
    "friction_force": "T",
    "friction_radius": "b",
    "friction_stress": "T",
    "friction_stress_without_adhesion": "T_0", "friction_force_without_adhesion": "T_0",
    "heat_share": "s",
    "height": "h",
    "interaction": r"\alpha",
    "interfacial_share": r"T_i/T",
    "lambda": r"\lambda",
    "major_half_width": "a",
    "load": "P",
    "mean_pressure": "p",
    "minor_half_width": "b",
    "normal_load": "N",
    "normal_traction": "p_0",
    "peak_pressure": "p_0",
    "penetration": "D",
    "period": "l",
    "poisson_ratio": r"\nu",
    "position_x": "x",
    "position_y": "y",
    "position_z": "z",
    "pressure": "p",
    "pull_off_load": "P_c",
    "pull_off_pressure": "p_c",
    "pull_off_tension": "-p_c",
    "radius_1x": "R_{1x}",
    "radius_2y": "R_{2y}",
    "relative_area": "A/A_0",
    "relative_pull_off_load": r"P_c/(\pi w R)",
    "relative_stick_radius": "e/b",
    "relaxation_time": "T_s",
    "retardation_ratio": r"\beta",
    "shear_strength": r"\tau_0",
    "shear_stress": r"\tau",
    "root_mean_square_height": r"h_\mathrm{rms}",
    "slip": "s",
    "slip_energy_ratio": "g_0",
    "stick_radius": "e",
    "stiffness": "1/K",
    "stress": "p_0",
    "surface_energy": r"\gamma",
    "tangential_displacement": "D",
    "tangential_force": "T",
    "tangential_load": "T",
    "tangential_traction": "q_0",
    "temperature": "T",
    "velocity": "V",
    "velocity_slope": r"\mathrm{d} \ln T/\mathrm{d} \ln V",
    "work_of_adhesion": "w",
}
NAMES = {"area_left": "friction area", "contact_half_width": "half-width",
         "friction_stress_without_adhesion": "without adhesion", "friction_force_without_adhesion": "without adhesion", "lambda": "", "minor_half_width": "minor half-width",
         "position_x": "position", "position_y": "position", "position_z": "position", "pull_off_load": "pull-off load",
         "pull_off_excess": "pull-off beyond Dugdale's",
         "pull_off_pressure": "pull-off pressure", "pull_off_tension": "pull-off tension", "r": "", "radius_1x": "principal radius",
         "radius_2y": "principal radius",
         "relative_area": "friction area", "relative_pull_off_load": "pull-off load", "relative_stick_radius": "stick radius",
         "stress": "adhesion stress",
         "velocity": "sliding velocity", "x": "", "y": "", "z": ""}
PREFIXES = {-15: "f", -12: "p", -9: "n", -6: "µ", -3: "m", 0: "", 3: "k", 6: "M", 9: "G", 12: "T"}
# the power to which a prefix is raised with the first letter of the unit; others keep their unit as it is
PREFIXED = {"m": 1, "m/s": 1, "m^2": 2, "m^2/m": 1, "s": 1, "N": 1, "N/m": 1, "Pa": 1, "Pa/m": 1, "J": 1,
            "J/m^2": 1, "J/m": 1, "W": 1, "N m": 1}
# label of a curve without adhesion
NO_ADHESION = "no adhesion"
# quantities of one unit that differ by less than this have the same prefix
FAR_APART = 30.0


def scale_of(values, unit):
    """The factor that brings values into a readable range, and the unit they then have."""
    values = np.abs(np.asarray(values, dtype=float))
    values = values[np.isfinite(values) & (values > 0)]
    power = PREFIXED.get(unit)
    if power is None or values.size == 0:
        return 1.0, _pretty(unit)
    # a hair above a power of ten counts as one
    exponent = 3 * math.floor(math.log10(values.max() * (1 + 1e-9)) / (3 * power))
    # nobody speaks of millipascals
    exponent = min(max(exponent, 0 if unit.startswith("Pa") else -15), 0 if unit[0] in "ms" else 12)
    prefix = PREFIXES[exponent]
    if unit == "m^2/m":
        return 10.0**-exponent, f"{prefix}m²/{prefix}m"
    return 10.0 ** (-exponent * power), prefix + _pretty(unit)


def scales_of(fields):
    """`scale_of` for several quantities side by side: those of one unit have one prefix, unless they are far apart."""
    scales = {}
    for field in fields:
        alike = [_largest(other.values) for other in fields if other.unit == field.unit]
        alike = [value for value in alike if value > 0]
        together = alike and max(alike) < FAR_APART * min(alike)
        scales[field.name] = scale_of([max(alike)] if together else field.values, field.unit)
    return scales


def _largest(values):
    values = np.abs(np.asarray(values, dtype=float))
    return np.max(values[np.isfinite(values)], initial=0.0)


def axis_label(name, unit):
    """Label of an axis: name, symbol and unit."""
    words = NAMES.get(name, name.replace("_", " "))
    words = words[:1].upper() + words[1:]
    symbol = f"${SYMBOLS[name]}$" if name in SYMBOLS else ("" if words else f"${name}$")
    label = " ".join(part for part in (words, symbol) if part)
    return f"{label} ({unit})" if unit else label


def point_label(pairs, model):
    """Label of a curve or a panel: the swept values that it belongs to."""
    return ", ".join(_value_label(axis, value, model) for axis, value in pairs)


def _value_label(axis, value, model):
    if model == "wavy_sliding" and axis.name in ("adhesion_stress", "stress") and value == 0:
        return NO_ADHESION
    factor, unit = scale_of(axis.values, axis.unit)
    symbol = f"${SYMBOLS[axis.name]}$" if axis.name in SYMBOLS else axis.name.replace("_", " ")
    return f"{symbol} = {value * factor:.5g} {unit}".rstrip()


def _pretty(unit):
    return "" if unit == "-" else unit.replace("^2", "²").replace("^3", "³")
