# SPDX-License-Identifier: GPL-3.0-or-later
"""The pages of the guide: their inputs are solved, and their numbers are those of the inputs that they name."""

import os
import re
import shutil
import sys
import unittest
from pathlib import Path

import h5py
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from input_runs import InputRuns  # noqa: E402
from runs import main  # noqa: E402

SOURCE = Path(os.environ["ADFRIC_SOURCE"])
PAGES = sorted((SOURCE/"docs/guide").glob("*.md"))
# pages that answer one question by one input
QUESTIONS = ("a_scan_on_a_cluster", "ageing_of_a_contact", "columns", "fit", "fit_of_a_force_map", "fretting", "friction_of_a_tip", "pull_off_of_a_rough_surface", "rubber_on_a_road",
             "soft_samples")
INPUT = re.compile(r"^```fortran\n(.*?)^```$", re.MULTILINE | re.DOTALL)
PARTS = ("**Question.**", "scripts/", "](../gallery/", "## The input", "## Where it fails", "Next:")
FIGURE = re.compile(r"^!\[[^]]+\]\(([^)]+\.png)\)$", re.MULTILINE)


def digits(value, count=3):
    """A number as the pages print it."""
    return f"{float(f'{value:.{count - 1}e}'):g}"


class Guide(InputRuns):
    def page(self, name):
        return (SOURCE/f"docs/guide/{name}.md").read_text()

    def test_parts(self):
        """Each of these pages has a question, a command, a figure, an input, limits, and where to go on."""
        for name in QUESTIONS:
            for part in PARTS:
                self.assertIn(part, self.page(name), name)

    def test_figures(self):
        """Every page of the guide shows a figure."""
        self.assertGreaterEqual(len(PAGES), 15)
        without = {path.stem for path in PAGES if not FIGURE.search(path.read_text())}
        self.assertEqual(set(), without)

    def test_inputs(self):
        """The inputs of the pages are solved as they stand, big samples with fewer points."""
        self.make_surface("surface_stickiness", 32)
        shutil.copy(SOURCE/"tests/reference/fit/map_jkr_a.h5", self.folder/"map.h5")
        shutil.copy(SOURCE/"inputs/fit_friction.csv", self.folder)
        for name in QUESTIONS:
            with self.subTest(name):
                text = INPUT.search(self.page(name).split("## The input\n")[1])[1]
                text = re.sub(r"count = \d+", "count = 3", text).replace("turning_pressure', values = 0.0, 1.0e5", "turning_pressure', values = 0.0")
                self.write("&job output = 'run.h5' /\n" + text)
                self.run_program("fit" if "&data" in text else "run", "--quiet", "--force", "run.nml", status=None)
                self.assertTrue((self.folder/"run.h5").exists())

    def test_tip(self):
        page, found = self.page("friction_of_a_tip"), self.solve_any("johnson1997_fig5")
        at_rest = np.argmin(abs(found["load"]))
        self.assertIn(f"| {digits(1e9*found['friction_force'][at_rest])} nN without load |", page)
        self.assertIn(f"| {digits(1e9*found['pull_off_load'][at_rest])} nN |", page)
        self.assertIn(f"| {digits(1e18*found['friction_area'][at_rest])} nm^2 without load |", page)
        self.assertIn(f"| {digits(1e18*found['contact_area'][at_rest])} nm^2 without load |", page)

    def test_rubber(self):
        page, found = self.page("rubber_on_a_road"), self.solve_any("rubber_velocity")
        largest = found["friction_coefficient"].argmax(axis=1)
        speeds = [digits(found["velocity"][place], 2) for place in largest]
        self.assertIn(f"at most {digits(found['friction_coefficient'][1, largest[1]])}, at {speeds[1]} m/s and 25 °C", page)
        self.assertIn(f"{speeds[0]} m/s at 0 °C and {speeds[2]} m/s at 50 °C", page)
        printed = self.solve_printed("rubber_on_a_road")
        checked, _ = self.run_program("check", "run.nml")
        times = [digits(1e3*float(time)) for time in re.findall(r"retardation time (\S+) s", checked)]
        self.assertIn(f"prints those: {times[0]} ms and {times[1]} ms", page)
        top = printed["friction_coefficient"].argmax()
        self.assertIn(f"| at most {digits(printed['friction_coefficient'][top])}, at {digits(printed['velocity'][top], 2)} m/s |", page)
        self.assertIn(f"| from {digits(printed['contact_fraction'][0], 1)} when slow to {digits(printed['contact_fraction'][-1], 1)} when fast |", page)
        self.assertIn(f"from {digits(found['contact_fraction'][1, 0], 2)} when slow to {digits(found['contact_fraction'][1, -1], 1)} when fast", page)

    def test_fretting(self):
        page, found = self.page("fretting"), self.solve_any("hertz_hysteresis")
        period = (found["friction_loss"].shape[1] - 1)//3
        losses = found["friction_loss"][:, -1] - found["friction_loss"][:, -1 - period]
        self.assertIn(f"{digits(1e6*losses[0], 2)} uJ in a period, at mu = 0.15", page)
        self.assertIn(f"each period takes {digits(1e6*losses[1], 2)} uJ", page)
        self.assertIn(f"{digits(1e6*found['total_friction_loss'][0])} uJ after three periods", page)
        printed = self.solve_printed("fretting")
        self.assertIn(f"| {digits(1e6*printed['total_friction_loss'], 2)} uJ |", page)
        self.assertIn(f"| at most {digits(1e6*printed['largest_tangential_displacement'], 2)} um |", page)

    def test_ageing(self):
        page, printed = self.page("ageing_of_a_contact"), self.solve_printed("ageing_of_a_contact")
        self.assertIn(f"| from {digits(printed['contact_fraction'][0])} to {digits(printed['contact_fraction'][-1])} |", page)
        self.assertIn(f"| {digits(printed['contact_growth'])} |", page)

    def solve_printed(self, name):
        """Numbers of the input that a page prints."""
        self.write("&job output = 'run.h5' /\n" + INPUT.search(self.page(name).split("## The input\n")[1])[1])
        self.run_program("run", "--quiet", "--force", "run.nml")
        with h5py.File(self.folder/"run.h5") as file:
            return {key: data[()] for key, data in file.items() if isinstance(data, h5py.Dataset)}

    def solve_any(self, name):
        """Numbers of a shipped input, some of whose points may have no equilibrium."""
        self.run_program("run", "--quiet", "--force", "--output", "run.h5", SOURCE/f"inputs/{name}.nml")
        with h5py.File(self.folder/"run.h5") as file:
            return {key: data[()] for key, data in file.items() if isinstance(data, h5py.Dataset)}


if __name__ == "__main__":
    main()
