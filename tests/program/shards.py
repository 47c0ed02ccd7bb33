# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs in parts, and the parts put together: the same file as that of one run, to the bit."""

import os
import shutil
import signal
import subprocess
import sys
import unittest
from pathlib import Path

import numpy as np
import xarray as xr

sys.path.insert(0, str(Path(__file__).parent))
from runs import LOADS, PROFILES, PROGRAM, Runs  # noqa: E402

SCRIPT = os.environ["ADFRIC_SOURCE"] + "/scripts/slurm_array.sh"
ONE_POINT = """
&job model = 'hertz', output = 'run.h5' /
&contact kind = 'circular', radius = 1 /
&solid contact_modulus = 1e9 /
&operating load = 1 /
"""


class Shards(Runs):
    def part(self, number, n, name="run"):
        return f"{name}.part-{number:04}-of-{n:04}.h5"

    def parts(self, n):
        return [self.part(number, n) for number in range(1, n + 1)]

    def run_parts(self, n, **options):
        for number in range(1, n + 1):
            self.run_program("run", "--quiet", "run.nml", "--shard", f"{number}/{n}", **options)

    def run_whole(self, text):
        self.write(text)
        self.run_program("run", "run.nml", "--output", "whole.h5")
        return self.snapshot("whole.h5")

    def check_parts(self, text, numbers):
        whole = self.run_whole(text)
        for n in numbers:
            with self.subTest(n=n):
                self.run_parts(n, threads=1 + n % 2)
                output, _ = self.run_program("merge", "all.h5", *reversed(self.parts(n)))
                self.assertRegex(output, rf"parts +{n}\n")
                self.assert_same(whole, self.snapshot("all.h5"))
                self.run_program("merge", "--virtual", "--quiet", "virtual.h5", *self.parts(n))
                self.assert_same(whole, self.snapshot("virtual.h5"))
                for name in ("all.h5", "virtual.h5", *self.parts(n)):
                    (self.folder / name).unlink()
                self.assertEqual(self.names(), ["run.nml", "whole.h5"])

    def test_profiles(self):
        # 150 points in 10 blocks
        self.check_parts(PROFILES.format(strips=16, count=50), (1, 3, 7, 13))

    def test_many_blocks(self):
        # 130 000 points in 508 blocks, more than one to a piece for few parts
        text = """
&job model = 'sphere', output = 'run.h5' /
&sphere units = 'reduced', lambda = 0.8 /
&friction shear_strength = 0.8, slip_energy_ratio = 1.1 /
&operating state = 'sliding' /
&sweep variable = 'interaction', values = 0, 0.1, 0.2, 0.4, 0.8 /
&sweep variable = 'edge_fraction', values = 0.2, 0.4 /
&sweep variable = 'load', from = -2, to = 10, count = 13000 /
"""
        self.check_parts(text, (2, 5, 40))

    def test_one_point(self):
        self.check_parts(ONE_POINT, (1, 3))

    def test_resume(self):
        # the half of it that is stopped lasts long enough
        whole = self.run_whole(PROFILES.format(strips=16, count=2 * self.count_of_lasting(PROFILES)))
        self.run_parts(2)
        (self.folder / self.part(2, 2)).unlink()
        process = self.start("run", "--quiet", "run.nml", "--shard", "2/2", threads=1)
        self.wait_for_points(self.part(2, 2) + ".partial")
        process.send_signal(signal.SIGTERM)
        _, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 143)
        self.assertIn("adfric run --resume --shard 2/2 run.nml goes on", errors)
        _, errors = self.run_program("merge", "all.h5", self.part(1, 2), self.part(2, 2) + ".partial", status=2)
        self.assertRegex(errors, r"this part is not complete, \d+ of its \d+ points are missing; "
                                 r"adfric run --resume --shard 2/2 goes on with it")
        # a part that is complete stays as it is
        before = (self.folder / self.part(1, 2)).read_bytes()
        for number in (1, 2):
            self.run_program("run", "--resume", "run.nml", "--shard", f"{number}/2")
        self.assertEqual((self.folder / self.part(1, 2)).read_bytes(), before)
        self.run_program("merge", "all.h5", *self.parts(2))
        self.assert_same(whole, self.snapshot("all.h5"))

    def test_what_does_not_belong_together(self):
        self.write(LOADS.format(strips=16, count=61))
        self.run_parts(3)
        self.run_program("run", "--output", "other", "--shard", "2/3", "run.nml")
        self.run_program("run", "--shard", "2/4", "run.nml")
        self.run_program("run", "run.nml", "--output", "whole.h5")
        self.write(LOADS.format(strips=16, count=62), "foreign.nml")
        self.run_program("run", "--shard", "2/3", "foreign.nml", "--output", "foreign.h5")
        (self.folder / "text.h5").write_text("text")
        one, two, three = self.parts(3)
        for given, status, expected in [
                ((one, three), 2, f"{one}: 1 of 3 parts are missing: 2\n"),
                ((two,), 2, f"{two}: 2 of 3 parts are missing: 1, 3\n"),
                ((one, two, three, one), 2, f"{one}: part 1 of 3 is given twice, also as {one}\n"),
                ((one, two, three, "other.part-0002-of-0003.h5"), 2, f"part 2 of 3 is given twice, also as {two}\n"),
                ((one, self.part(2, 3, "foreign"), three), 2, f"does not belong to the run of {one}: it was made from another"),
                ((one, self.part(2, 4), three), 2, f"one of 4 parts, but {one} is one of 3\n"),
                ((one, "whole.h5", three), 2, "whole.h5: this is no part of a run"),
                ((one, "text.h5", three), 3, "text.h5: cannot read"),
                ((one, "nothing.h5", three), 3, "nothing.h5: cannot read: No such file or directory\n"),
        ]:
            for options in ([], ["--virtual"]):
                with self.subTest(given=given, options=options):
                    before = self.names()
                    _, errors = self.run_program("merge", *options, "all.h5", *given, status=status)
                    self.assertIn(expected, errors)
                    self.assertEqual(self.names(), before)
        _, errors = self.run_program("merge", one, "--force", one, two, three, status=2)
        self.assertIn("would replace the part", errors)
        _, errors = self.run_program("merge", "whole.h5", one, two, three, status=3)
        self.assertIn("this file exists; --force overwrites it, or name another one: adfric merge FILE.h5 PART.h5", errors)
        self.run_program("merge", "all.h5", one, two, three)
        self.assert_same(self.snapshot("whole.h5"), self.snapshot("all.h5"))

    def test_virtual_file(self):
        whole = self.run_whole(PROFILES.format(strips=16, count=50))
        (self.folder / "parts").mkdir()
        for number in (1, 2, 3):
            self.run_program("run", "run.nml", "--shard", f"{number}/3", "--output", "parts/run.h5")
        parts = [f"parts/{name}" for name in self.parts(3)]
        self.run_program("merge", "--virtual", "all.h5", *parts)
        # it refers to the parts, and goes wherever they go with it
        self.assertLess((self.folder / "all.h5").stat().st_size, (self.folder / "whole.h5").stat().st_size / 2)
        (self.folder / "moved").mkdir()
        shutil.move(self.folder / "parts", self.folder / "moved" / "parts")
        shutil.move(self.folder / "all.h5", self.folder / "moved" / "all.h5")
        self.assert_same(whole, self.snapshot("moved/all.h5"))
        with xr.open_dataset(self.folder / "moved/all.h5", engine="h5netcdf") as results:
            self.assertEqual(results.friction_force.dims, ("stress", "load"))
            self.assertEqual(results.pressure.dims, ("stress", "load", "y", "x"))
        (self.folder / "moved" / parts[1]).unlink()
        with xr.open_dataset(self.folder / "moved/all.h5", engine="h5netcdf") as results:
            self.assertTrue(np.any(results.status == -1))
            self.assertTrue(np.all(np.isnan(results.friction_force.where(results.status == -1))))

    def script(self, *arguments, task=0):
        """The job script, called by a user or started by Slurm as a task; sbatch writes down what it is asked to do."""
        sbatch = self.folder / "bin" / "sbatch"
        if not sbatch.exists():
            sbatch.parent.mkdir()
            sbatch.write_text("#!/bin/sh\nprintf '%s\\n' \"$*\" >>jobs\necho \"$(wc -l <jobs);cluster\"\n")
            sbatch.chmod(0o755)
        environment = dict(os.environ, PATH=f"{sbatch.parent}:{os.environ['PATH']}", ADFRIC=PROGRAM,
                           SLURM_ARRAY_TASK_ID=str(task), SLURM_CPUS_PER_TASK="2")
        return subprocess.Popen([SCRIPT, *arguments], cwd=self.folder, env=environment, text=True,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    def run_script(self, *arguments, task=0):
        process = self.script(*arguments, task=task)
        output, errors = process.communicate(timeout=60)
        return process.returncode, output, errors

    def submitted(self):
        """The jobs of the last call: options, and what their script is told."""
        jobs = (self.folder / "jobs").read_text().splitlines()
        (self.folder / "jobs").unlink()
        return [job.split(f" {SCRIPT} ") for job in jobs]

    def test_job_script(self):
        whole = self.run_whole(LOADS.format(strips=16, count=61))
        status, output, errors = self.run_script("run.nml", "5")
        self.assertEqual((status, errors), (0, ""))
        self.assertIn("job 1 solves 5 of 5 parts", output)
        (array, solve), (last, merge) = self.submitted()
        self.assertEqual(array, "--parsable --array=1-5")
        self.assertEqual(solve, f"--solve {PROGRAM} run.nml 5 run.h5")
        self.assertIn("--dependency=afterany:1", last)
        self.assertEqual(merge, f"--merge {PROGRAM} 5 run.h5")
        # one task is lost
        for task in (1, 3, 4, 5):
            self.assertEqual(self.run_script(*solve.split(), task=task), (0, "", ""))
        status, _, errors = self.run_script(*merge.split())
        self.assertEqual(status, 2)
        self.assertIn("1 of 5 parts are missing: 2", errors)
        # once more, and two
        (self.folder / self.part(5, 5)).unlink()
        self.assertEqual(self.run_script("run.nml", "5")[0], 0)
        (array, solve), (last, merge) = self.submitted()
        self.assertEqual(array, "--parsable --array=2,5")
        for task in (2, 5):
            self.assertEqual(self.run_script(*solve.split(), task=task), (0, "", ""))
        status, output, errors = self.run_script("run.nml", "5")
        self.assertEqual((status, errors), (0, ""))
        ((last, merge),) = self.submitted()
        self.assertNotIn("dependency", last)
        status, _, errors = self.run_script(*merge.split())
        self.assertEqual((status, errors), (0, ""))
        self.assert_same(whole, self.snapshot("run.h5"))
        status, _, errors = self.run_script("run.nml", "5")
        self.assertEqual((status, errors), (2, "slurm_array: run.h5 exists: the sweep is done\n"))
        for number in ("", "0", "x", "-3", "1.5"):
            self.assertEqual(self.run_script("run.nml", number, "other.h5")[0], 2)

    def test_job_script_at_the_end_of_its_time(self):
        self.write(LOADS.format(strips=16, count=4 * self.count_of_lasting(LOADS)))
        task = ("--solve", PROGRAM, "run.nml", "2", "run.h5")
        process = self.script(*task, task=1)
        self.wait_for_points(self.part(1, 2) + ".partial")
        process.send_signal(signal.SIGTERM)
        _, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 143)
        self.assertIn("stopped by SIGTERM", errors)
        self.assertGreater((self.status_of(self.part(1, 2) + ".partial") >= 0).sum(), 0)


if __name__ == "__main__":
    unittest.main()
