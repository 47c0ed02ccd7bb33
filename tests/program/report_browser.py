# SPDX-License-Identifier: GPL-3.0-or-later
"""Pages of results in a browser without a window and without a network: they are opened, clicked through and compared with the files."""

from environments import ALL_SKIPPED, SOURCE, restart_in

restart_in(".venv_browser", "playwright")

import json  # noqa: E402
import os  # noqa: E402
import shutil  # noqa: E402
import subprocess  # noqa: E402
import sys  # noqa: E402
import tempfile  # noqa: E402
import unittest  # noqa: E402
from pathlib import Path  # noqa: E402

from playwright.sync_api import sync_playwright  # noqa: E402

PROGRAM = os.environ["ADFRIC_PROGRAM"]
REPORT = SOURCE / ".venv_report/bin/python"
BROWSERS = ("chromium", "chromium-browser", "google-chrome")
# exit status: all points are answered, or some did not converge
IN_ORDER = (0, 1)
PATIENCE = 300_000
# a run of two swept variables, of which some points have no equilibrium and none has a doubt
TWO = SOURCE / "inputs/gm2011_fig5.nml"
MAP = SOURCE / "inputs/wave_2d_contact.nml"
FIT = SOURCE / "inputs/fit_friction.nml"
# a title that is not to be taken for a part of the page
LINE = """&job title = 'Fish & <b>chips</b> </script>', output = 'line.h5' /
&surface kind = 'wave_1d', period = 1e-5, amplitude = 1e-7 /
&solid contact_modulus = 1e9 /
&output profiles = .true., x_max = 5e-6, n_x = 33 /
&sweep variable = 'mean_pressure', from = 1e6, to = 40e6, count = 14 /
"""
# what a browser is asked of a model of the page by its name
MODEL = "(name) => Bokeh.documents[0].get_model_by_name(name)"
NUMBERS_OF_FILE = """
import h5py, json, sys
with h5py.File(sys.argv[1]) as file:
    print(json.dumps({name: file[name][()].ravel().tolist() for name in sys.argv[2:]}))
"""
# the cell of a notebook
CELL = """
import sys
sys.path.insert(0, sys.argv[1])
from pathlib import Path
from plotting.results import Results
from reporting.notebook import InteractiveFigure
from reporting.page import page_of
print(InteractiveFigure(page_of([Results(Path(sys.argv[2]))], has_words=False))._repr_html_())
"""


def find_browser():
    """A browser; None where there is none."""
    return next((found for name in BROWSERS if (found := shutil.which(name))), None)


class Browser(unittest.TestCase):
    """A browser for all tests, and a page for each of them."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        playwright = sync_playwright().start()
        cls.addClassCleanup(playwright.stop)
        # the sandbox of the browser needs rights that a container does not give; the pages are the test's own
        cls.browser = playwright.chromium.launch(executable_path=find_browser(), args=["--no-sandbox"])
        cls.addClassCleanup(cls.browser.close)

    def report(self, name, *inputs, options=()):
        """Solve inputs, and write their page."""
        files = []
        for source in inputs:
            text = source if isinstance(source, str) else None
            path = self.folder / f"{name}.nml" if text else source
            if text:
                path.write_text(text)
            command = "fit" if "&free" in path.read_text() else "run"
            files.append(self.folder / f"{path.stem}.h5")
            done = subprocess.run([PROGRAM, command, "--quiet", "--force", "--output", files[-1], path], cwd=self.folder, capture_output=True, text=True,
                                  check=False)
            self.assertIn(done.returncode, IN_ORDER, done.stderr)
        done = subprocess.run([REPORT, SOURCE / "scripts/report.py", *files, "--output", f"{name}.html", "--force", *options], cwd=self.folder,
                              capture_output=True, text=True, check=False, env={**os.environ, "PYTHONPATH": ""})
        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
        return self.open(f"{name}.html")

    def open(self, name):
        """Open a page, which asks nothing of a network and has no error."""
        page = self.browser.new_page(viewport={"width": 1100, "height": 900})
        self.addCleanup(page.close)
        page.set_default_timeout(PATIENCE)
        faults = []
        page.on("pageerror", lambda error: faults.append(str(error)))
        page.on("console", lambda message: faults.append(message.text) if message.type in ("error", "warning") else None)
        page.on("request", lambda request: None if request.url.startswith(("file:", "data:", "blob:", "about:")) else faults.append(request.url))
        self.addCleanup(self.assertEqual, [], faults)
        page.goto((self.folder / name).as_uri())
        page.wait_for_function("window.Bokeh && Bokeh.documents.length && Bokeh.documents[0].is_idle")
        return page

    def numbers(self, name, *datasets):
        """Datasets of a results file."""
        done = subprocess.run([REPORT, "-c", NUMBERS_OF_FILE, self.folder / name, *datasets], capture_output=True, text=True, check=True)
        return json.loads(done.stdout)

    def data(self, page, name):
        """The columns of a source, as lists."""
        return page.evaluate(f"(name) => Object.fromEntries(Object.entries(({MODEL})(name).data)"
                             ".map(([key, column]) => [key, Array.from(column, (one) => ArrayBuffer.isView(one) ? Array.from(one) : one)]))", name)

    def select(self, page, title, value, place=0):
        """Choose from a list by hand."""
        page.locator(f".bk-input-group:has(> label:text-is('{title}')) select").nth(place).select_option(label=value.replace('_', ' '))

    def drag(self, page, name, start, end):
        """Draw the mouse across a figure, from one part of its frame to another."""
        box = page.evaluate(f"""(name) => {{
            const view = Bokeh.index.find_one_by_id(({MODEL})(name).id)
            const frame = view.frame.bbox, outside = view.el.getBoundingClientRect()
            return [outside.x + frame.x0, outside.y + frame.y0, frame.width, frame.height]
        }}""", name)
        page.mouse.move(box[0] + start[0] * box[2], box[1] + start[1] * box[3])
        if end is not None:
            page.mouse.down()
            page.mouse.move(box[0] + end[0] * box[2], box[1] + end[1] * box[3], steps=5)
            page.mouse.up()

    def range(self, page, name, side="x"):
        """The ends of an axis of a figure."""
        return page.evaluate(f"([name, side]) => {{ const range = ({MODEL})(name)[`${{side}}_range`]; return [range.start, range.end] }}", [name, side])

    def assert_curve(self, xs, ys, x, y, factors):
        """A curve of the page is that of the file, without its empty points."""
        found = [(a, b) for a, b in zip(xs, ys) if a is not None and b is not None and a == a and b == b]
        wanted = [(a * factors[0], b * factors[1]) for a, b in zip(x, y) if b == b]
        self.assertEqual(len(found), len(wanted))
        for one, other in zip(found, wanted):
            for a, b in zip(one, other):
                # numbers of the page have 24 bits
                self.assertAlmostEqual(a, b, delta=1e-6 * max(abs(b), 1e-6))

    def test_one_variable(self):
        """A sweep of one variable: its curve, another one by the lists, hover, zoom and reset, and the text of the title as it is."""
        page = self.report("line", LINE)
        self.assertEqual(page.inner_text("h1"), "Fish & <b>chips</b> </script>")
        self.assertEqual(page.title(), "Fish & <b>chips</b> </script>")
        self.assertEqual(page.locator("svg.sketch").count(), 1)
        self.assertIn("14 of 14 points are solved", page.inner_text("body"))
        file = self.numbers("line.h5", "mean_pressure", "contact_fraction", "peak_pressure")
        self.select(page, "y", "contact_fraction")
        lines = self.data(page, "curves1 lines")
        self.assertEqual(len(lines["xs"]), 1)
        self.assert_curve(lines["xs"][0], lines["ys"][0], file["mean_pressure"], file["contact_fraction"], (1e-6, 1.0))
        self.select(page, "y", "peak_pressure")
        self.select(page, "x", "contact_fraction")
        lines = self.data(page, "curves1 lines")
        self.assert_curve(lines["xs"][0], lines["ys"][0], file["contact_fraction"], file["peak_pressure"], (1.0, 1e-6))
        before = self.range(page, "curves1 linear")
        page.locator(".bk-Figure").first.scroll_into_view_if_needed()
        self.drag(page, "curves1 linear", (0.2, 0.3), (0.6, 0.8))
        page.wait_for_function(f"(start) => ({MODEL})('curves1 linear').x_range.start > start", arg=before[0])
        low, high = self.range(page, "curves1 linear")
        self.assertAlmostEqual((low - before[0]) / (before[1] - before[0]), 0.2, delta=0.02)
        self.assertAlmostEqual((high - before[0]) / (before[1] - before[0]), 0.6, delta=0.02)
        page.locator(".bk-tool-icon-reset").first.click()
        page.wait_for_function(f"(start) => ({MODEL})('curves1 linear').x_range.start === start", arg=before[0])
        self.check_hover(page, "curves1", ["contact fraction", "peak pressure", "MPa"])
        self.select(page, "axes", "both logarithmic")
        self.assertFalse(page.evaluate(f"({MODEL})('curves1 linear').visible"))
        self.assertTrue(page.evaluate(f"({MODEL})('curves1 both logarithmic').visible"))
        self.check_profiles(page)

    def check_profiles(self, page):
        """The profiles of the same run: all of them, or that of the slider."""
        self.assertEqual(len(self.data(page, "profiles1 lines")["xs"]), 14)
        page.locator(".noUi-handle").first.focus()
        for _ in range(3):
            page.keyboard.press("ArrowRight")
        lines = self.data(page, "profiles1 lines")
        file = self.numbers("line.h5", "x", "pressure", "mean_pressure")
        self.assertEqual(lines["label"], ["mean pressure 7 MPa"])
        size = len(file["x"])
        self.assert_curve(lines["xs"][0], lines["ys"][0], file["x"], file["pressure"][2 * size:3 * size], (1e6, 1e-6))

    def check_hover(self, page, prefix, words):
        """The mouse on a point shows what it is."""
        point = page.evaluate(f"""(prefix) => {{
            const figure = ({MODEL})(`${{prefix}} linear`), view = Bokeh.index.find_one_by_id(figure.id), data = ({MODEL})(`${{prefix}} points`).data
            const k = Math.floor(data.x.length / 2), outside = view.el.getBoundingClientRect()
            return [outside.x + view.frame.x_scale.compute(data.x[k]), outside.y + view.frame.y_scale.compute(data.y[k])]
        }}""", prefix)
        page.mouse.move(point[0] - 3, point[1])
        page.mouse.move(*point)
        tip = page.locator(".bk-Tooltip").first
        tip.wait_for(state="visible")
        text = tip.evaluate("(tip) => (tip.shadowRoot ?? tip).textContent")
        for word in words:
            self.assertIn(word, text)

    def test_two_variables(self):
        """A sweep of two variables: a curve for each value, or one by the slider; where points have no value; the input."""
        page = self.report("two", TWO)
        text = page.inner_text("body")
        self.assertIn("513 of 562 points are solved", text)
        self.assertIn("adhesion stress 5 kPa, load -0.2 N/m to -0.16 N/m", text)
        file = self.numbers("gm2011_fig5.h5", "load", "friction_stress")
        self.select(page, "y", "friction_stress")
        lines = self.data(page, "curves1 lines")
        self.assertEqual(lines["label"], ["adhesion stress 0 kPa", "adhesion stress 5 kPa"])
        half = len(file["load"])
        self.assert_curve(lines["xs"][1], lines["ys"][1], file["load"], file["friction_stress"][half:], (1.0, 1.0))
        page.locator(".noUi-handle").first.focus()
        page.keyboard.press("ArrowRight")
        page.keyboard.press("ArrowRight")
        lines = self.data(page, "curves1 lines")
        self.assertEqual(lines["label"], ["adhesion stress 5 kPa"])
        # along the other axis the slider of the load chooses
        self.select(page, "x", "adhesion_stress")
        self.assertEqual(len(self.data(page, "curves1 lines")["xs"]), 60)
        self.assertEqual(page.evaluate(f"({MODEL})('curves1 remark').text"), "60 of 281 curves are drawn; a slider chooses others.")
        page.locator("summary", has_text="The input that repeats it").click()
        self.assertEqual(page.locator("pre").inner_text(), TWO.read_text())

    def test_map(self):
        """Maps of a surface, at the value of the slider and of the quantity that is chosen."""
        page = self.report("map", MAP)
        file = self.numbers("wave_2d_contact.h5", "pressure", "gap", "x")
        size = len(file["x"]) ** 2
        for quantity, factor, place in (("pressure", 1e-6, 0), ("gap", 1e9, 0), ("gap", 1e9, 2)):
            self.select(page, "map of", quantity)
            for _ in range(place):
                page.locator(".noUi-handle").last.focus()
                page.keyboard.press("ArrowRight")
            image = page.evaluate(f"Array.from(({MODEL})('surface1 cells').data.image[0])")
            self.assertEqual(len(image), size)
            for found, wanted in zip(image, file[quantity][place * size:(place + 1) * size]):
                self.assertAlmostEqual(found, wanted * factor, delta=1e-6 * max(abs(wanted * factor), 1.0))

    def test_fit(self):
        """A fit: its estimates in words, and residuals beside the data that zoom with them."""
        page = self.report("fit", FIT)
        text = page.inner_text("table.fit")
        for words in ("Work of adhesion", "188.97 mJ/m²", "Shear strength", "963.26 MPa"):
            self.assertIn(words, text)
        file = self.numbers("fit_friction.h5", "abscissa", "ordinate", "residual")
        points = self.data(page, "points 1")
        self.assert_curve(points["x"], points["y"], file["abscissa"], file["ordinate"], (1e9, 1e9))
        self.assert_curve(points["x"], points["residual"], file["abscissa"], file["residual"], (1e9, 1.0))
        before = self.range(page, "residuals 1")
        page.locator("h3", has_text="Fit").scroll_into_view_if_needed()
        page.evaluate(f"Bokeh.index.find_one_by_id(({MODEL})('data 1').id).el.scrollIntoView()")
        self.drag(page, "data 1", (0.3, 0.3), (0.5, 0.6))
        page.wait_for_function(f"(start) => ({MODEL})('residuals 1').x_range.start > start", arg=before[0])
        self.assertEqual(self.range(page, "residuals 1"), self.range(page, "data 1"))

    def test_several_files(self):
        """Two runs on a page: their curves together, each with its title, and a part for each."""
        page = self.report("several", SOURCE / "inputs/johnson1997_fig5.nml", SOURCE / "inputs/johnson1997_fig5_jkr.nml", options=("--y", "friction_force"))
        lines = self.data(page, "together lines")
        self.assertEqual(len(lines["xs"]), 2)
        for place, name in enumerate(("johnson1997_fig5.h5", "johnson1997_fig5_jkr.h5")):
            file = self.numbers(name, "load", "friction_force")
            self.assert_curve(lines["xs"][place], lines["ys"][place], file["load"], file["friction_force"], (1e9, 1e9))
        self.assertEqual(page.locator("svg.sketch").count(), 2)

    def test_notebook(self):
        """What a notebook shows below a cell draws the same curve."""
        page = self.report("line", LINE)
        lines = self.data(page, "curves1 lines")
        done = subprocess.run([REPORT, "-c", CELL, SOURCE / "scripts", "line.h5"], cwd=self.folder, capture_output=True, text=True, check=True)
        (self.folder / "cell.html").write_text(f"<!DOCTYPE html><meta charset='utf-8'><body>{done.stdout}", encoding="utf-8")
        page = self.browser.new_page()
        self.addCleanup(page.close)
        page.goto((self.folder / "cell.html").as_uri())
        frame = page.wait_for_selector("iframe").content_frame()
        frame.wait_for_function("window.Bokeh && Bokeh.documents.length && Bokeh.documents[0].is_idle", timeout=PATIENCE)
        self.assertEqual(self.data(frame, "curves1 lines"), lines)


if __name__ == "__main__":
    for missing, what in ((find_browser() is None, f"none of {', '.join(BROWSERS)}"), (not REPORT.exists(), f"no {REPORT}")):
        if missing:
            print(f"skipped: there is {what}: scripts/setup tests could not install it")
            sys.exit(ALL_SKIPPED)
    unittest.main()
