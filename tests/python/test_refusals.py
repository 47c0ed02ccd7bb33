# SPDX-License-Identifier: GPL-3.0-or-later
"""What is wrong is said in the words of the program, and changes nothing."""

import contextlib
import threading
import unittest

import numpy as np
import xarray as xr
from cases import SURFACE, TIP, InFolder

import adfric
from adfric import FailedError, InputError


class Refusals(InFolder):
    """Bad input through every door."""

    def check_values(self, error, words, model="sphere", **values):
        """A case that refuses values gives the same results as before."""
        given = dict(TIP, load=[0.0, 1e-7]) if model == "sphere" else dict(SURFACE, mean_pressure=1e6)
        with adfric.Case(model) as case:
            case.set(**given)
            before = case.solve()
            with self.assert_raises_text(error, *words):
                case.set(**values)
            xr.testing.assert_equal(before, case.solve())

    def test_names(self):
        with self.assert_raises_text(InputError, "unknown model", "did you mean 'sphere'"):
            adfric.solve("spheer")
        self.check_values(InputError, ("unknown variable", "did you mean 'radius'"), radus=1.0)
        self.check_values(InputError, ("friction%radus",), friction={"radus": 1.0})
        self.check_values(InputError, ("frictoin", "friction"), frictoin={"shear_strength": 1.0})
        self.check_values(InputError, ("theory", "hertzz", "did you mean 'hertz'"), theory="hertzz")
        self.check_values(InputError, ("name of a variable", "without characters that are 0"), **{"load\0x": 1.0})
        self.check_values(InputError, ("theory", "without characters that are 0"), theory="jkr\0x")
        for path in ("a.nml\0b.nml", b"a.nml\0"):
            with self.assert_raises_text(InputError, "path", "without characters that are 0"):
                adfric.Case.read(path)
        with self.assert_raises_text(KeyError, "did you mean 'sphere'"):
            adfric.models()["spheer"]
        for name in (3, None, b"sphere"):
            with self.assert_raises_text(InputError, "model", "a text"):
                adfric.solve(name)

    def test_numbers(self):
        for value in (np.nan, np.inf, -1.0, 0.0, 0, -3, float("1e400")):
            self.check_values(InputError, ("radius",), radius=value)
        self.check_values(InputError, ("load",), load=[1.0, np.nan])
        self.check_values(InputError, ("radius",), radius=[1.0, -1.0])
        self.check_values(InputError, ("radius", "64 bits"), radius=10**400)
        self.check_values(InputError, ("n_r", "64 bits"), n_r=2**63)
        self.check_values(InputError, ("n_r",), n_r=2.5)
        self.check_values(InputError, ("load", "numbers"), load=["a", "b"])
        self.check_values(InputError, ("load", "numbers"), load=np.array([1.0 + 1.0j]))
        self.check_values(InputError, ("load", "numbers"), load=1.0 + 1.0j)
        self.check_values(InputError, ("load", "numbers"), load=[True, False])
        self.check_values(InputError, ("load", "numbers"), load=object())
        self.check_values(InputError, ("load", "masked"), load=np.ma.array([1.0, 2.0], mask=[True, False]))
        self.check_values(InputError, ("load", "given in kN, allowed: N"), load=xr.DataArray([1.0], attrs={"units": "kN"}))
        load = xr.DataArray([1.0, 2.0], attrs={"units": "N/m"})
        self.assertEqual(2, adfric.solve("hertz", kind="line", radius=0.01, contact_modulus=1e9, load=load).sizes["load"])
        with self.assert_raises_text(InputError, "load: given in N/m, allowed: N$"):
            adfric.solve("hertz", kind="circular", radius=0.01, contact_modulus=1e9, load=load)
        for value in ("large", True):
            self.check_values(InputError, ("radius",), radius=value)
        self.check_values(InputError, ("theory",), theory=1.0)
        self.check_values(InputError, ("profiles",), profiles=1.0)

    def test_shapes(self):
        self.check_values(InputError, ("load",), load=[])
        self.check_values(InputError, ("load", "2 dimensions"), load=np.zeros((2, 2)))
        self.check_values(InputError, ("load", "different lengths"), load=[[1.0], [1.0, 2.0]])
        self.check_values(InputError, ("theory",), theory=[1.0, 2.0])
        for heights in (np.zeros((4, 4, 4)), np.zeros((2, 8)), np.full((8, 8), np.nan), 1.0):
            with adfric.Case("surface_elastic") as case, self.assert_raises_text(InputError, "heights"):
                case.set(heights=heights)
        for together, words in ((("load", "radius"), "no array was given for radius"), ("load", "a list of names"),
                                (("load", "edge_fraction"), "one length")):
            with self.assert_raises_text(InputError, "together", words):
                adfric.solve("sphere", **TIP, load=[0.0, 1e-7], edge_fraction=[0.1, 0.2, 0.3], together=together)

    def test_together(self):
        """All that is missing or contradictory is said at once."""
        with self.assertRaises(InputError) as problem:
            adfric.solve("sphere", load=0.0)
        self.assertGreater(len(str(problem.exception).splitlines()), 1)

    def test_threads(self):
        for threads in (-1, 1.5, "2", 2**31, True):
            with self.assert_raises_text(InputError, "threads"):
                adfric.solve("sphere", **TIP, load=0.0, threads=threads)

    def test_paths(self):
        """A character that is 0 would end a name for the system."""
        for call in (adfric.run, adfric.open, adfric.Case.read, adfric.read_surface, adfric.read_curve, adfric.read_master_curve,
                     adfric.plot, lambda name: adfric.plot("a.h5", output=name),
                     lambda name: adfric.run("a.nml", output=name), lambda name: adfric.run(name, output="a.h5"),
                     lambda name: adfric.plot("a.h5", data=name)):
            for name in ("a\0b", b"a\0b"):
                with self.assert_raises_text(InputError, "without characters that are 0"):
                    call(name)
        for call in (adfric.run, adfric.open, adfric.Case.read):
            with self.assert_raises_text(InputError, "the name of a file"):
                call(3)

    def test_closed(self):
        case = adfric.Case("sphere")
        case.close()
        for call in (case.close, case.check, case.solve, lambda: case.set(load=1.0), lambda: case.n_points, lambda: case.model):
            with self.assert_raises_text(InputError, "closed"):
                call()
        self.assertIn("closed", repr(case))
        with adfric.Case("sphere") as case:
            case.close()

    def test_in_use(self):
        """A case that another thread solves is refused. That somebody else can ask at all says that Python's lock is free."""
        case = adfric.Case("sphere")
        case.set(**TIP, load=np.linspace(0, 1e-7, 20000))
        seen = threading.Event()

        def solve():
            while not seen.is_set():
                # this thread may be refused while the other one asks
                with contextlib.suppress(InputError):
                    case.solve()

        worker = threading.Thread(target=solve)
        worker.start()
        try:
            while not seen.is_set():
                try:
                    case.n_points
                except InputError as problem:
                    self.assertIn("thread", str(problem))
                    seen.set()
        finally:
            seen.set()
            worker.join()
        case.close()

    def test_files(self):
        with self.assert_raises_text((FailedError, InputError), "none.nml"):
            adfric.run("none.nml")
        (self.folder/"bad.nml").write_text("&job model = 'sphere' /\n&sphere radus = 1 /\n")
        for output in (None, "bad.h5"):
            with self.assert_raises_text(InputError, "bad.nml", "radus", "did you mean"):
                adfric.run("bad.nml", output=output)
        (self.folder/"good.nml").write_text("&job model = 'hertz' /\n&contact kind = 'line', radius = 1 /\n"
                                            "&solid contact_modulus = 1 /\n&operating load = 1 /\n")
        (self.folder/"here.h5").write_text("mine")
        with self.assert_raises_text(FailedError, "here.h5"):
            adfric.run("good.nml", output="here.h5")
        self.assertEqual("mine", (self.folder/"here.h5").read_text())
        for name, error in (("none.h5", FailedError), ("here.h5", FailedError)):
            with self.assert_raises_text(error, name):
                adfric.open(name)
        xr.Dataset({"a": 1.0}).to_netcdf("other.h5", engine="h5netcdf")
        with self.assert_raises_text(InputError, "other.h5", "not a results file"):
            adfric.open("other.h5")

    def test_texts(self):
        with self.assert_raises_text(InputError, "radus"):
            adfric.Case.read_text("&job model = 'sphere' /\n&sphere radus = 1 /")
        with adfric.Case.read_text("&job model = 'hertz' /\n&contact kind = 'line', radius = 1 /\n&solid contact_modulus = 1 /\n"
                                   "&sweep variable = 'load', values = 1, 2, 3 /") as case:
            self.assertEqual(("hertz", 3), (case.model, case.n_points))


if __name__ == "__main__":
    unittest.main()
