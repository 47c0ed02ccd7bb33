# SPDX-License-Identifier: GPL-3.0-or-later
"""The options of the command line, which need no packages: help is there before anything is installed."""

import argparse
import sys
from pathlib import Path

from .printable import printable


class Parser(argparse.ArgumentParser):
    """A parser whose messages show what a name has, instead of obeying it."""

    def _print_message(self, message, file=None):
        super()._print_message("\n".join(printable(line) for line in message.split("\n")), file)


def read_command_line(arguments):
    """What the user asks for."""
    parser = Parser(
        prog="scripts/plot",
        description="Draw the figure of a results file, or several files in one figure. Without --x and --y what is drawn "
        "follows from what was swept.",
    )
    parser.add_argument("files", metavar="FILE.h5", type=Path, nargs="+", help="results of adfric run")
    parser.add_argument("--x", metavar="NAME", help="swept variable or result along the axis (default: the last one that is swept); "
                        "or a profile, as gap")
    parser.add_argument("--y", metavar="NAME", nargs="+", help="results to draw, a panel for each; or profiles, as pressure")
    parser.add_argument("--data", metavar="TABLE", type=Path,
                        help="points to draw as well: a table whose heads have the names of x and of results, with units or in those of the results")
    parser.add_argument("--cut", metavar="LINE", nargs="+",
                        help="draw the maps of one file along lines, as y=0 y=x; numbers are in metres")
    parser.add_argument("-o", "--output", metavar="FIGURE", type=Path,
                        help="figure, .png, .pdf or .svg (default: that of the first file, .png)")
    return parser.parse_args(arguments)


if __name__ == "__main__":
    read_command_line(sys.argv[1:])
