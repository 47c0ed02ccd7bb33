# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of rough lines and of temperatures on small files made here."""

import unittest
import warnings

import h5py
import numpy as np

from plot_files import PlotCase, make_file

from plotting import figures, rubber
from plotting.results import Results

VELOCITY = ("velocity", [0.1, 1.0, 10.0])
TEMPERATURE = ("temperature", [273.15, 298.15, 323.15])
WLF = {"reference_temperature": 298.15, "wlf_c1": 4.57, "wlf_c2": 113.6}


class RubberTest(PlotCase):
    def add_constants(self, **values):
        """Numbers, and words for the kind, that have one value in the whole run."""
        with h5py.File(self.file, "r+") as file:
            for name, value in values.items():
                file[name] = value
            if "kind" in values:
                file["kind"].attrs["flag_values"] = np.arange(-1, 5, dtype="i1")
                file["kind"].attrs["flag_meanings"] = "no_value wave_2d wave_3d profile cosines map"
            file["status"].attrs["coordinates"] = " ".join(values)

    def add_field(self, name, values, unit):
        with h5py.File(self.file, "r+") as file:
            file[name] = np.broadcast_to(values, file["status"].shape)
            file[name].attrs["units"] = unit
            for dimension, scale in zip(file[name].dims, file["status"].dims):
                dimension.attach_scale(scale[0])

    def draw(self):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.assertEqual(self.plot(), (0, ""))

    def test_shift_factors(self):
        """1 at the reference; WLF by hand at 0 degrees Celsius; none without several temperatures."""
        make_file(self.file, [TEMPERATURE, VELOCITY])
        self.add_constants(**WLF)
        factors = rubber.shift_factors(Results(self.file))
        self.assertEqual(1, factors[1])
        self.assertAlmostEqual(4.57 * 25 / 88.6, np.log10(factors[0]), places=12)
        self.draw()
        make_file(self.file, [TEMPERATURE, VELOCITY])
        self.add_constants(reference_temperature=298.15, activation_energy=8.31446261815324e3)
        self.assertAlmostEqual(1e3 / 273.15 - 1e3 / 298.15, np.log(rubber.shift_factors(Results(self.file))[0]), places=12)
        self.draw()
        make_file(self.file, [VELOCITY])
        self.add_constants(**WLF)
        self.assertIsNone(rubber.shift_factors(Results(self.file)))
        self.draw()

    def test_curves_meet(self):
        """Friction that depends on a_T V alone is one curve over it: the curves have the same height at the same place."""
        make_file(self.file, [TEMPERATURE, ("velocity", np.geomspace(1e-3, 1e3, 13))])
        self.add_constants(**WLF)
        results = Results(self.file)
        factors = rubber.shift_factors(results)
        reduced = np.log10(np.outer(factors, results.axes[1].values))
        results.fields["friction_coefficient"].values = 1 / (1 + reduced**2)
        results.status[...] = 0
        figure = rubber.draw_velocities(results)
        for line in figure.axes[1].lines:
            np.testing.assert_allclose(line.get_ydata(), 1 / (1 + np.log10(line.get_xdata()) ** 2), rtol=1e-12)
        self.assertEqual(3, len(figure.axes[1].lines))

    def test_contact_share(self):
        """Over the period of a line, or over the load by its mean pressure for a map; unknown without either."""
        make_file(self.file, [VELOCITY])
        self.add_field("contact_area", [1.0, 2.0, 3.0], "m")
        self.assertIsNone(rubber.contact_share(Results(self.file)))
        self.add_constants(period=4.0)
        np.testing.assert_allclose(rubber.contact_share(Results(self.file)).values, [0.25, 0.5, 0.75])
        self.draw()
        make_file(self.file, [VELOCITY])
        self.add_field("contact_area", [1.0, 2.0, 3.0], "m^2")
        self.add_field("load", 10.0, "N")
        self.add_constants(mean_pressure=2.0)
        np.testing.assert_allclose(rubber.contact_share(Results(self.file)).values, [0.2, 0.4, 0.6])

    def test_lines(self):
        """A rough line has its heights below its pressure, a wave has stresses; also where no point is solved."""
        for kind, expected in ((2, rubber.draw_lines), (3, rubber.draw_lines), (0, figures.draw_stresses)):
            for value in (1.0, np.nan):
                make_file(self.file, [VELOCITY], [("x", [0.0, 1.0, 2.0, 3.0])])
                self.add_constants(kind=np.int8(kind))
                with h5py.File(self.file, "r+") as file:
                    file["displacement"] = value * file["gap"][()]
                    file["displacement"].attrs["units"] = "m"
                    for dimension, scale in zip(file["displacement"].dims, ("velocity", "x")):
                        dimension.attach_scale(file[scale])
                self.assertIs(figures.choose_figure(Results(self.file)), expected)
                self.draw()


if __name__ == "__main__":
    unittest.main()
