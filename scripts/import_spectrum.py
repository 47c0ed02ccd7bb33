# SPDX-License-Identifier: GPL-3.0-or-later
"""Join measurements of one surface to its power spectrum: scripts/import_spectrum FILE... [options]."""

import os
import sys

from importing.spectrum_command import main

if __name__ == "__main__":
    # no window, whatever the user has chosen for other programs
    os.environ["MPLBACKEND"] = "Agg"
    sys.exit(main(sys.argv[1:]))
