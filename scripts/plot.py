"""Draw a figure: scripts/plot FILE.h5 ... [--x NAME] [--y NAME ...] [--data TABLE] [--output FIGURE]."""

import sys

from plotting.command import main

sys.exit(main(sys.argv[1:]))
