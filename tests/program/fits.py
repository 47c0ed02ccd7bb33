# SPDX-License-Identifier: GPL-3.0-or-later
"""adfric fit through the command line: the reference sets, stacks in parts, and what is refused."""

import csv
import re
import sys
import unittest
import warnings
from pathlib import Path

import h5py
import numpy as np
import xarray as xr

sys.path.insert(0, str(Path(__file__).parent))
from runs import MAP, STACK, Runs  # noqa: E402

SOURCE = Path(__file__).resolve().parents[2]
SETS = SOURCE / "tests/reference/fit"
# of chi2, absolute; of estimates in standard errors; of standard errors, relative
CHI2, ESTIMATE, ERROR = 1e-6, 1e-4, 1e-4

FRICTION = """
&job model = 'sphere', output = 'run.h5' /
&sphere radius = 140e-9, contact_modulus = 44e9 /
&model theory = 'maugis_dugdale' /
&data file = '{file}', abscissa = 'load', ordinate = 'friction_force', abscissa_sigma_column = 'sigma_load' /
&free variable = 'work_of_adhesion' /
&free variable = 'shear_strength' /
&free variable = 'lambda' /
"""
AREA = """
&job model = 'sphere', output = 'run.h5' /
&sphere radius = 1e-3 /
&model theory = 'jkr' /
&data file = '{file}', abscissa = 'load', ordinate = 'contact_area' /
&free variable = 'work_of_adhesion' /
&free variable = 'contact_modulus' /
"""
# a small case in which each mistake is made
SMALL = """
&job model = 'sphere', output = 'run.h5' /
&sphere radius = 140e-9, contact_modulus = 44e9, work_of_adhesion = 0.19 /
&model theory = 'jkr' /
&data file = 'tip.csv', abscissa = 'load', ordinate = 'friction_force' /
&free variable = 'shear_strength' /
"""
TABLE = "load,friction_force,sigma\n-1e-8,3e-7,3e-9\n0,3.1e-7,3e-9\n1e-8,3.3e-7,3e-9\n2e-8,nan,3e-9\n"


def answers_of(name):
    """What a reference set gives, by quantity and word, of its first fit."""
    found = {}
    with open(SETS / f"{name}_answers.csv") as file:
        for row in csv.DictReader(line for line in file if not line.startswith("#")):
            if row["fit"] == "1":
                found.setdefault((row["quantity"], row["first"]), row["value"])
    return found


class Fits(Runs):
    def fit(self, text, *options, **more):
        """Fit an input; its results file as a dictionary."""
        self.write(text)
        self.run_program("fit", "--force", "run.nml", *options, **more)
        return self.read("run.h5")

    def read(self, name):
        with h5py.File(self.folder / name) as file:
            return {key: data[()] for key, data in file.items() if isinstance(data, h5py.Dataset)}


TIP = """&surface kind = 'paraboloid', radius = 140e-9 /
&solid contact_modulus = 44e9 /
&operating state = 'sliding' /
"""


class Sets(Fits):
    """Reference sets, one fit each; `tests/fit` has all of them."""

    def check(self, name, text, frees):
        results, answers = self.fit(text.format(file=SETS / f"{name}.csv")), answers_of(name)
        self.assertEqual(int(results["status"]), 0)
        self.assertAlmostEqual(float(results["chi2"]), float(answers["chi2", ""]), delta=CHI2)
        for free in frees:
            error = float(answers["error", free])
            self.assertLess(abs(float(results[free]) - float(answers["estimate", free])), ESTIMATE * error, free)
            self.assertLess(abs(float(results[f"{free}_error"]) / error - 1), ERROR, free)
        return results

    def test_friction(self):
        """Errors of the load, the latent form."""
        results = self.check("friction_md_lambda0.8_noise1_a", FRICTION, ("work_of_adhesion", "shear_strength", "lambda"))
        self.assertEqual(results["fitted"].shape, (80,))
        self.assertEqual(results["covariance"].shape, (3, 3))
        np.testing.assert_allclose(np.sqrt(np.diag(results["covariance"]))[0], results["work_of_adhesion_error"], rtol=1e-12)

    def test_area(self):
        self.check("area_jkr_a", AREA, ("work_of_adhesion", "contact_modulus"))

    def test_two_sets(self):
        """Friction and area together tell the modulus from the strength; both alone do not."""
        table = SETS / "joint_friction_area_a.csv"
        text = FRICTION.format(file=table).replace(", abscissa_sigma_column = 'sigma_load'", "").replace(", contact_modulus = 44e9", "")
        text += f"&data file = '{SETS}/joint_friction_area_a_area.csv', abscissa = 'load', ordinate = 'friction_area', "
        text += "ordinate_column = 'contact_area' /\n&event kind = 'pull_off_load', value = -1.3834167846086491e-07, sigma = 1.36529e-09 /\n"
        results = self.fit(text + "&free variable = 'contact_modulus' /\n")
        self.assertAlmostEqual(float(results["chi2"]), 86.66686746177017, delta=CHI2)
        self.assertEqual({"ordinate_1", "ordinate_2", "residual_2", "curve_1"} - set(results), set())

    def test_answers_for_lambda(self):
        """Friction that acts on a part of the ring of adhesion has two answers for lambda; on the contact alone it has one."""
        for fraction, n_others in ((0.0, 0), (0.4, 1)):
            self.write("&job output = 'curve.h5' /\n" + TIP + "&adhesion theory = 'maugis_dugdale', work_of_adhesion = 0.19, lambda = 5.0 /\n"
                       f"&friction edge_fraction = {fraction}, shear_strength = 0.96e9 /\n"
                       "&sweep variable = 'load', from = -110e-9, to = 280e-9, count = 80 /\n")
            self.run_program("run", "--quiet", "--force", "run.nml")
            curve = self.read("curve.h5")
            # the points have no noise, and an error of 1 % of the friction without load
            sigma = float(0.01 * np.interp(0.0, curve["load"], curve["friction_force"]))
            rows = "".join(f"{load!r},{force!r},{sigma!r}\n" for load, force in zip(curve["load"].tolist(), curve["friction_force"].tolist()))
            (self.folder / "curve.csv").write_text("load,friction_force,sigma\n" + rows)
            self.write(TIP + f"&adhesion theory = 'maugis_dugdale' /\n&friction edge_fraction = {fraction} /\n"
                       "&data file = 'curve.csv', abscissa = 'load', ordinate = 'friction_force' /\n"
                       + "".join(f"&free variable = '{name}' /\n" for name in ("work_of_adhesion", "shear_strength", "lambda")))
            output, _ = self.run_program("fit", "--force", "run.nml")
            self.assertEqual(output.count("another minimum"), n_others, output)

    def test_areas_on_cells(self):
        """A modulus by the area of a rough surface, and a shear strength by its friction, from any start; the count is refused."""
        rng = np.random.default_rng(7)
        x = np.arange(32)*2*np.pi/32
        with h5py.File(self.folder/"z.h5", "w") as file:
            file["z"] = sum(1e-7/k*np.cos(k*x[:, None] + rng.random()*6)*np.cos((4 - k)*x + rng.random()*6) for k in (1, 2, 3))
        rough = "&surface kind = 'heights', heights = 'z.h5:/z', length_x = 1e-5, length_y = 1e-5 /\n"
        self.write("&job output = 'run.h5' /\n" + rough + "&solid contact_modulus = 1e9 /\n&friction shear_strength = 1e6 /\n"
                   "&sweep variable = 'mean_pressure', from = 1e6, to = 3e7, count = 8 /\n")
        self.run_program("run", "--quiet", "run.nml")
        true = self.read("run.h5")
        noise = 1 + 0.01*rng.standard_normal((2, 8))
        lines = [f"{q:.17g},{a*f:.17g},{t*g:.17g},{0.01*a:.17g},{0.01*t:.17g}" for q, a, t, f, g in zip(
            true["mean_pressure"], true["smooth_contact_fraction"], true["smooth_friction_stress"], *noise)]
        self.write("mean_pressure,area,friction,sigma_area,sigma_friction\n" + "\n".join(lines) + "\n", "area.csv")
        data = "&data file = 'area.csv', abscissa = 'mean_pressure', ordinate = '{}', ordinate_column = '{}', sigma_column = 'sigma_{}' /\n"
        head = "&job output = 'run.h5' /\n" + rough
        for start in ("4e8", "3e9"):
            results = self.fit(head + data.format("smooth_contact_fraction", "area", "area")
                               + f"&free variable = 'contact_modulus', start = {start} /\n")
            self.assertEqual(int(results["status"]), 0)
            self.assertLess(abs(results["contact_modulus"] - 1e9), 4*results["contact_modulus_error"])
            self.assertLess(results["contact_modulus_error"], 2e7)
        results = self.fit(head + "&solid contact_modulus = 1e9 /\n" + data.format("smooth_friction_stress", "friction", "friction")
                           + "&free variable = 'shear_strength' /\n")
        self.assertLess(abs(results["shear_strength"] - 1e6), 4*results["shear_strength_error"])
        self.write(head + data.format("contact_fraction", "area", "area") + "&free variable = 'contact_modulus', start = 1e9 /\n")
        _, errors = self.run_program("fit", "--force", "run.nml", status=2)
        self.assertIn("smooth_contact_fraction", errors)

    def test_wavy(self):
        """Any model, any variable."""
        text = ("&job model = 'wavy_sliding', output = 'run.h5' /\n&surface kind = 'wave_2d', period = 1e-4, height = 1e-5 /\n"
                "&foundation retardation_ratio = 10 /\n&operating load = 12 /\n"
                "&data file = '{file}', abscissa = 'velocity', ordinate = 'friction_force' /\n"
                "&free variable = 'stiffness' /\n&free variable = 'relaxation_time' /\n")
        self.check("velocity_gm_a", text, ("stiffness", "relaxation_time"))

    def test_units(self):
        """A table in nanonewtons gives what one in newtons does."""
        lines = (SETS / "friction_models_lambda0.8_a.csv").read_text().splitlines()
        rows = [[float(word) for word in line.split(",")] for line in lines if line[0] in "-0123456789"]
        self.write("load [nN],friction_force [nN],sigma [nN]\n" + "".join(",".join(repr(x * 1e9) for x in row) + "\n" for row in rows), "tip.csv")
        text = FRICTION.replace(", abscissa_sigma_column = 'sigma_load'", "")
        first, second = self.fit(text.format(file="tip.csv")), self.fit(text.format(file=SETS / "friction_models_lambda0.8_a.csv"))
        np.testing.assert_allclose(first["ordinate"], second["ordinate"], rtol=1e-15)
        np.testing.assert_allclose(first["lambda"], second["lambda"], rtol=1e-6)

    def test_table_on_the_screen(self):
        """Each variable with its error; both minima; the theory that is as good."""
        self.write((SOURCE / "inputs/fit_friction.nml").read_text().replace("fit_friction.csv", str(SOURCE / "inputs/fit_friction.csv")))
        output, _ = self.run_program("fit", "run.nml", "--output", "run.h5")
        for words in ("standard error", "lambda", "0.21 to 0.24 or >= ", "another minimum", "theory jkr", "as good", "80 used, 0 left out",
                      "warning: the range of adhesion"):
            self.assertIn(words, output)
        results = self.read("run.h5")
        self.assertEqual(results["interval"].shape[:2], (3, 2))
        self.assertEqual(results["second_curve"].shape, results["curve"].shape)
        self.assertEqual([word.decode() for word in results["theory_name"]], ["jkr", "dmt"])
        with h5py.File(self.folder / "run.h5") as file:
            self.assertIn("as they were given", file["covariance"].attrs["long_name"])
            self.assertEqual(file.attrs["dataset_data"].split("/")[-1], "fit_friction.csv")
            self.assertEqual(len(file.attrs["checksum_data"]), 16)

    def test_beside_the_input(self):
        """A file that is not found from here is looked for beside the input."""
        self.run_program("fit", "--quiet", str(SOURCE / "inputs/fit_velocity.nml"), "--output", "run.h5")
        self.assertEqual(int(self.read("run.h5")["points_used"]), 61)

    def test_open_by_xarray(self):
        """Labels of the variables, no warnings."""
        self.fit(FRICTION.format(file=SETS / "friction_md_lambda0.8_noise1_a.csv") + "&fit intervals = 'profile' /\n")
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            with xr.open_dataset(self.folder / "run.h5", engine="h5netcdf") as data:
                self.assertEqual(data.correlation.sel(variable="lambda", other_variable="work_of_adhesion").shape, ())
                self.assertEqual(data.interval.dims, ("variable", "level", "piece", "end"))
                self.assertEqual(data.curve.dims, ("curve_x",))
                self.assertEqual(data.lambda_profile.dims, ("lambda_profile_value",))

    def test_complete(self):
        """A fit that is complete is not made again."""
        self.fit(AREA.format(file=SETS / "area_jkr_a.csv"))
        before = self.snapshot("run.h5")
        output, _ = self.run_program("fit", "--resume", "run.nml")
        self.assertIn("complete already", output)
        self.assert_same(before, self.snapshot("run.h5"))
        self.write(AREA.format(file=SETS / "area_jkr_a.csv").replace("&free variable = 'contact_modulus'", "&free variable = 'contact_modulus', prior = 2e6, prior_sigma = 0.1"))
        self.run_program("fit", "--resume", "run.nml", status=3)


class Curves(Fits):
    """Whole curves of load against approach: base line, contact, tilt."""

    TIP = ("&job model = 'indenter', output = 'run.h5' /\n&shape kind = 'paraboloid', radius = {radius} /\n&solid poisson_ratio = 0.5 /\n"
           "&data file = '{file}', abscissa = '{abscissa}', ordinate = 'load' /\n&free variable = 'young_modulus' /\n"
           "&free variable = 'contact_point' /\n")

    def test_whole(self):
        """A base line and contact, unmarked: E = 230 kPa, touch at 330 nm, for the indenter as for the sphere."""
        file = SETS / "whole_hertz.csv"
        found = self.fit(self.TIP.format(radius=40e-9, file=file, abscissa="approach"))
        self.assertEqual(int(found["status"]), 0)
        self.assertLess(abs(found["young_modulus"] / 230e3 - 1), 0.01)
        self.assertLess(abs(found["contact_point"] - 330e-9), 1e-9)
        sphere = self.fit("&job model = 'sphere', output = 'run.h5' /\n&sphere radius = 40e-9, poisson_ratio = 0.5 /\n&model theory = 'hertz' /\n"
                          f"&data file = '{file}', abscissa = 'approach', ordinate = 'load' /\n&free variable = 'young_modulus' /\n"
                          "&free variable = 'contact_point' /\n")
        for name in ("young_modulus", "contact_point"):
            self.assertLess(abs(found[name] - sphere[name]), 1e-3 * sphere[f"{name}_error"], name)

    def test_adhesion(self):
        """Contact alone, down to its end, without starts."""
        text = self.TIP.format(radius=1e-6, file=SETS / "contact_jkr.csv", abscissa="approach") + "&free variable = 'work_of_adhesion' /\n"
        found = self.fit(text)
        for name, value in (("young_modulus", 1e6), ("contact_point", 150e-9), ("work_of_adhesion", 1e-3)):
            self.assertLess(abs(found[name] / value - 1), 0.01, name)

    def test_tilt(self):
        """A base line with a slope is named; free, it gives E* = 2 GPa; the figure's branch tells nothing that the data do not."""
        rng = np.random.default_rng(3)
        load = np.r_[np.zeros(100), np.arange(1, 101) * 5e-10]
        z = np.r_[np.arange(-99, 1) * 1e-9, (0.75 * load[100:] / (2e9 * np.sqrt(2e-8)))**(2 / 3) + load[100:] / 0.5] + 2e-7
        measured = load + 3e-3 * z + rng.normal(0, 1e-11, z.size)
        self.write("base_approach,load\n" + "".join(f"{a!r},{b!r}\n" for a, b in zip(z.tolist(), measured.tolist())), "tip.csv")
        text = self.TIP.format(radius=2e-8, file="tip.csv", abscissa="base_approach").replace("young_modulus", "contact_modulus")
        text = text.replace("poisson_ratio = 0.5", "") + "&operating machine_stiffness = 0.5 /\n&free variable = 'load_offset' /\n"
        self.write(text)
        output, _ = self.run_program("fit", "--force", "run.nml")
        self.assertIn("warning: the base line of tip.csv has a slope of ", output)
        self.assertGreater(abs(self.read("run.h5")["contact_modulus"] / 2e9 - 1), 0.2)
        self.write(text + "&free variable = 'tilt' /\n")
        output, _ = self.run_program("fit", "--force", "run.nml")
        self.assertNotIn("slope", output)
        found = self.read("run.h5")
        self.assertLess(abs(found["contact_modulus"] - 2e9), 4 * found["contact_modulus_error"])
        self.assertLess(abs(found["tilt"] - 3e-3), 4 * found["tilt_error"])
        with h5py.File(self.folder / "run.h5") as file:
            self.assertEqual(file["tilt"].attrs["units"], "N/m")

    def test_jump(self):
        """With adhesion the base line is found from the jump, and check says so before anything is fitted."""
        rng = np.random.default_rng(4)
        # JKR in units of its own: P = t^2 - sqrt(6) t, delta = t^(1/3) (t - (2/3) sqrt(6)), t = a^(3/2)
        t = np.linspace(np.sqrt(6) / 6, 3, 80)
        unit, depth = np.pi * 1e-3 * 1e-6, (9 * np.pi**2 * 1e-6 * 1e-6 / (16 * 1e12))**(1 / 3)
        delta, load = depth * np.cbrt(t) * (t - 2 / 3 * np.sqrt(6)), unit * (t**2 - np.sqrt(6) * t)
        x = np.r_[delta[::-1], delta[0] - np.arange(1, 61) * 1e-9] + 1e-6
        y = np.r_[load[::-1], np.zeros(60)] + 2e-9 + rng.normal(0, 2e-11, 140)
        self.write("approach,load\n" + "".join(f"{a!r},{b!r}\n" for a, b in zip(x.tolist(), y.tolist())), "tip.csv")
        self.write(self.TIP.format(radius=1e-6, file="tip.csv", abscissa="approach").replace("young_modulus", "contact_modulus")
                   .replace("poisson_ratio = 0.5", "") + "&free variable = 'work_of_adhesion' /\n&free variable = 'load_offset' /\n")
        output, _ = self.run_program("check", "run.nml")
        self.assertIn("60 points of data[1], found from the jump of the load", output)
        output, _ = self.run_program("fit", "--force", "run.nml")
        self.assertIn("60 points, found from the jump of the load", output)
        found = self.read("run.h5")
        self.assertEqual(int(np.sum(found["branch"] == 0)), 60)
        for name, value in (("contact_modulus", 1e6), ("work_of_adhesion", 1e-3), ("contact_point", 1e-6)):
            self.assertLess(abs(found[name] - value), 4 * found[f"{name}_error"], name)

    def test_drawn_curve(self):
        """Of data over decades the curve is even in ratios, and nowhere do chords of it leave the model."""
        self.write((SOURCE / "inputs/fit_velocity.nml").read_text().replace("fit_velocity.csv", str(SOURCE / "inputs/fit_velocity.csv")))
        self.run_program("fit", "run.nml", "--output", "run.h5")
        found = self.read("run.h5")
        x, y = np.log(found["curve_x"]), found["curve"]
        self.assertLess(np.diff(x).max() / np.diff(x).min(), 6)
        chord = y[:-2] + (y[2:] - y[:-2]) * (x[1:-1] - x[:-2]) / (x[2:] - x[:-2])
        self.assertLess(np.abs(y[1:-1] - chord).max(), 0.01 * np.ptp(y))


class Stacks(Fits):
    """A map of 144 curves."""

    def test_map(self):
        results = self.fit(STACK.format(file=MAP))
        with h5py.File(MAP) as file:
            expected = {key: data[()] for key, data in file["expected"].items()}
        self.assertTrue(np.array_equal(results["status"], expected["status"]))
        self.assertEqual(int((results["status"] == 0).sum()), 141)
        np.testing.assert_allclose(results["chi2"], expected["chi2"], atol=CHI2, equal_nan=True)
        for name in ("work_of_adhesion", "contact_modulus", "contact_point", "load_offset"):
            difference = np.abs(results[name] - expected[name]) / expected[f"{name}_error"]
            self.assertLess(np.nanmax(difference), ESTIMATE, name)
            self.assertTrue(np.array_equal(np.isnan(results[name]), expected["status"] != 0), name)

    def test_bits(self):
        """Threads, parts and resumed runs change no bit."""
        self.write(STACK.format(file=MAP))
        self.run_program("fit", "--quiet", "run.nml", "--output", "whole.h5", threads=1)
        whole = self.snapshot("whole.h5")
        self.run_program("fit", "--quiet", "run.nml", "--output", "two.h5", threads=2)
        self.assert_same(whole, self.snapshot("two.h5"))
        for number in (1, 2, 3):
            self.run_program("fit", "--quiet", "run.nml", "--shard", f"{number}/3", threads=1 + number % 2)
        self.run_program("merge", "all.h5", *(f"run.part-{number:04}-of-0003.h5" for number in (3, 1, 2)))
        self.assert_same(whole, self.snapshot("all.h5"))
        # a part without its last states is a run that was stopped
        (self.folder / "two.h5").rename(self.folder / "run.h5.partial")
        with h5py.File(self.folder / "run.h5.partial", "r+") as file:
            file["status"][6:] = -1
        self.run_program("fit", "--quiet", "--resume", "run.nml")
        self.assert_same(whole, self.snapshot("run.h5"))

    def test_bits_of_one_curve(self):
        """A curve of several blocks of points, which threads share, has the same bits with any number of them."""
        noise = np.random.default_rng(3)
        depth = np.linspace(-2e-8, 1e-7, 2500)
        load = 1e4 * np.maximum(depth, 0) ** 1.5 + noise.normal(0, 2e-9, depth.size)
        np.savetxt(self.folder / "curve.csv", np.c_[depth, load], delimiter=",", header="approach,load", comments="")
        for kind in ("kind = 'power', exponent = 2.2, power_coefficient = 1e7", "kind = 'paraboloid', radius = 1e-6"):
            self.write(f"&job output = 'run.h5' /\n&surface {kind} /\n&data file = 'curve.csv', abscissa = 'approach', "
                       "ordinate = 'load', sigma = 2e-9 /\n&free variable = 'contact_modulus' /\n&free variable = 'contact_point' /\n")
            for threads in (1, 3):
                self.run_program("fit", "--quiet", "--force", "run.nml", "--output", f"{threads}.h5", threads=threads)
            self.assert_same(self.snapshot("1.h5"), self.snapshot("3.h5"))

    def test_doubts(self):
        """Each fitted curve has the doubt of its widest contact by JKR; tables of fits and of merged parts count them."""
        radius, stiffness = 8e-6, 0.05
        self.write(STACK.format(file=MAP).replace("radius = 5e-6", f"radius = {radius}"))
        table, _ = self.run_program("fit", "run.nml", "--output", "whole.h5")
        results = self.read("whole.h5")
        with h5py.File(MAP) as file:
            deepest = file["position"][()].max()
        modulus, work = results["contact_modulus"], results["work_of_adhesion"]

        def base(a):
            """Where the base of the spring is, from touch: approach and deflection."""
            pull = np.sqrt(8 * np.pi * work * modulus * a**3)
            load = 4 * modulus * a**3 / (3 * radius) - pull
            return a**2 / radius - np.sqrt(2 * np.pi * a * work / modulus) + load / stiffness

        # far beyond the fold, where the base goes forward with the contact
        low, high = np.full(modulus.shape, 0.2 * radius), np.full(modulus.shape, 2 * radius)
        for _ in range(60):
            middle = (low + high) / 2
            is_low = base(middle) < deepest - results["contact_point"]
            low, high = np.where(is_low, middle, low), np.where(is_low, high, middle)
        expected = np.where(results["status"] == 0, (low >= 0.5 * radius).astype(int), -1)
        np.testing.assert_array_equal(results["doubt"], expected)
        self.assertEqual(set(expected.ravel()), {-1, 0, 1})
        with h5py.File(self.folder / "whole.h5") as file:
            self.assertEqual(file["doubt"].attrs["flag_meanings"].split()[:3], ["no_value", "none", "contact_too_wide"])
        counted = rf"points beyond a bound of the theory\n  contact too wide +{(expected == 1).sum()}\n .* >= 0.5\n"
        self.assertRegex(table, counted)
        for number in (1, 2, 3):
            self.run_program("fit", "--quiet", "run.nml", "--shard", f"{number}/3")
        for options in ((), ("--virtual", "--force")):
            merged, _ = self.run_program("merge", "run.h5", *(f"run.part-{number:04}-of-0003.h5" for number in (1, 2, 3)), *options)
            self.assertRegex(merged, r"parts +3\npoints +144\n  fitted +141\n  too few points +3\n" + counted)

    def test_far_above(self):
        """Errors that are far too small, or a model that does not fit, are named with S and the degrees of freedom; fitting ones are not."""
        points = np.array([(-100, 100), (-50, 210), (0, 280), (50, 370), (100, 420), (150, 480), (200, 530), (300, 560)])
        for sigma, is_far in ((1.0, True), (25.0, False)):
            np.savetxt(self.folder / "tip.csv", np.c_[points, np.full(8, sigma)], delimiter=",", comments="",
                       header="load [nN],friction_force [nN],sigma [nN]")
            self.write("&job output = 'run.h5' /\n&data file = 'tip.csv', abscissa = 'load', ordinate = 'friction_force' /\n"
                       "&free variable = 'work_of_adhesion' /\n&free variable = 'shear_strength' /\n&adhesion theory = 'jkr' /\n"
                       "&surface kind = 'paraboloid', radius = 140e-9 /\n&solid contact_modulus = 44e9 /\n&operating state = 'sliding' /\n")
            table, _ = self.run_program("fit", "--force", "run.nml")
            results = self.read("run.h5")
            said = re.findall(r"warning: S = (\S+) is far above n = 6 degrees of freedom: .* too small, by (\S+) times", table)
            self.assertEqual(bool(said), is_far, table)
            for chi2, times in said:
                np.testing.assert_allclose([float(chi2), float(times)], [results["chi2"], np.sqrt(results["chi2"] / 6)], rtol=0.05)

    def test_abscissa_outside(self):
        """An abscissa that its variable does not take is named; points beyond from and to, and those without a number, are not used."""
        text = ("&job output = 'run.h5' /\n&surface kind = 'paraboloid', radius = 1e-3 /\n&data file = 'points.csv', abscissa = 'contact_radius', "
                "ordinate = 'load', sigma = 1e-6 /\n&free variable = 'contact_modulus' /\n")
        self.write("contact_radius (m),load (N)\n1e-5,1.3e-6\n2e-5,1.06e-5\n-3e-5,3.6e-5\nnan,1e-5\n4e-5,8.5e-5\n", "points.csv")
        self.write(text)
        _, errors = self.run_program("fit", "run.nml", status=2)
        self.assertEqual(errors.count("\n"), 1)
        self.assertIn("&data[1] file: points.csv: contact_radius is out of range at point 3, given -3e-5, allowed: a number >", errors)
        self.write(text.replace("1e-6 /", "1e-6, from = 0.0 /"))
        self.run_program("fit", "--quiet", "run.nml")
        with h5py.File(self.folder/"run.h5") as file:
            self.assertEqual(file["status"][()], 0)

    def test_one_curve(self):
        """A curve of the map alone, and all curves as one fit."""
        with h5py.File(MAP) as file, h5py.File(self.folder / "one.h5", "w") as one:
            for name in ("load", "contact"):
                one[name] = file[name][0, 0]
            one["position"] = file["position"][()]
        self.write(STACK.format(file="one.h5"))
        table, _ = self.run_program("fit", "run.nml")
        self.assertRegex(table, r"warning: half-width of contact over radius of the body is up to 0\.[5-9]\d?, the theory is off by a tenth")
        results = self.read("run.h5")
        self.assertEqual(int(results["doubt"]), 1)
        with h5py.File(MAP) as file:
            self.assertAlmostEqual(float(results["chi2"]), float(file["expected/chi2"][0, 0]), delta=CHI2)
        self.assertEqual(results["fitted"].shape, (100,))
        self.assertEqual(results["branch"].sum() > 0, True)

    def test_residuals(self):
        """The points of each curve, with residuals whose squares are S; the same bits in parts; nothing else changes."""
        plain = self.fit(STACK.format(file=MAP))
        text = STACK.format(file=MAP) + "&fit residuals = 'all' /\n"
        found = self.fit(text)
        self.assertEqual(set(found) - set(plain), {"abscissa", "ordinate", "fitted", "residual", "point"})
        for name in plain:
            np.testing.assert_array_equal(plain[name], found[name], err_msg=name)
        with h5py.File(MAP) as file:
            answered = found["status"] == 0
            self.assertEqual(int(answered.sum()), 141)
            np.testing.assert_array_equal(found["ordinate"][answered], file["load"][()][answered])
            np.testing.assert_array_equal(found["abscissa"][answered], np.broadcast_to(file["position"][()], (141, 100)))
        np.testing.assert_allclose((found["ordinate"] - found["fitted"])[answered] / 2e-10, found["residual"][answered], rtol=1e-9, atol=1e-9)
        np.testing.assert_allclose(np.sum(found["residual"][answered] ** 2, axis=-1), found["chi2"][answered], rtol=1e-9)
        self.assertTrue(np.all(np.isnan(found["residual"][~answered])))
        self.run_program("fit", "--quiet", "--force", "run.nml", "--output", "whole.h5")
        for part in ("1/2", "2/2"):
            self.run_program("fit", "--quiet", "run.nml", "--output", "parts.h5", "--shard", part)
        self.run_program("merge", "--quiet", "parts.h5", "parts.part-0001-of-0002.h5", "parts.part-0002-of-0002.h5")
        self.assert_same(self.snapshot("whole.h5"), self.snapshot("parts.h5"))
        twice = text + text[text.index("&data"):text.index("&free")]
        self.write(twice.replace("'contact_point'", "'data[1]%contact_point'").replace("'load_offset'", "'data[1]%load_offset'"))
        _, errors = self.run_program("fit", "run.nml", status=2)
        self.assertIn("&fit residuals: is 'all' beside several &data", errors)

    def test_together(self):
        with h5py.File(MAP) as file, h5py.File(self.folder / "two.h5", "w") as two:
            for name in ("load", "contact"):
                two[name] = np.stack([file[name][0, 0]] * 2)
            two["position"] = file["position"][()]
        each = self.fit(STACK.format(file="two.h5"))
        together = self.fit(STACK.format(file="two.h5") + "&fit curves = 'together' /\n")
        np.testing.assert_allclose(each["chi2"][0], each["chi2"][1], rtol=0)
        np.testing.assert_allclose(together["chi2"], 2 * each["chi2"][0], rtol=1e-8)
        np.testing.assert_allclose(together["contact_modulus_error"], each["contact_modulus_error"][0] / np.sqrt(2), rtol=1e-4)

    def test_shapes(self):
        """Columns of another shape, a missing one, and a unit of another quantity."""
        with h5py.File(self.folder / "bad.h5", "w") as bad:
            bad["load"] = np.zeros((3, 5))
            bad["position"] = np.zeros(4)
        self.write(STACK.format(file="bad.h5"))
        _, errors = self.run_program("fit", "run.nml", status=2)
        self.assertIn("&data[1] abscissa_column: bad.h5: the shape is not that of the ordinate, given 4, allowed: 3 x 5 or 5", errors)
        with h5py.File(self.folder / "bad.h5", "r+") as bad:
            del bad["position"]
        _, errors = self.run_program("fit", "run.nml", status=2)
        self.assertIn("there is no dataset /position in the file", errors)
        with h5py.File(self.folder / "bad.h5", "r+") as bad:
            bad["position"] = np.zeros(5)
            bad["position"].attrs["units"] = "N"
        _, errors = self.run_program("fit", "run.nml", status=2)
        self.assertIn("are of another quantity, allowed: units of [m]", errors)


class Variables(Fits):
    """Points with values of further variables: one fit of several curves."""

    HEAD = "&job output = 'run.h5' /\n&surface kind = '{kind}'{more} /\n&adhesion theory = 'jkr' /\n"
    DATA = "&data file = 'area.csv', abscissa = 'load', ordinate = 'contact_area', variables = 'radius' /\n"
    FREE = "&free variable = 'work_of_adhesion' /\n&free variable = 'contact_modulus' /\n"
    TRUE = {"work_of_adhesion": 0.05, "contact_modulus": 2e6}

    def points(self, radii=(5e-4, 1e-3, 3e-3), noise=0.0):
        """Areas of spheres of several radii: rows of radius, load, area and standard error."""
        self.write("&job output = 'true.h5' /\n&surface kind = 'paraboloid' /\n&solid contact_modulus = 2e6 /\n"
                   "&adhesion work_of_adhesion = 0.05, theory = 'jkr' /\n"
                   f"&sweep variable = 'radius', values = {', '.join(map(str, radii))} /\n"
                   "&sweep variable = 'load', from = -2e-5, to = 4e-4, count = 12 /\n")
        self.run_program("run", "--quiet", "run.nml")
        true = self.read("true.h5")
        area = np.ravel(true["contact_area"])
        sigma = 0.01*area
        rng = np.random.default_rng(11)
        radius, load = np.meshgrid(true["radius"], true["load"], indexing="ij")
        return np.column_stack([np.ravel(radius), np.ravel(load), area + noise*sigma*rng.standard_normal(area.size), sigma])

    def write_points(self, rows, head="radius,load,contact_area,sigma"):
        self.write(head + "\n" + "".join(",".join(repr(float(one)) for one in row) + "\n" for row in rows), "area.csv")

    def text(self, kind="paraboloid", data=None, more=""):
        return self.HEAD.format(kind=kind, more=more) + (data or self.DATA) + self.FREE

    def assert_alike(self, one, other, tolerance):
        for name in self.TRUE:
            for key in (name, f"{name}_error"):
                self.assertLess(abs(one[key]/other[key] - 1), tolerance, key)

    def test_radii(self):
        """Three radii in one file give the truth that none of them gives alone; the file repeats the column, and has each curve."""
        rows = self.points()
        self.write_points(rows)
        found = self.fit(self.text())
        self.assertEqual(int(found["status"]), 0)
        for name, true in self.TRUE.items():
            self.assertLess(abs(found[name]/true - 1), 1e-7)
        np.testing.assert_allclose(found["point_radius"], rows[:, 0], rtol=1e-14)
        np.testing.assert_allclose(found["fitted"], rows[:, 2], rtol=1e-6)
        self.assertEqual(set(found["curve_radius"]), {5e-4, 1e-3, 3e-3})
        # NaN between two curves, and nowhere else
        self.assertEqual(int(np.isnan(found["curve"]).sum()), 2)
        self.assertEqual(found["curve"].shape, found["curve_x"].shape)
        # as errors of a linear fit of the same points: J by differences of the model
        output, _ = self.run_program("check", "run.nml")
        for words in ("radius of each point, 5e-4 to 0.003 m", "3 curves"):
            self.assertIn(words, output)

    def test_errors(self):
        """Standard errors are those of the Jacobian of all curves together, here of power laws: areas of Hertz."""
        rng = np.random.default_rng(3)
        radius, load = np.repeat([1e-3, 4e-3], 10), np.tile(np.linspace(1e-4, 1e-3, 10), 2)
        area = np.pi*(0.75*load*radius/2e6)**(2/3)
        rows = np.column_stack([radius, load, area*(1 + 0.01*rng.standard_normal(20)), 0.01*area])
        self.write_points(rows)
        text = ("&job output = 'run.h5' /\n&surface kind = 'paraboloid' /\n" + self.DATA + "&free variable = 'contact_modulus' /\n")
        found = self.fit(text)
        # d ln A/d ln E = -2/3 of 20 points of 1 %
        self.assertLess(abs(found["contact_modulus_error"]/found["contact_modulus"]/(0.01*1.5/np.sqrt(20)) - 1), 0.02)
        self.assertEqual(int(found["degrees_of_freedom"]), 19)

    def test_one_value(self):
        """A column of one value is that value in its group; the order of the rows does not matter; a unit in a head is honoured."""
        rows = self.points(radii=(1e-3, 2e-3), noise=1.0)
        self.write_points(rows[:12])
        of_column = self.fit(self.text())
        of_group = self.fit(self.text(data=self.DATA.replace(", variables = 'radius'", ""), more=", radius = 1e-3"))
        self.assert_alike(of_column, of_group, 1e-9)
        self.assertEqual(of_column["chi2"], of_group["chi2"])
        self.write_points(rows)
        first = self.fit(self.text())
        self.write_points(np.random.default_rng(5).permutation(rows)*[1e3, 1, 1, 1], head="r [mm],load,contact_area,sigma")
        second = self.fit(self.text(data=self.DATA.replace("'radius' /", "'radius', variable_columns = 'r' /")))
        self.assert_alike(first, second, 1e-6)
        self.assertGreater(first["runs_p_value"], 1e-3)

    def test_hdf5(self):
        """One curve of an HDF5 file has further variables; a stack has none."""
        rows = self.points(noise=1.0)
        self.write_points(rows)
        first = self.fit(self.text())
        with h5py.File(self.folder/"area.h5", "w") as file:
            for name, column in zip(("radius", "load", "contact_area", "sigma"), rows.T):
                file[name] = column
            file["stack"] = np.tile(rows[:, 2], (2, 1))
        text = self.text(data=self.DATA.replace("area.csv", "area.h5:/contact_area"))
        self.assert_alike(first, self.fit(text), 1e-12)
        self.write(text.replace("h5:/contact_area", "h5:/stack"))
        _, errors = self.run_program("fit", "run.nml", status=2)
        self.assertIn("&data[1] variables: beside a stack of curves, given 2 curves in area.h5, allowed: one curve", errors)

    def test_refused(self):
        """One line for each mistake."""
        rows = self.points()
        self.write_points(rows)
        for old, new, words in (
                ("variables = 'radius'", "variables = 'radius', variable_columns = 'r'", "r"),
                ("variables = 'radius'", "variables = 'radiu'", "did you mean 'radius'"),
                ("variables = 'radius'", "variables = 'load'", "load is the abscissa, allowed: other variables"),
                ("variables = 'radius'", "variables = 'radius', 'radius'", "radius is named twice, allowed: once"),
                ("variables = 'radius'", "variables = 'theory'", "not a number"),
                ("variables = 'radius'", "variables = 'radius', variable_columns = 'a', 'b'", "given 2 for 1 variables, allowed: one for each"),
                ("kind = 'paraboloid'", "kind = 'paraboloid', radius = 1e-3", "radius is given twice, here and in &surface in line 2"),
                ("variables = 'radius'", "variables = 'contact_modulus'", "contact_modulus is a column of &data[1], it cannot be free"),
                ("&free", "&event kind = 'pull_off_load', value = -1e-4, sigma = 1e-6 /\n&free",
                 "the points of &data[1] have variables of their own, an event has none, allowed: a &data without variables")):
            self.write(self.text().replace(old, new, 1))
            _, errors = self.run_program("fit", "run.nml", status=2)
            self.assertIn(words, errors)
        rows[3, 0] = -1e-3
        self.write_points(rows)
        self.write(self.text())
        _, errors = self.run_program("fit", "run.nml", status=2)
        self.assertIn("radius is out of range at point 4, given -0.001, allowed: a number", errors)
        # a point without a value is left out
        rows[3, 0] = np.nan
        self.write_points(rows)
        self.assertEqual(int(self.fit(self.text())["points_used"]), 35)


class Interface(Fits):
    """The law of an interface from friction against velocity: what one temperature tells, and what it does not."""

    # the law that the table was computed with: ln tau_p, log10 v_p, c
    TRUE = np.log(1e6), -2.0, 0.1

    def text_of(self, temperature, pressure, more=""):
        """An input with the points of one temperature and one load of the table."""
        with open(SOURCE / "tests/reference/int_fit_synthetic_1.csv") as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
        points = [row for row in rows if row["temperature_K"] == temperature and float(row["mean_pressure_Pa"]) == pressure]
        lines = [f"{row['velocity_m_per_s']},{row['mu_noisy']},{0.02 * float(row['mu'])}" for row in points]
        self.assertEqual(len(lines), 9)
        self.write("\n".join(["velocity,friction_coefficient,sigma", *lines]) + "\n", "points.csv")
        text = (SOURCE / "inputs/fit_interface.nml").read_text()
        text = text.replace("283.15 ", f"{temperature} ").replace("mean_pressure = 4.0e5", f"mean_pressure = {pressure}")
        text = text.replace("'fit_interface.csv'", "'points.csv'").replace("'fit_interface.h5'", "'run.h5'")
        return text + more

    def test_one_temperature(self):
        """The errors are those that the spread of the velocities allows, and the law lies within them."""
        # of the temperature at which the maximum lies amid the velocities, and of one far from it
        expected = {"283.15": (0.010, 0.03, 0.005), "323.15": (0.041, 0.15, 0.0045)}
        for temperature, least in expected.items():
            found = self.fit(self.text_of(temperature, 4e5))
            self.assertEqual(found["status"], 0)
            names = "peak_shear_strength", "peak_velocity", "log_width_factor"
            strength, velocity, width = (float(found[name]) for name in names)
            of = [float(found[f"{name}_error"]) for name in names]
            errors = np.array([of[0] / strength, of[1] / velocity / np.log(10), of[2]])
            np.testing.assert_allclose(errors, least, rtol=0.1)
            offsets = (np.array([np.log(strength), np.log10(velocity), width]) - self.TRUE) / errors
            self.assertLess(np.abs(offsets).max(), 3.0)

    def test_four_temperatures(self):
        """Points of four temperatures and two loads in one file tell how the interface shifts, with the errors of its Jacobian."""
        with open(SOURCE / "tests/reference/int_fit_synthetic_1.csv") as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
        # one load at each temperature, and three velocities
        load_of = {"263.15": 2e5, "283.15": 8e5, "303.15": 2e5, "323.15": 8e5}
        rows = [row for row in rows if load_of[row["temperature_K"]] == float(row["mean_pressure_Pa"])
                and row["velocity_m_per_s"] in ("1e-05", "0.001", "0.1")]
        columns = "velocity_m_per_s", "temperature_K", "mean_pressure_Pa", "mu_noisy", "mu", "mu_hysteresis"
        velocity, temperature, pressure, noisy, mu, losses = (np.array([float(row[name]) for row in rows]) for name in columns)
        self.assertEqual(mu.size, 12)
        table = np.column_stack([velocity, temperature, pressure, noisy, 0.02*mu])
        self.write("velocity,temperature,mean_pressure,friction_coefficient,sigma\n" + "".join(",".join(map(repr, row)) + "\n" for row in table.tolist()),
                   "points.csv")
        text = (SOURCE / "inputs/fit_interface_all.nml").read_text()
        text = text.replace("fit_interface_all.csv", "points.csv").replace("fit_interface_all.h5", "run.h5")
        first = text.index("&free\n  variable = 'time_factor'")
        found = self.fit(text[:first] + text[text.index("&fit"):])
        self.assertEqual(int(found["status"]), 0)
        names = "peak_shear_strength", "peak_velocity", "log_width_factor", "wlf_c1"
        true = 1e6, 0.01, 0.1, 8.86
        for name, value in zip(names, true):
            self.assertLess(abs(found[name] - value), 3*found[f"{name}_error"], name)
        # the area of contact does not depend on the law, so the interface's part is proportional to the shear strength
        best = [float(found[name]) for name in names]
        scale = (temperature - 293.15)/(101.6 + temperature - 293.15)

        def part(strength, peak, width, c1):
            return strength*np.exp(-width*(np.log10(velocity/peak) - c1*scale)**2)

        area = (mu - losses)/part(*true)
        jacobian = np.empty((mu.size, 4))
        for k in range(4):
            moved = [value*(1 + (1e-6 if i == k else 0)) for i, value in enumerate(best)]
            jacobian[:, k] = area*(part(*moved) - part(*best))/(1e-6*best[k])/(0.02*mu)
        errors = np.sqrt(np.diag(np.linalg.inv(jacobian.T @ jacobian)))
        np.testing.assert_allclose([float(found[f"{name}_error"]) for name in names], errors, rtol=1e-3)

    def test_heat_is_warned_of(self):
        """Velocities at which heat changes the shear stress, with &heat and without; what does not depend on the temperature is not doubted."""
        text = self.text_of("283.15", 4e5)
        heat = "&heat conductivity = {}, density = 1e3, heat_capacity = 2e3, second_conductivity = 0.0 /\n"
        # of a polymer, and of a solid that conducts so well that no point is fast enough
        for more, found in (("", r"points.csv goes up to 0.1 m/s, and heat changes .* from (\S+) m/s on in a polymer of 0.2 W/m/K and 2e6 J"),
                            (heat.format(0.2), r"points.csv goes up to 0.1 m/s, and heat changes .* from (\S+) m/s on; what is fitted depends on &heat"),
                            (heat.format(1e4), None)):
            self.write(text + more)
            output, _ = self.run_program("check", "run.nml")
            warnings_ = [line for line in output.splitlines() if "heat changes" in line]
            self.assertEqual(len(warnings_), 0 if found is None else 1, output)
            if found is None:
                continue
            # at the start 2 tau v a s/(lambda sqrt(pi (4/pi + P))) is a hundredth there, s = |d ln tau/dT|, to the digits that are said
            least = float(re.search(found, warnings_[0])[1])
            tau, half_width = 5e5*np.exp(-0.2*np.log10(least/1e-3*self.shift(283.15))**2), 1e-3/4
            rise = 2*tau*least*half_width/(0.2*np.sqrt(np.pi*(4/np.pi + least*half_width/2e-7)))
            per_kelvin = abs(np.log(np.exp(-0.2*np.log10(least/1e-3*self.shift(283.16))**2)/np.exp(-0.2*np.log10(least/1e-3*self.shift(283.15))**2)))/0.01
            np.testing.assert_allclose(rise*per_kelvin, 0.01, rtol=0.15)
        self.write(text.replace("temperature = 283.15", "").replace("shift = 'wlf'", "shift = 'none'").replace(
            "reference_temperature = 293.15", "").replace("wlf_c1 = 8.86", "").replace("wlf_c2 = 101.6", ""))
        self.assertNotIn("heat changes", self.run_program("check", "run.nml")[0])

    @staticmethod
    def shift(temperature):
        """a_T of the input."""
        return 10**(-8.86*(temperature - 293.15)/(101.6 + temperature - 293.15))

    def test_shift_is_not_there(self):
        """With a shift of its own, one temperature does not tell velocity and activation energy apart: no answer, and it is said which."""
        text = self.text_of("283.15", 4e5, "&free variable = 'friction%activation_energy', start = 5.0e4 /\n")
        text = text.replace("law = 'log_gaussian' ", "law = 'log_gaussian', shift = 'arrhenius', reference_temperature = 293.15 ")
        self.write(text)
        output, _ = self.run_program("fit", "--force", "run.nml")
        self.assertEqual(self.read("run.h5")["status"], 3)
        self.assertIn("the data do not say what is free", output)
        self.assertRegex(output, r"not in the data +whatever changes together as .* ln peak_velocity .* ln friction%activation_energy")


class Refusals(Fits):
    """Mistakes in the input and in the data: one line, exit status 2, nothing written."""

    CASES = (
        ("ordinate = 'friction_force'", "ordinate = 'friction_forc'", "&data[1] ordinate: unknown result", "did you mean 'friction_force'?"),
        ("ordinate = 'friction_force'", "ordinate = 'theory_used'", "&data[1] ordinate: a state, or what is found by counting"),
        ("abscissa = 'load'", "abscissa = 'laod'", "&data[1] abscissa: unknown variable", "did you mean 'load'?"),
        ("abscissa = 'load'", "abscissa = 'theory'", "&data[1] abscissa: not a number"),
        ("abscissa = 'load'", "abscissa = 'radius'", "abscissa: radius is given twice, here and in &sphere"),
        ("abscissa = 'load', ", "", "&data[1] abscissa: not given, needed"),
        ("abscissa = 'load'", "abscissa = 'load', absissa_column = 'load'", "absissa_column: unknown variable", "did you mean 'abscissa_column'?"),
        ("abscissa = 'load'", "abscissa = 'load', abscissa_column = 'laod'", "abscissa_column: tip.csv: unknown column, given laod", "did you mean load?"),
        ("'tip.csv'", "'tap.csv'", "&data[1] file: tap.csv: cannot open the table"),
        ("'tip.csv'", "'tip.csv:/load'", "the file is no HDF5 file"),
        ("abscissa = 'load'", "abscissa = 'load', sigma = 1e-9, relative_sigma = 0.1", "relative_sigma: contradicts sigma"),
        ("abscissa = 'load'", "abscissa = 'load', sigma = -1", "&data[1] sigma: out of range, given -1"),
        ("abscissa = 'load'", "abscissa = 'load', from = 1, to = 0", "&data[1] to: no range"),
        ("abscissa = 'load'", "abscissa = 'load', from = 1", "&data[1] file: no point can be used, given 4 points in tip.csv, 1 of them without"),
        ("abscissa = 'load'", "abscissa = 'load', loss_width = 2", "loss_width: has no meaning"),
        ("abscissa = 'load'", "abscissa = 'load', tilt = 1", "&data[1] tilt: has no effect on friction_force against load"),
        ("variable = 'shear_strength'", "variable = 'tilt'", "tilt has no effect on friction_force against load"),
        ("abscissa = 'load'", "abscissa = 'load', loss = 'hubert'", "unknown choice", "did you mean 'huber'?"),
        ("abscissa = 'load'", "abscissa = 'load', sigma_column = '', loss = 'huber'", "loss: needs standard errors"),
        ("variable = 'shear_strength'", "variable = 'shear_strenth'", "&free[1] variable: unknown variable", "did you mean 'shear_strength'?"),
        ("variable = 'shear_strength'", "variable = 'radius'", "radius is given twice, here and in &sphere in line 3"),
        ("variable = 'shear_strength'", "variable = 'theory'", "no real number"),
        ("variable = 'shear_strength'", "variable = 'load'", "load is the abscissa of &data[1]"),
        ("variable = 'shear_strength'", "variable = 'data[2]%load_offset'", "no &data of this number"),
        ("variable = 'shear_strength'", "variable = 'data%load_ofset'", "unknown variable of a measurement", "did you mean 'load_offset'?"),
        ("variable = 'shear_strength'", "variable = 'shear_strength', start = -1", "&free[1] start: out of range, given -1"),
        ("variable = 'shear_strength'", "variable = 'shear_strength', start = 1e9, maximum = 1e8", "start: above the maximum"),
        ("variable = 'shear_strength'", "variable = 'shear_strength', minimum = 2, maximum = 1", "maximum: no range"),
        ("variable = 'shear_strength'", "variable = 'shear_strength', prior = 1e9", "prior_sigma: not given, needed: prior and prior_sigma together"),
        ("&free variable = 'shear_strength' /", "&free variable = 'shear_strength' /\n&free variable = 'shear_strength' /",
         "&free[2] variable: shear_strength is free twice"),
        ("&free variable = 'shear_strength' /", "", "&free: the group is missing"),
        ("&free variable = 'shear_strength' /", "&free variable = 'shear_strength' /\n&sweep variable = 'load', values = 1 /", "unknown group"),
        ("&free variable = 'shear_strength' /", "&free variable = 'shear_strength' /\n&event kind = 'pull_off', value = 1, sigma = 1 /",
         "&event[1] kind: unknown choice", "did you mean 'pull_off_load'?"),
        ("&free variable = 'shear_strength' /", "&free variable = 'shear_strength' /\n&event kind = 'pull_off_load', value = 1 /",
         "&event[1] sigma: not given"),
        ("&free variable = 'shear_strength' /", "&free variable = 'shear_strength' /\n&fit theories = 'jrk' /", "unknown theory", "did you mean 'jkr'?"),
        ("&free variable = 'shear_strength' /", "&free variable = 'shear_strength' /\n&fit levels = 0.95, 1.2 /", "&fit levels: out of range"),
        ("&free variable = 'shear_strength' /", "&free variable = 'shear_strength' /\n&output derivatives = 'load' /",
         "&output derivatives: has no place in a fit"),
        # what the data cannot say, whatever the noise
        ("&free variable = 'shear_strength' /", "&free variable = 'shear_strength' /\n&free variable = 'lateral_gain' /",
         "lateral_gain and shear_strength are one number"),
        ("&free variable = 'shear_strength' /", "&free variable = 'shear_strength' /\n&free variable = 'contact_point' /", "contact_point has no effect"),
        ("&free variable = 'shear_strength' /", "&free variable = 'shear_strength' /\n&free variable = 'lambda' /", "lambda has no meaning with theory = 'jkr'"),
    )

    def test_inputs(self):
        self.write(TABLE, "tip.csv")
        for old, new, *words in self.CASES:
            with self.subTest(new=new, words=words):
                self.assertIn(old, SMALL)
                self.write(SMALL.replace(old, new))
                process = self.start("fit", "run.nml")
                output, errors = process.communicate(timeout=60)
                self.assertEqual((process.returncode, output), (2, ""), errors)
                for word in words:
                    self.assertIn(word, errors)
                self.assertTrue(all(line.startswith("run.nml: ") for line in errors.splitlines()), errors)
                self.assertFalse((self.folder / "run.h5").exists())

    def test_modulus_and_strength(self):
        """The null vector 2 : 3 is known before anything is solved; a prior, or an area, mends it."""
        text = SMALL.replace(", contact_modulus = 44e9", "") + "&free variable = 'contact_modulus' /\n"
        self.write(TABLE, "tip.csv")
        self.write(text)
        _, errors = self.run_program("fit", "run.nml", status=2)
        self.assertIn("&free[2] variable: contact_modulus and shear_strength cannot both be known", errors)
        self.write(text.replace("variable = 'contact_modulus'", "variable = 'contact_modulus', prior = 44e9, prior_sigma = 0.1"))
        self.run_program("check", "--quiet", "run.nml")

    def test_tables(self):
        """Units, numbers, branches and errors of points."""
        self.write(SMALL)
        for table, words in ((TABLE.replace("load,", "load [nm],"), "of another quantity"),
                             (TABLE.replace("load,", "load [lbf],"), "are not known"),
                             (TABLE.replace("3.1e-7", "abc"), "column friction_force: not a number, given abc"),
                             (TABLE.replace("3.1e-7,3e-9", "3.1e-7,0"), "the standard error of the ordinate of point 2 is none"),
                             ("load,friction_force,contact\n1e-8,3e-7,2\n2e-8,3e-7,1\n", "the branch of point 1 is neither, given 2"),
                             ("load,friction_force,contact\n1e-8,3e-7,0\n2e-8,3e-7,0\n", "no point is in contact"),
                             ("load,friction_force\n1e-8,nan\n2e-8,\n", "no point can be used"),
                             ("load,friction_force\n1e-8,3e-7\n", "too few points, given 1"),
                             ("load,friction_force\n", "no rows")):
            with self.subTest(words=words):
                self.write(table, "tip.csv")
                _, errors = self.run_program("fit", "run.nml", status=2)
                self.assertTrue(errors.startswith("run.nml: &data[1] "), errors)
                self.assertIn(words, errors)

    def test_commands(self):
        """Each command has its inputs; a single fit has no parts."""
        self.write(TABLE, "tip.csv")
        self.write(SMALL)
        _, errors = self.run_program("run", "run.nml", status=2)
        self.assertIn("the input is that of a fit, needed: adfric fit run.nml", errors)
        _, errors = self.run_program("fit", "run.nml", "--shard", "1/2", status=2)
        self.assertIn("a single fit has no parts", errors)
        self.write("&job model = 'hertz', output = 'run.h5' /\n", "other.nml")
        _, errors = self.run_program("fit", "other.nml", status=2)
        self.assertIn("&data: the group is missing, the input is that of a run", errors)
        self.write(SMALL.replace("run.h5", "tip.csv"))
        _, errors = self.run_program("fit", "run.nml", status=2)
        self.assertIn("the results would replace the data", errors)

    def test_check(self):
        """Points, branches, starts and S at the start, and nothing written."""
        self.write(TABLE, "tip.csv")
        self.write(SMALL)
        output, _ = self.run_program("check", "run.nml")
        for words in ("friction_force against load", "3 of 4 points, 1 without a number", "a standard error for each point",
                      "free shear_strength", "S at the start", "fits                        1"):
            self.assertIn(words, output)
        self.assertEqual(self.names(), ["run.nml", "tip.csv"])

    def test_no_answer(self):
        """What the data do not see is found by the fit: exit status 1, the direction in words, no estimates."""
        self.write("&job model = 'wavy_sliding', output = 'run.h5' /\n&surface kind = 'wave_2d', period = 1e-4, height = 1e-5 /\n"
                   f"&operating load = 12 /\n&data file = '{SETS}/velocity_gm_a.csv', abscissa = 'velocity', ordinate = 'friction_force' /\n"
                   "&free variable = 'stiffness' /\n&free variable = 'relaxation_time' /\n&free variable = 'retardation_ratio' /\n")
        process = self.start("fit", "run.nml")
        output, errors = process.communicate(timeout=60)
        self.assertEqual((process.returncode, errors), (1, ""))
        self.assertIn("not in the data               whatever changes together as", output)
        results = self.read("run.h5")
        self.assertEqual(int(results["status"]), 3)
        self.assertTrue(np.isnan(results["stiffness"]))
        # the height of the peak has both, its place the time alone
        direction = np.abs(results["null_vector"]) > 1e-3
        self.assertEqual(direction.tolist(), [True, False, True])


if __name__ == "__main__":
    unittest.main()
