# SPDX-License-Identifier: GPL-3.0-or-later
"""Draw a figure: scripts/plot FILE.h5 ... [--x NAME] [--y NAME ...] [--data TABLE] [--cut LINE ...] [--output FIGURE]."""

import os
import sys

from plotting.command import main

# no window, whatever the user has chosen for other programs
os.environ["MPLBACKEND"] = "Agg"
sys.exit(main(sys.argv[1:]))
