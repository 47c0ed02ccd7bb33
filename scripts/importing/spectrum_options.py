# SPDX-License-Identifier: GPL-3.0-or-later
"""The options of scripts/import_spectrum."""

import argparse
import sys
from pathlib import Path

from .parser import Parser
from .problems import BadInput
from .reading import WINDOWS, check_values


def read_command_line(arguments):
    """What the user asks for."""
    parser = Parser(prog="scripts/import_spectrum", allow_abbrev=False, description="Join measurements of one surface, by one or several "
                    "instruments, to one power spectrum that &power_spectrum reads, in SI units.")
    add = parser.add_argument
    add("files", metavar="FILE", type=Path, nargs="+", help="what scripts/import_surface has written, or a container (.zip) of "
        "contact.engineering with several measurements (docs/guide/import.md)")
    add("-o", "--output", metavar="FILE.h5", type=Path, default=Path("spectrum.h5"), help="file to write (default: %(default)s); "
        "the picture stands beside it, with .png")
    add("--force", action="store_true", help="overwrite files that exist")
    add("--no-picture", action="store_true", help="write no picture")
    add("--surface", metavar="NAME", help="which of several surfaces of a container")
    add("--leave-out", metavar="NAME", nargs="+", default=[], help="measurements that are not taken, by the names that are shown")
    add("--window", choices=WINDOWS, help="window of parts (default: that of the file, hann of a container); periods have none")
    add("--most-missing", metavar="SHARE", type=float, default=0.05,
        help="largest share of missing samples of a measurement of a container (default: %(default)s)")
    given = parser.parse_args(arguments)
    check_options(given)
    return given


def check_options(given):
    """Are the files there, and have those to write a name?"""
    check_values(argparse.Namespace(average=1, most_missing=given.most_missing))
    for file in given.files:
        if not file.is_file():
            raise BadInput(f"{file}: " + ("this is no file" if file.exists() else "there is no such file"))
    given.picture = None if given.no_picture else given.output.with_suffix(".png")
    if given.picture == given.output:
        raise BadInput(f"{given.output}: the picture has this name, --output needs another ending, such as .h5")


if __name__ == "__main__":
    read_command_line(sys.argv[1:])
