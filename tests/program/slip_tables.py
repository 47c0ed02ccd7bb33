# SPDX-License-Identifier: GPL-3.0-or-later
"""Partial slip of a rough surface against tables that were solved otherwise, by two contacts and by the true direction of slip."""

import csv
import os
import sys
import unittest
from pathlib import Path

import h5py
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from input_runs import InputRuns  # noqa: E402

REFERENCE = Path(os.environ["ADFRIC_SOURCE"]) / "tests/reference"
PRESSURE, COEFFICIENT = 0.02, 0.3
CASE = """
&job model = 'surface_elastic', output = 'run.h5' /
&surface heights = '{heights}:/heights', length_x = 1.0, length_y = 1.0 /
&solid contact_modulus = 1.0, poisson_ratio = {nu} /
&friction coefficient = {mu} /
&operating mean_pressure = {pressure} /
&sweep variable = 'tangential_stress', values = {stresses} /
&numerics relative_tolerance = 1e-13 /
&output profiles = .true. /
"""


def table(name):
    with open(REFERENCE / f"{name}.csv") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    return [{key: float(value) for key, value in row.items()} for row in rows]


class SlipTables(InputRuns):
    def solve_table(self, nu, shares):
        """Results for shares of the force that friction can hold."""
        stresses = ", ".join(repr(COEFFICIENT * PRESSURE * share) for share in shares)
        self.write(CASE.format(heights=REFERENCE / "slip_rough_heights.h5", nu=nu, mu=COEFFICIENT, pressure=PRESSURE, stresses=stresses))
        self.run_program("run", "--quiet", "--force", "run.nml")
        with h5py.File(self.folder / "run.h5") as file:
            names = ("status", "tangential_displacement", "cycle_energy", "poisson_defect", "pressure", "shear_stress")
            return {name: file[name][...] for name in names}

    def test_displacement(self):
        """Displacement and cells that stick; the force of the true direction of slip differs by about the square of the defect."""
        rows = table("slip_rough")
        self.assertGreater(len(rows), 5)
        for row in rows:
            with self.subTest(row=row):
                found = self.solve_table(row["nu"], [1 - row["pstar_over_p"]])
                self.assertEqual(found["status"][0], 0)
                np.testing.assert_allclose(found["tangential_displacement"][0], row["u_difference"], rtol=1e-11)
                rest = found["pressure"] - found["shear_stress"] / COEFFICIENT
                top = found["pressure"].max()
                share = np.count_nonzero(rest > 1e-9 * top) / np.count_nonzero(found["pressure"] > 0)
                self.assertAlmostEqual(share, row["stick_fraction_difference"], delta=1e-9)
                force = row["T_over_mup_direct"] / row["T_over_mup_difference"] - 1
                self.assertLess(abs(force), 1.2 * found["poisson_defect"][0] ** 2 + 1e-9)

    def test_energy(self):
        """The energy of a cycle, by both forms."""
        rows = table("slip_rough_cycle")
        self.assertGreater(len(rows), 1)
        found = self.solve_table(0.0, [1 - row["pstar_over_p"] for row in rows])
        for energy, row in zip(found["cycle_energy"], rows):
            np.testing.assert_allclose(energy, row["W_gap"], rtol=1e-10)
            np.testing.assert_allclose(energy, row["W_direct"], rtol=1e-10)
            np.testing.assert_allclose(energy, row["W_chord"], rtol=1e-4)

    def check_input(self, name, **changes):
        """A shipped input up to the largest force that friction holds: less and less sticks, and more is lost."""
        found = self.solve(name, **changes)
        sticks, energy, stiffness = (found[key][0] for key in ("stick_fraction", "friction_loss_per_cycle", "tangential_stiffness"))
        self.assertEqual((sticks[0], sticks[-1]), (1, 0))
        self.assertTrue(np.all(np.diff(sticks) < 0))
        self.assertTrue(np.all(np.diff(energy) > 0))
        self.assertTrue(np.all(np.diff(stiffness) < 0))
        return found

    def test_inputs(self):
        self.check_input("hertz_slip", **{"0.2, 0.4": "0.4"})
        self.check_input("wave_1d_slip", **{"0.031416e9, 0.157e9, 0.3141e9": "0.3141e9"})

    def test_rough_input(self):
        self.make_surface("surface_slip", 64)
        found = self.check_input("surface_slip", **{"4.0e6, 1.6e7": "1.6e7", "count = 61": "count = 7"})
        self.assertTrue(np.all(found["poisson_defect"][0, 1:-1] > 0))


if __name__ == "__main__":
    unittest.main()
