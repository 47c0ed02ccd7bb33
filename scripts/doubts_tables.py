# SPDX-License-Identifier: GPL-3.0-or-later
"""Compute the table of docs/reference/doubts.md: scripts/tables [PROGRAM]. Each error is a closed form of its source."""

from math import atanh, cosh, hypot, log, pi, sinh

from table_tools import head, row

SIZES = (0.1, 0.2, 0.3, 0.5, 0.7)
LAYERS = (0.1, 0.15, 0.2, 0.25, 0.3, 0.5)


def sphere_errors(a):
    """By how much the exact profile of a sphere needs more approach and load than the paraboloid, at a contact of a radii."""
    approach, load = a * atanh(a), (1 + a * a) / 2 * log((1 + a) / (1 - a)) - a
    return approach / a**2 - 1, load / (4 * a**3 / 3) - 1


def cone_error(slope, poisson):
    """By how much a cone is stiffer than by small slopes (J. C. Hay, A. Bolshakov, G. M. Pharr, J. Mater. Res. 14 (1999) 2296)."""
    share = slope * (1 - 2 * poisson) / (4 * (1 - poisson))
    return pi * (pi / 4 + 0.15483073 * share) / (pi / 2 - 0.83119312 * share) ** 2 - 1


def column_error(thickness):
    """By how much a layer on a frictionless base is stiffer than its columns for waves of length 1."""
    x = 2 * pi * thickness
    return (x / 2) * (sinh(2 * x) + 2 * x) / (cosh(2 * x) - 1) - 1


def show(number):
    return f"{100 * number:.1f} %"


def main():
    head("Errors of small slopes", "contact over R, or slope", "approach of a sphere", "its load", "cone, nu = 0", "cone, nu = 0.3",
         "length of surface")
    for size in SIZES:
        row(f"{size:g}", *map(show, (*sphere_errors(size), cone_error(size, 0.0), cone_error(size, 0.3), hypot(1, size) - 1)))
    head("Errors of columns", "thickness over wave", "stiffness")
    for thickness in LAYERS:
        row(f"{thickness:g}", show(column_error(thickness)))


if __name__ == "__main__":
    main()
