# SPDX-License-Identifier: GPL-3.0-or-later
"""The tables of the documents can be computed."""

import os
import re
import subprocess
import sys
import unittest
from pathlib import Path

SCRIPTS = Path(__file__).resolve().parents[1]


@unittest.skipUnless("ADFRIC_PROGRAM" in os.environ, "ADFRIC_PROGRAM does not say where the program is")
class TablesTest(unittest.TestCase):
    """From inputs to tables."""

    def check(self, name, *numbers, **pages):
        """The tables are complete, and contain numbers that stand in the document of that name, or in others with theirs."""
        done = subprocess.run([sys.executable, SCRIPTS / f"{name}_tables.py", os.environ["ADFRIC_PROGRAM"]],
                              capture_output=True, text=True)
        self.assertEqual((0, ""), (done.returncode, done.stderr))
        self.assertNotRegex(done.stdout, r"\bnan\b")
        for page, shown in (pages or {name: numbers}).items():
            document = next((SCRIPTS.parent / "docs").glob(f"*/{page}.md")).read_text()
            for number in shown:
                self.assertRegex(done.stdout, rf"\b{re.escape(number)}")
                self.assertIn(number, document)

    def test_wavy(self):
        """Fig. 4 of Goryacheva and Makhovskaya with constants that fit together."""
        self.check("wavy", "0.27428")

    def test_profiles(self):
        """Friction of rubber on an asphalt-like line, the edge rules on a rough line, and a map."""
        self.check("profiles", "0.32472", "2.6343", "0.024212")

    def test_doubts(self):
        """Where theories are off by a tenth."""
        self.check("doubts", "9.9 %", "12.0 %", "9.5 %", "8.9 %")

    def test_columns(self):
        """One wave on columns, a layer and a half-space."""
        self.check("columns", "0.06938", "0.04112", "1.516")

    def test_sphere(self):
        """Figs. 3 and 5 of Johnson, pull-off against lambda, where `auto` takes a limit theory, events, and stick-slip."""
        self.check("sphere", johnson1997=("136.53", "329.30", "2.626293", "0.930351"), round_adhesion=("1.1e-16",),
                   round_branches=("1.95059", "0.83475"), round_peeling=("14.41032", "0.40217"), stick_slip=("9.11896", "0.46016"))


if __name__ == "__main__":
    unittest.main()
