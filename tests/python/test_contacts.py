# SPDX-License-Identifier: GPL-3.0-or-later
"""Batches of contacts find what the models find."""

import unittest

import numpy as np
from cases import TIP

import adfric
from adfric import InputError, contacts


class Contacts(unittest.TestCase):
    """Spheres and strips."""

    def test_sphere(self):
        scales = contacts.sphere_scales(TIP["radius"], TIP["contact_modulus"], TIP["work_of_adhesion"])
        loads = np.linspace(-0.8e-7, 1e-7, 50)
        expected = adfric.solve("sphere", **TIP, theory="maugis_dugdale", load=loads)
        found = contacts.sphere_load(TIP["adhesion_stress"]/scales.strength, loads/scales.force)
        np.testing.assert_array_equal(expected.status, found.status)
        np.testing.assert_allclose(found.contact_radius*scales.length, expected.contact_radius, rtol=1e-13)
        np.testing.assert_allclose(found.approach*scales.closer, expected.approach, rtol=1e-12)
        back = contacts.sphere_radius(TIP["adhesion_stress"]/scales.strength, found.contact_radius)
        np.testing.assert_allclose(back.load*scales.force, loads, rtol=1e-11, atol=1e-11*scales.force)
        again = contacts.sphere_approach(TIP["adhesion_stress"]/scales.strength, found.approach)
        np.testing.assert_allclose(again.load*scales.force, loads, rtol=1e-9, atol=1e-9*scales.force)
        # Johnson 1997: -1.5 in the limit of JKR
        self.assertAlmostEqual(-1.5, contacts.sphere_pull_off(1e6).load, 10)
        self.assertLess(contacts.sphere_pull_off(1.0, holds_approach=True).approach, contacts.sphere_pull_off(1.0).approach)

    def test_strip(self):
        given = {"stiffness": 1e8, "relaxation_time": 1e-3, "retardation_ratio": 10.0, "period": 1e-2, "height": 1e-4}
        loads = np.linspace(1.0, 60.0, 20)
        expected = adfric.solve("wavy_sliding", kind="wave_2d", **given, range=1e-5, stress=2e3, velocity=0.5, load=loads)
        found = contacts.strip_load(2*np.pi*0.5*1e-3/1e-2, 10.0, 2e3/(1e-4*1e8), 0.1, loads/(1e-4*1e8*1e-2))
        np.testing.assert_array_equal(expected.status, found.status)
        np.testing.assert_allclose(found.penetration*1e-4, expected.penetration, rtol=1e-7)
        np.testing.assert_allclose(found.friction*1e-4*1e8*1e-4, expected.friction_force, rtol=1e-7)
        back = contacts.strip_penetration(2*np.pi*0.5*1e-3/1e-2, 10.0, 0.2, 0.1, found.penetration)
        np.testing.assert_allclose(back.load, loads/(1e-4*1e8*1e-2), rtol=1e-7)

    def test_shapes(self):
        found = contacts.sphere_load(np.array([[0.5], [1.0], [2.0]]), [0.0, 1.0])
        self.assertEqual((3, 2), found.contact_radius.shape)
        for i, one in enumerate((0.5, 1.0, 2.0)):
            for j, load in enumerate((0.0, 1.0)):
                self.assertEqual(contacts.sphere_load(one, load).contact_radius, found.contact_radius[i, j])
        self.assertEqual((0,), contacts.sphere_load(1.0, []).status.shape)
        self.assertIsInstance(contacts.sphere_load(1.0, 0.0).contact_radius, float)
        unstable = contacts.sphere_load(1.0, -1.0, is_unstable=[False, True]).contact_radius
        self.assertGreater(unstable[0], unstable[1])

    def test_refusals(self):
        self.assertEqual([-2, -2, 0], contacts.sphere_load([np.nan, -1.0, 1.0], 0.0).status.tolist())
        self.assertTrue(np.isnan(contacts.sphere_load(1.0, np.nan).contact_radius))
        self.assertEqual(1, contacts.sphere_load(1.0, -3.0).status)
        with self.assertRaisesRegex(InputError, r"\(2,\), \(3,\)"):
            contacts.sphere_load([1.0, 2.0], [1.0, 2.0, 3.0])
        with self.assertRaises(InputError):
            contacts.sphere_load("large", 0.0)
        with self.assertRaises(InputError):
            contacts.sphere_load(1.0 + 1.0j, 0.0)


if __name__ == "__main__":
    unittest.main()
