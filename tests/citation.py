# SPDX-License-Identifier: GPL-3.0-or-later
"""CITATION.cff keeps the Citation File Format 1.2.0, as far as the project uses it; the files of .github are in order.

A reader of YAML stands in the environment of the site (scripts/setup tests), with whose Python this file starts itself again.
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
        print(f"skipped: there is no {PYTHON}: scripts/setup tests could not install what reads YAML")
        sys.exit(ALL_SKIPPED)
    os.execv(PYTHON, [str(PYTHON), *sys.argv])

import re
import unittest

import yaml

# What a file must have, what else it may have here, and the same for an article and for people and entities.
FILE = ({"cff-version", "message", "title", "authors"},
        {"type", "abstract", "version", "date-released", "license", "keywords", "references", "repository-code", "url", "doi"})
ARTICLE = ({"type", "title", "authors"}, {"journal", "volume", "issue", "year", "start", "end", "doi", "notes"})
PERSON = ({"family-names", "given-names"}, {"orcid", "affiliation"})
ENTITY = ({"name"}, {"website"})


def faults_of(citation):
    """What is wrong with the content of a file, as text."""
    faults = faults_of_keys("file", citation, FILE) + faults_of_authors("file", citation)
    for key, value in (("cff-version", "1.2.0"), ("type", "software"), ("license", "GPL-3.0-or-later")):
        if citation.get(key) != value:
            faults.append(f"{key} is not {value}")
    # a number or a date of YAML would not be the text that the format asks for
    faults += [f"{key} is no text" for key in ("message", "title", "abstract", "version") if not isinstance(citation.get(key), str)]
    if not all(isinstance(word, str) for word in citation.get("keywords", [])):
        faults.append("a keyword is no text")
    for number, article in enumerate(citation.get("references", []), 1):
        place = f"reference {number}"
        faults += faults_of_keys(place, article, ARTICLE) + faults_of_authors(place, article)
        faults += [f"{place}: {key} is no number" for key in ("year",) if not isinstance(article.get(key), int)]
        if not re.fullmatch(r"10\.\d{4,}/\S+", article.get("doi", "10.0000/none")):
            faults.append(f"{place}: doi is none")
    return faults


def faults_of_keys(place, found, keys):
    """Keys that are missing, and keys that are not known."""
    needed, allowed = keys
    return ([f"{place}: no {key}" for key in sorted(needed - found.keys())]
            + [f"{place}: {key} is not known" for key in sorted(found.keys() - needed - allowed)])


def faults_of_authors(place, found):
    """An author is a person or an entity."""
    return [fault for author in found.get("authors", [])
            for fault in faults_of_keys(f"{place}, author", author, ENTITY if "name" in author else PERSON)]


class Citation(unittest.TestCase):
    """The files as they are, and content with faults."""

    def setUp(self):
        self.citation = yaml.safe_load((ROOT / "CITATION.cff").read_text())

    def test_file(self):
        """The file keeps the format."""
        self.assertEqual([], faults_of(self.citation))

    def test_wrong(self):
        """What is missing, what is not known, and values of the wrong kind."""
        for change, expected in (({"version": 0.1}, ["version is no text"]), ({"licence": "MIT"}, ["file: licence is not known"]),
                                 ({"license": "MIT"}, ["license is not GPL-3.0-or-later"]),
                                 ({"keywords": [1997]}, ["a keyword is no text"]),
                                 ({"authors": [{"family-names": "A"}]}, ["file, author: no given-names"]),
                                 ({"references": [{"type": "article", "title": "A", "authors": [{"name": "B"}],
                                                   "year": 1997, "doi": "A"}]}, ["reference 1: doi is none"])):
            self.assertEqual(expected, faults_of(self.citation | change))
        del self.citation["title"]
        self.assertEqual(["file: no title", "title is no text"], faults_of(self.citation))

    def test_workflow(self):
        """Each job tests each preset of scripts/test."""
        workflow = yaml.safe_load((ROOT / ".github/workflows/ci.yml").read_text())
        named = re.search(r"^ *(release \| .*)\) presets=\(", (ROOT / "scripts/test").read_text(), re.MULTILINE)[1].split(" | ")
        for system in ("ubuntu", "debian"):
            job = workflow["jobs"][system]
            self.assertEqual(named, job["strategy"]["matrix"]["preset"])
            self.assertIn("scripts/test ${{ matrix.preset }}", [step.get("run") for step in job["steps"]])

    def test_command(self):
        """What the submission of a change runs is the test command of README, with a limit of time before it."""
        command = re.search(r"^(scripts/test)$", (ROOT / "README.md").read_text(), re.MULTILINE)[1]
        last = (ROOT / ".ci/run").read_text().splitlines()[-1]
        self.assertRegex(last, rf"^timeout --kill-after=\d+ \d+ {re.escape(command)}$")

    def test_templates(self):
        """Templates of issues have a name and say what they are for."""
        files = sorted((ROOT / ".github/ISSUE_TEMPLATE").glob("*.md"))
        self.assertTrue(files)
        for path in files:
            head = yaml.safe_load(path.read_text().split("---\n")[1])
            self.assertEqual({"name", "about"}, head.keys(), path.name)


if __name__ == "__main__":
    unittest.main()
