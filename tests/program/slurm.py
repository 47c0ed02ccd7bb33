# SPDX-License-Identifier: GPL-3.0-or-later
"""The job script under a Slurm of its own: tasks that are cancelled, told to end or killed, and submitted again."""

import os
import re
import signal
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from one_node import NoSlurm, OneNode  # noqa: E402
from runs import PROGRAM, Runs, main  # noqa: E402

SCRIPT = os.environ["ADFRIC_SOURCE"] + "/scripts/slurm_array.sh"
N_PARTS = 6
# time of a part on one thread [s]: long enough to be met in the middle
PART_SECONDS = 2.5
# for jobs that wait in a queue, on a machine that does other things
PATIENCE = 180


class Slurm(Runs):
    # input of every test, and what one run makes of it
    text, whole = None, None

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        try:
            cls.node = OneNode(Path(folder.name))
        except NoSlurm as reason:
            raise unittest.SkipTest(str(reason)) from None
        cls.addClassCleanup(cls.node.stop)

    def run(self, result=None):
        """Run a test; after a failure, say what the daemons and the jobs have said."""
        before = len(result.failures) + len(result.errors)
        super().run(result)
        if len(result.failures) + len(result.errors) > before:
            print(self.node.logs(), file=sys.stderr)

    def setUp(self):
        super().setUp()
        self.addCleanup(self.keep_job_logs)
        if self.text is None:
            type(self).text = self.case_of(N_PARTS*PART_SECONDS)
            self.write(self.text, "big.nml")
            self.run_program("run", "--quiet", "big.nml", "--output", "whole.h5")
            type(self).whole = self.snapshot("whole.h5")
        self.write(self.text, "big.nml")

    def keep_job_logs(self):
        """For `run`, since the folder goes."""
        for path in sorted(self.folder.glob("*.log")):
            (self.node.folder / f"job-{path.name}").write_text(path.read_text())

    def part(self, number):
        return f"big.part-{number:04}-of-{N_PARTS:04}.h5"

    def submit(self, n_parts):
        """Submit the sweep, which has so many parts to solve; the two jobs."""
        environment = dict(self.node.environment, ADFRIC=PROGRAM, ADFRIC_SBATCH="--cpus-per-task=1 --time=10")
        process = subprocess.run([SCRIPT, "big.nml", str(N_PARTS)], cwd=self.folder, env=environment, text=True,
                                 capture_output=True, timeout=60)
        self.assertEqual((process.returncode, process.stderr), (0, ""))
        found = re.fullmatch(rf"slurm_array: job (\d+) solves {n_parts} of {N_PARTS} parts\n"
                             r"slurm_array: job (\d+) merges them into big.h5\n", process.stdout)
        self.assertTrue(found, process.stdout)
        return found.groups()

    def meet_task(self, number):
        return self.meet(number, N_PARTS, PATIENCE)

    def log_of(self, job, number=None):
        name = f"adfric-{job}.log" if number is None else f"adfric-{job}_{number}.log"
        return (self.folder / name).read_text()

    def check_lost(self, jobs, lost):
        """Wait for the end of everything: all parts are solved but those that were lost, which have something to go on with."""
        array, last = jobs
        self.assertEqual(self.node.wait_for_end(last, PATIENCE), "FAILED")
        missing = ", ".join(str(number) for number in lost)
        self.assertIn(f"{len(lost)} of {N_PARTS} parts are missing: {missing}", self.log_of(last))
        for number in range(1, N_PARTS + 1):
            if number in lost:
                self.assertFalse((self.folder / self.part(number)).exists())
                status = self.status_of(f"{self.part(number)}.partial")
                self.assertGreater((status >= 0).sum(), 0)
                self.assertLess((status >= 0).sum(), status.size)
            else:
                self.assertEqual(self.node.state(f"{array}_{number}"), "COMPLETED")
                self.assertTrue((self.folder / self.part(number)).exists())

    def check_again(self, lost):
        """Submit again what was lost; everything is as if nothing had happened."""
        before = {number: self.stamp(number) for number in range(1, N_PARTS + 1) if number not in lost}
        array, last = self.submit(len(lost))
        self.assertEqual(self.node.wait_for_end(last, PATIENCE), "COMPLETED", self.log_of(last))
        for number in range(1, N_PARTS + 1):
            ran = (self.folder / f"adfric-{array}_{number}.log").exists()
            self.assertEqual(ran, number in lost, number)
        for number, stamp in before.items():
            self.assertEqual(self.stamp(number), stamp, "a part that was complete is another now")
        self.assert_same(self.whole, self.snapshot("big.h5"))

    def stamp(self, number):
        entry = (self.folder / self.part(number)).stat()
        return entry.st_ino, entry.st_mtime_ns

    def test_cancelled_tasks(self):
        array, last = self.submit(N_PARTS)
        # one of them is cancelled, which tells the script and the program; of another one only the script is told, as
        # before the end of its time
        self.meet_task(2)
        self.node.say("scancel", f"{array}_2")
        self.meet_task(4)
        self.node.say("scancel", "--batch", "--signal=TERM", f"{array}_4")
        self.check_lost((array, last), [2, 4])
        self.assertEqual(self.node.state(f"{array}_2"), "CANCELLED")
        self.assertEqual(self.node.state(f"{array}_4"), "FAILED")
        for number in (2, 4):
            self.assertRegex(self.log_of(array, number), r"stopped by SIGTERM, \d+ of \d+ points are in")
        self.check_again([2, 4])

    def test_killed_program(self):
        array, last = self.submit(N_PARTS)
        os.kill(self.meet_task(3), signal.SIGKILL)
        self.check_lost((array, last), [3])
        self.assertEqual(self.node.state(f"{array}_3"), "FAILED")
        self.check_again([3])


if __name__ == "__main__":
    main()
