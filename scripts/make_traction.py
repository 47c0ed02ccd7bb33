# SPDX-License-Identifier: GPL-3.0-or-later
"""Write the tractions of a cylinder in partial slip (Cattaneo, Mindlin; K. L. Johnson, Contact Mechanics, 1985, 7.2) as samples."""

import sys

import h5py
import numpy as np

from make_options.traction import read_command_line


def half_circle(positions, half_width):
    """sqrt(1 - x^2/a^2), and 0 beside the strip."""
    return np.sqrt(np.maximum(0, 1 - (positions / half_width) ** 2))


def make_tractions(half_width, peak_pressure, friction, load_ratio, samples):
    """Positions [m], pressures and shear tractions [Pa].

    Samples are dense at the ends of the strip, |x| = a, and of the part that sticks, |x| = c with c^2 = a^2 (1 - Q/(f P)).
    """
    stuck = half_width * np.sqrt(1 - load_ratio)
    share = 0.5 - 0.5 * np.cos(np.pi * np.arange(samples) / (samples - 1))
    ends = [-half_width, -stuck, stuck, half_width]
    positions = np.unique(np.concatenate([a + (b - a) * share for a, b in zip(ends, ends[1:]) if b > a]))
    pressures = peak_pressure * half_circle(positions, half_width)
    shear = friction * pressures
    if stuck > 0:
        shear = shear - friction * peak_pressure * (stuck / half_width) * half_circle(positions, stuck)
    return positions, pressures, shear


def main():
    """Read the options and write the file."""
    given = read_command_line(sys.argv[1:])
    values = make_tractions(given.half_width, given.peak_pressure, given.friction, given.load_ratio, given.samples)
    with h5py.File(given.file, "w") as file:
        for name, unit, data in zip(("positions", "pressures", "shear_tractions"), ("m", "Pa", "Pa"), values):
            file.create_dataset(name, data=data).attrs["units"] = unit


if __name__ == "__main__":
    main()
