# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes of arrays: the results are those of the input that names datasets, bit by bit, and what is wrong is said in its words."""

import copy
import pickle
import subprocess
import unittest
from pathlib import Path

import h5py
import numpy as np
import xarray as xr
from cases import SOURCE, InFolder

import adfric
from adfric import InputError
from adfric.command import PROGRAM

X = np.arange(32)*2*np.pi/32
PROFILE = 1e-6*np.cos(X) + 2e-7*np.cos(3*X + 1)
MAP = 1e-6*np.cos(X)[:, None]*np.cos(X[:16]*2) + 2e-7*np.cos(3*X[:16] + 1)
OMEGA = np.logspace(0, 6, 61)
MODULUS = 1e6 + 1e8*1j*OMEGA*1e-3/(1 + 1j*OMEGA*1e-3)
CURVE = {"omega": OMEGA, "storage": MODULUS.real, "loss": MODULUS.imag}
POSITIONS = np.linspace(-1e-3, 1e-3, 41)
PRESSURES = 1e6*np.sqrt(np.maximum(1 - (POSITIONS/1e-3)**2, 0))
SHEARS = 0.2*PRESSURES
HEIGHTS = {"kind": "heights", "heights": MAP, "length_x": 1e-4, "length_y": 2e-4}
# Groups of an input that name datasets, and those of Python that have arrays.
SCENES = {
    "heights": ("&surface kind = 'heights', heights = 'data.h5:/map', length_x = 1e-4, length_y = 2e-4 /\n"
                "&solid contact_modulus = 1e9 /\n&output profiles = .true. /\n&sweep variable = 'mean_pressure', values = 1e6, 5e6 /\n",
                {"surface": HEIGHTS, "solid": {"contact_modulus": 1e9}, "operating": {"mean_pressure": [1e6, 5e6]},
                 "output": {"profiles": True}}),
    "heights with adhesion": ("&surface kind = 'heights', heights = 'data.h5:/map', length_x = 1e-4, length_y = 2e-4 /\n"
                              "&solid contact_modulus = 1e9 /\n&adhesion work_of_adhesion = 1e-3, adhesion_stress = 1e5 /\n"
                              "&friction shear_strength = 1e5 /\n&operating branch = 'adhered' /\n"
                              "&sweep variable = 'mean_pressure', values = 0.0, 1e6 /\n",
                              {"surface": HEIGHTS, "solid": {"contact_modulus": 1e9},
                               "adhesion": {"work_of_adhesion": 1e-3, "adhesion_stress": 1e5}, "friction": {"shear_strength": 1e5},
                               "operating": {"branch": "adhered"}, "sweep": {"mean_pressure": [0.0, 1e6]}}),
    "profile on columns": ("&surface kind = 'profile', heights = 'data.h5:/profile', length_x = 1e-4 /\n"
                           "&solid extent = 'foundation', stiffness = 1e11, stiffnesses = 1e10, 3e10, relaxation_times = 1e-4, 1e-2 /\n"
                           "&operating velocity = 0.1 /\n&sweep variable = 'mean_pressure', values = 1e4, 5e4 /\n",
                           {"surface": {"kind": "profile", "heights": PROFILE, "length_x": 1e-4},
                            "solid": {"extent": "foundation", "stiffness": 1e11, "stiffnesses": [1e10, 3e10], "relaxation_times": (1e-4, 1e-2)},
                            "operating": {"velocity": 0.1}, "sweep": {"mean_pressure": [1e4, 5e4]}}),
    "heights on a master curve": ("&surface kind = 'heights', heights = 'data.h5:/map', length_x = 1e-4, length_y = 2e-4 /\n"
                                  "&solid master_curve = 'data.h5:/dma', poisson_ratio = 0.5 /\n&operating mean_pressure = 5e4 /\n"
                                  "&sweep variable = 'velocity', values = 1e-3, 1e-1 /\n",
                                  {"surface": HEIGHTS, "solid": {"master_curve": CURVE, "poisson_ratio": 0.5},
                                   "operating": {"mean_pressure": 5e4, "velocity": np.array([1e-3, 1e-1])}}),
    "tractions": ("&traction kind = 'strip', distribution = 'sampled', positions = 'data.h5:/positions', pressures = 'data.h5:/pressures',"
                  " shear_stresses = 'data.h5:/shears' /\n&solid young_modulus = 2e11, poisson_ratio = 0.3 /\n"
                  "&sweep variable = 'position_x', values = -2e-3, 0.0, 5e-4 /\n",
                  {"traction": {"kind": "strip", "distribution": "sampled", "positions": POSITIONS, "pressures": PRESSURES,
                                "shear_stresses": SHEARS}, "solid": {"young_modulus": 2e11, "poisson_ratio": 0.3},
                   "position": {"position_x": [-2e-3, 0.0, 5e-4]}}),
    "path": ("&surface kind = 'paraboloid', radius = 1e-3 /\n&solid young_modulus = 7.5e6, poisson_ratio = 0.5 /\n"
             "&friction coulomb_coefficient = 0.3 /\n&history loads = 1e-3, 1e-3, 1e-3, tangential_forces = 1e-4, -1e-4, 0.0 /\n",
             {"surface": {"kind": "paraboloid", "radius": 1e-3}, "solid": {"young_modulus": 7.5e6, "poisson_ratio": 0.5},
              "friction": {"coulomb_coefficient": 0.3}, "history": {"loads": [1e-3]*3, "tangential_forces": [1e-4, -1e-4, 0.0]}}),
}


class SceneArrays(InFolder):
    def setUp(self):
        super().setUp()
        with h5py.File("data.h5", "w") as file:
            for name, values in (("profile", PROFILE), ("map", MAP), ("positions", POSITIONS), ("pressures", PRESSURES), ("shears", SHEARS),
                                 *((f"dma/{name}", values) for name, values in CURVE.items())):
                file[name] = values

    def of_program(self, text):
        """What the program writes for an input."""
        Path("run.nml").write_text(text)
        return adfric.run("run.nml", output="run.h5", force=True)

    def check_same(self, found, expected):
        """The same names, dimensions, types and values, and the hash of the same case."""
        self.assertEqual(expected.attrs["case_hash"], found.attrs["case_hash"])
        self.assertEqual(set(expected.variables), set(found.variables))
        for name in expected.variables:
            self.assertEqual(expected[name].dtype, found[name].dtype, name)
        xr.testing.assert_equal(expected, found)

    def test_arrays(self):
        """Arrays in place of datasets, lists and sweeps."""
        for name, (text, groups) in SCENES.items():
            with self.subTest(name):
                expected = self.of_program(text)
                self.assertEqual(0, int(np.abs(expected.status).max()))
                self.check_same(adfric.solve(**groups, threads=2), expected)
                case = adfric.scene(**groups)
                self.assertEqual(expected.attrs["scene"], case.scene)
                self.assertIn(case.scene, repr(case))
                again = pickle.loads(pickle.dumps(case))
                self.check_same(case.solve(), expected)
                self.check_same(again.solve(), expected)
                self.check_same(copy.deepcopy(case).solve(), expected)

    def test_forms(self):
        """Other containers, orders in memory, tables and stated units are the same numbers."""
        groups = SCENES["heights on a master curve"][1]
        expected = adfric.solve(**groups)
        dataset = xr.Dataset({"storage": ("omega", CURVE["storage"], {"units": "Pa"}), "loss": ("omega", CURVE["loss"])},
                             {"omega": ("omega", OMEGA, {"units": "rad/s"})})
        for curve in (np.array([OMEGA, CURVE["storage"], CURVE["loss"]]), [OMEGA, CURVE["storage"], CURVE["loss"]], dataset,
                      dataset.to_dataframe().reset_index()):
            same = adfric.solve(**{**groups, "solid": {"master_curve": curve, "poisson_ratio": 0.5}})
            xr.testing.assert_equal(expected, same)
        for heights in (np.asfortranarray(MAP), MAP.tolist(), xr.DataArray(MAP, dims=("y", "x"), attrs={"units": "m"}), "data.h5:/map"):
            same = adfric.solve(**{**groups, "surface": {**HEIGHTS, "heights": heights}})
            xr.testing.assert_equal(expected, same)

    def test_set(self):
        """Arrays are changed afterwards; what the caller does to his array is not for the case."""
        heights = MAP.copy()
        case = adfric.scene(surface={**HEIGHTS, "heights": heights}, solid={"contact_modulus": 1e9}, operating={"mean_pressure": 1e6})
        first = case.solve()
        heights[:] = 0
        xr.testing.assert_equal(first, case.solve())
        xr.testing.assert_equal(first, copy.deepcopy(case).solve())
        case.set(surface={"heights": 2*MAP})
        second = adfric.solve(surface={**HEIGHTS, "heights": 2*MAP}, solid={"contact_modulus": 1e9}, operating={"mean_pressure": 1e6})
        xr.testing.assert_equal(second, case.solve())
        self.assertLess(second.contact_fraction.item(), first.contact_fraction.item())
        case.set(heights=MAP, mean_pressure=[1e6, 2e6])
        self.assertEqual(first.contact_fraction.item(), case.solve().contact_fraction[0].item())
        self.assertEqual(first.contact_fraction.item(), case.find("contact_fraction", mean_pressure=1e6))

    def test_order_and_together(self):
        """Sweeps of arrays make an outer product, that of `sweep` outermost, or a list of points."""
        tip = {"surface": {"kind": "paraboloid", "radius": 140e-9}, "solid": {"contact_modulus": 44e9},
               "adhesion": {"work_of_adhesion": [0.1, 0.2], "lambda_": 0.8}, "operating": {"load": [0.0, 1e-8, 2e-8]}}
        found = adfric.solve(**tip)
        self.assertEqual(("work_of_adhesion", "load"), found.contact_radius.dims)
        swept = adfric.solve(**{**tip, "operating": {}}, sweep={"load": [0.0, 1e-8, 2e-8]})
        self.assertEqual(("load", "work_of_adhesion"), swept.contact_radius.dims)
        np.testing.assert_allclose(found.contact_radius, swept.contact_radius.transpose(*found.contact_radius.dims), rtol=1e-14)
        pairs = {**tip, "operating": {"load": [0.0, 1e-8]}}
        listed = adfric.solve(**pairs, together=("work_of_adhesion", "load"))
        self.assertEqual(("point",), listed.contact_radius.dims)
        np.testing.assert_allclose(listed.contact_radius, found.contact_radius.values[[0, 1], [0, 1]], rtol=1e-14)
        other = adfric.scene(**{**pairs, "operating": {}}, sweep={"load": [0.0, 1e-8]}, together=("load", "adhesion%work_of_adhesion"))
        np.testing.assert_allclose(listed.contact_radius, other.solve().contact_radius, rtol=1e-14)
        with self.assert_raises_text(InputError, "together: no array was given for lambda"):
            adfric.scene(**tip, together=("load", "lambda"))

    def test_quantities(self):
        try:
            import pint
        except ImportError:
            self.skipTest("there is no pint")
        units = pint.get_application_registry()
        found = adfric.solve(surface={**HEIGHTS, "heights": units.Quantity(MAP*1e6, "um"), "length_x": 0.1*units.mm},
                             solid={"contact_modulus": 1.0*units.GPa}, operating={"mean_pressure": units.Quantity([1.0, 5.0], "MPa")})
        expected = adfric.solve(surface=HEIGHTS, solid={"contact_modulus": 1e9}, operating={"mean_pressure": [1e6, 5e6]})
        np.testing.assert_allclose(expected.contact_fraction, found.contact_fraction, rtol=1e-6)
        with self.assert_raises_text(InputError, "surface%heights", "second", "allowed: m"):
            adfric.scene(surface={**HEIGHTS, "heights": units.Quantity(MAP, "s")}, solid={"contact_modulus": 1e9})

    def test_refusals(self):
        """One line each, and what is missing is said by check and solve."""
        solid = {"contact_modulus": 1e9}
        for change, words in (({"heights": MAP*np.nan}, "&surface heights: NaN or Inf"), ({"heights": MAP[:2, :2]}, "too few values"),
                              ({"heights": np.zeros((4, 4, 4))}, "surface%heights: given an array of 3 dimensions"),
                              ({"hights": MAP}, "unknown variable, given 'surface%hights'.*did you mean 'heights'"),
                              ({"length_x": [1e-4, "a"]}, "surface%length_x: .*allowed: numbers"),
                              ({"heights": {"z": MAP}}, "surface%heights: given a table, allowed: "),
                              ({"heights": xr.DataArray(MAP, dims=("y", "x"), attrs={"units": "nm"})}, "given in nm, allowed: m")):
            with self.subTest(words), self.assertRaisesRegex(InputError, words) as problem:
                adfric.scene(surface={**HEIGHTS, **change}, solid=solid, operating={"mean_pressure": 1e6})
            self.assertEqual(1, len(str(problem.exception).splitlines()))
        case = adfric.scene(surface={name: value for name, value in HEIGHTS.items() if name != "length_y"}, solid=solid,
                            operating={"mean_pressure": 1e6})
        for call in (case.check, case.solve):
            with self.assertRaisesRegex(InputError, "^&surface length_y: is missing"):
                call()
        case.set(length_y=2e-4)
        case.check()
        with self.assertRaisesRegex(InputError, "&history: nothing solves heights .* the nearest scene"):
            adfric.scene(surface=HEIGHTS, solid={"extent": "foundation", "stiffness": 1e9}, history={"loads": [1.0, 2.0]})
        with self.assertRaisesRegex(InputError, "solid%master_curve: the table has no loss, allowed: columns omega, storage, loss"):
            adfric.scene(surface=HEIGHTS, solid={"master_curve": {"omega": OMEGA, "storage": OMEGA}}, operating={"velocity": 1.0})
        with self.assertRaisesRegex(InputError, "&uncertain or .*: a scene whose values come later has none"):
            adfric.scene(surface=HEIGHTS, solid=solid, operating={"mean_pressure": 1e6},
                         uncertain={"variable": "mean_pressure", "relative_error": 0.1})
        with self.assertRaisesRegex(InputError, "&surface or &traction"):
            adfric.solve(solid=solid)
        with self.assertRaisesRegex(InputError, "load: given 1.0, allowed: a dictionary"):
            adfric.solve(surface={"kind": "cone", "slope": 0.1}, solid=solid, load=1.0)


class SceneFits(InFolder):
    """Fits of scenes."""

    KNOWN = {"surface": {"kind": "paraboloid", "radius": 140e-9}, "solid": {"contact_modulus": 44e9}, "operating": {"state": "sliding"}}
    FREE = ["work_of_adhesion", "shear_strength"]
    NAMES = ("load", "friction_force")

    def setUp(self):
        super().setUp()
        lines = [line for line in (SOURCE/"inputs/fit_friction.csv").read_text().splitlines() if not line.startswith("#")]
        self.points = dict(zip(lines[0].split(","), np.loadtxt(lines[1:], delimiter=",").T.copy()))

    def test_command(self):
        """The shipped input and the same groups with arrays: every result, to the bit."""
        for name in ("fit_friction.nml", "fit_friction.csv"):
            Path(name).write_bytes((SOURCE/"inputs"/name).read_bytes())
        subprocess.run([PROGRAM, "fit", "--quiet", "fit_friction.nml"], check=True)
        of_file = adfric.open("fit_friction.h5")
        found = adfric.fit(self.points, *self.NAMES, free=[*self.FREE, "lambda"], intervals="profile", theories=["jkr", "dmt"],
                           events=[{"kind": "pull_off_load", "value": -125.454e-9, "sigma": 1.259e-9}], title="A fit of friction against load",
                           adhesion={"theory": "maugis_dugdale"}, friction={"edge_fraction": 0.4}, **self.KNOWN)
        self.assertEqual(set(of_file.variables), set(found.results.variables))
        xr.testing.assert_equal(of_file, found.results)
        self.assertEqual(2, len(found.minima))

    def test_forms(self):
        """Tables, xarray, quantities, and abscissa and ordinate by name."""
        known = {**self.KNOWN, "adhesion": {"theory": "jkr"}}
        expected = adfric.fit("sphere", self.points, *self.NAMES, free=self.FREE, radius=140e-9, contact_modulus=44e9, state="sliding", theory="jkr")
        found = adfric.fit(self.points, *self.NAMES, free=self.FREE, **known)
        self.assertEqual(expected.estimates, found.estimates)
        self.assertEqual(expected.errors, found.errors)
        dataset = xr.Dataset({name: ("i", values) for name, values in self.points.items()})
        Path("tip.csv").write_text("load,friction_force,sigma\n" + "".join(
            f"{load!r},{force!r},{error!r}\n" for load, force, error in zip(*(column.tolist() for column in self.points.values()))))
        for form in (dataset, dataset.to_dataframe(), "tip.csv", [self.points], {"file": "tip.csv"}):
            same = adfric.fit(form, abscissa="load", ordinate="friction_force", free=self.FREE, **known)
            self.assertEqual(expected.estimates, same.estimates)
        forces = np.stack([self.points["friction_force"]*factor for factor in (1.0, 1.1)])
        stack = adfric.fit({**self.points, "friction_force": forces}, *self.NAMES, free=self.FREE, **known)
        self.assertEqual(expected.estimates["shear_strength"], stack.estimates["shear_strength"][0].item())

    def test_quantities(self):
        try:
            import pint
        except ImportError:
            self.skipTest("there is no pint")
        units = pint.get_application_registry()
        known = {**self.KNOWN, "adhesion": {"theory": "jkr"}}
        expected = adfric.fit(self.points, *self.NAMES, free=self.FREE, **known)
        points = {"load": units.Quantity(self.points["load"]*1e9, "nN"), "friction_force": units.Quantity(self.points["friction_force"]*1e9, "nN"),
                  "sigma": self.points["sigma"]}
        known["surface"] = {"kind": "paraboloid", "radius": 140*units.nm}
        found = adfric.fit(points, *self.NAMES, free=self.FREE, **known)
        for name in self.FREE:
            np.testing.assert_allclose(expected.estimates[name], found.estimates[name], rtol=1e-9)
        with self.assert_raises_text(InputError, "column load", "second", "allowed: N"):
            adfric.fit({**points, "load": units.Quantity(self.points["load"], "s")}, *self.NAMES, free=self.FREE, **known)

    def test_arrays(self):
        """A scene of lists and of a master curve is fitted as that of an input which names datasets."""
        velocities = np.logspace(-3, 1, 9)
        with h5py.File("data.h5", "w") as file:
            for name, values in CURVE.items():
                file[f"dma/{name}"] = values
        cosines = {"kind": "cosines", "period": 1e-3, "amplitudes": [1e-5, 3e-6], "phases": (0.0, 1.0)}
        solid = {"extent": "foundation", "master_curve": CURVE, "poisson_ratio": 0.5, "thickness": 1e-2}
        truth = adfric.solve(surface=cosines, solid=solid, operating={"mean_pressure": 2e4, "velocity": velocities})
        points = {"velocity": velocities, "friction_stress": truth.friction_stress.values, "sigma": np.full(9, 10.0)}
        found = adfric.fit(points, "velocity", "friction_stress", free={"mean_pressure": {"start": 1e4, "minimum": 1e3, "maximum": 1e5}},
                           surface=cosines, solid=solid)
        np.testing.assert_allclose(found.estimates["mean_pressure"], 2e4, rtol=1e-4)
        Path("points.csv").write_text("velocity,friction_stress,sigma\n" + "".join(
            f"{v!r},{f!r},10.0\n" for v, f in zip(velocities.tolist(), points["friction_stress"].tolist())))
        Path("fit.nml").write_text(
            "&surface kind = 'cosines', period = 1e-3, amplitudes = 1e-5, 3e-6, phases = 0.0, 1.0 /\n"
            "&solid extent = 'foundation', master_curve = 'data.h5:/dma', poisson_ratio = 0.5, thickness = 1e-2 /\n"
            "&data file = 'points.csv', abscissa = 'velocity', ordinate = 'friction_stress' /\n"
            "&free variable = 'mean_pressure', start = 1e4, minimum = 1e3, maximum = 1e5 /\n")
        self.assertEqual(adfric.fit("fit.nml").estimates, found.estimates)

    def test_refusals(self):
        for given, words in (((self.points, *self.NAMES, 3), "given 4 arguments without a name"), (("spheer", self.points), "abscissa: given dict"),
                             ((), "data: not given"), (([], *self.NAMES), "empty list")):
            with self.subTest(words), self.assertRaisesRegex(InputError, words):
                adfric.fit(*given, free=self.FREE, **self.KNOWN)
        for change, words in (({"free": ["shear_strength", "edge_fractio"]}, "edge_fractio.*did you mean"), ({"surface": {"kind": "paraboloid", "radus": 1.0}}, "radus"),
                              ({"surface": {"kind": "paraboloid", "radius": [1.0, 2.0]}}, "radius"), ({"solid": 3}, "solid: given 3, allowed: a dictionary"),
                              ({"abscissa": "load"}, "abscissa: given twice")):
            with self.subTest(words), self.assertRaisesRegex(InputError, words):
                adfric.fit(self.points, *self.NAMES, **{"free": self.FREE, **self.KNOWN, **change})


if __name__ == "__main__":
    unittest.main()
