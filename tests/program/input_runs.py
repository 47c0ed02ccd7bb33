# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of shipped inputs with some words changed, and of the made surfaces that they name."""

import re
import shlex
import sys
from pathlib import Path

import h5py

sys.path.insert(0, str(Path(__file__).parent))
from runs import Runs  # noqa: E402

SOURCE = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(SOURCE / "scripts"))

from make_surface import main as make_surface  # noqa: E402


class InputRuns(Runs):
    def solve(self, name, **changes):
        """Numbers in the results file of a shipped input with some words changed."""
        text = (SOURCE / "inputs" / f"{name}.nml").read_text()
        for old, new in changes.items():
            self.assertIn(old, text)
            text = text.replace(old, new)
        self.write(text)
        self.run_program("run", "--quiet", "--force", "--output", "run.h5", "run.nml")
        with h5py.File(self.folder / "run.h5") as file:
            self.assertFalse(file["status"][()].any())
            return {key: data[()] for key, data in file.items() if isinstance(data, h5py.Dataset)}

    def make_surface(self, name, cells):
        """Do what the head of an input says, on other cells."""
        command = re.search(r"scripts/(make_surface .*)", (SOURCE / "inputs" / f"{name}.nml").read_text())[1]
        _, file, *options = shlex.split(command)
        arguments, sys.argv = sys.argv, ["make_surface", str(self.folder / file), *options, "--cells", str(cells)]
        try:
            make_surface()
        finally:
            sys.argv = arguments
