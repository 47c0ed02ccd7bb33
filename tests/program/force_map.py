# SPDX-License-Identifier: GPL-3.0-or-later
"""The tutorial docs/guide/force_map.md: its commands print what stands there, and find what the curves were made of."""

from environments import SOURCE, restart_in

restart_in(".venv_curve", "afmformats")

import subprocess  # noqa: E402
import unittest  # noqa: E402

import h5py  # noqa: E402
import numpy as np  # noqa: E402

from curve_imports import Curves  # noqa: E402
from runs import main  # noqa: E402

import make_force_map  # noqa: E402
from make_options.force_map import read_command_line  # noqa: E402

PLAIN = SOURCE / ".venv/bin/python"


class ForceMap(Curves):
    def test_truth(self):
        """Modulus and work of adhesion of each place are within their errors of those that the curves were made of."""
        modulus, work = make_force_map.write_map(read_command_line(["force_map.zip", "--curves", "8", "6", "--seed", "4"]))
        _, errors = self.call("force_map.zip", "--no-picture")
        self.assertEqual(errors.count("\n"), 2, errors)
        self.run_program("fit", SOURCE / "inputs/force_map.nml")
        with h5py.File("force_map_fit.h5") as file:
            status = file["status"][()]
            self.assertEqual(np.count_nonzero(status), 2)
            for name, truth in (("contact_modulus", modulus), ("work_of_adhesion", work)):
                score = ((file[name][()] - truth) / file[f"{name}_error"][()])[status == 0]
                # of 46 normal numbers the median is this small, and their spread this near to 1, but once in 10000 times
                self.assertLess(abs(np.median(score)), 4 * 1.25 / np.sqrt(score.size))
                self.assertAlmostEqual(np.median(np.abs(score)) / 0.6745, 1, delta=4 * 1.17 / np.sqrt(score.size))
                np.testing.assert_allclose(file[name][()][status == 0], truth[status == 0], rtol=0.05)

    def test_seed(self):
        """The same seed makes the same file, another seed another one."""
        for name, seed in (("a.zip", 1), ("b.zip", 1), ("c.zip", 2)):
            make_force_map.write_map(read_command_line([name, "--curves", "2", "2", "--seed", str(seed)]))
        first, again, other = ((self.folder / name).read_bytes() for name in ("a.zip", "b.zip", "c.zip"))
        self.assertEqual(first, again)
        self.assertNotEqual(first, other)

    @unittest.skipUnless(PLAIN.exists(), "scripts/setup python could not make .venv")
    def test_page(self):
        """The page shows what its commands print."""
        done = subprocess.run([PLAIN, SOURCE / "scripts/force_map_page.py"], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)


if __name__ == "__main__":
    main()
