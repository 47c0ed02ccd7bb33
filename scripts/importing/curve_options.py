# SPDX-License-Identifier: GPL-3.0-or-later
"""The options of scripts/import_curve."""

import math
import sys
from pathlib import Path

from .parser import Parser
from .problems import BadInput


def read_command_line(arguments):
    """What the user asks for."""
    parser = Parser(prog="scripts/import_curve", allow_abbrev=False, description="Bring force curves of instruments into one HDF5 "
                    "file that adfric fit reads, in SI units: position, deflection and load, approach and retraction.")
    add = parser.add_argument
    add("files", metavar="FILE", type=Path, nargs="+", help="a format that afmformats knows (.jpk-force, .jpk-force-map, .jpk-qi-data, "
        ".ibw, .h5, .tab, .csv and .zip of AFM Workshop, .txt of Chiaro), or a table of text with heads (docs/guide/import.md)")
    add("-o", "--output", metavar="FILE.h5", type=Path, help="file to write (default: the name of the first FILE with .h5, in this "
        "folder); the picture stands beside it, with .png")
    add("--force", action="store_true", help="overwrite files that exist")
    add("--no-picture", action="store_true", help="write no picture")
    add("--sign", choices=("towards", "away"), help="heights rise towards the surface, or away from it (default: as the end shows at "
        "which the load rises; where that is not clear this option is asked for)")
    add("--flip-load", action="store_true", help="loads of the file are negative where the surface is pressed")
    add("--spring-constant", metavar="K", type=positive, help="of the lever [N/m], where the file states none or another one")
    add("--sensitivity", metavar="S", type=positive, help="of the deflection [m/V], where the file states none or another one")
    add("--height", choices=("measured", "piezo"), help="which height, where an instrument states both (default: measured)")
    add("--tip", action="store_true", help="heights are those of the tip, and not of the base of the lever")
    add("--grid", metavar="NX,NY", type=grid, help="the curves are a map, in rows along x")
    add("--format", choices=("nt-mdt",), help="files without a mark of their own: text of NT-MDT's Nova")
    table = parser.add_argument_group("tables of text").add_argument
    table("--height-column", metavar="NAME", help="column of the height, where its head is not known or several are")
    table("--load-column", metavar="NAME", help="column of the load")
    table("--deflection-column", metavar="NAME", help="column of the deflection, in metres or in volts")
    table("--unit", metavar="U", help="unit of lengths, where the table states none: m, um, nm ...")
    table("--load-unit", metavar="U", help="unit of the load, where the table states none: N, nN, pN ...")
    table("--deflection-unit", metavar="U", help="unit of the deflection, where the table states none: m, nm, V, mV ...")
    given = parser.parse_args(arguments)
    check_options(given)
    return given


def positive(text):
    """A number above 0."""
    value = float(text)
    if not value > 0 or not math.isfinite(value):
        raise ValueError
    return value


def grid(text):
    """Two numbers of curves."""
    values = [int(part) for part in text.split(",")]
    if len(values) != 2 or min(values) < 1:
        raise ValueError
    return values


positive.__name__ = grid.__name__ = "number"


def check_options(given):
    """Are the files there, and have those to write a name?"""
    for file in given.files:
        if not file.is_file():
            raise BadInput(f"{file}: " + ("this is no file" if file.exists() else "there is no such file"))
    given.output = given.output or Path(given.files[0].with_suffix(".h5").name)
    given.picture = None if given.no_picture else given.output.with_suffix(".png")
    if given.picture == given.output:
        raise BadInput(f"{given.output}: the picture has this name, --output needs another ending, such as .h5")


if __name__ == "__main__":
    read_command_line(sys.argv[1:])
