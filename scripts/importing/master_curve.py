# SPDX-License-Identifier: GPL-3.0-or-later
"""Master curves: storage and loss modulus over the frequency at a reference temperature."""

import re
from dataclasses import dataclass

import numpy as np

from .heads import plain, split_head
from .problems import BadInput
from .tables import read_table
from .units import CYCLES, check_unit, settle, to_si
from .writing import add_axis, add_dataset, hdf5_image

# heads of columns, without their units, in small letters
FREQUENCY = {"frequency", "freq", "freq.", "f", "omega", "w", "\u03c9", "angular frequency",
             "reduced frequency", "reduced angular frequency"}
ANGULAR = {"omega", "w", "\u03c9", "angular frequency", "reduced angular frequency"}
STORAGE = {"storage", "storage modulus"}
LOSS = {"loss", "loss modulus"}
# E' and E'', G' and G'', with straight, curly and prime marks
MARKS = str.maketrans({"\u2032": "'", "\u2019": "'", "\u00b4": "'", "\u2033": "''", "\u201d": "''", '"': "''"})
TEMPERATURE = re.compile(r"reference[ _]temperature\s*[:=]?\s*(-?[0-9.]+(?:[eE][-+]?\d+)?)\s*(\S+)?", re.IGNORECASE)
# what the columns are called in messages, and the loss tangent and logarithms in heads
COLUMNS = {"frequency": "frequency", "storage": "storage modulus", "loss": "loss modulus", "tan delta": "loss tangent"}
TANGENT = re.compile(r"tan ?\(?(?:delta|d|\u03b4)\)?|loss (?:factor|tangent)|damping factor")
LOGARITHM = re.compile(r"(?:log(?: ?10)?|lg)(?: |(?=\())(.*)")
LOGARITHM_OF = re.compile(r"(?:log(?:_?10)?|lg)\s*\((.*)\)", re.IGNORECASE)
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


@dataclass
class Column:
    """A column by its head: name, unit, and whether its numbers are decimal logarithms."""

    place: int
    name: str
    unit: str
    is_log: bool


def read_master_curve(path, given):
    """Read a master curve from a table with heads."""
    table = read_table(path)
    columns, is_shear = find_columns(table, given, path)
    logs = getattr(given, "log10", None) or []
    values = {}
    for what, column in columns.items():
        unit = None
        if what == "frequency":
            unit = unit_of_frequency(column.name, column.unit, given.frequency_unit, path)
        elif what != "tan delta":
            unit = settle(column.unit or None, given.modulus_unit, "--modulus-unit", "modulus", path)
        numbers = table.column(column.place)
        if column.is_log or what in logs:
            with np.errstate(over="ignore"):
                numbers = 10.0**numbers
        values[what] = numbers if unit is None else to_si(numbers, unit, "frequency" if what == "frequency" else "modulus")
    if "tan delta" in values:
        check_values(path, {"loss tangent": (values["tan delta"], 0)})
        values["loss"] = values.pop("tan delta") * values["storage"]
    omega, moduli = values["frequency"], [values["storage"], values["loss"]]
    check_values(path, {"frequency": (omega, None), "storage modulus": (moduli[0], None), "loss modulus": (moduli[1], 0)})
    order = np.argsort(omega)
    if not (np.diff(omega[order]) > 0).all():
        raise BadInput(f"{path}: a frequency occurs twice")
    factor, poisson_ratio = young_of_shear(is_shear, given.poisson_ratio, path)
    return MasterCurve(omega[order], factor * moduli[0][order], factor * moduli[1][order],
                       temperature_of(table.comments, given.reference_temperature, path), poisson_ratio)


def columns_of(table):
    """All columns by their heads."""
    columns = []
    for place, head in enumerate(table.heads):
        text = plain(head.text.translate(MARKS))
        if TANGENT.fullmatch(text):
            columns.append(Column(place, "tan delta", "", False))
            continue
        whole = LOGARITHM_OF.fullmatch(head.text)
        inner = split_head(whole[1]) if whole else head
        name = plain(inner.name.translate(MARKS))
        found = LOGARITHM.fullmatch(name)
        unit = inner.unit if whole and inner.unit else "" if whole and head.unit == whole[1].strip() else head.unit
        columns.append(Column(place, (found[1] if found else name).strip("() "), unit, bool(whole or found)))
    return columns


def find_columns(table, given, path):
    """The columns of frequency, storage, and loss or tan delta, and whether the moduli are those of shear."""
    columns = columns_of(table)
    named = {what: getattr(given, f"{what.replace(' ', '_')}_column", None) for what in COLUMNS}
    named = {what: columns[table.find(name)] for what, name in named.items() if name is not None}
    names = {column.name for column in named.values()} or {column.name for column in columns}
    shear = {"g'", "g''"} & names
    if shear and {"e'", "e''"} & names:
        raise BadInput(f"{path}: the table has both E and G moduli")
    letter = "g" if shear or any("shear" in name for name in names) else "e"
    known = {"frequency": FREQUENCY, "storage": {letter + "'"} | STORAGE | {"shear " + name for name in STORAGE},
             "loss": {letter + "''"} | LOSS | {"shear " + name for name in LOSS}, "tan delta": {"tan delta"}}
    found = {}
    for what, words in known.items():
        fits = [named[what]] if what in named else [column for column in columns if column.name in words]
        if len(fits) > 1:
            raise BadInput(f"{path}: more than one column of the {COLUMNS[what]}; "
                           f"--{what.replace(' ', '-')}-column chooses one: {', '.join(table.heads[one.place].text for one in fits)}")
        if fits:
            found[what] = fits[0]
            if what != "tan delta" and table.heads[fits[0].place].flaw:
                table.unit(fits[0].place)
    if "loss" in found and "tan delta" not in named:
        found.pop("tan delta", None)
    elif "tan delta" in found:
        found.pop("loss", None)
    for what in ("frequency", "storage", "loss"):
        if what not in found and not (what == "loss" and "tan delta" in found):
            raise BadInput(f"{path}: no column of the {COLUMNS[what]}; heads such as frequency [Hz], E' [MPa], E'' [MPa] or tan delta "
                           f"name the columns, or --{what}-column does")
    return found, letter == "g"


def unit_of_frequency(name, stated, given, path):
    """Unit of the frequency: cycles and radians are told apart by it alone."""
    if name in ANGULAR and stated in CYCLES:
        if given is None:
            raise BadInput(f"{path}: the column '{name}' is in {stated}: say by --frequency-unit whether that is Hz or rad/s")
        return check_unit(given, "frequency", "--frequency-unit")
    return settle(stated or None, given, "--frequency-unit", "frequency", path)


def check_values(path, values):
    """Is this a curve of a solid? A number beside the values is the least one allowed; without it they are above 0."""
    for what, (numbers, least) in values.items():
        is_bad = ~(np.isfinite(numbers) & (numbers > 0 if least is None else numbers >= least))
        if is_bad.any():
            row = int(np.flatnonzero(is_bad)[0])
            shown = "missing" if np.isnan(numbers[row]) else f"{numbers[row]:g}" + (" in SI units" if what != "loss tangent" else "")
            raise BadInput(f"{path}: the {what} in row {row + 1} is {shown}, allowed: {'above 0' if least is None else '0 or more'}")
        if len(numbers) < FEWEST_ROWS:
            raise BadInput(f"{path}: {len(numbers)} row is no curve, allowed: at least {FEWEST_ROWS}")


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
