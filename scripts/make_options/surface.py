# SPDX-License-Identifier: GPL-3.0-or-later
"""Write a self-affine random surface, periodic in x and y, as heights in an HDF5 file."""

import argparse
import sys


def read_command_line(arguments):
    """What the user asks for."""
    parser = argparse.ArgumentParser(prog="scripts/make_surface", description=__doc__)
    parser.add_argument("file", nargs="?", default="surface.h5", help="file to write (default: %(default)s)")
    parser.add_argument("--cells", type=int, default=512, help="cells along x and y (default: %(default)s)")
    parser.add_argument("--length", type=float, default=1.0e-4, help="period in x and y [m] (default: %(default)s)")
    parser.add_argument("--hurst", type=float, default=0.8, help="Hurst exponent (default: %(default)s)")
    parser.add_argument("--longest", type=float, default=1 / 4, help="longest wave, in periods (default: %(default)s)")
    parser.add_argument("--shortest", type=float, default=1 / 64, help="shortest wave, in periods (default: %(default)s)")
    parser.add_argument("--rms", type=float, default=1.0e-7, help="root mean square of the heights [m] (default: %(default)s)")
    parser.add_argument("--seed", type=int, default=1, help="of the random numbers (default: %(default)s)")
    parser.add_argument("--stripes", type=int, default=0,
                        help="also write a map of the work of adhesion, with so many weak stripes along y (default: none)")
    parser.add_argument("--weak", type=float, default=0.1, help="work of a weak stripe over that between them (default: %(default)s)")
    parser.add_argument("--tip", type=float, metavar="RADIUS",
                        help="put the roughness on a tip of this radius of curvature [m], which has no cells beyond its circle in the map")
    given = parser.parse_args(arguments)
    if given.stripes < 0 or 2 * given.stripes > given.cells:
        parser.error("--stripes: from 0 to half of the cells")
    if not given.weak >= 0:
        parser.error("--weak: 0 at least")
    if given.tip is not None and not given.tip > 0:
        parser.error("--tip: above 0")
    if given.cells < 2 * int(1 / given.shortest) + 2:
        parser.error("the cells are too few for the shortest wave: less than two along it")
    return given


if __name__ == "__main__":
    read_command_line(sys.argv[1:])
