# SPDX-License-Identifier: GPL-3.0-or-later
"""Bring force curves of instruments into an HDF5 file: scripts/import_curve FILE... [options]."""

import os
import sys

from importing.curve_command import main

if __name__ == "__main__":
    # no window, whatever the user has chosen for other programs
    os.environ["MPLBACKEND"] = "Agg"
    sys.exit(main(sys.argv[1:]))
