# SPDX-License-Identifier: GPL-3.0-or-later
"""The options of the command line."""

import argparse
import sys
from pathlib import Path

from .parser import Parser
from .problems import BadInput
from .reading import WINDOWS, check_values

# options of surfaces alone, and of master curves alone, with the value that says that they are not given
OF_SURFACES = {"unit": None, "height_unit": None, "spacing": None, "channel": None, "transpose": False, "periodic": None,
               "detrend": None, "region": None, "average": 1, "most_missing": 0.05, "window": None, "shortest_reliable": None,
               "tip_radius": None}
OF_CURVES = {"frequency_unit": None, "modulus_unit": None, "reference_temperature": None, "poisson_ratio": None,
             "frequency_column": None, "storage_column": None, "loss_column": None, "tan_delta_column": None, "log10": None}


def read_command_line(arguments):
    """What the user asks for."""
    parser = Parser(prog="scripts/import_surface", allow_abbrev=False, description="Bring a measured surface, or with "
                    "--master-curve a measured master curve, into an HDF5 file that inputs can name, in SI units.")
    add = parser.add_argument
    add("file", metavar="FILE", type=Path, help="what was measured: a format that SurfaceTopography knows, .npy, .npz, .h5, "
        ".xyz, or .csv (docs/guide/import.md)")
    add("-o", "--output", metavar="FILE.h5", type=Path, help="file to write (default: the name of FILE with .h5, in this folder); "
        "the picture stands beside it, with .png")
    add("--force", action="store_true", help="overwrite files that exist")
    add("--no-picture", action="store_true", help="write no picture")
    surface = parser.add_argument_group("surfaces").add_argument
    surface("--unit", metavar="U", help="unit of the lengths, where the file states none: m, mm, um, nm ...")
    surface("--height-unit", metavar="U", help="unit of the heights, where the file states none and it is another one")
    surface("--spacing", metavar="DX[,DY]", type=numbers(1, 2), help="distance of neighbouring samples in this unit, "
            "where the file states none")
    surface("--channel", metavar="NAME", help="which of several channels or arrays")
    surface("--transpose", action="store_true", help="x and y change places, before all else, so that a model slides along the "
            "other direction")
    surface("--periodic", action=argparse.BooleanOptionalAction, help="this is one period, or a part of a larger surface "
            "(default: what the file states, otherwise a part)")
    surface("--region", metavar="X0,X1[,Y0,Y1]", type=numbers(2, 4), help="keep the samples between these positions [m]")
    surface("--detrend", choices=("none", "mean", "line", "plane", "curvature"), help="what is removed, by least squares "
            "(default: line or plane; mean of a period)")
    surface("--average", metavar="N", type=int, default=1, help="means over N samples of a line, N x N of a map")
    surface("--most-missing", metavar="SHARE", type=float, default=OF_SURFACES["most_missing"],
            help="largest share of missing samples that are interpolated (default: %(default)s)")
    surface("--window", choices=WINDOWS, help="window of the spectra of a part (default: hann); a period has none")
    surface("--shortest-reliable", metavar="L", type=float, help="shortest wave of the power spectrum [m] (default: 4 samples, or longer "
            "where the file states a tip radius or a resolution)")
    surface("--tip-radius", metavar="R", type=float, help="of the probe [m], which lengthens the shortest wave of the power spectrum to where "
            "the line is sharper than the probe")
    curve = parser.add_argument_group("master curves").add_argument
    curve("--master-curve", action="store_true", help="FILE is a table of frequency, storage and loss modulus")
    curve("--frequency-unit", metavar="U", help="Hz or rad/s, where the file does not state which")
    curve("--modulus-unit", metavar="U", help="Pa, kPa, MPa or GPa, where the file states none")
    curve("--reference-temperature", metavar="T", type=float, help="[K], where the file states none")
    curve("--poisson-ratio", metavar="NU", type=float, help="by which shear moduli become Young's moduli")
    for name in ("frequency", "storage", "loss", "tan-delta"):
        curve(f"--{name}-column", metavar="NAME", help=f"column of the {name.replace('-', ' ')}, where its head is not known or several are")
    curve("--log10", metavar="WHAT", nargs="+", choices=("frequency", "storage", "loss", "tan delta"),
          help="columns with decimal logarithms whose heads do not say so: frequency, storage, loss, 'tan delta'")
    given = parser.parse_args(arguments)
    check_options(given)
    return given


def numbers(fewest, most):
    """A type of options: numbers with commas between them."""
    def read(text):
        values = [float(part) for part in text.split(",")]
        if not fewest <= len(values) <= most or len(values) == 3:
            raise ValueError
        return values
    read.__name__ = "number"
    return read


def check_options(given):
    """Do the options go together?"""
    for name, absent in (OF_SURFACES if given.master_curve else OF_CURVES).items():
        if getattr(given, name) != absent:
            raise BadInput(f"--{name.replace('_', '-')} is for {'surfaces' if given.master_curve else 'master curves'}, "
                           f"{'not beside' if given.master_curve else 'beside'} --master-curve")
    check_values(given)
    if not given.file.is_file():
        raise BadInput(f"{given.file}: " + ("this is no file" if given.file.exists() else "there is no such file"))
    given.output = given.output or Path(given.file.with_suffix(".h5").name)
    given.picture = None if given.no_picture else given.output.with_suffix(".png")
    if given.picture == given.output:
        raise BadInput(f"{given.output}: the picture has this name, --output needs another ending, such as .h5")


if __name__ == "__main__":
    read_command_line(sys.argv[1:])
