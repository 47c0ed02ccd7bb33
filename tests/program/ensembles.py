# SPDX-License-Identifier: GPL-3.0-or-later
"""Ensembles of seeds and theories beside them, in scenes and results files: what is there, that it is the same bits, and what is refused."""

import signal

import h5py
import numpy as np

from runs import Runs, main

SCENE = """&job output = 'run.h5' /
&surface kind = 'spectrum', length_x = 6.4e-6{surface} /
&power_spectrum hurst_exponent = 0.8, shortest_wavelength = 8e-7, rolloff_wavelength = 1.6e-6, longest_wavelength = 6.4e-6
                root_mean_square_slope = 0.1 /
&solid contact_modulus = 1e9 /
&numerics cells = {cells} /
"""
LOAD = "&operating mean_pressure = 4e6 /\n"
LOADS = "&sweep variable = 'mean_pressure', values = {values} /\n"
RISING, FALLING = "1e6, 2e6, 4e6, 8e6, 1.6e7, 3.2e7", "3.2e7, 1.6e7, 8e6, 4e6, 2e6, 1e6"
MAIN = ("contact_fraction", "mean_gap", "penetration", "peak_pressure", "elastic_energy")
SEVERAL = {f"{name}_{kind}" for name in MAIN for kind in ("spread", "error_of_mean")}


def scene(surface, cells=64):
    return SCENE.format(surface=surface, cells=cells)


class Ensembles(Runs):
    def solve(self, text, *options, threads=1):
        """All numbers of the file of a run."""
        self.write(text)
        self.run_program("run", "--quiet", "--force", "run.nml", *options, threads=threads)
        with h5py.File(self.folder/"run.h5") as file:
            return {key: item[()] for key, item in file.items() if isinstance(item, h5py.Dataset) and item.dtype.kind in "fi"}

    def test_one_seed(self):
        """One seed is the scene without `seeds`, to the bit and in what the file has; and spreads stand beside several."""
        single = self.solve(scene(", seed = 1") + LOAD)
        one = self.solve(scene(", seeds = 1") + LOAD)
        self.assertEqual(set(one) - set(single), {"seeds"})
        self.assertEqual(set(single) - set(one), {"seed"})
        for name in set(one) - {"seeds"}:
            np.testing.assert_array_equal(one[name], single[name], name)
        several = self.solve(scene(", seeds = 2") + LOAD)
        self.assertEqual(set(several) - set(one), SEVERAL | {"root_mean_square_slope", "root_mean_square_curvature", "nayak_parameter"} - set(one))
        self.assertIn("regime", one)
        self.assertNotIn("regime", several)

    def test_means(self):
        """Means and spreads are those over a sweep of the seed."""
        found = self.solve(scene(", seed = 4, seeds = 6") + LOADS.format(values="2e6, 8e6"))
        seeds = self.solve(scene("") + "&sweep variable = 'seed', from = 4, to = 9, count = 6 /\n" + LOADS.format(values="2e6, 8e6"))
        for name in MAIN:
            np.testing.assert_allclose(found[name], seeds[name].mean(axis=0), rtol=1e-13, err_msg=name)
            spread = seeds[name].std(axis=0, ddof=1)
            np.testing.assert_allclose(found[name + "_spread"], spread, rtol=1e-10, err_msg=name)
            np.testing.assert_allclose(found[name + "_error_of_mean"], spread/6**0.5, rtol=1e-10, err_msg=name)
        np.testing.assert_array_equal(found["error_estimate"], seeds["error_estimate"].max(axis=0))

    def test_order(self):
        """The bits do not depend on threads, order, and which points are solved together."""
        text = scene(", seeds = 3") + "&estimates theories = 'persson', 'nayak_sphere' /\n"
        whole = self.solve(text + LOADS.format(values=RISING))
        for values, threads in ((RISING, 2), (FALLING, 2)):
            other = self.solve(text + LOADS.format(values=values), threads=threads)
            for name in (*MAIN, *SEVERAL, "mean_gap_nayak_sphere", "contact_fraction_persson"):
                np.testing.assert_array_equal(other[name][::-1] if values == FALLING else other[name], whole[name], name)
        part = self.solve(text + LOADS.format(values="8e6"))
        for name in (*MAIN, *SEVERAL, "mean_gap_nayak_sphere"):
            np.testing.assert_array_equal(np.ravel(part[name]), whole[name][3:4], name)

    def test_number_of_seeds(self):
        """The number of seeds may be swept; one seed has no spread."""
        found = self.solve(scene("") + LOAD + "&sweep variable = 'seeds', values = 1, 2, 4 /\n")
        self.assertTrue(np.isnan(found["contact_fraction_spread"][0]))
        self.assertTrue(np.all(found["contact_fraction_spread"][1:] > 0))
        single = self.solve(scene(", seed = 1") + LOAD)
        self.assertEqual(found["contact_fraction"][0], single["contact_fraction"])

    def test_interruption(self):
        """A signal ends a run within an ensemble, and the run that goes on has the same bits."""
        text = scene(", seeds = 40", cells=128) + LOADS.format(values=RISING)
        whole = self.solve(text)
        (self.folder/"run.h5").unlink()
        process = self.start("run", "--quiet", "run.nml", threads=1)
        self.wait_for_points("run.h5.partial")
        process.send_signal(signal.SIGTERM)
        _, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 143, errors)
        self.assertRegex(errors, r"^run.nml: stopped by SIGTERM, [1-5] of 6 points are in run.h5.partial")
        self.run_program("run", "--quiet", "--resume", "run.nml", threads=1)
        with h5py.File(self.folder/"run.h5") as file:
            for name in (*MAIN, *SEVERAL):
                np.testing.assert_array_equal(file[name][()], whole[name], name)
        # a point of many seeds does not hold up the end
        self.write(scene(", seeds = 100000", cells=256) + LOAD)
        process = self.start("run", "--quiet", "--force", "run.nml", threads=1)
        self.wait_for("run.h5.partial")
        process.send_signal(signal.SIGTERM)
        _, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 143, errors)
        self.assertIn("0 of 1 points", errors)

    def test_theories(self):
        """The theories that are asked, and no others, stand in the file with the numbers of the scene without a seed."""
        asked = "persson", "yang_persson", "greenwood_williamson"
        found = self.solve(scene(", seeds = 2") + LOAD + f"&estimates theories = {', '.join(map(repr, asked))}, yang_persson_constant = 0.5 /\n")
        alone = self.solve(scene("").replace("&numerics cells = 64 /\n", "") .replace(", length_x = 6.4e-6", "") + LOAD
                           + "&estimates yang_persson_constant = 0.5 /\n")
        words = (*asked, "wang_mueser", "bush_gibson_thomas", "greenwood_elliptic", "nayak_sphere")
        of_theory = {name: max((word for word in words if name.endswith("_" + word)), key=len) for name in alone
                     if any(name.endswith("_" + word) for word in words)}
        self.assertEqual(len(of_theory), 32)
        for name, word in of_theory.items():
            self.assertEqual(name in found, word in asked, name)
            if word in asked:
                self.assertEqual(found[name], alone[name], name)
        with h5py.File(self.folder/"run.h5") as file:
            self.assertNotIn("theories", file)
        # words in one pair of quotes; each is one for itself
        for words in ("'persson, nayak_sphere'", "'persson nayak_sphere'", "\"nayak_sphere\" 'persson'"):
            found = self.solve(scene(", seed = 1") + LOAD + f"&estimates theories = {words} /\n")
            self.assertEqual(found["theories"], 1 + 64)
            self.assertEqual({name for name in found if name.startswith("contact_fraction_")},
                             {"contact_fraction_error", "contact_fraction_persson", "contact_fraction_nayak_sphere"})
            with h5py.File(self.folder/"run.h5") as file:
                self.assertEqual(file["theories"].attrs["flag_meanings"], "persson+nayak_sphere")
                self.assertEqual(list(file["theories"].attrs["flag_values"]), [65])

    def test_conductances(self):
        """Those of the theories are those of the scene without a seed; the error of a mean stiffness is weighted by stiffness."""
        conduct = "resistivity = 1.7e-8, second_resistivity = 2.2e-8, thermal_conductivity = 400.0, second_thermal_conductivity = 310.0"
        cells = scene("{}").replace("modulus = 1e9", f"modulus = 1e9, {conduct}")
        load = LOAD.replace("4e6", "1.3e8")
        words = "'persson', 'bush_gibson_thomas'"
        found = self.solve(cells.replace("{}", ", seed = 2, seeds = 2") + load + f"&estimates theories = {words} /\n")
        alone = self.solve(cells.replace("{}", "").replace("&numerics cells = 64 /\n", "").replace(", length_x = 6.4e-6", "") + load)
        for name in ("electrical_conductance", "thermal_conductance"):
            self.assertEqual({key for key in found if key.startswith(name + "_")}, {name + "_persson", name + "_bush_gibson_thomas"})
            self.assertEqual(found[name + "_persson"], alone[name + "_persson"])
        members = [self.solve(cells.replace("{}", f", seed = {seed}") + load) for seed in (2, 3)]
        errors, weights = (np.array([member[name] for member in members]) for name in ("stiffness_error", "electrical_conductance"))
        self.assertGreater(abs(np.diff(errors)), 0)
        self.assertAlmostEqual(found["stiffness_error"], np.sum(errors * weights) / np.sum(weights), delta=1e-12)

    def test_refusals(self):
        """What has no meaning is refused in a line."""
        persson = "&estimates theories = 'persson' /\n"
        adhesion = "&adhesion adhesion_stress = 1e6, adhesion_range = 1e-8 /\n"
        several = "&output profiles: are maps of one surface, and seeds make several"
        for text, message in (
                (scene(", seed = 1, seeds = 0") + LOAD, r"&surface seeds: out of range, given 0, allowed: an integer >= 1 and <= 100000 \(line 2\)"),
                (scene(", seed = 1, seeds = -3") + LOAD, "&surface seeds: out of range, given -3"),
                (scene(", seed = 1, seeds = 1.5") + LOAD, "&surface seeds: not an integer, given 1.5"),
                (scene(", seeds = 2") + LOAD + "&output profiles = .true. /\n", several),
                (scene(", seed = 1") + LOAD + "&output profiles = .true. /\n&sweep variable = 'seeds', values = 1, 2 /\n", several),
                (scene(", seeds = 2, seed = 2147483647") + LOAD, "&surface seeds: goes beyond the largest seed"),
                ("&surface kind = 'wave_1d', period = 1e-6, amplitude = 1e-8, seeds = 2 /\n&solid contact_modulus = 1e9 /\n" + LOAD,
                 "&surface seeds: unknown variable, allowed: .*; the nearest scene that has it is spectrum on an elastic half-space, pressed"),
                (scene(", seed = 1") + LOAD + persson.replace("'persson'", "'person'"), "&estimates theories: unknown choice, given 'person', "
                 "allowed: one or more of 'persson', .*; did you mean 'persson'"),
                (scene(", seed = 1") + LOAD + persson.replace("'persson'", "'persson', 'persson'"), "&estimates theories: given twice, 'persson'"),
                (scene(", seed = 1") + LOAD + persson.replace("'persson'", "2*'persson'"), "&estimates theories: given twice"),
                (scene(", seed = 1") + LOAD + persson.replace("'persson'", "''"), "&estimates theories: no word given"),
                (scene(", seed = 1") + LOAD + persson.replace("'persson'", "1"), "&estimates theories: not a text in quotes, given 1"),
                (scene(", seed = 1") + LOAD + adhesion + persson, "&estimates theories: stand beside adhesion"),
                (scene(", seed = 1").replace("contact_modulus = 1e9", "young_modulus = 1e9, poisson_ratio = 0.3, extent = 'layer', "
                                             "base = 'bonded', thickness = 1e-5") + LOAD + persson, "&estimates theories: are those of a half-space"),
                (scene(", seed = 1") + LOAD + persson.replace(" /", ", yang_persson_constant = 0.5 /"), "&estimates yang_persson_constant: unknown variable")):
            with self.subTest(message=message):
                self.write(text)
                _, errors = self.run_program("run", "--force", "run.nml", status=2)
                self.assertRegex(errors, rf"^run.nml: {message}[^\n]*\n$")


if __name__ == "__main__":
    main()
