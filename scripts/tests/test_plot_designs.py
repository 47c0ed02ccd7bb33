# SPDX-License-Identifier: GPL-3.0-or-later
"""The plot script on samples, on variables that change together, and on results with errors."""

import unittest

import h5py
import numpy as np

from plot_files import PlotCase, make_file

from plotting import figures
from plotting.results import Results


class Designs(PlotCase):
    def add_companions(self, axis, **values):
        """Variables that change along an axis."""
        with h5py.File(self.file, "r+") as file:
            for name, numbers in values.items():
                file[name] = np.asarray(numbers, dtype=float)
                file[name].dims[0].attach_scale(file[axis])
                file[name].attrs["units"] = "m"
            file["status"].attrs["coordinates"] = " ".join(values)

    def test_sample(self):
        """A panel for each variable, with all points and a bar of colours each; the variables are no results."""
        make_file(self.file, [("load", [1.0, 2.0]), ("sample", [1.0, 2.0, 3.0, 4.0])])
        self.add_companions("sample", radius=[1.0, 10.0, 100.0, 30.0], height=[3.0, 1.0, 2.0, 4.0])
        results = Results(self.file)
        self.assertEqual({name: axis for name, (_, axis) in results.companions.items()}, {"radius": "sample", "height": "sample"})
        self.assertNotIn("radius", results.fields)
        self.assertEqual(results.constants, {})
        figure = figures.choose_figure(results)(results)
        panels = [axes for axes in figure.axes if axes.get_ylabel().startswith("Friction force")]
        self.assertEqual([axes.get_xscale() for axes in panels], ["log", "linear"])
        self.assertEqual([len(axes.collections) for axes in panels], [2, 2])
        self.assertEqual(len(figure.axes), 4)
        self.assertEqual(self.plot(), (0, ""))

    def test_band(self):
        """A result with an error has a band; what is said beside results is not drawn unless it is asked for."""
        make_file(self.file, [("load", [0.0, 1.0, 2.0])])
        with h5py.File(self.file, "r+") as file:
            for name, meaning in (("friction_force_error", "standard error of friction_force"),
                                  ("friction_force_by_load", "derivative of friction_force by load")):
                file[name] = [0.1, 0.2, 0.3]
                file[name].dims[0].attach_scale(file["load"])
                file[name].attrs.update(units="1", long_name=meaning)
        results = Results(self.file)
        self.assertEqual(results.errors, {"friction_force": "friction_force_error"})
        self.assertNotIn("friction_force_by_load", figures.choose_results(results))
        figure = figures.draw_sweep(results)
        bands = {axes.get_ylabel().split(" (")[0]: len(axes.collections) for axes in figure.axes}
        self.assertEqual([n for label, n in bands.items() if label.startswith("Friction force")], [1])
        self.assertEqual(sum(bands.values()), 1)
        self.assertEqual(self.plot("--y", "friction_force_by_load"), (0, ""))


if __name__ == "__main__":
    unittest.main()
