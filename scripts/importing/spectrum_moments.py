# SPDX-License-Identifier: GPL-3.0-or-later
"""Moments of a tabulated spectrum, as the program has them (src/shape/height_spectrum.f90), and their errors."""

import numpy as np

# change of ln C by which the moments are differentiated
CHANGE = 1e-4
# units of the numbers, and what they are
MEANINGS = {"root_mean_square_height": ("m", "root mean square of the heights"),
            "root_mean_square_slope": ("1", "root mean square of the gradient"),
            "root_mean_square_curvature": ("1/m", "root mean square of half the Laplacian"),
            "nayak_parameter": ("1", "Nayak's parameter m0 m4/m2^2")}


def moment(n, q, density):
    """M_n = 2 pi int C q^(n+1) dq of powers of q between the rows of a table."""
    x = np.diff(np.log(q))
    y = (n + 2) * x + np.diff(np.log(density))
    return float(2 * np.pi * np.sum(density[:-1] * q[:-1] ** (n + 2) * x * np.where(np.abs(y) > 1e-12, np.expm1(y) / np.where(y == 0, 1, y), 1)))


def numbers_of(q, density):
    """Height, slope, curvature and Nayak's parameter by their names."""
    m0, m2, m4 = (moment(n, q, density) for n in (0, 2, 4))
    return {"root_mean_square_height": np.sqrt(m0), "root_mean_square_slope": np.sqrt(m2),
            "root_mean_square_curvature": np.sqrt(m4) / 2, "nayak_parameter": 1.5 * (m0 / m2) * (m4 / m2)}


def moments_of(joined):
    """The numbers, each with its standard error, by their names."""
    q, density = joined.wave_numbers, joined.density
    values = numbers_of(q, density)
    slopes = {name: np.empty(len(q)) for name in values}
    for k in range(len(q)):
        change = np.zeros(len(q))
        change[k] = CHANGE
        above, below = (numbers_of(q, density * np.exp(sign * change)) for sign in (1, -1))
        for name in values:
            slopes[name][k] = np.log(above[name] / below[name]) / (2 * CHANGE)
    return {name: (float(value), float(value * np.sqrt(slopes[name] @ joined.covariance @ slopes[name]))) for name, value in values.items()}
