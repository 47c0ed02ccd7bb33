# SPDX-License-Identifier: GPL-3.0-or-later
"""What is done to heights before they are written: a part is cut out, tilt removed, gaps filled, neighbours averaged."""

import dataclasses

import numpy as np

from .problems import BadInput
from .source import FEWEST_SAMPLES, masked

# what can be removed: the words of the field, and those of SurfaceTopography
TRENDS = {"none": None, "mean": "mean", "line": "rms-tilt", "plane": "rms-tilt", "curvature": "rms-curvature"}
# heights that are so small a part of what was removed are round-off
ROUND_OFF = 1e-12


def topography_of(surface):
    """The surface as SurfaceTopography has it: x is the first index."""
    from SurfaceTopography import Topography, UniformLineScan

    kind = UniformLineScan if surface.heights.ndim == 1 else Topography
    heights = surface.heights if np.ma.is_masked(surface.heights) else surface.heights.data
    return kind(heights.T, surface.lengths, periodic=surface.is_periodic, unit="m")


def transpose(surface, path):
    """The surface with x and y in each other's place."""
    if surface.heights.ndim == 1:
        raise BadInput(f"{path}: --transpose is for maps, this is a line")
    return dataclasses.replace(surface, heights=surface.heights.T, spacing=surface.spacing[::-1])


def cut_out(surface, region, path):
    """The samples between positions [m], measured from the edge of the first cell."""
    if len(region) != 2 * surface.heights.ndim:
        raise BadInput(f"{path}: --region has {len(region)} numbers, a {'line' if surface.heights.ndim == 1 else 'map'} "
                       f"needs {2 * surface.heights.ndim}")
    slices = []
    for along, (first, last) in enumerate(zip(region[::2], region[1::2])):
        middles = (np.arange(surface.samples[along]) + 0.5) * surface.spacing[along]
        inside = np.flatnonzero((middles >= first) & (middles < last))
        if len(inside) < FEWEST_SAMPLES:
            raise BadInput(f"{path}: --region keeps {len(inside)} samples along {'xy'[along]}, allowed: at least {FEWEST_SAMPLES}")
        slices.append(slice(inside[0], inside[-1] + 1))
    origin = tuple(part.start * step for part, step in zip(slices, surface.spacing))
    return dataclasses.replace(surface, heights=surface.heights[tuple(reversed(slices))], origin=origin)


def missing_samples(surface, most, path):
    """Number of missing samples; too many are refused."""
    missing = int(np.ma.count_masked(surface.heights))
    if missing == surface.heights.size:
        raise BadInput(f"{path}: all samples are missing")
    if missing > most * surface.heights.size:
        share = missing / surface.heights.size
        raise BadInput(f"{path}: {missing} of {surface.heights.size} samples are missing, a share of {share:.3g}; "
                       f"--most-missing allows {most:g}")
    return missing


def choose_trend(surface, wanted, path):
    """The trend to remove; by default the tilt of what was cut out of a larger surface, the mean of a period."""
    own, other = ("line", "plane") if surface.heights.ndim == 1 else ("plane", "line")
    if wanted is None:
        return "mean" if surface.is_periodic else own
    if wanted == other:
        raise BadInput(f"{path}: --detrend {other} is for {'maps' if other == 'plane' else 'lines'}, this is a "
                       f"{'line' if other == 'plane' else 'map'}: --detrend {own}")
    if surface.is_periodic and wanted not in ("none", "mean"):
        raise BadInput(f"{path}: a period has no {wanted} to remove: --detrend none or mean, or --no-periodic")
    return wanted


def remove_trend(surface, trend, path):
    """The surface without a trend, which is fitted to the samples that are there, and the coefficients removed [m]."""
    if TRENDS[trend] is None:
        return surface, []
    detrended = topography_of(surface).detrend(TRENDS[trend])
    heights = masked(detrended.heights().T)
    if np.ptp(heights.compressed()) <= ROUND_OFF * np.abs(surface.heights.compressed()).max():
        raise BadInput(f"{path}: nothing is left of the heights without their {trend}")
    return dataclasses.replace(surface, heights=heights), [float(value) for value in detrended.coeffs]


def fill_gaps(surface):
    """The surface with missing samples interpolated harmonically: each is the mean of its neighbours."""
    if not np.ma.is_masked(surface.heights):
        return surface
    filled = topography_of(surface).interpolate_undefined_data_with_harmonic_function()
    return dataclasses.replace(surface, heights=masked(np.ma.getdata(filled.heights()).T))


def average(surface, count, path):
    """Means over blocks of so many samples along each direction; samples beyond the last whole block are left out."""
    if count == 1:
        return surface
    if surface.is_periodic and any(n % count for n in surface.samples):
        raise BadInput(f"{path}: --average {count} does not divide the {' x '.join(map(str, surface.samples))} samples of a period")
    blocks = tuple(n // count for n in surface.heights.shape)
    if min(blocks) < FEWEST_SAMPLES:
        raise BadInput(f"{path}: --average {count} leaves {' x '.join(map(str, blocks[::-1]))} samples, allowed: at least "
                       f"{FEWEST_SAMPLES} along each direction")
    heights = surface.heights.data[tuple(slice(n * count) for n in blocks)]
    shape = tuple(number for n in blocks for number in (n, count))
    means = heights.reshape(shape).mean(axis=tuple(range(1, len(shape), 2)))
    return dataclasses.replace(surface, heights=masked(means), spacing=tuple(count * step for step in surface.spacing))
