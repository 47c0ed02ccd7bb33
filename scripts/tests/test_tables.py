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

    def check(self, name, **pages):
        """The tables are complete, and contain numbers that stand in the documents, given by page."""
        done = subprocess.run([sys.executable, SCRIPTS / f"{name}_tables.py", os.environ["ADFRIC_PROGRAM"]],
                              capture_output=True, text=True)
        self.assertEqual((0, ""), (done.returncode, done.stderr))
        self.assertNotRegex(done.stdout, r"\bnan\b")
        for page, numbers in pages.items():
            shelf, _, file = page.partition("_")
            document = (SCRIPTS.parent / "docs" / shelf / f"{file}.md").read_text()
            for number in numbers:
                self.assertRegex(done.stdout, rf"\b{re.escape(number)}")
                self.assertIn(number, document)

    def test_wavy(self):
        """Fig. 4 of Goryacheva and Makhovskaya with constants that fit together, and what the edge rule changes."""
        self.check("wavy", theory_columns_strips=["0.27428"], theory_columns_adhesion=["0.089228", "0.21299"])

    def test_profiles(self):
        """Friction of rubber on an asphalt-like line, the edge rules on a rough line, and a map."""
        self.check("profiles", theory_columns_any_shape=["0.29878", "0.024212"], theory_columns_material=["0.32472", "2.6343"])

    def test_doubts(self):
        """Where theories are off by a tenth."""
        self.check("doubts", reference_doubts=["9.9 %", "12.0 %", "9.5 %", "8.9 %"])

    def test_columns(self):
        """One wave on columns, a layer and a half-space."""
        self.check("columns", guide_columns=["0.06938", "0.04112", "1.516"])

    def test_sphere(self):
        """Figs. 3 and 5 of Johnson, pull-off against lambda, where `auto` takes a limit theory, events, and stick-slip."""
        self.check("sphere", theory_johnson1997=("136.53", "329.30", "2.626293", "0.930351"), theory_round_adhesion=("1.1e-16",),
                   theory_round_branches=("1.95059", "0.83475"), theory_round_peeling=("14.41032", "0.40217"), theory_stick_slip=("9.11896", "0.46016"))


if __name__ == "__main__":
    unittest.main()
