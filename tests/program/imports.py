# SPDX-License-Identifier: GPL-3.0-or-later
"""The command scripts/import_surface for tests, with the Python of its own environment, .venv_import."""

import contextlib
import io
import os
import sys
from pathlib import Path

SOURCE = Path(os.environ["ADFRIC_SOURCE"])
PYTHON = SOURCE / ".venv_import/bin/python"
# see tests/CMakeLists.txt
ALL_SKIPPED = 77

if Path(sys.executable) != PYTHON:
    if not PYTHON.exists():
        print(f"skipped: there is no {PYTHON}: scripts/setup tests could not install SurfaceTopography")
        sys.exit(ALL_SKIPPED)
    os.execv(PYTHON, [str(PYTHON), *sys.argv])

sys.path.insert(0, str(SOURCE / "scripts"))

import h5py  # noqa: E402
import numpy as np  # noqa: E402

from importing.command import main as import_main  # noqa: E402
from runs import Runs  # noqa: E402


class Imports(Runs):
    """Imports in a folder of their own."""

    def setUp(self):
        super().setUp()
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)

    def call(self, *arguments, status=0):
        """What an import shows on standard output and on standard error."""
        output, errors = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(output), contextlib.redirect_stderr(errors):
            found = import_main([str(argument) for argument in arguments])
        self.assertEqual(found, status, errors.getvalue())
        return output.getvalue(), errors.getvalue()

    def read(self, *arguments):
        """Heights and attributes of an import without warnings."""
        _, errors = self.call(*arguments, "--output", "read.h5", "--force", "--no-picture")
        self.assertEqual(errors, "")
        with h5py.File("read.h5") as file:
            return file["z"][()], dict(file["z"].attrs)

    def refuse(self, words, *arguments, status=2):
        """An import that ends in one line with these words, and leaves no file."""
        before = self.names()
        output, errors = self.call(*arguments, status=status)
        self.assertEqual(output, "")
        self.assertEqual(errors.count("\n"), 1, errors)
        self.assertTrue(errors.startswith("import_surface: "), errors)
        self.assertIn(words, errors)
        self.assertEqual(self.names(), before)


def rough(ny, nx, seed=1):
    """Whole numbers of nanometres."""
    return np.random.default_rng(seed).integers(-500, 500, (ny, nx)).astype(float)
