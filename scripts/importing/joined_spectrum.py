# SPDX-License-Identifier: GPL-3.0-or-later
"""One isotropic spectrum C(q) of a surface from periodograms of maps and lines of any number of instruments.

Unknown are logarithms of C at wave numbers in equal steps of ln q; between them C is a power of q, as `&power_spectrum` has it. A bin
of a map has the mean of C over its waves, one of a line the mean of

    C1(q) = 2 int_0^inf C(sqrt(q^2 + y^2)) dy,

where C goes on beyond the last wave number with the slope that it has over the last half of a decade. A mean P of n_i independent
ordinates has the gamma distribution of mean m and shape n_i (Whittle's likelihood). So the spectrum is the least of

    sum n_i (P_i/m_i + ln m_i) + (1/2) int (d^2 ln C/d(ln q)^2)^2 d(ln q)/k^2 .

The second part says that slopes of ln C change by about 3 over a decade; it joins ranges without data, and matters little else.

A window w makes of C its mean with the power |W|^2 as weights. To second order that is C + (B/2) C'' of a line, or (B/2) times the
Laplacian of a map, with the mean square B of a wave number in |W|^2 along one axis. This is subtracted.

A table is a density over the whole plane, a period has a lattice of waves. Each stands for an equal area. So those of the first ring
stand for an annulus that begins before them. One more row, at its begin, gives the annulus the variance of the ring.
"""

from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq

from .periodogram import PER_DECADE
from .problems import NoSpectrum
from .spectrum_moments import moment

# by how much the slope of ln C over ln q may change, squared, over an interval 1 of ln q
CHANGE = 3.0**2 / np.log(10)
# the slope beyond the last wave number is that over so large a factor before it, and at most the one of an exponent H = 0
BEFORE_END, STEEP = np.sqrt(10), -2.0
# the corner at STEEP is rounded over so large a part of the slope, so that the likelihood has a derivative
ROUND = 0.03
# factor up to which C goes on, and nodes of the integral between two wave numbers
BEYOND, NODES = 1e4, 6
# waves that stand for a bin of a line
OF_LINE = 4
# most iterations, and the change of ln C at which they end
MOST_STEPS, SMALL = 200, 1e-11
# steps that are smaller are taken whole
WHOLE = 1e-3
# fewest bins of a spectrum
FEWEST = 3
# ln of the largest factor from the first wave of a period to the row before it, and the change by which that row is differentiated
LARGEST, CHANGE_OF_ROW = np.log(1e3), 1e-4


@dataclass
class Joined:
    """A spectrum."""

    # wave numbers [rad/m] and densities of the variance [m^4]; shape (n)
    wave_numbers: np.ndarray
    density: np.ndarray
    # covariance of ln C; shape (n, n)
    covariance: np.ndarray
    # mean square of what is left over, in the errors of Gaussian surfaces
    scatter: float
    # of each measurement: densities that its bins have by the spectrum and its window, mean of the measured over these, and its error
    models: list
    ratios: list
    # the longest wave that was measured [m]; the table of a period begins before it
    longest: float

    @property
    def error(self):
        """Standard error of the density [m^4]."""
        return self.density * np.sqrt(np.diag(self.covariance))


def join(measurements):
    """The spectrum of one or several periodograms."""
    first, last = min(each.ends[0] for each in measurements), max(each.ends[1] for each in measurements)
    if sum(len(each.density) for each in measurements) < FEWEST:
        raise NoSpectrum("too few waves")
    n = max(2, round(PER_DECADE * np.log10(last / first))) + 1
    x = np.linspace(np.log(first), np.log(last), n)
    rows = [row_of(each, x) for each in measurements]
    data = np.log(np.concatenate([each.density for each in measurements]))
    weight = np.concatenate([each.weight for each in measurements])
    prior = roughness(x)
    start = beginning(measurements, x)
    theta = descend(start, rows, data, weight, prior)
    model, slope = evaluate(rows, theta)
    information, belief = slope.T @ (weight[:, None] * slope), prior.T @ prior
    free = max(1.0, len(data) - np.trace(np.linalg.solve(information + belief, information)))
    scatter = np.sum(weight * np.expm1(data - model) ** 2) / free
    covariance = np.linalg.inv(information / max(1.0, scatter) + belief)
    # what windows mix in is taken out to first order, and half of it remains as a doubt common to all rows
    mixed = np.linalg.solve(information + belief, slope.T @ (weight * leakage(measurements, model)))
    theta, covariance = theta - mixed, covariance + np.outer(mixed, mixed) / 4
    ends = np.cumsum([len(each.density) for each in measurements])[:-1]
    models = np.split(np.exp(model), ends)
    ratios = [ratio_of(each, own) for each, own in zip(measurements, models)]
    rings = [each.ring for each in measurements if each.ring and each.ends[0] == first]
    if rings:
        ring = min(rings, key=lambda each: (each.begin, each.end))
        x, theta, covariance = with_ring(ring, x, theta, covariance)
    return Joined(np.exp(x), np.exp(theta), covariance, scatter, models, ratios, 2 * np.pi / first)


def leakage(measurements, model):
    """How much more than the spectrum the density behind a window is, over the spectrum: half the Laplacian times the blur."""
    parts, begin = [], 0
    for each in measurements:
        own, begin = model[begin:begin + len(each.density)], begin + len(each.density)
        middle = np.sum(each.shares * np.log(each.waves), axis=1)
        s = np.gradient(own, middle) if len(own) > 1 else np.zeros(1)
        parts.append(each.blur / 2 * np.exp(-2 * middle) * (s**2 if each.is_map else s * (s - 1)))
    return np.concatenate(parts)


def with_ring(ring, x, theta, covariance):
    """The table with a row where the annulus of the first ring begins."""
    begin, end = np.log(ring.begin), min(np.log(ring.end), x[-1])
    points = np.concatenate([x[x < end - 1e-9], [end]])

    def first_row(theta):
        """ln C there, so that the annulus has the variance of the ring."""
        behind = moment(0, np.exp(points), np.exp(np.interp(points, x, theta))) if end > x[0] else 0.0
        before = ring.cell * np.exp(np.interp(np.log(ring.waves), x, theta)).sum() - behind

        def excess(rise):
            return moment(0, np.exp([begin, x[0]]), np.exp([theta[0] + rise, theta[0]])) - before

        if excess(-LARGEST) > 0 or excess(LARGEST) < 0:
            return theta[0] + LARGEST * (-1 if excess(-LARGEST) > 0 else 1)
        return theta[0] + brentq(excess, -LARGEST, LARGEST, xtol=1e-13)

    step = CHANGE_OF_ROW * np.eye(len(x))
    # the rows behind the annulus do not matter
    slope = [(first_row(theta + each) - first_row(theta - each)) / (2 * CHANGE_OF_ROW) for each in step[:len(points) + 1]]
    change = np.vstack([np.append(slope, np.zeros(len(x) - len(slope))), np.eye(len(x))])
    return np.append(begin, x), np.append(first_row(theta), theta), change @ covariance @ change.T


def ratio_of(each, model):
    """Mean of measured over joined density of a measurement, and its error if the surface is Gaussian."""
    total = each.weight.sum()
    return float(np.sum(each.weight * each.density / model) / total), float(1 / np.sqrt(total))


def roughness(x):
    """Matrix whose product with the unknowns has half the square of the second part: changes of slopes over what they may be."""
    return np.diff(np.eye(len(x)), 2, axis=0) / np.sqrt(CHANGE * (x[1] - x[0]) ** 3)


def beginning(measurements, x):
    """Logarithms of C to begin with."""
    points = []
    for each in measurements:
        middle = np.sum(each.shares * np.log(each.waves), axis=1)
        # C1 of an exponent H = 0.8 over q C
        points += zip(middle, np.log(each.density) if each.is_map else np.log(0.55 * each.density) - middle)
    at, value = np.array(sorted(points)).T
    return np.interp(x, at, value)


def descend(theta, rows, data, weight, prior):
    """The least of the likelihood, by Fisher's scores."""
    def least(theta):
        model, _ = evaluate(rows, theta)
        return np.sum(weight * (np.exp(data - model) - 1 + model - data)) + np.sum((prior @ theta) ** 2) / 2

    for _ in range(MOST_STEPS):
        model, slope = evaluate(rows, theta)
        score = slope.T @ (weight * np.expm1(data - model)) - prior.T @ (prior @ theta)
        # a bin far above the model has the curvature that it has, one far below that of its mean
        curvature = weight * np.exp(np.clip(data - model, 0, None))
        step = np.linalg.solve(slope.T @ (curvature[:, None] * slope) + prior.T @ prior, score)
        size = np.abs(step).max()
        if size < SMALL:
            return theta
        # near the end the likelihood is flat to round-off, and whole steps shrink by a factor
        if size > WHOLE:
            value = least(theta)
            while not least(theta + step) <= value:
                step /= 2
                if np.abs(step).max() < SMALL:
                    raise NoSpectrum("its periodograms are those of no rough surface")
        theta = theta + step
    raise NoSpectrum("its periodograms are those of no rough surface")


def evaluate(rows, theta):
    """Logarithms of the densities of all bins, and their slopes over the unknowns."""
    model, slope, n = [], [], len(theta)
    tail, change = tail_slope(theta, rows[0]["x"])
    for row in rows:
        k, share = row["k"], row["share"]
        logarithm = (1 - share) * theta[k] + share * theta[k + 1] + row["beyond"] * tail
        top = logarithm.max(axis=1)
        part = row["factor"] * np.exp(logarithm - top[:, None])
        total = part.sum(axis=1)
        part /= total[:, None]
        model.append(np.log(total) + top)
        at = k + n * np.arange(len(k))[:, None]
        slope.append((np.bincount(at.ravel(), ((1 - share) * part).ravel(), n * len(k))
                      + np.bincount(at.ravel() + 1, (share * part).ravel(), n * len(k))).reshape(len(k), n)
                     + (part * row["beyond"]).sum(axis=1)[:, None] * change)
    return np.concatenate(model), np.concatenate(slope)


def tail_slope(theta, x):
    """Slope of ln C over ln q beyond the last wave number, and how it depends on the unknowns."""
    k = max(0, min(len(x) - 2, int(np.searchsorted(x, x[-1] - np.log(BEFORE_END) + 1e-9)) - 1))
    slope = (theta[-1] - theta[k]) / (x[-1] - x[k])
    below = (STEEP - slope) / ROUND
    change = np.zeros(len(x))
    change[[-1, k]] = np.array([1.0, -1.0]) / (x[-1] - x[k]) * np.exp(-np.logaddexp(0, -below))
    return STEEP - ROUND * np.logaddexp(0, below), change


def row_of(each, x):
    """How bins follow from C: factors of sums over points, between which unknowns these are, and ln q beyond the last one."""
    if each.is_map:
        points, factor = np.log(each.waves), each.shares
    else:
        points, factor = line_points(each, x)
    inside = np.clip(points, x[0], x[-1])
    position = (inside - x[0]) / (x[1] - x[0])
    k = np.clip(position.astype(int), 0, len(x) - 2)
    return {"x": x, "k": k, "share": position - k, "beyond": points - inside, "factor": factor}


def line_points(each, x):
    """Logarithms of wave numbers and factors by which a bin of a line is a sum of C."""
    step = x[1] - x[0]
    edges = np.exp(np.concatenate([x, x[-1] + step * np.arange(1, int(np.log(BEYOND) / step) + 2)]))
    nodes, weights = np.polynomial.legendre.leggauss(NODES)
    q, share = waves_of_line(each)
    ends = np.sqrt(np.maximum(edges[None, None, :] ** 2 - q[..., None] ** 2, 0))
    half, middle = np.diff(ends) / 2, (ends[..., 1:] + ends[..., :-1]) / 2
    y = middle[..., None] + half[..., None] * nodes
    factor = 2 * half[..., None] * weights * share[..., None, None]
    points = np.log(np.hypot(q[..., None, None], y))
    return points.reshape(len(q), -1), factor.reshape(len(q), -1)


def waves_of_line(each):
    """Few waves that stand for those of each bin of a line, and their shares; shape (n, OF_LINE)."""
    q, share = np.zeros((2, len(each.density), OF_LINE))
    for i, (waves, shares) in enumerate(zip(each.waves, each.shares)):
        there = shares > 0
        groups = np.array_split(np.flatnonzero(there), min(OF_LINE, np.count_nonzero(there)))
        q[i] = waves[there][0]
        for j, group in enumerate(groups):
            share[i, j] = shares[group].sum()
            q[i, j] = np.sum(shares[group] * waves[group]) / share[i, j]
    return q, share
