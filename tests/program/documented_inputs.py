# SPDX-License-Identifier: GPL-3.0-or-later
"""Every whole input of every document is solved as it stands, the numbers below it are those of the run, and every choice has an input.

A whole input has a surface or tractions on a solid. A block of text behind "This is `NAME.csv`:" is the table that inputs name. A block
of text behind an input, with lines such as `load [N]   1.5e-3   2e-3`, has results of it, to the digits that are printed.
"""

import os
import re
import shutil
import sys
from pathlib import Path

import h5py
import numpy as np

from input_runs import InputRuns
from runs import main

SOURCE = Path(os.environ["ADFRIC_SOURCE"])
sys.path.insert(0, str(SOURCE/"scripts"))

from document_links import documents_of  # noqa: E402
from document_prose import blocks_of  # noqa: E402

TABLE = re.compile(r"This is `([\w.]+)`:$")
PRINTED = re.compile(r"(\w+) \[[^\]]+\]((?: +-?[\d.]+(?:e[-+]?\d+)?)+) *$")
# Pages whose inputs are run by readme.py, with the files that other blocks of these pages make.
RUN_ELSEWHERE = ("README.md", "docs/guide/first_run.md")
# Files of commands that need the Python environments of imports; import_surface.py runs these commands.
MADE_BY_IMPORTS = {"line_scan.h5", "dma.h5"}
# Pages whose sweeps go beyond the last equilibrium.
WITHOUT_ANSWERS = ("docs/guide/friction_of_a_tip.md",)
# The tip of the page of fits, whose curve a user has measured.
CURVE = "&surface kind = 'rounded_cone', slope = 0.3, radius = 20e-9 /\n&solid young_modulus = 2e9, poisson_ratio = 0.5 /\n" \
        "&sweep variable = 'approach', from = 0.0, to = 4e-8, count = 60 /\n"


def whole_inputs():
    """Page, line and text of each whole input, and the lines of the block of text that follows it before any other block."""
    for path in documents_of(SOURCE):
        page = path.relative_to(SOURCE).as_posix()
        blocks = [block for block in blocks_of(path.read_text())]
        for place, (kind, number, lines) in enumerate(blocks):
            text = "\n".join(lines) + "\n"
            if kind == "code fortran" and text.startswith("&") and ("&surface" in text and "&solid" in text or "&traction" in text):
                after = blocks[place + 1:place + 2]
                yield page, number, text, after[0][2] if after and after[0][0] == "code text" else []


def tables():
    """Name and text of each table that a document prints."""
    for path in documents_of(SOURCE):
        before = ""
        for kind, _, lines in blocks_of(path.read_text()):
            if kind == "code text" and (found := TABLE.search(before)):
                yield found[1], "\n".join(lines) + "\n"
            before = " ".join(lines)


class DocumentedInputs(InputRuns):
    def make_files(self):
        """The tables of documents, data of shipped fits, a surface, and a force curve with noise."""
        found = {}
        for name, text in tables():
            self.assertEqual(text, found.setdefault(name, text), f"two tables have the name {name}")
            self.write(text, name)
        self.assertGreater(len(found), 4)
        for path in (SOURCE/"inputs").glob("fit_*.csv"):
            shutil.copy(path, self.folder)
        self.make_surface("surface_stickiness", 32)
        self.write(CURVE)
        self.run_program("run", "--quiet", "--output", "curve.h5", "run.nml")
        with h5py.File(self.folder/"curve.h5") as file:
            approach, load = file["approach"][()], file["load"][()]
        noise = np.random.default_rng(1).normal(scale=1e-3*load.max(), size=80)
        approach = np.concatenate([np.linspace(-1.4e-8, -1e-9, 20), approach]) + 1e-8
        self.write("\n".join(["approach, load", *(f"{x:.9e}, {y:.9e}" for x, y in zip(approach, np.concatenate([np.zeros(20), load]) + noise))]) + "\n",
                   "curve.csv")

    def test_run(self):
        """Every whole input has answers, and the numbers that stand below it."""
        self.make_files()
        n_inputs = n_numbers = 0
        for page, number, text, printed in whole_inputs():
            if page in RUN_ELSEWHERE or any(name in text for name in MADE_BY_IMPORTS):
                continue
            with self.subTest(page=page, line=number):
                (self.folder/"run.h5").unlink(missing_ok=True)
                self.write(text)
                self.run_program("fit" if "&data" in text else "run", "--quiet", "--output", "run.h5", "run.nml")
                with h5py.File(self.folder/"run.h5") as file:
                    if page not in WITHOUT_ANSWERS:
                        self.assertFalse(file["status"][()].any())
                n_inputs += 1
                if printed and all(PRINTED.match(line) for line in printed):
                    n_numbers += self.compare(printed)
        self.assertGreater(n_inputs, 70)
        self.assertGreater(n_numbers, 100)

    def compare(self, printed):
        """Are these the results of the last run? The number of numbers."""
        n_numbers = 0
        with h5py.File(self.folder/"run.h5") as file:
            for line in printed:
                name, numbers = PRINTED.match(line).groups()
                self.assertEqual([f"{value:.4g}" for value in np.ravel(file[name][()])], [f"{float(word):.4g}" for word in numbers.split()], name)
                unit = re.search(r"\[([^\]]+)\]", line)[1]
                self.assertEqual(file[name].attrs.get("units", "1"), {"-": "1"}.get(unit, unit), name)
                n_numbers += len(numbers.split())
        return n_numbers

    def test_choices(self):
        """Every word that a variable may be, and every variable, stands in a whole input of a document."""
        texts = re.sub(r"!.*", "", "".join(text for _, _, text, _ in whole_inputs()))
        shipped = re.sub(r"!.*", "", "".join(path.read_text() for path in (SOURCE/"inputs").glob("*.nml")))
        without = []
        for name, choices in re.findall(r"(?m)^- `(\w+)`[^:]*:(.*)$", (SOURCE/"docs/reference/variables.md").read_text().replace("\n  ", " ")):
            if not re.search(rf"\b{name}\b", texts + shipped):
                without.append(name)
            for word in re.findall(r"`'(\w+)'`", choices):
                # a list of results belongs to no variable of its own
                # some variables take several words
                if not re.search(rf"\b{name}\s*=\s*(?:'\w+'\s*,\s*)*'{word}'", texts) and (name, word) != ("activation_energy", "arrhenius"):
                    without.append(f"{name} = '{word}'")
        self.assertEqual([], without)


if __name__ == "__main__":
    main()
