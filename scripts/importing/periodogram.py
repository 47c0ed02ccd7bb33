# SPDX-License-Identifier: GPL-3.0-or-later
"""Periodograms of lines and maps in bins of the wave number, with the number of independent waves that each bin stands on.

Densities are variances: h^2 = int C d^2q of a map, and int C1 dq over both signs of a line. A window w has the mean square one.
The mean of n ordinates of a Gaussian surface has the relative variance <w^4>/n, n counted once for each pair of q and -q: ordinates
are exponential, and the sum of the squared correlations of one with all others is <w^4> (Parseval).
"""

from dataclasses import dataclass

import numpy as np

from .problems import NoSpectrum
from .treatment import topography_of

# bins in a decade, and parts of a bin whose means stand for its waves
PER_DECADE, PARTS = 10, 16
# samples in the shortest wave that is taken; shorter ones have waves beyond the samples in them (aliases)
SAMPLES_OF_WAVE = 4
# waves in the length of a part; the tilt that was removed, and the window, have changed longer ones
WAVES_OF_PART = 2
# a wave or a bin with so small a part of the largest density has no data but round-off
ROUND_OFF = 1e-20
# the first ring of a period has waves up to so many times its lowest wave number, and a table of so many candidates at most
RING, MOST_OF_RING = 1.26, 10**6


@dataclass
class Periodogram:
    """What one measurement says of a spectrum."""

    # name for messages
    name: str
    # is it a map? else a line
    is_map: bool
    # means of the density in bins [m^4, m^3 of a line], and the inverse of their relative variances; shape (n)
    density: np.ndarray
    weight: np.ndarray
    # wave numbers [rad/m] that stand for those of a bin, and their shares; shape (n, PARTS)
    waves: np.ndarray
    shares: np.ndarray
    # ends of the wave numbers that were taken [rad/m]
    ends: tuple
    # word of the window
    window: str
    # what the shortest wave follows from
    reason: str
    # (a - b)/(a + b) of the mean square slopes a, b along the directions in which they are largest and smallest, and its noise
    anisotropy: float | None = None
    anisotropy_noise: float | None = None
    # what was subtracted from the heights
    trend: str = "none"
    # the longest waves of a period, None of a part
    ring: "Ring | None" = None
    # mean square of a wave number along one axis in the power of the window [rad^2/m^2]
    blur: float = 0.0


@dataclass
class Ring:
    """The first waves of a period, a lattice of wave vectors, and the annulus whose area is that of their cells."""

    # ends of the annulus [rad/m]
    begin: float
    end: float
    # wave numbers [rad/m], and the area of the cell of each [rad^2/m^2]
    waves: np.ndarray
    cell: float


def window_of(surface, word=None):
    """The word of the window of a surface."""
    return "none" if surface.is_periodic else (word or "hann")


def window_values(surface, word):
    """The window with mean square one; shape of the heights."""
    if word == "none":
        return np.ones(surface.heights.shape)
    from scipy.signal import get_window
    from SurfaceTopography.FFTTricks import get_window_2D

    values = get_window_2D(word, *surface.samples, surface.lengths).T if surface.heights.ndim == 2 else get_window(word, surface.samples[0])
    return values / np.sqrt(np.mean(values**2))


def shortest_wave(surface, reliable=None, tip_radius=None, resolution=None):
    """The shortest wave to take [m], and why: what the user says, or else that of the samples, of the probe and of the instrument."""
    if reliable is not None:
        return reliable, "as given"
    longest = [(SAMPLES_OF_WAVE * max(surface.spacing), f"{SAMPLES_OF_WAVE} samples")]
    if tip_radius is not None:
        # A. Sanner and others, Appl. Surf. Sci. Adv. 7 (2022) 100190
        length = topography_of(surface).scanning_probe_reliability_cutoff(tip_radius)
        longest += [(float(length), f"tip radius {tip_radius:g} m")] if length else []
    if resolution is not None:
        longest.append((resolution, "resolution of the instrument"))
    return max(longest)


def periodogram_of(surface, name, shortest, reason, word=None):
    """The periodogram of a surface in bins."""
    word = window_of(surface, word)
    window = window_values(surface, word)
    first = 2 * np.pi / min(surface.lengths) * (1 if surface.is_periodic else WAVES_OF_PART)
    last = min(2 * np.pi / shortest, np.pi / max(surface.spacing))
    heights = window * (surface.heights.data - surface.heights.data.mean())
    # density in units of the heights, the wave numbers q_m = 2 pi m/L
    power = np.abs(np.fft.fftn(heights)) ** 2 / heights.size**2 * np.prod(np.array(surface.lengths) / (2 * np.pi))
    axes = [2 * np.pi * np.fft.fftfreq(n, step) for n, step in zip(surface.heights.shape, reversed(surface.spacing))]
    q = np.abs(axes[0]) if len(axes) == 1 else np.hypot(axes[0][:, None], axes[1][None, :])
    is_taken = is_between(q, first, last)
    # what was filtered has no density: the range ends where the power does
    has_power = is_taken & (power > ROUND_OFF * power[is_taken].max(initial=0.0))
    if has_power.any():
        first = first if q[has_power].min() <= q[is_taken].min() else q[has_power].min()
        if q[has_power].max() < q[is_taken].max():
            last, reason = q[has_power].max(), "shorter waves have no power"
    if not last > first or not has_power.any():
        raise NoSpectrum(f"too few waves, between {2 * np.pi / first:.3g} m and {2 * np.pi / last:.3g} m")
    is_taken = is_between(q, first, last)
    spread = np.mean(window**4)
    found = Periodogram(name, len(axes) == 2, *in_bins(q[is_taken], power[is_taken], first, last, spread), (first, last), word, reason)
    if surface.is_periodic:
        found.ring = first_ring(surface.lengths, first, last)
    found.blur = sum(np.mean(np.gradient(window, step, axis=axis) ** 2) for axis, step in enumerate(reversed(surface.spacing))) / len(axes)
    if found.is_map:
        qx, qy = np.broadcast_arrays(axes[1][None, :], axes[0][:, None])
        found.anisotropy, found.anisotropy_noise = anisotropy_of(qx[is_taken], qy[is_taken], power[is_taken], spread)
    return found


def is_between(q, first, last):
    """Which waves are in the range; a wave at an end belongs to it."""
    return (q > first * (1 - 1e-9)) & (q < last * (1 + 1e-9))


def first_ring(lengths, first, last):
    """The first ring of waves of a period; that of a line is the one of a square. None where it is too fine to matter."""
    steps = 2 * np.pi / np.array([lengths[0], lengths[-1]])
    most = np.floor(RING * first / steps)
    if np.prod(2 * most + 1) > MOST_OF_RING:
        return None
    x, y = (step * np.arange(-n, n + 1) for step, n in zip(steps, most))
    q, cell = np.hypot(x[:, None], y[None, :]), np.prod(steps)
    waves = q[is_between(q, first, min(RING * first, last))]
    longer = np.count_nonzero(q <= first * (1 - 1e-9))
    return Ring(*np.sqrt(np.array([longer, longer + len(waves)]) * cell / np.pi), waves, cell)


def in_bins(q, power, first, last, spread):
    """Mean densities in bins, weights, and the waves and shares that stand for each bin."""
    n_bins = max(1, round(PER_DECADE * np.log10(last / first)))
    position = np.log(np.clip(q / first, 1, None)) / np.log(last / first) * n_bins * PARTS
    part = np.minimum(position.astype(int), n_bins * PARTS - 1)
    counts = np.bincount(part, minlength=n_bins * PARTS).reshape(n_bins, PARTS)
    waves = np.bincount(part, q, n_bins * PARTS).reshape(n_bins, PARTS) / np.maximum(counts, 1)
    n = counts.sum(axis=1)
    density = np.bincount(part // PARTS, power, n_bins) / np.maximum(n, 1)
    has_data = (n > 0) & (density > ROUND_OFF * density.max())
    shares = counts / np.maximum(n, 1)[:, None]
    # parts without a wave have a share of 0, and any wave number of the range
    waves = np.where(counts > 0, waves, first)
    return density[has_data], n[has_data] / 2 / spread, waves[has_data], shares[has_data]


def anisotropy_of(qx, qy, power, spread):
    """How far the mean square slope depends on the direction, 0 to 1, and what an isotropic Gaussian map has of it by chance."""
    total = np.sum(power * (qx**2 + qy**2))
    parts = [np.sum(power * part) for part in (qx**2 - qy**2, 2 * qx * qy)]
    noise = spread * sum(np.sum((power * part) ** 2) for part in (qx**2 - qy**2, 2 * qx * qy))
    return float(np.hypot(*parts) / total), float(np.sqrt(noise) / total)
