# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes in time: a round body on a viscoelastic half-space. Moduli of a small oscillation, loads that end at 0 and come back, solids
that are far stiffer at once than at rest, units, and what is refused."""

import math
import sys
from pathlib import Path

import h5py
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from runs import SolverRuns, main  # noqa: E402

SOLID = "&solid modulus = 1e3, moduli = 2e3, 1e3, relaxation_times = 0.1, 2.0 /\n"
BALL = "&surface kind = 'paraboloid', radius = 5e-6 /\n"
PUNCH = "&surface kind = 'flat_punch', face_radius = 1e-6 /\n"
SINE = "&history path = 'sine', largest_approach = 5e-7, approach_rate = 1e-6, dwell_time = {dwell}, oscillation_amplitude = {amplitude}, " \
    "frequency = {frequency}, cycles = {cycles} /\n"
# of the loads, over the largest one: `relative_tolerance`
TOLERANCE = 1e-9
POWER = "&solid power_law_modulus = 800, power_law_exponent = {} /\n"
# of loads of a power law that is ramped: of its integral over time a hundredth of `power_law_error` (tests/solid), and as much of the panels
RAMPED = 5e-9


def modulus_of(frequency):
    """The complex modulus of the solid."""
    turn = 2j*np.pi*frequency*np.array([0.1, 2.0])
    return 1e3 + np.sum(np.array([2e3, 1e3])*turn/(1 + turn))


class TimeScenes(SolverRuns):
    """Runs of scenes in time."""

    solver = "indenter_time"

    def test_oscillation(self):
        """The moduli of a flat punch are those of the solid, once the rest is over; those of a ball, but for the swing of its edge."""
        for frequency in (0.3, 3.0):
            wanted = modulus_of(frequency)
            flat = self.solve(PUNCH + SOLID + SINE.format(dwell=60, amplitude=5e-9, frequency=frequency, cycles=40))
            # forty periods are ten relaxation times and more: what is not periodic yet is below exp(-6)
            self.assertLess(abs(flat["storage_modulus"] + 1j*flat["loss_modulus"] - wanted), 1e-4*abs(wanted))
            off = [abs(ball["storage_modulus"] + 1j*ball["loss_modulus"] - wanted)/abs(wanted) for ball in
                   (self.solve(BALL + SOLID + SINE.format(dwell=60, amplitude=amplitude, frequency=frequency, cycles=40))
                    for amplitude in (1e-8, 5e-9))]
            # of first order in the amplitude
            self.assertGreater(off[0], 1.7*off[1])
            self.assertLess(off[0], 2.3*off[1])
            self.assertLess(off[1], 0.03)

    def test_swing(self):
        """An amplitude that is no small part of the approach is pointed out; a small one is not, nor one of a face, whose edge rests."""
        for body, amplitude, is_doubted in ((BALL, 1e-7, True), (BALL, 5e-9, False), (PUNCH, 1e-7, False)):
            self.write("&job output = 'run.h5' /\n" + body + SOLID + SINE.format(dwell=1, amplitude=amplitude, frequency=1.0, cycles=2))
            self.assertEqual(is_doubted, "is 20 % of the approach: the edge swings" in self.run_program("check", "run.nml")[0])

    def test_lost_in_a_period(self):
        """A contact that has relaxed far is lost in each period of an oscillation that it cannot follow, and has no moduli."""
        for body in (BALL, PUNCH):
            lost = self.solve(body + POWER.format(0.8) + SINE.format(dwell=60, amplitude=5e-9, frequency=2.0, cycles=3))
            self.assertTrue(np.isnan(lost["storage_modulus"]) and np.isnan(lost["loss_modulus"]))
            self.assertGreater(lost["largest_load"], 0)

    def test_drift(self):
        """A load that still relaxes counts little: what is straight in time is taken out."""
        rested = self.solve(PUNCH + SOLID + SINE.format(dwell=60, amplitude=5e-9, frequency=3.0, cycles=40))
        early = self.solve(PUNCH + SOLID + SINE.format(dwell=2, amplitude=5e-9, frequency=3.0, cycles=6))
        self.assertLess(abs(early["storage_modulus"] - rested["storage_modulus"]), 0.02*rested["storage_modulus"])

    def test_loads_that_come_back(self):
        """A load ends at 0 and comes back, at once and after a rest; the contact recovers, and is softer than a new one."""
        for loads in ("0, 1e-9, 0, 1e-9", "0, 1e-9, 0, 0, 1e-9"):
            times = ", ".join(str(k) for k in range(loads.count(",") + 1))
            found = self.solve(BALL + SOLID + f"&history times = {times}, loads = {loads} /\n")
            self.assertGreater(found["approach"][-1], found["approach"][1])
            np.testing.assert_allclose(found["load"], [float(word) for word in loads.split(",")], atol=2*TOLERANCE*1e-9)
            self.assertLess(abs(found["energy_imbalance"]), 1e-6)

    def test_trigger(self):
        """Pressing ends where a load is reached: at an approach that gives the same path, also behind a spring, of a power law, with a
        zero and a drift, and where the relaxed contact under this load is far deeper."""
        rates = "approach_rate = 2e-6, retraction_rate = 1e-6, dwell_time = 0.2"
        law, spring = POWER.format(0.3), "&operating machine_stiffness = 0.02 /\n"
        shifts = ", contact_point = 2e-7, drift_rate = 3e-7"
        for solid, more, end in ((SOLID, "", ""), (SOLID, "", spring), (law, "", ""), (law, shifts, spring), (SOLID, shifts, ""),
                                 ("&solid modulus = 1, moduli = 4e3, relaxation_times = 2 /\n", "", "")):
            found = self.solve(BALL + solid + f"&history path = 'triangle', trigger_load = 3e-9, {rates}{more} /\n" + end)
            self.assertLess(abs(found["load"][50] - 3e-9), 10*TOLERANCE*3e-9)
            self.assertEqual(50, np.argmax(found["load"]))
            time = float(found["time"][50])
            # what is prescribed at the turn, without zero and drift
            name = "largest_base_approach" if end else "largest_approach"
            path = f"&history path = 'triangle', {name} = {2e-6*time!r}, {rates}{more} /\n"
            np.testing.assert_allclose(self.solve(BALL + solid + path + end)["load"], found["load"], atol=1e-7*3e-9, rtol=0)
        swept = self.solve(BALL + SOLID + f"&history path = 'triangle', {rates} /\n&sweep variable = 'trigger_load', values = 1e-9, 2e-9 /\n")
        np.testing.assert_allclose(swept["load"][:, 50], [1e-9, 2e-9], rtol=10*TOLERANCE)
        path = f"&history path = 'triangle', trigger_load = 3e-9, {rates}"
        self.refuse(BALL + SOLID + path + ", cycles = 2 /\n", "cycles: stands beside trigger_load")
        self.refuse(BALL + SOLID + path + ", largest_approach = 1e-6 /\n", "trigger_load")
        self.refuse(BALL + SOLID + "&history times = 0, 1, approaches = 0, 1e-7, trigger_load = 1e-9 /\n", "trigger_load: has no meaning without path")
        self.refuse(BALL + law + path + ", contact_point = -1e-7 /\n", "jumps")

    def test_stiff_at_once(self):
        """A solid that is a hundred million times as stiff at once is answered, or said not to be, in a bounded time."""
        found = self.solve("&surface kind = 'paraboloid', radius = 1 /\n&solid modulus = 1, moduli = 1e8, relaxation_times = 0.5 /\n"
                           "&history times = 0, 1, approaches = 0, 0.1 /\n")
        # growing contact: P = int E(t - s) 2 a d delta, a^2 = delta, delta = t/10
        s = (np.arange(200000) + 0.5)/200000
        wanted = np.sum((1 + 1e8*np.exp(-(1 - s)/0.5))*2*np.sqrt(0.1*s)*0.1)/200000
        self.assertLess(abs(found["load"][-1]/wanted - 1), 1e-6)

    def test_units(self):
        """Lengths a thousandth, moduli a million times, times a hundredth: loads and radii follow."""
        path = "&history times = 0, {0}, {1}, {2}, {3}, approaches = 0, {a}, {b}, {a}, 0 /\n"
        one = self.solve(BALL + SOLID + path.format(1, 1.5, 2, 3, a=5e-7, b=3e-7))
        other = self.solve("&surface kind = 'paraboloid', radius = 5e-9 /\n"
                           "&solid modulus = 1e9, moduli = 2e9, 1e9, relaxation_times = 1e-3, 2e-2 /\n"
                           + path.format(0.01, 0.015, 0.02, 0.03, a=5e-10, b=3e-10))
        largest = np.max(one["load"])
        np.testing.assert_allclose(other["load"], one["load"], atol=10*TOLERANCE*largest, rtol=0)
        np.testing.assert_allclose(other["contact_radius"]*1e3, one["contact_radius"], atol=1e-5*np.max(one["contact_radius"]), rtol=0)

    def test_rest_that_is_swept(self):
        """A rest of no time is a rest: all points of a sweep have the same steps."""
        path = "&history path = 'triangle', largest_approach = 1e-7, approach_rate = 1e-6{} /\n"
        swept = self.solve(BALL + SOLID + path.format("") + "&sweep variable = 'dwell_time', values = 0, 1 /\n")
        alone = self.solve(BALL + SOLID + path.format(", dwell_time = 0"))
        without = self.solve(BALL + SOLID + path.format(""))
        self.assertEqual((2, 151), swept["load"].shape)
        np.testing.assert_array_equal(swept["load"][0], alone["load"])
        np.testing.assert_allclose(alone["load"][[50, -30, -1]], without["load"][[50, -30, -1]], rtol=1e-8, atol=1e-9*np.max(alone["load"]))

    def integral(self, until, now, exponent, power):
        """The integral of (now - s)^(-exponent) s^power from 0 to `until`, by double-exponential quadrature in (now - s)^(1 - exponent)."""
        k = 0.02*np.arange(-200, 201)
        turned = np.pi/2*np.sinh(k)
        x, rest = 1/(1 + np.exp(-2*turned)), 1/(1 + np.exp(2*turned))
        weights = 0.02*np.pi*np.cosh(k)*x*rest
        low, high = (now - until)**(1 - exponent), now**(1 - exponent)
        past = (low*rest + high*x)**(1/(1 - exponent))
        return (high - low)/(1 - exponent)*np.sum(weights*np.maximum(now - past, 0)**power)

    def test_power_law(self):
        """A ball and a cone on a power law: while they are pressed and drawn back the load is an integral, and the edge is where it was
        at t - 2^(1/(1 - a)) (t - tm)."""
        for exponent in (0.05, 0.3, 0.6, 0.8, 0.9, 0.95):
            for body, width, power in ((BALL, np.sqrt(5e-6*1e-6), 0.5),
                                       ("&surface kind = 'cone', slope = 0.5 /\n", 1e-6/(np.pi/2*0.5), 1)):
                found = self.solve(body + POWER.format(exponent) + "&history path = 'triangle', largest_approach = 1e-6, "
                                   "approach_rate = 1e-6 /\n")
                factor = 2**(1/(1 - exponent))
                wanted = []
                for time in found["time"]:
                    earlier = time if time <= 1 else time - factor*(time - 1)
                    wanted.append(800*2*width*1e-6*self.integral(earlier, time, exponent, power) if earlier > 0 else 0)
                self.assertLess(np.max(np.abs(found["load"] - wanted)), RAMPED*max(wanted))
                self.assertLess(abs(found["loss_time"] - factor/(factor - 1)), 1e-5)
                self.assertLess(abs(found["energy_imbalance"]), 1e-6)
                self.assertTrue(np.all(np.isnan(found["contact_stiffness"])))

    def test_power_law_at_rest(self):
        """A load that rests on a ball: a^3 grows as t^a times what the creep function sin(pi a)/(pi a) says. A flat punch that is pressed and
        rests. The moduli of a small oscillation of a flat punch."""
        exponent = 0.4
        creep = np.sin(np.pi*exponent)/(np.pi*exponent)
        found = self.solve(BALL + POWER.format(exponent) + "&history times = 0, 0, 1, 2, 4, loads = 0, 1e-9, 1e-9, 1e-9, 1e-9 /\n")
        cube = 0.75*5e-6*1e-9*creep*found["time"][2:]**exponent/800
        np.testing.assert_allclose(found["contact_radius"][2:]**3, cube, rtol=1e-7)
        flat = self.solve(PUNCH + POWER.format(exponent) + "&history times = 0, 1, 3, approaches = 0, 1e-7, 1e-7 /\n")
        np.testing.assert_allclose(flat["load"][2], 2*1e-6*1e-7*800*(3**0.6 - 2**0.6)/0.6, rtol=RAMPED)
        # so small that the load stays above 0
        for exponent, dwell, amplitude in ((0.4, 60, 5e-9), (0.8, 10, 1e-9), (0.95, 10, 1e-10)):
            flat = self.solve(PUNCH + POWER.format(exponent) + SINE.format(dwell=dwell, amplitude=amplitude, frequency=2.0, cycles=10))
            wanted = 800*math.gamma(1 - exponent)*(2j*np.pi*2)**exponent
            # what is not periodic after ten periods is the slow end of the spectrum, as that of an arm of some periods
            self.assertLess(abs(flat["storage_modulus"] + 1j*flat["loss_modulus"] - wanted), 1e-3*abs(wanted))

    def test_power_law_after_rest(self):
        """A ball that is pressed, rests and is drawn back twice as fast: the edge is where it was at a time that is a root, and the load is an
        integral up to it (Ting)."""
        for exponent in (0.2, 0.5, 0.7, 0.8, 0.9, 0.95):
            found = self.solve(BALL + POWER.format(exponent) + "&history path = 'triangle', largest_approach = 1e-6, approach_rate = 1e-6, "
                               "dwell_time = 2, retraction_rate = 2e-6 /\n")
            wanted = []
            for time in found["time"]:
                earlier = min(time, 1)
                if time > 3:
                    # (t - t1)^(1 - a) - (t - 1)^(1 - a) = 2 (t - 3)^(1 - a)
                    earlier = time - ((time - 1)**(1 - exponent) + 2*(time - 3)**(1 - exponent))**(1/(1 - exponent))
                wanted.append(800*2*np.sqrt(5e-12)*1e-6*self.integral(earlier, time, exponent, 0.5) if earlier > 0 else 0)
            self.assertLess(np.max(np.abs(found["load"] - wanted)), RAMPED*max(wanted))
            self.assertLess(abs(found["energy_imbalance"]), 1e-6)

    def test_power_law_under_load(self):
        """A load that rises on a ball, rests and falls. While the contact grows, a^3 is that of the load with creep, Q. While it shrinks,
        it is that of an earlier time, up to which the integral of E(t - s) dQ is the load (Ting)."""
        for exponent in (0.3, 0.7, 0.9, 0.95):
            found = self.solve(BALL + POWER.format(exponent) + "&history path = 'triangle', largest_load = 1e-9, loading_rate = 1e-9, "
                               "dwell_time = 1 /\n&output steps_per_leg = 100 /\n")
            self.assertLess(abs(found["energy_imbalance"]), 1e-6)
            turns = ((0, 1), (1, -1), (2, -1))
            creep = 1e-9*np.sin(np.pi*exponent)/(np.pi*exponent)/800

            def crept(time):
                return creep/(1 + exponent)*sum(change*max(time - turn, 0)**(1 + exponent) for turn, change in turns)

            def root_of(rises, low, high, value):
                for _ in range(60):
                    middle = (low + high)/2
                    low, high = (middle, high) if rises(middle) < value else (low, middle)
                return low

            # the contact grows on until Q does not
            last = root_of(lambda time: sum(-change*max(time - turn, 0)**exponent for turn, change in turns), 2, 3, 0)
            for time, size, load in zip(found["time"], 4/3*found["contact_radius"]**3/5e-6, found["load"]):
                if time <= last:
                    self.assertLess(abs(size - crept(time)), 1e-7*crept(last), (exponent, time))
                elif size > 1e-6*crept(last):
                    earlier = root_of(crept, 0, last, size)
                    rest = sum(change*self.integral(earlier - turn, time - turn, exponent, exponent)
                               for turn, change in turns if earlier > turn)
                    self.assertLess(abs(800*creep*rest - load), 1e-6*1e-9, (exponent, time))

    def test_power_law_in_cycles(self):
        """A ball on a nearly fluid solid goes up and down without losing contact, beside springs in small steps, each in contact or free: the
        edge comes back over springs that still recover. The springs have an error of first order in their steps."""
        n_steps, n_springs, error_of_springs = 180, 400, 3e-3
        turns = (0, 1, 1.2, 1.5, 1.9, 2.2)
        heights = (0, 1, 0.98, 1.2, 1.18, 1.4)
        for exponent in (0.5, 0.8, 0.9):
            found = self.solve(BALL + POWER.format(exponent) + f"&history times = {', '.join(map(str, turns))}, "
                               f"approaches = {', '.join(f'{height}e-6' for height in heights)} /\n&output steps_per_leg = 20 /\n")
            # steps that begin short after each turn
            grid = (np.arange(1, n_steps + 1)/n_steps)**3
            times = np.concatenate([[0]] + [begin + (end - begin)*grid for begin, end in zip(turns, turns[1:])])
            approach = np.interp(times, turns, heights)
            # springs at equal steps of the radius, at their middles
            width = np.sqrt(heights[-1])/n_springs
            depth = (width*(np.arange(n_springs) + 0.5))**2
            stretch = np.zeros((len(times), n_springs))
            load = np.zeros(len(times))
            for k in range(1, len(times)):
                past = (times[k] - times[:k + 1])**(1 - exponent)/(1 - exponent)
                kernel = (past[:-1] - past[1:])/np.diff(times[:k + 1])
                known = kernel[:-1] @ np.diff(stretch[:k], axis=0) if k > 1 else np.zeros(n_springs)
                stretch[k] = np.maximum(approach[k] - depth, stretch[k - 1] - known/kernel[-1])
                load[k] = width*np.sum(known + kernel[-1]*(stretch[k] - stretch[k - 1]))
            wanted = 800*2*np.sqrt(5e-12)*1e-6*np.interp(found["time"], times, load)
            self.assertLess(np.max(np.abs(found["load"] - wanted)), error_of_springs*max(wanted), exponent)
            self.assertLess(abs(found["energy_imbalance"]), 1e-6)

    def test_approach_after_loss(self):
        """After a load has fallen to 0 the surface of a power law recovers as its creep says. The edge of a cone goes as the root of the
        load: where a load is as good as 0 it still has a depth, and the springs within it are let go."""
        for kind, exponent in (("kind = 'cone', slope = 0.1", 0.1), ("kind = 'cone', slope = 0.1", 0.5), ("kind = 'paraboloid', radius = 1.0", 0.8)):
            scene = f"&surface {kind} /\n&solid power_law_modulus = 1e5, power_law_exponent = {exponent} /\n" \
                "&history times = 0.0, 1.0, 2.0, 4.0, 4.5, loads = 0.0, 1e-3, 0.0, 0.0, 0.0 /\n&output steps_per_leg = 8000 /\n"
            path = self.solve(scene)
            # up to the loss all tolerances agree, so that the recovery is an integral over what is known
            known = path["time"] <= 2
            time, approach = path["time"][known], path["approach"][known]
            # int w^-a/(1 + w) dw from 0 to the time before the loss over the time since it, by y = w^(1 - a)
            most = ((2 - (time[:-1] + time[1:])/2)/2.5)**(1 - exponent)
            nodes, weights = np.polynomial.legendre.leggauss(40)
            lasting = (most[:, None]/2*weights/(1 + (most[:, None]*(nodes + 1)/2)**(1/(1 - exponent)))).sum(axis=1)/(1 - exponent)
            exact = np.sin(np.pi*exponent)/np.pi*np.sum(lasting*np.diff(approach))
            for tolerance in (1e-7, 1e-8, 1e-9):
                found = self.solve(scene.replace("8000", "4") + f"&numerics relative_tolerance = {tolerance} /\n")
                size = np.max(found["approach"])
                self.assertLess(abs(found["approach"][-1] - exact)/size, found["error_estimate"] + 3e-7, (kind, exponent, tolerance))

    def test_power_law_loads_that_come_back(self):
        """Loads that fall to 0, rest there and come back, beside springs in small steps. In each step the approach is where the springs that
        are in contact carry the load, which rises with it. The springs have an error of first order in their steps."""
        n_steps, n_springs, error_of_springs = 150, 300, 6e-3
        turns = (0, 1, 1.5, 1.8, 2.4, 3, 3.5)
        loads = (0, 1, 0, 0, 0.8, 0, 0.5)
        # of a spring of a micrometre on a ball, both its sides
        unit = 800*2*np.sqrt(5e-12)*1e-6
        for exponent in (0.3, 0.6, 0.9):
            found = self.solve(BALL + POWER.format(exponent) + f"&history times = {', '.join(map(str, turns))}, "
                               f"loads = {', '.join(f'{load*unit:.15e}' for load in loads)} /\n&output steps_per_leg = 20 /\n")
            grid = (np.arange(1, n_steps + 1)/n_steps)**3
            times = np.concatenate([[0]] + [begin + (end - begin)*grid for begin, end in zip(turns, turns[1:])])
            load = np.interp(times, turns, loads)
            width = 1.3*np.max(found["contact_radius"])/np.sqrt(5e-12)/n_springs
            depth = (width*(np.arange(n_springs) + 0.5))**2
            stretch = np.zeros((len(times), n_springs))
            approach = np.zeros(len(times))
            for k in range(1, len(times)):
                past = (times[k] - times[:k + 1])**(1 - exponent)/(1 - exponent)
                kernel = (past[:-1] - past[1:])/np.diff(times[:k + 1])
                known = kernel[:-1] @ np.diff(stretch[:k], axis=0) if k > 1 else np.zeros(n_springs)
                free = stretch[k - 1] - known/kernel[-1]
                low, high = np.min(free + depth), np.min(free + depth) + 2*depth[-1]
                for _ in range(60):
                    middle = (low + high)/2
                    carried = width*kernel[-1]*np.sum(np.maximum(middle - depth - free, 0))
                    low, high = (middle, high) if carried < load[k] else (low, middle)
                approach[k] = low
                stretch[k] = np.maximum(low - depth, free)
            wanted = 1e-6*np.interp(found["time"], times, approach)
            off = np.max(np.abs(found["approach"] - wanted))/max(wanted)
            self.assertLess(off, error_of_springs, exponent)
            self.assertLess(abs(found["energy_imbalance"]), 1e-6)

    def test_power_law_refused(self):
        """A power law without one of its numbers, beside arms, with adhesion, under a jump; a solver that has none."""
        path = "&history times = 0, 1, approaches = 0, 1e-7 /\n"
        law = POWER.format(0.3)
        self.refuse(BALL + "&solid power_law_exponent = 0.3 /\n" + path, "power_law_modulus: is missing")
        self.refuse(BALL + "&solid power_law_modulus = 800 /\n" + path, "power_law_exponent: is missing")
        self.refuse(BALL + POWER.format(0.96) + path, "power_law_exponent")
        self.refuse(BALL + law.replace("/", ", modulus = 1 /") + path, "modulus: stands beside a power law")
        self.refuse(BALL + law + "&adhesion work_of_adhesion = 1e-4, lambda = 2 /\n" + path, "power_law_modulus: has no meaning with adhesion")
        self.refuse(BALL + law + path.replace("approaches = 0", "approaches = 1e-8"), "approaches: jumps")
        self.refuse(BALL + law + path.replace("0, 1,", "0, 0,"), "are all equal")
        self.refuse(BALL + law + "&history times = 0, 1, 1, approaches = 0, 1e-7, 2e-7 /\n", "approaches: jumps")
        self.refuse(BALL + law + "&history path = 'ramp', largest_approach = 1e-6, approach_rate = 1e-6, contact_point = -1e-7 /\n",
                    "largest_approach: jumps")
        self.refuse(BALL + law + "&operating velocity = 1, load = 1 /\n", "nothing solves")

    def test_wide_contact(self):
        """A contact that is wider than its theory has a doubt, as at rest."""
        self.solve(BALL + SOLID + "&history times = 0, 1, approaches = 0, 5e-5 /\n")
        with h5py.File(self.folder/"run.h5") as file:
            self.assertGreater(file["doubt"][()], 0)

    def test_refused(self):
        """Each thing that makes no history."""
        lists = "times = 0, 1, 2, approaches = 0, 1e-7, 0"
        for history, words in (
                ("times = 0, 1, 2, approaches = 0, 1e-7", "has 2 values, and times has 3"),
                ("times = 0, 2, 1, approaches = 0, 1e-7, 0", "falls from"),
                ("times = 1, 1, approaches = 0, 1e-7", "are all equal"),
                ("times = 0, 1, approaches = 0, -1e-7", "never presses"),
                ("times = 0, 1", "is missing"),
                ("approaches = 0, 1e-7", "is missing"),
                ("times = 0, 1, loads = 0, -1e-9", "loads"),
                (lists + ", loads = 0, 1, 0", "stands beside"),
                (lists + ", dwell_time = 3", "has no meaning without path"),
                (lists + ", cycles = 3", "has no meaning without path"),
                (lists + ", frequency = 3", "has no meaning without path"),
                ("path = 'ramp', largest_approach = 1e-7, approach_rate = 1e-6, cycles = 3", "has no meaning for path = 'ramp'"),
                ("path = 'ramp', largest_approach = 1e-7", "approach_rate"),
                ("path = 'triangle', largest_load = 1e-9, loading_rate = 1e-9, retraction_rate = 1e-6", "has no meaning with largest_load"),
                ("path = 'sine', largest_approach = 1e-7, approach_rate = 1e-6, frequency = 1", "oscillation_amplitude"),
                ("path = 'sine', largest_approach = 1e-7, approach_rate = 1e-6, frequency = 1, oscillation_amplitude = 1e-6",
                 "above what is pressed")):
            with self.subTest(history=history):
                self.refuse(BALL + SOLID + f"&history {history} /\n", words)
        self.refuse(BALL + SOLID + "&history times = 0, 1, base_approaches = 0, 1e-7 /\n", "machine_stiffness")
        self.refuse(BALL + SOLID + f"&history {lists} /\n&operating machine_stiffness = 1.0 /\n", "has no meaning without")
        path = "&history path = 'triangle', largest_approach = 1e-7, approach_rate = 1e-6 /\n"
        for name in ("cycles", "steps_per_leg"):
            self.refuse(BALL + SOLID + path + f"&sweep variable = '{name}', values = 1, 2 /\n", name)
        self.refuse(BALL + SOLID + "&friction shear_strength = 1e4 /\n" + f"&history {lists} /\n", "nothing solves")

    def test_shifted(self):
        """Zero and drift of a history are those of its approaches; loads have none."""
        lists = "&history times = 0, 1, 2, approaches = {} /\n"
        plain = self.solve(BALL + SOLID + lists.format("0, 1e-6, 2e-7"))
        for shifted in ("1e-7, 1.1e-6, 3e-7, contact_point = 1e-7", "0, 0.8e-6, -2e-7, drift_rate = 2e-7"):
            found = self.solve(BALL + SOLID + lists.format(shifted))
            np.testing.assert_allclose(found["load"], plain["load"], rtol=1e-12)
            np.testing.assert_allclose(found["approach"], plain["approach"], rtol=1e-12)
        self.refuse(BALL + SOLID + "&history times = 0, 1, loads = 0, 1e-9, drift_rate = 1e-9 /\n", "drift_rate: has no meaning with loads")
        self.refuse(BALL + SOLID + lists.format("0, 1e-6, 0, contact_point = 2e-6"), "never presses: no value is above contact_point")
        self.refuse(BALL + SOLID + "&history path = 'square', largest_approach = 1e-6, approach_rate = 1e-6 /\n", "unknown choice")

    def test_noise(self):
        """A list with noise is pointed out. Smoothing leaves its steps, and takes fewer legs; approaches differ by no more than it."""
        times = np.linspace(0, 1, 401)
        noise = 2e-9*np.random.default_rng(1).standard_normal(times.shape)
        approaches = 1e-6*np.minimum(times, 1 - times) + noise
        (self.folder/"list.csv").write_text("t,z\n" + "".join(f"{t:.17g},{z:.17g}\n" for t, z in zip(times, approaches)))
        lists = "&history times = 'list.csv:t', approaches = 'list.csv:z'{} /\n"
        self.write("&job output = 'run.h5' /\n" + BALL + SOLID + lists.format(""))
        self.assertIn("times, and each turn is an unloading", self.run_program("check", "run.nml")[0])
        self.write("&job output = 'run.h5' /\n" + BALL + SOLID + lists.format(", smoothing = 1e-8"))
        self.assertNotIn("each turn", self.run_program("check", "run.nml")[0])
        found = self.solve(BALL + SOLID + lists.format(", smoothing = 1e-8"))
        np.testing.assert_allclose(found["time"], times, atol=1e-15)
        self.assertLess(np.max(np.abs(found["approach"] - approaches)), 1e-8*(1 + 1e-9))
        # the smooth triangle, but for what the noise is of its approaches
        smooth = self.solve(BALL + SOLID + "&history times = 0, 0.5, 1, approaches = 0, 5e-7, 0 /\n&output steps_per_leg = 200 /\n")
        self.assertLess(np.max(np.abs(found["load"] - smooth["load"])), 0.1*smooth["load"].max())
        self.refuse(BALL + SOLID + "&history times = 0, 1, 1, approaches = 0, 1e-6, 2e-6, smoothing = 1e-9 /\n", "stands beside a jump")
        self.refuse(BALL + SOLID + "&history path = 'ramp', largest_approach = 1e-6, approach_rate = 1e-6, smoothing = 1e-9 /\n",
                    "has no meaning with path")

    def test_loss_at_once(self):
        """Contact that a jump ends is lost at its time."""
        for what in ("approaches = 0, 1e-6, 0, 0", "loads = 0, 1e-9, 0, 0"):
            self.assertEqual(1, self.solve(BALL + SOLID + f"&history times = 0, 1, 1, 2, {what} /\n")["loss_time"])


if __name__ == "__main__":
    main()
