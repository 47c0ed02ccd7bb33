# SPDX-License-Identifier: GPL-3.0-or-later
"""The command scripts/report: pages that need nothing else, how large they are, and what is refused. report_browser.py clicks through pages."""

from environments import SOURCE, restart_in

restart_in(".venv_report", "bokeh")

import html  # noqa: E402
import os  # noqa: E402
import re  # noqa: E402
import subprocess  # noqa: E402
import sys  # noqa: E402
import unittest  # noqa: E402
from pathlib import Path  # noqa: E402

import bokeh  # noqa: E402
import h5py  # noqa: E402
import numpy as np  # noqa: E402

from runs import EVEN, LOADS, STACK, MAP, Runs, main  # noqa: E402

from reporting.inputs import groups_of  # noqa: E402
from reporting.page import page_of  # noqa: E402
from reporting.scene import scene_of  # noqa: E402
from reporting.stacks import root_mean_square, stack_html  # noqa: E402
from reporting.sketch import SHAPES, height_of, sketch_of  # noqa: E402
from reporting.statuses import status_html  # noqa: E402
from reporting.thinning import thin  # noqa: E402
from reporting.words import number_of  # noqa: E402
from plotting.results import Results  # noqa: E402

# of a page without maps [bytes]
LARGEST = 3e6
PLAIN = SOURCE / ".venv/bin/python"
# the same at one point
POINT = re.sub(r"&sweep.*\n", "", LOADS).replace("range = 1e-5", "range = 1e-5, stress = 1e3").replace("velocity = 0.5", "velocity = 0.5, load = 0.3")
IN_NOTEBOOK = """
import adfric, sys
for given in ("run.h5", adfric.open("run.h5")):
    figure = adfric.plot(given, x="load", y="friction_coefficient", interactive=True, output="figure.html")
    assert "srcdoc" in figure._repr_html_() and len(figure.html) < 3e6, len(figure.html)
    assert open("figure.html", encoding="utf-8").read() == figure.html
for bad in ({"y": "nothing"}, {"data": "points.csv"}, {"y": ["load", "approach"]}, {"output": "figure.png"}):
    try:
        adfric.plot("run.h5", interactive=True, **bad)
    except adfric.InputError as problem:
        print(problem)
"""


class Report(Runs):
    def report(self, *arguments, status=0):
        """Standard output and standard error of the command."""
        done = subprocess.run([sys.executable, SOURCE / "scripts/report.py", *arguments], cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, status, done.stderr)
        return done.stdout, done.stderr

    def refused(self, *arguments):
        """The one line that refuses."""
        output, errors = self.report(*arguments, status=2)
        self.assertEqual((output, errors.count("\n")), ("", 1), errors)
        self.assertTrue(errors.startswith("report: "), errors)
        return errors

    def solve(self, text):
        """The results of an input."""
        self.write(text)
        self.run_program("run", "--quiet", "--force", "run.nml")

    def test_page(self):
        """A page has all that it needs, says what the scene is and repeats the input; it is small."""
        self.solve(LOADS.format(strips=16, count=9))
        output, errors = self.report("run.h5")
        self.assertEqual(errors, "")
        self.assertRegex(output, r"\Areport run\.html \(\d\.\d MB\)\n\Z")
        text = (self.folder / "run.html").read_text(encoding="utf-8")
        self.assertLess(len(text.encode()), LARGEST)
        # nothing is fetched: outside of its scripts no script, style, picture or frame has an address
        self.assertEqual([], re.findall(r"""<(?:script|link|img|iframe|source)\b[^>]*\b(?:src|href)\s*=\s*["'](?!data:)[^"']*""",
                                        re.sub(r"(<script[^>]*>).*?</script>", r"\1", text, flags=re.DOTALL)))
        self.assertIn("<title>loads</title>", text)
        self.assertIn(html.escape((self.folder / "run.nml").read_text()), text)
        for words in ("<svg class='sketch'", "Adhesion stress: 0, 1, 2 kPa", "Load: -100 to 600 mN, 9 values", "Statuses and doubts"):
            self.assertIn(words, text)

    def test_choice(self):
        """CONTRIBUTING says how large the scripts are that a page carries."""
        row = next(line for line in (SOURCE / "CONTRIBUTING.md").read_text().splitlines() if line.startswith("| Bokeh"))
        scripts = Path(bokeh.__file__).parent / "server/static/js"
        sizes = [f"{scripts.joinpath(f'{name}.min.js').stat().st_size / 1e6:.2f} MB" for name in ("bokeh", "bokeh-widgets")]
        self.assertIn(f"| Bokeh {bokeh.__version__} |", row)
        self.assertTrue(row.endswith(f"| {' and '.join(sizes)} |"), row)

    def test_sizes(self):
        """A run of very many points has a page that is no larger than others, and that says what it leaves out."""
        self.solve(EVEN.format(strips=0, count=40).replace("values = 0, 1e3, 2e3", "from = 0, to = 2e3, count = 30").replace("strips = 0", "strips = 4"))
        with h5py.File(self.folder / "run.h5") as file:
            self.assertEqual(file["status"].shape, (30, 40))
        results = Results(self.folder / "run.h5")
        thinned, left = thin(results, 300 * len(results.fields), len(results.fields))
        self.assertEqual(thinned.status.shape, (15, 20))
        self.assertEqual(left, "The page has one of 2 values of stress and one of 2 values of load.")
        for name, field in thinned.fields.items():
            np.testing.assert_array_equal(field.values, results.fields[name].values[::2, ::2])
        for axis, whole in zip(thinned.axes, results.axes):
            np.testing.assert_array_equal(axis.values, whole.values[::2])
        self.assertEqual(thin(results, 1200 * len(results.fields), len(results.fields)), (results, ""))

    def test_kinds(self):
        """Single points, profiles with two axes, fits, stacks of fits and paths all have pages."""
        self.write(STACK.format(file=MAP), "stack.nml")
        self.run_program("fit", "--quiet", "stack.nml", "--output", "stack.h5")
        self.solve(POINT.format(strips=8, count=2))
        for name in ("inputs/fit_friction.nml", "inputs/indenter_fretting.nml", "inputs/wave_2d_contact.nml", "inputs/strip_load.nml"):
            self.run_program("fit" if "fit" in name else "run", "--quiet", SOURCE / name, "--output", f"{SOURCE.joinpath(name).stem}.h5")
        for name, words in (("run", "Results"), ("stack", "Maps over two swept variables"), ("fit_friction", "<table class='fit'>"),
                            ("indenter_fretting", "Curves"), ("wave_2d_contact", "Maps of the surface"), ("strip_load", "svg")):
            with self.subTest(name=name):
                text = page_of([Results(self.folder / f"{name}.h5")])
                self.assertIn(words, text)
        self.assertIn("too few points", page_of([Results(self.folder / "stack.h5")]))

    def test_residuals(self):
        """The page of a stack has the largest residuals, the probabilities and, where the file has them, the points of each curve."""
        for wants, profiles in ((False, ""), (True, "&fit residuals = 'all' /")):
            self.write(STACK.format(file=MAP) + profiles, "stack.nml")
            self.run_program("fit", "--quiet", "--force", "stack.nml", "--output", "stack.h5")
            results = Results(self.folder / "stack.h5")
            text = page_of([results])
            self.assertEqual("residuals of single points" in text, not wants)
            self.assertEqual("residuals1 lines" in text, wants)
            self.assertLess(len(text.encode()), LARGEST)
            self.assertIn("141 of 144 fits have residuals", text)
        sizes = root_mean_square(results)
        residuals = results.profiles["residual"].values
        # S is their sum of squares
        np.testing.assert_allclose(np.nansum(residuals**2, axis=-1)[results.status == 0], results.fields["chi2"].values[results.status == 0], rtol=1e-9)
        self.assertTrue(np.all(np.isnan(residuals[results.status != 0])))
        rows = re.findall(r"<tr><td>(\d+)</td><td>(\d+)</td><td>([^<]*)</td>", stack_html(results))
        self.assertEqual(len(rows), 10)
        np.testing.assert_allclose([float(size) for _, _, size in rows], np.sort(sizes[np.isfinite(sizes)])[::-1][:10], rtol=1e-3)
        for row, column, size in rows:
            self.assertAlmostEqual(sizes[int(row) - 1, int(column) - 1], float(size), delta=1e-3)

    def test_statuses(self):
        """What is not solved and what is doubted is counted, and is where the file has it."""
        self.solve(LOADS.format(strips=4, count=15))
        with h5py.File(self.folder / "run.h5", "r+") as file:
            status, doubt = np.zeros((3, 15), np.int8), np.zeros((3, 15), np.int8)
            status[1, 2:5], status[2, 7] = 1, 2
            doubt[0, 14], doubt[1, 0] = 2, 2
            doubt[status > 0] = -1
            file["status"][...], file["doubt"][...] = status, doubt
            loads = [number_of(load, "N", file["load"][()]) for load in file["load"][()]]
        text = re.sub(r"<[^>]+>", "|", status_html(Results(self.folder / "run.h5"), {0: "solved", 1: "no_equilibrium", 2: "not_converged"}))
        self.assertIn("41 of 45 points are solved", text)
        for what, points, where in (("no equilibrium", 3, f"adhesion stress 1 kPa, load {loads[2]} to {loads[4]}"),
                                    ("not converged", 1, f"adhesion stress 2 kPa, load {loads[7]}"),
                                    ("doubt: slope too steep", 2, f"adhesion stress 0 kPa, load {loads[14]}|adhesion stress 1 kPa, load {loads[0]}")):
            self.assertIn(f"|{what}|{points} of 45|{where}", text.replace("||", "|"))

    def test_refusals(self):
        """What is no results file, is missing, exists already or has another ending is refused in one line."""
        self.solve(LOADS.format(strips=4, count=3))
        self.write("no results", "text.h5")
        with h5py.File(self.folder / "other.h5", "w") as file:
            file["x"] = 1.0
        self.assertIn("none.h5: no such file", self.refused("none.h5"))
        self.assertIn("text.h5: not an HDF5 file", self.refused("text.h5"))
        self.assertIn("other.h5: not a results file of adfric", self.refused("other.h5"))
        self.assertIn("run.png: a page is one of .html, .htm", self.refused("run.h5", "--output", "run.png"))
        self.assertIn("none/run.html: there is no such folder", self.refused("run.h5", "--output", "none/run.html"))
        self.assertIn("run.h5: y nothing: allowed: ", self.refused("run.h5", "--y", "nothing"))
        self.assertIn("run.h5: x status: allowed: stress, load, ", self.refused("run.h5", "--x", "status"))
        before = self.names()
        self.write("mine", "run.html")
        self.assertIn("run.html: exists already; --force overwrites it", self.refused("run.h5"))
        self.assertEqual((self.folder / "run.html").read_text(), "mine")
        self.report("run.h5", "--force", "--y", "penetration")
        self.assertIn("<title>loads</title>", (self.folder / "run.html").read_text(encoding="utf-8"))
        (self.folder / "page.html").symlink_to("run.h5")
        self.assertIn("page.html: the page would replace the results", self.refused("run.h5", "--output", "page.html", "--force"))
        self.assertEqual(self.names(), sorted([*before, "run.html", "page.html"]))

    def test_words(self):
        """The input is told group by group, whatever stands in its comments and texts."""
        text = "&job title = '&fake a = 1' / ! b = 2\n&surface kind = 'cone', half_angle = 1.2 /\n&Solid\n  contact_modulus=1e9 ! R = 3\n/\n&sweep variable = 'load', values(1:2) = 1, 2 /\n"
        self.assertEqual(groups_of(text), [("job", ["title"]), ("surface", ["kind", "half_angle"]), ("solid", ["contact_modulus"]),
                                           ("sweep", ["variable", "values"])])
        self.solve(LOADS.format(strips=4, count=3))
        scene = scene_of(Results(self.folder / "run.h5"))
        self.assertEqual(dict(scene.groups)["foundation"], [("stiffness", "100 MPa/m"), ("relaxation_time", "1 ms"), ("retardation_ratio", "10")])
        sketch = sketch_of(scene)
        self.assertIn("stiffness 100 MPa/m", sketch)
        # columns are springs, and a body that slides has an arrow more than one that is pressed
        self.assertGreater(sketch.count("<polyline"), 10)
        for kind in (*SHAPES, "wave_1d", "heights"):
            heights = [height_of(kind, k / 20) for k in range(-20, 21)]
            self.assertTrue(0 <= min(heights) and max(heights) <= 1, kind)
            self.assertGreater(max(heights) - min(heights), 0.5, kind)

    @unittest.skipUnless(PLAIN.exists() and "ADFRIC_LIBRARY" in os.environ, "there is no .venv, or no library")
    def test_notebook(self):
        """adfric.plot(interactive=True) gives the figures of the page, of a file and of a dataset."""
        self.solve(LOADS.format(strips=4, count=5))
        # the package's own needs come from .venv, and bokeh from here
        here = os.pathsep.join([str(SOURCE / "python"), *(path for path in sys.path if path.endswith("site-packages"))])
        done = subprocess.run([PLAIN, "-c", IN_NOTEBOOK], cwd=self.folder, capture_output=True, text=True, check=False,
                              env={**os.environ, "PYTHONPATH": here, "MPLBACKEND": "Agg"})
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = done.stdout.splitlines()
        self.assertEqual(len(lines), 4, done.stdout)
        for line, words in zip(lines, ("run.h5: y nothing: allowed: ", "data: not with interactive=True", "y: given 2 names", "figure.png: an interactive figure")):
            self.assertIn(words, line)


if __name__ == "__main__":
    main()
