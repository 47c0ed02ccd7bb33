# SPDX-License-Identifier: GPL-3.0-or-later
"""Force curves and master curves that are read, and what models and fits make of them."""

import unittest
import warnings
from pathlib import Path

import numpy as np
from cases import InFolder

import adfric
from adfric import InputError

K, RADIUS, MODULUS = 0.5, 2e-6, 5e6


class Curves(InFolder):
    """Curves of a ball on a soft solid, without adhesion, as tables."""

    def write_curve(self, name, factor=1.0):
        """Approach and retraction of a lever, heights towards the surface."""
        approach = np.linspace(-1e-6, 5e-7, 301)
        load = factor*4/3*MODULUS*np.sqrt(RADIUS)*np.maximum(approach, 0)**1.5
        position = approach + load/K
        rows = [*zip(position, load), *zip(position[::-1], load[::-1])]
        Path(name).write_text("height [nm],load [nN]\n" + "".join(f"{float(z)*1e9!r},{float(f)*1e9!r}\n" for z, f in rows))
        return approach, load

    def test_curve(self):
        approach, load = self.write_curve("curve.csv")
        curve = adfric.read_curve("curve.csv", spring_constant=K, sign="towards", segment="approach")
        self.assertEqual(("sample",), curve["load"].dims)
        np.testing.assert_allclose(curve["load"], load, rtol=1e-12, atol=1e-20)
        np.testing.assert_allclose(np.diff(curve.approach), np.diff(approach), rtol=1e-6)
        self.assertEqual("N", curve["load"].attrs["units"])
        whole = adfric.read_curve("curve.csv", spring_constant=K, sign="towards")
        self.assertEqual(602, whole.sizes["sample"])
        found = adfric.fit("sphere", curve, "approach", "load", free=["contact_modulus", "contact_point"], radius=RADIUS, theory="hertz",
                           work_of_adhesion=0.0, data_options={"sigma": 1e-12, "branch_column": "", "segment_column": ""})
        self.assertEqual("fitted", found.status)
        np.testing.assert_allclose(found.estimates["contact_modulus"], MODULUS, rtol=1e-3)

    def test_stack(self):
        for number in range(1, 4):
            self.write_curve(f"curve{number}.csv", number)
        stack = adfric.read_curve([f"curve{number}.csv" for number in range(1, 4)], spring_constant=K, sign="towards", segment="approach")
        self.assertEqual(("curve", "sample"), stack["load"].dims)
        found = adfric.fit("sphere", stack, "approach", "load", free=["contact_modulus", "contact_point"], radius=RADIUS, theory="hertz",
                           work_of_adhesion=0.0, data_options={"sigma": 1e-12, "branch_column": "", "segment_column": ""})
        np.testing.assert_allclose(found.estimates["contact_modulus"], MODULUS*np.arange(1, 4), rtol=1e-3)

    def test_refusals(self):
        self.write_curve("curve.csv")
        for given, words in (({"segment": "up"}, ("segment", "approach")), ({"sign": "left"}, ("sign",)),
                             ({"spring_constant": -1.0}, ("spring_constant",)), ({"grid": (0, 2)}, ("grid",)),
                             ({"load_column": "force"}, ("force",))):
            with self.subTest(given=given), self.assert_raises_text(InputError, *words), warnings.catch_warnings():
                warnings.simplefilter("ignore")
                adfric.read_curve("curve.csv", **{"spring_constant": K, "sign": "towards", **given})
        with self.assert_raises_text(adfric.FailedError, "none.csv"):
            adfric.read_curve("none.csv")
        with self.assert_raises_text(InputError, "empty list"):
            adfric.read_curve([])

    def test_master_curve(self):
        omega = np.logspace(-3, 6, 46)
        storage = 1e6 + 1e7*sum((omega*tau)**2/(1 + (omega*tau)**2) for tau in (1e-4, 1e-2))
        loss = 1e7*sum(omega*tau/(1 + (omega*tau)**2) for tau in (1e-4, 1e-2))
        rows = "".join(f"{float(w)!r},{float(a)/1e6!r},{float(b)/1e6!r}\n" for w, a, b in zip(omega, storage, loss))
        Path("rubber.csv").write_text("# reference temperature: 20 degC\nomega [rad/s],E' [MPa],E'' [MPa]\n" + rows)
        curve = adfric.read_master_curve("rubber.csv")
        np.testing.assert_allclose(curve.storage, storage, rtol=1e-14)
        np.testing.assert_allclose(curve.loss, loss, rtol=1e-14)
        self.assertAlmostEqual(293.15, curve.attrs["reference_temperature"], 9)
        Path("logs.csv").write_text("f,a,b\n" + "".join(
            f"{float(w/2/np.pi)!r},{float(np.log10(a))!r},{float(b/a)!r}\n" for w, a, b in zip(omega, storage, loss)))
        same = adfric.read_master_curve("logs.csv", frequency_unit="Hz", modulus_unit="Pa", reference_temperature=293.15,
                                        columns={"frequency": "f", "storage": "a", "tan_delta": "b"}, log10=["storage"])
        np.testing.assert_allclose(same.loss, loss, rtol=1e-12)
        with self.assert_raises_text(InputError, "poisson_ratio"):
            adfric.read_master_curve("rubber.csv", poisson_ratio=0.5)
        with self.assert_raises_text(InputError, "reference_temperature"):
            adfric.read_master_curve("logs.csv", frequency_unit="Hz", modulus_unit="Pa",
                                     columns={"frequency": "f", "storage": "a", "tan_delta": "b"}, log10=["storage"])


class Times(InFolder):
    """Curves in time."""

    def test_fit(self):
        """A curve with its own history gives back what it was made with: a relaxed modulus, an arm, and where contact begins."""
        times = np.linspace(0, 0.4, 101)
        base = 1e-5*np.minimum(times, 0.4 - times)
        scene = {"surface": {"kind": "paraboloid", "radius": 5e-6}}
        curve = adfric.solve(**scene, solid={"modulus": 1e3, "moduli": [2e3], "relaxation_times": [0.1]},
                             history={"times": times, "approaches": base, "contact_point": 3e-7})
        noise = 1e-11*np.random.default_rng(1).standard_normal(times.shape)
        data = {"time": times, "base": base, "load": np.ravel(curve["load"]) + noise}
        found = adfric.fit(data, "time", "load", free=["modulus", "moduli(1)", "relaxation_times(1)", "contact_point"], **scene,
                           solid={"moduli": [1e3], "relaxation_times": [0.05]}, starts=1,
                           data_options={"sigma": 1e-11, "variables": ["approaches"], "variable_columns": ["base"]})
        self.assertEqual("fitted", found.status)
        for name, value in (("modulus", 1e3), ("moduli_1", 2e3), ("relaxation_times_1", 0.1), ("contact_point", 3e-7)):
            self.assertLess(abs(found.estimates[name] - value), 4*found.errors[name], name)


if __name__ == "__main__":
    unittest.main()
