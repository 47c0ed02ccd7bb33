"""The scripts that write data for inputs."""

import sys
import unittest
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from make_surface import make_heights  # noqa: E402
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
