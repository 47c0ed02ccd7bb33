# SPDX-License-Identifier: GPL-3.0-or-later
"""Master curves: storage and loss modulus over the frequency at a reference temperature."""

import re
from dataclasses import dataclass

import numpy as np

from .problems import BadInput
from .tables import read_table
from .units import CYCLES, check_unit, settle, to_si, unit_in
from .writing import add_axis, add_dataset, hdf5_image

# heads of columns, without their units, in small letters
FREQUENCY = {"frequency", "freq", "freq.", "f", "omega", "w", "\u03c9", "angular frequency", "angular_frequency",
             "reduced frequency", "reduced angular frequency"}
ANGULAR = {"omega", "w", "\u03c9", "angular frequency", "angular_frequency", "reduced angular frequency"}
STORAGE = {"storage", "storage modulus", "storage_modulus"}
LOSS = {"loss", "loss modulus", "loss_modulus"}
# E' and E'', G' and G'', with straight, curly and prime marks
MARKS = str.maketrans({"\u2032": "'", "\u2019": "'", "\u00b4": "'", "\u2033": "''", "\u201d": "''", '"': "''"})
TEMPERATURE = re.compile(r"reference[ _]temperature\s*[:=]?\s*(-?[0-9.]+(?:[eE][-+]?\d+)?)\s*(\S+)?", re.IGNORECASE)
CELSIUS, ZERO_CELSIUS = {"C", "\u00b0C", "degC", "Celsius"}, 273.15
FEWEST_ROWS = 2


@dataclass
class MasterCurve:
    """Moduli [Pa] over the angular frequency [rad/s], which rises, at a temperature [K]."""

    omega: np.ndarray
    storage: np.ndarray
    loss: np.ndarray
    temperature: float
    # Poisson's ratio by which shear moduli became Young's moduli; None where they were Young's
    poisson_ratio: float | None


def read_master_curve(path, given):
    """Read a master curve from a table with heads."""
    table = read_table(path)
    names, units = zip(*(unit_in(head) for head in table.heads)) if table.heads else ((), ())
    names = [name.translate(MARKS).lower() for name in names]
    places, is_shear = find_columns(names, path)
    frequency_unit = unit_of_frequency(names[places[0]], units[places[0]], given.frequency_unit, path)
    omega = to_si(table.values[:, places[0]], frequency_unit, "frequency")
    moduli = [to_si(table.values[:, place], settle(units[place] or None, given.modulus_unit, "--modulus-unit", "modulus", path),
                    "modulus") for place in places[1:]]
    check_values(omega, *moduli, path)
    order = np.argsort(omega)
    if not (np.diff(omega[order]) > 0).all():
        raise BadInput(f"{path}: a frequency occurs twice")
    factor, poisson_ratio = young_of_shear(is_shear, given.poisson_ratio, path)
    return MasterCurve(omega[order], factor * moduli[0][order], factor * moduli[1][order],
                       temperature_of(table.comments, given.reference_temperature, path), poisson_ratio)


def find_columns(names, path):
    """Numbers of the columns of frequency, storage and loss, and whether the moduli are those of shear."""
    shear = {"g'", "g''"} & set(names)
    if shear and {"e'", "e''"} & set(names):
        raise BadInput(f"{path}: the table has both E and G moduli")
    letter = "g" if shear or any("shear" in name for name in names) else "e"
    wanted = (("frequency", FREQUENCY), ("storage modulus", {letter + "'"} | STORAGE | {"shear " + name for name in STORAGE}),
              ("loss modulus", {letter + "''"} | LOSS | {"shear " + name for name in LOSS}))
    places = []
    for what, known in wanted:
        found = [place for place, name in enumerate(names) if name in known]
        if len(found) != 1:
            raise BadInput(f"{path}: {'no' if not found else 'more than one'} column of the {what}; heads such as "
                           "frequency [Hz], E' [MPa], E'' [MPa] name the columns")
        places += found
    return places, letter == "g"


def unit_of_frequency(name, stated, given, path):
    """Unit of the frequency: cycles and radians are told apart by it alone."""
    if name in ANGULAR and stated in CYCLES:
        if given is None:
            raise BadInput(f"{path}: the column '{name}' is in {stated}: say by --frequency-unit whether that is Hz or rad/s")
        return check_unit(given, "frequency", "--frequency-unit")
    return settle(stated or None, given, "--frequency-unit", "frequency", path)


def check_values(omega, storage, loss, path):
    """Is this a curve of a solid?"""
    for what, values, is_allowed, allowed in (
        ("frequency", omega, omega > 0, "above 0"), ("storage modulus", storage, storage > 0, "above 0"),
        ("loss modulus", loss, loss >= 0, "0 or more"),
    ):
        is_bad = ~(np.isfinite(values) & is_allowed)
        if is_bad.any():
            row = int(np.flatnonzero(is_bad)[0])
            shown = "missing" if np.isnan(values[row]) else f"{values[row]:g} in SI units"
            raise BadInput(f"{path}: the {what} in row {row + 1} is {shown}, allowed: {allowed}")
    if len(omega) < FEWEST_ROWS:
        raise BadInput(f"{path}: {len(omega)} row is no curve, allowed: at least {FEWEST_ROWS}")


def young_of_shear(is_shear, poisson_ratio, path):
    """The factor that makes Young's moduli of the moduli, and Poisson's ratio where it was needed."""
    if not is_shear:
        if poisson_ratio is not None:
            raise BadInput(f"{path}: --poisson-ratio is for shear moduli, these are Young's moduli")
        return 1.0, None
    if poisson_ratio is None:
        raise BadInput(f"{path}: these are shear moduli; --poisson-ratio makes Young's moduli of them, 2 (1 + ratio) G")
    if not -1 < poisson_ratio <= 0.5:
        raise BadInput(f"--poisson-ratio: given {poisson_ratio:g}, allowed: above -1, at most 0.5")
    return 2 * (1 + poisson_ratio), poisson_ratio


def temperature_of(comments, given, path):
    """The reference temperature [K] that the file states in a line above the table, or the option gives."""
    stated = None
    found = next((TEMPERATURE.search(line) for line in comments if TEMPERATURE.search(line)), None)
    if found:
        value, unit = float(found[1]), (found[2] or "").strip(",;")
        if unit not in CELSIUS | {"K"}:
            raise BadInput(f"{path}: the reference temperature has the unit '{unit}', allowed: K or \u00b0C")
        stated = value + ZERO_CELSIUS if unit in CELSIUS else value
    if stated is None and given is None:
        raise BadInput(f"{path}: the file does not state the reference temperature: give --reference-temperature in K")
    if stated is not None and given is not None and abs(stated - given) > 1e-9 * stated:
        raise BadInput(f"{path}: the file states the reference temperature {stated:g} K, --reference-temperature says {given:g} K")
    temperature = given if stated is None else stated
    if not temperature > 0 or not np.isfinite(temperature):
        raise BadInput(f"{path}: the reference temperature is {temperature:g} K, allowed: above 0")
    return temperature


def image_of_curve(curve, attributes):
    """The bytes of a file with the curve as the group `master_curve`."""
    with hdf5_image() as (file, get_bytes):
        for key, value in attributes.items():
            file.attrs[key] = value
        group = file.create_group("master_curve")
        group.attrs["long_name"] = "complex Young's modulus, shifted to the reference temperature [K]"
        group.attrs["reference_temperature"] = curve.temperature
        if curve.poisson_ratio is not None:
            group.attrs["poisson_ratio"] = curve.poisson_ratio
        add_axis(group, "omega", curve.omega, "rad/s", "angular frequency")
        add_dataset(group, "storage", curve.storage, "Pa", "storage modulus", ["omega"])
        add_dataset(group, "loss", curve.loss, "Pa", "loss modulus", ["omega"])
    return get_bytes()
