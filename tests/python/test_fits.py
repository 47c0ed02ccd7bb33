# SPDX-License-Identifier: GPL-3.0-or-later
"""Fits from Python are those of the command, whatever form the data have."""

import os
import shutil
import signal
import subprocess
import unittest
from pathlib import Path

import numpy as np
import xarray as xr
from cases import SOURCE, InFolder

import adfric
from adfric import InputError
from adfric.command import PROGRAM

KNOWN = {"radius": 140e-9, "contact_modulus": 44e9, "state": "sliding", "theory": "jkr"}
FREE = ["work_of_adhesion", "shear_strength"]
NAMES = ("load", "friction_force")


def read_points():
    """The columns of the shipped example."""
    lines = [line for line in (SOURCE/"inputs/fit_friction.csv").read_text().splitlines() if not line.startswith("#")]
    return dict(zip(lines[0].split(","), np.loadtxt(lines[1:], delimiter=",").T.copy()))


class Fits(InFolder):
    """The friction of a tip, in many forms."""

    def setUp(self):
        super().setUp()
        self.points = read_points()
        self.expected = adfric.fit("sphere", self.points, *NAMES, free=FREE, **KNOWN)

    def check_same(self, found):
        self.assertEqual(self.expected.estimates, found.estimates)
        self.assertEqual(self.expected.errors, found.errors)

    def test_command(self):
        """An input gives what the results file has, to the bit; the same in arrays as well."""
        for name in ("fit_friction.nml", "fit_friction.csv"):
            shutil.copy(SOURCE/"tests/old_inputs"/name, self.folder)
        subprocess.run([PROGRAM, "fit", "--quiet", "fit_friction.nml"], check=True)
        of_file = adfric.open("fit_friction.h5")
        found = adfric.fit("fit_friction.nml")
        for name, values in of_file.variables.items():
            xr.testing.assert_identical(of_file[name].variable, found.results[name].variable)
            self.assertEqual(values.dims, found.results[name].dims)
        self.assertEqual(set(of_file.variables), set(found.results.variables))
        in_arrays = adfric.fit("sphere", self.points, *NAMES, free=[*FREE, "lambda"], intervals="profile", theories=["jkr", "dmt"],
                               events=[{"kind": "pull_off_load", "value": -125.454e-9, "sigma": 1.259e-9}],
                               **{**KNOWN, "theory": "maugis_dugdale"})
        xr.testing.assert_equal(found.results.drop_vars("title", errors="ignore"), in_arrays.results)
        self.assertEqual("fitted", found.status)
        # the two answers of this page of the manual
        self.assertEqual(2, len(found.minima))
        self.assertEqual(0.0, found.minima[0]["excess"])
        self.assertGreater(found.minima[1]["excess"], 0)
        sets = found.intervals["lambda"][0.95]
        self.assertEqual(2, len(sets))
        self.assertEqual(np.inf, sets[1][1])
        self.assertTrue(sets[1][0] < found.estimates["lambda"])
        self.assertEqual("J/m^2", found.units["work_of_adhesion"])
        self.assertEqual(("variable", "other_variable"), found.correlation.dims)
        self.assertIn("band_low", found.curve[0])
        self.assertIn("another minimum", repr(found))
        self.assertEqual(found.estimates, adfric.Fit(of_file).estimates)

    def test_forms(self):
        """Tables, units, xarray and pandas say the same."""
        Path("tip.csv").write_text("load [nN],friction_force,sigma\n" + "".join(
            f"{load*1e9!r},{force!r},{error!r}\n" for load, force, error in zip(*(column.tolist() for column in self.points.values()))))
        by_table = adfric.fit("sphere", "tip.csv", *NAMES, free=FREE, **KNOWN)
        nano = {"load [nN]": self.points["load"]*1e9, "friction_force": self.points["friction_force"], "sigma": self.points["sigma"]}
        for form in (Path("tip.csv"), nano, {"file": "tip.csv", "abscissa": "load", "ordinate": "friction_force"}, [nano]):
            self.assertEqual(by_table.estimates, adfric.fit("sphere", form, *NAMES, free=FREE, **KNOWN).estimates)
        dataset = xr.Dataset({"friction_force": ("i", self.points["friction_force"], {"units": "N"}),
                              "load": ("i", nano["load [nN]"], {"units": "nN"}), "sigma": ("i", self.points["sigma"])})
        self.assertEqual(by_table.estimates, adfric.fit("sphere", dataset, *NAMES, free=FREE, **KNOWN).estimates)
        array = xr.DataArray(self.points["friction_force"], {"load": self.points["load"]}, ("load",), "friction_force")
        by_array = adfric.fit("sphere", array, *NAMES, free=FREE, data_options={"sigma": 1e-9}, **KNOWN)
        by_mapping = adfric.fit("sphere", {name: self.points[name] for name in NAMES}, *NAMES, free=FREE, data_options={"sigma": 1e-9},
                                **KNOWN)
        self.assertEqual(by_mapping.estimates, by_array.estimates)
        renamed = {"P": self.points["load"], "F": self.points["friction_force"], "s": self.points["sigma"]}
        self.check_same(adfric.fit("sphere", renamed, *NAMES, free=FREE, **KNOWN,
                                   data_options={"abscissa_column": "P", "ordinate_column": "F", "sigma_column": "s"}))
        self.check_same(adfric.fit("sphere", self.points, *NAMES, free=dict.fromkeys(FREE), sphere={"radius": 140e-9},
                                   model={"theory": "jkr"}, contact_modulus=44e9, operating={"state": "sliding"}))

    def test_variables(self):
        """Points of two radii are one fit; a unit of a head is honoured, and a name without a column is refused."""
        radius, load = np.repeat([1e-3, 4e-3], 10), np.tile(np.linspace(1e-4, 1e-3, 10), 2)
        area = np.pi*(0.75*load*radius/2e6)**(2/3)
        points = {"radius": radius, "load": load, "contact_area": area, "sigma": 0.01*area}
        known = {"free": ["contact_modulus"], "surface": {"kind": "paraboloid"}}
        options = {"data_options": {"variables": ["radius"]}}
        found = adfric.fit(points, "load", "contact_area", **options, **known)
        self.assertAlmostEqual(2e6, found.estimates["contact_modulus"], delta=2.0)
        np.testing.assert_array_equal(radius, found.results.point_radius)
        frame = xr.Dataset({name: ("i", values) for name, values in points.items()})
        frame["r"] = ("i", radius*1e3, {"units": "mm"})
        other = adfric.fit(frame, "load", "contact_area", data_options={"variables": "radius", "variable_columns": "r"}, **known)
        self.assertAlmostEqual(1, other.estimates["contact_modulus"]/found.estimates["contact_modulus"], delta=1e-12)
        del points["radius"]
        with self.assertRaisesRegex(adfric.InputError, "unknown column, given radius"):
            adfric.fit(points, "load", "contact_area", **options, **known)

    def test_stack(self):
        """Each curve of a stack is a fit of its own, whatever the number of threads."""
        forces = np.stack([[self.points["friction_force"]*factor for factor in (1.0, 1.1, 1.2)]]*2)
        stack = {**self.points, "friction_force": forces}
        found = adfric.fit("sphere", stack, *NAMES, free=FREE, threads=2, **KNOWN)
        self.assertEqual((2, 3), found.estimates["work_of_adhesion"].shape)
        self.assertEqual(("row", "column"), found.status.dims)
        self.assertEqual(self.expected.estimates["shear_strength"], found.estimates["shear_strength"][1, 0].item())
        one = adfric.fit("sphere", {**self.points, "friction_force": forces[0, 2]}, *NAMES, free=FREE, **KNOWN)
        self.assertEqual(one.estimates["shear_strength"], found.estimates["shear_strength"][0, 2].item())
        dataset = xr.Dataset({"friction_force": (("i", "y", "x"), np.moveaxis(forces, -1, 0)), "load": ("i", self.points["load"]),
                              "sigma": ("i", self.points["sigma"])}).transpose("y", "x", "i")
        xr.testing.assert_equal(found.results, adfric.fit("sphere", dataset, *NAMES, free=FREE, threads=1, **KNOWN).results)
        with self.assert_raises_text(InputError, "intervals", "stack"):
            found.intervals

    def test_several(self):
        """Two tables with one model, each with a zero of its own."""
        shifted = {**self.points, "load": self.points["load"] + 5e-9}
        found = adfric.fit("sphere", [self.points, {"file": shifted, "load_offset": 5e-9}], *NAMES, free=FREE, **KNOWN)
        np.testing.assert_allclose(found.estimates["work_of_adhesion"], self.expected.estimates["work_of_adhesion"], rtol=1e-6)
        self.assertLess(found.errors["work_of_adhesion"], self.expected.errors["work_of_adhesion"])
        self.assertEqual(2, len(found.curve))

    def test_figure(self):
        try:
            import matplotlib  # noqa: F401
        except ImportError:
            self.skipTest("there is no matplotlib")
        axes = self.expected.plot("fit.png").axes
        self.assertTrue(Path("fit.png").read_bytes().startswith(b"\x89PNG"))
        self.assertEqual(2, len(axes))
        # the best curve, in the units of the axes
        curve = self.expected.curve[0]
        drawn = [line.get_xydata() for line in axes[0].lines if line.get_xydata().shape == (curve.sizes["curve_x"], 2)]
        self.assertEqual(1, len(drawn))
        np.testing.assert_allclose(drawn[0][:, 1]/curve.curve.values, drawn[0][0, 1]/curve.curve.values[0], rtol=1e-12)

    def test_refusals(self):
        for given, words in (({"free": ["work"]}, ("work", "did you mean 'work_of_adhesion'")), ({"free": []}, ("&free",)),
                             ({"radus": 1.0}, ("radus", "did you mean 'radius'")), ({"radius": [1.0, 2.0]}, ("radius", "several")),
                             ({"radius": np.nan}, ("radius",)), ({"intervals": "prof"}, ("intervals", "profile")),
                             ({"theories": ["jkr", "x"]}, ("theories",)), ({"title": "two\nlines"}, ("title", "one line")),
                             ({"events": [{"kind": "pull_off", "value": 1.0, "sigma": 1.0}]}, ("pull_off_load",)),
                             ({"threads": -1}, ("threads",)), ({"data_options": {"sgima": 1.0}}, ("sgima", "did you mean 'sigma'"))):
            with self.subTest(given=given), self.assert_raises_text(InputError, *words):
                adfric.fit("sphere", self.points, *NAMES, **{**KNOWN, "free": FREE, **given})
        short = {**self.points, "sigma": self.points["sigma"][:-1]}
        for data, words in ((short, ("sigma", "one length")), ({}, ("data",)), (3, ("data", "int")), ([], ("empty",)),
                            ({"load": self.points["load"]}, ("friction_force",)), ("none.csv", ("none.csv",)), ("a\0.csv", ("characters",)),
                            ({**self.points, "load [kg]": self.points["load"]}, ("load",)),
                            ({**self.points, "sigma": -self.points["sigma"]}, ("standard error",)),
                            ({**self.points, "load": self.points["load"] + 1j}, ("numbers",)),
                            ({**self.points, "load": np.full(80, 1e300)}, ("out of range",)),
                            ({**self.points, 3: self.points["load"]}, ("names",))):
            with self.subTest(data=str(data)[:60]), self.assert_raises_text(InputError, *words):
                adfric.fit("sphere", data, *NAMES, free=FREE, **KNOWN)
        with self.assert_raises_text(InputError, "unknown model"):
            adfric.fit("spheer", self.points, *NAMES, free=FREE)
        with self.assert_raises_text(InputError, "data: not given"):
            adfric.fit("fit_friction.nml", free=FREE)
        Path("run.nml").write_text("&job model = 'sphere' /\n&sphere radius = 1e-6, contact_modulus = 1e9, work_of_adhesion = 0 /\n"
                                   "&operating load = 1e-6 /\n")
        with self.assert_raises_text(InputError, "&data and &free"):
            adfric.fit("run.nml")

    def test_case(self):
        """A fit is a case that is solved once, and whose values are those of its input."""
        for name in ("fit_friction.nml", "fit_friction.csv"):
            shutil.copy(SOURCE/"inputs"/name, self.folder)
        with adfric.Case.read("fit_friction.nml") as case:
            self.assertEqual((1, "sphere"), (case.n_points, case.model))
            for call in (lambda: case.set(radius=1e-6), lambda: case.set(load=[1.0, 2.0])):
                with self.assert_raises_text(InputError, "as its input describes it"):
                    call()
            case.check()
            case.solve()
            with self.assert_raises_text(InputError, "solved once"):
                case.solve()

    def test_interrupt(self):
        """Ctrl-C ends the search."""
        told = []

        def interrupt(*_):
            told.append(True)
            os.kill(os.getpid(), signal.SIGINT)

        with self.assertRaises(KeyboardInterrupt):
            adfric.fit("sphere", self.points, *NAMES, free=[*FREE, "lambda"], intervals="bootstrap", refits=1000000,
                       progress=interrupt, **{**KNOWN, "theory": "maugis_dugdale"})
        self.assertTrue(told)


if __name__ == "__main__":
    unittest.main()
