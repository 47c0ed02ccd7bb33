# SPDX-License-Identifier: GPL-3.0-or-later
"""The documentation site: it is built, its pages show what the documents say, and every link inside it leads somewhere.

What builds it stands in an environment of its own (scripts/setup tests), with whose Python this file starts itself again.
"""

import os
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PYTHON = ROOT / ".venv_site/bin/python"
# see tests/CMakeLists.txt
ALL_SKIPPED = 77

if Path(sys.executable) != PYTHON:
    if not PYTHON.exists():
        print(f"skipped: there is no {PYTHON}: scripts/setup tests could not install what builds the site")
        sys.exit(ALL_SKIPPED)
    os.execv(PYTHON, [str(PYTHON), *sys.argv])

sys.path.insert(0, str(ROOT / "scripts"))

import json
import re
import shutil
import subprocess
import tempfile
import threading
import unittest
from collections import Counter
from copy import copy
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from urllib.parse import unquote

from bs4 import BeautifulSoup
from markdown_it import MarkdownIt

from document_links import documents_of, is_inside
from notebooks import PAGES
from site_areas import AREAS
from site_formulas import DISPLAY, INLINE, FormulaError, mathml_of
from site_hooks import WRITTEN
from site_pages import PUBLIC_MODULES, edit_links, source_of
from site_versions import BadVersion, add_version, order_of, versions_in

BROWSER = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
# Where a project may stand.
ADDRESS = "https://example.org/somebody/adfric"
# Parts of a page that have a meaning of their own; paragraphs of lists are no such part.
PARTS = ("h1", "h2", "h3", "h4", "ul", "ol", "li", "table", "tr", "th", "td", "pre", "code", "em", "strong", "a", "img")


def page_of(file):
    """The page of a document, below the folder of the site."""
    return "index.html" if file == "README.md" else re.sub(r"\.md$", ".html", file.replace("README.md", "index.md"))


def without_metadata(text):
    """A document without the lines of YAML that a journal asks for at its beginning; a page does not show them."""
    return re.sub(r"\A---\n.*?\n---\n", "", text, flags=re.DOTALL)


def with_words(text):
    """A document with a word in the place of each formula, and the formulas by these words; code has none."""
    formulas, parts = {}, re.split(r"(^ *```.*?^ *```|`[^`\n]*`)", text, flags=re.MULTILINE | re.DOTALL)

    def put(found):
        word = f"formula{len(formulas)}x"
        formulas[word] = " ".join(found.groups()[-1].split())
        return (found[1] if found.re is DISPLAY else "") + word

    return "".join(part if number % 2 else re.sub(INLINE, put, DISPLAY.sub(put, part)) for number, part in enumerate(parts)), formulas


class QuietHandler(SimpleHTTPRequestHandler):
    """A server that says nothing."""

    def log_message(self, *_):
        """Say nothing."""


class Formulas(unittest.TestCase):
    """Formulas by themselves."""

    def test_set(self):
        """A formula becomes MathML that keeps its source; what cannot be set is said."""
        page = BeautifulSoup(mathml_of("\\frac{a}{b}\n < c"), "html.parser").math
        self.assertEqual(("\\frac{a}{b} < c", "inline", ["a", "b", "c"]), (page["alttext"], page["display"], [part.get_text() for part in page.find_all("mi")]))
        self.assertEqual("block", BeautifulSoup(mathml_of("a", is_display=True), "html.parser").math["display"])
        for formula in ("\\nosuchthing{a}", "{a"):
            with self.assertRaises(FormulaError, msg=formula):
                mathml_of(formula)

    def test_found(self):
        """What is a formula in a line, and what is not."""
        for text, expected in (("a $b$ c", ["b"]), ("($b_1$, $c$)", ["b_1", "c"]), ("$a$b or 7$", []), ("costs $5 and $6", []), ("a \\$b$ c", []),
                               ("$ a$ $b $", [])):
            self.assertEqual(expected, [found[1] for found in re.finditer(INLINE, text)], text)


class Site(unittest.TestCase):
    """The site, built once."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.versions = Path(folder.name, "site")
        cls.folder = cls.versions / "1.10.0"
        # an older version and one that is gone
        (cls.versions / "1.9.2").mkdir(parents=True)
        old = [{"version": name, "title": name, "aliases": []} for name in ("0.1", "1.9.2")]
        (cls.versions / "versions.json").write_text(json.dumps(old))
        result = subprocess.run([PYTHON, ROOT / "scripts/site_pages.py", "--without-figures", "--version", "1.10.0", cls.versions], capture_output=True,
                                text=True, env={**os.environ, "ADFRIC_ADDRESS": ADDRESS})
        if result.returncode or result.stderr or result.stdout != f"{cls.folder}/index.html\n":
            raise AssertionError(f"status {result.returncode}\n{result.stdout}{result.stderr}")
        cls.pages = {path: BeautifulSoup(path.read_text(), "html.parser") for path in sorted(cls.folder.rglob("*.html"))}

    def test_content(self):
        """A page has the words and the parts that its document has where CommonMark, the language of GitHub, is spoken."""
        reader = MarkdownIt("commonmark").enable("table")
        for path in documents_of(ROOT):
            file = path.relative_to(ROOT).as_posix()
            with self.subTest(file):
                text, formulas = with_words(without_metadata(path.read_text()))
                expected = BeautifulSoup(reader.render(text), "html.parser")
                found = copy(self.pages[self.folder / page_of(file)].find("article"))
                for part in [*found.find_all("nav"), *found.find_all(class_=("md-content__button", "notebook"))]:
                    part.decompose()
                words = "".join(expected.get_text().split())
                for word, formula in formulas.items():
                    words = words.replace(word, f"${formula}$".replace(" ", ""))
                for part in found.find_all("math"):
                    part.replace_with(f"${part['alttext']}$")
                self.assertEqual(words, "".join(found.get_text().split()))
                self.assertEqual(*(Counter(part.name for part in page.find_all(PARTS)) for page in (expected, found)))

    def test_formulas(self):
        """No dollar of a formula remains on a page, and there are formulas."""
        count = 0
        for path in documents_of(ROOT):
            page = copy(self.pages[self.folder / page_of(path.relative_to(ROOT).as_posix())].find("article"))
            count += len(page.find_all("math"))
            for part in page.find_all(["math", "code", "pre"]):
                part.decompose()
            self.assertNotRegex(page.get_text(), r"\$[^$]+\$", path.name)
        self.assertGreater(count, 10)

    def test_links(self):
        """Links and pictures lead to files and places that are there."""
        faults, count = [], 0
        for path, page in self.pages.items():
            for part in page.find_all(["a", "img", "link", "script"]):
                link = part.get("href") or part.get("src")
                # the page of what is not found stands at any place
                if not link or not is_inside(link) or path.name == "404.html":
                    continue
                target, _, anchor = unquote(link).partition("#")
                file = (path.parent / target.partition("?")[0]).resolve() if target else path
                count += 1
                if not file.is_file():
                    faults.append(f"{path.relative_to(self.folder)}: {link}: there is no such file")
                # FORD knows some places by two names
                elif anchor and "fortran" not in path.parts and not self.pages[file].find(attrs={"id": anchor}):
                    faults.append(f"{path.relative_to(self.folder)}: {link}: there is no such place")
        self.assertEqual([], faults, "\n" + "\n".join(sorted(set(faults))))
        self.assertGreater(count, 1000)

    def test_no_server(self):
        """No page reads anything from another place."""
        for path, page in self.pages.items():
            for part in page.find_all(["img", "link", "script"]):
                link = part.get("href") or part.get("src") or ""
                self.assertTrue(is_inside(link) or part.get("rel") == ["canonical"], f"{path.relative_to(self.folder)}: {link}")

    def test_menu(self):
        """Every page of the areas can be chosen on the first page, and the areas stand above it."""
        page = self.pages[self.folder / "index.html"]
        links = {link["href"].partition("#")[0] or "index.html" for menu in page.find_all("nav") for link in menu.find_all("a", href=True)}
        there = {page_of(file) for pages in AREAS.values() for file in pages.values()}
        self.assertEqual(set(), there - links)
        tabs = [" ".join(tab.get_text().split()) for tab in page.find(class_="md-tabs").find_all("a")]
        self.assertEqual(list(AREAS), tabs)

    def test_edit_links(self):
        """Each page that somebody writes leads to where it is edited, if the project has an address, and no other page does."""
        for path in documents_of(ROOT):
            file = path.relative_to(ROOT).as_posix()
            links = [link["href"] for link in self.pages[self.folder / page_of(file)].find_all("a", class_="md-content__button")]
            self.assertEqual([] if file in WRITTEN else [f"{ADDRESS}/edit/main/{file}"], links, file)
        self.assertEqual({}, edit_links(""))
        for address in ("example.org", "javascript:alert(1)", "https://example.org/a b"):
            with self.assertRaises(SystemExit) as found:
                edit_links(address)
            self.assertIn("ADFRIC_ADDRESS", found.exception.code)

    def test_proofs(self):
        """The proofs of a page stand in a box of their own, which ends before the sources."""
        pages = [path for path in documents_of(ROOT) if "\n## Proofs\n" in path.read_text()]
        self.assertGreater(len(pages), 20)
        for path in pages:
            boxes = self.pages[self.folder / page_of(path.relative_to(ROOT).as_posix())].find_all("section", class_="proofs")
            self.assertEqual([["proofs"]], [[head["id"] for head in box.find_all("h2")] for box in boxes], path.name)

    def test_notebooks(self):
        """Pages that are notebooks, too, offer them, and these are files of the site."""
        found = {path.stem: link["href"] for path, page in self.pages.items() for part in page.find_all(class_="notebook") for link in part.find_all("a")}
        self.assertEqual({name: f"{name}.ipynb" for name in (*PAGES, "tutorial")}, found)
        for name in found:
            cells = json.loads((self.folder / f"docs/guide/{name}.ipynb").read_text())["cells"]
            self.assertGreater(sum(cell["cell_type"] == "code" for cell in cells), 2, name)

    def test_versions(self):
        """The versions that are there are listed, the newest first, and the first page leads to it."""
        self.assertEqual(["1.10.0", "1.9.2"], [entry["version"] for entry in versions_in(self.versions)])
        self.assertIn('url=1.10.0/index.html"', (self.versions / "index.html").read_text())
        self.assertEqual(["2.0", "1.10.0", "1.9.2", "1.9", "development"], sorted(("1.9", "development", "1.9.2", "2.0", "1.10.0"), key=order_of))
        with tempfile.TemporaryDirectory() as name:
            for bad in ("../x", "", "versions.json", "a b"):
                with self.assertRaises(BadVersion, msg=bad):
                    add_version(name, bad)
            Path(name, "versions.json").write_text('{"a": 1}')
            with self.assertRaisesRegex(BadVersion, "not a list of versions"):
                add_version(name, "1.0")

    @unittest.skipUnless(BROWSER, "there is no Chromium")
    def test_selector(self):
        """A browser shows the selector of versions on a page, once there is a server."""
        server = ThreadingHTTPServer(("127.0.0.1", 0), partial(QuietHandler, directory=self.versions))
        thread = threading.Thread(target=server.serve_forever, daemon=True)
        thread.start()
        self.addCleanup(thread.join)
        self.addCleanup(server.server_close)
        self.addCleanup(server.shutdown)
        done = subprocess.run([BROWSER, "--headless", "--no-sandbox", "--disable-gpu", "--dump-dom", "--virtual-time-budget=20000",
                               f"--user-data-dir={self.versions.parent}/browser", f"http://127.0.0.1:{server.server_port}/1.10.0/docs/guide/install.html"],
                              capture_output=True, text=True, timeout=120, check=True)
        page = BeautifulSoup(done.stdout, "html.parser")
        self.assertEqual("1.10.0", page.find(class_="md-version__current").get_text().strip())
        self.assertEqual(["1.10.0", "1.9.2"], [link.get_text().strip() for link in page.find_all(class_="md-version__link")])

    def test_dark(self):
        """Each page of the documents can be dark."""
        for path in documents_of(ROOT):
            page = self.pages[self.folder / page_of(path.relative_to(ROOT).as_posix())]
            schemes = [choice["data-md-color-scheme"] for choice in page.find_all("input", attrs={"data-md-color-scheme": True})]
            self.assertEqual(["default", "slate"], schemes, path.name)

    def test_search(self):
        """The search has every page of the documents and what stands there; what searches is a file of the site."""
        index = json.loads((self.folder / "search/search_index.json").read_text())
        found = {entry["location"].partition("#")[0] or "index.html" for entry in index["docs"]}
        self.assertEqual(set(), {page_of(path.relative_to(ROOT).as_posix()) for path in documents_of(ROOT)} - found)
        self.assertTrue(any("glossary.html" in entry["location"] and "pull-off" in entry["text"] for entry in index["docs"]))
        worker = json.loads(self.pages[self.folder / "index.html"].find("script", id="__config").string)["search"]
        self.assertTrue((self.folder / worker).is_file(), worker)

    @unittest.skipUnless(BROWSER, "there is no Chromium")
    def test_gallery(self):
        """The filter of the gallery leaves the figures that have its words, as a browser shows them."""
        shown, everything = {}, len(self.pages[self.folder / "docs/gallery.html"].find("article").find_all("h3"))
        for words in ("", "johnson+fig.+5", "no-such-word"):
            done = subprocess.run([BROWSER, "--headless", "--no-sandbox", "--disable-gpu", "--dump-dom", f"--user-data-dir={self.folder.parent}/browser",
                                   f"file://{self.folder}/docs/gallery.html?filter={words}"], capture_output=True, text=True, timeout=120, check=True)
            page = BeautifulSoup(done.stdout, "html.parser")
            shown[words] = [part.get_text() for part in page.find("article").find_all("h3") if not part.has_attr("hidden")]
            self.assertEqual(f"{len(shown[words])} figures", page.find(id="gallery-count").get_text())
        self.assertGreater(everything, 50)
        self.assertEqual(everything, len(shown[""]))
        self.assertTrue(any("Johnson 1997, Fig. 5" in heading for heading in shown["johnson+fig.+5"]))
        self.assertLess(len(shown["johnson+fig.+5"]), everything // 4)
        self.assertEqual([], shown["no-such-word"])

    def fortran_pages(self, module):
        """The words of the page of a module, and of those of its types, with single spaces."""
        page = self.pages[self.folder / f"fortran/module/{module}.html"]
        types = {Path(link["href"]).name.partition("#")[0] for link in page.find_all("a", href=re.compile(r"\.\./type/"))}
        words = [page.get_text()] + [self.pages[self.folder / "fortran/type" / name].get_text() for name in sorted(types)]
        return re.sub(r"\s+", " ", " ".join(words))

    def test_fortran(self):
        """Each procedure of a public module stands on the page of the module, with its arguments and what they mean."""
        for module in PUBLIC_MODULES:
            text = source_of(module).read_text()
            page = self.fortran_pages(module)
            lists = re.findall(r"^ *(?:public|procedure) :: (.*)$", text, re.MULTILINE)
            public = {name.strip() for names in lists for name in names.split(",")}
            named = re.findall(r"^ *(?:elemental |pure |impure )*(?:subroutine|function) (\w+)\(", text, re.MULTILINE)
            own = public & set(named)
            self.assertTrue(own, module)
            for name in own:
                self.assertRegex(page, rf"\b(?:subroutine|function) {name} ?\(", module)
                comment = re.search(rf"!> (.*)\n(?: *!>.*\n)* *(?:\w+ )*(?:subroutine|function) {name}\(", text)[1]
                self.assertIn(comment.replace("`", ""), page)


if __name__ == "__main__":
    unittest.main()
