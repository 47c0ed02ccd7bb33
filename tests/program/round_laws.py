# SPDX-License-Identifier: GPL-3.0-or-later
"""Round bodies that laws of attraction draw: what a law is given by, bodies far apart and apart, and states beyond the end of a law."""

import math
import os
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from runs import SolverRuns, main  # noqa: E402

MODULUS, RADIUS, WORK, RANGE = 1e9, 1e-6, 0.05, 1e-9
BALL = f"&surface kind = 'paraboloid', radius = {RADIUS} /\n"
# checks make states ten times slower
IS_SLOW = float(os.environ.get("ADFRIC_RANDOM_CASES", "1")) < 1
# work over largest tension and range
RATIOS = {"van_der_waals": 1/2} if IS_SLOW else {"exponential": 1, "linear": 1/2, "van_der_waals": 1/2, "lennard_jones": 9*math.sqrt(3)/16}


def scene_of(law, operating, adhesion=f"work_of_adhesion = {WORK}, adhesion_range = {RANGE}", surface=BALL):
    """A scene of one state, or of a sweep."""
    return f"{surface}&solid contact_modulus = {MODULUS} /\n&adhesion law = '{law}', {adhesion} /\n{operating}"


class RoundLaws(SolverRuns):
    """Laws of attraction on round bodies."""

    solver = "attracted_indenter"

    def test_two_of_three(self):
        """Work, largest tension and range of a law: any two say the third."""
        for law, ratio in RATIOS.items():
            stress = WORK/(ratio*RANGE)
            loads = [self.solve(scene_of(law, "&operating approach = 1e-9 /\n", adhesion))["load"]
                     for adhesion in (f"work_of_adhesion = {WORK}, adhesion_range = {RANGE}",
                                      f"work_of_adhesion = {WORK}, adhesion_stress = {stress!r}",
                                      f"adhesion_stress = {stress!r}, adhesion_range = {RANGE}")]
            np.testing.assert_allclose(loads, loads[0], rtol=1e-9, err_msg=law)

    def test_rigid(self):
        """Far apart the load is 2 pi R times the work that is left, by approach and by load."""
        found = self.solve(scene_of("van_der_waals", "&sweep variable = 'approach', values = -3e-8, -1e-7, -3e-7 /\n"))
        gap = found["central_gap"]
        np.testing.assert_allclose(found["load"], -2*math.pi*RADIUS*WORK/(1 + gap/RANGE)**2, rtol=1e-3)
        found = self.solve(scene_of("van_der_waals", "&operating load = -1e-11, branch = 'unstable' /\n"))
        right = RANGE*(math.sqrt(2*math.pi*RADIUS*WORK/1e-11) - 1)
        self.assertAlmostEqual(found["central_gap"]/right, 1, delta=1e-3)

    def test_far_apart(self):
        """A tension that falls exponentially is none in the end; on the way to there loads fall."""
        found = self.solve(scene_of("exponential", "&sweep variable = 'approach', values = -1e-6, -3.1e-7, -2.9e-7, -1e-7, -1e-8 /\n"))
        self.assertEqual(list(found["load"][:2]), [0, 0])
        self.assertTrue(np.all(np.diff(found["load"][1:]) < 0))
        np.testing.assert_allclose(found["central_gap"][:4], [1e-6, 3.1e-7, 2.9e-7, 1e-7], rtol=1e-12)

    def test_beyond_the_end(self):
        """Beyond the end of a law bodies may be apart, or still in contact, up to pull-off; a state by its approach and by its load is one."""
        law = "work_of_adhesion = 0.05, adhesion_stress = 3e8"
        end = 2*0.05/3e8
        for approach in (-3*end,) if IS_SLOW else (-0.9*end, -1.1*end, -3*end):
            adhered = self.solve(scene_of("linear", f"&operating approach = {approach!r} /\n", law))
            self.assertGreater(adhered["contact_radius"], 0)
            self.assertGreater(approach, adhered["pull_off_approach"])
            again = self.solve(scene_of("linear", f"&operating load = {float(adhered['load'])!r} /\n", law))
            self.assertAlmostEqual(float(again["approach"])/approach, 1, delta=1e-3)
        for approach in (-1.1*end,) if IS_SLOW else (-1.1*end, -3*end):
            apart = self.solve(scene_of("linear", f"&operating approach = {approach!r}, branch = 'inner' /\n"
                                        "&output profiles = .true., r_max = 3e-7, n_r = 4 /\n", law))
            self.assertEqual([apart["load"], apart["contact_radius"]], [0, 0])
            np.testing.assert_array_equal(apart["pressure"], 0)
            np.testing.assert_allclose(apart["gap"], -approach + apart["r"]**2/(2*RADIUS), rtol=1e-12)
        apart = self.solve(scene_of("linear", f"&operating approach = {2*float(adhered['pull_off_approach'])!r} /\n", law))
        self.assertEqual([apart["load"], apart["contact_radius"]], [0, 0])

    def test_next_to_the_end(self):
        """Bodies that just feel each other are next to apart: the load falls to 0 as the law ends."""
        law = "work_of_adhesion = 0.05, adhesion_stress = 1e8"
        parts = (0.9985, 0.9991, 0.9999, 0.999999, 1)
        values = ", ".join(repr(-1e-9*part) for part in parts)
        found = self.solve(scene_of("linear", f"&operating branch = 'inner' /\n&sweep variable = 'approach', values = {values} /\n", law))
        np.testing.assert_array_equal(found["contact_radius"], 0)
        self.assertTrue(np.all(np.diff(found["load"]) > 0))
        self.assertEqual(found["load"][-1], 0)

    def test_energy_of_a_cone(self):
        """What attracts far away has no bound on a cone where the tension falls as the third power; an exponential one has energy."""
        cone = "&surface kind = 'cone', slope = 0.05 /\n"
        law = "work_of_adhesion = 0.05, adhesion_stress = 2e7"
        found = self.solve(scene_of("van_der_waals", "&operating approach = 3e-9 /\n", law, cone))
        self.assertTrue(np.isnan(found["adhesion_energy"]))
        found = self.solve(scene_of("exponential", "&operating approach = 3e-9 /\n", law, cone))
        self.assertLess(found["adhesion_energy"], 0)

    def test_zeros_at_the_end(self):
        """A table may go on with zeros: they say nothing."""
        rows = "0, 5e7\n1e-9, 1e7\n3e-9, 0\n"
        found = []
        for more in ("", "3.5e-9, 0\n4e-9, 0\n"):
            (self.folder/"law.csv").write_text("gap, tension\n" + rows + more)
            found.append(self.solve(scene_of("table", "&operating load = 0 /\n", "tension_table = 'law.csv'"))["approach"])
        self.assertEqual(found[0], found[1])


if __name__ == "__main__":
    main()
