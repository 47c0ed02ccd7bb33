# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes of a cylinder that slides over a viscoelastic solid and adheres to it: a table, limits, units, directions and refusals."""

import csv
import os
import sys
import unittest
from pathlib import Path

import h5py
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from runs import Runs  # noqa: E402

REFERENCE = Path(os.environ["ADFRIC_SOURCE"]) / "tests/reference"
# one of so many alike cases is tried where checks make programs slow
EVERY = round(1 / float(os.environ.get("ADFRIC_RANDOM_CASES", "1")))
# digits of the table, and how far its row of the pull-off at touch lies above the limit of no width
DIGITS, AT_TOUCH = 1e-9, 4e-5
SCENE = """
&job output = 'run.h5' /
&surface kind = 'cylinder', radius = {radius} /
&solid modulus = {modulus}, moduli = {moduli}, relaxation_times = {times} /
&adhesion {adhesion} /
&operating velocity = {velocity}{more} /
&sweep variable = 'load', values = {loads} /
{friction}
"""


def rows_of(name):
    with open(REFERENCE / f"{name}.csv") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def listed(values):
    return ", ".join(repr(float(value)) for value in np.atleast_1d(values))


class AdhesiveCylinder(Runs):
    def solve(self, loads, radius=1.0, modulus=1.0, moduli=9.0, times=1.0, velocity=0.3, work=1.0, stress=2.0, adhesion=None, more="",
              friction=""):
        """Results of loads, by name."""
        adhesion = adhesion or f"work_of_adhesion = {listed(work)}, adhesion_stress = {listed(stress)}"
        self.write(SCENE.format(radius=listed(radius), modulus=listed(modulus), moduli=listed(moduli), times=listed(times), velocity=listed(velocity),
                                adhesion=adhesion, loads=listed(loads), more=more, friction=friction))
        self.run_program("run", "--quiet", "--force", "run.nml")
        with h5py.File(self.folder / "run.h5") as file:
            return {key: data[()] for key, data in file.items() if isinstance(data, h5py.Dataset)}

    def groups(self):
        """Rows of the table with the same solid, speed and stress."""
        rows = {}
        for row in rows_of("adv_cylinder_sls"):
            rows.setdefault((float(row["r"]), float(row["speed"]), float(row["stress"])), []).append(row)
        return list(rows.items())

    def test_table(self):
        """All rows: pull-off, friction and edges, in units of the table and in those of a roller."""
        groups = self.groups()
        self.assertEqual(sum(len(rows) for _, rows in groups), 105)
        for number, ((r, speed, stress), rows) in enumerate(groups[::EVERY]):
            # E0, R and w of the roller, and its units
            modulus, radius, work = (1.0, 1.0, 1.0) if number % 2 == 0 else (3.0e6, 0.02, 0.05)
            length = (radius**2 * work / modulus)**(1 / 3)
            force, friction = modulus * length**2 / radius, modulus * length**3 / radius**2
            events = [float(row["load"]) for row in rows if row["event"]]
            states = [row for row in rows if not row["event"]]
            loads = [float(row["load"]) for row in states] or [0.0]
            with self.subTest(r=r, speed=speed, stress=stress):
                found = self.solve(np.multiply(loads, force), radius, modulus, (r - 1) * modulus, 0.7, speed * length / 0.7, work,
                                   stress * modulus * length / radius)
                self.assertFalse(found["status"].any())
                for row, load in zip([row for row in rows if row["event"]], events):
                    off = found["pull_off_load"] / force - load
                    np.testing.assert_array_less(abs(off), DIGITS if row["event"] == "pull_off" else AT_TOUCH)
                    self.assertTrue(np.all((found["pull_off_half_width"] > 0) == (row["event"] == "pull_off")))
                    self.assertTrue(np.all(off < DIGITS))
                for k, row in enumerate(states):
                    middle, width = found["contact_shift"][k], found["contact_half_width"][k]
                    edges = [middle - width - found["zone_trailing"][k], middle - width, middle + width,
                             middle + width + found["zone_leading"][k]]
                    wanted = [float(row[name]) for name in ("zone_trailing", "contact_trailing", "contact_leading", "zone_leading")]
                    np.testing.assert_allclose(np.divide(edges, length), wanted, rtol=0, atol=DIGITS)
                    np.testing.assert_allclose(found["friction_force"][k] / friction, float(row["friction"]), rtol=0, atol=DIGITS)
                np.testing.assert_array_less(abs(found["energy_imbalance"]), 1e-8)
                np.testing.assert_array_less(found["contact_violation"], 1e-12)
                np.testing.assert_array_less(found["error_estimate"], 1e-8)

    def test_direction(self):
        """The other direction changes the signs of vectors alone, bit by bit; profiles are mirrored."""
        output = "&output profiles = .true., x_min = -3.0, x_max = 3.0, n_x = 61 /"
        one = self.solve([0.0, 1.0], velocity=0.3, friction=output)
        two = self.solve([0.0, 1.0], velocity=-0.3, friction=output)
        for name in ("friction_force", "friction_coefficient", "contact_shift", "friction_force_without_adhesion",
                     "adhesive_friction_force"):
            np.testing.assert_array_equal(one[name], -two[name], err_msg=name)
        for name in ("contact_half_width", "zone_leading", "zone_trailing", "pull_off_load", "peak_pressure", "dissipation"):
            self.assertEqual(one[name].tobytes(), two[name].tobytes(), name)
        for name in ("pressure", "gap"):
            np.testing.assert_allclose(one[name], two[name][:, ::-1], rtol=0, atol=1e-12)

    def test_profile(self):
        """In contact the gap is 0, in the zones the pressure is -p0 and the gap within the range, and beyond nothing pulls. The
        pressure sums up to load and friction."""
        found = self.solve([1.0], friction="&output profiles = .true., x_min = -4.0, x_max = 4.0, n_x = 16001 /")
        x, pressure, gap = found["x"], found["pressure"][0], found["gap"][0]
        middle, width = found["contact_shift"][0], found["contact_half_width"][0]
        touches = abs(x - middle) < width
        zone = ~touches & (x < middle + width + found["zone_leading"][0]) & (x > middle - width - found["zone_trailing"][0])
        self.assertTrue(np.all(gap[touches] == 0) and np.all(pressure[touches] > -2))
        self.assertTrue(np.all(pressure[zone] == -2) and np.all(gap[zone] > 0) and np.all(gap[zone] <= 0.5 + 1e-12))
        self.assertTrue(np.all(pressure[~touches & ~zone] == 0) and np.all(gap[~touches & ~zone] >= 0.5 - 1e-12))
        self.assertAlmostEqual(np.trapezoid(pressure, x), 1, delta=1e-3)
        self.assertAlmostEqual(np.trapezoid(pressure * x, x), found["friction_force"][0], delta=1e-3)
        self.assertAlmostEqual(pressure.max(), found["peak_pressure"][0], delta=1e-3)

    def test_limits_of_speed(self):
        """At rest, slow and fast: Maugis's elastic line contact of the relaxed and of the instantaneous modulus, in closed form. A large
        stress leads to the line of Johnson, Kendall and Roberts."""
        for velocity, modulus, digits in ((0.0, 1.0, 1e-10), (1e-9, 1.0, 1e-7), (1e7, 10.0, 1e-7)):
            for half_width, zone in ((1.1, 1.4), (1.6, 1.8)):
                with self.subTest(velocity=velocity, half_width=half_width):
                    # the range for which these edges are those of an elastic cylinder with a stress of 2
                    root, ratio = np.sqrt(zone**2 - half_width**2), np.arccosh(zone / half_width)
                    load = np.pi * modulus * half_width**2 / 4 - 4 * root
                    opening = (zone * root - half_width**2 * ratio) / 2 \
                        + 8 / (np.pi * modulus) * (root * ratio - zone * np.log(zone / half_width))
                    found = self.solve([load], velocity=velocity, adhesion=f"adhesion_stress = 2.0, adhesion_range = {listed(opening)}")
                    self.assertEqual(found["status"][0], 0)
                    np.testing.assert_allclose(found["contact_half_width"][0], half_width, rtol=digits)
                    np.testing.assert_allclose(found["zone_leading"][0], zone - half_width, rtol=10 * digits)
        for velocity, modulus in ((0.0, 1.0), (1e7, 10.0)):
            found = self.solve([0.0], velocity=velocity, stress=300.0)
            wanted = -0.75 * (4 * np.pi * modulus)**(1 / 3)
            np.testing.assert_allclose(found["pull_off_load"][0], wanted, rtol=1e-4)

    def test_limit_of_no_adhesion(self):
        """With less and less adhesion it is the cylinder without; both scenes have that friction."""
        text = SCENE.replace("&adhesion {adhesion} /\n", "").format(radius=1.0, modulus=1.0, moduli="2.0, 7.0", times="0.2, 3.0",
                                                                   velocity=0.3, loads="1.0, 4.0", more="", friction="")
        self.write(text)
        self.run_program("run", "--quiet", "--force", "run.nml")
        with h5py.File(self.folder / "run.h5") as file:
            self.assertEqual(file.attrs["model"], "hertz")
            without = {name: file[name][()] for name in ("friction_force", "contact_half_width", "peak_pressure")}
        off = []
        for stress in (1e-2, 1e-4, 1e-6):
            found = self.solve([1.0, 4.0], moduli=[2.0, 7.0], times=[0.2, 3.0], adhesion=f"adhesion_stress = {stress}, adhesion_range = 0.01")
            self.assertFalse(found["status"].any())
            np.testing.assert_allclose(found["friction_force_without_adhesion"], without["friction_force"], rtol=1e-12)
            off.append([abs(found[name] / without[name] - 1).max() for name in without])
        off = np.array(off)
        np.testing.assert_array_less(off[1:], 0.03 * off[:-1])
        np.testing.assert_array_less(off[2], 1e-5)

    def test_branches(self):
        """Under a load that presses both branches have one state here; the loading branch has none under tension."""
        loads = [-1.0, 0.0, 2.0, -3.1]
        adhered = self.solve(loads)
        loading = self.solve(loads, more=", branch = 'loading'")
        self.assertEqual(adhered["status"].tolist(), [0, 0, 0, 1])
        self.assertEqual(loading["status"].tolist(), [1, 0, 0, 1])
        self.assertEqual(adhered["friction_force"][1:3].tobytes(), loading["friction_force"][1:3].tobytes())
        self.assertEqual(adhered["branches_differ"][:3].tolist(), [0, 0, 0])
        self.assertTrue(np.isnan(adhered["friction_force_without_adhesion"][:2]).all())
        self.assertEqual(adhered["pull_off_load"].tobytes(), loading["pull_off_load"].tobytes())

    def test_no_neighbours(self):
        """A point has the same bits alone and in a sweep."""
        loads = [-1.0, 30.0, 2.0, 400.0, 2.5]
        together = self.solve(loads)
        for k, load in enumerate(loads):
            alone = self.solve([load])
            for name in ("friction_force", "contact_half_width", "pull_off_load", "error_estimate"):
                self.assertEqual(together[name][k], alone[name][0], name)

    def test_interface(self):
        """Losses and the shear of the interface are the friction; the activated law counts the pressure of the contact."""
        plain = self.solve([-1.0, 1.0])
        found = self.solve([-1.0, 1.0], friction="&friction shear_strength = 3.0, pressure_factor = 0.2 /")
        area = 2 * found["contact_half_width"]
        carried = found["load"] + 2 * (found["zone_leading"] + found["zone_trailing"])
        np.testing.assert_allclose(found["interfacial_friction_force"], 3 * area + 0.2 * carried, rtol=1e-13)
        np.testing.assert_array_equal(found["hysteretic_friction_force"], plain["friction_force"])
        np.testing.assert_allclose(found["friction_force"], plain["friction_force"] + 3 * area + 0.2 * carried, rtol=1e-13)
        # the slope, from velocities far apart
        sums = [self.solve([-1.0, 1.0], velocity=0.3 * np.exp(step), friction="&friction shear_strength = 3.0 /")["friction_force"]
                for step in (-0.01, 0.01)]
        slope = self.solve([-1.0, 1.0], friction="&friction shear_strength = 3.0 /")["velocity_slope"]
        np.testing.assert_allclose(slope, np.log(sums[1] / sums[0]) / 0.02, rtol=1e-4)

    def test_law_of_pressure(self):
        """Shear of a law of the pressure, which counts a tension as none, against a sum over the profile."""
        boltzmann, temperature = 1.380649e-23, 300.0
        law = ("&friction law = 'activated', shear_activation_volume = 4e-21, pressure_activation_volume = 1e-21, attempt_velocity = 10.0, "
               "activation_energy = 5e4 /\n&output profiles = .true., x_min = -3.0, x_max = 3.0, n_x = 120001 /")
        found = self.solve([1.0], more=", temperature = 300.0", friction=law)
        x, pressure, shear = found["x"], found["pressure"][0], found["shear_stress"][0]
        touches = abs(x - found["contact_shift"][0]) < found["contact_half_width"][0]
        self.assertTrue(np.all((shear > 0) == touches))
        np.testing.assert_allclose(np.trapezoid(shear, x), found["interfacial_friction_force"][0], rtol=1e-4)
        slope = (shear[touches].max() - shear[touches].min()) / pressure.max()
        self.assertGreater(boltzmann * temperature, 0)
        np.testing.assert_allclose(slope, 0.25, rtol=1e-6)

    def test_refusals(self):
        """One line each."""
        good = SCENE.format(radius=1.0, modulus=1.0, moduli="9.0", times="1.0", velocity=0.3, loads="1.0", more="",
                            adhesion="work_of_adhesion = 1.0, adhesion_stress = 2.0", friction="")
        for old, new, message in (
                (", adhesion_stress = 2.0", "", r"&adhesion adhesion_stress: is missing \[Pa\]"),
                ("work_of_adhesion = 1.0, ", "", r"&adhesion work_of_adhesion: is missing"),
                ("adhesion_stress = 2.0", "adhesion_stress = 1e9", "adhesion_stress: or the load or the velocity is too small or too large"),
                ("values = 1.0", "values = 1e12", "or the load or the velocity is too small or too large"),
                ("radius = 1.0", "radius = -1.0", "&surface radius"),
                ("velocity = 0.3", "velocity = 0.3, approach = 1.0", "approach"),
                ("velocity = 0.3", "velocity = 0.3, turning_pressure = 1.0", "turning_pressure"),
                ("&sweep variable = 'load', values = 1.0 /", "", r"&operating load: is missing \[N/m\]"),
                ("&operating velocity = 0.3 /", "", r"&operating velocity: is missing \[m/s\]"),
                ("\n\n", "\n&friction shear_strength = 1.0, pressure_factor = 0.6 /\n", "times the stress of adhesion is above")):
            with self.subTest(message=message):
                self.assertIn(old, good)
                self.write(good.replace(old, new))
                _, errors = self.run_program("run", "--quiet", "--force", "run.nml", status=2)
                self.assertRegex(errors, message)


if __name__ == "__main__":
    unittest.main()
