# SPDX-License-Identifier: GPL-3.0-or-later
"""Power spectra, moments and the distribution of imported heights against closed forms."""

# first, since it starts the file again with the Python that has SurfaceTopography
from imports import Imports

import h5py
import numpy as np
from runs import main

NM = ("--unit", "nm", "--spacing", "100")
N = 64


def waves(*pairs):
    """Sum of cosines of amplitude [nm] and number over N samples."""
    x = 2 * np.pi * np.arange(N) / N
    return sum(amplitude * np.cos(number * x) for amplitude, number in pairs)


class Analysis(Imports):
    def spectrum(self, heights, *options, number=1):
        """Wave numbers and density of the spectrum along x, or over the plane."""
        np.save("a.npy", heights)
        self.read("a.npy", *NM, *options)
        with h5py.File("read.h5") as file:
            density = file[f"spectrum_{number}d"]
            self.assertEqual(density.attrs["units"], f"m^{number + 2}")
            return density.dims[0][0][()], density[()]

    def test_waves_of_a_line(self):
        """A cosine of amplitude a has L a^2/4 at its wave number; Parseval: the sum over both signs is L times the variance."""
        heights = waves((100, 2), (30, 7), (10, 20))
        length = N * 100e-9
        q, density = self.spectrum(heights, "--periodic")
        np.testing.assert_allclose(q, 2 * np.pi / length * np.arange(1, N // 2), rtol=1e-14)
        for amplitude, number in ((100e-9, 2), (30e-9, 7), (10e-9, 20)):
            self.assertAlmostEqual(density[number - 1] / (length * amplitude**2 / 4), 1, places=12)
        variance = heights.var() * 1e-18
        self.assertAlmostEqual(2 * density.sum() / length / variance, 1, places=12)

    def test_waves_behind_a_window(self):
        """A part of a surface: the window spreads a wave over three wave numbers, and keeps its power."""
        q, density = self.spectrum(waves((100, 10)), "--detrend", "none")
        length = N * 100e-9
        self.assertEqual(density.argmax(), 9)
        self.assertAlmostEqual(2 * density.sum() / length / 5e-15, 1, places=12)
        self.assertLess(np.delete(density, (8, 9, 10)).max(), 1e-20 * density.max())

    def test_peak(self):
        """One sample of height h has the same power (h dx dy)^2/A in all modes of the plane."""
        heights = np.zeros((12, 16))
        heights[5, 3] = 200
        q, density = self.spectrum(heights, "--periodic", number=2)
        expected = (200e-9 * 1e-14) ** 2 / (12 * 16 * 1e-14)
        np.testing.assert_allclose(density, expected, rtol=1e-12)
        self.assertGreaterEqual(len(q), 5)
        _, density = self.spectrum(heights, "--periodic")
        np.testing.assert_allclose(density, (200e-9 * 1e-7) ** 2 / (16 * 1e-7) / 12, rtol=1e-12)

    def test_moments(self):
        """A cosine on a grid: differences of neighbours have the amplitude 2 a sin(q dx/2)."""
        amplitude, number = 100e-9, 4
        half = np.sin(np.pi * number / N)
        slope = 2 * amplitude * half / 100e-9 / np.sqrt(2)
        curvature = 4 * amplitude * half**2 / 100e-9**2 / np.sqrt(2)
        line = waves((100, number))
        for heights, letter, factor in ((line, "P", 1.0), (np.tile(line, (8, 1)), "S", 0.5)):
            expected = {"rms_height": (amplitude / np.sqrt(2), letter + "q"), "skewness": (0, letter + "sk"),
                        "kurtosis": (1.5, letter + "ku"),
                        "peak_height": (amplitude, letter + "p"), "pit_depth": (amplitude, letter + "v"),
                        "rms_slope": (slope, letter + "dq"), "rms_curvature": (factor * curvature, None),
                        "mean_deviation": (np.abs(line).mean() * 1e-9, letter + "a")}
            np.save("a.npy", heights)
            self.read("a.npy", *NM, "--periodic")
            with h5py.File("read.h5") as file:
                for name, (value, symbol) in expected.items():
                    with self.subTest(name=name, letter=letter):
                        self.assertAlmostEqual(file[name][()] / (value or 1), bool(value), places=12)
                        self.assertEqual(file[name].attrs.get("symbol"), symbol)
                width = np.diff(file["height"][:2])[0]
                self.assertAlmostEqual(file["height_density"][()].sum() * width, 1, places=12)


if __name__ == "__main__":
    main()
