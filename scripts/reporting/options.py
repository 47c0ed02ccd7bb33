# SPDX-License-Identifier: GPL-3.0-or-later
"""The options of the command line, which need no packages: help is there before anything is installed."""

import argparse
import sys
from pathlib import Path


def read_command_line(arguments):
    """What the user asks for."""
    parser = argparse.ArgumentParser(
        prog="scripts/report",
        allow_abbrev=False,
        description="Write results files as one HTML page, which opens in any browser without a network: the scene, the input, curves to "
        "choose and to zoom, maps, fits, and where there are doubts.",
    )
    parser.add_argument("files", metavar="FILE.h5", type=Path, nargs="+", help="results of adfric run or adfric fit")
    parser.add_argument("--x", metavar="NAME", help="swept variable or result along the axis at first (default: the last one that is swept)")
    parser.add_argument("--y", metavar="NAME", help="result that is drawn at first")
    parser.add_argument("-o", "--output", metavar="PAGE.html", type=Path, help="page to write (default: the name of the first file with .html)")
    parser.add_argument("--force", action="store_true", help="overwrite a page that exists")
    return parser.parse_args(arguments)


if __name__ == "__main__":
    read_command_line(sys.argv[1:])
