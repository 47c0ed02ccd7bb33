# SPDX-License-Identifier: GPL-3.0-or-later
"""Machines that have too little: memory, threads, stacks, files. A run ends with its results, or in one line, status 2 or 3 and
nothing left behind."""

import os
import resource
import struct
import subprocess
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from runs import IN_ORDER, LOADS, PROFILES, PROGRAM, Runs  # noqa: E402

SPHERE = """
&job model = 'sphere', output = 'run.h5' /
&sphere units = 'reduced', lambda = 0.8 /
&sweep variable = 'load', from = -1, to = 10, count = 3000 /
"""
CHECKED = """
&job model = 'hertz', output = 'run.h5' /
&contact kind = 'circular', radius = 1 /
&solid contact_modulus = 1e9 /
&sweep variable = 'load', from = 1, to = 2, count = 5 /
"""
KILOBYTE = 1024
# exit status of the loader of programs, which comes before ours: libraries have no room
NOT_LOADED = 127
# the sanitizers take terabytes of addresses, and more of a stack
IS_SANITIZED = b"__asan_init" in Path(PROGRAM).read_bytes()
# the system ends a program whose own segments have no room before its first instruction; beyond them the loader needs this much
ROOM_OF_LOADER = 1_000
# somebody who has no processes
NOBODY = 54321


def limits(**values):
    """For a process that is about to start: its limits, as resource names them."""
    def limit():
        for name, value in values.items():
            resource.setrlimit(getattr(resource, f"RLIMIT_{name.upper()}"), (value, value))
    return limit


def size_of_segments():
    """Addresses that the program takes when it is loaded, in bytes: the span of its loaded segments (ELF of 64 bits)."""
    program = Path(PROGRAM).read_bytes()
    start, = struct.unpack_from("<Q", program, 32)
    size, count = struct.unpack_from("<HH", program, 54)
    loaded = 1
    spans = []
    for i in range(count):
        kind, _, _, first, _, _, length, _ = struct.unpack_from("<IIQQQQQQ", program, start + i*size)
        if kind == loaded:
            spans.append((first, first + length))
    return max(end for _, end in spans) - min(begin for begin, _ in spans)


class Starved(Runs):
    def try_run(self, whole, environment=(), preexec_fn=None, command=("run", "--quiet", "run.nml")):
        """A run that may lack something; its exit status."""
        process = subprocess.run([PROGRAM, *command], cwd=self.folder, env=dict(os.environ, **dict(environment)),
                                 capture_output=True, text=True, preexec_fn=preexec_fn, timeout=120)
        status, errors = process.returncode, process.stderr
        self.errors = errors
        self.assertEqual(process.stdout, "")
        if status in IN_ORDER:
            self.assertEqual(errors, "")
            self.assert_same(whole, self.snapshot("run.h5"))
            (self.folder / "run.h5").unlink()
        else:
            self.assertIn(status, (2, 3, NOT_LOADED), errors)
            self.assertEqual(errors.count("\n"), 1, errors)
            self.assertTrue(errors.endswith("\n"))
        self.assertEqual(self.names(), ["run.nml", "whole.h5"], errors)
        return status

    def begin(self, text):
        self.write(text)
        self.run_program("run", "--quiet", "--force", "run.nml", "--output", "whole.h5")
        return self.snapshot("whole.h5")

    @unittest.skipIf(IS_SANITIZED, "the sanitizers take all addresses")
    def test_memory(self):
        for text in (LOADS.format(strips=16, count=60), PROFILES.format(strips=16, count=20), SPHERE):
            whole = self.begin(text)
            met = set()
            for kilobytes in [*range(max(10_000, size_of_segments()//KILOBYTE + ROOM_OF_LOADER), 130_000, 1_700),
                              *range(130_000, 1_000_001, 145_000)]:
                with self.subTest(kilobytes=kilobytes, text=text):
                    met.add(self.try_run(whole, {"OMP_NUM_THREADS": "3"}, limits(**{"as": kilobytes*KILOBYTE})))
            self.assertLessEqual({0, 3}, {status if status != 1 else 0 for status in met})

    def test_stack_of_threads(self):
        whole = self.begin(SPHERE)
        for size, expected in [("16k", 3), ("32k", 3), ("65536B", 3), ("100", 3), ("255k", 3), ("1M", 0), ("4096", 0)]:
            with self.subTest(size=size):
                self.assertEqual(self.try_run(whole, {"OMP_STACKSIZE": size, "OMP_NUM_THREADS": "2"}), expected)

    def test_stack(self):
        whole = self.begin(SPHERE)
        for kilobytes, expected in [(128, 3), (512, 3), (1000, 3), (8192, 0)]:
            with self.subTest(kilobytes=kilobytes):
                self.assertEqual(self.try_run(whole, (), limits(stack=kilobytes*KILOBYTE)), expected)

    @unittest.skipIf(IS_SANITIZED, "a sanitizer keeps an account of each thread")
    def test_very_many_threads(self):
        whole = self.begin(CHECKED)
        # more than all processes of any machine may have
        self.assertIn(self.try_run(whole, {"OMP_NUM_THREADS": "10000000"}), (2, 3))
        # one more than all of this one may have: none is tried, which would keep others from starting theirs
        most = min(int(Path(f"/proc/sys/kernel/{name}").read_text()) for name in ("pid_max", "threads-max"))
        self.assertEqual(self.try_run(whole, {"OMP_NUM_THREADS": str(most + 1)}), 3)
        self.assertEqual(self.errors, f"run.nml: cannot start {most + 1} threads, the system has no more than {most} for all; "
                                      "OMP_NUM_THREADS sets how many there are\n")
        # 8 MB each
        self.assertIn(self.try_run(whole, {"OMP_NUM_THREADS": "1000", "OMP_STACKSIZE": "8M"},
                                   limits(**{"as": 2_000_000*KILOBYTE})), (2, 3))

    @unittest.skipIf(IS_SANITIZED, "a sanitizer looks for leaks in a thread of its own, which the limit refuses")
    def test_limit_of_processes(self):
        if os.geteuid() != 0:
            self.skipTest("needs root, to be somebody else who has no processes")
        whole = self.begin(CHECKED)
        self.folder.chmod(0o777)

        def be_nobody(n):
            def become():
                resource.setrlimit(resource.RLIMIT_NPROC, (n, n))
                os.setgroups([])
                os.setgid(NOBODY)
                os.setuid(NOBODY)
            return become

        try:
            subprocess.run([PROGRAM, "--version"], preexec_fn=be_nobody(100), check=True, capture_output=True)
        except (OSError, subprocess.CalledProcessError):
            self.skipTest("others may not run the program")
        for n, expected in [(1, 3), (2, 3), (4, 3), (100, 0)]:
            with self.subTest(n=n):
                self.assertEqual(self.try_run(whole, {"OMP_NUM_THREADS": "4"}, be_nobody(n)), expected)

    def test_limit_of_open_files(self):
        whole = self.begin(CHECKED)
        for n in range(4, 12):
            with self.subTest(n=n):
                self.write(CHECKED)
                process = subprocess.run([PROGRAM, "run", "--quiet", "run.nml"], cwd=self.folder, capture_output=True, text=True,
                                         preexec_fn=limits(nofile=n))
                if process.returncode != 0:
                    self.assertEqual(process.returncode, 3)
                    self.assertRegex(process.stderr, "^[^\n]*: Too many open files\n$")
                    self.assertEqual(self.names(), ["run.nml", "whole.h5"])
                else:
                    self.assert_same(whole, self.snapshot("run.h5"))
                    (self.folder / "run.h5").unlink()

    @unittest.skipIf(IS_SANITIZED, "the sanitizers take all addresses")
    def test_results_before_stay(self):
        """A run that goes on and gets no memory says that what there is stays."""
        self.write(LOADS.format(strips=16, count=self.count_of_lasting(LOADS)))
        process = self.start("run", "--quiet", "run.nml", threads=1)
        self.wait_for_points("run.h5.partial")
        process.kill()
        process.communicate()
        before = self.status_of("run.h5.partial")
        met = 0
        for kilobytes in range(60_000, 110_000, 1_500):
            process = subprocess.run([PROGRAM, "run", "--quiet", "--resume", "run.nml"], cwd=self.folder, text=True,
                                     capture_output=True, preexec_fn=limits(**{"as": kilobytes*KILOBYTE}))
            if process.returncode in IN_ORDER:
                break
            self.assertIn(process.returncode, (2, 3, NOT_LOADED), process.stderr)
            self.assertEqual(process.stderr.count("\n"), 1, process.stderr)
            if "stay in" in process.stderr:
                met += 1
                self.assertRegex(process.stderr, "; the results so far stay in run.h5.partial, --resume goes on with them\n$")
            self.assertGreaterEqual((self.status_of("run.h5.partial") >= 0).sum(), (before >= 0).sum())
        self.run_program("run", "--quiet", "--resume", "run.nml")
        self.run_program("run", "--quiet", "run.nml", "--output", "whole.h5")
        self.assert_same(self.snapshot("whole.h5"), self.snapshot("run.h5"))


if __name__ == "__main__":
    unittest.main()
