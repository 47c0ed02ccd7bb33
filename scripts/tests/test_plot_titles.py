# SPDX-License-Identifier: GPL-3.0-or-later
"""Titles that fit into their figures, and profiles that the user has chosen."""

import unittest

import h5py
import numpy as np

from plot_files import PlotCase, make_file

from plotting.command import make_figure
from plotting.results import Results
from plotting.titles import words_of

LONG = "Friction of a rubber block on a rough road, with a title that says what nobody would say (velocity, load), 3 MPa"


class PlotTitlesTest(PlotCase):
    def test_long_title(self):
        """A title wider than the figure is broken between words; a short one stays as it is."""
        make_file(self.file, [("load", [0.0, 1.0, 2.0])])
        for title, n_lines in (("A title", 1), (LONG, 2)):
            with h5py.File(self.file, "r+") as file:
                file.attrs["title"] = title
            figure = make_figure([Results(self.file)], y=["friction_force"])
            shown = figure.get_suptitle()
            self.assertEqual(shown.replace("\n", " "), title)
            self.assertGreaterEqual(shown.count("\n") + 1, n_lines)
            self.assertEqual("\n" in shown, n_lines > 1)
            figure.draw_without_rendering()
            extent = next(text for text in figure.texts if text.get_text() == shown).get_window_extent()
            self.assertTrue(extent.x0 >= 0 and extent.x1 <= figure.bbox.width)

    def test_titles_of_panels(self):
        """Titles of panels side by side do not run into each other."""
        stress, load = ("stress", [1.23456e3, 5.4321e3]), ("load", [0.123456, 1.23456])
        radius = ("radius", [1.23456])
        make_file(self.file, [radius, stress, load], [("x", [-1.0, 0.0, 1.0])])
        figure = make_figure([Results(self.file)])
        figure.draw_without_rendering()
        extents = [panel.title.get_window_extent() for panel in figure.axes if panel.get_title()]
        self.assertEqual(len(extents), 4)
        for place, extent in enumerate(extents):
            self.assertFalse(any(extent.overlaps(other) for other in extents[:place]))
            self.assertTrue(extent.x0 >= 0 and extent.x1 <= figure.bbox.width)

    def test_words(self):
        """A formula and a value with its sign of equality are not broken."""
        self.assertEqual(words_of(r"$\mu$ = 0.3 at $p_0 = 2$ kPa"), [r"$\mu$ = 0.3", "at", "$p_0 = 2$", "kPa"])

    def test_chosen_profiles(self):
        """Profiles along the surface, or one against another, a curve for each point."""
        make_file(self.file, [("load", [0.0, 1.0, 2.0])], [("x", [-1.0, 0.0, 1.0])])
        results = Results(self.file)
        for options, x in (({"y": ["pressure", "gap"]}, results.profile_axes[0].values), ({"x": "gap", "y": ["pressure"]}, None)):
            figure = make_figure([results], **options)
            self.assertEqual(len(figure.axes), len(options["y"]))
            for panel, name in zip(figure.axes, options["y"]):
                curves = [line for line in panel.lines if len(line.get_xdata()) == 3]
                self.assertEqual(len(curves), 3)
                for k, curve in enumerate(curves):
                    np.testing.assert_array_equal(curve.get_ydata(), results.profiles[name].values[k])
                    np.testing.assert_array_equal(curve.get_xdata(), results.profiles["gap"].values[k] if x is None else x)
        self.assertEqual(self.plot("--x", "gap", "--y", "pressure"), (0, ""))

    def test_profiles_that_are_not_there(self):
        make_file(self.file, [("load", [0.0, 1.0, 2.0])], [("x", [-1.0, 0.0, 1.0])])
        self.assert_refused("no profile of this name, given pressures; did you mean pressure?", "--x", "gap", "--y", "pressures")
        self.assert_refused("profiles are drawn of one file, with --y", "--x", "gap")
        make_file(self.file, [("load", [0.0, 1.0])], [("y", [-1.0, 0.0, 1.0]), ("x", [-1.0, 0.0, 1.0])])
        self.assert_refused("--cut draws them along lines", "--y", "pressure", expected=3)


if __name__ == "__main__":
    unittest.main()
