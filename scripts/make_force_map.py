# SPDX-License-Identifier: GPL-3.0-or-later
"""Write a map of force curves as an instrument would; make_options/force_map.py says more."""

import sys
import zipfile

import numpy as np

from make_options.force_map import read_command_line

# what the islands and the matrix are: contact modulus [Pa] and work of adhesion [J/m^2]
ISLANDS, MATRIX = (2.4e8, 0.025), (8.0e7, 0.05)
# distance of curves, range of the base in free air, and largest load [m, m, N]
SPACING, FREE, LARGEST_LOAD = 2.0e-7, 2.5e-7, 4.0e-7
HEAD = """Force-Distance Curve
File Format:    3

Date:    Wednesday, January 7, 2026
Time:    10:00:00 AM
Mode:    Mapping
Point:    {point}
X, um:    {x:.6f}
Y, um:    {y:.6f}
Light Lever Gain, mV/nm:    {gain:.6f}
Force Constant, nN/nm:    {spring:.6f}

Extend Z-Sense(nm),Extend T-B(V),Retract Z-Sense(nm),Retract T-B(V)
"""


def make_material(nx, ny, rng):
    """Contact modulus [Pa] and work of adhesion [J/m^2] of each place, shape (ny, nx): islands with soft edges in a matrix."""
    y, x = np.mgrid[:ny, :nx]
    share = np.zeros((ny, nx))
    for _ in range(max(1, nx * ny // 40)):
        distance = np.hypot(x - rng.uniform(0, nx - 1), y - rng.uniform(0, ny - 1))
        share = np.maximum(share, 1 / (1 + np.exp(2.5 * (distance - rng.uniform(1.5, 2.5)))))
    return tuple(soft * (hard / soft) ** share for hard, soft in zip(ISLANDS, MATRIX))


def jkr_curve(radius, modulus, work, spring):
    """Position of the base [m] and load [N] on the branch that holds, from the pull-off on."""
    scale = (np.pi * work * radius**2 / modulus) ** (1 / 3)
    a = scale * np.linspace(0.05, 8, 40001)
    load = 4 * modulus * a**3 / (3 * radius) - np.sqrt(8 * np.pi * work * modulus * a**3)
    base = a**2 / radius - np.sqrt(2 * np.pi * a * work / modulus) + load / spring
    first = int(np.argmin(base))
    return base[first:], load[first:]


def make_curve(radius, modulus, work, spring, samples):
    """Positions of the base [m] and loads [N] of the approach and of the retraction; the surface is at 0."""
    base, load = jkr_curve(radius, modulus, work, spring)
    ramp = np.linspace(-FREE, np.interp(LARGEST_LOAD, load, base), samples)
    # the ball touches at 0 and jumps into contact there; it holds until the branch ends
    approach = np.where(ramp < 0, 0.0, np.interp(ramp, base, load))
    retraction = np.where(ramp < base[0], 0.0, np.interp(ramp, base, load))
    return ramp, approach, ramp[::-1], retraction[::-1]


def write_map(given):
    """Write the file, and return modulus and work of adhesion of each place."""
    rng = np.random.default_rng(given.seed)
    nx, ny = given.curves
    modulus, work = make_material(nx, ny, rng)
    height = 3.0e-8 * np.cumsum(rng.normal(size=(ny, nx)), axis=1) / np.sqrt(nx)
    never, lost = rng.choice(nx * ny, 2, replace=False)
    gain = 1e-6 / given.sensitivity
    with zipfile.ZipFile(given.file, "w", zipfile.ZIP_DEFLATED) as archive:
        for point in range(nx * ny):
            j, i = divmod(point, nx)
            columns = list(make_curve(given.radius, modulus[j, i], work[j, i], given.spring_constant, given.samples))
            for k in (1, 3):
                columns[k] = 0 * columns[k] if point == never else columns[k]
                columns[k] = columns[k] + 5.0e-9 + given.noise * rng.normal(size=given.samples)
                columns[k] = columns[k] / given.spring_constant / given.sensitivity * (np.nan if point == lost else 1)
            # zeros of heights are those of the piezo, and follow the surface
            rows = np.stack([(columns[0] + height[j, i] + 3.0e-6) * 1e9, columns[1], (columns[2] + height[j, i] + 3.0e-6) * 1e9, columns[3]],
                            axis=1)
            head = HEAD.format(point=point + 1, x=i * SPACING * 1e6, y=j * SPACING * 1e6, gain=gain, spring=given.spring_constant)
            text = head + "".join(",".join(f"{value:.6f}" for value in row) + "\n" for row in rows)
            # the same seed makes the same file
            archive.writestr(zipfile.ZipInfo(f"point_{point + 1:04d}.csv", (2026, 1, 7, 10, 0, 0)), text)
    return modulus, work


if __name__ == "__main__":
    write_map(read_command_line(sys.argv[1:]))
