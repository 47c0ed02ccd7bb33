# SPDX-License-Identifier: GPL-3.0-or-later
"""Write the tractions of a cylinder in partial slip (Cattaneo, Mindlin; K. L. Johnson, Contact Mechanics, 1985, 7.2) as samples."""

import argparse
import sys


def read_command_line(arguments):
    """What the user asks for."""
    parser = argparse.ArgumentParser(prog="scripts/make_traction", description=__doc__)
    parser.add_argument("file", nargs="?", default="traction.h5", help="file to write (default: %(default)s)")
    parser.add_argument("--half-width", type=float, default=1.0e-3, help="a [m] (default: %(default)s)")
    parser.add_argument("--peak-pressure", type=float, default=1.0e9, help="p0 [Pa] (default: %(default)s)")
    parser.add_argument("--friction", type=float, default=0.3, help="coefficient f (default: %(default)s)")
    parser.add_argument("--load-ratio", type=float, default=0.5, help="Q/(f P), 0 to 1 (default: %(default)s)")
    parser.add_argument("--samples", type=int, default=401, help="in each of the three parts (default: %(default)s)")
    given = parser.parse_args(arguments)
    return given


if __name__ == "__main__":
    read_command_line(sys.argv[1:])
