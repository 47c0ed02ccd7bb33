# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/validation/misprints.md and docs/paper/results.md: their blocks of Python run as they stand, and print what stands behind them."""

import os
import re
import subprocess
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from runs import main  # noqa: E402

SOURCE = Path(os.environ["ADFRIC_SOURCE"])
# pages, with the least number of their blocks
PAGES = {"docs/validation/misprints.md": 12, "docs/paper/results.md": 5}
# the index of the figures, tables and equations of the sources
INDEX = "docs/validation/published.md"
BLOCK = re.compile(r"^```python\n(.*?)^```\n\n```text\n(.*?)^```$", re.MULTILINE | re.DOTALL)
# a test of a file, as the page names it
NAMED = re.compile(r"((?:`test_\w+`(?:,| and)? ?)+) of `(tests/[\w/.]+)`|`(tests/[\w/.]+)`((?:, `test_\w+`)*)")


class Misprints(unittest.TestCase):
    @unittest.skipUnless("ADFRIC_LIBRARY" in os.environ, "there is no shared library")
    def test_blocks(self):
        """Every block of Python has its output behind it, and prints it."""
        environment = {**os.environ, "PYTHONPATH": str(SOURCE / "python"), "OMP_NUM_THREADS": "2"}
        for page, least in PAGES.items():
            text = (SOURCE / page).read_text()
            blocks = BLOCK.findall(text)
            self.assertEqual(text.count("```python"), len(blocks), page)
            self.assertGreaterEqual(len(blocks), least, page)
            for code, expected in blocks:
                with self.subTest(code.splitlines()[-1]):
                    done = subprocess.run([sys.executable, "-c", code], cwd=SOURCE, env=environment, capture_output=True, text=True, check=False)
                    self.assertEqual(0, done.returncode, done.stderr)
                    self.assertEqual(expected, done.stdout)

    def test_named_tests(self):
        """Every test that a page of validation or the page of results names is there."""
        for page in (*sorted((SOURCE / "docs/validation").glob("*.md")), SOURCE / "docs/paper/results.md"):
            for before, file, other, behind in NAMED.findall(page.read_text()):
                path = SOURCE / (file or other)
                self.assertTrue(path.exists(), f"{page.name}: {path}")
                for name in re.findall(r"test_\w+", before or behind) if path.is_file() else ():
                    self.assertRegex(path.read_text(), rf"\b{name}\b", page.name)

    def test_index(self):
        """Every input, file and table that the index of published figures names is there, and every input of a source is in it."""
        text = (SOURCE / INDEX).read_text()
        inputs, tables = ({path.stem for path in (SOURCE / folder).glob(pattern)} for folder, pattern in
                          (("inputs", "*.nml"), ("tests/reference", "*.csv")))
        named = set(re.findall(r"`([\w/.]+)`", text))
        # numbers and results stand between such marks, too
        words = {name for name in named if re.match("(gm|fig|md|yas|bisine|eq|johnson|lecture|punch|hertz|wave|line|strip|point|fit|edge)[0-9_]", name)}
        self.assertGreater(len(words), 60)
        self.assertEqual(set(), words - inputs - tables)
        self.assertEqual([], [name for name in sorted(named) if "/" in name and not (SOURCE / name).exists()])
        of_sources = {name for name in inputs if re.match("(gm2011|johnson1997|lecture|punch|rigid_punch|hertz|line_load|strip_load|point_load)", name)}
        self.assertGreater(len(of_sources), 30)
        self.assertEqual(set(), of_sources - named)


if __name__ == "__main__":
    main()
