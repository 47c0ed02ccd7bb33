# SPDX-License-Identifier: GPL-3.0-or-later
"""The results of small runs, opened by xarray and drawn as a user does."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np
import xarray as xr

GROUPS = """
&job model = 'wavy_sliding', title = 'A wave', output = 'run.h5' /
&foundation stiffness = 1e8, relaxation_time = 1e-3, retardation_ratio = 10 /
&adhesion range = 1e-5 /
&operating velocity = 0.5 /
&sweep variable = 'stress', values = 0, 2e3 /
"""
WAVE_2D = GROUPS + """
&surface kind = 'wave_2d', period = 1e-2, height = 1e-4 /
&sweep variable = 'load', values = -100, 0, 10, 30, 60 /
"""
WAVE_3D = GROUPS + """
&surface kind = 'wave_3d', period = 1e-2, height = 1e-4 /
&sweep variable = 'penetration', values = 2e-5, 8e-5, 9e-4 /
&output profiles = .true., n_x = 9, n_y = 5 /
"""
RESULTS = {
    "friction_force": "N", "friction_coefficient": "1", "contact_area": "m^2", "adhesion_area": "m^2",
    "contact_width": "m", "contact_shift": "m", "dissipation": "N", "edge_loss": "N", "energy_imbalance": "1",
    "error_estimate": "1",
}


class OpenByXarray(unittest.TestCase):
    def make_file(self, text):
        """Results file of an input."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        path = Path(folder.name) / "run.nml"
        path.write_text(text)
        subprocess.run([os.environ["ADFRIC_PROGRAM"], "run", "--quiet", path.name], cwd=folder.name, check=True)
        return path.with_suffix(".h5")

    def run_input(self, text):
        """Results of an input, in memory."""
        with xr.open_dataset(self.make_file(text), engine="h5netcdf") as results:
            return results.load()

    def test_figures(self):
        for text in (WAVE_2D, WAVE_3D):
            path = self.make_file(text)
            subprocess.run([sys.executable, Path(os.environ["ADFRIC_SOURCE"]) / "scripts/plot.py", path], cwd=path.parent,
                           check=True, capture_output=True)
            self.assertGreater(path.with_suffix(".png").stat().st_size, 0)

    def test_doubt(self):
        results = self.run_input("""
&job model = 'indenter', output = 'run.h5' /
&shape kind = 'paraboloid', radius = 1e-6 /
&solid contact_modulus = 1e6 /
&sweep variable = 'approach', values = -1e-7, 1e-8, 2.4e-7, 2.6e-7 /
""")
        self.assertEqual(results.doubt.dtype, np.int8)
        meanings = dict(zip(results.doubt.attrs["flag_values"], results.doubt.attrs["flag_meanings"].split()))
        self.assertEqual([meanings[int(k)] for k in results.doubt], ["none", "none", "none", "contact_too_wide"])
        self.assertEqual(results.status.values.tolist(), [0, 0, 0, 0])

    def test_wave_2d(self):
        results = self.run_input(WAVE_2D)
        self.assertEqual(results.friction_force.dims, ("stress", "load"))
        np.testing.assert_array_equal(results.stress, [0.0, 2e3])
        np.testing.assert_array_equal(results["load"], [-100.0, 0.0, 10.0, 30.0, 60.0])
        self.assertEqual(results.stress.attrs["units"], "Pa")
        self.assertEqual(results["load"].attrs["units"], "N/m")
        # one strip: forces and areas per width
        for name, unit in RESULTS.items():
            with self.subTest(name=name):
                self.assertEqual(results[name].attrs["units"], unit.replace("m^2", "m").replace("N", "N/m"))
                self.assertGreater(len(results[name].attrs["long_name"]), 3)
        # nothing carries a pull of 100 N/m
        self.assertTrue(np.all(np.isnan(results.friction_force.sel(load=-100.0))))
        self.assertTrue(np.all(results.status.sel(load=-100.0) == 1))
        self.assertTrue(np.all(results.status.sel(load=[0.0, 10.0, 30.0, 60.0]) == 0))
        # labels choose values: adhesion adds to friction
        self.assertGreater(float(results.friction_force.sel(stress=2e3, load=30.0)),
                           float(results.friction_force.sel(stress=0.0, load=30.0)))

    def test_wave_3d_with_profiles(self):
        results = self.run_input(WAVE_3D)
        self.assertEqual(results.friction_force.dims, ("stress", "penetration"))
        for name, unit in {**RESULTS, "load": "N"}.items():
            with self.subTest(name=name):
                self.assertEqual(results[name].attrs["units"], unit)
        for name, unit in {"pressure": "Pa", "shear_stress": "Pa", "displacement": "m", "gap": "m"}.items():
            with self.subTest(name=name):
                self.assertEqual(results[name].dims, ("stress", "penetration", "y", "x"))
                self.assertEqual(results[name].attrs["units"], unit)
                self.assertTrue(np.all(np.isfinite(results[name])))
        np.testing.assert_allclose(results.x, np.linspace(-5e-3, 5e-3, 9), atol=1e-18)
        np.testing.assert_allclose(results.y, np.linspace(-5e-3, 5e-3, 5), atol=1e-18)
        # at the crest the foundation is pressed in by the penetration
        crest = results.displacement.sel(x=0.0, y=0.0)
        np.testing.assert_allclose(crest, np.broadcast_to(results.penetration, crest.shape), rtol=1e-12)

    def test_flags_and_attributes(self):
        results = self.run_input(WAVE_2D)
        self.assertEqual(results.status.attrs["flag_meanings"], "solved no_equilibrium not_converged")
        self.assertEqual(list(results.status.attrs["flag_values"]), [0, 1, 2])
        words = results.regime.attrs["flag_meanings"].split()
        meanings = dict(zip(results.regime.attrs["flag_values"], words, strict=True))
        self.assertEqual(meanings[int(results.regime.sel(stress=0.0, load=30.0))], "discrete_contact")
        self.assertEqual(meanings[int(results.regime.sel(stress=0.0, load=-100.0))], "no_value")
        self.assertEqual(results.attrs["title"], "A wave")
        self.assertEqual(results.attrs["model"], "wavy_sliding")
        # the input stands in the file, and gives the same results again
        self.assertEqual(results.attrs["input"], WAVE_2D)
        again = self.run_input(results.attrs["input"])
        xr.testing.assert_equal(results, again)
        for name in ("adfric_version", "git_revision", "compiler", "created"):
            self.assertIsInstance(results.attrs[name], str)
        self.assertGreater(results.attrs["wall_seconds"], 0.0)


if __name__ == "__main__":
    unittest.main()
