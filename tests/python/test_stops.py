# SPDX-License-Identifier: GPL-3.0-or-later
"""Ctrl-C, and what the caller's function raises, end a call; threads solve at once, and sleep where they wait."""

import os
import signal
import subprocess
import sys
import time
import threading
import unittest

import numpy as np
import xarray as xr
from cases import SURFACE, TIP

import adfric


class Stops(unittest.TestCase):
    """A case of many points."""

    def setUp(self):
        self.case = adfric.Case("sphere")
        self.addCleanup(self.case.close)
        self.case.set(**TIP, load=np.linspace(0, 1e-7, 5000))

    def test_progress(self):
        told = []
        self.case.solve(progress=lambda n_done, n_points: told.append((n_done, n_points)))
        self.assertEqual((5000, 5000), told[-1])
        self.assertEqual(sorted(told), told)

    def test_raised(self):
        def fail(*_):
            raise ZeroDivisionError("mine")

        before = self.case.solve()
        with self.assertRaisesRegex(ZeroDivisionError, "mine"):
            self.case.solve(progress=fail)
        xr.testing.assert_equal(before, self.case.solve())

    def test_calls_meanwhile(self):
        """What is told may call again, with cases of its own."""
        def ask(*_):
            asked.append(adfric.solve("sphere", **TIP, load=0.0).status.item())

        asked = []
        before = self.case.solve()
        xr.testing.assert_equal(before, self.case.solve(progress=ask))
        self.assertEqual({0}, set(asked))

    def test_interrupt(self):
        """The interrupt comes while the library solves; Python's handler is what it was before."""
        before = signal.getsignal(signal.SIGINT)
        with self.assertRaises(KeyboardInterrupt):
            self.case.solve(progress=lambda *_: os.kill(os.getpid(), signal.SIGINT))
        self.assertIs(before, signal.getsignal(signal.SIGINT))
        self.assertEqual(5000, self.case.solve().sizes["load"])

    def test_handler(self):
        """A handler of the user's that raises nothing ends nothing."""
        heard = []
        before = signal.signal(signal.SIGINT, lambda *_: heard.append(True))
        self.addCleanup(signal.signal, signal.SIGINT, before)
        found = self.case.solve(progress=lambda *_: os.kill(os.getpid(), signal.SIGINT))
        self.assertEqual(5000, found.sizes["load"])
        self.assertTrue(heard)

    def check_interrupted(self, call):
        """A call is interrupted a tenth of a second after it has begun, long before its end."""
        timer = threading.Timer(0.1, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            call()
        timer.join()

    def test_long_point(self):
        """A single point looks up from its iterations: a map of a million cells."""
        heights = np.random.default_rng(1).random((1024, 1024))*1e-6
        rough = {**SURFACE, "heights": heights}
        self.check_interrupted(lambda: adfric.solve("surface_elastic", **rough, mean_pressure=1e6, relative_tolerance=1e-12))

    def test_long_points(self):
        """So do points behind one another in a block."""
        heights = np.random.default_rng(1).random((256, 256))*1e-6
        rough = {**SURFACE, "heights": heights}
        pressures = np.linspace(1e6, 2e6, 1000)
        self.check_interrupted(lambda: adfric.solve("surface_elastic", **rough, mean_pressure=pressures, threads=2))

    def test_other_thread(self):
        """Blocks that other threads solve are stopped by the thread that calls, which has none of them."""
        heights = np.random.default_rng(1).random((512, 512))*1e-6
        rough = {**SURFACE, "heights": heights}
        started = time.monotonic()
        self.check_interrupted(lambda: adfric.solve("surface_elastic", **rough, mean_pressure=np.linspace(1e6, 2e6, 17), threads=3))
        self.assertLess(time.monotonic() - started, 60)

    def test_long_sweep(self):
        """Nor does a sweep whose results fill memory wait for its end."""
        self.check_interrupted(lambda: adfric.solve("sphere", **TIP, load=np.linspace(0, 1e-7, 1_000_000)))

    def test_threads(self):
        """Many threads, each with cases of its own, find what one finds."""
        expected = self.case.solve()
        found = []

        def solve():
            for _ in range(5):
                found.append(adfric.solve("sphere", **TIP, load=np.linspace(0, 1e-7, 5000), threads=1))

        workers = [threading.Thread(target=solve) for _ in range(6)]
        for worker in workers:
            worker.start()
        for worker in workers:
            worker.join()
        self.assertEqual(30, len(found))
        for one in found:
            xr.testing.assert_equal(expected, one)

    def test_waits(self):
        """Threads that wait sleep soon, unless the environment says how they wait; it is left as it was."""
        program = "import os, adfric; print([name for name in os.environ if name.startswith('GOMP')])"
        for policy, looks in ((None, "GOMP_SPINCOUNT = '10000'"), ("passive", "GOMP_SPINCOUNT = '0'")):
            environment = {**os.environ, "OMP_DISPLAY_ENV": "verbose"}
            for name in ("OMP_WAIT_POLICY", "GOMP_SPINCOUNT"):
                environment.pop(name, None)
            if policy:
                environment["OMP_WAIT_POLICY"] = policy
            told = subprocess.run([sys.executable, "-c", program], env=environment, capture_output=True, text=True, check=True)
            self.assertIn(looks, told.stderr)
            self.assertEqual("[]", told.stdout.strip())


if __name__ == "__main__":
    unittest.main()
