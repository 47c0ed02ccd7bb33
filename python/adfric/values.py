# SPDX-License-Identifier: GPL-3.0-or-later
"""What Python gives, as the library takes it: numbers in the unit of their variable."""

import numbers

import numpy as np

from .errors import InputError

LARGEST = 2**63


def in_unit(value, unit, name):
    """The value without its unit, which is that of the variable: quantities of pint are converted, arrays of xarray that state
    another unit are refused."""
    stated = getattr(value, "attrs", {}).get("units") if hasattr(value, "dims") else None
    if stated is not None and unit and str(stated) != unit:
        raise InputError(f"{name}: given in {stated}, allowed: {unit}")
    # an array of xarray may have a quantity in it
    value = value.data if hasattr(value, "dims") and hasattr(value, "data") else value
    if hasattr(value, "to") and hasattr(value, "magnitude"):
        try:
            value = value.to("dimensionless" if unit in ("1", "-", "") else unit).magnitude
        except Exception as problem:
            raise InputError(f"{name}: {problem}") from None
    return value


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
