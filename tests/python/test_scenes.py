# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes by their groups: the results are those of the same input of the program."""

import pickle
import unittest

import numpy as np
from cases import InFolder

import adfric

TIP = {"surface": {"kind": "paraboloid", "radius": 140e-9}, "solid": {"contact_modulus": 44e9},
       "adhesion": {"work_of_adhesion": 0.19, "lambda_": 0.8}, "friction": {"shear_strength": 0.96e9}, "operating": {"state": "sliding"}}
TEXT = """
&surface kind = 'paraboloid', radius = 140e-9 /
&solid contact_modulus = 44e9 /
&adhesion work_of_adhesion = 0.19, lambda = 0.8 /
&friction shear_strength = 0.96e9 /
&operating state = 'sliding' /
&sweep variable = 'load', values = -1e-7, 0.0, 2e-7 /
"""
LOADS = np.array([-1e-7, 0.0, 2e-7])


class Scenes(InFolder):
    def test_groups(self):
        case = adfric.scene(title="A tip", **TIP, sweep={"load": LOADS})
        self.assertEqual(case.scene, "paraboloid on an elastic half-space with adhesion and a shear strength, sliding")
        self.assertEqual(case.model, "sphere")
        results = case.solve()
        self.assertEqual(results.attrs["title"], "A tip")
        with open("tip.nml", "w") as file:
            file.write(TEXT)
        other = adfric.run("tip.nml")
        for name in other.data_vars:
            np.testing.assert_array_equal(results[name], other[name], err_msg=name)
        # what has no meaning in the scene is absent
        self.assertNotIn("slip", results)
        self.assertNotIn("-", results)

    def test_set(self):
        case = adfric.scene(**TIP, sweep={"load": LOADS})
        case.set(adhesion={"lambda": 2.0}, radius=70e-9)
        again = pickle.loads(pickle.dumps(case)).solve()
        expected = adfric.solve("sphere", radius=70e-9, contact_modulus=44e9, work_of_adhesion=0.19, lambda_=2.0, shear_strength=0.96e9,
                                state="sliding", load=LOADS)
        for results in (case.solve(), again):
            for name in ("contact_radius", "friction_force", "pull_off_load"):
                np.testing.assert_array_equal(results[name], expected[name], err_msg=name)
        self.assertEqual(case.find("friction_force", load=0.0), expected.friction_force[1])

    def test_conversions(self):
        wave = adfric.scene(surface={"kind": "wave_1d", "period": 1e-4, "amplitude": 5e-6},
                            solid={"extent": "foundation", "stiffness": 2e9, "relaxation_time": 1e-4, "retardation_ratio": 10.0},
                            operating={"velocity": 0.1}, sweep={"mean_pressure": [1e3, 1e4]}).solve()
        model = adfric.solve("wavy_sliding", kind="wave_2d", period=1e-4, height=1e-5, stiffness=2e9, relaxation_time=1e-4, retardation_ratio=10.0,
                             velocity=0.1, mean_pressure=[1e3, 1e4])
        np.testing.assert_allclose(wave.friction_stress*1e-4, model.friction_force, rtol=1e-15)
        self.assertEqual(wave.friction_stress.attrs["units"], "Pa")

    def test_refusals(self):
        for change, message in (({"solid": {"contact_modulus": 44e9, "relaxation_times": [1.0]}}, "&solid: nothing solves paraboloid"),
                                ({"surface": {"kind": "paraboloid"}}, "&surface radius: is missing"),
                                ({"surfaces": {"kind": "cone"}}, "&surfaces: unknown group"),
                                ({"solid": 44e9}, "solid: given 44000000000.0, allowed: a dictionary")):
            with self.subTest(message), self.assertRaisesRegex(adfric.InputError, message):
                adfric.scene(**{**TIP, **change}, sweep={"load": LOADS})
        self.assertEqual(adfric.Case("sphere").scene, "")


if __name__ == "__main__":
    unittest.main()
