# SPDX-License-Identifier: GPL-3.0-or-later
"""Units in which files have their numbers.

A conversion is one multiplication or division by an exact power of ten, so that the same measurement, written in other units,
gives the same numbers to the last digit wherever the numbers in the file have few digits.
"""

import math
import re

from .problems import BadInput

PREFIXES = {"p": -12, "n": -9, "u": -6, "m": -3, "c": -2, "d": -1, "": 0, "k": 3, "M": 6, "G": 9, "T": 12}
# the micro sign and the Greek letter are two characters
MICRO = str.maketrans({"\u00b5": "u", "\u03bc": "u"})
# exponents of ten that make metres of a length
LENGTHS = {prefix + "m": power for prefix, power in PREFIXES.items() if power <= 3} | {
    "\u00c5": -10, "\u212b": -10, "A": -10, "angstrom": -10, "Angstrom": -10, "micron": -6, "microns": -6}
# exponents of ten that make pascals of a modulus
MODULI = {prefix + "Pa": power for prefix, power in PREFIXES.items() if power >= 0} | {
    "N/m^2": 0, "N/mm^2": 6, "N/m2": 0, "N/mm2": 6, "N/m\u00b2": 0, "N/mm\u00b2": 6}
# 1/s and s^-1 are of neither: both quantities have them
CYCLES = {prefix + "Hz": PREFIXES[prefix] for prefix in ("u", "m", "", "k", "M", "G", "T")}
RADIANS = {"rad/s": 0, "krad/s": 3, "Mrad/s": 6, "rad s-1": 0, "rad s^-1": 0, "rad*s^-1": 0, "rad\u00b7s\u207b\u00b9": 0,
           "rad.s-1": 0}
KINDS = {"length": LENGTHS, "modulus": MODULI, "frequency": CYCLES | RADIANS}
EXAMPLES = {"length": "m, mm, um, nm or angstrom", "modulus": "Pa, kPa, MPa or GPa", "frequency": "Hz or rad/s"}


def exponent_of(unit, kind):
    """The exponent of ten of a unit of this kind; None if it is none."""
    return KINDS[kind].get(unit.strip().translate(MICRO))


def check_unit(unit, kind, where):
    """The unit, if it is known."""
    if exponent_of(unit, kind) is None:
        raise BadInput(f"{where}: the unit '{unit}' is not known for a {kind}; {EXAMPLES[kind]} are")
    return unit.strip().translate(MICRO)


def to_si(values, unit, kind):
    """Values of a known unit in SI units; cycles become radians."""
    exponent = exponent_of(unit, kind)
    scaled = values * 10.0**exponent if exponent >= 0 else values / 10.0**-exponent
    is_cyclic = kind == "frequency" and unit.strip().translate(MICRO) in CYCLES
    return scaled * (2 * math.pi) if is_cyclic else scaled


def unit_in(label):
    """Name and unit of the head of a column, as in `x [um]`, `x (um)`, `x / um` or `x in um`; without one the unit is empty."""
    found = re.fullmatch(r"\s*(.*?)\s*(?:\[([^\]]*)\]|\(([^)]*)\)|/\s*(\S+)|\s+in\s+(\S+))\s*", label)
    if not found:
        return label.strip(), ""
    name, *units = found.groups()
    return name, next(unit for unit in units if unit is not None).strip()


def settle(stated, given, option, kind, path):
    """The unit that a file states or, where it states none, that an option gives."""
    if stated is not None:
        check_unit(stated, kind, path)
        if given is not None and to_si(1.0, check_unit(given, kind, option), kind) != to_si(1.0, stated, kind):
            raise BadInput(f"{path}: the file states the unit {stated}, {option} says {given}")
        return stated
    if given is None:
        raise BadInput(f"{path}: the file does not state the unit of {'its lengths' if kind == 'length' else 'the ' + kind}: "
                       f"give {option}, such as {EXAMPLES[kind]}")
    return check_unit(given, kind, option)
