# SPDX-License-Identifier: GPL-3.0-or-later
"""Designs of scans: whole, in parts, resumed, and opened by xarray with their labels."""

import signal
import sys
import unittest
from pathlib import Path

import numpy as np
import xarray as xr

sys.path.insert(0, str(Path(__file__).parent))
from runs import Runs, main  # noqa: E402

SPHERE = """
&job model = 'sphere', output = 'run.h5' /
&sphere contact_modulus = 1e9, adhesion_stress = 1e8, {sphere} /
&friction {friction} /
&operating state = 'sliding' /
"""
TABLE = """# three tips, two surfaces
radius [nm], load [nN], work_of_adhesion [mJ/m^2], note
10, 1.5, 50, 1
20, 2.0, 50, 2
50, 3.0, 20, nan
"""
WITH = SPHERE.format(sphere="work_of_adhesion = 0.05", friction="") + """
&sweep variable = 'load', values = 'tips.csv:load' /
&sweep variable = 'radius', values = 'tips.csv:radius', with = 'load' /
&sweep variable = 'shear_strength', values = 1e7, 2e7 /
"""
CASES = SPHERE.format(sphere="radius = 1e-8", friction="") + """
&sweep variable = 'shear_strength', from = 1e6, to = 1e7, count = 20 /
&cases file = 'tips.csv', variables = 'work_of_adhesion', 'load' /
"""
SAMPLE = SPHERE.format(sphere="work_of_adhesion = 0.05", friction="shear_strength = 1e7") + """
&sample count = 40, method = 'latin_hypercube', seed = 5 /
&range variable = 'radius', from = 1e-9, to = 1e-6, spacing = 'log' /
&range variable = 'load', from = 0, to = 1e-8 /
"""
REFINED = SPHERE.format(sphere="radius = 20e-9, work_of_adhesion = 0.05", friction="shear_strength = 1e7") + """
&sweep variable = 'load', from = -8e-9, to = 4e-8, count = 9 /
&refine variable = 'load', result = 'contact_radius', tolerance = 1e-6 /
"""
UNCERTAIN = SPHERE.format(sphere="radius = 20e-9, work_of_adhesion = 0.05", friction="shear_strength = 1e7") + """
&sweep variable = 'load', from = -8e-9, to = 4e-8, count = {count} /
&output derivatives = 'load', 'radius' /
&uncertain variable = 'radius', relative_error = 0.1 /
&uncertain variable = 'work_of_adhesion', error = 0.005, method = 'samples', count = 20 /
"""


class Designs(Runs):
    def setUp(self):
        super().setUp()
        self.write(TABLE, "tips.csv")

    def check_parts(self, text, *options):
        """One run, and two parts with other numbers of threads: the same bits. A run that is complete is known as such."""
        self.write(text)
        self.run_program("run", "--quiet", "run.nml", threads=1)
        output, _ = self.run_program("run", "--resume", "run.nml")
        self.assertIn("this run was complete already", output)
        for number in (1, 2):
            self.run_program("run", "--quiet", "run.nml", "--shard", f"{number}/2", threads=1 + number)
        parts = [f"run.part-000{number}-of-0002.h5" for number in (2, 1)]
        self.run_program("merge", "--quiet", *options, "all.h5", *parts)
        self.assert_same(self.snapshot("run.h5"), self.snapshot("all.h5"))
        with xr.open_dataset(self.folder / "run.h5", engine="h5netcdf") as results:
            return results.load()

    def test_with(self):
        results = self.check_parts(WITH)
        self.assertEqual(results.friction_force.dims, ("load", "shear_strength"))
        np.testing.assert_array_equal(results["load"], [1.5e-9, 2e-9, 3e-9])
        np.testing.assert_array_equal(results.friction_force.coords["radius"], [1e-8, 2e-8, 5e-8])
        self.assertEqual(results.radius.dims, ("load",))
        self.assertEqual(results.radius.attrs["units"], "m")
        self.assertEqual(results.attrs["dataset_radius"], "tips.csv:radius")
        self.assertEqual(len(results.attrs["checksum_load"]), 16)

    def test_cases(self):
        results = self.check_parts(CASES, "--virtual")
        self.assertEqual(results.friction_force.dims, ("shear_strength", "case"))
        np.testing.assert_array_equal(results.case, [1, 2, 3])
        np.testing.assert_array_equal(results.friction_force.coords["work_of_adhesion"], [0.05, 0.05, 0.02])
        self.assertEqual(results["load"].dims, ("case",))

    def test_sample(self):
        results = self.check_parts(SAMPLE)
        self.assertEqual(results.friction_force.dims, ("sample",))
        radii = np.sort(np.log10(results.friction_force.coords["radius"]))
        np.testing.assert_array_equal(np.floor((radii + 9)/3*40), np.arange(40))
        self.assertTrue(np.all((results["load"] >= 0) & (results["load"] <= 1e-8)))

    def test_refined(self):
        results = self.check_parts(REFINED)
        edge = float(results.pull_off_load[0])
        load, status = results["load"].values, results.status.values
        last = int(np.max(np.nonzero(status == 1)))
        self.assertTrue(load[last] < edge < load[last + 1])
        self.assertLess(load[last + 1] - load[last], 1e-6*4.8e-8)
        self.assertLess(load.size, 60)

    def test_uncertain(self):
        results = self.check_parts(UNCERTAIN.format(count=40))
        self.assertEqual(results.friction_force_by_radius.attrs["units"], "N/m")
        self.assertEqual(results.contact_area_by_load.attrs["units"], "m^2/N")
        self.assertEqual(results.friction_force_error.attrs["units"], "N")
        solved = results.status == 0
        for name in ("friction_force_by_load", "friction_force_error"):
            np.testing.assert_array_equal(np.isfinite(results[name]), solved)
        # the derivative leads from value to value
        load, force = results["load"].values, results.friction_force.values
        slope = results.friction_force_by_load.values
        rest = slice(20, None)
        np.testing.assert_allclose(np.diff(force)[rest], np.diff(load)[rest]*((slope[1:] + slope[:-1])/2)[rest], rtol=1e-3)

    def test_resume(self):
        # a run of samples of each point that is stopped, and goes on
        count = 200
        self.write(UNCERTAIN.format(count=count))
        self.run_program("run", "--quiet", "run.nml", "--output", "whole.h5")
        process = self.start("run", "--quiet", "run.nml", threads=1)
        if self.wait_for_points("run.h5.partial", process) > 0:
            process.send_signal(signal.SIGTERM)
        process.communicate(timeout=60)
        if (self.folder / "run.h5.partial").exists():
            self.check_truth("run.h5.partial", "whole.h5")
            self.run_program("run", "--quiet", "--resume", "run.nml")
        self.assert_same(self.snapshot("whole.h5"), self.snapshot("run.h5"))

    def test_other_design(self):
        # results of another design are none of this run
        self.write(UNCERTAIN.format(count=5))
        self.run_program("run", "--quiet", "run.nml")
        self.write(UNCERTAIN.format(count=5).replace("0.005", "0.006"))
        _, errors = self.run_program("run", "--resume", "run.nml", status=3)
        self.assertIn("it was made from another input", errors)

    def test_limit(self):
        self.write(REFINED.replace("tolerance", "limit = 20, tolerance"))
        _, errors = self.run_program("run", "run.nml", status=2)
        self.assertTrue(errors.startswith("run.nml: &refine limit: the refined sweep needs more values, given 20, allowed: "), errors)
        self.assertEqual(self.names(), ["run.nml", "tips.csv"])


if __name__ == "__main__":
    main()
