# SPDX-License-Identifier: GPL-3.0-or-later
"""Bring a measured surface or a master curve into an HDF5 file: scripts/import_surface FILE [options]."""

import os
import sys

from importing.command import main

if __name__ == "__main__":
    # no window, whatever the user has chosen for other programs
    os.environ["MPLBACKEND"] = "Agg"
    sys.exit(main(sys.argv[1:]))
