# SPDX-License-Identifier: GPL-3.0-or-later
"""The documents can be read: sentences and lines are short, words mean one thing, and every block says what it is in.

What is counted stands in scripts/document_prose.py; the words that are not used stand in docs/reference/glossary.md. Whether commands run
is for program/readme.py, whether inputs are solved for program/guide.py.
"""

import re
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "scripts"))

from document_links import documents_of  # noqa: E402
from document_prose import (GLOSSARY, MEASURED_ELSEWHERE, SHOWN_ELSEWHERE, WRITTEN, banned_words, faults_of_blocks, faults_of_formulas, faults_of_lines,  # noqa: E402
                            faults_of_numbers, faults_of_prose, faults_of_sentences, faults_of_words, prose_of)
from reference_pages import WRITTEN as REFERENCE  # noqa: E402

# Pages that are not yet written for readers. A page leaves this list for good once it has no fault.
NOT_YET = ()
# Shelves whose measured numbers have a source in the same section, beside the validation.
NUMBERED = (("docs", "guide"), ("docs", "theory"), ("docs", "paper"))
BANNED = {"way": ("path", ["half way", "in the same way"]), "room": ("workspace", ["room temperature"])}


class Prose(unittest.TestCase):
    """The documents as they are, and texts with faults."""

    def test_documents(self):
        """A page for readers has no fault."""
        banned = banned_words((ROOT / GLOSSARY).read_text())
        pages = [path for path in documents_of(ROOT) if path.relative_to(ROOT).as_posix() not in (*WRITTEN, *NOT_YET)]
        faults = [f"{path.relative_to(ROOT).as_posix()}:{fault}" for path in pages for fault in faults_of_prose(path.read_text(), banned)]
        self.assertEqual([], faults, "\n" + "\n".join(faults))
        self.assertGreater(len(pages), 20)
        self.assertGreater(sum(1 for path in pages for _ in prose_of(path.read_text())), 500)

    def test_not_yet(self):
        """A page that has become readable, or is gone, leaves the list."""
        banned = banned_words((ROOT / GLOSSARY).read_text())
        self.assertEqual([], [name for name in NOT_YET if not (ROOT / name).exists() or not faults_of_prose((ROOT / name).read_text(), banned)])

    def test_lines_of_written_pages(self):
        """What a program writes for the reference has no longer lines, but for the code that it repeats."""
        for name in REFERENCE:
            with self.subTest(name):
                text = re.sub(r"(?ms)^```.*?^```$", "", (ROOT / name).read_text())
                self.assertEqual([], faults_of_lines(text))

    def test_ban_list(self):
        """The glossary has the list, and every word has another in its place."""
        banned = banned_words((ROOT / GLOSSARY).read_text())
        self.assertLessEqual({"way", "place", "held", "room", "march", "left"}, set(banned))
        self.assertTrue(all(instead for instead, _ in banned.values()))
        rows = "| way | path | half way |\n| | | by the way |\n| march | time stepping | |\n"
        self.assertEqual({"way": ("path", ["half way", "by the way"]), "march": ("time stepping", [])}, banned_words(
            f"# Words\n\n## Words that are not used\n\nText.\n\n| not | but | usual |\n| --- | --- | --- |\n{rows}\nMore | a | b |\n"))
        self.assertEqual({}, banned_words("# Words\n"))

    def test_sentences(self):
        """A sentence has at most 25 words, in a paragraph, an item, a quotation and a cell; 15 are the mean of a page."""
        right, wrong = " ".join(["word"] * 25), " ".join(["word"] * 26)
        short = "One word. " * 30
        fault = "a sentence of 26 words: word word word word word word ..."
        self.assertEqual([], faults_of_sentences(f"# {wrong}\n\n{right}. {right}! {short}"))
        self.assertEqual([f"3: {fault}"], faults_of_sentences(f"# A\n\n{short}\n{wrong}.\n"))
        self.assertEqual([f"3: {fault}"], faults_of_sentences(f"{short}\n- a\n- {wrong}\n"))
        self.assertEqual([f"3: {fault}"], faults_of_sentences(f"{short}\n\n> {wrong}\n"))
        self.assertEqual([f"4: {fault}"], faults_of_sentences(f"{short}\n\n| a | b |\n| {right} | {wrong} |\n"))
        self.assertEqual(["1: sentences have 16.0 words on average"], faults_of_sentences(" ".join(["word"] * 16) + "."))
        self.assertEqual([], faults_of_sentences(" ".join(["word"] * 15) + "."))

    def test_words_of_sentences(self):
        """Lines are joined; code, formulas, links, initials and sources are what a reader takes them for."""
        for text, count in (("a\nb c.", [3]), ("a `b c. d` e.", [3]), ("a $b + c.\\ d$ e.", [3]), ("[a b](c.md) d. E", [3, 1]),
                            ("[a b][c d] e [-]. F\n\n[c d]: e.md\n", [3, 1]),
                            ("See Fig. 3 of J. C. Hay (J. C. Hay, J. Mater. Res. 14 (1999) 2296). Next.", [7, 1]),
                            ("It is 1.5 m - or 2.5. A b.", [6, 2]), ("**Ab.** C d.", [1, 2]), ("a load P. The next", [3, 2]), ("Ab?  C! \"De.\" F", [1, 1, 1, 1])):
            self.assertEqual(count, [len(words) for _, words in prose_of(text)], text)
        self.assertEqual([], list(prose_of("# A b\n\n```sh\na b\n```\n\n$$\na b\n$$\n\n| a | b |\n\n<!-- a b -->\n")))

    def test_lines(self):
        """A line has at most 120 characters, and so has a row of a table, but for links alone and what a program prints."""
        long = "a" * 121
        self.assertEqual(["2: a line of 121 characters", "3: a line of 123 characters"], faults_of_lines(f"{long[1:]}\n{long}\n- {long}\n"))
        link = f"[a](https://example.org/{long})"
        self.assertEqual([], faults_of_lines(f"```text\n{long}\n```\n\n{link}\n\n- {link}.\n\n!{link}\n"))
        self.assertEqual(["2: a line of 121 characters", "6: a line of 121 characters", "9: a line of 125 characters"],
                         faults_of_lines(f"```sh\n{long}\n```\n\n$$\n{long}\n$$\n\n| {long} |\n"))
        self.assertEqual(["1: a line of 150 characters", "3: a line of 126 characters"], faults_of_lines(f"and {link}\n\n[a]: {long}\n"))

    def test_blocks(self):
        """Blocks say what they are in, commands stand alone, and formulas have no thin spaces."""
        self.assertEqual([], faults_of_blocks("a\n\n```sh\nadfric run a.nml      # solves it\n```\n\n- a\n  b\n\n```text\na     b\n```\n"))
        self.assertEqual(["3: a block that does not say what it is in", "6: a block in ''", "9: a block in 'fortan'"],
                         faults_of_blocks("a\n\n    adfric run\n    adfric\n\n```\na\n```\n```fortan\na\n```\n"))
        self.assertEqual(["3: words behind a command"], faults_of_blocks("```sh\nadfric check a.nml\nadfric run a.nml      solves it\n```\n"))
        self.assertEqual(["2: \\, in a formula"], faults_of_formulas("$a b$\n$a\\,b$\n"))

    def test_pages_of_guide_and_theory(self):
        """A page of the guide or the theory shows a figure; one of the theory has a table of its symbols with their units."""
        guide, theory = (sorted((ROOT / "docs" / shelf).glob("*.md")) for shelf in ("guide", "theory"))
        self.assertGreater(min(len(guide), len(theory)), 15)
        self.assertEqual([], [path.name for path in (*guide, *theory) if not re.search(r"^!\[[^]]+\]\(\S+\.png\)", path.read_text(), re.MULTILINE)])
        for path in theory:
            tables = re.findall(r"^\| symbol \|.*\| unit \|\n\|[ -|]+\n((?:\|.*\n)+)", path.read_text(), re.MULTILINE)
            self.assertTrue(tables, f"{path.name}: no table of symbols")
            rows = [line.rstrip("|").rpartition(" | ") for table in tables for line in table.splitlines()]
            self.assertEqual([], [row for row in rows if not row[2].strip() and "[" not in row[0] or "$" not in row[0]], path.name)

    def test_numbers(self):
        """A section of the validation says which command, test or file has its numbers."""
        pages = sorted((ROOT / "docs/validation").glob("*.md"))
        self.assertGreater(len(pages), 5)
        faults = [f"{path.name}:{fault}" for path in pages for fault in faults_of_numbers(path.read_text())]
        self.assertEqual([], faults, "\n" + "\n".join(faults))
        fault = "numbers without the command that gives them"
        self.assertEqual([f"1: {fault}: # A", f"7: {fault}: ## C"], faults_of_numbers("# A\n\nIt is 0.5.\n\n## B\n\n## C\n\n| 3 % |\n"))
        self.assertEqual([], faults_of_numbers("# A\n\nIt is 0.5, `bench/run a`.\n\n## B\n\nIt is $0.5$, or [0.5](a.md).\n\n## C\n\n2 %\n\n```sh\na\n```\n"))

    def test_numbers_elsewhere(self):
        """So do sections of the other pages, where a number has a unit or four decimals."""
        pages = [path for path in documents_of(ROOT) if path.relative_to(ROOT).parts[:2] in NUMBERED or path.name == "README.md"]
        self.assertGreater(len(pages), 45)
        faults = [f"{path.relative_to(ROOT)}:{fault}" for path in pages
                  for fault in faults_of_numbers(path.read_text(), MEASURED_ELSEWHERE, SHOWN_ELSEWHERE)]
        self.assertEqual([], faults, "\n" + "\n".join(faults))
        for text, is_fault in (("It is 0.5, and by (2.12) of section 4.3.", False), ("It takes 3 %.", True), ("1.7841 at most.", True),
                               ("It takes 3 %, `src/base/kinds.f90`.", False), ("It is 2.1 um.", True), ("A load [N] of 3 N/m", True),
                               ("It falls from 3 m, `bench/run a`.", False), ("Of 1 method and 2 Kelvin arms 3 more.", False)):
            self.assertEqual(is_fault, bool(faults_of_numbers(f"# A\n\n{text}\n", MEASURED_ELSEWHERE, SHOWN_ELSEWHERE)), text)

    def test_banned(self):
        """A word of the list is found in prose, headings and tables, not in code, and not in its usual phrases."""
        self.assertEqual([], faults_of_words("Half\nway there, in the same way, always `way`.\n\n```sh\nroom\n```\n", BANNED))
        self.assertEqual(["1: 'way', better path", "4: 'ways', better path", "6: 'room', better workspace", "8: 'way', better path"], faults_of_words(
            "# A Way\n\nRoom temperature\ngoes two ways.\n\n| room | `room` |\n\n[a way](way.md)\n", BANNED))


if __name__ == "__main__":
    unittest.main()
