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

import re
import subprocess
import tempfile
import unittest
from collections import Counter
from urllib.parse import unquote

from bs4 import BeautifulSoup
from markdown_it import MarkdownIt

from document_links import documents_of, is_inside
from site_areas import AREAS
from site_pages import PUBLIC_MODULES, source_of

# Parts of a page that have a meaning of their own; paragraphs of lists are no such part.
PARTS = ("h1", "h2", "h3", "h4", "ul", "ol", "li", "table", "tr", "th", "td", "pre", "code", "em", "strong", "a", "img")


def page_of(file):
    """The page of a document, below the folder of the site."""
    return "index.html" if file == "README.md" else re.sub(r"\.md$", ".html", file.replace("README.md", "index.md"))


class Site(unittest.TestCase):
    """The site, built once."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name, "site")
        result = subprocess.run([PYTHON, ROOT / "scripts/site_pages.py", cls.folder], capture_output=True, text=True)
        if result.returncode or result.stderr or result.stdout != f"{cls.folder}/index.html\n":
            raise AssertionError(f"status {result.returncode}\n{result.stdout}{result.stderr}")
        cls.pages = {path: BeautifulSoup(path.read_text(), "html.parser") for path in sorted(cls.folder.rglob("*.html"))}

    def test_content(self):
        """A page has the words and the parts that its document has where CommonMark, the language of GitHub, is spoken."""
        reader = MarkdownIt("commonmark").enable("table")
        for path in documents_of(ROOT):
            file = path.relative_to(ROOT).as_posix()
            with self.subTest(file):
                expected = BeautifulSoup(reader.render(path.read_text()), "html.parser")
                found = self.pages[self.folder / page_of(file)].find(attrs={"itemprop": "articleBody"})
                self.assertEqual("".join(expected.get_text().split()), "".join(found.get_text().split()))
                self.assertEqual(*(Counter(part.name for part in page.find_all(PARTS)) for page in (expected, found)))

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
        """Every page of the areas can be chosen on the first page."""
        menu = self.pages[self.folder / "index.html"].find("nav")
        links = {link["href"].partition("#")[0] or "index.html" for link in menu.find_all("a", href=True)}
        there = {page_of(file) for pages in AREAS.values() for file in pages.values()}
        self.assertEqual(set(), there - links)

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
