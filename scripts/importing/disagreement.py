# SPDX-License-Identifier: GPL-3.0-or-later
"""Do measurements of one surface say the same of the waves that they have in common?

Each has a spectrum of its own. Over the waves that two of them have, the mean of ln C_i - ln C_j has a standard error. The level of a
measurement is the median of these means over all others and itself, so that the majority has levels near 0, whichever one is off.
"""

import itertools
from dataclasses import dataclass

import numpy as np

from .joined_spectrum import join
from .problems import BadInput, NoSpectrum

# a measurement is pointed out where it is off by so many errors, and by so large a part
ERRORS, PART = 4.0, 0.2
# two are refused where they are off by so many errors, and by so large a factor of the density
MOST_ERRORS, MOST_FACTOR = 10.0, 10.0
# wave numbers at which two are compared
POINTS = 12


@dataclass
class Pair:
    """Two measurements, by their indices, and the mean of ln C_i - ln C_j with its error."""

    i: int
    j: int
    mean: float
    error: float

    def is_off(self, errors, factor):
        """Are they off by more than so many errors and this factor?"""
        return abs(self.mean) > max(errors * self.error, np.log(factor))


def compare(periodograms):
    """The pairs that have waves in common."""
    own = []
    for each in periodograms:
        try:
            own.append(join([each]))
        except NoSpectrum:
            # too few waves for a spectrum of its own
            own.append(None)
    pairs = []
    for i, j in itertools.combinations(range(len(own)), 2):
        first, last = (choose(periodograms[k].ends[end] for k in (i, j)) for end, choose in ((0, max), (1, min)))
        if own[i] and own[j] and last > first * (1 + 1e-6):
            pairs.append(Pair(i, j, *difference(own[i], own[j], np.linspace(np.log(first), np.log(last), POINTS))))
    return pairs


def difference(one, other, points):
    """Mean of the logarithm of one density over the other at points ln q, each by its error, and the error of the mean."""
    value, covariance = 0.0, 0.0
    for sign, each in ((1, one), (-1, other)):
        rows = np.array([np.interp(points, np.log(each.wave_numbers), unit) for unit in np.eye(len(each.wave_numbers))]).T
        value, covariance = value + sign * rows @ np.log(each.density), covariance + rows @ each.covariance @ rows.T
    weight = 1 / np.diag(covariance)
    weight /= weight.sum()
    return float(weight @ value), float(np.sqrt(weight @ covariance @ weight))


def levels_of(pairs, n):
    """The median of ln of each density over those of all that share waves with it, itself among them."""
    found = [[0.0] for _ in range(n)]
    for pair in pairs:
        found[pair.i].append(pair.mean)
        found[pair.j].append(-pair.mean)
    return [float(np.median(each)) for each in found]


def check_agreement(periodograms):
    """Refuse measurements that contradict each other; give a line for each one that is far from the others."""
    pairs = compare(periodograms)
    levels = levels_of(pairs, len(periodograms))
    names = [each.name for each in periodograms]
    wrong = [pair for pair in pairs if pair.is_off(MOST_ERRORS, MOST_FACTOR)]
    if wrong:
        _, text = contradiction(max(wrong, key=lambda each: abs(each.mean)), levels, names)
        raise BadInput(f"{text}: are the units right? --leave-out NAME takes one out")
    remarks = {}
    for pair in sorted(pairs, key=lambda each: -abs(each.mean) / each.error):
        if pair.is_off(ERRORS, 1 + PART):
            i, text = contradiction(pair, levels, names)
            remarks.setdefault(i, f"{text}: are units, tilt and reliable range right?")
    return [remarks[i] for i in sorted(remarks)]


def contradiction(pair, levels, names):
    """Index of the one of two measurements that is further from all others, and what to say of it."""
    i, j = (pair.i, pair.j) if abs(levels[pair.i]) >= abs(levels[pair.j]) else (pair.j, pair.i)
    factor = np.exp(pair.mean if i == pair.i else -pair.mean)
    is_open = np.isclose(abs(levels[i]), abs(levels[j]))
    return i, (f"{names[i]}: its spectrum is {factor:.2g} times that of {names[j]} at the same waves, "
               + ("and nothing says which one is wrong" if is_open else "and it is further from the median of all"))
