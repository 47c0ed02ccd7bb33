# SPDX-License-Identifier: GPL-3.0-or-later
"""The plot script on small files made here: jumps, tension on maps, pull-off and stickiness of surfaces that adhere."""

import unittest

import h5py
import numpy as np
from matplotlib import pyplot as plt
from matplotlib.colors import TwoSlopeNorm

from plot_files import PlotCase, make_file

from plotting import adhesion, figures, halfspace, jumps, sphere, style, surface
from plotting.chosen import draw_chosen
from plotting.results import Field, Results

# a load that falls off a fold at 0.3, as a square root, and jumps to 0 below
PLACES = np.linspace(0.0, 1.0, 101)
LOAD = np.where(PLACES > 0.295, -np.sqrt(np.maximum(PLACES - 0.29, 0.0)) - 0.5, 0.0)


class PlotAdhesionTest(PlotCase):
    def make_branch(self, branch="adhered", path=None):
        """A branch at given penetrations with one jump."""
        path = path or self.file
        make_file(path, [("penetration", PLACES)], model="surface_elastic")
        with h5py.File(path, "r+") as file:
            file["status"][...] = 0
            for name in ("contact_fraction", "mean_gap", "adhesion_fraction"):
                file[name][...] = 0.0
            file["mean_pressure"] = LOAD
            file["mean_pressure"].attrs["units"] = "Pa"
            file["mean_pressure"].dims[0].attach_scale(file["penetration"])
            file["branch"] = np.int8(0 if branch == "adhered" else 1)
            file["branch"].attrs.update(units="1", flag_meanings="adhered approach", flag_values=np.arange(2, dtype="i1"))
            file["status"].attrs["coordinates"] = "branch"
        return Results(path)

    def test_jumps(self):
        """The one jump is found, and the fold beside it is none."""
        results = self.make_branch()
        found = jumps.find_jumps(results, 0, ())
        np.testing.assert_array_equal(np.flatnonzero(found), [29])
        # any smooth curve, any other variable, any surface without adhesion
        results.fields["mean_pressure"].values[:] = np.exp(-8 * PLACES)
        self.assertFalse(jumps.find_jumps(results, 0, ()).any())
        results.fields["mean_pressure"].values[:] = LOAD
        results.axes[0].name = "range"
        self.assertFalse(jumps.find_jumps(results, 0, ()).any())
        results.axes[0].name = "penetration"
        del results.fields["adhesion_fraction"]
        self.assertFalse(jumps.find_jumps(results, 0, ()).any())

    def test_missing_values_are_no_jumps(self):
        results = self.make_branch()
        results.fields["mean_pressure"].values[29] = np.nan
        self.assertFalse(jumps.find_jumps(results, 0, ()).any())
        results.fields["mean_pressure"].values[:] = np.nan
        self.assertFalse(jumps.find_jumps(results, 0, ()).any())

    def test_loop(self):
        """Both branches in one figure: broken at their jumps, with arrows the way that each is passed, and dashes above."""
        other = self.folder / "other.h5"
        runs = [self.make_branch(), self.make_branch("approach", other)]
        self.assertEqual([jumps.way_of(run) for run in runs], [-1, 1])
        panel = draw_chosen(runs, None, ["mean_pressure"], None)[0].axes[0]
        curves = [line for line in panel.lines if len(line.get_xdata()) == PLACES.size + 1]
        leaps = [line for line in panel.lines if line.get_linestyle() == ":"]
        self.assertEqual((len(curves), len(leaps)), (2, 2))
        for curve in curves:
            np.testing.assert_array_equal(np.flatnonzero(np.isnan(curve.get_ydata())), [30])
        self.assertGreater(curves[0].get_zorder(), curves[1].get_zorder())
        # an arrow points from where its text would stand to its place: up for the first, down for the second
        ways = [np.sign(arrow.xy[1] - arrow.xyann[1]) for arrow in panel.texts]
        self.assertEqual(ways, [1, -1])
        self.assertEqual(self.plot(str(other), "--y", "mean_pressure"), (0, ""))

    def test_turned(self):
        results = self.make_branch("approach")
        results.constants["turning_pressure"] = Field("turning_pressure", "Pa", np.array(0.0))
        self.assertEqual(jumps.way_of(results), -1)
        del results.constants["turning_pressure"], results.words["branch"]
        self.assertEqual(jumps.way_of(results), 0)

    def make_map(self, model):
        """A map with a tension of 1 Pa, pressures up to 10 Pa and places without either."""
        places = ("y", np.linspace(0.1, 0.9, 8)), ("x", np.linspace(0.1, 0.9, 8))
        make_file(self.file, [("mean_pressure", [0.5, 1.0, 2.0])], places, model)
        with h5py.File(self.file, "r+") as file:
            file["status"][...] = 0
            rows = np.repeat([10.0, 5.0, 2.0, -0.5, -1.0, -1.0, 0.0, 0.0], 8).reshape(8, 8)
            file["pressure"][...] = rows
            file["gap"][...] = np.repeat([0.0, 0.0, 0.0, 0.0, 0.1, 0.2, 0.3, 0.4], 8).reshape(8, 8)
            for name in ("full_contact_pressure", "contact_fraction"):
                if name in file:
                    file[name][...] = 1.0
        return Results(self.file)

    def test_tension_on_maps(self):
        """Tension has the whole blue side of the colours, places without adhesion are grey, and contact has an outline."""
        for model, draw in (("surface_elastic", surface.draw_pressure_maps), ("wave_2d_elastic", halfspace.draw_contact_maps)):
            with self.subTest(model):
                figure = draw(self.make_map(model))
                panel, key = figure.axes[0], figure.axes[-1]
                mesh = panel.collections[0]
                self.assertIsInstance(mesh.norm, TwoSlopeNorm)
                self.assertEqual((mesh.norm.vmin, mesh.norm.vcenter, mesh.norm.vmax), (-1.0, 0.0, 10.0))
                free = np.ma.getmaskarray(mesh.get_array())
                self.assertEqual(free.sum(), free.size // 4)
                self.assertGreater(len(panel.collections), 1)
                self.assertIn("grey: no adhesion", key.get_ylabel())
                ticks = key.get_yticks()
                self.assertTrue((ticks < 0).any() and (ticks > 0).any() and 0 in ticks)
                plt.close(figure)

    def test_maps_without_tension(self):
        results = self.make_map("wave_2d_elastic")
        results.profiles["pressure"].values[:] = np.maximum(results.profiles["pressure"].values, 0.0)
        figure = halfspace.draw_contact_maps(results)
        self.assertIn("blue: no contact", figure.axes[-1].get_ylabel())
        self.assertEqual(len(figure.axes[0].collections), 1)

    def make_pull_off(self):
        """A wave whose summit is a sphere of 1 m with E* = 1 Pa, and w = 1 J/m^2."""
        stress = np.array([0.1, 0.3, 1.0, 3.0])
        make_file(self.file, [("stress", stress)], model="wave_2d_elastic")
        results = Results(self.file)
        for name, value in (("period", 2 * np.pi), ("amplitude", 1.0), ("surface_energy", 1.0), ("contact_modulus", 1.0)):
            results.constants[name] = Field(name, "-", np.array(value))
        pressure = -np.array([2.0, 1.9, 1.6, 1.5]) * np.pi / (4 * np.pi**2)
        results.fields["pull_off_pressure"] = Field("pull_off_pressure", "Pa", pressure)
        return results, stress

    def test_pull_off_of_summits(self):
        """Load of a period over pi w R, against Maugis's lambda, 1.12725 of the stress here: (9/(2 pi))^(1/3)."""
        results, stress = self.make_pull_off()
        figure = adhesion.draw_pull_off(results)
        line = figure.axes[0].lines[0]
        np.testing.assert_allclose(line.get_xdata(), 1.1272517 * stress, rtol=1e-7)
        np.testing.assert_allclose(line.get_ydata(), [-2.0, -1.9, -1.6, -1.5], rtol=1e-14)
        self.assertEqual([text.get_text() for text in figure.axes[0].texts], ["DMT", "JKR"])
        # the range in place of the energy, and in place of the stress
        for gone, name, value in (("surface_energy", "range", 1 / stress), ("stress", "range", 1 / stress)):
            results, _ = self.make_pull_off()
            results.fields[name] = Field(name, "m", value)
            if gone == "stress":
                results.axes[0] = Field("range", "m", value)
                del results.fields["range"]
            else:
                del results.constants[gone]
            adhesion.add_pull_off(results)
            np.testing.assert_allclose(results.fields["lambda"].values, 1.1272517 * stress, rtol=1e-7)

    def test_pull_off_beside_the_sphere(self):
        """Points of the wave upon the curve of a sphere in reduced units, along a logarithmic axis."""
        wave, _ = self.make_pull_off()
        other = self.folder / "sphere.h5"
        make_file(other, [("lambda", np.logspace(-3, 3, 40))], model="sphere")
        with h5py.File(other, "r+") as file:
            file["pull_off_load"].attrs["units"] = "1"
        wave.title, ball = "Pull-off: wave", Results(other)
        ball.title = "Pull-off: sphere"
        panel = draw_chosen([ball, wave], "lambda", ["relative_pull_off_load"], None)[0].axes[0]
        self.assertEqual(panel.get_xscale(), "log")
        self.assertEqual(panel.get_legend_handles_labels()[1], ["sphere", "wave"])
        self.assertEqual(panel.get_legend_handles_labels()[0][1].get_linestyle(), "None")
        self.assertIn("JKR", [text.get_text() for text in panel.texts])

    def test_sphere_in_metres(self):
        make_file(self.file, [("adhesion_stress", [0.5, 1.0])], model="sphere")
        results = Results(self.file)
        for name in ("radius", "work_of_adhesion", "contact_modulus"):
            results.constants[name] = Field(name, "m", np.array(1.0))
        results.fields["pull_off_load"] = Field("pull_off_load", "N", np.array([-2.0, -1.5]) * np.pi)
        adhesion.add_pull_off(results)
        np.testing.assert_allclose(results.fields["relative_pull_off_load"].values, [-2.0, -1.5])
        np.testing.assert_allclose(results.fields["lambda"].values, sphere.lambda_of(np.array([0.5, 1.0]), 1.0, 1.0, 1.0))

    def test_pull_off_that_is_not_known(self):
        make_file(self.file, [("stress", [0.1, 1.0, 10.0])], model="wave_2d_elastic")
        figure = adhesion.draw_pull_off(Results(self.file))
        self.assertEqual([panel.get_ylabel() for panel in figure.axes], ["Contact fraction $A/A_0$"])

    def test_stickiness(self):
        """Tension at pull-off is positive, on a logarithmic axis; the roughness has plain numbers."""
        make_file(self.file, [("root_mean_square_height", [1e-8, 1e-7, 1e-6])], model="surface_elastic")
        results = Results(self.file)
        results.axes[0].unit = "m"
        results.fields["pull_off_pressure"] = Field("pull_off_pressure", "Pa", np.array([-1e5, -1e3, np.nan]))
        figure = adhesion.draw_stickiness(results)
        axes = figure.axes[0]
        self.assertEqual((axes.get_xscale(), axes.get_yscale()), ("log", "log"))
        np.testing.assert_array_equal(axes.lines[0].get_ydata(), [100.0, 1.0, np.nan])
        self.assertLess(axes.get_ylim()[0], 1.0)
        self.assertEqual(axes.get_xlabel(), r"Root mean square height $h_\mathrm{rms}$ (µm)")
        figure.canvas.draw()
        labels = [text.get_text() for text in axes.get_xticklabels()]
        self.assertIn("0.05", labels)
        self.assertIs(figures.choose_figure(results), adhesion.draw_stickiness)

    def test_few_decades(self):
        self.assertTrue(style.has_few_decades(np.array([1e-8, 1e-6])))
        self.assertFalse(style.has_few_decades(np.array([1e-8, 1e-5])))


if __name__ == "__main__":
    unittest.main()
