# SPDX-License-Identifier: GPL-3.0-or-later
"""Indenters on which nothing slips, against rings that carry pressure and shear."""

import sys
import unittest
from pathlib import Path

import h5py
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from runs import Runs, main  # noqa: E402

SHAPES = {1: "kind = 'cone', slope = 0.1", 2: "kind = 'paraboloid', radius = 1e-3", 4: "kind = 'power', exponent = 4.0, power_coefficient = 1e6"}
NODES, WEIGHTS = np.polynomial.legendre.leggauss(8)


def elliptic(m):
    """The complete integrals K and E, by the arithmetic-geometric mean."""
    a, b, c, total, power = np.ones_like(m), np.sqrt(1 - m), np.sqrt(m), m/2, 1.0
    while np.abs(c).max() > 1e-16:
        a, b, c = (a + b)/2, np.sqrt(a*b), (a - b)/2
        total, power = total + power*c**2, 2*power
    return np.pi/(2*a), np.pi/(2*a)*(1 - total)


def kernels(r, s):
    """The integrals of J0(kr) J0(ks) and of J1(kr) J1(ks) over k: what rings of pressure lift, and rings of shear widen."""
    low, high = np.minimum(r, s), np.maximum(r, s)
    k, e = elliptic((low/high)**2)
    return 2/np.pi*np.array([k/high, (k - e)/low])


def of_cell(r, begin, end):
    """Both kernels over a cell, with nodes that are dense where r is near."""
    total = 0
    for start, stop in ((r, begin), (r, end)) if begin < r < end else ((begin, end) if abs(r - begin) < abs(r - end) else (end, begin),):
        t = (NODES + 1)/2
        s = start + (stop - start)*t**3
        total = total + (kernels(r, s)*s*abs(stop - start)*3*t**2*WEIGHTS/2).sum(-1)
    return total


def stuck_punch(n, beta):
    """Stiffness of a flat punch that sticks over that of one that slips, and what depends on the exponent of other shapes: their depth."""
    edges = np.sin(np.linspace(0, np.pi/2, n + 1))
    x, widths = (edges[1:] + edges[:-1])/2, np.diff(edges)
    lifts, widens = np.moveaxis([[of_cell(r, *edges[j:j + 2]) for j in range(n)] for r in x], -1, 0)
    beyond = np.triu(np.tile(widths, (n, 1)), 1) + np.diag(edges[1:] - x)
    within = (np.tril(np.tile(np.diff(edges**2)/2, (n, 1)), -1) + np.diag((x**2 - edges[:-1]**2)/2))/x[:, None]
    # in contact the surface goes down by 1 and does not widen; 2/E* = 1
    pressure = np.linalg.solve(np.block([[lifts, -beta*beyond], [-beta*within, widens]]), np.repeat([1.0, 0.0], n))[:n]
    t, weights = np.polynomial.legendre.leggauss(40)
    outside = 1 - (1 - t)**2/4
    weights = weights*(1 - t)/2
    s = x[:, None] + widths[:, None]/2*NODES
    sinks = np.array([(pressure*(kernels(1/r, s)[0]*s*WEIGHTS).sum(1)*widths/2).sum() for r in outside])
    depth = {power: (weights*(1 - 2/np.pi*np.arcsin(outside))*outside**(power - 1)).sum()/(weights*(1 - sinks)*outside**(power - 1)).sum()
             for power in SHAPES}
    return np.pi*(pressure*np.diff(edges**2)).sum()/4, depth


class FullStick(Runs):
    def solve(self, surface, solid):
        """Results of an indenter."""
        self.write(f"&job output = 'run.h5' /\n&surface {surface} /\n&solid {solid} /\n&operating load = 1e-3 /\n")
        self.run_program("run", "--quiet", "--force", "run.nml")
        with h5py.File(self.folder/"run.h5") as file:
            self.assertFalse(file["status"][()].any())
            return {key: data[()].item() for key, data in file.items() if isinstance(data, h5py.Dataset) and data.size == 1}

    def test_rings(self):
        """What the shapes have by closed forms is that of rings, to the error of these."""
        stiffness, depth = stuck_punch(32, 0.5)
        self.assertAlmostEqual(stiffness, np.log(3), delta=1e-3)
        for power, surface in SHAPES.items():
            found = self.solve(surface, "young_modulus = 1e9, poisson_ratio = 0.0")
            self.assertAlmostEqual(found["full_stick_stiffness"]/found["contact_stiffness"], np.log(3), delta=1e-13)
            self.assertAlmostEqual(found["full_stick_approach"]/found["approach"], depth[power], delta=2e-3)
            self.assertAlmostEqual(found["full_stick_load"]/found["load"], np.log(3)*depth[power], delta=3e-3)

    def test_bodies(self):
        """Nothing changes for bodies alike or incompressible ones; two bodies have the difference of what each of them does."""
        ball = SHAPES[2]
        for solid in ("young_modulus = 1e9, poisson_ratio = 0.5", "young_modulus = 1e9, poisson_ratio = 0.2, second_young_modulus = 1e9, second_poisson_ratio = 0.2"):
            found = self.solve(ball, solid)
            for name in ("load", "approach"):
                self.assertAlmostEqual(found[f"full_stick_{name}"]/found[name], 1, delta=1e-13)
        first, second = "young_modulus = 1e9, poisson_ratio = 0.1", "second_young_modulus = 3e9, second_poisson_ratio = 0.4"
        swapped = "young_modulus = 3e9, poisson_ratio = 0.4, second_young_modulus = 1e9, second_poisson_ratio = 0.1"
        found, other = (self.solve(ball, solid) for solid in (f"{first}, {second}", swapped))
        self.assertAlmostEqual(found["full_stick_load"]/other["full_stick_load"], 1, delta=1e-13)
        compliances = 0.8*1.1/1e9 - 0.2*1.4/3e9
        beta = compliances/2/((1 - 0.01)/1e9 + (1 - 0.16)/3e9)
        self.assertAlmostEqual(found["full_stick_stiffness"]/found["contact_stiffness"], np.arctanh(beta)/beta, delta=1e-13)
        punch = self.solve("kind = 'flat_punch', face_radius = 1e-5", first)
        self.assertEqual(punch["full_stick_approach"], punch["approach"])
        self.assertAlmostEqual(punch["full_stick_load"]/punch["approach"]/punch["full_stick_stiffness"], 1, delta=1e-13)

    def test_absent(self):
        """Without Poisson's ratio there is none, and of a shape that changes with its depth the stiffness alone."""
        self.assertNotIn("full_stick_stiffness", self.solve(SHAPES[2], "contact_modulus = 1e9"))
        found = self.solve("kind = 'sphere', radius = 1e-3", "young_modulus = 1e9, poisson_ratio = 0.3")
        self.assertIn("full_stick_stiffness", found)
        self.assertNotIn("full_stick_load", found)


if __name__ == "__main__":
    main()
