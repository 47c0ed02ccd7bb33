# SPDX-License-Identifier: GPL-3.0-or-later
"""Ctrl-C, and what the caller's function raises, end a call; threads solve at once."""

import os
import signal
import threading
import unittest

import numpy as np
import xarray as xr
from cases import TIP

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


if __name__ == "__main__":
    unittest.main()
