# SPDX-License-Identifier: GPL-3.0-or-later
"""Results files as other programs read them: the CF conventions by compliance-checker, units by pint-xarray.

These packages stand in an environment of their own (scripts/setup tests), with whose Python this file starts itself again.
"""

import json
import os
import sys
from pathlib import Path

PYTHON = Path(os.environ["ADFRIC_SOURCE"]) / ".venv_tests/bin/python"
# see tests/CMakeLists.txt
ALL_SKIPPED = 77

if Path(sys.executable) != PYTHON:
    if not PYTHON.exists():
        print(f"skipped: there is no {PYTHON}: scripts/setup tests could not install compliance-checker and pint-xarray")
        sys.exit(ALL_SKIPPED)
    os.execv(PYTHON, [str(PYTHON), *sys.argv])

import unittest

import h5py
import numpy as np
import pint_xarray  # noqa: F401
import xarray as xr
from compliance_checker.runner import CheckSuite, ComplianceChecker

from runs import Runs, main

CHECKS = "cf:1.11"
WAVY = """
&job model = 'wavy_sliding', title = 'A wave', output = 'run.h5' /
&foundation young_modulus = 7.5e4, poisson_ratio = 0.5, thickness = 1e-3, relaxation_time = 1e-3, retardation_ratio = 10 /
&adhesion surface_energy = 0.02 /
&operating velocity = 0.5 /
&sweep variable = 'stress', values = 1e3, 2e3 /
&sweep variable = 'penetration', values = 2e-5, 8e-5, 9e-4 /
"""
SPHERE = "&job model = 'sphere', title = 'A tip', output = 'run.h5' /\n"
TIP = SPHERE + """
&sphere radius = 140e-9, young_modulus = 56e9, poisson_ratio = 0.2, work_of_adhesion = 0.19, adhesion_stress = 1e9 /
&friction shear_strength = 0.96e9, poisson_ratio = 0.2, interaction = 0.2, critical_slip = 0.2e-9 /
"""
SLIDING = "&operating state = 'sliding'{} /\n"
SOLID = "&solid contact_modulus = 1e9 /\n"
CASES = {
    "wave in two dimensions": WAVY + "&surface kind = 'wave_2d', period = 1e-2, height = 1e-4 /\n",
    "wave in three dimensions, with profiles": WAVY + """
&surface kind = 'wave_3d', period = 1e-2, height = 1e-4 /
&output profiles = .true., n_x = 9, n_y = 5 /
""",
    "tip under loads": TIP + SLIDING.format("") + "&sweep variable = 'load', values = -1e-6, 0, 1e-7 /\n",
    "tip, one point": TIP + SLIDING.format(", load = 0"),
    "sphere in reduced units, with events": SPHERE + """
&sphere units = 'reduced', lambda = 0.8 /
&friction shear_strength = 0.8, poisson_ratio = 0.3, interaction = 0.4, slip_energy_ratio = 1.0 /
&operating load = 0.0 /
&output events = .true., profiles = .true., n_r = 11, r_max = 3.0 /
&sweep variable = 'tangential_displacement', values = 0.0, 1.0 /
""",
    "Hertz, one point": "&job model = 'hertz', output = 'run.h5' /\n" + SOLID + """
&contact kind = 'circular', radius = 1e-2 /
&operating load = 1.0 /
""",
    "line load, with maps": """
&job model = 'line_load', output = 'run.h5' /
&operating normal_load = 1.0, tangential_load = 0.5 /
&solid young_modulus = 1.0, poisson_ratio = 0.3 /
&position position_x = 0.1, position_y = 1.0 /
&output profiles = .true., x_min = -1, x_max = 1, n_x = 5, y_min = 0.1, y_max = 1, n_y = 4 /
""",
    "load of a line, swept": "&job model = 'hertz', output = 'run.h5' /\n" + SOLID + """
&contact kind = 'line', radius = 1e-2 /
&sweep variable = 'load', values = 1.0, 2.0 /
""",
    "periodic wave, with maps": "&job model = 'wave_2d_elastic', output = 'run.h5' /\n" + SOLID + """
&surface period = 1e-3, amplitude = 1e-6 /
&numerics cells = 64 /
&output profiles = .true. /
&sweep variable = 'mean_pressure', values = 1e5, 1e6 /
""",
    "surface from a file": "&job model = 'surface_elastic', output = 'run.h5' /\n" + SOLID + """
&surface heights = 'heights.h5:/heights', length_x = 1e-3, length_y = 1e-3 /
&sweep variable = 'mean_pressure', values = 0, 1e5, 1e6 /
""",
}


class Conventions(Runs):
    """Every kind of file."""

    def solve(self, text):
        """Run an input."""
        with h5py.File(self.folder / "heights.h5", "w") as file:
            x = 2 * np.pi * np.arange(16) / 16
            file["heights"] = 1e-6 * (np.cos(x)[:, None] + np.cos(x))
        self.write(text)
        self.run_program("run", "--quiet", "--force", "run.nml")

    def assert_clean(self, name):
        """No remark of the checker on a file."""
        # the checker knows files by their endings
        copy, report = self.folder / "run.nc", self.folder / "report.json"
        copy.write_bytes((self.folder / name).read_bytes())
        ComplianceChecker.run_checker(str(copy), [CHECKS], 0, "strict", output_filename=str(report), output_format="json")
        found = json.loads(report.read_text())[CHECKS]
        remarks = [f"{check['name']}: {message}" for check in found["all_priorities"] for message in check["msgs"]]
        # CF takes each coordinate with a unit of pressure for a height, and would have heights behind all other dimensions; here
        # the dimensions stand as the user has ordered the sweeps
        with h5py.File(copy) as file:
            pressures = [scale[0].name[1:] for scale in file["status"].dims if scale[0].attrs["units"] == "Pa"]
        if pressures:
            remarks = [text for text in remarks if not (text.startswith("§2.4 Dimensions: ") and f"{pressures[0]} (Z)" in text)]
        else:
            self.assertEqual(found["scored_points"], found["possible_points"])
        self.assertEqual(remarks, [])
        self.assertGreater(found["possible_points"], 10)

    def test_cf(self):
        CheckSuite.load_all_available_checkers()
        for name, text in CASES.items():
            with self.subTest(name=name):
                self.solve(text)
                self.assert_clean("run.h5")

    def test_cf_of_merged_parts(self):
        CheckSuite.load_all_available_checkers()
        self.write(CASES["tip under loads"])
        for number in (1, 2):
            self.run_program("run", "--quiet", "--shard", f"{number}/2", "run.nml")
        self.run_program("merge", "--quiet", "run.h5", "run.part-0001-of-0002.h5", "run.part-0002-of-0002.h5")
        self.assert_clean("run.h5")
        with h5py.File(self.folder / "run.h5") as file:
            self.assertEqual([line.split()[-1] for line in file.attrs["history"].splitlines()], ["run", "merge"])

    def test_units(self):
        for name, text in CASES.items():
            with self.subTest(name=name):
                self.solve(text)
                with xr.open_dataset(self.folder / "run.h5", engine="h5netcdf") as results:
                    results = results.load()
                quantified = results.pint.quantify()
                for key, variable in results.variables.items():
                    self.assertIn("units", variable.attrs, key)
                    if key not in results.indexes:
                        self.assertIsNotNone(quantified[key].pint.units, key)

    def test_parameters_are_coordinates(self):
        self.solve(CASES["tip under loads"])
        with xr.open_dataset(self.folder / "run.h5", engine="h5netcdf") as results:
            results = results.load()
        tip = results.pint.quantify()
        self.assertAlmostEqual(tip.coords["radius"].pint.to("nm").item().magnitude, 140.0)
        # given, by default, derived
        self.assertEqual(tip.coords["sphere_poisson_ratio"].item().magnitude, 0.2)
        self.assertEqual(tip.coords["edge_fraction"].item().magnitude, 0.4)
        modulus = 56e9 / (1 - 0.2**2)
        self.assertAlmostEqual(tip.coords["contact_modulus"].pint.to("GPa").item().magnitude, 1e-9 * modulus)
        expected = 2 * 1e9 * (9 * 140e-9 / (16 * np.pi * 0.19 * modulus**2)) ** (1 / 3)
        self.assertAlmostEqual(tip.coords["lambda"].item().magnitude, expected)
        words = results.coords["state"].attrs["flag_meanings"].split()
        self.assertEqual(words[int(results.coords["state"]) - 1], "sliding")
        # what is swept is an axis, and what is not given has no value
        self.assertEqual(results["load"].dims, ("load",))
        self.assertNotIn("operating_load", results)
        self.assertNotIn("approach", results.coords)
        force = tip["friction_force"].isel({"load": 1}).pint.to("nN").item().magnitude
        area = tip["friction_area"].isel({"load": 1}).pint.to("nm^2").item().magnitude
        self.assertAlmostEqual(force, 0.96 * area, places=6)


if __name__ == "__main__":
    main()
