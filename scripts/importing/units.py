# SPDX-License-Identifier: GPL-3.0-or-later
"""Units in which files have their numbers.

A conversion is one multiplication or division by an exact power of ten, so that the same measurement, written in other units,
gives the same numbers to the last digit wherever the numbers in the file have few digits.
"""

import math
import re

from .problems import BadInput
from .quantities import read_unit

MICRO = str.maketrans({"\u00b5": "u", "\u03bc": "u"})
# units of kinds that are told apart by more than their powers; what is there goes before the table of all units
ANGSTROM = {"A": -10}
# 1/s and s^-1 are of neither: both quantities have them
CYCLES = {prefix + "Hz": power for prefix, power in (("u", -6), ("m", -3), ("", 0), ("k", 3), ("M", 6), ("G", 9), ("T", 12))}
RADIANS = {"rad/s": 0, "krad/s": 3, "Mrad/s": 6, "rad s-1": 0, "rad s^-1": 0, "rad*s^-1": 0, "rad\u00b7s\u207b\u00b9": 0,
           "rad.s-1": 0}
# SI units of kinds of quantities, and units as examples
KINDS = {"length": ("m", "m, mm, um, nm or angstrom"), "modulus": ("Pa", "Pa, kPa, MPa or GPa"),
         "frequency": ("rad/s", "Hz or rad/s"), "force": ("N", "N, uN, nN or pN"), "voltage": ("V", "V or mV"),
         "spring constant": ("N/m", "N/m, mN/m or nN/nm"), "sensitivity": ("m/V", "m/V or nm/V"), "time": ("s", "s or ms"),
         "temperature": ("K", "K")}
# a number and a unit behind it, in the head of a file
QUANTITY = re.compile(r"([+-]?(?:\d+[.,]?\d*|[.,]\d+)(?:[eE][+-]?\d+)?)\s*(\S.*)?")


def exponent_of(unit, kind):
    """The exponent of ten of a unit of this kind; None if it is none."""
    if kind == "frequency":
        return (CYCLES | RADIANS).get(unit.strip().translate(MICRO))
    if kind == "length" and unit.strip() in ANGSTROM:
        return ANGSTROM[unit.strip()]
    found = read_unit(unit)
    return found.exponent if found and found.powers == read_unit(KINDS[kind][0]).powers else None


def check_unit(unit, kind, where):
    """The unit, if it is known."""
    if exponent_of(unit, kind) is None:
        raise BadInput(f"{where}: the unit '{unit}' is not known for a {kind}; {KINDS[kind][1]} are")
    return unit.strip().translate(MICRO)


def to_si(values, unit, kind):
    """Values of a known unit in SI units; cycles become radians."""
    exponent = exponent_of(unit, kind)
    scaled = values * 10.0**exponent if exponent >= 0 else values / 10.0**-exponent
    is_cyclic = kind == "frequency" and unit.strip().translate(MICRO) in CYCLES
    return scaled * (2 * math.pi) if is_cyclic else scaled


def number_with_unit(text, kind):
    """A number and its unit, empty where there is none, as in `2,0 um`; None where the text is no such."""
    found = QUANTITY.fullmatch(text.strip())
    if not found or found[2] and exponent_of(found[2], kind) is None:
        return None
    return float(found[1].replace(",", ".")), (found[2] or "").strip()


def settle(stated, given, option, kind, path):
    """The unit that a file states or, where it states none, that an option gives."""
    if stated is not None:
        check_unit(stated, kind, path)
        if given is not None and to_si(1.0, check_unit(given, kind, option), kind) != to_si(1.0, stated, kind):
            raise BadInput(f"{path}: the file states the unit {stated}, {option} says {given}")
        return stated
    if given is None:
        raise BadInput(f"{path}: the file does not state the unit of {'its lengths' if kind == 'length' else 'the ' + kind}: "
                       f"give {option}, such as {KINDS[kind][1]}")
    return check_unit(given, kind, option)
