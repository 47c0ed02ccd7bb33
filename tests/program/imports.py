# SPDX-License-Identifier: GPL-3.0-or-later
"""The command scripts/import_surface for tests, with the Python of its own environment, .venv_import."""

from environments import SOURCE, restart_in  # noqa: F401

restart_in(".venv_import", "SurfaceTopography")

import h5py  # noqa: E402
import numpy as np  # noqa: E402

from importing.command import main as import_main  # noqa: E402
from importing_case import ImportCase  # noqa: E402


class Imports(ImportCase):
    """Imports of surfaces and master curves."""

    program = "import_surface"
    import_main = staticmethod(import_main)

    def read(self, *arguments):
        """Heights and attributes of an import without warnings."""
        _, errors = self.call(*arguments, "--output", "read.h5", "--force", "--no-picture")
        self.assertEqual(errors, "")
        with h5py.File("read.h5") as file:
            return file["z"][()], dict(file["z"].attrs)


def rough(ny, nx, seed=1):
    """Whole numbers of nanometres."""
    return np.random.default_rng(seed).integers(-500, 500, (ny, nx)).astype(float)
