# SPDX-License-Identifier: GPL-3.0-or-later
"""Write a map of force curves as an instrument would: made here, not measured.

A ball on a lever approaches an elastic surface, sticks to it (Johnson, Kendall, Roberts 1971) and is torn off. Stiff islands that adhere
little lie in a softer matrix that adheres more. Two curves are spoiled: one never reaches the surface, one has lost its numbers.
scripts/import_curve reads the file, the zipped text of AFM Workshop.
"""

import argparse
import sys
from pathlib import Path


def read_command_line(arguments):
    """What the user asks for."""
    parser = argparse.ArgumentParser(prog="scripts/make_force_map", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    add = parser.add_argument
    add("file", nargs="?", type=Path, default=Path("force_map.zip"), help="file to write (default: %(default)s)")
    add("--curves", type=int, nargs=2, metavar=("NX", "NY"), default=(16, 12), help="curves along x and y (default: 16 12)")
    add("--samples", type=int, default=200, help="of the approach, and of the retraction (default: %(default)s)")
    add("--radius", type=float, default=1.0e-6, help="of the ball [m] (default: %(default)s)")
    add("--spring-constant", type=float, default=5.0, help="of the lever [N/m] (default: %(default)s)")
    add("--sensitivity", type=float, default=5.0e-8, help="of its deflection [m/V] (default: %(default)s)")
    add("--noise", type=float, default=1.0e-9, help="of the load [N] (default: %(default)s)")
    add("--seed", type=int, default=1, help="of the random numbers (default: %(default)s)")
    given = parser.parse_args(arguments)
    if min(given.curves) < 2 or given.samples < 50:
        parser.error("a map has 2 curves at least along x and y, and a curve 50 samples")
    return given


if __name__ == "__main__":
    read_command_line(sys.argv[1:])
