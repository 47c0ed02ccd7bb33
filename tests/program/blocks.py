# SPDX-License-Identifier: GPL-3.0-or-later
"""The blocks of all other documents: commands name programs, subcommands, options and files that there are; Python runs.

README and the first pages are run by readme.py, the pages of the guide by guide.py, the tutorials by force_map.py and wheel.py. Whole
inputs of all pages are solved by documented_inputs.py.
"""

import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

from runs import PROGRAM, Runs, main

SOURCE = Path(os.environ["ADFRIC_SOURCE"])
sys.path.insert(0, str(SOURCE/"scripts"))

from document_links import documents_of  # noqa: E402
from document_prose import blocks_of  # noqa: E402

# What belongs to a shell or to the system, and is not looked at.
OF_THE_SYSTEM = {"export", "module", "tar", "cd", "seq", "parallel", "prefix", "cmake", "ctest", "gfortran", "cc", "mpirun", "python3", "pip",
                 "./configure", "make", "adfric-python/bin/pip"}
# Pages whose Python runs, with what stands before the first block, and the inputs that leave what they open.
PYTHON = {"docs/reference/file_format.md": ("", ["gm2011_fig5", "johnson1997_fig5"], {"pint_xarray"}),
          "docs/reference/python.md": ("import numpy as np\nimport adfric\nloads = np.linspace(0.0, 3e-7, 30)\n"
                                       "forces = adfric.solve('sphere', radius=140e-9, contact_modulus=44e9, state='sliding', theory='jkr', "
                                       "work_of_adhesion=0.19, shear_strength=1e9, load=loads).friction_force.values\n"
                                       "errors = 0.01*forces*np.resize([0.9, 1.1], forces.size)\n", [], {"map.jpk-force-map"})}


def blocks(language, name=None):
    """Page and lines of each block in a language."""
    for path in documents_of(SOURCE):
        page = path.relative_to(SOURCE).as_posix()
        if name in (None, page):
            for kind, _, lines in blocks_of(path.read_text()):
                if kind == f"code {language}":
                    yield page, "\n".join(lines) + "\n"


def commands_of(text):
    """The commands of a block, each as its words: what stands in brackets and behind &&, | and a comment sign is looked at, too."""
    for line in text.replace("\\\n", " ").splitlines():
        words = shlex.split(line.replace("(", " ").replace(")", " ") if line.startswith("(") else line, comments=True)
        command = []
        for word in [*words, "&&"]:
            if word in ("&&", "|", ";"):
                while command and re.fullmatch(r"\w+=.*", command[0]):
                    command.pop(0)
                if command:
                    yield command
                command = []
            elif word == ">":
                command.append(word)
            else:
                command.append(word)


class Blocks(Runs):
    def usage(self, command):
        """What a program says of itself."""
        done = subprocess.run([*command, "--help"], capture_output=True, text=True, cwd=SOURCE, check=False)
        self.assertEqual(0, done.returncode, f"{command}: {done.stderr}")
        return done.stdout

    def look_up(self, words):
        """Does a command name what there is?"""
        words = words[:words.index(">")] if ">" in words else words
        program, *rest = words
        if program in OF_THE_SYSTEM:
            return
        if program in ("adfric", "build/release/adfric", "build/mpi/adfric"):
            usage = self.usage([PROGRAM])
            self.assertRegex(usage, rf"(?m)^\s*adfric {rest[0]}\b" if not rest[0].startswith("-") else re.escape(rest[0]), words)
            if rest[0] == "help":
                subprocess.run([PROGRAM, *rest], check=True, capture_output=True)
        else:
            self.assertRegex(program, r"^[\w.]+/", f"{words}: what is this?")
            before = []
            if program == ".venv/bin/python":
                # this test has the same Python
                before, (program, *rest) = [sys.executable], rest
            self.assertTrue(os.access(SOURCE/program, os.X_OK), f"there is no {program}")
            usage = self.usage([*before, SOURCE/program])
        for word in rest:
            if word.startswith("-"):
                self.assertIn(word.partition("=")[0], usage, words)
            if re.match(r"(?:inputs|scripts|examples|tests)/", word):
                self.assertTrue((SOURCE/word).exists(), f"there is no {word}")

    def test_commands(self):
        """Every command names what there is."""
        n_commands = 0
        for page, text in blocks("sh"):
            for words in commands_of(text):
                with self.subTest(page=page, command=words):
                    self.look_up(words)
                    n_commands += 1
        self.assertGreater(n_commands, 50)

    def test_python(self):
        """Blocks of Python run one after the other, but for those that need what a user has."""
        if "ADFRIC_LIBRARY" not in os.environ:
            self.skipTest("there is no shared library")
        environment = {**os.environ, "MPLBACKEND": "Agg", "PYTHONPATH": str(SOURCE/"python"), "OMP_NUM_THREADS": "2"}
        for page, (before, inputs, needs) in PYTHON.items():
            for name in inputs:
                self.run_program("run", "--quiet", "--force", SOURCE/f"inputs/{name}.nml", status=None)
            found = [text for _, text in blocks("python", page) if not any(need in text for need in needs)]
            self.assertGreaterEqual(len(found), 2)
            self.write(before + "\n".join(found), "page.py")
            done = subprocess.run([sys.executable, "page.py"], cwd=self.folder, env=environment, capture_output=True, text=True, check=False)
            self.assertEqual(0, done.returncode, f"{page}\n{done.stderr}")

    def test_faults(self):
        """Programs, subcommands, options, files and topics that there are not."""
        for line in ("scripts/none a.nml", "adfric solve a.nml", "adfric run --fast a.nml", "scripts/build --none", "scripts/run inputs/none.nml",
                     "none a.nml", "cd a && scripts/none", "A=1 scripts/none", "(scripts/none)"):
            with self.subTest(line), self.assertRaises(AssertionError):
                for words in commands_of(line):
                    self.look_up(words)
        with self.assertRaises(subprocess.CalledProcessError):
            self.look_up(["adfric", "help", "no_such_name"])


if __name__ == "__main__":
    main()
