# SPDX-License-Identifier: GPL-3.0-or-later
"""The plot script on small files made here: several files, chosen names, tables, and what figures look like."""

import unittest

import h5py
import numpy as np

from plot_files import PlotCase, make_file

from plotting import chosen, command, curves, figures, labels
from plotting.chosen import draw_chosen
from plotting.results import Field, Results
from plotting.style import COLOURS


class PlotChoiceTest(PlotCase):
    def test_constants_are_no_results(self):
        """What has one value in the whole run is neither a result nor a profile, not even of a single point."""
        for axes in ([], [("load", [0.0, 1.0, 2.0])]):
            make_file(self.file, axes)
            with h5py.File(self.file, "r+") as file:
                file["radius"] = 2.5
                file["radius"].attrs["units"] = "m"
                file["status"].attrs["coordinates"] = "radius"
            results = Results(self.file)
            self.assertNotIn("radius", {**results.fields, **results.profiles})
            self.assertEqual((results.constants["radius"].unit, results.constants["radius"].values), ("m", 2.5))
        self.assert_refused("radius has one value in the whole run", "--y", "radius")

    def test_pure_numbers(self):
        make_file(self.file, [("load", [0.0, 1.0, 2.0])])
        self.assertEqual(Results(self.file).fields["friction_coefficient"].unit, "-")

    def test_names_of_earlier_versions(self):
        make_file(self.file, [("mean_pressure", [0.0, 0.5, 1.0])], model="wave_2d_elastic")
        with h5py.File(self.file, "r+") as file:
            file.move("contact_fraction", "area_fraction")
        self.assertIn("contact_fraction", Results(self.file).fields)
        self.assertEqual(self.plot(), (0, ""))
        make_file(self.file, [("load", [0.0, 0.5, 1.0])], model="sphere")
        with h5py.File(self.file, "r+") as file:
            file.move("friction_area", "contact_area")
        fields = Results(self.file).fields
        self.assertIn("friction_area", fields)
        self.assertNotIn("contact_area", fields)

    def test_old_names_of_other_models(self):
        make_file(self.file, [("load", [0.0, 0.5, 1.0])], model="sphere")
        self.assert_refused("did you mean friction_area?", "--y", "area_fraction")
        make_file(self.file, [("mean_pressure", [0.0, 0.5, 1.0])], model="wave_1d")
        self.assert_refused("area_fraction is called contact_fraction now", "--y", "area_fraction")

    def test_nothing_but_gaps(self):
        make_file(self.file, [("load", [0.0, 0.5, 1.0])])
        with h5py.File(self.file, "r+") as file:
            file["contact_width"][...] = np.nan
        self.assert_refused("contact_width has no value at any point", "--y", "friction_force", "contact_width", expected=3)
        self.assert_refused("contact_width has no value at any point", "--x", "contact_width", expected=3)

    def test_reduced_units_have_names(self):
        make_file(self.file, [("lambda", [0.1, 1.0, 10.0])], model="sphere")
        results = Results(self.file)
        self.assertIn(r"$P_c/(\pi w R)$", figures.sphere.draw_pull_off(results).axes[0].get_ylabel())

    def test_concave_radii_have_ticks_within_decades(self):
        make_file(self.file, [("radius_2y", [-1.0, -0.1, -0.02])], model="hertz")
        for panel in figures.halfspace.draw_half_axes(Results(self.file)).axes:
            self.assertGreater(np.sum(panel.xaxis.get_minorticklocs() < -0.1), 5)

    def drawn(self, *options, other=None):
        """The figure of several files, or of chosen names."""
        runs = [Results(path) for path in [self.file, *([other] if other else [])]]
        given = command.read_command_line([str(self.file), *options])
        return draw_chosen(runs, given.x, given.y, given.data)

    def test_several_files(self):
        other = self.folder / "other.h5"
        for path, title in ((self.file, "Fig. 5 (JKR)"), (other, "Fig. 5 (DMT)")):
            make_file(path, [("load", [-1.0, 0.0, 1.0])], model="sphere")
            with h5py.File(path, "r+") as file:
                file.attrs["title"] = title
        self.assertEqual(self.plot(str(other)), (0, ""))
        figure, title = self.drawn(other=other)
        self.assertEqual(title, "Fig. 5")
        self.assertEqual(figure.axes[0].get_legend_handles_labels()[1], ["JKR", "DMT"])
        with h5py.File(other, "r+") as file:
            file["load"].attrs["units"] = "1"
        self.file.with_suffix(".png").unlink()
        self.assert_refused("load is in reduced units, but in N/m in", str(other), "-o", str(self.folder / "new.pdf"))

    def make_pair(self, few=3):
        """An exact curve of 40 velocities at two pressures, and what another model has found at few of them."""
        other = self.folder / "other.h5"
        for path, model, count in ((self.file, "wave_1d", 40), (other, "surface_sliding", few)):
            make_file(path, [("mean_pressure", [2.0e5, 8.0e5]), ("velocity", np.logspace(-3, 3, count))], model=model)
            with h5py.File(path, "r+") as file:
                file.attrs["title"] = "A wave" if path == self.file else "A wave: cells"
        return other

    def test_points_upon_a_curve(self):
        """Curves of several files that have the same other values have the same colours; few values are points upon many."""
        figure, title = self.drawn("--y", "friction_coefficient", "contact_fraction", other=self.make_pair())
        self.assertEqual(title, "A wave")
        for panel in figure.axes:
            lines = {line.get_label(): line for line in panel.lines if not line.get_label().startswith("_")}
            self.assertEqual(list(lines), [f"{model}, $p$ = {value} kPa" for model in ("wave_1d", "surface_sliding") for value in (200, 800)])
            exact, points = list(lines.values())[:2], list(lines.values())[2:]
            self.assertEqual([line.get_color() for line in exact], [line.get_color() for line in points])
            self.assertNotEqual(exact[0].get_color(), exact[1].get_color())
            self.assertEqual({line.get_linestyle() for line in exact}, {"-"})
            self.assertEqual({(line.get_linestyle(), line.get_fillstyle()) for line in points}, {("None", "none")})
            self.assertEqual({len(line.get_xdata()) for line in points}, {3})

    def test_many_upon_many(self):
        """Curves of as many values differ by their dashes, and other curves by their colours."""
        other = self.make_pair(few=39)
        panel = self.drawn("--y", "friction_coefficient", other=other)[0].axes[0]
        self.assertEqual([line.get_linestyle() for line in panel.lines[:4]], ["-", "-", "--", "--"])
        with h5py.File(other, "r+") as file:
            file["mean_pressure"][1] = 4.0e5
        panel = self.drawn("--y", "friction_coefficient", other=other)[0].axes[0]
        self.assertEqual([line.get_color() for line in panel.lines[:4]], [COLOURS[0], COLOURS[0], COLOURS[1], COLOURS[1]])

    def test_share_of_strips(self):
        """Strips have no share in contact among their results; it follows from the area, the load and the mean pressure."""
        other = self.make_pair()
        make_file(self.file, [("velocity", np.logspace(-3, 3, 40))])
        self.assert_refused("run.h5: no variable or result of this name, given contact_fraction", str(other), "--y", "contact_fraction")
        with h5py.File(self.file, "r+") as file:
            for name, values, units in (("load", 6.0, "N"), ("contact_area", np.linspace(1e-6, 2e-6, 40), "m^2")):
                file[name] = np.broadcast_to(values, 40)
                file[name].attrs["units"] = units
                file[name].dims[0].attach_scale(file["velocity"])
            file["mean_pressure"] = 2.0e6
            file["mean_pressure"].attrs["units"] = "Pa"
            file["status"].attrs["coordinates"] = "mean_pressure"
        panel = self.drawn("--y", "contact_fraction", other=other)[0].axes[0]
        np.testing.assert_allclose(panel.lines[0].get_ydata()[[0, -1]], [1 / 3, 2 / 3])
        self.assert_refused("contact_shift", str(other), "--y", "contact_shift")

    def test_titles(self):
        for titles, expected in ((["Fig. 5 (JKR)", "Fig. 5 (DMT)"], ("Fig. 5", ["JKR", "DMT"])),
                                 (["A layer", "A layered one"], ("A", ["layer", "layered one"])),
                                 (["A wave", "A wave: cells"], ("A wave", ["run", "other"])),
                                 (["", ""], ("", ["run", "other"])), (["A wave", "A wave"], ("A wave", ["run", "other"]))):
            runs = []
            for name, title in zip(("run", "other"), titles):
                make_file(self.folder / f"{name}.h5", [("load", [0.0, 1.0])])
                runs.append(Results(self.folder / f"{name}.h5"))
                runs[-1].title = title
            self.assertEqual(chosen._split_titles(runs), expected)

    def test_chosen_names(self):
        make_file(self.file, [("stress", [0.0, 5e3]), ("load", [-1.0, 0.0, 1.0])])
        figure, _ = self.drawn("--x", "contact_width", "--y", "friction_force", "friction_coefficient")
        self.assertEqual([panel.get_xlabel() for panel in figure.axes], 2 * ["Contact width $a + b$ (mm)"])
        self.assertEqual(figure.axes[1].get_ylabel(), r"Friction coefficient $\mu$")
        self.assertEqual(len(figure.axes), 2)
        self.assertEqual(sum(line.get_label() == "no adhesion" for line in figure.axes[0].lines), 1)
        self.assertEqual(self.plot("--y", "friction_force"), (0, ""))

    def test_wrong_names(self):
        make_file(self.file, [("load", [-1.0, 0.0, 1.0])], model="sphere")
        self.assert_refused("given frction_force; did you mean friction_force?", "--y", "frction_force")
        self.assert_refused("given zzz, allowed: load, ", "--x", "zzz")
        self.assert_refused("stable is a state", "--y", "stable")
        make_file(self.file, [], model="sphere")
        self.assert_refused("one point", "--y", "friction_force", expected=3)

    def test_table(self):
        make_file(self.file, [("load", [-1.0, 0.0, 1.0])])
        table = self.folder / "measured.csv"
        table.write_text("# by hand\nload [N/m], friction_force [N/m], other\n0.5, 0.25, 1\n0.75, , 2\n")
        figure, _ = self.drawn("--y", "friction_force", "--data", str(table))
        points = next(line for line in figure.axes[0].lines if line.get_label() == "measured")
        np.testing.assert_array_equal(points.get_xdata(), [0.5, 0.75])
        self.assertEqual(figure.axes[0].get_ylabel(), "Friction force $T$ (mN/m)")
        np.testing.assert_array_equal(points.get_ydata(), [250.0, np.nan])
        self.assertEqual(self.plot("--y", "friction_force", "--data", str(table)), (0, ""))
        # other units, and the dialects of docs/reference/tables.md
        for text in ("load (mN/m);Friction force in kN/m\n500;2,5e-4\n750;\n", "load\tfriction_force\nN/m\tuN/um\n0.5\t0.25\n0.75\tnan\n"):
            table.write_text(text)
            figure, _ = self.drawn("--y", "friction_force", "--data", str(table))
            points = next(line for line in figure.axes[0].lines if line.get_label() == "measured")
            np.testing.assert_allclose(points.get_xdata(), [0.5, 0.75], rtol=1e-15)
            np.testing.assert_allclose(points.get_ydata(), [250.0, np.nan], rtol=1e-15)
        for text, words in (("lod,friction_force\n1,2\n", "is it lod?"), ("load,a\n1,2\n", "no column friction_force"),
                            ("load,friction_force\n1,a\n", "'a' is no number"),
                            ("load,friction_force\n", "there is no row of numbers"),
                            ("load [nm],friction_force\n1,2\n", "column load is in nm, the results in N/m"),
                            ("load (raw),friction_force\n1,2\n", "column load is in raw, the results in N/m")):
            table.write_text(text)
            self.file.with_suffix(".png").unlink(missing_ok=True)
            self.assert_refused(words, "--y", "friction_force", "--data", str(table))
        self.assert_refused("none.csv: no such file", "--y", "friction_force", "--data", str(self.folder / "none.csv"))

    def test_poles(self):
        """A friction coefficient is no curve through the load 0."""
        load = np.array([-2.0, -1.0, -0.1, 0.2, 1.0, 2.0])
        broken = curves.without_pole(1 / load, load)
        np.testing.assert_array_equal(np.isnan(broken), load == -0.1)
        self.assertTrue(curves.passes_zero(load))
        self.assertFalse(curves.passes_zero(load[3:]))
        make_file(self.file, [("load", load)])
        with h5py.File(self.file, "r+") as file:
            file["friction_coefficient"][...] = 1 / load
        figure = curves.draw_panels(Results(self.file), "load", ["friction_coefficient"])
        low, high = figure.axes[0].get_ylim()
        self.assertEqual((low, high), (-4.0, 4.0))

    def test_one_prefix_for_one_unit(self):
        fields = [Field("a", "Pa", np.array([0.3])), Field("b", "Pa", np.array([2e3])), Field("c", "m", np.array([3e-3])),
                  Field("d", "m", np.array([4e-4])), Field("e", "Pa", np.array([0.0]))]
        scales = labels.scales_of(fields[2:4])
        self.assertEqual((scales["c"][1], scales["d"][1]), ("mm", "mm"))
        scales = labels.scales_of(fields)
        # too far apart
        self.assertEqual((scales["a"][1], scales["b"][1]), ("Pa", "kPa"))

    def test_colours_and_dashes(self):
        """Two more swept variables have a colour and dashes for each value; without adhesion the line is broken."""
        make_file(self.file, [("velocity", [0.1, 1.0]), ("stress", [0.0, 5e3]), ("load", [-1.0, 0.0, 1.0])])
        panel = figures.draw_sweep(Results(self.file)).axes[1]
        self.assertEqual(panel.get_ylabel(), "Friction force $T$ (mN/m)")
        styles = {line.get_label(): (line.get_linestyle(), line.get_color()) for line in panel.lines}
        self.assertEqual([styles[f"$V$ = {v} m/s, {words}"] for v in ("0.1", "1") for words in ("no adhesion", "$p_0$ = 5 kPa")],
                         [("--", COLOURS[0]), ("-", COLOURS[0]), ("--", COLOURS[1]), ("-", COLOURS[1])])

    def test_panels_of_the_slowest_of_three(self):
        axes = [("load", [0.0, 3.0]), ("interaction", [0.0, 0.5, 1.0]), ("lambda", [0.8, 1e6]), ("slip_energy_ratio", [0.5, 1.0])]
        make_file(self.file, axes, model="sphere")
        figure = figures.sphere.draw_area_left(Results(self.file))
        self.assertEqual([panel.get_title() for panel in figure.axes], ["$P$ = 0 N/m", "$P$ = 3 N/m"])
        words = [text.get_text() for text in (figure.legends[0] if figure.legends else figure.axes[0].get_legend()).get_texts()]
        self.assertEqual(words, [r"$\alpha$ = 0", r"$\alpha$ = 0.5", r"$\alpha$ = 1", r"$\lambda$ = 0.8", r"$\lambda$ = 1e+06"])

    def test_area_of_sliding(self):
        """The area on which friction acts in sliding is the force over the strength; the reduced unit of force is twice that."""
        for unit, expected in (("N", 1.0), ("1", 2.0)):
            make_file(self.file, [("tangential_displacement", [0.0, 1.0, 2.0])], model="sphere")
            with h5py.File(self.file, "r+") as file:
                file["friction_area"][...] = [4.0, 3.0, np.nan]
                file["friction_force"][...] = [0.0, 5.0, np.nan]
                file["sliding_force"] = np.full(3, 6.0)
                file["sliding_force"].attrs["units"] = unit
                file["sliding_force"].dims[0].attach_scale(file["tangential_displacement"])
                file["shear_strength"] = 3.0
                file["status"].attrs["coordinates"] = "shear_strength"
            figure = figures.sphere.draw_peeling(Results(self.file))
            self.assertEqual(figure.axes[1].lines[-1].get_ydata()[-1], expected * 6.0 / 3.0 / 4.0)
            # the drop at the onset of sliding, against the force
            drop = figure.axes[2].lines[-1]
            np.testing.assert_array_equal(drop.get_xdata(), [5.0, 6.0])
            np.testing.assert_array_equal(drop.get_ydata(), [0.75, expected * 6.0 / 3.0 / 4.0])

    def test_force_and_stick_radius(self):
        make_file(self.file, [("tangential_force", [0.1, 0.2, 0.3])], model="sphere")
        with h5py.File(self.file, "r+") as file:
            file["friction_radius"][...] = [2.0, 2.0, 0.0]
            file["stick_radius"][...] = [2.0, 1.0, 0.0]
        axes = figures.sphere.draw_stick_radius(Results(self.file)).axes[0]
        self.assertEqual(axes.get_xlabel(), "Tangential force $T$")
        np.testing.assert_array_equal(axes.lines[0].get_ydata(), [1.0, 0.5, np.nan])

    def test_long_legends_stand_outside(self):
        make_file(self.file, [("stress", [1e3, 2e3, 3e3, 4e3, 5e3]), ("load", [0.0, 1.0])])
        figure = curves.draw_panels(Results(self.file), "load", ["friction_force"])
        self.assertEqual((len(figure.legends), figure.axes[0].get_legend()), (1, None))


if __name__ == "__main__":
    unittest.main()
