# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of the Python package share."""

import os
import tempfile
import unittest
from pathlib import Path

import numpy as np

SOURCE = Path(os.environ["ADFRIC_SOURCE"])
# A tip of a force microscope.
TIP = {"radius": 140e-9, "contact_modulus": 50e9, "work_of_adhesion": 0.2, "adhesion_stress": 5e9}
# A rough surface of a few cells.
SURFACE = {"heights": 1e-6*np.random.default_rng(1).random((16, 32)), "length_x": 1e-4, "length_y": 0.5e-4, "contact_modulus": 1e9}
# What differs from run to run, or is said of a file.
OF_THE_FILE = {"created", "history", "wall_seconds"}


class InFolder(unittest.TestCase):
    """A test in a folder of its own."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(temporary.name)
        self.folder = Path(temporary.name)

    def assert_raises_text(self, error, *words):
        """An error whose text has these words."""
        return self.assertRaisesRegex(error, "(?s)" + ".*".join(words))
