# SPDX-License-Identifier: GPL-3.0-or-later
"""What Python gives, as the library takes it: numbers in the unit of their variable."""

import numbers

import numpy as np

from .errors import InputError

LARGEST = 2**63


def in_unit(value, unit, name):
    """The value without its unit, and the unit that it has now, None if it says none. Quantities of pint are converted to the unit of
    the variable, arrays of xarray that state another unit are refused."""
    stated = getattr(value, "attrs", {}).get("units") if hasattr(value, "dims") else None
    if stated is not None and unit and str(stated) not in alternatives_of(unit):
        raise InputError(f"{name}: given in {stated}, allowed: {unit}")
    # an array of xarray may have a quantity in it
    value = value.data if hasattr(value, "dims") and hasattr(value, "data") else value
    if hasattr(value, "to") and hasattr(value, "magnitude"):
        return magnitude_of(value, unit, name)
    return value, None if stated is None else str(stated)


def magnitude_of(quantity, unit, name):
    """The magnitude of a quantity of pint in a unit of a variable, and that unit."""
    for one in alternatives_of(unit):
        try:
            return quantity.to("dimensionless" if one in ("1", "-", "") else one).magnitude, one
        except Exception:  # noqa: BLE001, S112: pint has many, and the message says what matters
            continue
    raise InputError(f"{name}: given in {quantity.units}, allowed: {unit or 'no unit'}")


def alternatives_of(unit):
    """The units that a variable may have: `N; N/m for line` is N or N/m, as the case is."""
    return [part.partition(" for ")[0].strip() for part in unit.split(";")]


def numbers_of(value, name):
    """An array of 64-bit numbers, the last dimension of which varies fastest; no copy where it is one."""
    if np.ma.is_masked(value):
        raise InputError(f"{name}: some values are masked, allowed: numbers")
    try:
        values = np.asarray(value)
    except ValueError:
        raise InputError(f"{name}: the rows have different lengths, allowed: an array of numbers") from None
    if values.dtype.kind not in "fiu":
        raise InputError(f"{name}: given an array of {values.dtype}, allowed: numbers")
    return np.require(values, dtype=np.float64, requirements="CA")


def whole_number_of(value, name):
    """A whole number that 64 bits hold."""
    if not -LARGEST <= int(value) < LARGEST:
        raise InputError(f"{name}: given {value}, allowed: a number of 64 bits")
    return int(value)


def number_of(value, name):
    """A number as 64 bits have it."""
    try:
        return float(value)
    except OverflowError:
        raise InputError(f"{name}: given {value}, allowed: a number of 64 bits") from None


def is_logical(value):
    """Is it True or False?"""
    return isinstance(value, (bool, np.bool_))


def is_whole_number(value):
    """Is it a whole number, but for True and False?"""
    return isinstance(value, numbers.Integral) and not is_logical(value)


def is_number(value):
    """Is it a number?"""
    return isinstance(value, numbers.Real) and not is_logical(value)


def single_of(value):
    """What an array of no dimension holds; else the value itself."""
    if isinstance(value, np.ndarray) and value.ndim == 0 and not np.ma.is_masked(value):
        return value[()]
    return value
