# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes in time with adhesion: tables of approach, load and spring, pull-off against its rate, its limits, energy, units, and what
is refused. Units of the tables: R = 1, w = 1/pi and E0 = 3/4, so that loads are in pi w R; sigma0 = lambda/2."""

import csv
import math
import os
import sys
from collections import defaultdict
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from runs import SolverRuns, main  # noqa: E402

TABLES = Path(os.environ["ADFRIC_SOURCE"]) / "tests/reference"
# moduli over E0 and times of the materials of the tables
MATERIALS = {"A": ("9", "1"), "B": ("2, 3, 4", "0.1, 1, 10")}
BALL = "&surface kind = 'paraboloid', radius = 1 /\n"
PUNCH = "&surface kind = 'flat_punch', face_radius = 1 /\n"
CONE = ("&surface kind = 'cone', slope = 0.6366197723675814 /\n&solid modulus = 1, moduli = 1, relaxation_times = 1 /\n"
        f"&adhesion adhesion_stress = {2/3}, adhesion_range = {2/math.pi!r} /\n"
        "&history path = 'triangle', largest_approach = 22, approach_rate = 0.05, dwell_time = 1000, ")
# what is asked for, and how far a run may be from a table: the tables have errors of their own
TOLERANCE = 1e-3
# share of alike cases, less in builds with checks: one of so many
EVERY = max(1, round(1/float(os.environ.get("ADFRIC_RANDOM_CASES", "1"))))


def rows_of(name):
    """The rows of a table."""
    with open(TABLES / name, encoding="utf-8") as lines:
        return list(csv.DictReader(line for line in lines if not line.startswith("#")))


def scene_of(material, size, history, surface=BALL, tolerance=TOLERANCE):
    """A scene in the units of the tables."""
    moduli, times = MATERIALS[material]
    moduli = ", ".join(str(0.75*float(word)) for word in moduli.split(","))
    return (f"{surface}&solid modulus = 0.75, moduli = {moduli}, relaxation_times = {times} /\n"
            f"&adhesion work_of_adhesion = {1/math.pi!r}, adhesion_stress = {size/2} /\n"
            f"&numerics relative_tolerance = {tolerance} /\n{history}")


def lists_of(name, kinks, places):
    """Lists of times and of what is prescribed, from the kinks of a path, with further times."""
    times = sorted({*(t for t, _ in kinks), *places})
    values = np.interp(times, *zip(*kinks))
    return times, f"&history times = {', '.join(map(repr, map(float, times)))}, {name} = {', '.join(map(repr, map(float, values)))} /\n"


def cases_of(name):
    """The cases of a table of histories: rows of each."""
    cases = defaultdict(list)
    for row in rows_of(name):
        cases[row["case"]].append(row)
    return list(cases.values())


def history_of(rows):
    """Kinks, times and history of a case: an approach, or a load or a spring up to a hold and back beyond the place where contact is lost."""
    places = [float(row["t"]) for row in rows]
    start = -2/(math.pi*float(rows[0]["lambda"]))
    if "v" in rows[0]:
        v, top, dwell, back = (float(rows[0][key]) for key in ("v", "delta_max", "dwell", "v_retract"))
        rest = (top - start)/v + dwell
        kinks = sorted({(0, start), ((top - start)/v, top), (rest, top), (rest + (top + 4)/back, -4)})
        return kinks, *lists_of("approaches", kinks, places)
    rate, top, lost = (float(rows[0][key]) for key in ("rate", "u_max", "u_pull_off"))
    by_load = rows[0]["ctl"] == "load"
    start = 0 if by_load else start
    up = (top - start)/rate
    kinks = [(0, start), (up, top), (up + 1, top), (up + 1 + (top - lost + 1)/rate, lost - 1)]
    times, history = lists_of("loads" if by_load else "base_approaches", kinks, places)
    return kinks, times, history + ("" if by_load else f"&operating machine_stiffness = {rows[0]['k']} /\n")


class AdhesionInTime(SolverRuns):
    """Runs of scenes in time with adhesion."""

    solver = "adhesive_indenter_time"

    def follow(self, found, times, rows, names):
        """The steps of a run beside the rows of a table, each over the largest one."""
        for column, result in names.items():
            wanted = np.array([float(row[column]) for row in rows])
            lacks = np.array([float(row[column + "_unc"]) for row in rows])
            steps = found[result][[times.index(float(row["t"])) for row in rows]]
            self.assertLess(np.max((abs(steps - wanted) - 2*lacks)/np.max(abs(wanted))), TOLERANCE, (rows[0]["case"], column))

    def test_given_approach(self):
        """Radii and load of `vit_adhesion.csv`."""
        for rows in cases_of("vit_adhesion.csv")[::EVERY]:
            _, times, history = history_of(rows)
            found = self.solve(scene_of(rows[0]["material"], float(rows[0]["lambda"]), history))
            self.follow(found, times, rows, {"a": "contact_radius", "c": "adhesion_radius", "P": "load"})
            self.assertLess(abs(found["energy_imbalance"]), 1e-3)

    def test_given_load_and_spring(self):
        """Radii, load and approach of `vit_adhesion_load.csv`, and where contact is lost."""
        for rows in cases_of("vit_adhesion_load.csv")[::EVERY]:
            kinks, times, history = history_of(rows)
            top, lost = float(rows[0]["u_max"]), float(rows[0]["u_pull_off"])
            found = self.solve(scene_of(rows[0]["material"], float(rows[0]["lambda"]), history))
            self.follow(found, times, rows, {"a": "contact_radius", "c": "adhesion_radius", "P": "load", "delta": "approach"})
            self.assertLess(abs(np.interp(found["loss_time"], *zip(*kinks)) - lost), TOLERANCE*(top - lost))

    def pull(self, rate, size=1.0, top=10, surface=BALL, approach=0.01, dwell=1000.0):
        """Pull-off after an approach and a dwell."""
        return self.solve(scene_of("A", size, f"&history path = 'triangle', largest_approach = {top}, approach_rate = {approach}, "
                                              f"dwell_time = {dwell}, retraction_rate = {rate} /\n", surface))

    def test_pull_off(self):
        """Pull-off of `vit_pulloff.csv` after a dwell, from slow to fast; it grows with the rate, between its limits."""
        loads = []
        for row in rows_of("vit_pulloff.csv"):
            # rested, nearly short of range at a slow rate, and never pressed; the slow one takes longest
            if EVERY > 1 and row["rate"] == "0.0001" or row["series"] not in ("relaxed_A_l1", "relaxed_A_l3", "edge_A_l1") or row["rate"] not in ("0.0001", "0.1", "10", "1000"):
                continue
            found = self.pull(row["rate"], size=float(row["lambda"]), top=row["delta_max"])
            self.assertLess(abs(found["pull_off_load"] - float(row["P_off"])), TOLERANCE*abs(float(row["P_off"])) + float(row["unc"]), row)
            if row["series"] == "relaxed_A_l1":
                loads.append(found["pull_off_load"])
        self.assertGreater(len(loads), 2)
        self.assertEqual(loads, sorted(loads, reverse=True))

    def test_pull_off_under_load(self):
        """Pull-off of `vit_pulloff_load.csv`, after a rest, and lists that never press."""
        for row in rows_of("vit_pulloff_load.csv"):
            rate = float(row["rate"])
            if rate < 1e-3 or rate > 1e3:
                continue
            found = self.solve(scene_of("A", 1.0, f"&history times = 0, 500, 1500, {1500 + 25/rate!r}, loads = 0, 5, 5, -20 /\n"))
            self.assertLess(abs(found["pull_off_load"] - float(row["P_pull_off"])), TOLERANCE*5 + float(row["unc"]), row)
        listed = self.solve(scene_of("A", 1.0, "&history times = 0, 3, 20, approaches = -0.6, -0.1, -4 /\n"))
        self.assertLess(listed["pull_off_load"], -1)

    def test_cone(self):
        """Pull-off of `vit_pulloff_cone.csv`: g = x, E0 = 1, so that f' = 2/pi, and the work of adhesion is 4/(3 pi)."""
        for row in rows_of("vit_pulloff_cone.csv"):
            if float(row["rate"]) < 1e-2:
                continue
            found = self.solve(f"{CONE}retraction_rate = {row['rate']} /\n")
            self.assertLess(abs(found["pull_off_load"]/float(row["P_off"]) - 1), TOLERANCE, row)

    def test_limits(self):
        """The limits of slow and of fast retraction, and of a fast approach too."""
        slow = self.pull(1e-4, top=1.5, dwell=10.0)
        # approached in proportion to the rate: 61 of it
        self.assertLess(abs(slow["pull_off_load"] - slow["relaxed_pull_off_load"] + 61*1e-4), 2e-3)
        fast = self.pull(1e6, approach=1e6, dwell=0.0, top=1.5)
        self.assertLess(abs(fast["pull_off_load"] - fast["glassy_pull_off_load"]), 1e-3)
        frozen = self.pull(1e6, size=3.0, top=20)
        self.assertLess(abs(frozen["pull_off_load"]/frozen["frozen_pull_off_load"] - 1), 1e-3)
        # a small preload, too
        frozen = self.pull(1e6, top=3)
        self.assertLess(abs(frozen["pull_off_load"]/frozen["frozen_pull_off_load"] - 1), 1e-3)

    def test_frozen_limit(self):
        """Every preload of `vit_limit.csv`: its zone ends within the rested contact, beside it or outside. Short ranges take long."""
        rows = [row for row in rows_of("vit_limit.csv") if float(row["lambda"]) <= 3]
        self.assertGreater(len(rows), 20)
        for row in rows[::EVERY]:
            history = f"&history path = 'triangle', largest_approach = {row['delta_r']}, approach_rate = 1e6 /\n"
            scene = scene_of("A", float(row["lambda"]), history, tolerance=1e-2)
            found = self.solve(scene.replace("moduli = 6.75", f"moduli = {0.75*(float(row['r']) - 1)!r}"))
            self.assertLess(abs(found["frozen_pull_off_load"]/float(row["P_off"]) - 1), 2e-5, row)

    def test_comes_back(self):
        """Contact is lost and comes back: four jumps, at a tolerance far below the default; a load, a spring, and an approach."""
        for history in ("&history times = 0, 5, 10, 15, 25, loads = 0, 5, -10, 5, -10 /\n",
                        "&history times = 0, 5, 15, 20, 30, base_approaches = -0.6366, 3, -8, 3, -8 /\n&operating machine_stiffness = 3 /\n",
                        "&history times = 0, 5, 15, 20, 30, approaches = -0.6366, 3, -4, 3, -4 /\n")[::EVERY]:
            fine, plain = (self.solve(scene_of("A", 1.0, history, tolerance=tolerance)) for tolerance in (1e-5, TOLERANCE))
            self.assertEqual((4, 4), (fine["jumps"], plain["jumps"]))
            self.assertLess(abs(fine["pull_off_load"]/plain["pull_off_load"] - 1), TOLERANCE)

    def test_trigger(self):
        """Pressing ends where a load is reached, at an approach that gives the same path; also behind a spring."""
        rates = "approach_rate = 0.5, retraction_rate = 0.5, dwell_time = 0.3"
        for end, name in (("", "largest_approach"), ("&operating machine_stiffness = 3 /\n", "largest_base_approach"))[::EVERY]:
            for tolerance in (TOLERANCE, 1e-4):
                found = self.solve(scene_of("A", 1.0, f"&history path = 'triangle', trigger_load = 2, {rates} /\n{end}", tolerance=tolerance))
                # the load counts over the largest one, and the approach of the turn over all of pressing
                self.assertLess(abs(found["load"][50]/2 - 1), 2*tolerance)
            # it begins where the range does
            top = 0.5*float(found["time"][50]) - 2/math.pi
            given = self.solve(scene_of("A", 1.0, f"&history path = 'triangle', {name} = {top!r}, {rates} /\n{end}", tolerance=tolerance))
            self.assertLess(abs(given["pull_off_load"]/found["pull_off_load"] - 1), 2*tolerance)

    def test_long_list(self):
        """A smooth list of many values is that of few: weak kinks do not shorten steps."""
        loads = []
        for count in (101, 4001):
            times = np.linspace(0, 40, count)
            values = 3.6365*np.sin(math.pi*times/40)**2 - 0.6365 - 3*(times/40)**4
            table = "\n".join(f"{float(t)!r},{float(v)!r}" for t, v in zip(times, values))
            self.write("t,x\n" + table + "\n", "list.csv")
            found = self.solve(scene_of("A", 1.0, "&history times = 'list.csv:t', approaches = 'list.csv:x' /\n"))
            loads.append(found["pull_off_load"])
        # straight pieces of 0.4 are off by 1/8 of 0.4^2 times the curvature of the path, 0.016
        self.assertLess(abs(loads[1]/loads[0] - 1), 2*TOLERANCE)

    def test_elastic(self):
        """Arms without a modulus: pull-off is that of an elastic half-space."""
        found = self.solve(scene_of("A", 1.0, "&history path = 'triangle', largest_approach = 1, approach_rate = 1 /\n").replace(
            "moduli = 6.75", "moduli = 0"))
        self.assertLess(abs(found["pull_off_load"] - found["relaxed_pull_off_load"]), 1e-4)
        self.assertLess(abs(found["dissipated_energy"] - found["path_work"] + found["elastic_energy"] + found["adhesion_energy"]), 1e-3)

    def test_stiff_spring(self):
        """A stiff spring is a given approach."""
        path = "&history path = 'triangle', {} = 1, approach_rate = 0.5 /\n"
        free = self.solve(scene_of("A", 1.0, path.format("largest_approach")))
        held = self.solve(scene_of("A", 1.0, path.format("largest_base_approach") + "&operating machine_stiffness = 1e6 /\n"))
        self.assertLess(abs(free["pull_off_load"] - held["pull_off_load"]), 1e-3*abs(free["pull_off_load"]))

    def test_units(self):
        """Lengths, moduli and times in other units: the same results."""
        history = "&history path = 'triangle', largest_approach = {}, approach_rate = {}, dwell_time = {} /\n"
        one = self.solve(scene_of("B", 1.0, history.format(1.0, 0.5, 1.0)))
        other = self.solve("&surface kind = 'paraboloid', radius = 1e-6 /\n&solid modulus = 0.75e3, moduli = 1.5e3, 2.25e3, 3e3, "
                           "relaxation_times = 1e-3, 1e-2, 1e-1 /\n"
                           f"&adhesion work_of_adhesion = {1e-3/math.pi!r}, adhesion_stress = 0.5e3 /\n"
                           f"&numerics relative_tolerance = {TOLERANCE} /\n" + history.format(1e-6, 0.5e-4, 1e-2))
        for name, unit in (("pull_off_load", 1e-9), ("pull_off_approach", 1e-6), ("pull_off_time", 1e-2), ("jumps", 1)):
            self.assertLess(abs(other[name]/(one[name]*unit) - 1), 1e-6, name)

    def test_shapes(self):
        """Other shapes: the slow limit of each is its elastic pull-off."""
        for surface in ("kind = 'cone', slope = 0.5", "kind = 'power', exponent = 1.5, power_coefficient = 1", "kind = 'sphere', radius = 8",
                        "kind = 'flat_paraboloid', face_radius = 0.3, radius = 1", "kind = 'rounded_cone', slope = 1, radius = 1",
                        "kind = 'polynomial', coefficient_1 = 0.3, coefficient_2 = 0.5")[::EVERY]:
            found = self.solve(scene_of("A", 1.0, "&history path = 'triangle', largest_approach = 2.5, approach_rate = 1e3, "
                                                  "dwell_time = 20, retraction_rate = 1e-6 /\n", f"&surface {surface} /\n"))
            self.assertLess(abs(found["pull_off_load"]/found["relaxed_pull_off_load"] - 1), 1e-3, surface)
            self.assertLess(abs(found["energy_imbalance"]), 5e-3, surface)

    def punch(self, history, surface=PUNCH, moduli="9", stress=1.0):
        """A flat punch, or another body, on a solid of relaxed contact modulus 1, whose zone is 1/40 of its radius."""
        return self.solve(f"{surface}&solid modulus = 1, moduli = {moduli}, relaxation_times = 1 /\n&adhesion work_of_adhesion = 0.03, "
                          f"adhesion_stress = {stress} /\n&numerics relative_tolerance = {TOLERANCE} /\n&history {history} /\n")

    def test_flat_punch(self):
        """A flat punch: its elastic pull-off, slow and fast retraction, the limit of bodies with a steep flank, and its energy."""
        path = "path = 'triangle', largest_approach = 1, approach_rate = {}, dwell_time = {}, retraction_rate = {}"
        wanted = self.punch(path.format(1, 1, 1), moduli="1e-9")
        self.assertLess(abs(wanted["pull_off_load"]/wanted["relaxed_pull_off_load"] - 1), 1e-6)
        # pressed and at rest, the load is that of the whole face, with E(t)
        rest = self.punch("times = 0, 1e-6, 2, 2.1, approaches = 0, 1, 1, -1")
        for k, time in ((1, 0.0), (2, 2.0)):
            self.assertLess(abs(rest["load"][k]/(2*(1 + 9*math.exp(-time))) - 1), 1e-5)
            self.assertEqual(rest["contact_radius"][k], 1)
        loads = []
        for approach, dwell, rate in ((1, 100, 1e-3), (1, 100, 0.1), (1, 100, 1.0), (1, 100, 1e3), (1e4, 0, 1e4)):
            found = self.punch(path.format(approach, dwell, rate))
            loads.append(found["pull_off_load"])
            self.assertLess(abs(found["energy_imbalance"]), 1e-4)
            self.assertEqual(found["frozen_pull_off_load"], found["glassy_pull_off_load"])
        self.assertEqual(loads[:4], sorted(loads[:4], reverse=True))
        self.assertLess(loads[0], found["relaxed_pull_off_load"])
        # m is uniform under a face that has rested: fast retraction is glassy with a rest and without one
        for load in loads[3:]:
            self.assertLess(abs(load/found["glassy_pull_off_load"] - 1), 1e-3)
        # a steep flank beyond the face pulls with a little more, in proportion to its width
        excess = [self.punch(path.format(1, 100, 0.1), f"&surface kind = 'flat_paraboloid', face_radius = 1, radius = {radius} /\n")["pull_off_load"]/loads[1] - 1
                  for radius in (0.3, 0.1)]
        self.assertGreater(excess[1], 0)
        self.assertLess(excess[1], 6e-3)
        self.assertLess(excess[1], 0.4*excess[0])

    def test_flat_punch_small(self):
        """A punch that is small beside its range pulls with its whole face, at any rate; its stress is then the one number."""
        for rate in (0.1, 10.0)[::EVERY]:
            found = self.punch(f"path = 'triangle', largest_approach = 1, approach_rate = 1, dwell_time = 3, retraction_rate = {rate}", stress=0.1)
            self.assertLess(abs(found["pull_off_load"]/(-0.1*math.pi) - 1), 1e-6)

    def test_flat_punch_controls(self):
        """A flat punch under a load and behind springs, soft ones near the load and stiff ones near the approach; and in other units."""
        history = "times = 0, 1, 50, {}, {} = 0, 1, 1, {}"
        load = self.punch(history.format(54, "loads", -3))
        soft = self.punch(history.format(54, "base_approaches", -3).replace("0, 1, 1, -3", "0, 1e4, 1e4, -3e4") + " /\n&operating machine_stiffness = 1e-4")
        self.assertLess(abs(soft["pull_off_load"]/load["pull_off_load"] - 1), 2e-3)
        free = self.punch(history.format(52, "approaches", -1))
        stiff = self.punch(history.format(52, "base_approaches", -1) + " /\n&operating machine_stiffness = 1e6")
        self.assertLess(abs(stiff["pull_off_load"]/free["pull_off_load"] - 1), 2e-3)
        for found in (load, soft, free, stiff):
            self.assertLess(abs(found["energy_imbalance"]), 1e-3)
            self.assertLess(found["pull_off_load"], found["relaxed_pull_off_load"])
            self.assertGreater(found["pull_off_load"], found["glassy_pull_off_load"])
        other = self.solve("&surface kind = 'flat_punch', face_radius = 1e-6 /\n&solid modulus = 1e3, moduli = 9e3, relaxation_times = 1e-2 /\n"
                           f"&adhesion work_of_adhesion = 0.03e-3, adhesion_stress = 1e3 /\n&numerics relative_tolerance = {TOLERANCE} /\n"
                           "&history times = 0, 0.01, 0.5, 0.52, approaches = 0, 1e-6, 1e-6, -1e-6 /\n")
        for name, unit in (("pull_off_load", 1e-9), ("pull_off_approach", 1e-6), ("pull_off_time", 1e-2), ("jumps", 1)):
            self.assertLess(abs(other[name]/(free[name]*unit) - 1), 1e-6, name)
        # contact that ends and comes back, and an approach that never touches
        again = self.punch("times = 0, 1, 3, 5, 7, approaches = -0.1, 0.3, -2, 0.3, -2")
        self.assertEqual(again["jumps"], 4)
        self.assertLess(abs(again["energy_imbalance"]), 1e-3)
        apart = self.punch("times = 0, 1, 3, approaches = -2, -0.02, -2")
        self.assertLess(apart["pull_off_load"], 0)

    def test_refused(self):
        """What has no meaning is refused in one line."""
        history = "&history path = 'triangle', largest_approach = 1, approach_rate = 1 /\n"
        scene = scene_of("A", 1.0, history)
        # without a history it is the history that is missing, with adhesion and without
        for bare in (scene.replace(history, ""), scene.replace(history, "&operating approach = 1 /\n"),
                     "".join(line for line in scene.replace(history, "").splitlines(True) if "&adhesion" not in line)):
            self.refuse(bare, "give &history times with what is prescribed, or a path")
        self.refuse(scene.replace(", adhesion_stress = 0.5", ""), "has no range, which adhesion in time needs")
        # lambda is a number of powers of r
        self.refuse(scene.replace(BALL, PUNCH).replace("adhesion_stress = 0.5", "lambda = 1"), "lambda")
        self.refuse(scene.replace(BALL, "&surface kind = 'flat_punch' /\n"), "face_radius")
        self.refuse(scene.replace("modulus = 0.75", "modulus = 0"), "modulus")
        self.refuse(scene.replace("adhesion_stress = 0.5", "adhesion_stress = 1e3"), "has so short a range")
        self.refuse(scene.replace("&numerics ", "&numerics cells = 5, "), "which needs 6; give")
        # cells that no number would do are no second problem
        self.refuse(scene.replace("adhesion_stress = 0.5", "adhesion_stress = 1e3").replace("&numerics ", "&numerics cells = 64, "),
                    "has so short a range")
        self.refuse(scene.replace("adhesion_stress = 0.5", "adhesion_stress = 1e9"), "needs 1000000000 or more cells")
        self.refuse(scene.replace(history, "&history times = 0, 1, 2, approaches = 0, 1 /\n"), "has 2 values, and times has 3")
        self.refuse(scene.replace("triangle", "sine").replace("approach_rate = 1", "approach_rate = 1, frequency = 1, "
                                                              "oscillation_amplitude = 0.1"), "'sine'")
        self.refuse(scene.replace("kind = 'paraboloid', radius = 1", "kind = 'sphere', radius = 0.5"), "beyond the body")
        listed = "&history times = 0, 1, 2, approaches = -0.6, 1, 0, smoothing = 0.1 /\n"
        self.refuse(scene.replace(history, listed), "has no solver with adhesion")
        self.refuse(scene.replace("largest_approach = 1", "largest_approach = -1"), "too small for this history")


if __name__ == "__main__":
    main()
