# SPDX-License-Identifier: GPL-3.0-or-later
"""Published figures of Johnson 1997 and of Yastrebov's lecture, by their names: the numbers of the shipped inputs against closed forms and tables.

Those of Goryacheva and Makhovskaya 2011 are in program_figures.pf, what is wrong in the texts in misprints.py. J is Johnson 1997.
"""

import csv
import os
import sys
import unittest
from pathlib import Path

import h5py
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from runs import Runs, main  # noqa: E402

SOURCE = Path(os.environ["ADFRIC_SOURCE"])
# a closed form, and a table of 12 digits or more
CLOSED_FORM, TABLE = 1e-13, 1e-11
# numbers are relative to the larger of their size in reduced units and this
LEAST = 0.1
SOLVED, NO_EQUILIBRIUM = 0, 1
# w over the reduced units of stress and of slip (J 2.11)
SLIP_UNIT = 2 / np.pi


def table(name):
    """Rows of a reference table, each a dictionary of the numbers that it has."""
    lines = [line for line in (SOURCE / f"tests/reference/{name}.csv").read_text().splitlines() if not line.startswith("#")]
    return [{key: number(text) for key, text in row.items()} for row in csv.DictReader(lines)]


def number(text):
    """A cell: a number, a word, or None where it is empty."""
    try:
        return float(text) if text else None
    except ValueError:
        return text


def nearest(values, value):
    """Index of a value of a sweep, which must be there."""
    index = int(np.argmin(abs(values - value)))
    np.testing.assert_allclose(values[index], value, rtol=1e-12, atol=1e-12)
    return index


def is_on(values, value):
    """Is a number one of a sweep?"""
    return bool(np.min(abs(values - value)) < 1e-9)


class PublishedFigures(Runs):
    def solve(self, name):
        """Numbers of a shipped input as it stands."""
        self.run_program("run", "--quiet", "--force", "--output", "run.h5", SOURCE / f"inputs/{name}.nml")
        with h5py.File(self.folder / "run.h5") as file:
            return {key: data[()] for key, data in file.items() if isinstance(data, h5py.Dataset)}

    def test_johnson1997_fig1(self):
        """Dugdale's law: the stress lambda up to the gap 2/(pi lambda), nothing beyond; the table has the radii."""
        found = self.solve("johnson1997_fig1")
        rows = {row["lambda"]: row for row in table("fig03_pulloff")}
        for k, lambda_ in enumerate(found["lambda"]):
            gap, pressure, r = found["gap"][k], found["pressure"][k], found["r"]
            attracts = (gap > 0) & (gap < SLIP_UNIT / lambda_)
            self.assertGreater(attracts.sum(), 40)
            np.testing.assert_allclose(pressure[attracts], -lambda_, rtol=1e-14)
            self.assertTrue(np.all(pressure[gap > (1 + 1e-12) * SLIP_UNIT / lambda_] == 0))
            # where the attraction ends the gap is the range
            within = r < found["adhesion_radius"][k]
            self.assertTrue(gap[within].max() < SLIP_UNIT / lambda_ < gap[~within].min())
            if lambda_ in rows:
                self.assertAlmostEqual(found["contact_radius"][k] / rows[lambda_]["a(P=0)"], 1, delta=TABLE)
                self.assertAlmostEqual(found["adhesion_radius"][k] / rows[lambda_]["c(P=0)"], 1, delta=TABLE)
        self.assertTrue(set(found["lambda"]) & set(rows))

    def test_johnson1997_fig2(self):
        """Hertz's pressure, and that of J 2.12 to 2.14 at the same radius; the sum of their difference is that of the loads."""
        found = self.solve("johnson1997_fig2")
        radius, modulus, a = (found[name] for name in ("radius", "contact_modulus", "operating_contact_radius"))
        np.testing.assert_array_equal(found["work_of_adhesion"], [0, 0.19])
        r, c = found["r"], found["adhesion_radius"][1]
        inside, tension, beyond = r < a, (r > a) & (r < c), r > c
        hertz = 2 * modulus / (np.pi * radius) * np.sqrt(np.maximum(a**2 - r**2, 0))
        np.testing.assert_allclose(found["pressure"][0], hertz, atol=1e-12 * hertz[0], rtol=1e-11)
        stress = found["lambda"] / 2 * (16 * np.pi * 0.19 * modulus**2 / (9 * radius)) ** (1 / 3)
        angle = np.arccos((2 * a**2 - c**2 - r[inside] ** 2) / (c**2 - r[inside] ** 2))
        np.testing.assert_allclose(found["pressure"][1][inside], hertz[inside] - stress / np.pi * angle, atol=1e-7 * hertz[0])
        np.testing.assert_allclose(found["pressure"][1][tension], -stress, rtol=1e-12)
        self.assertTrue(np.all(found["pressure"][1][beyond] == 0))
        self.assertTrue(inside.sum() > 300 and tension.sum() > 100 and beyond.sum() > 100)
        # the sum over the area of both tensions in closed form (J 2.13)
        m = c / a
        pulled = 2 * stress * a**2 * (np.sqrt(m**2 - 1) + m**2 * np.arccos(1 / m))
        np.testing.assert_allclose(found["load"], [4 * modulus * a**3 / (3 * radius), 4 * modulus * a**3 / (3 * radius) - pulled], rtol=1e-12)
        added = 2 * np.pi * np.trapezoid((found["pressure"][1] - found["pressure"][0]) * r, r)
        self.assertAlmostEqual(added / (found["load"][1] - found["load"][0]), 1, delta=3e-3)

    def test_johnson1997_fig3(self):
        """Every state solves J 2.12 and 2.13, without load and at pull-off the radii and loads are those of the table."""
        found = self.solve("johnson1997_fig3")
        lambda_, a = found["lambda"][:, None], found["contact_radius"][None, :]
        c, load = found["adhesion_radius"], found["load"]
        m = c / a
        arc, root = np.arccos(1 / m), np.sqrt(m**2 - 1)
        gap = lambda_ / 2 * a**2 * ((m**2 - 2) * arc + root) + 4 / 3 * lambda_**2 * a * (root * arc - m + 1)
        # terms of m cancel as the root of m - 1 does
        np.testing.assert_allclose(gap, 1, rtol=1e-11)
        np.testing.assert_allclose(load, a**3 - lambda_ * a**2 * (root + m**2 * arc), rtol=0, atol=1e-12 * np.max(a**3))
        rows = [row for row in table("fig03_pulloff") if is_on(found["lambda"], row["lambda"])]
        self.assertEqual(len(rows), 4)
        for row in rows:
            k = nearest(found["lambda"], row["lambda"])
            least = int(load[k].argmin())
            # a fold, to the square of the step of the radius
            self.assertAlmostEqual(load[k].min(), row["Pc_load[-]"], delta=1e-4)
            rising = slice(least, None)
            for name, values in (("a(P=0)", a[0]), ("c(P=0)", c[k])):
                self.assertAlmostEqual(np.interp(0.0, load[k, rising], values[rising]), row[name], delta=1e-5)

    def test_johnson1997_fig4(self):
        """J 3.8 between the radii of contact and adhesion, and the area of the table of Fig. 5."""
        found = self.solve("johnson1997_fig4")
        b, x = found["friction_radius"], found["edge_fraction"]
        np.testing.assert_array_equal(x, [0, 0.4, 1])
        a, c = (found[name][0] for name in ("contact_radius", "adhesion_radius"))
        known = np.isfinite(a)
        for k in range(3):
            np.testing.assert_allclose(b[k][known], (a + x[k] * (c - a))[known], rtol=1e-14)
        n_compared, loads = 0, 1e9 * found["load"]
        for row in table("fig05_friction_vs_load"):
            friction = row["friction MD lambda=0.8 w=0.19 tau0=0.96GPa x=0.4 [nN]"]
            if friction is not None and is_on(loads, row["load[nN]"]):
                area = np.pi * b[1, nearest(loads, row["load[nN]"])] ** 2
                self.assertAlmostEqual(1e9 * 0.96e9 * area / friction, 1, delta=TABLE)
                n_compared += 1
        self.assertGreater(n_compared, 15)

    def test_johnson1997_fig5(self):
        """Friction of both curves at all loads of the table, and the loads at which they end."""
        columns = {"johnson1997_fig5": "friction MD lambda=0.8 w=0.19 tau0=0.96GPa x=0.4 [nN]",
                   "johnson1997_fig5_jkr": "friction JKR w=0.21 tau0=0.84GPa [nN]"}
        for name, column in columns.items():
            found, n_compared = self.solve(name), 0
            loads = 1e9 * found["load"]
            for row in table("fig05_friction_vs_load"):
                if not is_on(loads, row["load[nN]"]):
                    continue
                k = nearest(loads, row["load[nN]"])
                if row[column] is None:
                    self.assertEqual(found["status"][k], NO_EQUILIBRIUM)
                    continue
                self.assertAlmostEqual(1e9 * found["friction_force"][k] / row[column], 1, delta=TABLE)
                n_compared += 1
            self.assertGreater(n_compared, 15)
            ends = -1e9 * np.nanmin(found["pull_off_load"])
            self.assertAlmostEqual(ends, {"johnson1997_fig5": 136.5285048888156, "johnson1997_fig5_jkr": 138.5442360233099}[name], delta=1e-8)

    def test_johnson1997_fig5_fitted(self):
        """What the full line supports: the numbers that drew it, and next to them a second answer for lambda (docs/theory/johnson1997.md)."""
        self.run_program("run", "--quiet", "--force", SOURCE / "inputs/johnson1997_fig5_jkr.nml")
        self.run_program("fit", "--quiet", "--force", "--output", "fit.h5", SOURCE / "inputs/fit_johnson1997_fig5.nml")
        with h5py.File(self.folder / "fit.h5") as file:
            self.assertEqual(file["status"][()], SOLVED)
            minima, chi2, lambda_ = (file[name][()] for name in ("minima", "minima_chi2", "lambda"))
        # lambda is at the upper bound of its range, where JKR and Maugis differ by less than the errors
        np.testing.assert_allclose(minima[0, :2], [0.21, 0.84e9], rtol=1e-4)
        self.assertGreater(lambda_, 3)
        np.testing.assert_allclose(minima[1], [0.175, 0.80e9, 0.24], rtol=3e-3)
        self.assertAlmostEqual(chi2[1] - chi2[0], 1.3, delta=0.05)

    def test_johnson1997_fig6(self):
        """The five radii that stick, and the traction from the middle to the edge (J 3.3, corrected)."""
        found = self.solve("johnson1997_fig6")
        np.testing.assert_allclose(found["stick_radius"] / found["friction_radius"], [0.975105, 0.796468, 0.592754, 0.406231, 0.284301], atol=5e-7)
        r = found["r"]
        for k, (e, b) in enumerate(zip(found["stick_radius"], found["friction_radius"])):
            inside = r <= e
            expected = np.where(r <= b, 1.0, 0.0)
            expected[inside] = np.arccos((2 * e**2 - b**2 - r[inside]**2) / (b**2 - r[inside]**2)) / np.pi
            # next to e the arc cosine has the root of round-off
            np.testing.assert_allclose(found["shear_stress"][k], expected, atol=1e-7)

    def test_johnson1997_fig7(self):
        """Areas at all loads and alpha of the table, by JKR and with lambda = 0.8, and where they end."""
        found, n_compared = self.solve("johnson1997_fig7"), 0
        for row in table("fig07_area_vs_load"):
            if not (is_on(found["interaction"], row["alpha"]) and is_on(found["load"], row["P[-]"])):
                continue
            i, k = nearest(found["interaction"], row["alpha"]), nearest(found["load"], row["P[-]"])
            # `auto` at lambda = 1e6 is JKR to its tolerance; at the end of the branch the radius has the root of that
            for j, column, margin in ((0, "A_MD=pi b^2", TABLE), (1, "A_JKR", 1e-7)):
                if row[column] is None:
                    self.assertEqual(found["status"][i, j, k], NO_EQUILIBRIUM)
                elif j == 0 or row["P[-]"] > -1.49 * row["X"]:
                    self.assertAlmostEqual(found["friction_area"][i, j, k] / row[column], 1, delta=margin)
                    n_compared += 1
        self.assertGreater(n_compared, 60)

    def test_johnson1997_fig8(self):
        """What is left of the area, at all loads, alpha and g0 of the table, and where the surfaces have snapped apart."""
        found, n_compared, n_apart = self.solve("johnson1997_fig8"), 0, 0
        area = found["friction_area"]
        for row in table("fig08_area_reduction"):
            axes = [(found[name], row[key]) for name, key in (("load", "P[-]"), ("interaction", "alpha"), ("slip_energy_ratio", "g0"))]
            if not all(is_on(values, value) for values, value in axes):
                continue
            i, j, m = (nearest(values, value) for values, value in axes)
            # `auto` at lambda = 1e6 is JKR to its tolerance, which counts more next to the snap
            for k, column, margin in ((0, "A/A* MD(lambda=0.8;x=0.4)", TABLE), (1, "A/A* JKR", 1e-6)):
                if row[column] is None:
                    self.assertEqual(found["status"][i, j, k, m], NO_EQUILIBRIUM)
                    n_apart += 1
                else:
                    self.assertAlmostEqual(area[i, j, k, m] / area[i, 0, k, m], row[column], delta=margin)
                    n_compared += 1
        self.assertGreater(n_compared, 100)
        self.assertGreater(n_apart, 10)

    def test_johnson1997_fig9a(self):
        """JKR: the area falls up to a quarter of the force of sliding and is constant from there; nothing drops."""
        found = self.solve("johnson1997_fig9a")
        self.check_annulus(found)
        for k, sliding in enumerate(np.nanmax(found["friction_force"], axis=1)):
            force, area = found["tangential_force"][k], found["friction_area"][k]
            late = force > 0.27 * sliding
            np.testing.assert_allclose(area[late], np.nanmin(area), rtol=1e-12)
            self.assertAlmostEqual(np.nanmax(abs(found["tangential_force_drop"][k])), 0, delta=1e-12)
        expected = {0.0: 25.93328, 0.4: 22.14056, 1.0: 14.41032}
        for alpha, force in expected.items():
            self.assertAlmostEqual(np.nanmax(found["friction_force"][nearest(found["interaction"], alpha)]), force, delta=5e-6)

    def test_johnson1997_fig9b(self):
        """Lambda = 0.8: the area falls with the force, and both drop at the onset of sliding from alpha = 0.4 on."""
        found = self.solve("johnson1997_fig9b")
        self.check_annulus(found)
        drops = np.nanmax(found["tangential_force_drop"], axis=1)
        np.testing.assert_allclose(drops, [0, 0, 0.00838, 0.04265, 0.11820, 0.26624], atol=5e-6)
        for k in range(6):
            area = found["friction_area"][k]
            area = area[np.isfinite(area)]
            self.assertTrue(np.all(np.diff(area) <= 1e-12 * area[0]))
            # the force of sliding is the strength times the area, in units of force that are twice those of stress and area
            sliding = 2 * np.nanmax(found["friction_force"][k]) / 0.8
            self.assertEqual(sliding < area[-1] * (1 - 1e-3), k >= 2)

    def check_annulus(self, found):
        """Force and displacement of the annulus that slips (J 3.4, 3.5), and the interaction (J 4.7)."""
        e, b, strength = found["stick_radius"], found["friction_radius"], found["shear_strength"]
        ratio = np.clip(e / b, 0, 1)
        known = np.isfinite(ratio)
        self.assertGreater(known.sum(), 1000)
        angle = np.arccos(ratio)
        # the arc cosine of a ratio near 1 has the root of round-off
        np.testing.assert_allclose(found["tangential_force"][known], (strength * b**2 * (angle + np.sin(angle) * np.cos(angle)))[known], atol=2e-7)
        alpha = found["interaction"][:, None]
        energy = np.minimum(strength * found["edge_slip"] / SLIP_UNIT, found["slip_energy_ratio"])
        expected = np.sqrt((1 + energy)**2 - 2 * alpha * energy) - energy
        np.testing.assert_allclose(found["adhesion_ratio"][known], expected[known], rtol=0, atol=1e-9)

    def test_johnson1997_fig10(self):
        """Force, displacement and slip of the ring from its inner radius (J 3.4, 3.5, 3.7)."""
        found = self.solve("johnson1997_fig10")
        b, nu = found["friction_radius"], found["poisson_ratio"]
        ratio = np.clip(found["stick_radius"] / b, 0, 1)
        angle, root = np.arccos(ratio), np.sqrt(1 - ratio**2)
        # in sliding neither has a value but at its onset
        unit = 2 / 3 * (2 - nu) / (1 - nu) * b
        np.testing.assert_allclose(found["tangential_force"], 2 / np.pi * (angle + ratio * root), atol=2e-8)
        np.testing.assert_allclose(found["tangential_displacement"], unit * root, atol=2e-8)
        np.testing.assert_allclose(found["edge_slip"], unit * SLIP_UNIT * (root * angle + ratio - 1), atol=2e-8)
        self.assertAlmostEqual(found["edge_slip"][-1] / (unit[-1] * SLIP_UNIT * (np.pi / 2 - 1)), 1, delta=CLOSED_FORM)
        # at first a spring, of which nothing slips
        force = found["tangential_force"][1]
        self.assertAlmostEqual(found["tangential_displacement"][1] / (np.pi / 4 * unit[1] * force), 1, delta=1e-5)

    def test_johnson1997_fig11(self):
        """J 3.4 along the whole curve, and the labels of Fig. 6."""
        found = self.solve("johnson1997_fig11")
        ratio = found["stick_radius"] / found["friction_radius"]
        angle = np.arccos(np.clip(ratio, 0, 1))
        np.testing.assert_allclose(2 / np.pi * (angle + np.sin(angle) * ratio), found["tangential_force"], atol=2e-8)
        for force, expected in ((0.28, 0.97511), (0.72, 0.79647), (0.90, 0.59275), (0.97, 0.40623), (0.99, 0.28430)):
            self.assertAlmostEqual(ratio[nearest(found["tangential_force"], force)], expected, delta=5e-6)

    def test_sphere_pressure(self):
        """Pressure of Maugis and Dugdale: a closed form inside, the tension to the edge of adhesion, nothing beyond."""
        found = self.solve("sphere_pressure")
        r = found["r"]
        for k, lambda_ in enumerate(found["lambda"]):
            a, c, pressure = found["contact_radius"][k], found["adhesion_radius"][k], found["pressure"][k]
            inside, tension, beyond = r < a, (r > a) & (r < c), r > c
            root = np.sqrt(a**2 - r[inside]**2)
            expected = 3 / np.pi * root - 2 / np.pi * lambda_ * np.arctan(np.sqrt(c**2 - a**2) / root)
            np.testing.assert_allclose(pressure[inside], expected, atol=1e-12 * max(1, lambda_))
            np.testing.assert_allclose(pressure[tension], -lambda_, rtol=1e-14)
            self.assertTrue(np.all(pressure[beyond] == 0))
            self.assertTrue(inside.sum() > 250 and tension.sum() > 4 and beyond.sum() > 50)

    def test_lecture_jkr(self):
        """a' = [F' + b' + sqrt(2 b' F' + b'^2)]^(1/3) on the stable branch, less the root on the other; the table has the same numbers."""
        found = self.solve("lecture_jkr")
        # R = 1 mm and E* = 0.75 MPa: a' is the radius in mm, F' the load in N
        a, energies = 1e3 * found["contact_radius"], 3e-3 * np.pi * found["work_of_adhesion"]
        for k, reduced in enumerate(energies):
            force = found["load"][k]
            root = np.sqrt(np.maximum(2 * reduced * force + reduced**2, 0))
            sign = np.where(a**3 >= reduced / 2, 1, -1)
            # at the fold the root has the root of round-off
            np.testing.assert_allclose(force + reduced + sign * root, a**3, atol=1e-9)
            if reduced > 0:
                self.assertAlmostEqual(np.nanmax(found["pull_off_load"][k]) / (-reduced / 2), 1, delta=CLOSED_FORM)
        n_compared = 0
        for row in table("yas_jkr"):
            reduced = row["b'=9 pi gamma/(4 E* R)"]
            if not is_on(energies, reduced) or row["branch"] != "stable":
                continue
            k = nearest(energies, reduced)
            stable = a**3 > reduced / 2
            if row["a'=a/R"] < 0.45:
                # between samples of the radius the load is cubic
                self.assertAlmostEqual(np.interp(row["F'=3F/(4E*R^2)"], found["load"][k][stable], a[stable]), row["a'=a/R"], delta=2e-4)
                n_compared += 1
        self.assertGreater(n_compared, 15)

    def test_lecture_wave_cuts(self):
        """Along y = 0 and y = x: pressure or gap, contacts that merge between 0.2 and 0.4 p*, and full contact in closed form."""
        found = self.solve("lecture_wave_cuts")
        x, y, pressure, gap = (found[name] for name in ("x", "y", "pressure", "gap"))
        np.testing.assert_array_equal(x, y)
        full = found["full_contact_pressure"][0]
        share = found["mean_pressure"] / full
        np.testing.assert_allclose(share, [0.03, 0.1, 0.2, 0.4, 0.8, 1.1], rtol=1e-6)
        places = np.arange(x.size)
        # the row beside the crest, half a cell from it
        cuts = {"y=0": (0, places, np.full(x.size, y[0])), "y=x": (places, places, y)}
        k = 2 * np.pi / found["period"]
        for name, (rows, columns, across) in cuts.items():
            p, g = pressure[:, rows, columns], gap[:, rows, columns]
            self.assertEqual(np.max(np.minimum(p / full, g / g.max())), 0, name)
            self.assertTrue(np.all(np.diff(p, axis=1) <= 1e-9 * full))
            expected = found["mean_pressure"][5] + full / 2 * (np.cos(k * x) + np.cos(k * across))
            # the cells have the cosine to the square of their width
            np.testing.assert_allclose(p[5], expected, atol=1e-4 * full)
        closed = [bool(np.all(gap[i, 0, :] == 0)) for i in range(6)]
        self.assertEqual(closed, [False, False, False, True, True, True])
        self.assertEqual([bool(gap[i, -1, -1] == 0) for i in range(6)], [False] * 5 + [True])

    def test_lecture_westergaard(self):
        """Width, pressure and mean gap of Westergaard's wave in closed form."""
        found = self.solve("wave_1d")
        share = found["mean_pressure"] / found["full_contact_pressure"]
        inside = (share > 0) & (share < 1)
        self.assertGreater(inside.sum(), 50)
        np.testing.assert_allclose(found["contact_fraction"][inside], 2 / np.pi * np.arcsin(np.sqrt(share[inside])), rtol=1e-12)
        np.testing.assert_allclose(found["mean_gap"][inside] / found["amplitude"], 1 - share[inside] + share[inside] * np.log(share[inside]),
                                   atol=1e-12)
        found = self.solve("wave_1d_pressure")
        full = np.pi * found["contact_modulus"] * found["amplitude"] / found["period"]
        for mean, pressure in zip(found["mean_pressure"], found["pressure"]):
            phase = np.pi * found["x"] / found["period"]
            expected = 2 * full * np.abs(np.cos(phase)) * np.sqrt(np.maximum(mean / full - np.sin(phase)**2, 0))
            if mean >= full:
                expected = mean + full * np.cos(2 * phase)
            np.testing.assert_allclose(pressure, expected, atol=1e-7 * full)

    def test_lecture_area(self):
        """Area of the bi-sinusoidal wave: the last asymptote next to full contact, the table in between, within the bound of its error."""
        found = self.solve("wave_2d_elastic")
        share = found["mean_pressure"] / found["full_contact_pressure"]
        area, bound = found["contact_fraction"], found["contact_fraction_error"]
        for row in table("bisine_area"):
            if is_on(share, row["p/p*"]):
                k = nearest(share, row["p/p*"])
                self.assertLess(abs(area[k] - row["A/A0 numeric"]), bound[k] + row["uncertainty"])
        near = (share > 0.95) & (share < 1)
        self.assertGreater(near.sum(), 3)
        np.testing.assert_allclose(area[near], 1 - 3 / (2 * np.pi) * (1 - share[near]), atol=5e-3)
        light = (share > 0) & (share < 0.01)
        np.testing.assert_allclose(area[light], np.pi * (3 * share[light] / (8 * np.pi)) ** (2 / 3), rtol=0.05)
        self.assertTrue(np.all(area[share >= 1] == 1))


if __name__ == "__main__":
    main()
