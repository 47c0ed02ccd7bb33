# SPDX-License-Identifier: GPL-3.0-or-later
"""The lines of docs/guide/clusters.md for GNU parallel: a task that is killed once, and the same lines again."""

import os
import re
import shutil
import signal
import subprocess
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from runs import PROGRAM, Runs, main  # noqa: E402

SOURCE = Path(os.environ["ADFRIC_SOURCE"])
N_PARTS = 6
KILLED = 2
# time of a part on one thread [s]: long enough to be met in the middle
PART_SECONDS = 1.5


def recipe():
    """The lines that the document has, for fewer parts."""
    text = (SOURCE / "docs/guide/clusters.md").read_text().split("## GNU parallel")[1]
    lines = re.search(r"^```sh\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)[1]
    return lines.replace("seq 16", f"seq {N_PARTS}").replace("/16", f"/{N_PARTS}").replace("-0016", f"-{N_PARTS:04}") \
        .replace("--jobs 8", "--jobs 2")


@unittest.skipUnless(shutil.which("parallel"), "GNU parallel is not installed")
class GnuParallel(Runs):
    def setUp(self):
        super().setUp()
        (self.folder / "bin").mkdir()
        # adfric in the path
        (self.folder / "bin" / "adfric").write_text(f'#!/bin/sh\nexec "{PROGRAM}" "$@"\n')
        (self.folder / "bin" / "adfric").chmod(0o755)
        self.write(self.case_of(N_PARTS*PART_SECONDS), "big.nml")
        self.run_program("run", "--quiet", "big.nml", "--output", "whole.h5")

    def shell(self, lines):
        environment = dict(os.environ, PATH=f"{self.folder}/bin:{os.environ['PATH']}", PARALLEL_HOME=f"{self.folder}/home")
        (self.folder / "home").mkdir(exist_ok=True)
        process = subprocess.Popen(["bash", "-c", lines], cwd=self.folder, env=environment, text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.addCleanup(process.wait)
        return process

    def part(self, number):
        return f"big.part-{number:04}-of-{N_PARTS:04}.h5"

    def log(self):
        """Tasks of the log: exit status and signal."""
        rows = [line.split("\t") for line in (self.folder / "big.log").read_text().splitlines()[1:]]
        return {int(row[0]): (int(row[6]), int(row[7])) for row in rows}

    def stamps(self, numbers):
        entries = {number: (self.folder / self.part(number)).stat() for number in numbers}
        return {number: (entry.st_ino, entry.st_mtime_ns) for number, entry in entries.items()}

    def check_again(self, lines):
        process = self.shell(lines)
        os.kill(self.meet(KILLED, N_PARTS), signal.SIGKILL)
        _, errors = process.communicate(timeout=120)
        self.assertEqual(process.returncode, 2)
        self.assertIn(f"1 of {N_PARTS} parts are missing: {KILLED}", errors)
        others = [number for number in range(1, N_PARTS + 1) if number != KILLED]
        before = self.stamps(others)
        states = self.log()
        self.assertNotEqual(states.pop(KILLED), (0, 0))
        self.assertTrue(all(state == (0, 0) for state in states.values()), states)
        self.assertGreater((self.status_of(f"{self.part(KILLED)}.partial") >= 0).sum(), 0)
        process = self.shell(lines)
        _, errors = process.communicate(timeout=120)
        self.assertEqual((process.returncode, errors), (0, ""))
        self.assertEqual(self.stamps(others), before, "a part that was complete is another now")
        self.assertEqual(self.log()[KILLED], (0, 0))
        self.assert_same(self.snapshot("whole.h5"), self.snapshot("big.h5"))

    def test_same_lines_again(self):
        self.check_again(recipe())

    def test_only_what_failed(self):
        self.check_again(recipe().replace("--joblog", "--resume-failed --joblog"))
        # once for each part, and once more
        self.assertEqual(len((self.folder / "big.log").read_text().splitlines()) - 1, N_PARTS + 1)


if __name__ == "__main__":
    main()
