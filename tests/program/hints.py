# SPDX-License-Identifier: GPL-3.0-or-later
"""What `adfric check`, `run` and `help` say to somebody who is new: warnings, hints, usual sizes, and no values without an effect."""

import os
import re
import subprocess
import sys
import unittest
from pathlib import Path

import h5py
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from runs import PROGRAM, Runs, main  # noqa: E402

ELASTIC = "&solid contact_modulus = 1e9, poisson_ratio = 0.3 /"
RUBBER = "&solid modulus = 1e6, moduli = 1e6, relaxation_times = 1e-3 /"
COULOMB = "&friction coulomb_coefficient = 0.3 /"
WAVE = "&surface kind = 'wave_1d', period = 1e-6, amplitude = 1e-8 /"
ROUND = "&surface kind = 'paraboloid', radius = 1e-6 /"
ELLIPSE = "&surface kind = 'ellipsoid', radius_1x = 1e-6, radius_1y = 2e-6 /"
CYLINDER = "&surface kind = 'cylinder', radius = 1e-3 /"
SLIDES = "more than mu P"
TWO_OF_THREE = "give two of work_of_adhesion, adhesion_stress and adhesion_range"


class Hints(Runs):
    def test_beyond_yield(self):
        """A point whose stress is not below the yield strength is doubted, one below is not."""
        for strength, doubt in ((1e12, 0), (1e3, 5)):
            self.write(f"&job output = 'y.h5' /\n{WAVE}\n&solid contact_modulus = 1e9, poisson_ratio = 0.3, yield_strength = {strength} /\n"
                       "&operating mean_pressure = 1e6 /\n&output largest_stresses = .true. /\n".replace("wave_1d", "wave_2d"))
            printed, _ = self.run_program("run", "--force", "run.nml")
            with h5py.File(self.folder/"y.h5") as file:
                self.assertEqual(doubt, int(file["doubt"][()].squeeze()))
                self.assertEqual(doubt == 5, file["yield_ratio"][()].squeeze() >= 1)
            self.assertEqual(doubt == 5, "beyond yield" in printed)

    def test_beyond_hardness(self):
        """A load that no surface carries is told before the run."""
        said = self.said(WAVE.replace("wave_1d", "wave_2d"), "&solid contact_modulus = 1e9, hardness = 1e7 /", "&operating mean_pressure = 1e7 /")
        self.assertIn("mean_pressure is not below the hardness", said)

    def test_lists_without_a_history(self):
        """Members of a list are known where the list is: what lacks is the history."""
        self.write("time,load\n0.1,1e-9\n0.2,2e-9\n0.3,1e-9\n", "t.csv")
        self.write(f"&job output = 'f.h5' /\n{ROUND}\n{RUBBER}\n&data file = 't.csv', abscissa = 'time', ordinate = 'load' /\n"
                   "&free variable = 'solid%moduli(1)' /\n")
        _, errors = self.run_program("check", "run.nml", status=2)
        self.assertNotIn("unknown variable", errors)

    def test_noise_of_a_fit(self):
        """Noise in the history of measured points is pointed out, unless it is smoothed."""
        times = np.linspace(1e-3, 0.4, 300)
        noise = 1e-8*np.random.default_rng(1).standard_normal(300)
        approach = 1e-6*(1 - abs(times/0.2 - 1)) + noise
        self.write("time,z,load\n" + "".join(f"{t},{z},{max(z, 0)**1.5}\n" for t, z in zip(times, approach)), "t.csv")
        fit = (f"&job output = 'f.h5' /\n{ROUND}\n&solid moduli = 1e6, relaxation_times = 0.1 /\n&data file = 't.csv', abscissa = 'time', "
               "ordinate = 'load', variables = 'approaches', variable_columns = 'z' /\n&free variable = 'modulus' /\n")
        for group, is_noisy in (("", True), ("&history smoothing = 5e-8 /\n", False)):
            self.write(fit + group)
            printed, _ = self.run_program("check", "run.nml")
            self.assertEqual(is_noisy, "warning: the list of the history turns" in printed)

    def said(self, *groups, command="check", status=0, name="run.nml"):
        """Both outputs of a command on an input of these groups."""
        self.write("\n".join(groups) + "\n", name)
        done = subprocess.run([PROGRAM, command, name], cwd=self.folder, env=dict(os.environ, OMP_NUM_THREADS="1"), text=True,
                              capture_output=True, timeout=120, check=False)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        return done.stdout + done.stderr

    def help(self, topic):
        return subprocess.run([PROGRAM, "help", topic], text=True, capture_output=True, timeout=60, check=True).stdout

    def results(self):
        with h5py.File(self.folder / "run.h5") as file:
            return {key: data[()] for key, data in file.items() if isinstance(data, h5py.Dataset)}

    def test_force_above_friction(self):
        """One rule for all contacts: a warning, and a point without equilibrium."""
        scenes = ((ROUND, ELASTIC, "load = 1e-6, tangential_force = {}", 0.3e-6),
                  (ELLIPSE, ELASTIC, "load = 1e-6, tangential_force = {}", 0.3e-6),
                  (CYLINDER, "&solid contact_modulus = 1e9 /", "load = 1.0, tangential_force = {}", 0.3),
                  (WAVE, "&solid contact_modulus = 1e9 /", "mean_pressure = 1e5, tangential_stress = {}", 3e4),
                  (WAVE.replace("wave_1d", "wave_2d"), ELASTIC, "mean_pressure = 1e5, tangential_stress = {}", 3e4))
        for surface, solid, operating, limit in scenes:
            for share, slides in ((0.999, False), (-0.999, False), (1.001, True), (-3.0, True)):
                groups = surface, solid, COULOMB, f"&operating {operating.format(share * limit)} /"
                for command in ("check", "run"):
                    if command == "run":
                        (self.folder / "run.h5").unlink(missing_ok=True)
                    text = self.said(*groups, command=command)
                    self.assertEqual(SLIDES in text, slides, text)
                self.assertEqual(self.results()["status"] == 1, slides)

    def test_force_of_a_path(self):
        for surface in (ROUND, ELLIPSE):
            for share, slides in ((0.999, False), (1.001, True)):
                (self.folder / "run.h5").unlink(missing_ok=True)
                text = self.said(surface, ELASTIC, COULOMB, f"&history loads = 1e-6, 1e-6, tangential_forces = 0, {share * 3e-7} /", command="run")
                self.assertEqual(f"N at step 2 is {SLIDES}" in text, slides, text)
                self.assertEqual(self.results()["status"] == 1, slides)

    def test_largest_share_of_a_sweep(self):
        """The share is that of the worst point, whether force, load and coefficient change apart or together."""
        apart = ROUND, ELASTIC, "&sweep variable = 'coulomb_coefficient', values = 0.5, 0.2 /", \
            "&sweep variable = 'load', values = 1e-6, 4e-6 /", "&sweep variable = 'tangential_force', values = 0, -1e-6 /"
        self.assertIn("hint: &operating tangential_force: more than mu P at some points, up to 5 times as much", self.said(*apart))
        everywhere = [text.replace("values = 0, -1e-6", "values = 3e-6, -1e-5") for text in apart]
        self.assertIn("warning: &operating tangential_force: more than mu P, up to 50 times as much", self.said(*everywhere))
        together = ROUND, ELASTIC, COULOMB, "&sweep variable = 'load', values = 1e-6, 4e-6 /", \
            "&sweep variable = 'tangential_force', values = {}, with = 'load' /"
        for values, words in (("2e-7, 1.1e-6", None), ("4e-7, 1e-7", "up to 1.33 times as much")):
            text = self.said(*together[:-1], together[-1].format(values))
            self.assertIn(words, text) if words else self.assertNotIn(SLIDES, text)

    def test_usual_sizes(self):
        """Help says which sizes a variable usually has; a value beyond them is warned of with the same numbers."""
        usual = re.search(r"usual sizes (\S+) to (\S+) Pa", self.help("contact_modulus"))
        warned = self.said(ROUND, "&solid contact_modulus = 1e-3 /", "&operating load = 1e-6 /")
        self.assertIn(f"usual are {usual[1]} to {usual[2]} Pa", warned)
        self.assertIn("usual sizes up to 6.3 rad", self.help("angle"))
        self.assertNotIn("usual", self.help("lambda"))

    def test_values_without_effect(self):
        """Defaults that change nothing are not shown; what is given, and what has an effect, is."""
        pressed = self.said(ROUND, "&solid contact_modulus = 1e9 /", "&operating load = 1e-6 /", "&adhesion work_of_adhesion = 0 /")
        for name in ("coefficient_1", "n_r", "interaction", "edge_fraction", "state"):
            self.assertNotRegex(pressed, rf"\n  {name}\b")
        cases = ((("&surface kind = 'polynomial', coefficient_2 = 1e6 /", "&adhesion work_of_adhesion = 0.1 /"), ("coefficient_1", "branch")),
                 ((ROUND, "&output profiles = .true., r_max = 1e-6 /"), ("n_r",)),
                 ((ROUND, "&friction shear_strength = 1e6 /", "&adhesion work_of_adhesion = 0.1, adhesion_stress = 1e8 /"),
                  ("edge_fraction", "interaction", "state", "branch", "theory")),
                 ((ROUND, "&friction shear_strength = 1e6, edge_fraction = 0.4 /"), ("edge_fraction", "state")))
        for groups, names in cases:
            text = self.said(*groups, "&solid contact_modulus = 1e9 /", "&operating load = 1e-6 /")
            for name in names:
                self.assertRegex(text, rf"\n  {name}\b")
        # whatever is not shown changes no digit
        plain = self.solved(ROUND, ELASTIC, COULOMB, "&operating load = 1e-6, tangential_force = 1e-7 /")
        full = self.solved(ROUND, ELASTIC, COULOMB, "&operating load = 1e-6, tangential_force = 1e-7 /", "&output n_r = 33 /")
        for name in ("contact_radius", "tangential_displacement", "stick_fraction"):
            self.assertEqual(plain[name], full[name])

    def solved(self, *groups):
        (self.folder / "run.h5").unlink(missing_ok=True)
        self.said(*groups, command="run")
        return self.results()

    def test_missing_of_three(self):
        """Where one of work, stress and range stands alone, two of the three are asked for."""
        for surface, operating in ((ROUND, "load = 1e-6"), (WAVE, "mean_pressure = 1e5")):
            for given in ("adhesion_range = 1e-9", "adhesion_stress = 1e7", *(("work_of_adhesion = 0.01",) if surface == WAVE else ())):
                text = self.said(surface, "&solid contact_modulus = 1e9 /", f"&adhesion {given} /", f"&operating {operating} /", status=2)
                self.assertIn(TWO_OF_THREE, text)
            text = self.said(surface, "&solid contact_modulus = 1e9 /", "&adhesion adhesion_range = 1e-9, adhesion_stress = 1e7 /",
                             f"&operating {operating} /")
            self.assertNotIn("give two", text)

    def test_sliding(self):
        """A hint for who wants friction, and for who asks a body to slide that has none."""
        hint = "&operating state = 'sliding' gives it"
        shear = ROUND, "&solid contact_modulus = 1e9 /", "&friction shear_strength = 1e6 /"
        self.assertIn(hint, self.said(*shear, "&operating load = 1e-6 /"))
        self.assertNotIn(hint, self.said(*shear, "&operating load = 1e-6, state = 'sliding' /"))
        self.assertNotIn(hint, self.said(*shear, "&operating load = 1e-6, state = 'static' /"))
        needs = "state = 'sliding' needs &friction shear_strength"
        for friction in ((), (COULOMB,)):
            self.assertIn(needs, self.said(ROUND, ELASTIC, *friction, "&operating load = 1e-6, state = 'sliding' /", status=2))

    def test_direction_of_zero(self):
        """Along x is what a scene does by itself: the same answer; another direction is refused where there is none."""
        scenes = ((WAVE, RUBBER, "mean_pressure = 1e5, velocity = 1e-3", ()),
                  (CYLINDER, RUBBER, "load = 10.0, velocity = 1e-3", ()),
                  (ROUND, ELASTIC, "load = 1e-6, tangential_force = 1e-7", (COULOMB,)),
                  (WAVE, "&solid contact_modulus = 1e9 /", "mean_pressure = 1e5, state = 'sliding'", ("&friction shear_strength = 1e4 /",)))
        for surface, solid, operating, others in scenes:
            plain = self.solved(surface, solid, *others, f"&operating {operating} /")
            with_zero = self.solved(surface, solid, *others, f"&operating {operating}, direction = 0 /")
            self.assertEqual(plain["status"], 0)
            self.assertEqual(with_zero.pop("direction"), 0)
            # a round contact has another solver that knows directions
            common = [name for name in plain if name in with_zero and plain[name].dtype.kind == "f" and name != "error_estimate"]
            self.assertGreater(len(common), 5)
            for name in common:
                np.testing.assert_allclose(plain[name], with_zero[name], rtol=1e-14, err_msg=name)
            text = self.said(surface, solid, *others, f"&operating {operating}, direction = 1.5707963267948966 /", status=2)
            self.assertIn("&operating direction", text)

    def test_master_curve_of_a_table(self):
        """Columns of a text with the names of the datasets, in any units; other heads are for scripts/import_surface."""
        omega = np.logspace(-2, 6, 33)
        storage, loss = 1e6 + 1e7 * omega**2 / (1e6 + omega**2), 1e7 * 1e3 * omega / (1e6 + omega**2)
        with h5py.File(self.folder / "curve.h5", "w") as file:
            for name, values, unit in (("omega", omega, "rad/s"), ("storage", storage, "Pa"), ("loss", loss, "Pa")):
                file[f"m/{name}"] = values
                file[f"m/{name}"].attrs["units"] = unit
        rows = np.column_stack([omega / (2 * np.pi), storage / 1e6, loss / 1e6])
        heads = "frequency [Hz],storage [MPa],loss [MPa]"
        np.savetxt(self.folder / "curve.csv", rows, delimiter=",", header=heads, comments="", fmt="%.17g")
        found = {}
        for name in ("curve.h5:/m", "curve.csv"):
            found[name] = self.solved(WAVE, f"&solid master_curve = '{name}' /", "&operating mean_pressure = 1e5, velocity = 1e-3 /")
            self.assertEqual(found[name]["status"], 0)
        for name in ("friction_coefficient", "contact_fraction"):
            np.testing.assert_allclose(found["curve.csv"][name], found["curve.h5:/m"][name], rtol=1e-12)
        self.assertIn("table                       curve.csv: columns between commas", self.said(
            WAVE, "&solid master_curve = 'curve.csv' /", "&operating mean_pressure = 1e5, velocity = 1e-3 /"))
        (self.folder / "curve.csv").write_text("f [Hz],E1 [MPa],E2 [MPa]\n1,1,0.1\n10,2,0.3\n")
        text = self.said(WAVE, "&solid master_curve = 'curve.csv' /", "&operating mean_pressure = 1e5, velocity = 1e-3 /", status=2)
        self.assertEqual(text.count("\n"), 1, text)
        self.assertIn("there is no column omega or frequency; scripts/import_surface curve.csv --master-curve", text)
        text = self.said(WAVE, "&solid master_curve = 'curve.csv:E1' /", "&operating mean_pressure = 1e5, velocity = 1e-3 /", status=2)
        self.assertIn("names a column, a group or a whole table is needed", text)


if __name__ == "__main__":
    main()
