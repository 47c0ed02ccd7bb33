# SPDX-License-Identifier: GPL-3.0-or-later
"""Draw a figure: scripts/plot FILE.h5 ... [--x NAME] [--y NAME ...] [--data TABLE] [--output FIGURE]."""

import sys

from plotting.command import main

sys.exit(main(sys.argv[1:]))
