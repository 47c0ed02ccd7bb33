# SPDX-License-Identifier: GPL-3.0-or-later
"""What Python finds is what the results file of the same input has, field by field and bit by bit."""

import copy
import gc
import pickle
import subprocess
import sys
import unittest

import h5py
import numpy as np
import xarray as xr
from cases import OF_THE_FILE, SOURCE, SURFACE, TIP, InFolder

import adfric
from adfric.library import library

# Every kind of model, sweeps, profiles along one and two axes, events, lists, points swept together.
INPUTS = ("johnson1997_fig5", "johnson1997_fig9a", "gm2011_fig8", "hertz_axes", "punch_stress", "line_load", "strip_load_maps",
          "point_load", "wave_1d_adhesion", "wave_2d_contact")
WAVE = """
&job model = 'wavy_sliding', title = 'A wave' /
&surface kind = 'wave_3d', period = 1e-2, height = 1e-4 /
&foundation stiffness = 1e8, relaxation_time = 1e-3, retardation_ratio = 10 /
&adhesion range = 1e-5 /
&operating velocity = 0.5 /
&sweep variable = 'stress', values = 0, 2e3 /
&sweep variable = 'penetration', values = 2e-5, 8e-5, 9e-4 /
&output profiles = .true., n_x = 9, n_y = 5 /
"""
RUBBER = """
&job model = 'wave_1d' /
&surface period = 1e-3, amplitude = 2e-5 /
&material young_modulus = 2e6, poisson_ratio = 0.5, young_moduli = 2e6, 1e7, relaxation_times = 1e-3, 1e-2 /
&operating mean_pressure = 5e4 /
&sweep variable = 'velocity', values = 1e-3, 1e-1, 1e1 /
"""
DATA = """
&job model = 'surface_elastic' /
&surface heights = 'surface.h5:/heights', length_x = 1e-4, length_y = 0.5e-4 /
&solid contact_modulus = 1e9 /
&operating mean_pressure = 1e6 /
&output profiles = .true. /
"""


def without(dataset, names):
    """A dataset without some attributes."""
    kept = {name: value for name, value in dataset.attrs.items() if name not in names}
    return dataset.drop_attrs(deep=False).assign_attrs(kept)


class Results(InFolder):
    """Datasets of solve and run."""

    def check_same(self, found, of_file):
        """The same names, dimensions, coordinates, types, values and attributes."""
        self.assertEqual(set(of_file.attrs) - OF_THE_FILE, set(found.attrs) - OF_THE_FILE)
        self.assertEqual(set(of_file.data_vars), set(found.data_vars))
        for name in of_file.variables:
            self.assertEqual(of_file[name].dtype, found[name].dtype, name)
        xr.testing.assert_identical(without(of_file, OF_THE_FILE), without(found, OF_THE_FILE))

    def test_inputs(self):
        for name in INPUTS:
            with self.subTest(name=name):
                path = SOURCE/f"inputs/{name}.nml"
                self.check_same(adfric.run(path), adfric.run(path, output="results.h5", force=True))

    def test_maps_and_datasets(self):
        with h5py.File("surface.h5", "w") as file:
            file["heights"] = SURFACE["heights"]
        for text in (WAVE, RUBBER, DATA):
            (self.folder/"input.nml").write_text(text)
            of_file = adfric.run("input.nml", output="results.h5", force=True)
            self.check_same(adfric.run("input.nml"), of_file)
        # the same by name; the input's text and the name of the dataset are of the file
        found = adfric.solve("surface_elastic", **SURFACE, mean_pressure=1e6, profiles=True)
        self.assertEqual(("y", "x"), found.pressure.dims)
        xr.testing.assert_equal(of_file, found)

    def test_sweeps(self):
        loads, lambdas = np.linspace(0, 1e-7, 4), [0.2, 0.1]
        found = adfric.solve("sphere", radius=140e-9, contact_modulus=50e9, work_of_adhesion=0.2, lambda_=lambdas, load=loads)
        self.assertEqual(("lambda", "load"), found.contact_radius.dims)
        np.testing.assert_array_equal(loads, found["load"])
        np.testing.assert_array_equal(lambdas, found["lambda"])
        for i, one in enumerate(lambdas):
            alone = adfric.solve("sphere", radius=140e-9, contact_modulus=50e9, work_of_adhesion=0.2, load=loads, sphere={"lambda": one})
            np.testing.assert_array_equal(alone.contact_radius, found.contact_radius[i])
        listed = adfric.solve("sphere", radius=140e-9, contact_modulus=50e9, work_of_adhesion=0.2, lambda_=[0.2, 0.1, 0.2, 0.1],
                              load=loads, together=("lambda", "load"))
        self.assertEqual(("point",), listed.contact_radius.dims)
        np.testing.assert_allclose(found.contact_radius.values[[0, 1, 0, 1], range(4)], listed.contact_radius, rtol=1e-14)

    def test_order_of_sweeps(self):
        one = adfric.solve("sphere", **TIP, load=[0.0, 1e-7], edge_fraction=[0.2, 0.4], shear_strength=1e8, state="sliding")
        other = adfric.solve("sphere", **TIP, edge_fraction=[0.2, 0.4], load=[0.0, 1e-7], shear_strength=1e8, state="sliding")
        self.assertEqual(("load", "edge_fraction"), one.friction_force.dims)
        np.testing.assert_allclose(one.friction_force, other.friction_force.transpose("load", "edge_fraction"), rtol=1e-14)

    def test_states(self):
        found = adfric.solve("sphere", **TIP, load=[0.0, -1.0])
        self.assertEqual([0, 1], found.status.values.tolist())
        self.assertTrue(np.isnan(found.contact_radius[1]))
        self.assertEqual("solved", found.status.attrs["flag_meanings"].split()[list(found.status.attrs["flag_values"]).index(0)])

    def test_threads_and_kinds_of_numbers(self):
        loads = np.linspace(0, 1e-7, 2000)
        first = adfric.solve("sphere", **TIP, load=loads, threads=1)
        xr.testing.assert_equal(first, adfric.solve("sphere", **TIP, load=loads, threads=3))
        # other orders in memory, types and containers are the same numbers
        for values in (loads.tolist(), np.repeat(loads, 2)[::2], xr.DataArray(loads, attrs={"units": "N"}), np.ma.array(loads)):
            xr.testing.assert_equal(first, adfric.solve("sphere", **TIP, load=values))
        whole = adfric.solve("sphere", **dict(TIP, contact_modulus=np.int64(50_000_000_000)), load=np.float64(0))
        xr.testing.assert_equal(adfric.solve("sphere", **TIP, load=0), whole)
        self.assertEqual((), whole.contact_radius.shape)

    def test_memory(self):
        """Arrays are there as long as somebody has them, and no longer."""
        found = adfric.solve("sphere", **TIP, load=np.linspace(0, 1e-7, 100))
        radius = found.contact_radius.values
        handle = radius.base.owner.handle
        kept = radius.copy()
        del found
        gc.collect()
        for _ in range(50):
            adfric.solve("sphere", **TIP, load=np.linspace(1e-7, 2e-7, 100))
        np.testing.assert_array_equal(kept, radius)
        del radius
        gc.collect()
        with self.assertRaises(adfric.InputError):
            library.adfric_close_results(handle)

    def test_written_and_opened(self):
        found = adfric.solve("sphere", **TIP, load=np.linspace(-1e-7, 1e-7, 5))
        found.to_netcdf("kept.h5", engine="h5netcdf")
        xr.testing.assert_identical(found, adfric.open("kept.h5"))

    def test_pandas(self):
        found = adfric.solve("sphere", **TIP, load=[0.0, 1e-7])
        table = found.to_dataframe()
        np.testing.assert_array_equal(found.contact_radius, table["contact_radius"])

    def test_quantities(self):
        try:
            import pint
            import pint_xarray  # noqa: F401
        except ImportError:
            self.skipTest("there is no pint-xarray")
        units = pint.get_application_registry()
        found = adfric.solve("sphere", **dict(TIP, radius=0.14*units.um), load=units.Quantity([0.0, 100.0], "nN"))
        np.testing.assert_allclose(found["load"], [0.0, 1e-7], rtol=4e-16)
        quantified = found.pint.quantify()
        self.assertAlmostEqual(found.contact_radius.values[1]*1e9, quantified.contact_radius[1].pint.to("nm").item().magnitude, 12)
        line = {"kind": "line", "radius": 0.01, "contact_modulus": 1e9}
        found = adfric.solve("hertz", **line, load=units.Quantity(2.0, "kN/m"))
        xr.testing.assert_equal(found, adfric.solve("hertz", **line, load=2000.0))
        with self.assert_raises_text(adfric.InputError, "load", "allowed: N; N/m for line"):
            adfric.solve("hertz", **line, load=units.Quantity(2.0, "m"))
        with self.assert_raises_text(adfric.InputError, "load: given in N, allowed: N/m"):
            adfric.solve("hertz", **line, load=units.Quantity(2.0, "N"))
        with self.assert_raises_text(adfric.InputError, "radius", "second"):
            adfric.solve("sphere", **dict(TIP, radius=1.0*units.s), load=0.0)


class Cases(InFolder):
    """Cases that are set many times, and sent to other processes."""

    def test_find(self):
        """Numbers alone are those of the dataset."""
        with adfric.Case("sphere") as case:
            case.set(**TIP)
            for load in (0.0, 1e-7, -1e-3):
                found = adfric.solve("sphere", **TIP, load=load)
                names = ("contact_radius", "approach", "stable", "status", "error_estimate")
                for name, value in zip(names, case.find(*names, load=load), strict=True):
                    expected = float(found[name])
                    if name == "stable" and expected < 0:
                        expected = np.nan
                    np.testing.assert_equal(value, expected, err_msg=name)
            self.assertEqual(case.find("contact_radius", load=1e-7), adfric.solve("sphere", **TIP, load=1e-7).contact_radius.item())
            with self.assert_raises_text(adfric.InputError, "contact_radus", "did you mean 'contact_radius'"):
                case.find("contact_radus")
            with self.assert_raises_text(adfric.InputError, "given none"):
                case.find()
            case.set(load=[0.0, 1e-7])
            with self.assert_raises_text(adfric.InputError, "2 points"):
                case.find("contact_radius")
            with self.assert_raises_text(adfric.InputError, "radius"):
                case.find("contact_radius", load=0.0, radius=-1.0)

    def test_single(self):
        """A dataset of one point is as xarray would make it."""
        found = adfric.solve("sphere", **TIP, load=1e-8, profiles=False)
        same = xr.Dataset({name: found[name].variable for name in found.data_vars}, {name: found[name].variable for name in found.coords},
                          found.attrs)
        xr.testing.assert_identical(same, found)
        self.assertEqual(found.contact_radius.item()*2, (found + found).contact_radius.item())
        xr.testing.assert_identical(found.expand_dims("run").isel(run=0), found)

    def check_pickled(self, case):
        """A case is the same in another process."""
        before = case.solve()
        program = ("import pickle, sys; found = pickle.load(sys.stdin.buffer).solve(); "
                   "pickle.dump(found.load(), sys.stdout.buffer)")
        done = subprocess.run([sys.executable, "-c", program], input=pickle.dumps(case), stdout=subprocess.PIPE, check=True)
        xr.testing.assert_equal(before, pickle.loads(done.stdout))
        xr.testing.assert_equal(before, copy.deepcopy(case).solve())

    def test_pickle(self):
        case = adfric.Case("sphere")
        case.set(**TIP, load=[0.0, 1e-7], shear_strength=1e8, state="sliding")
        self.check_pickled(case)
        # an order that is not that of the first sweeps
        case.set(radius=[1e-7, 2e-7], edge_fraction=[0.1, 0.2])
        case.set(load=0.0)
        case.set(load=[1e-8, 2e-8, 3e-8], edge_fraction=None)
        self.assertEqual(("radius", "load"), case.solve().contact_radius.dims)
        self.check_pickled(case)
        case.set(edge_fraction=[0.1, 0.2, 0.3])
        case.sweep_together(["load", "edge_fraction"])
        case.set(contact_modulus=60e9)
        self.check_pickled(case)
        rough = adfric.Case("surface_elastic")
        heights = SURFACE["heights"].copy()
        rough.set(**{**SURFACE, "heights": heights}, mean_pressure=1e6)
        # what the caller does to his array is not for the case
        heights[:] = 0
        self.check_pickled(rough)
        text = "&job model = 'sphere' /\n&sphere radius = 1e-6, contact_modulus = 1e9, work_of_adhesion = 0 /\n&operating load = 1e-6 /\n"
        self.check_pickled(adfric.Case.read_text(text))
        (self.folder/"tip.nml").write_text(text)
        case = adfric.Case.read("tip.nml")
        case.set(load=2e-6)
        self.check_pickled(case)
        (self.folder/"tip.nml").write_text(text + "\n")
        with self.assert_raises_text(adfric.InputError, "has changed"):
            copy.deepcopy(case)
        case.close()
        with self.assert_raises_text(adfric.InputError, "closed"):
            pickle.dumps(case)


if __name__ == "__main__":
    unittest.main()
