# SPDX-License-Identifier: GPL-3.0-or-later
"""A cylinder that rolls, against cells that carry constant tractions, and Hertz's contacts by what stands in place of a load."""

import sys
import unittest
from pathlib import Path

import h5py
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from runs import Runs, main  # noqa: E402

FRICTION, RADIUS, MODULUS, LOAD = 0.3, 0.46, 1.14e11, 1.3e7
HALF_WIDTH = np.sqrt(4*LOAD*RADIUS/(np.pi*MODULUS))
WHEEL = f"""&job output = 'run.h5' /
&surface kind = 'cylinder', radius = {RADIUS} /
&solid contact_modulus = {MODULUS} /
&friction coulomb_coefficient = {FRICTION} /
"""
BODIES = {"cylinder": ("radius = 1e-2", "contact_half_width"), "paraboloid": ("radius = 1e-2", "contact_radius"),
          "ellipsoid": ("radius_1x = 1e-2, radius_1y = 1e-3", "major_half_width")}


def rolling_of_cells(n, creepage):
    """Force of steady rolling on n cells. What a cell carries goes from one to the next; no closed form is used."""
    width = 2*HALF_WIDTH/n
    x = -HALF_WIDTH + width*(np.arange(n) + 0.5)
    bound = FRICTION*2*LOAD/(np.pi*HALF_WIDTH)*np.sqrt(1 - (x/HALF_WIDTH)**2)

    def displacement(distance):
        """Of a cell with a traction of 1 Pa, up to a constant."""
        ends = distance[..., None] + width/2*np.array([1.0, -1.0])
        return -2/(np.pi*MODULUS)*np.subtract(*np.moveaxis(ends*np.log(np.abs(ends)), -1, 0))

    apart = x[:, None] - x[None, :]
    slope = (displacement(apart + width) - displacement(apart))/width
    sticks = np.ones(n, bool)
    for _ in range(50):
        traction = bound.copy()
        traction[sticks] = np.linalg.solve(slope[np.ix_(sticks, sticks)], -creepage - slope[np.ix_(sticks, ~sticks)] @ bound[~sticks])
        now = np.where(sticks, traction <= bound, creepage + slope @ traction < 0)
        if (now == sticks).all():
            return traction.sum()*width
        sticks = now
    raise AssertionError("the cells do not settle")


class Rolling(Runs):
    def solve(self, text):
        """Results of a scene."""
        self.write(text)
        self.run_program("run", "--quiet", "--force", "run.nml")
        with h5py.File(self.folder/"run.h5") as file:
            self.assertFalse(file["status"][()].any())
            return {key: data[()] for key, data in file.items() if isinstance(data, h5py.Dataset)}, file.attrs["model"]

    def test_cells(self):
        """The error of cells falls with their width; without that of first order the force is that of the closed form."""
        full = FRICTION*HALF_WIDTH/RADIUS
        shares = np.array([0.1, 0.5, 0.9])
        found, solver = self.solve(WHEEL + f"&operating load = {LOAD}, state = 'rolling' /\n&sweep variable = 'creepage', values = "
                                   + ", ".join(repr(float(share*full)) for share in shares) + " /\n")
        self.assertEqual(solver, "hertz")
        for share, force in zip(shares, found["tangential_force"]):
            coarse, fine = (rolling_of_cells(n, share*full)/force - 1 for n in (100, 200))
            self.assertLess(abs(coarse), 0.01)
            self.assertLess(abs(2*fine - coarse), 1e-4)

    def test_profiles(self):
        """What slips carries mu p, behind what sticks; the sum of the shear stress is the force, and that with slip the loss."""
        found, _ = self.solve(WHEEL + "&operating peak_pressure = 1e9, tangential_force = -2e6, state = 'rolling' /\n"
                              "&output profiles = .true., x_min = -0.009, x_max = 0.009, n_x = 4001 /\n")
        x, pressure, shear, slip = (np.squeeze(found[name]) for name in ("x", "pressure", "shear_stress", "slip_ratio"))
        self.assertNotIn("contact_shift", found)
        self.assertTrue(np.all(shear <= 0) and np.all(slip <= 0))
        np.testing.assert_allclose(shear[slip < 0], -FRICTION*pressure[slip < 0], rtol=1e-9)
        self.assertLess(x[slip < 0].max(), x[(slip == 0) & (pressure > 0)].min())
        self.assertAlmostEqual(shear.sum()*(x[1] - x[0])/found["tangential_force"][()].item(), 1, delta=1e-3)
        self.assertAlmostEqual((shear*slip).sum()*(x[1] - x[0])/found["dissipation"][()].item(), 1, delta=1e-3)

    def test_in_place_of_a_load(self):
        """The largest pressure or the half-width of a state gives back its load, in scenes."""
        for kind, (sizes, width) in BODIES.items():
            scene = f"&job output = 'run.h5' /\n&surface kind = '{kind}', {sizes} /\n&solid young_modulus = 2.1e11, poisson_ratio = 0.3 /\n"
            by_pressure, solver = self.solve(scene + "&operating peak_pressure = 1e9 /\n")
            self.assertEqual(solver, "hertz", kind)
            by_width, _ = self.solve(scene + f"&operating {width} = {by_pressure[width].item()!r} /\n")
            np.testing.assert_allclose(by_width["load"], by_pressure["load"], rtol=1e-13)

    def test_refusals(self):
        """Bodies that do not roll, rolling without friction, and what a solid that relaxes cannot have."""
        rubber = "&job output = 'run.h5' /\n&surface kind = 'cylinder', radius = 1e-2 /\n&solid modulus = 1e7, moduli = 9e7, relaxation_times = 1e-3 /\n"
        for text, message in (
                (WHEEL.replace("cylinder", "paraboloid") + "&operating load = 1, tangential_force = 0.1, state = 'rolling' /\n", "nothing solves"),
                (WHEEL + "&operating load = 1, creepage = 1e-3 /\n", "&operating creepage"),
                (WHEEL + "&operating load = 1, state = 'rolling' /\n", "&operating tangential_force: is missing; one of tangential_force or creepage"),
                (WHEEL + "&operating load = 1, state = 'rolling', creepage = 1e-3, velocity = 1.0 /\n", "&operating velocity"),
                (rubber + "&operating load = 1, state = 'rolling', creepage = 1e-3, velocity = 1.0 /\n", "&operating creepage"),
                (rubber + "&operating peak_pressure = 1e5, velocity = 1.0 /\n", "&operating peak_pressure")):
            self.write(text)
            _, errors = self.run_program("check", "run.nml", status=2)
            self.assertIn(message, errors)
            self.assertEqual(1, len(errors.splitlines()), errors)
        # over a solid that relaxes rolling without friction is sliding
        rolls, slides = (self.solve(rubber + f"&operating load = 100, velocity = 0.1{more} /\n")[0] for more in (", state = 'rolling'", ""))
        self.assertEqual(rolls["friction_force"], slides["friction_force"])


if __name__ == "__main__":
    main()
