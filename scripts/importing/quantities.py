# SPDX-License-Identifier: GPL-3.0-or-later
"""Units as people write them: `nm`, `MPa`, `N/m^2`, `mJ m-2`; the table and the rules are those of src/base/units.f90, with volts besides."""

import re
from dataclasses import dataclass, field

PREFIXES = {"Y": 24, "Z": 21, "E": 18, "P": 15, "T": 12, "G": 9, "M": 6, "k": 3, "h": 2, "da": 1, "d": -1, "c": -2, "m": -3, "u": -6,
            "n": -9, "p": -12, "f": -15, "a": -18, "z": -21, "y": -24}
LONG_PREFIXES = {"tera": 12, "giga": 9, "mega": 6, "kilo": 3, "hecto": 2, "deca": 1, "deci": -1, "centi": -2, "milli": -3,
                 "micro": -6, "nano": -9, "pico": -12, "femto": -15}
# names, the exponent of ten, powers of m, kg, s, K and A, and whether a prefix may stand before it
TABLE = (
    ("m metre metres meter meters", 0, {"m": 1}, True), ("micron microns", -6, {"m": 1}, False),
    ("angstrom angstroms Angstrom Angstroms", -10, {"m": 1}, False), ("g gram grams", -3, {"kg": 1}, True),
    ("s second seconds", 0, {"s": 1}, True), ("K kelvin kelvins", 0, {"K": 1}, True), ("Hz hertz", 0, {"s": -1}, True),
    ("N newton newtons", 0, {"m": 1, "kg": 1, "s": -2}, True), ("Pa pascal pascals", 0, {"m": -1, "kg": 1, "s": -2}, True),
    ("bar bars", 5, {"m": -1, "kg": 1, "s": -2}, True), ("J joule joules", 0, {"m": 2, "kg": 1, "s": -2}, True),
    ("W watt watts", 0, {"m": 2, "kg": 1, "s": -3}, True), ("rad radian radians", 0, {}, False),
    ("V volt volts", 0, {"m": 2, "kg": 1, "s": -3, "A": -1}, True), ("A ampere amperes", 0, {"A": 1}, True),
)
# micro signs, angstroms, points and powers beyond the English alphabet
SIGNS = {"\u00b5": "u", "\u03bc": "u", "A\u030a": "angstrom", "\u00c5": "angstrom", "\u212b": "angstrom", "\u00b7": "*",
         "\u22c5": "*", "\u00b2": "2", "\u00b3": "3", "\u00b9": "1", "\u207b": "-"}
# a power of ten up to this one is exact
LARGEST_EXACT = 22
FACTOR = re.compile(r"(?P<name>[^ *./^+\-0-9]+)(?:(?:\*\*|\^)(?P<power>[+-]?\d)|(?P<bare>[+-]?\d))?|(?P<pure>[1-])")
OPERATOR = re.compile(r" *(?P<sign>[*./])? *")


@dataclass
class Unit:
    """A unit: a power of ten of SI units, and the powers of these."""

    exponent: int = 0
    powers: dict = field(default_factory=dict)


def read_unit(text):
    """The unit that a text means; None where it is not known."""
    for sign, meaning in SIGNS.items():
        text = text.replace(sign, meaning)
    text, unit, position, direction = text.strip(), Unit(), 0, 1
    while True:
        found = FACTOR.match(text, position)
        factor = found and (Unit() if found["pure"] else look_up(found["name"]))
        if not factor:
            return None
        power = direction * int(found["power"] or found["bare"] or 1)
        unit.exponent += power * factor.exponent
        for name, times in factor.powers.items():
            unit.powers[name] = unit.powers.get(name, 0) + power * times
        position = found.end()
        if position == len(text):
            break
        step = OPERATOR.match(text, position)
        if step.end() == position:
            return None
        direction, position = -1 if step["sign"] == "/" else 1, step.end()
    unit.powers = {name: power for name, power in unit.powers.items() if power}
    return unit if abs(unit.exponent) <= LARGEST_EXACT else None


def look_up(name):
    """A unit of the table, with a prefix or without; None where there is none."""
    for names, exponent, powers, _ in TABLE:
        if name in names.split():
            return Unit(exponent, powers)
    # nm and nanometre, but not nmetre and nanom
    for prefixes, is_long in ((PREFIXES, False), (LONG_PREFIXES, True)):
        for prefix, power in prefixes.items():
            if not name.startswith(prefix):
                continue
            symbol = name[len(prefix):]
            for names, exponent, powers, has_prefixes in TABLE:
                if has_prefixes and symbol in names.split() and (len(symbol) > 3) == is_long:
                    return Unit(exponent + power, powers)
    return None


def is_like(one, other):
    """Are two texts known units of the same size?"""
    one, other = read_unit(one), read_unit(other)
    return one is not None and one == other
