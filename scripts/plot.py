"""Draw the figure of a results file: scripts/plot FILE.h5 [-o FIGURE.png | FIGURE.pdf]."""

import sys

from plotting.command import main

sys.exit(main(sys.argv[1:]))
