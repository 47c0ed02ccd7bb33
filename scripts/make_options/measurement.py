# SPDX-License-Identifier: GPL-3.0-or-later
"""Write a line scan and a master curve as instruments would: made here, not measured.

The line is rough like asphalt, with a tilt and a few samples missing. The master curve is that of a fractional Zener solid, the rubber of
inputs/rubber_velocity.nml, with a scatter. scripts/import_surface reads both files.
"""

import argparse
import sys
from pathlib import Path


def read_command_line(arguments):
    """What the user asks for."""
    parser = argparse.ArgumentParser(prog="scripts/make_measurement", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default=Path(), help="for line_scan.csv and dma.csv (default: the current one)")
    parser.add_argument("--samples", type=int, default=4000, help="of the line (default: %(default)s)")
    parser.add_argument("--spacing", type=float, default=2.0e-6, help="of the samples [m] (default: %(default)s)")
    parser.add_argument("--hurst", type=float, default=0.8, help="Hurst exponent (default: %(default)s)")
    parser.add_argument("--longest", type=float, default=2.0e-3, help="longest wave [m] (default: %(default)s)")
    parser.add_argument("--shortest", type=float, default=1.0e-4, help="shortest wave [m] (default: %(default)s)")
    parser.add_argument("--rms", type=float, default=4.0e-5, help="root mean square of the heights [m] (default: %(default)s)")
    parser.add_argument("--tilt", type=float, default=0.02, help="slope of the line as it lies (default: %(default)s)")
    parser.add_argument("--missing", type=float, default=0.005, help="share of the samples that are missing (default: %(default)s)")
    parser.add_argument("--scatter", type=float, default=0.01, help="of the moduli, relative (default: %(default)s)")
    parser.add_argument("--seed", type=int, default=1, help="of the random numbers (default: %(default)s)")
    given = parser.parse_args(arguments)
    return given


if __name__ == "__main__":
    read_command_line(sys.argv[1:])
