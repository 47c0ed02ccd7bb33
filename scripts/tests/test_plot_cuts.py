# SPDX-License-Identifier: GPL-3.0-or-later
"""Maps along lines: scripts/plot --cut."""

import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

import numpy as np  # noqa: E402
from plot_files import PlotCase, make_file  # noqa: E402
from plotting import cuts  # noqa: E402
from plotting.results import Results  # noqa: E402

LOADS = ("load", [0.0, 1.0, 2.0])
X, Y = ("x", [1e-6, 2e-6, 3e-6]), ("y", [1e-6, 2e-6, 3e-6])


class PlotCutsTest(PlotCase):
    def test_values(self):
        """A row, a column and the diagonal of the map of each point, against the place along the line."""
        make_file(self.file, [LOADS], [Y, X])
        results = Results(self.file)
        pressure = results.profiles["pressure"].values
        panels = cuts.draw_cuts(results, ["y=0", "x=2e-6", "y=x"]).axes
        self.assertEqual(len(panels), 6)
        for number in range(2):
            expected = (pressure[number][0], pressure[number][:, 1], np.diagonal(pressure[number]))
            for panel, values in zip(panels, expected):
                np.testing.assert_array_equal(panel.lines[number].get_ydata(), values)
        ratio = panels[2].lines[0].get_xdata() / panels[0].lines[0].get_xdata()
        np.testing.assert_allclose(ratio, np.sqrt(2.0), rtol=1e-15)
        self.assertEqual(panels[2].get_title(), "$y = x$")

    def test_figure(self):
        make_file(self.file, [LOADS], [Y, X])
        self.assertEqual(self.plot("--cut", "y=0", "y=x"), (0, ""))
        self.assertTrue(self.file.with_suffix(".png").exists())

    def test_refusals(self):
        """What is no line, what lies beyond the map, and what has no map."""
        make_file(self.file, [LOADS], [Y, X])
        self.assert_refused("--cut: not a line, given y=2x", "--cut", "y=2x")
        self.assert_refused("--cut y=1: beyond the map", "--cut", "y=1")
        self.assert_refused("--cut: not with several files, --x, --y or --data", "--cut", "y=0", "--y", "load")
        make_file(self.file, [LOADS], [("y", [1e-6, 2e-6]), X])
        self.assert_refused("the samples along x are not those along y", "--cut", "y=x")
        make_file(self.file, [LOADS], [X])
        self.assert_refused("no map of the pressure: nothing to cut", "--cut", "y=0", expected=3)


if __name__ == "__main__":
    unittest.main()
