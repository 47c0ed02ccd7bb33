# SPDX-License-Identifier: GPL-3.0-or-later
"""Names and numbers in words, without the formulas that figures have."""

import re

import numpy as np

from .shared import axis_label, scale_of


def words_of(name, unit=""):
    """A name in words, with its unit."""
    label = re.sub(r"\s*\$[^$]*\$", "", axis_label(name, "")).strip() or name.replace("_", " ")
    return f"{label} ({unit})" if unit else label


def number_of(value, unit, among=None):
    """A number with its unit, in the range of those that it belongs to."""
    factor, unit = scale_of([value] if among is None else among, unit)
    return f"{value * factor:.5g} {unit}".rstrip()


def numbers_of(values, unit):
    """Some numbers with one unit: all of few, the least and the largest of many."""
    values = np.ravel(values)
    factor, unit = scale_of(values[np.isfinite(values)], unit)
    if values.size <= 4:
        return f"{', '.join(f'{value * factor:.5g}' for value in values)} {unit}".rstrip()
    return f"{np.nanmin(values) * factor:.5g} to {np.nanmax(values) * factor:.5g} {unit}".rstrip() + f", {values.size} values"
