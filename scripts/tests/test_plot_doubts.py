# SPDX-License-Identifier: GPL-3.0-or-later
"""Points beyond a bound of their theory, in figures."""

import unittest

import h5py
import numpy as np
from plot_files import PlotCase, make_file

from plotting import command, doubts
from plotting.results import Results

MEANINGS = "no_value none contact_too_wide slope_too_steep"


def add_doubts(path, values):
    """Add the doubt to a file that has none."""
    with h5py.File(path, "r+") as file:
        file["doubt"] = np.asarray(values, dtype="i1")
        file["doubt"].attrs.update(flag_meanings=MEANINGS, flag_values=np.arange(-1, 3, dtype="i1"), units="1")
        for source, target in zip(file["status"].dims, file["doubt"].dims):
            target.attach_scale(file[source[0].name])


class PlotDoubts(PlotCase):
    def make(self, axes, values=None, **rest):
        """Results of a made-up run."""
        path = self.folder / "run.h5"
        make_file(path, axes, **rest)
        if values is not None:
            add_doubts(path, values)
        return Results(path)

    def figure_of(self, results, **choice):
        """The figure as the command draws it, and the text below it."""
        figure = command.make_figure([results], **choice)
        below = figure._supxlabel
        return figure, below.get_text() if below else ""

    def hatches(self, panel):
        """Extent along x of each hatched band."""
        patches = [patch for patch in panel.patches if patch.get_hatch()]
        return [(patch.get_x(), patch.get_x() + patch.get_width()) for patch in patches]

    def test_old_file(self):
        results = self.make([("load", [0, 1, 2, 3])])
        figure, below = self.figure_of(results)
        self.assertIsNone(doubts.is_doubted(results))
        self.assertEqual(below, "")
        self.assertEqual(self.hatches(figure.axes[0]), [])

    def test_no_doubt(self):
        figure, below = self.figure_of(self.make([("load", [0, 1, 2, 3])], [0, 0, 0, -1]))
        self.assertEqual(below, "")
        self.assertEqual(self.hatches(figure.axes[0]), [])

    def test_hatched(self):
        figure, below = self.figure_of(self.make([("load", [0, 1, 2, 3, 4])], [1, 0, 1, 2, -1]))
        self.assertEqual(below, "Beyond a bound of the theory: contact too wide at 2, slope too steep at 1 of 5 points")
        for panel in figure.axes:
            self.assertEqual(self.hatches(panel), [(0.0, 0.5), (1.5, 3.5)])

    def test_shaded(self):
        # the first curve is doubted from 1 on, the second from 2 on
        results = self.make([("stress", [1, 2]), ("load", [0, 1, 2, 3])], [[0, 1, 1, 1], [0, 0, 1, 1]])
        figure, _ = self.figure_of(results)
        panel = figure.axes[0]
        self.assertEqual(self.hatches(panel), [(1.5, 3.0)])
        shades = [line for line in panel.lines if line.get_color() == doubts.SHADOW["color"]]
        self.assertEqual(len(shades), 1)
        self.assertEqual(np.flatnonzero(np.isfinite(shades[0].get_ydata())).tolist(), [1])

    def test_logarithmic(self):
        figure, _ = self.figure_of(self.make([("load", np.logspace(0, 3, 4))], [0, 0, 1, 1]))
        (first, last), = self.hatches(figure.axes[0])
        self.assertAlmostEqual(first, np.sqrt(1000.0))
        self.assertAlmostEqual(last, 1000.0)

    def test_chosen(self):
        figure, below = self.figure_of(self.make([("load", [0, 1, 2, 3])], [0, 1, 1, 0]), y=["contact_width"])
        shades = [line for line in figure.axes[0].lines if line.get_color() == doubts.SHADOW["color"]]
        self.assertEqual(np.flatnonzero(np.isfinite(shades[0].get_ydata())).tolist(), [1, 2])
        self.assertTrue(below.startswith("Beyond a bound"))

    def test_profiles(self):
        results = self.make([("load", [0, 1])], [1, -1], profile_axes=[("x", np.linspace(0, 1, 5))])
        _, below = self.figure_of(results)
        self.assertEqual(below, "Beyond a bound of the theory: contact too wide at 1 of 2 points")


if __name__ == "__main__":
    unittest.main()
