# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs that are killed, stopped or run out of room, and resumed: nothing is lost, and the results are the same bits."""

import os
import random
import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from runs import IN_ORDER, LOADS, PROFILES, Runs, limit_file_size  # noqa: E402

# fewer where checks make runs slow
N_KILLS = max(5, round(17*float(os.environ.get("ADFRIC_RANDOM_CASES", "1"))))
# a point takes long, and may be ended at any time
SLOW = """
&job model = 'wave_2d_elastic', output = 'run.h5' /
&surface period = 1, amplitude = 0.01 /
&solid contact_modulus = 1 /
&numerics cells = 4096 /
&sweep variable = 'mean_pressure', from = 1e-3, to = 5e-2, count = 16 /
"""


class Restart(Runs):
    def kill_and_resume(self, template, threads, seed, *options, n_kills=N_KILLS):
        """Kill a run again and again at random moments until it is complete; what is left tells the truth each time."""
        count = self.count_of_lasting(template, threads=threads)
        self.write(template.format(strips=16, count=count))
        start = time.monotonic()
        self.run_program("run", "--quiet", "run.nml", "--output", "whole.h5", threads=threads)
        duration = time.monotonic() - start
        moment = random.Random(seed)
        n_killed, n_resumed, most = 0, 0, 0
        name = "run.h5"
        while n_killed < n_kills:
            process = self.start("run", "--quiet", "--resume", "run.nml", *options, threads=threads)
            try:
                # every other time at any moment, otherwise when there is something to lose
                latest = 0.8 * duration
                if n_killed % 2 == 0:
                    self.wait_for_points(f"{name}.partial", process)
                    latest = 0.3 * duration
                _, errors = process.communicate(timeout=moment.uniform(0.0, latest))
                # complete: once more from the beginning
                self.assertIn(process.returncode, IN_ORDER, errors)
                self.assert_same(self.snapshot("whole.h5"), self.snapshot(name))
                (self.folder / name).unlink()
                most = 0
                continue
            except subprocess.TimeoutExpired:
                process.send_signal(signal.SIGKILL)
                process.communicate()
                n_killed += 1
            if (self.folder / f"{name}.partial").exists():
                n_done = self.check_truth(f"{name}.partial", "whole.h5")
                self.assertGreaterEqual(n_done, most, "results of a former run are lost")
                most = n_done
                n_resumed += n_done > 0
            elif (self.folder / name).exists():
                self.assert_same(self.snapshot("whole.h5"), self.snapshot(name))
                (self.folder / name).unlink()
                most = 0
        self.run_program("run", "--quiet", "--resume", "run.nml", *options, threads=threads)
        self.assert_same(self.snapshot("whole.h5"), self.snapshot(name))
        self.assertFalse([other for other in self.names() if other not in ("run.nml", "whole.h5", name)])
        return n_resumed

    def test_kill_one_thread(self):
        n_resumed = self.kill_and_resume(LOADS, 1, 1)
        self.assertGreater(n_resumed, 0, "no kill met a run with results on the disk")

    def test_kill_two_threads(self):
        n_resumed = self.kill_and_resume(LOADS, 2, 2)
        self.assertGreater(n_resumed, 0, "no kill met a run with results on the disk")

    def test_kill_profiles(self):
        n_resumed = self.kill_and_resume(PROFILES, 2, 3)
        self.assertGreater(n_resumed, 0, "no kill met a run with results on the disk")

    def check_signal(self, number, name):
        count = self.count_of_lasting(PROFILES)
        self.write(PROFILES.format(strips=16, count=count))
        self.run_program("run", "--quiet", "run.nml", "--output", "whole.h5")
        process = self.start("run", "--quiet", "run.nml", threads=1)
        self.wait_for_points("run.h5.partial")
        process.send_signal(number)
        output, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 128 + number, errors)
        self.assertEqual(output, "")
        self.assertRegex(errors, rf"^run.nml: stopped by {name}, \d+ of {3*count} points are in run.h5.partial; "
                                 r"adfric run --resume run.nml goes on\n$")
        n_done = self.check_truth("run.h5.partial", "whole.h5")
        self.assertEqual(int(errors.split()[4]), n_done)
        self.assertGreater(n_done, 0)
        self.assertLess(n_done, 3 * count)
        self.assertEqual(self.names(), ["run.h5.partial", "run.nml", "whole.h5"])
        self.run_program("run", "--resume", "run.nml", threads=1)
        self.assert_same(self.snapshot("whole.h5"), self.snapshot("run.h5"))
        self.assertEqual(self.names(), ["run.h5", "run.nml", "whole.h5"])

    def test_sigterm(self):
        self.check_signal(signal.SIGTERM, "SIGTERM")

    def test_sigint(self):
        self.check_signal(signal.SIGINT, "SIGINT")

    def test_two_signals(self):
        # a batch system tells the script and the program, and the script tells the program, too: that is one request
        process = self.stopped_twice(LOADS.format(strips=16, count=8000), 0.002)
        _, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 143, errors)
        self.assertIn("stopped by SIGTERM", errors)
        (self.folder / "run.h5.partial").unlink()
        # a block that takes long, of a solver that does not ask
        process = self.stopped_twice(LOADS.format(strips=65536, count=8000), 1.1)
        _, errors = process.communicate(timeout=60)
        self.assertEqual((process.returncode, errors), (-signal.SIGTERM, ""))

    def test_long_point(self):
        # a signal ends a point that takes long; what it has found is of no use
        self.write(SLOW)
        process = self.start("run", "--quiet", "run.nml", threads=1)
        self.wait_for("run.h5.partial")
        process.send_signal(signal.SIGTERM)
        _, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 143)
        self.assertEqual(errors, "run.nml: stopped by SIGTERM, 0 of 16 points are in run.h5.partial; "
                                 "adfric run --resume run.nml goes on\n")
        self.assertTrue((self.status_of("run.h5.partial") < 0).all())

    def stopped_twice(self, text, interval):
        """A run that was asked to end twice."""
        self.write(text)
        process = self.start("run", "--quiet", "run.nml", threads=1)
        self.wait_for("run.h5.partial")
        process.send_signal(signal.SIGTERM)
        time.sleep(interval)
        process.send_signal(signal.SIGTERM)
        return process

    def stopped_run(self):
        """A run that was stopped in order, with some points done; its count."""
        count = self.count_of_lasting(LOADS)
        self.write(LOADS.format(strips=16, count=count))
        process = self.start("run", "--quiet", "run.nml", threads=1)
        self.wait_for_points("run.h5.partial")
        process.send_signal(signal.SIGTERM)
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, 143)
        return count

    def test_nothing_is_overwritten(self):
        count = self.stopped_run()
        partial = (self.folder / "run.h5.partial").read_bytes()
        _, errors = self.run_program("run", "run.nml", status=3)
        self.assertEqual(errors, "run.h5: run.h5.partial has results of a run that was stopped; --resume goes on with it, "
                                 "--force discards it\n")
        # other inputs, and not such that have the same results
        for text, difference in [
                (LOADS.format(strips=16, count=count + 1), "made from another input"),
                (LOADS.format(strips=15, count=count), "made from another input"),
                (LOADS.format(strips=16, count=count).replace("2e3", "2.000000000001e3"), "made from another input"),
                ("&job model = 'hertz', output = 'run.h5' /\n&contact kind = 'circular', radius = 1 /\n"
                 "&solid contact_modulus = 1e9 /\n&sweep variable = 'load', values = 1, 2 /\n", "another input"),
        ]:
            self.write(text)
            with self.subTest(text=text):
                _, errors = self.run_program("run", "--resume", "run.nml", status=3)
                self.assertRegex(errors, f"^run.h5.partial: does not belong to this run: .*{difference}")
                self.assertEqual((self.folder / "run.h5.partial").read_bytes(), partial)
        self.write(LOADS.format(strips=16, count=count).replace("'loads'", "'a new title'") + "! and a comment\n")
        self.run_program("run", "--resume", "run.nml")
        self.run_program("run", "run.nml", "--output", "whole.h5")
        run, whole = self.snapshot("run.h5"), self.snapshot("whole.h5")
        del run["/"], whole["/"]
        self.assert_same(run, whole)

    def test_partial_file_that_is_none(self):
        self.write(LOADS.format(strips=16, count=20))
        for content in (b"", b"no HDF5 file", bytes(5000)):
            (self.folder / "run.h5.partial").write_bytes(content)
            _, errors = self.run_program("run", "--resume", "run.nml", status=3)
            self.assertIn("run.h5.partial: cannot read", errors)
            self.assertEqual((self.folder / "run.h5.partial").read_bytes(), content)
        self.run_program("run", "--force", "run.nml")
        self.assertEqual(self.names(), ["run.h5", "run.nml"])

    def test_resume_of_a_finished_run(self):
        self.write(LOADS.format(strips=16, count=50))
        first, _ = self.run_program("run", "--resume", "run.nml")
        before = (self.folder / "run.h5").read_bytes()
        again, _ = self.run_program("run", "--resume", "run.nml")
        self.assertEqual((self.folder / "run.h5").read_bytes(), before)
        # the table says the same
        self.assertEqual(again.splitlines()[-1], "this run was complete already")
        self.assertEqual(again.splitlines()[:-1], first.splitlines())
        self.write(LOADS.format(strips=16, count=51))
        _, errors = self.run_program("run", "--resume", "run.nml", status=3)
        self.assertIn("does not belong to this run", errors)
        self.assertEqual((self.folder / "run.h5").read_bytes(), before)

    def test_killed_between_two_names(self):
        self.write(LOADS.format(strips=16, count=20))
        self.run_program("run", "run.nml")
        os.link(self.folder / "run.h5", self.folder / "run.h5.partial")
        output, _ = self.run_program("run", "--resume", "run.nml")
        self.assertIn("complete already", output)
        self.assertEqual(self.names(), ["run.h5", "run.nml"])

    def test_table_after_a_restart(self):
        self.stopped_run()
        resumed, _ = self.run_program("run", "--resume", "run.nml")
        whole, _ = self.run_program("run", "--force", "run.nml")
        self.assertEqual(resumed.splitlines()[:-2], whole.splitlines()[:-2])

    def test_two_runs_at_once(self):
        self.write(LOADS.format(strips=16, count=6 * self.count_of_lasting(LOADS)))
        process = self.start("run", "--quiet", "run.nml")
        self.wait_for("run.h5.partial")
        for options in ([], ["--resume"], ["--force"], ["--resume", "--force"]):
            with self.subTest(options=options):
                _, errors = self.run_program("run", *options, "run.nml", status=3)
                self.assertIn("another run is writing this file", errors)
        process.send_signal(signal.SIGKILL)
        process.communicate()
        # the lock of a dead process holds nobody up
        process = self.start("run", "--quiet", "--resume", "run.nml")
        time.sleep(0.1)
        process.send_signal(signal.SIGTERM)
        _, errors = process.communicate(timeout=60)
        self.assertNotEqual(process.returncode, 3, errors)

    def test_many_starts_at_once(self):
        self.write(LOADS.format(strips=16, count=200))
        processes = [self.start("run", "--quiet", "--resume", "run.nml", threads=1) for _ in range(6)]
        ends = []
        for process in processes:
            _, errors = process.communicate(timeout=120)
            ends.append((process.returncode, errors))
        self.assertTrue(all(status in (*IN_ORDER, 3) for status, _ in ends), ends)
        self.assertTrue(any(status in IN_ORDER for status, _ in ends), ends)
        self.assertTrue(all("another run" in errors or "exists" in errors for status, errors in ends if status == 3), ends)
        self.run_program("run", "run.nml", "--output", "whole.h5")
        self.assert_same(self.snapshot("whole.h5"), self.snapshot("run.h5"))

    def test_threads(self):
        self.write(PROFILES.format(strips=16, count=200))
        for threads in (1, 2, 3):
            self.run_program("run", "run.nml", "--output", f"{threads}.h5", threads=threads)
        self.assert_same(self.snapshot("1.h5"), self.snapshot("2.h5"))
        self.assert_same(self.snapshot("1.h5"), self.snapshot("3.h5"))

    def test_file_size_limit(self):
        self.write(LOADS.format(strips=16, count=1200))
        _, errors = self.run_program("run", "run.nml", status=3, preexec_fn=limit_file_size(100_000))
        self.assertRegex(errors, "^run.h5: cannot create: File too large")
        self.assertEqual(self.names(), ["run.nml"])
        self.stopped_run()
        n_done = (self.status_of("run.h5.partial") >= 0).sum()
        limit = limit_file_size((self.folder / "run.h5.partial").stat().st_size // 4)
        _, errors = self.run_program("run", "--resume", "run.nml", status=3, preexec_fn=limit)
        self.assertRegex(errors, "^run.h5: cannot .*: File too large; the results so far stay in run.h5.partial, "
                                 "--resume goes on with them\n$")
        self.assertGreaterEqual((self.status_of("run.h5.partial") >= 0).sum(), n_done)
        self.run_program("run", "--resume", "run.nml")
        self.run_program("run", "run.nml", "--output", "whole.h5")
        self.assert_same(self.snapshot("whole.h5"), self.snapshot("run.h5"))


if __name__ == "__main__":
    unittest.main()
