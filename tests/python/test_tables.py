# SPDX-License-Identifier: GPL-3.0-or-later
"""The models as the program's help has them, figures, surfaces, and the command."""

import inspect
import os
import subprocess
import unittest
import zipfile
from pathlib import Path

import numpy as np
import xarray as xr
from cases import SURFACE, TIP, InFolder

import adfric
from adfric.command import PROGRAM


def has(module):
    """Is there a package?"""
    try:
        __import__(module)
    except ImportError:
        return False
    return True


class Tables(InFolder):
    """Models and what is drawn, read and run."""

    def test_models(self):
        models = adfric.models()
        self.assertIn("sphere", models)
        self.assertEqual(len(models), len(list(models)))
        self.assertIn("wavy_sliding", repr(models))
        for model in models.values():
            text = subprocess.run([PROGRAM, "help", model.name], capture_output=True, text=True, check=True).stdout
            for name, variable in model.variables.items():
                self.assertRegex(text, rf"\b{variable.name}\b", model.name)
                self.assertIn(f"{name} : {variable.unit or variable.kind}\n", model.__doc__)
            for result in (*model.results.values(), *model.profiles.values()):
                self.assertIn(f"{result.name} : {result.unit}\n", model.__doc__)
            self.assertIn("status", model.results)
            # arguments of solve are no names of variables, and no group has the name of a variable
            groups = {variable.group for variable in model.variables.values()}
            self.assertFalse({"together", "threads", "progress", "model"} & set(model.variables), model.name)
            self.assertFalse(groups & {variable.name for variable in model.variables.values() if variable.kind != "array"}, model.name)
        sphere = models["sphere"]
        self.assertEqual("N", sphere.variables["load"].unit)
        self.assertEqual(("si", "reduced"), sphere.variables["units"].choices)
        self.assertIn("radius", inspect.signature(sphere).parameters)
        xr.testing.assert_equal(sphere(**TIP, load=0.0), adfric.solve("sphere", **TIP, load=0.0))

    def test_defaults(self):
        with adfric.Case("sphere") as case:
            case.set(**TIP, load=0.0, edge_fraction=0.1, shear_strength=1e8, state="sliding")
            changed = case.solve()
            case.set(edge_fraction=None)
            self.assertEqual(adfric.models()["sphere"].variables["edge_fraction"].default, f"{case.solve().edge_fraction.item():g}")
            self.assertNotEqual(changed.friction_force, case.solve().friction_force)

    @unittest.skipUnless(has("matplotlib"), "there is no matplotlib")
    def test_plot(self):
        results = adfric.solve("sphere", **TIP, load=np.linspace(0, 1e-7, 20), shear_strength=1e8, state="sliding")
        results.to_netcdf("results.h5", engine="h5netcdf")
        of_file = adfric.plot("results.h5")
        of_dataset = adfric.plot(results, output="figure.png")
        self.assertTrue((self.folder/"figure.png").read_bytes().startswith(b"\x89PNG"))
        for one, other in zip(of_file.axes, of_dataset.axes, strict=True):
            self.assertEqual(one.get_xlabel(), other.get_xlabel())
            for line, same in zip(one.lines, other.lines, strict=True):
                np.testing.assert_array_equal(line.get_xydata(), same.get_xydata())
        self.assertEqual(2, len(adfric.plot([results, "results.h5"], x="load", y=["contact_radius", "approach"]).axes))
        for given, words in (({"output": "figure.doc"}, "figure.doc"), ({"x": "lod"}, "lod"), ({"y": "lod"}, "lod")):
            with self.assert_raises_text(adfric.InputError, words):
                adfric.plot(results, **given)
        with self.assert_raises_text(adfric.InputError, "empty list"):
            adfric.plot([])
        for given in (3, "none.h5", [results, 3]):
            with self.assertRaises(adfric.InputError):
                adfric.plot(given)
        with self.assertRaises(adfric.FailedError):
            adfric.plot(results, output="none/figure.png")

    @unittest.skipUnless(has("SurfaceTopography"), "there is no SurfaceTopography")
    def test_surface(self):
        heights = SURFACE["heights"]
        np.save("heights.npy", heights*1e6)
        surface = adfric.read_surface("heights.npy", unit="um", spacing=(3.125, 3.125), periodic=True, detrend="none")
        np.testing.assert_allclose(surface, heights, rtol=1e-15)
        self.assertEqual(("y", "x"), surface.dims)
        self.assertAlmostEqual(1e-4, surface.attrs["length_x"], 18)
        found = adfric.solve("surface_elastic", heights=surface, length_x=surface.length_x, length_y=surface.length_y,
                             contact_modulus=1e9, mean_pressure=1e6)
        np.testing.assert_allclose(adfric.solve("surface_elastic", **SURFACE, mean_pressure=1e6).contact_fraction,
                                   found.contact_fraction, rtol=1e-12)
        with self.assert_raises_text(adfric.InputError, "does not state the spacing", "give spacing"):
            adfric.read_surface("heights.npy", unit="um")
        with zipfile.ZipFile("none.npz", "w") as file:
            file.writestr("notes.txt", "no array")
        with self.assert_raises_text(adfric.InputError, "none.npz", "no array of real numbers"):
            adfric.read_surface("none.npz")
        with self.assert_raises_text(adfric.InputError, "average"):
            adfric.read_surface("heights.npy", unit="um", spacing=1.0, average=0)
        with self.assert_raises_text(adfric.FailedError, "none.npy"):
            adfric.read_surface("none.npy")

    def test_command(self):
        """The command that comes with the package."""
        (self.folder/"tip.nml").write_text("&job model = 'sphere' /\n&sphere radius = 1e-6, contact_modulus = 1e9, work_of_adhesion = 0 /\n"
                                           "&operating load = 1e-6 /\n")
        found = adfric.run("tip.nml", output=Path("tip.h5"), threads=1)
        xr.testing.assert_equal(found, adfric.run(Path("tip.nml")))
        self.assertEqual(found.attrs["input"], (self.folder/"tip.nml").read_text())
        shown = subprocess.run([PROGRAM, "--version"], capture_output=True, text=True, check=True).stdout
        self.assertIn(adfric.__version__, shown)
        self.assertTrue(os.access(PROGRAM, os.X_OK))


if __name__ == "__main__":
    unittest.main()
