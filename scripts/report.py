# SPDX-License-Identifier: GPL-3.0-or-later
"""Write a page: scripts/report FILE.h5 ... [--x NAME] [--y NAME] [--output PAGE.html] [--force]."""

import os
import sys

from reporting.command import main

# no window, whatever the user has chosen for other programs
os.environ["MPLBACKEND"] = "Agg"
sys.exit(main(sys.argv[1:]))
