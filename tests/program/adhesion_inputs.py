# SPDX-License-Identifier: GPL-3.0-or-later
"""The shipped inputs of rough surfaces that adhere, on fewer cells, and their figures."""

import os
import re
import sys
import unittest
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from input_runs import SOURCE, InputRuns  # noqa: E402
from plotting import adhesion, figures, surface  # noqa: E402
from plotting.results import Results  # noqa: E402

# points of a sweep, and cells along a direction, are so many times fewer where checks make a test slow
SHRINK = 1 if float(os.environ.get("ADFRIC_RANDOM_CASES", "1")) == 1 else 4


class AdhesionInputs(InputRuns):
    def test_waves(self):
        """Every input of a wave along two directions is answered, on fewer cells where those of the input take their time."""
        for name, result, count, cells in (("wave_2d_adhesion", "contact_fraction", 52, 128),
                                           ("wave_2d_adhesion_approach", "contact_fraction", 51, 128),
                                           ("wave_2d_adhesion_penetration", "mean_pressure", 45, 64),
                                           ("wave_2d_adhesion_penetration_approach", "mean_pressure", 45, 64),
                                           ("wave_2d_pull_off", "pull_off_pressure", 13, 128)):
            given = re.search(r"cells = \d+", (SOURCE / "inputs" / f"{name}.nml").read_text())[0]
            points = 1 + (count - 1)//SHRINK
            found = self.solve(name, **{given: f"cells = {cells}", f"count = {count}": f"count = {points}"})
            self.assertEqual(found[result].shape, (points,))

    def test_adhesion_and_friction(self):
        """A rough surface that adheres has friction under a tension, where it has no coefficient; it is that of area and of what contact carries."""
        self.make_surface("surface_adhesion_friction", 256//SHRINK)
        found = self.solve("surface_adhesion_friction", **{"count = 12": "count = 2", "&friction": "&output profiles = .true. /\n&friction"})
        self.assertLess(found["mean_pressure"][0], 0)
        self.assertGreater(found["friction_stress"][0], 0)
        self.assertTrue(np.isnan(found["friction_coefficient"][0]))
        carried = found["mean_pressure"] + found["adhesion_stress"] * found["adhesion_fraction"]
        expected = found["shear_strength"] * found["contact_fraction"] + found["pressure_factor"] * carried
        np.testing.assert_allclose(found["friction_stress"], expected, rtol=1e-14)
        np.testing.assert_allclose(found["friction_coefficient"][1], expected[1] / found["mean_pressure"][1], rtol=1e-14)
        touches = found["gap"] == 0
        shear = np.where(touches, found["shear_strength"] + found["pressure_factor"] * found["pressure"], 0)
        np.testing.assert_allclose(found["shear_stress"], shear, rtol=1e-14)
        # the map counts cells at the perimeter as a whole
        excess = touches.mean(axis=(1, 2)) - found["contact_fraction"]
        np.testing.assert_array_less(0, excess)
        np.testing.assert_array_less(abs(shear.mean(axis=(1, 2)) - expected), 1.0001 * found["shear_strength"] * excess)

    def test_stickiness(self):
        """A smooth surface holds to the stress of adhesion, a rough one to less and less of it; a surface that has been pressed holds
        no less than one that has touched."""
        self.make_surface("surface_stickiness", 32)
        found = self.solve("surface_stickiness", **{"count = 25": "count = 4", "range = 1.25e-7": "range = 2.5e-7"})
        tension = -found["pull_off_pressure"]
        self.assertEqual(tension.shape, (2, 4))
        np.testing.assert_allclose(tension[:, 0], found["adhesion_stress"], rtol=1e-9)
        self.assertTrue(np.all(np.diff(tension) < 0))
        # to the step with which a pull-off is sought
        self.assertTrue(np.all(tension[1] >= 0.99 * tension[0]))
        results = Results(self.folder / "run.h5")
        self.assertIs(figures.choose_figure(results), adhesion.draw_stickiness)
        adhesion.draw_stickiness(results)

    def test_opening(self):
        """A preload makes a surface hold more where opening takes more work, up to full contact. With equal works it need not."""
        self.make_surface("surface_opening", 32)
        found = self.solve("surface_opening", **{"count = 13": "count = 3", "adhesion_stress = 1.2e5": "adhesion_stress = 6.0e4"})
        tension = -found["pull_off_pressure"]
        self.assertEqual(tension.shape, (3, 3))
        # to the step with which a pull-off is sought
        self.assertTrue(np.all(tension[1:] >= 0.99 * tension[:-1]))
        self.assertTrue(np.all(tension[:, 1:] >= 0.99 * tension[:, :-1]))
        self.assertTrue(np.all(np.isnan(found["opening_loss"][0])))
        self.assertTrue(np.all(found["opening_loss"][1:] >= 0))

    def test_maps(self):
        """Without the load of the contacts alone: rims of tension, whose pressure is that of adhesion, balance it."""
        self.make_surface("surface_adhesion_maps", 64)
        found = self.solve("surface_adhesion_maps", **{"range = 5.0e-8": "range = 1.0e-7", "4.0e4, 1.5e5": "4.0e4"})
        pressure, gap = found["pressure"], found["gap"]
        np.testing.assert_allclose(pressure.mean(axis=(1, 2)), found["mean_pressure"], atol=1e-6 * pressure.max())
        self.assertGreaterEqual(pressure.min(), -found["adhesion_stress"] * (1 + 1e-6))
        rims = (gap > 0) & (gap < 0.5 * found["adhesion_range"])
        np.testing.assert_array_less(pressure[rims], 0)
        results = Results(self.folder / "run.h5")
        self.assertIs(figures.choose_figure(results), surface.draw_pressure_maps)
        surface.draw_pressure_maps(results)


if __name__ == "__main__":
    unittest.main()
