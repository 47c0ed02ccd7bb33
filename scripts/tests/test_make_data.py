# SPDX-License-Identifier: GPL-3.0-or-later
"""The scripts that write data for inputs."""

import sys
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from make_measurement import EXPONENT, GLASSY, RELAXED, complex_modulus, make_line, write_curve, write_line  # noqa: E402
from make_surface import make_heights, write_surface  # noqa: E402
from make_traction import make_tractions  # noqa: E402


class SurfaceTest(unittest.TestCase):
    """A random surface."""

    def test_root_mean_square_and_mean(self):
        """Both are as asked for, to round-off."""
        heights = make_heights(64, 0.8, 1 / 2, 1 / 16, 3.0e-7, 1)
        self.assertEqual((64, 64), heights.shape)
        self.assertAlmostEqual(1, heights.std() / 3.0e-7, places=12)
        self.assertAlmostEqual(0, heights.mean() / 3.0e-7, places=12)

    def test_seed(self):
        """The same seed makes the same surface, another seed another one."""
        first, again, other = (make_heights(32, 0.8, 1 / 2, 1 / 16, 1.0, seed) for seed in (1, 1, 2))
        self.assertTrue((first == again).all())
        self.assertFalse(np.allclose(first, other))

    def test_cells(self):
        """Three times the cells: the same surface, of which every third middle is that of a larger cell."""
        coarse, fine = (make_heights(cells, 0.8, 1 / 2, 1 / 8, 1.0, 1) for cells in (32, 96))
        self.assertLess(np.abs(fine[1::3, 1::3] - coarse).max(), 1e-12)

    def test_waves(self):
        """No waves longer or shorter than asked for, and the power falls as |k|^(-2 - 2 hurst) = |k|^-3.6."""
        power = np.abs(np.fft.fft2(make_heights(256, 0.8, 1 / 2, 1 / 64, 1.0, 1))) ** 2
        waves = np.fft.fftfreq(256, 1 / 256)
        number = np.hypot(waves[:, None], waves[None, :])
        self.assertLess(power[(number < 2) | (number > 64)].max(), 1e-20 * power.max())
        rings = [power[(number >= k) & (number < 1.2 * k)].mean() for k in (8, 32)]
        self.assertAlmostEqual(-3.6, np.log(rings[1] / rings[0]) / np.log(4), delta=0.1)


    def test_file(self):
        """The distances of the samples stand beside the heights."""
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "surface.h5")
            write_surface(path, np.zeros((4, 8)), 2.0)
            with h5py.File(path) as file:
                self.assertEqual((0.25, 0.5), (file["heights"].attrs["dx"], file["heights"].attrs["dy"]))


class MeasurementTest(unittest.TestCase):
    """A line scan and a master curve."""

    def test_line(self):
        """The root mean square is as asked for, and no wave is shorter than asked for: cubics through every fourth sample have the others."""
        heights = make_line(400, 1.0e-6, 0.8, 1.0e-4, 4.0e-5, 3.0e-5, 1)
        self.assertAlmostEqual(1, heights.std() / 3.0e-5, places=12)
        middles = (-heights[:-3:4][:-3] + 9 * heights[4:-3:4][:-2] + 9 * heights[8:-3:4][:-1] - heights[12:-3:4]) / 16
        self.assertLess(np.abs(middles - heights[6:][:4 * middles.size:4]).max(), 0.02 * heights.std())

    def test_modulus(self):
        """Relaxed at low frequencies, glassy at high ones, and the loss between them as omega to the exponent."""
        self.assertAlmostEqual(1, complex_modulus(1e-20) / RELAXED, places=5)
        self.assertAlmostEqual(1, abs(complex_modulus(1e30)) / GLASSY, places=10)
        ratio = complex_modulus(2.0).imag / complex_modulus(1.0).imag
        self.assertAlmostEqual(EXPONENT, np.log2(ratio), places=3)

    def test_files(self):
        """What is written is what was made: positions, heights with the tilt, and samples that are missing."""
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "line.csv")
            write_line(path, 1.0e-6, np.full(1000, 2.0e-6), 0.5, 0.1, 1)
            x, z = np.genfromtxt(path, delimiter=",", skip_header=2).T
            is_there = np.isfinite(z)
            np.testing.assert_allclose(z[is_there], 2 + 500 * x[is_there], atol=1e-4)
            self.assertTrue(0.05 < 1 - is_there.mean() < 0.15)
            path = Path(folder, "curve.csv")
            write_curve(path, 1.0, 100.0, 2, 0.0, 1)
            frequency, storage, loss = np.genfromtxt(path, delimiter=",", skip_header=3).T
            np.testing.assert_allclose(frequency, 10.0 ** np.array([0, 0.5, 1, 1.5, 2]), rtol=1e-5)
            np.testing.assert_allclose(storage + 1j * loss, complex_modulus(2 * np.pi * frequency) / 1e6, rtol=1e-5)


class TractionTest(unittest.TestCase):
    """A cylinder in partial slip."""

    def test_loads(self):
        """The integrals are P = pi a p0/2 and Q, to the second order of the samples."""
        positions, pressures, shear = make_tractions(2.0, 3.0, 0.3, 0.5, 401)
        self.assertTrue((np.diff(positions) > 0).all())
        load = np.pi * 2.0 * 3.0 / 2
        self.assertAlmostEqual(1, np.trapezoid(pressures, positions) / load, delta=1e-4)
        self.assertAlmostEqual(0.5 * 0.3, np.trapezoid(shear, positions) / load, delta=1e-4)

    def test_slip(self):
        """Nowhere more than friction allows; all of it beside the part that sticks, and everywhere in full slip."""
        positions, pressures, shear = make_tractions(2.0, 3.0, 0.3, 0.5, 101)
        self.assertTrue((shear <= 0.3 * pressures).all() and (shear >= 0).all())
        slips = np.abs(positions) > 2.0 * np.sqrt(0.5)
        self.assertTrue((shear[slips] == 0.3 * pressures[slips]).all())
        positions, pressures, shear = make_tractions(2.0, 3.0, 0.3, 1.0, 101)
        self.assertTrue((shear == 0.3 * pressures).all())


if __name__ == "__main__":
    unittest.main()
