# SPDX-License-Identifier: GPL-3.0-or-later
"""The blocks of README.md and of the first pages can be copied as they stand: commands are run, inputs are read or solved, Python is executed.

Commands that install packages of the system or of Python, that compile for minutes, or that need MPI or Slurm are not run: the scripts,
presets, options and files that they name are looked up instead (`NAMED`). Synopses (`text`) have no option that `--help` has not.
"""

import os
import re
import shlex
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

from runs import PROGRAM, Runs, main

SOURCE = Path(os.environ["ADFRIC_SOURCE"])
BLOCK = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
# README and the pages that it leads a newcomer to
PAGES = ("README.md", "docs/guide/install.md", "docs/guide/first_run.md")
# what the blocks are in
LANGUAGES = {"sh", "fortran", "python", "cmake", "text"}
# commands that are looked up, not run, by their first words
NAMED = ("scripts/run", "scripts/report", "scripts/test", "scripts/install", "scripts/setup", "scripts/slurm_array.sh", "cmake", "gfortran", "cc", "mpirun",
         "python3 -m venv", "adfric-python/bin/pip")
# a small sweep in the place of the big one, in 16 parts
BIG = "&job model = 'sphere' /\n&sphere radius = 1e-6, contact_modulus = 1e9, work_of_adhesion = 0 /\n" \
      "&sweep variable = 'load', from = 0, to = 1e-6, count = 400 /\n"


def blocks_of(text):
    """Language and text of each block."""
    return [(found[1], found[2]) for found in BLOCK.finditer(text)]


def commands_of(block):
    """The commands of a block; one goes on behind a backslash."""
    return [line for line in block.replace("\\\n", " ").splitlines() if line.strip()]


class Readme(Runs):
    """The first pages, block by block, in a folder that looks like the sources."""

    @classmethod
    def setUpClass(cls):
        cls.text = "\n".join((SOURCE/page).read_text() for page in PAGES)
        cls.blocks = blocks_of(cls.text)
        (cls.first,) = [text for language, text in cls.blocks if language == "fortran" and "first.h5" in text]

    def setUp(self):
        super().setUp()
        for name in ("inputs", "scripts", "docs", "CMakePresets.json", ".venv"):
            (self.folder/name).symlink_to(SOURCE/name)
        # the program by its name, as behind the block that sets the PATH
        (self.folder/"build/release").mkdir(parents=True)
        (self.folder/"build/release/adfric").symlink_to(Path(PROGRAM).resolve())
        self.environment = {**os.environ, "PATH": f"{self.folder/'build/release'}:{os.environ['PATH']}", "OMP_NUM_THREADS": "2",
                            "MPLBACKEND": "Agg", "PYTHONPATH": str(SOURCE/"python")}

    def shell(self, command):
        """A command as a user's shell runs it; what it prints."""
        done = subprocess.run(["bash", "-euc", command], cwd=self.folder, env=self.environment, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, check=False)
        self.assertEqual(0, done.returncode, f"{command}\n{done.stdout}")
        return done.stdout

    def test_form(self):
        """Every block says what it is in, and nothing else is indented as code is."""
        self.assertEqual(2*len(self.blocks), len(re.findall(r"^```", self.text, re.MULTILINE)))
        self.assertEqual(set(), {language for language, _ in self.blocks} - LANGUAGES)
        prose = BLOCK.sub("", self.text)
        self.assertEqual([], re.findall(r"^ {4,}\S.*$", prose, re.MULTILINE))

    def test_commands(self):
        """A block of commands holds commands alone, which run where they can."""
        self.write(BIG, "big.nml")
        self.write(self.first, "first.nml")
        self.run_program("run", "--quiet", "first.nml")
        n_run = 0
        for language, block in self.blocks:
            if language != "sh":
                continue
            for command in commands_of(block):
                with self.subTest(command=command):
                    if command.startswith(NAMED):
                        self.look_up(command)
                        continue
                    if command.startswith("adfric merge"):
                        self.run_parts()
                    self.shell(command)
                    n_run += 1
        self.assertGreaterEqual(n_run, 6)
        self.assertTrue((self.folder/"first.png").is_file())

    def run_parts(self):
        """The other parts of a run that is to be merged."""
        (self.folder/"big.h5").unlink()
        for k in range(1, 17):
            self.shell(f"adfric run --quiet --resume --shard {k}/16 big.nml")

    def look_up(self, command):
        """Does a command name what there is?"""
        words = shlex.split(command)
        program = SOURCE/words[0]
        if "/" in words[0] and words[0].startswith("scripts/"):
            self.assertTrue(os.access(program, os.X_OK), words[0])
            usage = subprocess.run([program, "--help"], capture_output=True, text=True, check=True).stdout
            for word in words[1:]:
                if word.startswith("-") or words[0] == "scripts/setup":
                    self.assertRegex(usage, rf"(?<![\w-]){re.escape(word)}(?![\w-])")
        presets = (SOURCE/"CMakePresets.json").read_text()
        for option, word in zip(words, words[1:]):
            if option == "--preset":
                self.assertIn(f'"{word}"', presets)
        for word in words[1:]:
            if word.startswith(("inputs/", "scripts/")):
                self.assertTrue((SOURCE/word).exists(), word)
            if word.endswith(".nml") and "/" not in word:
                self.assertEqual("big.nml", word)
        if words[0].endswith("pip"):
            extras = re.search(r"\[(\w+)\]", words[-1])[1]
            self.assertRegex((SOURCE/"pyproject.toml").read_text(), rf"(?m)^{extras} = ")

    def test_synopses(self):
        """The program's own help has the commands and options of the synopses."""
        shown = [line for language, block in self.blocks if language == "text" for line in block.splitlines() if line.startswith("adfric")]
        self.assertEqual(["run", "fit", "merge", "check", "modernise", "help"], [line.split()[1] for line in shown])
        usage = self.shell("adfric --help")
        for line in shown:
            self.assertRegex(usage, rf"(?m)^\s*adfric {line.split()[1]}\b")
            for option in re.findall(r"--[a-z]+", line):
                self.assertIn(option, usage)
        texts = "".join(block for language, block in self.blocks if language == "text")
        (of_plot,) = [line for line in texts.splitlines() if "scripts/plot" in line]
        usage = self.shell("scripts/plot --help")
        for option in re.findall(r"--\w+", of_plot):
            self.assertIn(option, usage)

    def test_inputs(self):
        """Whole inputs are solved, and groups that may stand in any are read by the program."""
        shutil.copy(SOURCE/"inputs/fit_friction.csv", self.folder/"tip.csv")
        n_inputs = 0
        for number, (language, text) in enumerate(self.blocks):
            if language != "fortran":
                continue
            with self.subTest(text=text[:60]):
                if "&job" in text:
                    self.write(text, f"input_{number}.nml")
                    self.shell(f"adfric {'fit' if '&data' in text else 'run'} --quiet input_{number}.nml")
                    n_inputs += 1
                else:
                    self.check_groups(text)
        self.assertEqual(3, n_inputs)

    def check_groups(self, text):
        """Each group in an input with what it needs beside."""
        self.write("load\n1e-9\n2e-9\n" + "3e-9\n"*8, "loads.csv")
        self.write("radius,load\n1e-8,1e-9\n2e-8,2e-9\n", "cases.csv")
        swept = "&sweep variable = 'radius', from = 5e-9, to = 50e-9, count = 10, spacing = 'log' /\n"
        loads = "&sweep variable = 'load', from = -1e-9, to = 1e-7, count = 5 /\n"
        at_load = "&operating load = 1e-8 /\n"
        groups = re.findall(r"^&(\w+).*$", text, re.MULTILINE)
        lines = [line for line in text.splitlines() if line.startswith("&")]
        self.assertEqual(len(text.splitlines()), len(lines))
        radius = "radius = 2e-8, "
        for group, line in zip(groups, lines):
            beside, given = at_load, radius
            if group == "sweep":
                given, beside = "", swept if "with" in line else at_load
            elif group == "cases":
                given, beside = "", ""
            elif group in ("sample", "range"):
                pair = [one for other, one in zip(groups, lines) if other in ("sample", "range")]
                line, beside = "\n".join(pair), at_load
            elif group == "refine":
                beside = loads
            elif group in ("uncertain", "output"):
                beside = at_load
            lambda_ = "" if group in ("sample", "range") else ", lambda = 0.8"
            self.write(f"&job model = 'sphere' /\n&sphere {given}contact_modulus = 44e9, work_of_adhesion = 0.19{lambda_} /\n{beside}{line}\n")
            with self.subTest(group=group):
                self.shell("adfric check run.nml")

    def test_python(self):
        """What Python blocks print is said beside them; they run with what the first input has left."""
        if "ADFRIC_LIBRARY" not in os.environ:
            self.skipTest("there is no shared library")
        self.write(self.first, "first.nml")
        self.run_program("run", "--quiet", "first.nml")
        blocks = [text for language, text in self.blocks if language == "python"]
        self.assertGreaterEqual(len(blocks), 2)
        for text in blocks:
            self.write(text, "block.py")
            done = subprocess.run([sys.executable, "block.py"], cwd=self.folder, env=self.environment, capture_output=True, text=True,
                                  check=False)
            self.assertEqual(0, done.returncode, done.stderr)

    def test_faults(self):
        """A word of explanation behind a command is seen."""
        with self.assertRaises(AssertionError):
            self.shell("adfric check inputs/hertz_axes.nml      says what it is")
        with self.assertRaises(AssertionError):
            self.look_up("scripts/install --prefixx")
        with self.assertRaises(AssertionError):
            self.look_up("scripts/run inputs/none.nml")


if __name__ == "__main__":
    main()
