# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes: the table of what can be solved, the language of inputs and results, and inputs of models written anew as scenes."""

import csv
import os
import re
import sys
import unittest
from pathlib import Path

import h5py
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from runs import Runs, main  # noqa: E402

sys.path.insert(0, str(Path(__file__).resolve().parents[2]/"scripts"))
from document_prose import LONGEST_LINE  # noqa: E402
from reference_pages import pages_of, read_variables  # noqa: E402

SOURCE = Path(os.environ["ADFRIC_SOURCE"])
OLD_INPUTS = SOURCE/"tests/old_inputs"
NAMES = SOURCE/"tests/reference/scene_names.csv"
# one of so many alike cases is tried where checks make programs slow to begin
EVERY = round(1/float(os.environ.get("ADFRIC_RANDOM_CASES", "1")))
# Sizes of each surface; the lists of round kinds are those of one body each.
SURFACES = {
    "sphere": "radius = 1e-3", "paraboloid": "radius = 1e-3", "cone": "slope = 0.1", "power": "exponent = 4.0, power_coefficient = 1e6",
    "flat_cone": "face_radius = 1e-5, slope = 0.1", "flat_paraboloid": "face_radius = 1e-5, radius = 1e-3",
    "rounded_punch": "face_radius = 1e-5, radius = 1e-3", "rounded_cone": "slope = 0.1, radius = 1e-3",
    "polynomial": "coefficient_2 = 500.0, coefficient_4 = 1e6", "flat_punch": "face_radius = 1e-5", "ellipsoid": "radius_1x = 1e-3, radius_1y = 2e-3", "cylinder": "radius = 1e-3",
    "line_punch": "face_half_width = 1e-5", "wedge": "slope = 0.1", "line_polynomial": "coefficient_2 = 500.0",
    "wave_1d": "period = 1e-4, amplitude = 1e-6", "wave_2d": "period = 1e-4, amplitude = 1e-6", "wave_product": "period = 1e-4, amplitude = 1e-6",
    "cosines": "period = 1e-4, amplitudes = 1e-6, 3e-7, phases = 0.0, 1.0", "profile": "heights = 'z.h5:/profile', length_x = 1e-4",
    "heights": "heights = 'z.h5:/map', length_x = 1e-4, length_y = 1e-4", "spectrum": ""}
# Results that take the sign of the velocity.
VECTORS = ("hysteretic_friction_stress", "interfacial_friction_stress", "friction_stress", "friction_force", "friction_coefficient", "contact_shift", "lateral_friction_stress", "full_contact_friction_stress",
           "friction_coefficient_persson", "friction_coefficient_yang_persson", "friction_coefficient_wang_mueser", "full_contact_friction_coefficient")
PERIODIC = ("wave_1d", "wave_2d", "wave_product", "cosines", "profile", "heights", "spectrum")
SPECTRUM = "&power_spectrum hurst_exponent = 0.8, shortest_wavelength = 1e-6, rolloff_wavelength = 1e-5, root_mean_square_slope = 0.1 /\n"
ELASTIC = "&solid young_modulus = 7.5e6, poisson_ratio = 0.5 /\n"
RELAXING = "&solid modulus = 1e7, moduli = 9e7, relaxation_times = 1e-3{more} /\n"
LAYER = RELAXING.format(more=", extent = 'layer', thickness = 1e-4, base = 'frictionless'")
ON_LAYER = ELASTIC.replace(" /", ", extent = 'layer', thickness = 1e-4, base = 'bonded' /")
COATING = ELASTIC.replace(" /", ", extent = 'coating', thickness = 1e-5, base_young_modulus = 1e9, base_poisson_ratio = 0.3 /")
COLUMNS = "&solid extent = 'foundation', stiffness = 1e11, relaxation_time = 1e-4, retardation_ratio = 10.0 /\n"
ADHESION = "&adhesion work_of_adhesion = 0.05, adhesion_stress = 1e6 /\n"
LIGHT = "&adhesion work_of_adhesion = 1e-4, adhesion_stress = 1e3 /\n"


# the kind of scene in each column of the table
KINDS = (1, 2, 3, 4, 5, 22, 6, 15, 16, 21, 17, 18, 19, 20, 13, 14, 7, 11, 8, 12, 9, 10)


def scene_of(surface, kind):
    """An input for a surface in a kind of scene."""
    load = "mean_pressure = 5e4" if surface in PERIODIC else "load = 1e-3"
    force = "tangential_stress = 1e3" if surface in PERIODIC else "tangential_force = 1e-6"
    sliding = "" if surface in PERIODIC else ", state = 'sliding'"
    adhesion = LIGHT if surface in PERIODIC else ADHESION
    path = "mean_pressures = 0.0, 5e4, 5e4" if surface in PERIODIC else "approaches = 0.0, 1e-6, 0.0"
    rest = {1: ELASTIC + f"&operating {load} /\n",
            2: ELASTIC + adhesion + f"&operating {load} /\n",
            3: ELASTIC + f"&friction shear_strength = 1e5 /\n&operating {load}{sliding} /\n",
            4: ELASTIC + adhesion + f"&friction shear_strength = 1e5 /\n&operating {load}{sliding} /\n",
            5: ELASTIC + f"&friction coulomb_coefficient = 0.3 /\n&operating {load}, {force} /\n",
            6: ELASTIC + "&friction coulomb_coefficient = 0.3 /\n&history loads = 1e-3, 1e-3, 1e-3, tangential_forces = 1e-4, -1e-4, 0.0 /\n",
            22: ELASTIC + f"&friction coulomb_coefficient = 0.3 /\n&operating {load}, {force}, state = 'rolling' /\n",
            15: ELASTIC + adhesion + f"&history {path} /\n",
            16: ELASTIC.replace(" /", ", boundaries = 'free' /") + "&operating load = 1e-5 /\n",
            17: ON_LAYER + f"&operating {load} /\n", 18: ON_LAYER + adhesion + f"&operating {load} /\n",
            19: COATING + f"&operating {load} /\n", 20: COATING + adhesion + f"&operating {load} /\n",
            21: ELASTIC.replace(" /", ", boundaries = 'free' /") + adhesion + "&operating load = 1e-5 /\n",
            7: RELAXING.format(more="") + f"&operating {load}, velocity = 0.01 /\n",
            8: LAYER + f"&operating {load}, velocity = 0.01 /\n",
            9: COLUMNS + f"&operating {load}, velocity = 0.01 /\n",
            10: COLUMNS + adhesion + f"&operating {load}, velocity = 0.01 /\n",
            11: RELAXING.format(more="") + adhesion + f"&operating {load}, velocity = 0.01 /\n",
            12: LAYER + adhesion + f"&operating {load}, velocity = 0.01 /\n",
            13: RELAXING.format(more="") + f"&history times = 0.0, 1.0, 3.0, {path} /\n",
            14: RELAXING.format(more="") + ADHESION.replace("1e6", "1e5") + "&history times = 0.0, 1.0, 3.0, approaches = 0.0, 1e-6, 0.0 /\n"}[kind]
    cells = "&numerics cells = 64 /\n" if surface == "wave_2d" or surface in PERIODIC and kind in (8, 12) and surface not in ("profile", "heights", "spectrum") else ""
    if surface == "spectrum" and kind not in (1, 2, 7):
        return f"&job output = 'run.h5' /\n&surface kind = 'spectrum', length_x = 1e-5, seed = 1 /\n{SPECTRUM}{rest}&numerics cells = 64 /\n"
    if surface == "spectrum":
        rest = SPECTRUM + (rest.replace(f"&operating {load} /\n", "") if "&adhesion" in rest else rest)
    return f"&job output = 'run.h5' /\n&surface kind = '{surface}'{', ' if SURFACES[surface] else ''}{SURFACES[surface]} /\n{rest}{cells}"


def results_of(name):
    """The results of each point, by their names, and the name of the solver."""
    with h5py.File(name) as file:
        shape = file["status"].shape
        return {key: item[()] for key, item in file.items()
                if isinstance(item, h5py.Dataset) and item.shape == shape and "flag_meanings" not in item.attrs}, file.attrs["model"]


class Scenes(Runs):
    def setUp(self):
        super().setUp()
        x = np.arange(32)*2*np.pi/32
        with h5py.File(self.folder/"z.h5", "w") as file:
            file["profile"] = 1e-6*np.cos(x) + 2e-7*np.cos(3*x + 1)
            file["map"] = 1e-6*np.cos(x)[:, None]*np.cos(x) + 2e-7*np.cos(3*x + 1)

    def table(self):
        """The cells of `adfric help scenes`: surface, column, letter."""
        page, _ = self.run_program("help", "scenes")
        rows = [line.split() for line in page.splitlines() if line.split()[:1] and line.split()[0] in SURFACES
                and len(line.split()) == 1 + len(KINDS) and set(line.split()[1:]) <= set("ent-")]
        self.assertEqual([row[0] for row in rows], list(SURFACES))
        return [(row[0], column, letter) for row in rows for column, letter in enumerate(row[1:], 1)]

    def test_every_cell(self):
        """What the table promises is solved, and what it does not is refused with the group that stands in the way."""
        cells = self.table()
        self.assertGreater(sum(letter == "e" for _, _, letter in cells), 80)
        for surface, column, letter in cells[::EVERY]:
            with self.subTest(surface=surface, column=column):
                self.write(scene_of(surface, KINDS[column - 1]))
                if letter == "-":
                    _, errors = self.run_program("run", "--quiet", "--force", "run.nml", status=2)
                    self.assertRegex(errors, r"run.nml: &\w+: nothing solves .*; the nearest scene that can be solved is .* \(adfric help scenes\)")
                else:
                    self.run_program("run", "--quiet", "--force", "run.nml")
                    with h5py.File(self.folder/"run.h5") as file:
                        self.assertTrue(np.all(file["status"][()] == 0), f"{surface}, {column}")
                        self.assertNotIn("-", file)

    def test_variable_of_another_scene(self):
        """A variable that this scene does not have is refused with the nearest scene that has it."""
        self.write(scene_of("wave_1d", 11).replace("work_of_adhesion", "work_map = 'map.h5:/work', work_of_adhesion"))
        _, errors = self.run_program("run", "run.nml", status=2)
        self.assertRegex(errors, r"^run.nml: &adhesion work_map: unknown variable, allowed: .*; the nearest scene that has it is wave_1d on an elastic "
                         r"half-space with adhesion, pressed \(line \d\)\n$")

    def test_spectrum_beside_what_it_has_not(self):
        """A law of attraction leads from theories to a surface that is drawn, and a pressure beside adhesion is refused at any size."""
        text = scene_of("spectrum", 2)
        self.write(text.replace("work_of_adhesion", "law = 'exponential', work_of_adhesion").replace("'spectrum' /", "'spectrum', length_x = 1e-5 /")
                   + "&operating mean_pressure = 5e4 /\n")
        _, errors = self.run_program("run", "run.nml", status=2)
        self.assertIn("&surface seed: is missing [-]; cells have a surface that a seed draws from the spectrum", errors)
        for pressure in "0.0", "1e5":
            self.write(f"{text}\n&operating mean_pressure = {pressure} /\n")
            _, errors = self.run_program("run", "run.nml", status=2)
            self.assertIn("mean_pressure: stands beside adhesion, whose theories give pull-off alone", errors)

    def test_seeds(self):
        """A seed is one surface for any number of threads, in any order, and among other seeds."""
        text = f"&job output = 'run.h5' /\n&surface kind = 'spectrum', length_x = 1e-5 /\n{SPECTRUM}{ELASTIC}&numerics cells = 64 /\n"
        found = []
        for seeds, threads in (("1, 2, 3, 4, 5, 6", 1), ("1, 2, 3, 4, 5, 6", 2), ("6, 5, 4, 3, 2, 1", 2), ("2, 6", 1)):
            self.write(text + f"&sweep variable = 'seed', values = {seeds} /\n&sweep variable = 'mean_pressure', values = 2e4, 6e4 /\n")
            self.run_program("run", "--quiet", "--force", "run.nml", threads=threads)
            found.append(results_of(self.folder/"run.h5")[0])
        for name, expected in found[0].items():
            np.testing.assert_array_equal(found[1][name], expected, name)
            np.testing.assert_array_equal(found[2][name][::-1], expected, name)
            np.testing.assert_array_equal(found[3][name], expected[[1, 5]], name)
        self.assertGreater(np.ptp(found[0]["contact_fraction"][:, 0]), 1e-3)

    def test_said_once(self):
        """What both the scene and its solver read is wrong once."""
        self.write(scene_of("paraboloid", 2).replace("&job", "&job units = 'reduced' x,"))
        _, errors = self.run_program("run", "run.nml", status=2)
        lines = errors.splitlines()
        self.assertIn("&job units", errors)
        self.assertEqual(len(set(lines)), len(lines))

    def test_readme(self):
        """README shows the same cells in four tables; surfaces with the same cells share a row, as far as a line of the page allows."""
        words = {"exact": "e", "numerical": "n", "theory": "t", "": "-"}
        section = re.search(r"^## What can be solved\n(.*?)^## ", (SOURCE/"README.md").read_text(), re.MULTILINE | re.DOTALL)[1]
        shown, first = [], 1
        for head, body in re.findall(r"^(\| surface \|.*\|)\n\|[ |-]+\n((?:\|.*\n)+)", section, re.MULTILINE):
            rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in body.splitlines()]
            columns = len(head.strip("|").split("|")) - 1
            self.assertEqual({1 + columns}, {len(row) for row in rows})
            shown += [(name.strip("`"), column, words[cell]) for row in rows for name in row[0].split(", ")
                      for column, cell in enumerate(row[1:], first) if cell]
            alike = [f"{row[0]}, {line}" for row in rows for other, line in zip(rows, body.splitlines()) if other is not row and other[1:] == row[1:]]
            self.assertEqual([], [line for line in alike if len(line) <= LONGEST_LINE])
            first += columns
        self.assertEqual(sorted(shown), sorted(cell for cell in self.table() if cell[2] != "-"))
        self.assertEqual(first, 1 + len(KINDS))

    def test_reference_pages(self):
        """The written pages of docs/reference say what the program, the header, the docstrings and the comments say."""
        pages = pages_of(lambda topic: self.run_program("help", *topic.split())[0])
        for file, text in pages.items():
            self.assertEqual((SOURCE/file).read_text(), text, f"{file}: scripts/reference_pages.py")
        # every call of the header, every name of the package, every public procedure and every solver has an entry
        for file, pattern, source in (("c_functions", r"^(?:int|\}) (adfric_\w+)[(;]", "include/adfric.h"), ("python_functions", r"^def (sphere_\w+|strip_\w+)", "python/adfric/contacts.py"),
                                      ("fortran_procedures", r"^   (?:pure |elemental |impure )*subroutine (open_\w+|solve_\w+)\(", "src/api/api.f90")):
            found = re.findall(pattern, (SOURCE/source).read_text(), re.MULTILINE)
            self.assertTrue(found, source)
            self.assertEqual([], [name for name in found if not re.search(rf"^##.*\b{name}`", pages[f"docs/reference/{file}.md"], re.MULTILINE)])
        self.assertEqual(13, len(re.findall(r"^\| -?\d \| ", pages["docs/reference/status.md"].split("## Status of a point")[1], re.MULTILINE)))
        self.assertEqual([], re.findall(r"^- `\w+`:.*$", pages["docs/reference/results.md"], re.MULTILINE))
        page, _ = self.run_program("help", "scenes")
        names = [name for _, variables in read_variables(page) for name, _, _ in variables]
        self.assertGreater(len(names), 150)
        with open(NAMES, newline="") as file:
            rows = csv.DictReader(line for line in file if not line.startswith("#"))
            self.assertEqual(set(), {row["new_name"] for row in rows if row["kind"] == "input"} - {*names, "", "-", "units"})

    def test_inputs_of_models(self):
        """Every input of version 0.2, which names a model, is written anew as a scene, and the results have the same bits."""
        with open(NAMES, newline="") as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
        new_names = {}
        for row in rows:
            if row["kind"] == "result":
                new_names.setdefault((row["model"], row["old_name"]), []).append(row["new_name"])
        n_compared = 0
        for path in sorted(OLD_INPUTS.glob("*.nml"))[::EVERY]:
            text = short(path.read_text())
            if re.search(r"'[\w/]+\.h5:", text) or "&data" in text or "&refine" in text or "&uncertain" in text or "model =" not in text:
                continue
            with self.subTest(path.name):
                n_compared += self.compare(text, new_names)
        self.assertGreater(n_compared, 600//(2*EVERY - 1))

    def test_shipped_inputs(self):
        """The shipped inputs are those of version 0.2, written anew; but for comments, and for data that count otherwise."""
        names = [path.name for path in OLD_INPUTS.glob("*.nml") if path.name != "fit_velocity.nml"]
        self.assertGreater(len(names), 90)
        for name in sorted(names)[::EVERY]:
            scene, _ = self.run_program("modernise", str(OLD_INPUTS/name))
            self.assertEqual(bare(scene), bare((SOURCE/"inputs"/name).read_text()), name)

    def compare(self, text, new_names):
        """Number of results that an input and its scene have in common, all with the same bits or over the nominal area."""
        self.write(re.sub(r"output = '[^']*'", "output = 'old.h5'", text), "old.nml")
        scene, _ = self.run_program("modernise", "old.nml")
        self.write(scene.replace("'old.h5'", "'new.h5'"), "new.nml")
        self.assertNotIn("model =", scene)
        for name in ("old", "new"):
            self.run_program("run", "--quiet", "--force", f"{name}.nml")
        # a scene stays as it is
        self.assertEqual(self.run_program("modernise", "new.nml")[0], (self.folder/"new.nml").read_text())
        old, model = results_of(self.folder/"old.h5")
        new, solver = results_of(self.folder/"new.h5")
        self.assertEqual(model, solver)
        n = 0
        size = None
        for name, values in new.items():
            sources = [key for key in old if name in new_names.get((model, key), [key])]
            same = [key for key in sources if np.array_equal(old[key], values, equal_nan=True)]
            if same or not sources or name == "friction_force":
                n += len(same)
                continue
            # a result of a period, over its nominal size, which is one number
            with np.errstate(all="ignore"):
                ratios = old[sources[0]]/values
            ratios = ratios[np.isfinite(ratios)]
            self.assertGreater(len(ratios), 0, name)
            size = ratios[0] if size is None else size
            np.testing.assert_allclose(ratios, size, rtol=1e-15, err_msg=name)
            n += 1
        self.assertGreater(n, 0)
        # nothing that varies is lost, whatever its name
        for name, values in old.items():
            finite = values[np.isfinite(values)] if values.dtype.kind == "f" else np.zeros(1)
            # the radius of friction is that of contact where nothing rubs
            if finite.size > 1 and np.ptp(finite) > 0 and (name != "friction_radius" or "shear_strength" in scene):
                self.assertTrue(any(proportional(values, other) for other in new.values()), f"{name} is lost")
        return n

    def test_mixture(self):
        """Names of a model in a scene, and groups of scenes beside a model: each is told what the other language has."""
        scene = scene_of("wave_1d", 9)
        for old, new, message in (
                ("amplitude = 1e-6", "height = 2e-6", r"&surface height: is a name of the model 'wavy_sliding'; in a scene it is &surface amplitude"),
                ("&solid extent", "&foundation stiffness = 1.0 /\n&solid extent", r"&foundation: is a group of the model 'wavy_sliding'; a scene has"),
                ("&job output", "&job model = 'sphere', output", r"&solid: is a group of scenes, and &job names the model 'sphere'"),
                ("'wave_1d'", "'wave_id'", r"&surface kind: unknown word, given 'wave_id', allowed: .*; did you mean 'wave_1d'\?"),
                ("kind = 'wave_1d', ", "", r"&surface kind: is missing, one of sphere, paraboloid"),
                ("'foundation'", "'foundations'", r"&solid extent: unknown word"),
                ("&job output", "&job solver = 'sphere', output", r"&job solver: sphere does not solve wave_1d on a foundation, sliding")):
            self.assertIn(old, scene)
            self.write(scene.replace(old, new))
            process = self.start("check", "run.nml")
            output, errors = process.communicate(timeout=60)
            self.assertEqual((process.returncode, output), (2, ""))
            self.assertRegex(errors, message)
        # the old name of what would make it another scene
        self.write(scene_of("cylinder", 5).replace("coulomb_coefficient", "coefficient"))
        _, errors = self.run_program("check", "run.nml", status=2)
        self.assertIn("; in a scene it is &friction coulomb_coefficient", errors)
        # what has no meaning is not offered
        self.write(scene_of("cylinder", 1) + "&sweep variable = 'depth', values = 1.0 /\n")
        _, errors = self.run_program("check", "run.nml", status=2)
        self.assertIn("allowed: radius, ", errors)
        self.assertNotIn(" -,", errors)

    def test_fit_without_work(self):
        """A fit of a sphere asks for the work of adhesion, and does not take it from stress and range."""
        self.write("load,friction_force\n0,1e-8\n1e-8,2e-8\n2e-8,3e-8\n3e-8,4e-8\n", "tip.csv")
        self.write("&surface kind = 'paraboloid', radius = 140e-9 /\n&solid contact_modulus = 44e9 /\n&operating state = 'sliding' /\n"
                   "&adhesion theory = 'maugis_dugdale', adhesion_range = 0.3e-9 /\n&free variable = 'adhesion_stress' /\n"
                   "&free variable = 'shear_strength' /\n&data file = 'tip.csv', abscissa = 'load', ordinate = 'friction_force' /\n")
        _, errors = self.run_program("fit", "run.nml", status=2)
        self.assertIn("&adhesion work_of_adhesion: is missing [J/m^2]; a fit takes it with", errors)

    def test_depths(self):
        """z is the depth of loads on a half-plane, in names, axes and texts."""
        self.write("&job output = 'run.h5' /\n&traction kind = 'strip', pressure = 1e6, half_width = 1e-3, distribution = 'uniform' /\n"
                   + ELASTIC + "&output profiles = .true., x_max = 1e-3, n_x = 3, z_min = 1e-4, z_max = 1e-3, n_z = 4 /\n"
                   "&position position_z = 1e-3 /\n")
        self.run_program("run", "--quiet", "run.nml")
        with h5py.File(self.folder/"run.h5") as file:
            self.assertEqual(file["stress_zz_map"].shape, (4, 3))
            self.assertEqual([scale.name for dimension in file["stress_zz_map"].dims for scale in dimension.values()], ["/z", "/x"])
            self.assertIn(b"s_zz", np.bytes_(file["stress_zz"].attrs["long_name"]))

    def test_solver(self):
        """check says which solver answers; several may know a scene, and one of them can be asked for."""
        scene = scene_of("paraboloid", 1)
        peaks = {}
        for solver, more in (("indenter", ""), ("hertz", ", solver = 'hertz'")):
            self.write(scene.replace("&job output", f"&job{more[1:] + ',' if more else ''} output"))
            output, _ = self.run_program("check", "run.nml")
            self.assertRegex(output, r"scene +paraboloid on an elastic half-space, pressed\nsolver +" + solver + ", exact\n")
            self.run_program("run", "--quiet", "--force", "run.nml")
            peaks[solver] = results_of(self.folder/"run.h5")[0]
        self.assertNotIn("peak_pressure", peaks["indenter"])
        for name in ("contact_radius", "approach", "mean_contact_pressure"):
            np.testing.assert_allclose(peaks["hertz"][name], peaks["indenter"][name], rtol=1e-14, err_msg=name)

    def test_sweeps(self):
        """A swept variable counts as given, with its group or without."""
        for name in ("work_of_adhesion", "adhesion%work_of_adhesion"):
            self.write(scene_of("sphere", 1) + f"&adhesion adhesion_stress = 1e6 /\n&sweep variable = '{name}', values = 0.01, 0.05 /\n")
            output, _ = self.run_program("check", "run.nml")
            self.assertIn("sphere on an elastic half-space with adhesion, pressed", output)
            self.run_program("run", "--quiet", "--force", "run.nml")
            self.assertIn("pull_off_load", results_of(self.folder/"run.h5")[0])

    def test_without_a_range(self):
        """Adhesion by its work alone is that of JKR: pull-off at 3/2 pi w R."""
        self.write(scene_of("paraboloid", 1).replace("&operating load = 1e-3", "&adhesion work_of_adhesion = 0.05 /\n&operating load = 0.0"))
        self.run_program("run", "--quiet", "run.nml")
        results, solver = results_of(self.folder/"run.h5")
        self.assertEqual(solver, "sphere")
        np.testing.assert_allclose(results["pull_off_load"], -1.5*np.pi*0.05*1e-3, rtol=1e-14)

    def test_lambda(self):
        """Without a range there is no lambda, whatever the units are; with one it is derived."""
        tip = "&job output = 'run.h5' /\n&surface kind = 'paraboloid', radius = 1e-6 /\n&solid contact_modulus = 1e9 /\n&operating load = 0.0 /\n"
        for adhesion, count in (("work_of_adhesion = 0.05", 0), ("work_of_adhesion = 0.05, adhesion_range = 3e-10", 1)):
            self.write(f"{tip}&adhesion {adhesion} /\n")
            page, _ = self.run_program("check", "run.nml")
            self.assertEqual(count, len(re.findall(r"^  lambda .*Maugis", page, re.MULTILINE)), page)

    def test_nominal_area(self):
        """A mean pressure that is given is that of the results, however the ends of heights are brought together."""
        for surface in ("profile", "heights"):
            for ends in ("", "periodise = 'none'", "periodise = 'blend', blend_fraction = 0.2", "periodise = 'mirror'", "periodise = 'taper'"):
                scene = scene_of(surface, 9).replace("length_x", f"{ends + ', ' if ends else ''}length_x")
                self.write(scene)
                self.run_program("run", "--quiet", "--force", "run.nml")
                with h5py.File(self.folder/"run.h5") as file:
                    np.testing.assert_allclose(file["mean_pressure"][()], 5e4, rtol=1e-12, err_msg=f"{surface}, {ends}")

    def test_any_case(self):
        """Capitals do not count, and columns of a table have to be named."""
        names = []
        for name in ("velocity", "Velocity", "Operating%VELOCITY"):
            scene = scene_of("wave_1d", 7).replace(", velocity = 0.01", "") + f"&sweep variable = '{name}', values = 0.01, 0.1 /\n"
            self.write(scene)
            self.run_program("run", "--quiet", "--force", "run.nml")
            names.append(results_of(self.folder/"run.h5")[0].keys())
        self.assertIn("dissipation", names[0])
        self.assertEqual(names[0], names[1])
        self.assertEqual(names[0], names[2])
        self.write("velocity\n0.01\n0.1\n", "v.csv")
        scene = scene_of("wave_1d", 7).replace(", velocity = 0.01", "")
        self.write(scene + "&cases file = 'v.csv' /\n")
        _, errors = self.run_program("run", "run.nml", status=2)
        self.assertIn("&cases variables: not given, needed", errors)
        self.write(scene + "&cases file = 'v.csv', variables = 'velocity' /\n")
        self.run_program("run", "--quiet", "--force", "run.nml")
        self.assertEqual(results_of(self.folder/"run.h5")[0].keys() - names[0], {"case"})

    def test_units(self):
        """Reduced units are those of a paraboloid; SI units may be named everywhere, and make no adhesion."""
        self.write(scene_of("paraboloid", 1).replace("&job", "&job units = 'si',"))
        output, _ = self.run_program("check", "run.nml")
        self.assertIn("paraboloid on an elastic half-space, pressed", output)
        for surface, word, message in (("wave_1d", "reduced", "&job units: reduced units are those of a paraboloid"),
                                       ("cone", "kg", "&job units: unknown word, given 'kg', allowed: 'si', 'reduced'")):
            self.write(scene_of(surface, 1).replace("&job", f"&job units = '{word}',"))
            process = self.start("check", "run.nml")
            _, errors = process.communicate(timeout=60)
            self.assertEqual(process.returncode, 2)
            self.assertIn(message, errors)
        self.write("&job units = 'reduced', output = 'run.h5' /\n&surface kind = 'paraboloid' /\n&adhesion lambda = 1.0 /\n&operating load = 0.0 /\n")
        self.run_program("run", "--quiet", "--force", "run.nml")
        self.write(scene_of("paraboloid", 1).replace("&job", "&job solver = 'sphere',"))
        self.run_program("run", "--quiet", "--force", "run.nml")
        self.assertEqual(results_of(self.folder/"run.h5")[1], "sphere")

    def test_comments_are_kept(self):
        """Comments before, in and behind groups and values are in the scene, and a value that counts otherwise keeps the old one."""
        self.write("! head\n&job model = 'wavy_sliding' / ! job\n! above\n&surface\n  kind = 'cosines', period = 1e-4\n"
                   "  amplitudes =   ! of waves\n    1e-6, ! first\n    2e-7\n  phases = 0.0, 1.0 ! '!' [rad]\n/ ! behind\n"
                   "&foundation stiffness = 1e9, relaxation_time = 1e-3, retardation_ratio = 10.0 / ! arms\n"
                   "&operating load = 1.0, velocity = 0.1 /\n! last")
        scene, _ = self.run_program("modernise", "run.nml")
        for comment in ("! head", "! job", "! above", "! of waves", "! first", "! '!' [rad]", "! behind", "! arms", "! last"):
            self.assertEqual(scene.count(comment), 1, comment)
        self.assertIn("  amplitudes =   ! of waves\n    1e-6, ! first\n    2e-7\n", scene)
        self.write(scene, "new.nml")
        self.assertEqual(self.run_program("modernise", "new.nml")[0], scene)
        self.write("&job model = 'wavy_sliding' /\n&surface kind = 'wave_2d', period = 1e-4,\n  height = 1e-5 ! h [m]\n/\n"
                   "&foundation stiffness = 1e9, relaxation_time = 1e-3, retardation_ratio = 10.0 /\n&operating load = 1.0, velocity = 0.1 /\n")
        self.assertIn("  amplitude = 5e-6              ! h [m]; height = 1e-5 before\n", self.run_program("modernise", "run.nml")[0])

    def test_what_cannot_be_written_anew(self):
        """What an input says and a scene cannot is named; nothing is dropped."""
        wave = ("&job model = 'wavy_sliding' /\n&surface kind = 'wave_2d', period = 1e-4, {} /\n&foundation stiffness = 1e11, relaxation_time = 1e-4,"
                " retardation_ratio = 10 /\n&operating velocity = 0.1, mean_pressure = 1e4 /\n")
        for text, message in (
                (wave.format("") + "&sweep variable = 'height', values = 2*2e-6, 3e-6 /\n", "&sweep[1] values: are counted otherwise"),
                (wave.format("height = 2e-6") + "&uncertain variable = 'height', error = 1e-7 /\n", "&uncertain[1] variable: is counted otherwise"),
                (wave.format("height = 2e-6").replace(", mean_pressure = 1e4", "") + "&cases file = 'x.csv', variables = 'penetration' /\n",
                 "&cases variables: are 'approach' in a scene; rename the columns"),
                ("&job model = 'sphere' /\n&sphere radius = 1e-6, young_modulus = 1e9, poisson_ratio = 0.3, work_of_adhesion = 0.1, adhesion_stress = 1e7 /\n"
                 "&friction shear_strength = 1e6, poisson_ratio = 0.4 /\n&operating load = 0 /\n", "&friction poisson_ratio: has no place in this scene")):
            self.write(text.replace(", ,", ",").replace(",  /", " /"))
            _, errors = self.run_program("modernise", "run.nml", status=2)
            self.assertIn(message, errors)
        self.write(wave.format("height = 2e-6") + "&output derivatives = 'height', 'velocity' /\r\n")
        scene, _ = self.run_program("modernise", "run.nml")
        self.assertIn("derivatives = 'amplitude', 'velocity'\n", scene)
        self.assertNotIn("\r", scene)
        # SI units that are named make no adhesion
        self.write("&job model = 'sphere' /\n&sphere units = 'si', radius = 1e-6, contact_modulus = 1e9, work_of_adhesion = 0.0 /\n"
                   "&operating load = 1e-6 /\n")
        self.assertIn("  solver = 'sphere'\n", self.run_program("modernise", "run.nml")[0])
        self.write("&job model = 'sphere' /\n&sphere radius = 1e-6, contact_modulus = 1e9, work_of_adhesion = 0.0, adhesion_stress = 1e7 /\n&operating load = 1e-6 /\n")
        scene, _ = self.run_program("modernise", "run.nml")
        self.assertNotIn("&adhesion", scene)
        self.write(scene.replace("&job", "&job output = 'run.h5'"), "new.nml")
        self.run_program("run", "--quiet", "--force", "new.nml")
        self.assertEqual(results_of(self.folder/"run.h5")[1], "sphere")

    def test_adhesion(self):
        """Of work, stress and range any two say the same, for every kind of solver; one of them may be swept."""
        pairs = ("work_of_adhesion = 4e-4, adhesion_stress = 1e3", "work_of_adhesion = 4e-4, adhesion_range = 4e-7",
                 "adhesion_stress = 1e3, adhesion_range = 4e-7")
        for surface, column in (("paraboloid", 2), ("paraboloid", 4), ("cone", 2), ("wave_1d", 2), ("wave_2d", 2), ("heights", 2),
                                ("wave_1d", 10), ("wave_product", 10), ("profile", 10)):
            found = []
            for pair in pairs:
                scene = re.sub(r"&adhesion .*", f"&adhesion {pair} /", scene_of(surface, column))
                self.write(scene)
                self.run_program("run", "--quiet", "--force", "run.nml")
                found.append(results_of(self.folder/"run.h5")[0])
            self.assertGreater(len(found[0]), 5)
            for other in found[1:]:
                same = found[0].keys() & other.keys()
                self.assertLessEqual(len(found[0].keys() ^ other.keys()), 6)
                for name, values in found[0].items():
                    if name in same - {"error_estimate", "contact_violation", "energy_imbalance"}:
                        # the loss of a loop is a small difference of energies of the size of the work, an extreme depth one of heights
                        least = 1e-12*4e-4 if name == "adhesion_hysteresis" else 1e-10*1e-6 if "pull_off" in name else 0
                        np.testing.assert_allclose(other[name], values, rtol=1e-9, atol=least, err_msg=f"{surface}, {column}: {name}")
        self.write(re.sub(r"&adhesion .*", "&adhesion adhesion_range = 4e-7 /\n&sweep variable = 'adhesion_stress', values = 5e2, 1e3 /",
                          scene_of("paraboloid", 2)))
        self.run_program("run", "--quiet", "--force", "run.nml")
        swept = results_of(self.folder/"run.h5")[0]
        self.write(re.sub(r"&adhesion .*", f"&adhesion {pairs[0]} /", scene_of("paraboloid", 2)))
        self.run_program("run", "--quiet", "--force", "run.nml")
        np.testing.assert_allclose(swept["contact_radius"][1], results_of(self.folder/"run.h5")[0]["contact_radius"], rtol=1e-14)

    def test_directions(self):
        """Angles in radians: against +x is pi, along y pi/2; others are refused where the solver has two or four."""
        forward = scene_of("profile", 9)
        friction = {}
        for direction in ("0.0", "3.14159265"):
            self.write(forward.replace("velocity = 0.01", f"velocity = 0.01, direction = {direction}"))
            self.run_program("run", "--quiet", "--force", "run.nml")
            friction[direction] = results_of(self.folder/"run.h5")[0]["friction_stress"]
        self.assertNotEqual(friction["0.0"], friction["3.14159265"])
        self.write(forward.replace("velocity = 0.01", "velocity = 0.01, direction = 1.0"))
        _, errors = self.run_program("run", "--quiet", "run.nml", status=2)
        self.assertIn("&operating direction: is no multiple of pi", errors)
        self.write(scene_of("wave_2d", 7).replace("velocity = 0.01", "velocity = 0.01, direction = 0.785398163"))
        self.run_program("run", "--quiet", "--force", "run.nml")

    def run_scene(self, scene):
        """The results of a scene, and its profiles."""
        self.write(scene)
        self.run_program("run", "--quiet", "--force", "run.nml")
        with h5py.File(self.folder/"run.h5") as file:
            self.assertTrue(np.all(file["status"][()] == 0))
            inputs = [name for name in ("velocity", "direction", "length_x", "length_y") if name in file]
            maps = {name: item[()] for name, item in file.items() if name in ("pressure", "shear_stress", "displacement", "gap")}
        return {name: values for name, values in results_of(self.folder/"run.h5")[0].items() if name not in inputs}, maps

    def test_velocity_of_either_sign(self):
        """Vectors take the sign of the velocity, losses do not; sliding back is sliding to where pi shows."""
        for surface, column in (("wave_1d", 7), ("wave_2d", 7), ("profile", 7), ("heights", 7), ("wave_1d", 8), ("profile", 8),
                                ("wave_1d", 9), ("wave_product", 9), ("cosines", 9), ("profile", 9), ("heights", 9),
                                ("wave_1d", 10), ("profile", 10), ("cylinder", 7)):
            scene = scene_of(surface, column)
            forward, _ = self.run_scene(scene)
            back, _ = self.run_scene(scene.replace("velocity = ", "velocity = -"))
            self.assertEqual(forward.keys(), back.keys())
            vectors = [name for name in forward if name in VECTORS and np.isfinite(forward[name])]
            self.assertGreater(len(vectors), 1, (surface, column))
            for name in vectors:
                self.assertGreaterEqual(forward[name] if "lateral" not in name and "shift" not in name else 0, 0, (surface, column, name))
                self.assertLessEqual(back[name] if "lateral" not in name and "shift" not in name else 0, 0, (surface, column, name))
            self.assertGreater(back["dissipation"], 0)
            if surface in ("cylinder", "wave_1d") and column == 7:
                continue
            turned, _ = self.run_scene(scene.replace("velocity = ", "direction = 3.14159265, velocity = "))
            for name, values in turned.items():
                np.testing.assert_array_equal(back[name], -values if name in VECTORS else values, err_msg=f"{surface}, {column}: {name}")
            there_and_back, _ = self.run_scene(scene.replace("velocity = ", "direction = 3.14159265, velocity = -"))
            for name, values in forward.items():
                np.testing.assert_array_equal(there_and_back[name], -values if name in VECTORS else values, err_msg=f"{surface}, {column}: {name}")

    def test_interface(self):
        """With a law of the interface the losses are those of before to the last bit, and the friction is the sum, in both directions."""
        law = "&friction law = 'log_gaussian', peak_shear_strength = 3e4, peak_velocity = 0.01, log_width_factor = 0.1, pressure_factor = 0.05 /\n"
        for surface, column in (("wave_1d", 7), ("wave_2d", 7), ("profile", 7), ("heights", 7), ("cylinder", 7), ("wave_1d", 8), ("profile", 8),
                                ("wave_1d", 9), ("wave_product", 9), ("cosines", 9), ("profile", 9), ("heights", 9), ("wave_1d", 10), ("heights", 10)):
            with self.subTest(surface=surface, column=column):
                scene = scene_of(surface, column)
                kind = "force" if surface == "cylinder" else "stress"
                without, _ = self.run_scene(scene)
                self.assertFalse([name for name in without if "interfacial" in name or "hysteretic" in name or name == "velocity_slope"])
                both, _ = self.run_scene(scene + law)
                self.assertEqual(without[f"friction_{kind}"], both[f"hysteretic_friction_{kind}"])
                for name in without.keys() - {f"friction_{kind}", "friction_coefficient"}:
                    np.testing.assert_array_equal(without[name], both[name], err_msg=name)
                # at the velocity of the peak; a wave in contact of the cells, the tension of adhesion about it
                area, load = (2*both["contact_half_width"], 1e-3) if kind == "force" else (both["contact_fraction"], 5e4)
                load += 1e3*both.get("adhesion_fraction", 0.0)
                np.testing.assert_allclose(both[f"interfacial_friction_{kind}"], 3e4*area + 0.05*load, rtol=1e-12)
                np.testing.assert_allclose(both[f"friction_{kind}"], both[f"hysteretic_friction_{kind}"] + both[f"interfacial_friction_{kind}"], rtol=1e-14)
                np.testing.assert_allclose(both["interfacial_share"], both[f"interfacial_friction_{kind}"]/both[f"friction_{kind}"], rtol=1e-14)
                back, _ = self.run_scene(scene.replace("velocity = ", "velocity = -") + law)
                self.assertEqual(both.keys(), back.keys())
                self.assertEqual(both[f"interfacial_friction_{kind}"] > 0, back[f"interfacial_friction_{kind}"] < 0)
                self.assertLess(back[f"friction_{kind}"], 0)
                self.assertGreater(back["interfacial_share"], 0)

    def test_table_of_velocities(self):
        """A table of the shear stress is read from a group, with its temperature; a velocity beyond it is refused."""
        with h5py.File(self.folder/"law.h5", "w") as file:
            group = file.create_group("dry")
            for name, values, unit in (("velocity", [1e-4, 1e-2, 1.0], "m/s"), ("shear_strength", [1e4, 4e4, 2e4], "Pa")):
                group[name] = np.array(values)
                group[name].attrs["units"] = unit
            group.attrs["reference_temperature"] = 300.0
        scene = scene_of("wave_1d", 7).replace("velocity = 0.01", "velocity = 0.01, temperature = 300.0") + (
            "&friction law = 'table', velocity_table = 'law.h5:/dry', shift = 'arrhenius', activation_energy = 25e3 /\n")
        found, _ = self.run_scene(scene)
        np.testing.assert_allclose(found["interfacial_friction_stress"], 4e4*found["contact_fraction"], rtol=1e-12)
        # 40 K colder the factor is 4.7
        self.write(scene.replace("300.0", "260.0").replace("velocity = 0.01", "velocity = 0.5"))
        _, errors = self.run_program("run", "--quiet", "--force", "run.nml", status=2)
        self.assertIn("&operating velocity: times the factor of the shift lies beyond velocity_table", errors)
        self.assertEqual(1, len(errors.splitlines()))

    def test_mirrored_heights(self):
        """A surface that slides back is its mirror image that slides forth, with profiles that are mirrored in x."""
        profiles = "\n&output profiles = .true., n_x = 65 /\n"
        with h5py.File(self.folder/"z.h5", "a") as file:
            for name in ("profile", "map"):
                file[name + "_mirrored"] = np.roll(file[name][()][..., ::-1], 1, axis=-1)
        for surface, column in (("cosines", 9), ("profile", 9), ("heights", 9), ("profile", 10), ("wave_1d", 9), ("wave_1d", 10)):
            scene = (scene_of(surface, column) + profiles).replace("length_x", "detrend = 'none', periodise = 'none', length_x")
            back, maps = self.run_scene(scene.replace("velocity = ", "velocity = -"))
            mirrored = scene.replace("z.h5:/profile", "z.h5:/profile_mirrored").replace("z.h5:/map", "z.h5:/map_mirrored")
            forth, images = self.run_scene(mirrored.replace("phases = 0.0, 1.0", "phases = 0.0, -1.0"))
            for name, values in forth.items():
                if name not in ("error_estimate", "energy_imbalance"):
                    np.testing.assert_allclose(back[name], -values if name in VECTORS else values, rtol=1e-9, atol=1e-20,
                                               err_msg=f"{surface}, {column}: {name}")
            self.assertEqual(set(maps), {"pressure", "shear_stress", "displacement", "gap"})
            for name, values in maps.items():
                image = images[name][..., ::-1]
                np.testing.assert_allclose(values, -image if name == "shear_stress" else image, rtol=1e-7,
                                           atol=1e-9*np.abs(image).max(), err_msg=f"{surface}, {column}: {name}")
            # the mean of the shear stress over the period is the friction, with its sign
            if surface in ("cosines", "profile"):
                mean = np.mean(maps["shear_stress"][..., :-1])
                np.testing.assert_allclose(mean, back["friction_stress"], rtol=0.1)
                self.assertLess(mean, 0)

    def test_sweep_of_velocity(self):
        """A sweep of velocities from one sign to the other, its derivative and its refinement."""
        for surface, column in (("profile", 7), ("profile", 9), ("wave_1d", 10)):
            scene = scene_of(surface, column).replace(", velocity = 0.01", "")
            swept, _ = self.run_scene(scene + "&sweep variable = 'velocity', from = -0.02, to = 0.02, count = 5 /\n"
                                      "&output derivatives = 'velocity' /\n")
            friction = swept["friction_stress"]
            self.assertTrue(np.all(friction[:2] < 0) and np.all(friction[3:] > 0))
            # adhesion is lost at edges that slide however slowly
            self.assertLess(abs(friction[2]), (1e-3 if column == 10 else 1e-9)*friction[4])
            for at, velocity in ((0, -0.02), (4, 0.02)):
                one, _ = self.run_scene(scene_of(surface, column).replace("velocity = 0.01", f"velocity = {velocity}"))
                np.testing.assert_allclose(friction[at], one["friction_stress"], rtol=1e-9)
            self.assertGreater(swept["friction_stress_by_velocity"][2], 0)

    def test_what_does_not_vary(self):
        """A direction of a few values has no derivative, no error, and cannot be refined or fitted."""
        for surface, column in (("profile", 7), ("profile", 9)):
            scene = scene_of(surface, column).replace("velocity", "direction = 0.0, velocity")
            for group, message in (("&output derivatives = 'direction' /", "&output derivatives: it has some values alone, given 'direction'"),
                                   ("&uncertain variable = 'direction', error = 0.1 /", "&uncertain[1] variable: it has some values alone")):
                self.write(scene + group + "\n")
                _, errors = self.run_program("check", "run.nml", status=2)
                self.assertIn(message, errors)
            self.write("velocity,friction_stress\n0.01,1.0\n0.02,2.0\n0.03,3.0\n", "v.csv")
            self.write(scene.replace("direction = 0.0, velocity = 0.01", "").replace(",  /", " /") + "&free variable = 'direction' /\n"
                       "&data file = 'v.csv', abscissa = 'velocity', ordinate = 'friction_stress' /\n")
            _, errors = self.run_program("fit", "run.nml", status=2)
            self.assertIn("it has some values alone, it cannot be fitted, given 'direction'", errors)

    def test_work_from_zero(self):
        """A sweep of the work of adhesion from 0: Hertz's contact there, and JKR's or Maugis's behind it."""
        for surface in ("paraboloid", "cone", "sphere"):
            for more in ("", "&adhesion adhesion_stress = 1e6 /\n", "&adhesion adhesion_range = 1e-8 /\n"):
                scene = scene_of(surface, 1).replace("&operating load = 1e-3", "&operating load = 1e-4") + more
                swept, _ = self.run_scene(scene + "&sweep variable = 'work_of_adhesion', from = 0.0, to = 0.05, count = 3 /\n")
                plain, _ = self.run_scene(scene_of(surface, 1).replace("load = 1e-3", "load = 1e-4"))
                for name in ("contact_radius", "approach"):
                    np.testing.assert_allclose(swept[name][0], plain[name], rtol=1e-13, err_msg=f"{surface}: {name}")
                self.assertTrue(np.all(np.diff(swept["contact_radius"]) > 0))
                self.assertEqual(swept["contact_radius"].shape, (3,))
        scene = scene_of("paraboloid", 1) + "&sweep variable = 'work_of_adhesion', from = 0.0, to = 0.05, count = 3 /\n"
        self.run_scene(scene)
        with h5py.File(self.folder/"run.h5") as file:
            meanings = file["theory_used"].attrs["flag_meanings"].split()
            values = list(file["theory_used"].attrs["flag_values"])
            self.assertEqual([meanings[values.index(k)] for k in file["theory_used"][()]], ["hertz", "jkr", "jkr"])
        # a theory that is asked for keeps its bound
        self.write(scene + "&adhesion theory = 'jkr' /\n")
        _, errors = self.run_program("check", "run.nml", status=2)
        self.assertIn("&adhesion work_of_adhesion: is 0", errors)

    def test_spacing_of_heights(self):
        """The attributes dx and dy of heights give the lengths, on a half-space as on columns; a length that is given counts."""
        for surface, column in (("profile", 1), ("heights", 1), ("heights", 2), ("profile", 7), ("heights", 7), ("heights", 8), ("heights", 9)):
            scene = scene_of(surface, column)
            given, _ = self.run_scene(scene)
            bare_scene = re.sub(r", length_[xy] = [^ ,]+", "", scene)
            self.assertNotIn("length", bare_scene)
            with h5py.File(self.folder/"z.h5", "a") as file:
                for name in ("profile", "map"):
                    file[name].attrs.update({"dx": 1e-4/32, "dy": 1e-4/32})
            found, _ = self.run_scene(bare_scene)
            for name, values in given.items():
                np.testing.assert_allclose(found[name], values, rtol=1e-12, atol=1e-14, err_msg=f"{surface}, {column}: {name}")
            if column < 9:
                with h5py.File(self.folder/"run.h5") as file:
                    np.testing.assert_allclose(file["length_x"][()], 1e-4, rtol=1e-14)
                    self.assertEqual("length_y" in file, surface == "heights")
            with h5py.File(self.folder/"z.h5", "a") as file:
                for name in ("profile", "map"):
                    file[name].attrs["dx"] = 2e-4/32
            again, _ = self.run_scene(scene)
            for name, values in given.items():
                np.testing.assert_array_equal(again[name], values, err_msg=name)
            with h5py.File(self.folder/"z.h5", "a") as file:
                for name in ("profile", "map"):
                    file[name].attrs["dx"] = -1.0
            self.write(bare_scene)
            _, errors = self.run_program("check", "run.nml", status=2)
            self.assertIn("&surface heights: has an attribute dx that is not > 0", errors)
            with h5py.File(self.folder/"z.h5", "a") as file:
                for name in ("profile", "map"):
                    del file[name].attrs["dx"], file[name].attrs["dy"]

    def test_modulus_of_a_curve(self):
        """A bonded layer takes a master curve of Young's modulus or of the contact modulus, and Poisson's ratio beside either."""
        omega = np.logspace(-1, 6, 43)
        storage, loss = (1e6 + 9e6*(omega*1e-3)**2/(1 + (omega*1e-3)**2), 9e6*omega*1e-3/(1 + (omega*1e-3)**2))
        with h5py.File(self.folder/"curve.h5", "w") as file:
            for name, factor in (("young", 1.0), ("contact", 1/(1 - 0.45**2))):
                file[f"{name}/omega"] = omega
                file[f"{name}/storage"] = factor*storage
                file[f"{name}/loss"] = factor*loss
        scene = scene_of("wave_1d", 8)
        solid = scene[scene.index("&solid"):scene.index("&operating")]
        found = {}
        for word, ratio in (("young", "poisson_ratio = 0.45, "), ("contact", "poisson_ratio = 0.45, "), ("", "poisson_ratio = 0.45, ")):
            says = f"curve_modulus = '{word}', " if word else ""
            found[word], _ = self.run_scene(scene.replace(solid, f"&solid master_curve = 'curve.h5:/{word or 'young'}', {says}{ratio}extent = 'layer',"
                                                          " thickness = 1e-4, base = 'bonded' /\n"))
        for name in ("friction_stress", "contact_fraction", "approach"):
            np.testing.assert_allclose(found["contact"][name], found["young"][name], rtol=1e-9, err_msg=name)
            np.testing.assert_array_equal(found[""][name], found["young"][name], err_msg=name)
        for text, message in (("curve_modulus = 'contact'", "&solid poisson_ratio: is missing [-]; a bonded layer needs it"),
                              ("curve_modulus = 'young'", "&solid poisson_ratio: is missing [-]; a master curve of Young's modulus needs it"),
                              ("curve_modulus = 'shear'", "&solid curve_modulus: unknown word, given 'shear', allowed: 'young', 'contact'")):
            self.write(scene.replace(solid, f"&solid master_curve = 'curve.h5:/contact', {text}, extent = 'layer', thickness = 1e-4, base = 'bonded' /\n"))
            _, errors = self.run_program("check", "run.nml", status=2)
            self.assertIn(message, errors)
        self.write(scene.replace("modulus = 1e7", "curve_modulus = 'young', modulus = 1e7"))
        _, errors = self.run_program("check", "run.nml", status=2)
        self.assertIn("&solid curve_modulus: has no meaning without master_curve", errors)
        # an input of a model says it by where Poisson's ratio stands
        self.write("&job model = 'surface_sliding', output = 'run.h5' /\n&surface kind = 'wave_1d', period = 1e-4, amplitude = 1e-6 /\n"
                   "&material master_curve = 'curve.h5:/contact' /\n&layer thickness = 1e-4, base = 'bonded', poisson_ratio = 0.45 /\n"
                   "&operating mean_pressure = 5e4, velocity = 0.01 /\n&numerics cells = 64 /\n")
        text, _ = self.run_program("modernise", "run.nml")
        self.assertIn("curve_modulus = 'contact'", text)
        old, _ = self.run_scene((self.folder/"run.nml").read_text())
        new, _ = self.run_scene(text)
        np.testing.assert_array_equal(new["friction_stress"], old["friction_stress"])

    def test_messages(self):
        """What a solver finds wrong is said with the names of the scene."""
        with h5py.File(self.folder/"z.h5", "a") as file:
            file["long"] = np.linspace(-1e-3, 1e-3, 33)
        flat = scene_of("line_punch", 1)
        coulomb = scene_of("cone", 5)
        old_names = re.compile(r"&(sphere|shape|contact|punch|material|foundation|layer|samples|model)\b|friction coefficient|tangential_axis|"
                               r"surface_energy|strip_spacing|wave_3d|degrees|'flat'|shear_tractions")
        for scene, message in (
                (coulomb.replace("&friction coulomb_coefficient = 0.3 /\n", ""), "run.nml: &"),
                (scene_of("ellipsoid", 5).replace("tangential_force = 1e-6", "direction = 1.5707963").replace("&friction coulomb_coefficient = 0.3 /\n", ""), ""),
                (scene_of("wave_2d", 5).replace(", tangential_stress = 1e3", ", direction = 1.5707963"), "&operating tangential_stress: is missing [Pa]; &friction coulomb_coefficient needs it"),
                (scene_of("line_polynomial", 1).replace("coefficient_2 = 500.0", "coefficient_2 = 0.0"), "&surface coefficient_2: is 0 like all coefficients; give one of them, or kind = 'line_punch'"),
                (scene_of("polynomial", 1).replace("coefficient_2 = 500.0, coefficient_4 = 1e6", "coefficient_2 = 0.0"), "&surface coefficient_1: is 0 like all coefficients; give one of them, or kind = 'flat_punch'"),
                (scene_of("wedge", 1).replace("slope = 0.1", "slope = 0.1, face_half_width = 1e-6").replace("load = 1e-3", "contact_half_width = 1e-5"), "&operating contact_half_width: is larger than the face_half_width"),
                (flat.replace("load = 1e-3", "load = 1e-3, contact_half_width = 1e-6"), "&operating contact_half_width"),
                (scene_of("power", 2).replace("exponent = 4.0", "exponent = 0.4").replace(", adhesion_stress = 1e6", ""), "&surface exponent: is too small for adhesion"),
                (scene_of("cone", 2).replace("adhesion_stress = 1e6", "theory = 'dmt', adhesion_stress = 1e6"), "&adhesion theory: is 'dmt'"),
                (scene_of("wave_1d", 2).replace("work_of_adhesion = 1e-4, adhesion_stress = 1e3", "adhesion_stress = 1e-15, adhesion_range = 1e-7"), "&adhesion adhesion_stress: or its range is too small"),
                (scene_of("wave_2d", 7).replace("velocity = 0.01", "velocity = 0.01, direction = 0.5"), "&operating direction: is no multiple of pi/4"),
                (scene_of("profile", 7).replace("velocity = 0.01", "velocity = 0.01, direction = 0.5"), "&operating direction: is no multiple of pi/2"),
                (scene_of("wave_product", 9).replace("relaxation_time = 1e-4, retardation_ratio = 10.0", "stiffnesses = 1e10, relaxation_times = 1e-3"), "&surface kind: is wave_product, which has one relaxation time; sample it as heights"),
                (scene_of("profile", 9).replace(", length_x = 1e-4", ""), "&surface length_x: is missing"),
                (scene_of("wave_2d", 1) + "&output pull_off = .true. /\n", "&output pull_off: has no meaning without &adhesion"),
                (scene_of("wave_2d", 7) + "&output compare_branches = .true. /\n", "&output compare_branches: has no meaning without &adhesion"),
                (scene_of("profile", 9).replace("z.h5:/profile", "z.h5:/map"), "&surface heights: of a profile have one dimension; those of two are of kind heights"),
                (scene_of("wave_1d", 9).replace("retardation_ratio = 10.0", "retardation_ratio = 10.0, stiffnesses = 1e10"), "&solid stiffnesses: belongs to heights"),
                ("&job output = 'run.h5' /\n&traction kind = 'strip', distribution = 'sampled', positions = 'z.h5:/long', pressures = 'z.h5:/long', shear_stresses = 'z.h5:/profile' /\n"
                 + ELASTIC + "&position position_x = 0.0, position_z = 1e-3 /\n", "&traction shear_stresses: has not as many values as positions")):
            self.write(scene)
            _, errors = self.run_program("check", "run.nml", status=2)
            self.assertIn(message, errors)
            self.assertIsNone(old_names.search(errors), errors)

    def test_extent(self):
        """A layer has a thickness, a half-space has none; a base belongs to a layer, and a stiffness per area to columns."""
        rubber = scene_of("wave_1d", 7)
        layer, columns = scene_of("wave_1d", 8), scene_of("wave_1d", 9)
        self.assertIn("thickness = ", layer)
        without = re.sub(r"thickness = [0-9.e-]+,?", "", layer)
        for scene, message in (
                (rubber.replace("&solid ", "&solid thickness = 1e-5, "), "&solid thickness: belongs to a layer, a coating or columns, and a half-space has none; give extent = 'layer', extent = 'coating' or"),
                (rubber.replace("&solid ", "&solid extent = 'half_space', thickness = 1e-5, "), "&solid thickness: belongs to a layer"),
                (without, "&solid thickness: is missing [m]; a layer needs it"),
                (rubber.replace("&solid ", "&solid base = 'bonded', "), "&solid base: belongs to a layer; give extent = 'layer'"),
                (scene_of("wave_1d", 17).replace(", base = 'bonded'", ""), "&solid base: is missing, allowed: frictionless, bonded; a coating has extent = 'coating'"),
                (scene_of("wave_1d", 17).replace("poisson_ratio = 0.5, ", "").replace("young", "contact"), "&solid poisson_ratio: is missing [-]; a bonded layer needs it"),
                (scene_of("wave_1d", 17).replace("&solid ", "&solid base_young_modulus = 1e9, "), "&solid base_young_modulus: belongs to a coating; give extent = 'coating'"),
                (scene_of("wave_1d", 17).replace("'bonded'", "'elastic'"), "&solid base: "),
                (scene_of("wave_1d", 17).replace("&solid ", "&solid second_young_modulus = 1e9, second_poisson_ratio = 0.3, "), "&solid second_young_modulus: has no meaning beside a layer"),
                (scene_of("wave_1d", 18).replace("&adhesion ", "&adhesion law = 'lennard_jones', "), "&adhesion law: is 'lennard_jones' beside a layer, where a law without a wall has no bounds; other laws have"),
                (scene_of("wave_1d", 19).replace("base_young_modulus = 1e9, ", ""), "&solid base_young_modulus: is missing [Pa]; a coating needs it and base_poisson_ratio"),
                (scene_of("wave_1d", 19).replace(" poisson_ratio = 0.5,", "").replace("&solid young", "&solid contact"), "&solid poisson_ratio: is missing [-]; a coating needs it"),
                (scene_of("wave_1d", 18) + "&output pull_off = .true. /\n", "&output pull_off: is not found on layers and coatings"),
                (scene_of("profile", 20) + "&output pull_off = .true. /\n", "&output pull_off: is not found on layers and coatings"),
                (scene_of("wave_1d", 19).replace(", base_poisson_ratio = 0.3", ""), "&solid base_poisson_ratio: is missing"),
                (scene_of("wave_1d", 19).replace("&solid ", "&solid base = 'bonded', "), "&solid base: belongs to a layer"),
                (re.sub("thickness = [0-9.e-]+, ", "", scene_of("wave_1d", 19)), "&solid thickness: is missing [m]; a coating needs it"),
                (columns.replace("extent = 'foundation', ", ""), "&solid stiffness: belongs to columns; give extent = 'foundation'")):
            self.write(scene)
            _, errors = self.run_program("check", "run.nml", status=2)
            self.assertIn(message, errors)
        # a thickness that is swept is one
        self.write(without + "&sweep variable = 'thickness', values = 1e-5, 1e-4 /\n")
        self.run_program("check", "run.nml")

    def test_two_of_adhesion_while_sliding(self):
        """Any two of work, stress and range are one law. The work of one that fades linearly is half of stress times range, that of
        van der Waals' law likewise, of the exponential one the whole."""
        for law, ratio in (("dugdale", 1), ("exponential", 1), ("linear", 0.5), ("van_der_waals", 0.5)):
            found = []
            for pair in ({"work_of_adhesion": 0.02, "adhesion_range": 1e-6}, {"work_of_adhesion": 0.02, "adhesion_stress": 0.02/ratio/1e-6},
                         {"adhesion_stress": 0.02/ratio/1e-6, "adhesion_range": 1e-6}):
                words = ", ".join(f"{name} = {value!r}" for name, value in pair.items())
                self.write("&job output = 'run.h5' /\n&surface kind = 'profile', heights = 'z.h5:/profile', length_x = 1e-4 /\n"
                           + "&solid modulus = 1e6, moduli = 9e6, relaxation_times = 1e-3 /\n"
                           + f"&adhesion law = '{law}', {words} /\n&operating mean_pressure = 5e4, velocity = 0.01 /\n")
                self.run_program("run", "--quiet", "--force", "run.nml")
                results, solver = results_of(self.folder/"run.h5")
                self.assertEqual(solver, "surface_sliding")
                found.append([float(results[name]) for name in ("friction_stress", "contact_fraction", "penetration")])
            np.testing.assert_allclose(found[1:], found[:1]*2, rtol=1e-9, err_msg=law)

    def test_boundaries(self):
        """Heights end where boundaries say so; what has no solver there, and bodies that are alone anyway, are refused in one line."""
        free = scene_of("heights", 16)
        with h5py.File(self.folder/"z.h5", "r+") as file:
            heights = file["map"][()]
            heights[:3] = np.nan
            file["masked"] = heights
            heights[0, 0] = np.inf
            file["infinite"] = heights
            file["nothing"] = np.full((8, 8), np.nan)
            file["few"] = heights[4:19, 4:]
        masked = free.replace("/map", "/masked")
        for scene, message in (
                (free + ADHESION + "&friction shear_strength = 1e5 /\n", "nothing solves heights on an elastic half-space with free boundaries with adhesion and"),
                (free + "&output pull_off = .true. /\n", "&output pull_off: "),
                (free.replace("/map", "/few") + LIGHT, "&surface heights: has 15 cells along a side, allowed: at least 16; with adhesion"),
                (free + ADHESION.replace("&adhesion", "&adhesion law = 'lennard_jones',"), "&adhesion law: is 'lennard_jones', which has no wall"),
                (free + "&friction coulomb_coefficient = 0.3 /\n", "&friction: nothing solves heights on an elastic half-space with free boundaries with a coefficient"),
                (free + "&friction shear_strength = 1e5 /\n", "nothing solves heights on an elastic half-space with free boundaries with a shear strength, pressed"),
                (scene_of("heights", 7).replace("&solid ", "&solid boundaries = 'periodic_x', "), "&solid: nothing solves heights on a viscoelastic half-space with free boundaries"),
                (scene_of("heights", 8).replace("&solid ", "&solid boundaries = 'free', "), "&solid: nothing solves heights on a layer with free boundaries"),
                (scene_of("heights", 9).replace("&solid ", "&solid boundaries = 'free', "), "&solid: nothing solves heights on a foundation with free boundaries"),
                (scene_of("profile", 1).replace("&solid ", "&solid boundaries = 'free', "), "nothing solves profile on an elastic half-space with free boundaries"),
                (scene_of("sphere", 1).replace("&solid ", "&solid boundaries = 'periodic', "), "&solid boundaries: are periodic under waves and given heights, and a body of kind 'sphere' is alone"),
                (free.replace("'free'", "'open'"), "&solid boundaries"),
                (free.replace("load = 1e-5", "load = 1e-5, mean_pressure = 1e5"), "&operating mean_pressure: unknown variable, allowed: branch, turning_load, load, approach"),
                (free.replace("load = 1e-5", "load = 1e-5, approach = 1e-7"), "&operating load: "),
                (free.replace("load = 1e-5", "load = -1e-5"), "&operating load: "),
                (free.replace("/map", "/profile"), "&surface heights: have one dimension, x; a body that ends somewhere needs two, (ny, nx)"),
                (free.replace("/map", "/infinite"), "&surface heights: Inf in the dataset; what is not known is NaN"),
                (free.replace("/map", "/nothing"), "&surface heights: all values of the dataset are NaN"),
                (masked.replace("boundaries = 'free'", "boundaries = 'periodic'").replace("load = 1e-5", "mean_pressure = 1e5"), "&surface heights: NaN or Inf in the dataset")):
            self.write(scene)
            _, errors = self.run_program("check", "run.nml", status=2)
            self.assertIn(message, errors)
            self.assertEqual(1, len(errors.splitlines()), errors)
        for scene, solver in ((masked, "free_surface"), (free.replace("'free'", "'periodic_y'"), "free_surface"), (free + LIGHT, "free_surface"),
                              (scene_of("heights", 1).replace("&solid ", "&solid boundaries = 'periodic', "), "surface_elastic"),
                              (scene_of("wave_2d", 1).replace("&solid ", "&solid boundaries = 'periodic', "), "wave_2d_elastic")):
            self.write(scene)
            self.run_program("run", "--quiet", "--force", "run.nml")
            self.assertEqual(solver, results_of(self.folder/"run.h5")[1])
        self.write(masked + "&output profiles = .true. /\n")
        self.run_program("run", "--quiet", "--force", "run.nml")
        with h5py.File(self.folder/"run.h5") as file:
            self.assertTrue(np.isnan(np.squeeze(file["gap"][()])[:3]).all())
            pressure = np.squeeze(file["pressure"][()])
            self.assertFalse(pressure[:3].any())
            np.testing.assert_allclose(pressure.sum()*(1e-4/32)**2, 1e-5, rtol=1e-12)

    def test_help_on_names(self):
        """What scenes say of a name stands first, and what models say of it behind."""
        for topic, first, then in (("work_of_adhesion", "&adhesion\n  work_of_adhesion [J/m^2]", "model = 'sphere'"),
                                   ("amplitude", "&surface\n  amplitude [m]", "model = 'wave_1d'"),
                                   ("friction_force", "Results, where they have a meaning\n  friction_force", "model = "),
                                   ("operating", "&operating\n", "model = "),
                                   ("wave_product", "&surface\n  kind ", ""), ("operating%velocity", "&operating\n  velocity [m/s]", "model = "),
                                   ("blend_fraction", "&surface\n  blend_fraction [-]", ""), ("curve_modulus", "&solid\n  curve_modulus", "")):
            page, _ = self.run_program("help", topic)
            self.assertIn("In a scene (adfric help scenes)\n" + first, page, topic)
            if then:
                old = page.index("In an input that names a model (&job model)\n" + then)
                self.assertGreater(old, page.index("In a scene"))
            else:
                self.assertNotIn("model = ", page)

    def test_lengths(self):
        """A profile by its length and by the attribute of its spacing."""
        scene = scene_of("profile", 9)
        values = []
        for text in (scene, scene.replace(", length_x = 1e-4", "")):
            self.write(text)
            with h5py.File(self.folder/"z.h5", "a") as file:
                file["profile"].attrs["dx"] = 1e-4/32
            self.run_program("run", "--quiet", "--force", "run.nml")
            values.append(results_of(self.folder/"run.h5")[0])
        for name in ("friction_stress", "contact_fraction", "approach", "mean_pressure"):
            if name in values[0]:
                np.testing.assert_allclose(values[0][name], values[1][name], rtol=1e-14, err_msg=name)


def proportional(values, others):
    """Are two results the same but for a factor?"""
    if others.dtype.kind != "f" or not np.array_equal(np.isfinite(values), np.isfinite(others)):
        return False
    largest = np.nanargmax(np.where(np.isfinite(values), np.abs(values), 0))
    if others.flat[largest] == 0:
        return False
    with np.errstate(invalid="ignore"):
        return np.allclose(values, others*(values.flat[largest]/others.flat[largest]), rtol=1e-14, atol=0, equal_nan=True)


def bare(text):
    """An input without its comments."""
    return [line.strip() for line in re.sub(r"!.*|(?<=0)\.0\b", "", text).splitlines() if line.strip()]


def short(text):
    """An input with three points a sweep."""
    text = re.sub(r"count = \d+", "count = 3", text)
    return re.sub(r"'\.\./tests", f"'{SOURCE}/tests", text)


if __name__ == "__main__":
    main()
