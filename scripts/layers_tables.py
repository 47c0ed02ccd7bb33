# SPDX-License-Identifier: GPL-3.0-or-later
"""Compute the table of docs/validation/thin_samples.md: scripts/tables [PROGRAM]. A round tip on the cells of a thin layer, beside the correction of
E. K. Dimitriadis, F. Horkay, J. Maresca, B. Kachar, R. S. Chadwick, Biophys. J. 82 (2002) 2798, equation 12, for nu = 1/2 and a layer that is
bonded to its base."""

import subprocess
import tempfile
from math import ceil, cosh, pi, sinh, sqrt
from pathlib import Path

import h5py
import numpy as np
from table_tools import PROGRAM, head, row

SIZES = (0.2, 0.4, 0.7, 1.0, 1.5, 2.0, 3.0, 5.0)
RADIUS, APPROACH, YOUNG = 5.0e-6, 1.0e-7, 1.0e3
COARSE, FINE, SPACING = 16, 32, 8.0


def series(chi):
    """Load over that of a half-space."""
    return 1 + 1.133 * chi + 1.283 * chi**2 + 0.769 * chi**3 + 0.0975 * chi**4


def factor(q):
    """Compliance of the bonded layer with nu = 1/2 under a wave over that of a half-space, q = k H."""
    if q < 1e-3:
        return 2 * q**3 / 3
    return (2 * sinh(2 * q) - 4 * q) / (2 * cosh(2 * q) + 4 * q * q + 2)


def first_coefficient(end=22.0, count=100000):
    """That of chi, from the surface that the base lifts below a small contact."""
    step = end / count
    return 2 / pi * step * sum(1 - factor((i + 0.5) * step) for i in range(count))


def solve(chi, poisson, cells):
    """Load over that of a half-space, and radius of contact over thickness, with so many cells in the radius sqrt(R d)."""
    width = sqrt(RADIUS * APPROACH)
    thickness = width / chi
    # neighbours are radii and thicknesses away
    count = 16 * ceil(cells * (4.0 + SPACING / chi) / 16)
    length = count * width / cells
    x = (np.arange(count) + 0.5) * length / count - length / 2
    with tempfile.TemporaryDirectory() as folder:
        with h5py.File(Path(folder, "tip.h5"), "w") as file:
            file["z"] = -(x[:, None] ** 2 + x**2) / (2 * RADIUS)
        source, target = Path(folder, "input.nml"), Path(folder, "results.h5")
        source.write_text(f"&surface kind = 'heights', heights = '{folder}/tip.h5:/z', length_x = {length!r}, length_y = {length!r} /\n"
                          f"&solid young_modulus = {YOUNG}, poisson_ratio = {poisson}, extent = 'layer', thickness = {thickness!r}, base = 'bonded' /\n"
                          f"&operating approach = {APPROACH} /\n")
        subprocess.run([PROGRAM, "run", source, "--output", target, "--quiet"], check=True)
        with h5py.File(target) as file:
            load = file["mean_pressure"][()] * length**2
            radius = sqrt(file["contact_fraction"][()] / np.pi) * length
    hertz = 4 / 3 * YOUNG / (1 - poisson**2) * sqrt(RADIUS) * APPROACH**1.5
    return load / hertz, radius / thickness


def main():
    head("Load of a round tip on a bonded layer of nu = 1/2, over that of a half-space", "sqrt(R d)/H", "contact radius/H", "cells", "finer cells",
         "series", "series over cells", "error of E", "nu = 0.45")
    for chi in SIZES:
        (coarse, _), (fine, radius), (other, _) = solve(chi, 0.5, COARSE), solve(chi, 0.5, FINE), solve(chi, 0.45, COARSE)
        row(f"{chi:g}", f"{radius:.3g}", f"{coarse:.5g}", f"{fine:.5g}", f"{series(chi):.5g}", f"{series(chi) / fine:.4f}",
            f"{100 * (fine / series(chi) - 1):+.1f} %", f"{other:.5g}")

    head("Coefficients for small sizes", "coefficient", "series", "from the wave factor")
    row("first", "1.133", f"{first_coefficient():.4f}")
    row("second", "1.283", f"{7 / 6 * first_coefficient() ** 2:.4f}")


if __name__ == "__main__":
    main()
