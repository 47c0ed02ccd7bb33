# SPDX-License-Identifier: GPL-3.0-or-later
"""The plot script on small files made here: the figures that follow from what was swept."""

import subprocess
import sys
import unittest
import warnings

import h5py
import numpy as np

from plot_files import SCRIPTS, STATES, PlotCase, make_file

from plotting import figures, halfspace, labels, sliding
from plotting.command import make_figure
from plotting.results import Results
from plotting.style import plt


class PlotTest(PlotCase):
    def test_figure_follows_from_what_is_swept(self):
        stress, load, velocity = ("stress", [0.0, 5e3]), ("load", [-1.0, 0.0, 1.0]), ("velocity", [0.1, 1.0, 10.0])
        radius, x, y = ("radius", [1.0, 2.0, 4.0]), ("x", [-1.0, 0.0, 1.0]), ("y", [-1.0, 0.0, 1.0, 2.0])
        for expected, axes, surface in (
            (figures.draw_sweep, [stress, load], []),
            (figures.draw_sweep, [velocity, stress, load], []),
            (figures.draw_sweep, [radius, stress, velocity, load], []),
            (figures.draw_stresses, [stress], [x]),
            (figures.draw_pressure_maps, [stress], [y, x]),
            (figures.draw_pressure_maps, [], [y, x]),
            (figures.draw_stresses, [stress, load, velocity], [x]),
        ):
            with self.subTest(expected=expected.__name__, axes=[name for name, _ in axes]):
                make_file(self.file, axes, surface)
                self.assertIs(figures.choose_figure(Results(self.file)), expected)
                self.assertEqual(self.plot(), (0, ""))
                self.assertTrue(self.file.with_suffix(".png").read_bytes().startswith(b"\x89PNG"))

    def test_results_of_a_sweep(self):
        """Some models have results that are drawn against a variable, as far as they vary; of others it is all that vary."""
        axes = [("stress", [0.0, 5e3]), ("load", [0.0, 1.0, 2.0])]
        make_file(self.file, axes)
        self.assertEqual(figures.choose_results(Results(self.file)), ["contact_width", "friction_force"])
        with h5py.File(self.file, "r+") as file:
            file["contact_width"][...] = 1.0
        self.assertEqual(figures.choose_results(Results(self.file)), ["friction_force"])
        make_file(self.file, axes, model="hertz")
        self.assertEqual(figures.choose_results(Results(self.file))[:2], ["friction_force", "friction_coefficient"])

    def test_figures_of_the_sphere(self):
        load, lam, alpha = ("load", [-1.0, 0.0, 1.0]), ("lambda", [0.8, 1e6]), ("interaction", [0.0, 0.5])
        energy, force = ("slip_energy_ratio", [0.5, 1.0]), ("tangential_force", [0.1, 0.2])
        for expected, axes, radius in (
            (figures.sphere.draw_radii, [lam, ("contact_radius", [0.5, 1.0, 1.5])], []),
            (figures.draw_sweep, [load], []),
            (figures.draw_sweep, [alpha, lam, load], []),
            (figures.sphere.draw_area_left, [load, alpha, lam, energy], []),
            (figures.sphere.draw_peeling, [alpha, ("tangential_displacement", [0.0, 1.0])], []),
            (figures.sphere.draw_stick_radius, [force], []),
            (figures.sphere.draw_shear_stress, [force], [("r", [0.0, 0.5, 1.0])]),
            (figures.sphere.draw_pull_off, [("lambda", [1e-2, 1.0, 1e2])], []),
            (figures.draw_stresses, [load], [("r", [0.0, 0.5, 1.0])]),
        ):
            with self.subTest(expected=expected.__name__):
                make_file(self.file, axes, radius, model="sphere")
                self.assertIs(figures.choose_figure(Results(self.file)), expected)
                self.assertEqual(self.plot(), (0, ""))

    def test_figures_of_the_half_space(self):
        pressure, radius = ("mean_pressure", [0.0, 0.5, 1.0]), ("radius_1x", [0.1, 1.0, 10.0])
        load, work = ("load", [0.0, 1.0, 2.0]), ("work_of_adhesion", [0.0, 0.1])
        x, y = ("x", [0.5, 1.5, 2.5, 3.5]), ("y", [0.5, 1.5, 2.5])
        for expected, model, axes, surface in (
            (halfspace.draw_area, "wave_2d_elastic", [pressure], []),
            (halfspace.draw_contact_maps, "wave_2d_elastic", [pressure], [y, x]),
            (figures.draw_sweep, "wave_1d", [pressure], []),
            (halfspace.draw_pressures, "wave_1d", [pressure], [x]),
            (halfspace.draw_pressures, "rigid_punch", [load], [x]),
            (halfspace.draw_stress_maps, "rigid_punch", [], [y, x]),
            (halfspace.draw_stress_maps, "line_load", [load], [y, x]),
            (sliding.draw_friction, "surface_sliding", [("velocity", [0.1, 1.0, 10.0])], []),
            (sliding.draw_friction, "surface_sliding", [("velocity", [0.1, 1.0]), ("temperature", [270.0, 290.0, 310.0])], []),
            (sliding.draw_contacts, "surface_sliding", [pressure], [y, x]),
            (sliding.draw_contacts, "surface_sliding", [pressure], [x]),
            (halfspace.draw_half_axes, "hertz", [radius], []),
            (halfspace.draw_half_axes, "hertz", [("radius_2y", [-10.0, -1.0, -0.1])], []),
            (figures.draw_pressure_maps, "hertz", [radius], [y, x]),
            (figures.draw_sweep, "hertz", [load, ("velocity", [0.1, 1.0, 10.0])], []),
            (figures.sphere.draw_radii, "sphere", [work, ("contact_radius", [0.5, 1.0, 1.5])], []),
        ):
            with self.subTest(expected=expected.__name__, model=model):
                make_file(self.file, axes, surface, model=model)
                self.assertIs(figures.choose_figure(Results(self.file)), expected)
                with warnings.catch_warnings():
                    warnings.simplefilter("error")
                    self.assertEqual(self.plot(), (0, ""))

    def test_levels(self):
        # even over what is usual, 1-2-5 where few are much larger, and something where there is nothing
        np.testing.assert_allclose(halfspace.choose_levels(np.linspace(0.0, 0.95, 100)), 0.1 * np.arange(1, 11))
        np.testing.assert_allclose(halfspace.choose_levels(np.append(np.full(1000, 3.0), 1e4)), [.02, .05, .1, .2, .5, 1, 2])
        self.assertTrue(np.all(np.diff(halfspace.choose_levels(np.array([np.nan, 0.0]))) > 0))

    def test_crest_in_the_middle(self):
        make_file(self.file, [("velocity", [1.0, 2.0])], [("x", [0.5, 1.5, 2.5, 3.5])], model="surface_sliding")
        results = Results(self.file)
        moved = sliding.centre_crest(results)
        np.testing.assert_array_equal(moved.profile_axes[0].values, [-1.5, -0.5, 0.5, 1.5])
        np.testing.assert_array_equal(moved.profiles["pressure"].values[..., [2, 3, 0, 1]], results.profiles["pressure"].values)

    def test_period_from_its_quarter(self):
        np.testing.assert_array_equal(halfspace._mirror(np.array([1.0, 2.0])), [2, 1, 1, 2])
        np.testing.assert_array_equal(halfspace._mirror(np.array([1.0, 2.0]), -1.0), [-2, -1, 1, 2])

    def test_words_of_states(self):
        make_file(self.file, [("load", [0.0, 1.0, 2.0])], model="sphere")
        self.assertEqual(list(Results(self.file).states["stable"]), ["stable", "stable", None])

    def test_pdf(self):
        make_file(self.file, [("load", [0.0, 1.0, 2.0])])
        figure = self.folder / "figure.pdf"
        self.assertEqual(self.plot("-o", str(figure)), (0, ""))
        self.assertTrue(figure.read_bytes().startswith(b"%PDF"))

    def test_missing_file(self):
        self.assert_refused("no such file")

    def test_text_file(self):
        self.file.write_text("x, y\n")
        self.assert_refused("not an HDF5 file")

    def test_foreign_file(self):
        with h5py.File(self.file, "w") as file:
            file["x"] = [1.0]
        self.assert_refused("not a results file of adfric")

    def test_single_point(self):
        make_file(self.file, [])
        self.assert_refused("one point without profiles", expected=3)

    def test_nothing_varies(self):
        for axes in ([("load", [0.0, 1.0])], [("load", [0.0]), ("stress", [0.0])]):
            make_file(self.file, axes)
            self.assert_refused("nothing to draw", expected=3)

    def test_every_registered_figure(self):
        """With any other swept variables, and without a solution."""
        for model, along in figures.FIGURES:
            for others in ([], ["poisson_ratio", "interaction", "edge_fraction"]):
                axes = [*((name, [0.1, 0.2]) for name in others), (along, [0.5, 1.0, 1.5])]
                for is_solved in (True, False):
                    with self.subTest(model=model, axes=[name for name, _ in axes], is_solved=is_solved):
                        make_file(self.file, axes, model=model)
                        if not is_solved:
                            with h5py.File(self.file, "r+") as file:
                                file["status"][...] = -1
                                for name in set(file) - {"status", "blocks", *STATES, *dict(axes)}:
                                    file[name][...] = np.nan
                        results = Results(self.file)
                        plt.close(figures.choose_figure(results)(results))

    def test_profiles_of_another_model(self):
        make_file(self.file, [("load", [0.0, 1.0])], [("radius", [0.0, 0.5, 1.0])], model="sphere")
        with h5py.File(self.file, "r+") as file:
            file["pressure"].attrs["units"] = "1"
            file["status"][...] = -1
        self.assertEqual(self.plot(), (0, ""))

    def test_file_of_a_run_that_goes_on(self):
        make_file(self.file, [("load", [0.0, 1.0, 2.0])])
        with h5py.File(self.file, "r+"):
            code = f"import sys; from plotting.command import main; sys.exit(main([{str(self.file)!r}]))"
            ended = subprocess.run([sys.executable, "-c", code], cwd=SCRIPTS, capture_output=True, text=True)
        self.assertEqual((ended.returncode, ended.stdout), (2, ""))
        self.assertIn("a run is writing this file", ended.stderr)

    def test_figure_never_replaces_the_results(self):
        self.file = self.folder / "run.png"
        make_file(self.file, [("load", [0.0, 1.0, 2.0])])
        content = self.file.read_bytes()
        self.assertEqual(self.plot()[0], 2)
        self.assertEqual(self.file.read_bytes(), content)

    def test_axes_are_missing(self):
        with h5py.File(self.file, "w") as file:
            file.attrs.update(model="wavy_sliding", adfric_version="0.0.0")
            file["status"] = np.zeros(3, dtype="i1")
        self.assert_refused("its axes are missing")

    def test_deleted_scales(self):
        """Datasets stay attached to a scale that somebody has deleted: of the sweep, or of the surface alone."""
        for name in ("load", "x"):
            make_file(self.file, [("stress", [0.0, 5e3]), ("load", [0.0, 1.0])], [("x", [-1.0, 0.0, 1.0])])
            with h5py.File(self.file, "r+") as file:
                del file[name]
            with self.subTest(name=name):
                self.assert_refused("its axes are missing")

    def test_dollars(self):
        """What stands between dollar signs in a title or a name is no formula, and never an error of one."""
        make_file(self.file, [("load", [0.0, 1.0, 2.0])])
        for title in ("5 $ a piece", r"$\frac$ and $x$", "from $1 to $2", r"a\$b"):
            with h5py.File(self.file, "r+") as file:
                file.attrs["title"] = title
            with self.subTest(title=title):
                figure = make_figure([Results(self.file)])
                shown, is_formula = figure.get_suptitle(), figure._suptitle._preprocess_math(figure.get_suptitle())
                self.assertEqual((title, False), is_formula, shown)
                self.assertEqual(self.plot(), (0, ""))
        others = [self.folder / "$x$.h5", self.folder / "$y$.h5"]
        for path in others:
            make_file(path, [("load", [0.0, 1.0, 2.0])])
        labels = [text.get_text() for text in make_figure([Results(path) for path in others]).axes[0].get_legend().get_texts()]
        self.assertEqual([r"\$x\$", r"\$y\$"], labels)

    def test_unknown_format(self):
        make_file(self.file, [("load", [0.0, 1.0])])
        self.assert_refused(".png, .pdf, .svg", "-o", str(self.folder / "figure.gif"))

    def test_unwritable_figure(self):
        make_file(self.file, [("load", [0.0, 1.0, 2.0])])
        self.assert_refused("cannot write", "-o", str(self.folder / "none" / "figure.png"))

    def test_units(self):
        for values, unit, expected in (
            ([0.0, 8.3e-3], "N/m", (1e3, "mN/m")),
            ([1e-4], "m", (1e6, "µm")),
            ([5e-9], "m^2", (1e12, "µm²")),
            ([2e-6], "m^2/m", (1e6, "µm²/µm")),
            ([-5.5e6, 1.0], "Pa", (1e-6, "MPa")),
            ([3e3], "m", (1.0, "m")),
            ([0.2, np.nan], "-", (1.0, "")),
            ([0.0], "N", (1.0, "N")),
            ([0.3], "Pa", (1.0, "Pa")),
        ):
            factor, text = labels.scale_of(values, unit)
            self.assertEqual(text, expected[1])
            self.assertAlmostEqual(factor / expected[0], 1.0)


if __name__ == "__main__":
    unittest.main()
