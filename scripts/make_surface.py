# SPDX-License-Identifier: GPL-3.0-or-later
"""Write a self-affine random surface, periodic in x and y, as heights in an HDF5 file."""

import sys

import h5py
import numpy as np

from make_options.surface import read_command_line


def make_heights(cells, hurst, longest, shortest, rms, seed):
    """Heights [m] in the middles of cells, shape (ny, nx): waves of random phase whose power falls as |k|^(-2 - 2 hurst).

    Wavelengths are parts of the period, which is the same in x and y. A seed makes the same surface on any number of cells.
    """
    modes = 2 * int(1 / shortest) + 2
    waves = np.fft.fftfreq(modes, 1 / modes)
    number = np.hypot(waves[:, None], waves[None, :])
    is_kept = (number >= 1 / longest) & (number <= 1 / shortest)
    amplitude = np.zeros_like(number)
    amplitude[is_kept] = number[is_kept] ** (-1 - hurst)
    spectrum = amplitude * np.fft.fft2(np.random.default_rng(seed).normal(size=number.shape))
    to_middle = np.exp(1j * np.pi * waves / cells)
    places = waves.astype(int)
    padded = np.zeros((cells, cells), complex)
    padded[np.ix_(places, places)] = spectrum * to_middle[:, None] * to_middle[None, :]
    heights = np.fft.ifft2(padded).real
    return heights * (rms / heights.std())


def make_stripes(cells, stripes, weak):
    """Work of adhesion of the cells over the largest one, shape (ny, nx): stripes along y, half of each period weak."""
    position = (np.arange(cells) + 0.5) * stripes / cells % 1
    return np.tile(np.where(position < 0.5, 1.0, weak), (cells, 1))


def shape_tip(heights, length, radius):
    """Roughness [m] on a paraboloid about the middle of the map, (ny, nx); NaN beyond the circle that the map holds."""
    position = ((np.arange(len(heights)) + 0.5) / len(heights) - 0.5) * length
    square = position[:, None] ** 2 + position[None, :] ** 2
    return np.where(square <= length ** 2 / 4, heights - square / (2 * radius), np.nan)


def write_surface(path, heights, length, work=None):
    """Write the heights [m] and the distances of the samples, which `kind = 'map'` of `wavy_sliding` reads as well."""
    with h5py.File(path, "w") as file:
        dataset = file.create_dataset("heights", data=heights)
        dataset.attrs["units"] = "m"
        dataset.attrs["long_name"] = "height of the rough body, summits positive"
        dataset.attrs["length"] = length
        for axis, cells in zip(("dy", "dx"), heights.shape):
            dataset.attrs[axis] = length / cells
        if work is not None:
            dataset = file.create_dataset("work", data=work)
            dataset.attrs["units"] = "1"
            dataset.attrs["long_name"] = "work of adhesion over its largest value"


def main():
    """Read the options and write the file."""
    given = read_command_line(sys.argv[1:])
    heights = make_heights(given.cells, given.hurst, given.longest, given.shortest, given.rms, given.seed)
    if given.tip is not None:
        heights = shape_tip(heights, given.length, given.tip)
    work = make_stripes(given.cells, given.stripes, given.weak) if given.stripes else None
    write_surface(given.file, heights, given.length, work)


if __name__ == "__main__":
    main()
