# SPDX-License-Identifier: GPL-3.0-or-later
"""Moments, power spectra, distribution and seam of heights."""

from dataclasses import dataclass

import numpy as np

from .joined_spectrum import join
from .periodogram import periodogram_of, shortest_wave, window_of
from .problems import BadInput, NoSpectrum
from .treatment import topography_of

# bins of the distribution of heights
FEWEST_BINS, MOST_BINS = 10, 200
# edges meet where the step across them is at most so many times the largest inside (src/shape/period_seam.f90)
OPEN_SEAM = 2.0


@dataclass
class Quantity:
    """A number of the surface, as the table and the file have it."""

    name: str
    symbol: str
    value: float
    unit: str
    meaning: str


@dataclass
class Spectrum:
    """A power spectral density over the wave number [rad/m], as SurfaceTopography defines it."""

    name: str
    axis: str
    wave_numbers: np.ndarray
    density: np.ndarray
    unit: str
    meaning: str


@dataclass
class Results:
    """What is computed from a surface."""

    # list of `Quantity`
    moments: list
    # list of `Spectrum`, along x first
    spectra: list
    # wave numbers and density of the spectrum along x in bins
    binned: tuple
    # middles of bins of heights and the density in them
    distribution: tuple
    # steps across the edges and inside, along x first
    seams: list
    # periodogram and isotropic spectrum, None where there are too few waves, and why
    periodogram: object = None
    joined: object = None
    why_none: str = ""


def analyse(surface, path, reliable=None, tip_radius=None, resolution=None, window=None):
    """All that is computed from a surface; lengths and radius are those of `shortest_wave`."""
    results = Results(moments_of(surface), spectra_of(surface, window), binned(surface, window), distribution_of(surface), seams_of(surface))
    shortest = shortest_wave(surface, reliable, tip_radius, resolution)
    try:
        results.periodogram = periodogram_of(surface, path.name, *shortest, window)
        results.joined = join([results.periodogram])
    except NoSpectrum as problem:
        results.why_none = str(problem)
    for name, values in [(moment.name, moment.value) for moment in results.moments] + [
            (spectrum.name, spectrum.density) for spectrum in results.spectra]:
        if not np.isfinite(values).all():
            raise BadInput(f"{path}: {name.replace('_', ' ')} is no number: the heights are too large or too small")
    return results


def moments_of(surface):
    """Moments of the heights and of their derivatives; the symbols of ISO 21920 (P of a line) and ISO 25178 (S of a map)."""
    z = surface.heights.data - surface.heights.data.mean()
    is_line = z.ndim == 1
    letter = "P" if is_line else "S"
    deviation = np.sqrt(np.mean(z**2))
    topography = topography_of(surface)
    slope = topography.Rdq() if is_line else topography.rms_gradient()
    curvature = topography.Rddq() if is_line else topography.rms_curvature_from_area()
    # no standard has a symbol of the curvature
    return [
        Quantity("rms_height", f"{letter}q", deviation, "m", "root mean square of the heights about their mean"),
        Quantity("mean_deviation", f"{letter}a", np.mean(np.abs(z)), "m", "mean absolute deviation of the heights from their mean"),
        Quantity("skewness", f"{letter}sk", np.mean(z**3) / deviation**3, "1", "skewness of the heights"),
        Quantity("kurtosis", f"{letter}ku", np.mean(z**4) / deviation**4, "1", "kurtosis of the heights, 3 of a Gaussian"),
        Quantity("peak_height", f"{letter}p", z.max(), "m", "height of the highest sample above the mean"),
        Quantity("pit_depth", f"{letter}v", -z.min(), "m", "depth of the lowest sample below the mean"),
        Quantity("rms_slope", f"{letter}dq", float(slope), "1",
                 "root mean square of the slope between neighbouring samples" if is_line else
                 "root mean square of the gradient between neighbouring samples"),
        Quantity("rms_curvature", "", float(curvature), "1/m",
                 "root mean square of the second derivative, from three neighbouring samples" if is_line else
                 "root mean square of the mean curvature, half the sum of the second derivatives along x and y"),
    ]


def spectra_of(surface, word=None):
    """Power spectra along x and, of a map, averaged over all directions."""
    topography = topography_of(surface)
    waves, density = topography.power_spectrum_from_profile(window=library_window(surface, word), reliable=False, resampling_method=None)
    window = "without a window" if window_of(surface, word) == "none" else "behind a Hann window"
    # the wave number 0 is the mean
    spectra = [Spectrum("spectrum_1d", "wave_number_1d", np.asarray(waves)[1:], np.asarray(density)[1:], "m^3",
                        f"power spectral density of the heights along x, {window}")]
    if topography.dim == 2:
        waves, density = with_data(*topography.power_spectrum_from_area(window=library_window(surface, word), reliable=False))
        spectra.append(Spectrum("spectrum_2d", "wave_number_2d", waves, density, "m^4",
                                f"power spectral density of the heights over the plane, mean of all directions, {window}"))
    return spectra


def binned(surface, word=None):
    """The spectrum along x averaged in bins, for the eye."""
    return with_data(*topography_of(surface).power_spectrum_from_profile(window=library_window(surface, word), reliable=False))


def library_window(surface, word):
    """The window as SurfaceTopography calls it: that of a part or a period, or none."""
    return None if window_of(surface, word) != "none" or surface.is_periodic else "None"


def with_data(waves, density):
    """The bins that have data."""
    waves, density = np.ma.masked_invalid(waves), np.ma.masked_invalid(density)
    has_data = ~(np.ma.getmaskarray(waves) | np.ma.getmaskarray(density))
    return waves.data[has_data], density.data[has_data]


def distribution_of(surface):
    """Middles of bins of heights [m], and the density of heights in them [1/m]."""
    z = surface.heights.data.ravel()
    bins = int(np.clip(np.sqrt(z.size), FEWEST_BINS, MOST_BINS))
    density, edges = np.histogram(z, bins=bins, density=True)
    return (edges[1:] + edges[:-1]) / 2, density


def seams_of(surface):
    """The step from the last row to the first and the largest between neighbouring rows [m], along x first.

    Steps are root mean squares along the rows, as the program compares them when it reads periodic heights.
    """
    seams = []
    for along in range(surface.heights.ndim):
        rows = np.moveaxis(surface.heights.data, surface.heights.ndim - 1 - along, 0)
        steps = (rows - np.roll(rows, 1, axis=0)).reshape(len(rows), -1)
        steps = np.sqrt(np.mean(steps**2, axis=1))
        seams.append((float(steps[0]), float(steps[1:].max())))
    return seams


def is_open(seams):
    """Do opposite edges not meet?"""
    return any(step > OPEN_SEAM * largest for step, largest in seams)
