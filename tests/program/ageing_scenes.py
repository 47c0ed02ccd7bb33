# SPDX-License-Identifier: GPL-3.0-or-later
"""Periodic surfaces at rest on a viscoelastic half-space: Westergaard's wave with the creep of its solid, a contact followed in small
steps of time, legs and units, and what is refused."""

import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from runs import SolverRuns, main  # noqa: E402

MODULI, TIMES, RELAXED = np.array([3e8, 1e8]), np.array([1.0, 100.0]), 1e8
SOLID = "&solid modulus = 1e8, moduli = 3e8, 1e8, relaxation_times = 1, 100 /\n"
WAVE = "&surface kind = 'wave_1d', period = 1e-5, amplitude = 1e-7 /\n"


def exponential(matrix):
    """exp of a matrix, by squares of a series."""
    halves = max(0, int(np.ceil(np.log2(np.abs(matrix).sum() + 1))) + 1)
    term = total = np.eye(len(matrix))
    for k in range(1, 20):
        term = term @ matrix/2**halves/k
        total = total + term
    for _ in range(halves):
        total = total @ total
    return total


def creep(times, pressures):
    """Strain under a pressure that is straight between times, from the equations of the arms: z' = (strain - z)/time."""
    n = len(MODULI)
    glassy = RELAXED + MODULI.sum()
    state, strains = np.zeros(n), []
    for k, pressure in enumerate(pressures):
        span = times[k] - times[k - 1] if k else 0.0
        if span > 0:
            # z, the pressure and its slope
            system = np.zeros((n + 2, n + 2))
            system[:n, :n] = (np.outer(np.ones(n), MODULI)/glassy - np.eye(n))/TIMES[:, None]
            system[:n, n] = 1/glassy/TIMES
            system[n, n + 1] = 1
            slope = (pressure - pressures[k - 1])/span
            state = (exponential(system*span) @ np.concatenate([state, [pressures[k - 1], slope]]))[:n]
        strains.append((pressure + MODULI @ state)/glassy)
    return np.array(strains)


def march(times, pressures, period, amplitude, n, n_steps):
    """Share in contact and penetration at each time, by implicit steps of a contact of its own: at each one an elastic contact whose
    profile has the memory in it, by sets of places that press."""
    x = (np.arange(n) + 0.5)/n
    depth = amplitude*(1 - np.cos(2*np.pi*x))
    number = np.abs(np.fft.fftfreq(n, 1/n))
    number[0] = np.inf
    kernel = np.fft.ifft(2*period/(2*np.pi*number)).real
    compliance = np.array([np.roll(kernel, k) for k in range(n)]).T
    z = np.zeros((len(MODULI), n))
    touches = np.abs(depth) < 0.1*amplitude
    shares, penetrations = [], []
    for k in range(1, len(times)):
        h = (times[k] - times[k - 1])/n_steps
        for step in range(1, n_steps + 1):
            pressure = pressures[k - 1] + (pressures[k] - pressures[k - 1])*step/n_steps
            ratio = h/TIMES
            modulus = RELAXED + np.sum(MODULI/(1 + ratio))
            memory = (MODULI/(1 + ratio)) @ z/modulus
            for _ in range(100):
                inside = np.flatnonzero(touches)
                system = np.block([[compliance[np.ix_(inside, inside)]/modulus, -np.ones((len(inside), 1))],
                                   [np.ones((1, len(inside)))/n, np.zeros((1, 1))]])
                found = np.linalg.solve(system, np.concatenate([-(depth + memory)[inside], [pressure]]))
                p = np.zeros(n)
                p[inside] = found[:-1]
                u = compliance @ p/modulus + memory
                gap = depth - found[-1] + u
                changed = np.where(touches, p > 0, gap < 0)
                if (changed == touches).all():
                    break
                touches = changed
            z = (z + ratio[:, None]*u)/(1 + ratio[:, None])
        shares.append(touches.mean())
        penetrations.append(found[-1])
    return np.array(shares), np.array(penetrations)


class AgeingScenes(SolverRuns):
    """Runs of surfaces at rest."""

    solver = "surface_time"

    def test_wave(self):
        """H. M. Westergaard, J. Appl. Mech. 6 (1939) 49: the share in contact is (2/pi) arcsin sqrt(p/p*), on 1024 cells here."""
        times, pressures = [0, 0.1, 1, 10, 100, 1000, 5000, 5000, 6000], 7*[4e5] + 2*[9e5]
        found = self.solve(WAVE + SOLID + f"&history times = {str(times)[1:-1]}, mean_pressures = {str(pressures)[1:-1]} /\n")
        strains = creep(times, pressures)
        np.testing.assert_allclose(found["elastic_mean_pressure"], RELAXED*strains, rtol=1e-12)
        exact = 2/np.pi*np.arcsin(np.sqrt(strains/(np.pi*1e-7/1e-5)))
        np.testing.assert_allclose(found["smooth_contact_fraction"], exact, rtol=3e-3)
        # the whole estimate is that of the area
        self.assertLess(np.max(np.abs(found["contact_fraction"] - exact)/exact), 3*found["error_estimate"])
        self.assertAlmostEqual(found["contact_growth"], found["contact_fraction"][-1]/found["contact_fraction"][0], places=14)
        # the mean of the surface is where it was: gap and penetration sum to its mean depth
        np.testing.assert_allclose(found["mean_gap"] + found["penetration"], 1e-7, rtol=1e-9)

    def test_steps_of_time(self):
        """A contact that is followed in small steps, under a load that comes, stays, and falls so slowly that the contact grows."""
        times, pressures = [0.0, 2.0, 12.0, 22.0], [0.0, 4e5, 4e5, 3.95e5]
        found = self.solve(WAVE + SOLID + f"&history times = {str(times)[1:-1]}, mean_pressures = {str(pressures)[1:-1]} /\n")
        n = 128
        shares, penetrations = march(times, pressures, 1e-5, 1e-7, n, 100)
        self.assertTrue((np.diff(found["contact_fraction"]) > 0).all())
        # an edge is known to half a cell at each side, and time to first order of a step
        np.testing.assert_allclose(found["contact_fraction"][1:], shares, atol=1.5/n)
        np.testing.assert_allclose(found["penetration"][1:], penetrations, rtol=0.01)
        self.assertEqual(0, found["contact_fraction"][0])

    def test_legs(self):
        """Steps in between change nothing, and neither do other units."""
        history = "&history times = 0, 3, 50, mean_pressures = 0, 4e5, 4e5 /\n"
        few = self.solve(WAVE + SOLID + history)
        many = self.solve(WAVE + SOLID + history + "&output steps_per_leg = 4 /\n")
        scaled = self.solve("&surface kind = 'wave_1d', period = 3, amplitude = 0.03 /\n"
                            "&solid modulus = 7, moduli = 21, 7, relaxation_times = 1e-8, 1e-6 /\n"
                            "&history times = 0, 3e-8, 50e-8, mean_pressures = 0, 0.028, 0.028 /\n")
        # two solutions of the tolerance of contact
        close = 1e-8
        for name in ("time", "mean_pressure", "contact_fraction", "penetration", "mean_gap"):
            np.testing.assert_allclose(many[name][::4], few[name], rtol=close, atol=0)
        np.testing.assert_allclose(scaled["contact_fraction"], few["contact_fraction"], rtol=close)
        np.testing.assert_allclose(scaled["penetration"]/3e5, few["penetration"], rtol=close)

    def test_temperature(self):
        """A temperature that makes the solid ten times as fast is ten times the age."""
        shift = SOLID.replace(" /\n", ", shift = 'wlf', reference_temperature = 300, wlf_c1 = 8.86, wlf_c2 = 101.6 /\n")
        # log10 of the factor is -1
        warm = 300 + 101.6/(8.86 - 1)
        waves = WAVE.replace("wave_1d", "wave_2d") + shift + "&numerics cells = 64 /\n"
        swept = self.solve(waves + "&history times = 0, 2, mean_pressures = 4e5, 4e5 /\n"
                           + f"&sweep variable = 'temperature', values = 300, {warm!r} /\n")
        older = self.solve(waves + "&operating temperature = 300 /\n&history times = 0, 20, mean_pressures = 4e5, 4e5 /\n")
        np.testing.assert_allclose(swept["penetration"][1, 1], older["penetration"][1], rtol=1e-9)
        self.assertGreater(swept["penetration"][1, 1], swept["penetration"][0, 1])

    def test_refused(self):
        """Each thing that is no history, and a contact that shrinks."""
        for history, words in (
                ("times = 0, 1, 2, mean_pressures = 0, 1e5", "has 2 values, and times has 3"),
                ("times = 0, 2, 1, mean_pressures = 0, 1e5, 1e5", "falls from"),
                ("times = 1, 1, mean_pressures = 0, 1e5", "are all equal"),
                ("times = 0, 1, mean_pressures = 0, 0", "never presses"),
                ("times = 0, 1, mean_pressures = 0, -1", "mean_pressures"),
                ("times = 0, 1", "is missing"),
                ("times = 0, 1, 2, mean_pressures = 0, 1e5, 0", "shrink at"),
                ("times = 0, 1, 1, mean_pressures = 0, 1e5, 9e4", "shrink at"),
                ("times = 0, 1, mean_pressures = 0, 1e5, loads = 0, 1", "loads")):
            with self.subTest(history=history):
                self.refuse(WAVE + SOLID + f"&history {history} /\n", words)
        history = "&history times = 0, 1, mean_pressures = 0, 1e5 /\n"
        self.refuse(WAVE + SOLID + history + "&sweep variable = 'steps_per_leg', values = 1, 2 /\n", "steps_per_leg")
        self.refuse(WAVE + "&solid contact_modulus = 1e8 /\n" + history, "nothing solves")
        layer = "&solid extent = 'layer', thickness = 1e-5, base = 'frictionless', modulus = 1e8, moduli = 1e8, relaxation_times = 1 /\n"
        self.refuse(WAVE + layer + history, "nothing solves")
        self.refuse(WAVE + SOLID + "&adhesion work_of_adhesion = 0.05, adhesion_stress = 1e6 /\n" + history, "nothing solves")


if __name__ == "__main__":
    main()
