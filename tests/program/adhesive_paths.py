# SPDX-License-Identifier: GPL-3.0-or-later
"""Round contacts with adhesion along a path: closed forms of JKR, balance of work and energy, springs, loads, turning points, the
solver of single states, other units, and what is refused."""

import math
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from runs import SolverRuns, main  # noqa: E402

MODULUS, RADIUS, WORK = 1e9, 1e-6, 0.05
BALL = f"&surface kind = 'paraboloid', radius = {RADIUS} /\n"
SURFACES = (BALL, f"&surface kind = 'sphere', radius = {RADIUS} /\n", "&surface kind = 'cone', slope = 0.1 /\n",
            "&surface kind = 'power', exponent = 4.0, power_coefficient = 1e17 /\n",
            "&surface kind = 'rounded_cone', slope = 0.3, radius = 2e-7 /\n",
            "&surface kind = 'flat_paraboloid', face_radius = 3e-8, radius = 1e-6 /\n",
            "&surface kind = 'polynomial', coefficient_2 = 5e5, coefficient_4 = 1e17 /\n")
# without a range (JKR), a long one, and a short one
RANGES = ("", ", adhesion_stress = 2e7", ", adhesion_stress = 2e8")


def scene_of(history, surface=BALL, opening=None, more=""):
    """A scene with a path."""
    words = "" if opening is None else f", opening_work_of_adhesion = {opening}"
    return f"{surface}&solid contact_modulus = {MODULUS} /\n&adhesion work_of_adhesion = {WORK}{words}{more} /\n{history}"


def list_of(name, values, more=""):
    """A path by a list."""
    return f"&history {name} = {', '.join(repr(float(value)) for value in values)} /\n{more}"


class AdhesivePaths(SolverRuns):
    """Paths of round contacts with adhesion."""

    solver = "adhesive_indenter_history"

    def test_closed_forms(self):
        """JKR: jump in at first touch, least load and last state of the work of opening, and the loss of the cycle."""
        for opening in (WORK, 2*WORK):
            found = self.solve(scene_of(list_of("approaches", (2e-8, -3e-8)), opening=opening))
            self.assertAlmostEqual(found["jump_in_load"]/(-4/3*math.pi*WORK*RADIUS), 1, delta=1e-12)
            self.assertEqual(found["jump_in_base_approach"], 0)
            self.assertAlmostEqual(found["least_load"]/(-1.5*math.pi*opening*RADIUS), 1, delta=1e-12)
            self.assertAlmostEqual(found["pull_off_load"]/(-5/6*math.pi*opening*RADIUS), 1, delta=1e-12)
            # the last state has 3 pi w R^2/E* under 8 a^3: a g' = Dl/2
            last = (math.pi*opening*RADIUS**2/(8*MODULUS))**(1/3)
            self.assertAlmostEqual(found["pull_off_approach"]/(-3*last**2/RADIUS), 1, delta=1e-12)
            self.assertEqual(found["jumps"], 2)

    def test_edge_that_stays(self):
        """On turning, load follows approach like a flat punch, up to the work of opening."""
        top = 2e-8
        steps = np.linspace(top, -1e-8, 301)
        found = self.solve(scene_of(list_of("approaches", (top, *steps)), opening=3*WORK))
        a, load = found["contact_radius"][1:], found["load"][1:]
        stays = a == a[0]
        self.assertGreater(stays.sum(), 20)
        np.testing.assert_allclose(np.diff(load[stays])/np.diff(steps[stays]), 2*a[0]*MODULUS, rtol=1e-9)
        # the first that moves has the depth of the work of opening
        depth = steps[stays][-1] - a[0]**2/RADIUS
        limit = -math.sqrt(2*math.pi*3*WORK*a[0]/MODULUS)
        self.assertTrue(limit <= depth <= limit + 1.1e-10)

    def test_balance(self):
        """Over a closed path the work done is what jumps and opening have taken, for every shape and range."""
        for surface in SURFACES:
            for more in RANGES:
                for opening in (WORK, 1.7*WORK):
                    self.check_balance(surface, more, opening)

    def check_balance(self, surface, more, opening):
        first = self.solve(scene_of(list_of("approaches", (2e-8, -1e-7)), surface, opening, more))
        up = np.linspace(-1e-8, 2e-8, 1500)
        down = np.linspace(2e-8, -1e-7, 6000)
        start, end = first["jump_in_base_approach"], first["pull_off_approach"]
        if np.isfinite(start):
            up = np.sort(np.append(up, (start - 1e-16, start + 1e-16)))
        down = np.sort(np.append(down, (end - 1e-16, end + 1e-16)))[::-1]
        path = np.concatenate((up, np.linspace(2e-8, 5e-9, 800), np.linspace(5e-9, 2e-8, 800), down))
        found = self.solve(scene_of(list_of("approaches", path), surface, opening, more))
        label = (surface, more, opening)
        work = np.sum(np.diff(path)*(found["load"][1:] + found["load"][:-1])/2)
        self.assertEqual(found["load"][0], 0, label)
        self.assertEqual(found["load"][-1], 0, label)
        self.assertLess(abs(work - found["dissipated_energy"]), 2e-3*found["dissipated_energy"] + 1e-6*np.max(np.abs(found["load"]))*1e-8, label)
        # what has been taken never falls
        self.assertGreaterEqual(np.min(np.diff(found["adhesion_loss"])), -1e-12*found["dissipated_energy"], label)

    def test_states(self):
        """Without hysteresis retraction has the largest stable states of the solver of single ones, and approach the smallest."""
        for surface in SURFACES[1:]:
            for more in RANGES:
                steps = np.linspace(2e-8, 1e-9, 12)
                down = self.solve(scene_of(list_of("approaches", (2e-8, *steps)), surface, None, more))
                up = self.solve(scene_of(list_of("approaches", steps[::-1]), surface, None, more))
                for k, approach in enumerate(steps):
                    for branch, found, at in (("stable", down, k + 1), ("inner", up, len(steps) - 1 - k)):
                        operation = f"&operating approach = {float(approach)!r}, branch = '{branch}' /\n"
                        single, _ = self.run_scene(scene_of(operation, surface, None, more))
                        if np.isnan(single["load"]) or found["contact_radius"][at] == 0:
                            continue
                        self.assertAlmostEqual(found["load"][at]/single["load"], 1, delta=1e-9, msg=(surface, more, approach, branch))

    def test_springs(self):
        """A soft spring lets go at the least load, a stiff one at the last state of a given approach; the base is approach + load/k."""
        soft = self.solve(scene_of(list_of("base_approaches", (1e-4, -1e-4), "&operating machine_stiffness = 0.1 /\n"), opening=2*WORK))
        self.assertAlmostEqual(soft["pull_off_load"]/soft["least_load"], 1, delta=1e-5)
        self.assertAlmostEqual(soft["least_load"]/(-3*math.pi*WORK*RADIUS), 1, delta=1e-5)
        stiff = self.solve(scene_of(list_of("base_approaches", (1e-8, -1e-7), "&operating machine_stiffness = 1e9 /\n"), opening=2*WORK))
        self.assertAlmostEqual(stiff["pull_off_load"]/(-5/3*math.pi*WORK*RADIUS), 1, delta=1e-3)
        for more in RANGES:
            base = np.array([1e-8, 2e-7, 1e-7, 0.0, -5e-9, -1e-8, 2e-8, -1e-6])
            found = self.solve(scene_of(list_of("base_approaches", base, "&operating machine_stiffness = 10.0 /\n"), opening=2*WORK, more=more))
            np.testing.assert_allclose(found["approach"] + found["load"]/10.0, base, rtol=1e-12, atol=1e-20)
            self.assertAlmostEqual(found["pull_off_base_approach"], found["pull_off_approach"] + found["pull_off_load"]/10.0, delta=1e-18)

    def test_loads(self):
        """Under a load bodies part at the least load, carry none below 0 afterwards, and come together again."""
        loads = (1e-6, 0.0, -4e-7, -6e-7, -1e-7, 1e-7)
        found = self.solve(scene_of(list_of("loads", loads), opening=2*WORK))
        self.assertTrue(np.isnan(found["load"][3]) and np.isnan(found["load"][4]))
        self.assertEqual(list(found["load"][[0, 1, 2, 5]]), [1e-6, 0.0, -4e-7, 1e-7])
        self.assertAlmostEqual(found["pull_off_load"]/(-3*math.pi*WORK*RADIUS), 1, delta=1e-12)
        self.assertTrue(np.isnan(found["dissipated_energy"]))
        again = self.solve(scene_of(list_of("loads", (1e-7,)), opening=2*WORK))
        self.assertEqual(found["contact_radius"][5], again["contact_radius"])

    def test_turning_points(self):
        """A path knows its turning points alone."""
        turns = (1.5e-8, 3e-9, 1e-8, -1e-9, 2e-8, 1e-8)
        for more in RANGES:
            coarse = self.solve(scene_of(list_of("approaches", turns), opening=2*WORK, more=more))
            fine = np.concatenate([np.linspace(*pair, 41)[1:] for pair in zip((0.0, *turns), turns)])
            found = self.solve(scene_of(list_of("approaches", fine), opening=2*WORK, more=more))
            for name in ("load", "contact_radius", "adhesion_radius", "adhesion_loss"):
                np.testing.assert_allclose(found[name][39::40], coarse[name], rtol=1e-9, err_msg=name)

    def test_narrow_zone(self):
        """A large stress is JKR, with hysteresis as well."""
        path = list_of("approaches", (2e-8, 1e-8, 0.0, 1.5e-8, -2e-8))
        jkr = self.solve(scene_of(path, opening=2*WORK))
        found = self.solve(scene_of(path, opening=2*WORK, more=", adhesion_stress = 1e11"))
        for name in ("load", "contact_radius", "adhesion_loss"):
            np.testing.assert_allclose(found[name], jkr[name], rtol=1e-3, err_msg=name)

    def test_corner(self):
        """A contact beside the corner of its flat face has all digits of its load, though its radius has none of what it is beyond."""
        surface = "&surface kind = 'flat_paraboloid', face_radius = 3.1539008715394582e-6, radius = {} /\n"
        solid = ("&solid young_modulus = 1.6376769073274173e5, poisson_ratio = -0.53448919019013197 /\n"
                 "&adhesion work_of_adhesion = 4.359430850187325e-4, adhesion_range = 5.1901488113709939e-7, "
                 "opening_work_of_adhesion = 4.8860129400927002e-4 /\n")
        spring = "&operating machine_stiffness = 2.9151131405453606e-4 /\n"
        base = -np.array([7.220337925915933e-11, 6.351613479062238e-10, 1.6850466920767759e-9, 3.080066578425058e-9, 4.631815841227695e-9,
                          6.130722144003692e-9, 7.374349884836609e-9, 8.194740246147748e-9, 8.481094963702124e-9, 8.194740246147748e-9,
                          3.080066578425058e-9])
        # the first one had 2 digits when radii were unknowns
        for radius in (1e-11, 1e-9, 1e-6, 1e-3):
            loads = [self.solve(surface.format(radius) + solid + list_of("base_approaches", base*factor, spring))["load"]
                     for factor in (1, 1 + 1e-12, 1 - 1e-12)]
            for other in loads[1:]:
                np.testing.assert_allclose(other, loads[0], rtol=1e-9, err_msg=radius)

    def test_units(self):
        """Lengths in another unit: loads, radii and energies go with it."""
        factor = 1e3
        for more in RANGES:
            path = np.array([2e-8, 1e-8, 0.0, 1.5e-8, -2e-8])
            found = self.solve(scene_of(list_of("approaches", path), opening=2*WORK, more=more))
            surface = BALL.replace(str(RADIUS), str(RADIUS*factor))
            text = scene_of(list_of("approaches", path*factor), surface, 2*WORK, more).replace(f"= {WORK},", f"= {WORK*factor},")
            other = self.solve(text.replace(f"opening_work_of_adhesion = {2*WORK}", f"opening_work_of_adhesion = {2*WORK*factor}"))
            for name, power in (("load", 2), ("contact_radius", 1), ("adhesion_loss", 3), ("pull_off_load", 2)):
                np.testing.assert_allclose(other[name], found[name]*factor**power, rtol=1e-9, err_msg=name)

    def test_refusals(self):
        """Bad input ends in one line."""
        path = list_of("approaches", (1e-8, -1e-8))
        flat = "&surface kind = 'flat_punch', face_radius = 1e-7 /\n"
        for text, words in ((scene_of(path, opening=0.5*WORK), "is below work_of_adhesion"),
                            (scene_of(path, flat), "flat_punch"),
                            (scene_of(list_of("base_approaches", (1e-8, 0.0))), "machine_stiffness"),
                            (scene_of(path + "&operating machine_stiffness = 1.0 /\n"), "base_approaches"),
                            (scene_of("&history approaches = 1e-8, loads = 1e-8 /\n"), "give one"),
                            (scene_of("&operating approach = 1e-8 /\n", opening=2*WORK), "opening_work_of_adhesion"),
                            (scene_of(list_of("approaches", (1e200,))), "&history"),
                            (scene_of(path).replace(f"= {WORK}", "= 0.0"), "is 0")):
            self.refuse(text, words)

    def test_threads(self):
        """Points of a sweep are the same for any number of threads."""
        text = scene_of(list_of("approaches", (2e-8, -2e-8)), more=", adhesion_stress = 2e7")
        self.write("&job output = 'run.h5' /\n" + text + "&sweep variable = 'opening_work_of_adhesion', from = 0.06, to = 0.2, count = 24 /\n")
        found = []
        for threads in (1, 2):
            self.run_program("run", "--quiet", "--force", "run.nml", threads=threads)
            found.append(self.snapshot("run.h5"))
        self.assert_same(*found)


if __name__ == "__main__":
    main()
