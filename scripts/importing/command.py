"""The command line: options, the order of the steps, and what is shown."""

import argparse
import os
import sys
import warnings
from contextlib import suppress
from pathlib import Path
from types import SimpleNamespace

from plotting.command import Parser as PlainParser
from plotting.printable import printable

from .problems import BadInput, FileFailure, first_line

# endings of text files that may be tables of positions
TEXT = (".csv", ".xyz", ".txt", ".dat", ".asc")
# options of surfaces alone, and of master curves alone, with the value that says that they are not given
OF_SURFACES = {"unit": None, "height_unit": None, "spacing": None, "channel": None, "transpose": False, "periodic": None,
               "detrend": None, "region": None, "average": 1, "most_missing": 0.05}
OF_CURVES = {"frequency_unit": None, "modulus_unit": None, "reference_temperature": None, "poisson_ratio": None}


class Parser(PlainParser):
    """A parser that reports a bad option in one line."""

    def error(self, message):
        raise BadInput(message)


def main(arguments):
    """Import one file; return the exit status: 0, 2 for bad input or options, 3 for files that cannot be read or written."""
    try:
        given = read_command_line(arguments)
        with warnings.catch_warnings():
            warnings.showwarning = lambda message, *rest, **more: remark(first_line(message))
            import_file(given, arguments)
    except (BadInput, FileFailure) as problem:
        print(printable(f"import_surface: {problem}"), file=sys.stderr)
        return problem.status
    except MemoryError:
        print(printable(f"import_surface: {given.file}: there is not enough memory for it"), file=sys.stderr)
        return FileFailure.status
    except BrokenPipeError:
        # nobody reads what is shown; the files are written
        with suppress(OSError):
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return 0


def read_command_line(arguments):
    """What the user asks for."""
    parser = Parser(prog="scripts/import_surface", allow_abbrev=False, description="Bring a measured surface, or with "
                    "--master-curve a measured master curve, into an HDF5 file that inputs can name, in SI units.")
    add = parser.add_argument
    add("file", metavar="FILE", type=Path, help="what was measured: a format that SurfaceTopography knows, .npy, .npz, .h5, "
        ".xyz, or .csv (docs/import.md)")
    add("-o", "--output", metavar="FILE.h5", type=Path, help="file to write (default: the name of FILE with .h5, in this folder); "
        "the picture stands beside it, with .png")
    add("--force", action="store_true", help="overwrite files that exist")
    surface = parser.add_argument_group("surfaces").add_argument
    surface("--unit", metavar="U", help="unit of the lengths, where the file states none: m, mm, um, nm ...")
    surface("--height-unit", metavar="U", help="unit of the heights, where the file states none and it is another one")
    surface("--spacing", metavar="DX[,DY]", type=numbers(1, 2), help="distance of neighbouring points in this unit, where the file "
            "states none")
    surface("--channel", metavar="NAME", help="which of several channels or arrays")
    surface("--transpose", action="store_true", help="x and y change places, so that a model slides along the other direction")
    surface("--periodic", action=argparse.BooleanOptionalAction, help="this is one period, or a part of a larger surface "
            "(default: what the file states, otherwise a part)")
    surface("--region", metavar="X0,X1[,Y0,Y1]", type=numbers(2, 4), help="keep the points between these positions [m]")
    surface("--detrend", choices=("none", "mean", "line", "plane", "curvature"), help="what is removed, by least squares "
            "(default: line or plane; mean of a period)")
    surface("--average", metavar="N", type=int, default=1, help="means over N points of a line, N x N of a map")
    surface("--most-missing", metavar="SHARE", type=float, default=OF_SURFACES["most_missing"],
            help="largest share of missing points that are interpolated (default: %(default)s)")
    curve = parser.add_argument_group("master curves").add_argument
    curve("--master-curve", action="store_true", help="FILE is a table of frequency, storage and loss modulus")
    curve("--frequency-unit", metavar="U", help="Hz or rad/s, where the file does not state which")
    curve("--modulus-unit", metavar="U", help="Pa, kPa, MPa or GPa, where the file states none")
    curve("--reference-temperature", metavar="T", type=float, help="[K], where the file states none")
    curve("--poisson-ratio", metavar="NU", type=float, help="by which shear moduli become Young's moduli")
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
    if given.average < 1:
        raise BadInput(f"--average: given {given.average}, allowed: 1 or more")
    if not 0 <= given.most_missing < 1:
        raise BadInput(f"--most-missing: given {given.most_missing:g}, allowed: 0 or more, below 1")
    if not given.file.is_file():
        raise BadInput(f"{given.file}: " + ("this is no file" if given.file.exists() else "there is no such file"))
    given.output = given.output or Path(given.file.with_suffix(".h5").name)
    given.picture = given.output.with_suffix(".png")
    if given.picture == given.output:
        raise BadInput(f"{given.output}: the picture has this name, --output needs another ending, such as .h5")


def import_file(given, arguments):
    """Read, treat, write and show."""
    from .writing import check_target, new_files

    for target in (given.output, given.picture):
        check_target(target, given.file, given.force)
    lines, write = import_curve(given, arguments) if given.master_curve else import_heights(given, arguments)
    with new_files([given.output, given.picture], given.force) as (results, picture):
        write(results, picture)
    for line in [*lines, f"  {'file':<17}{given.output}", f"  {'picture':<17}{given.picture}"]:
        print(printable(line))


def import_heights(given, arguments):
    """A surface: the lines to show, and what writes its files."""
    from . import analysis, report, treatment, writing
    from .picture import draw_surface
    from .source import in_metres

    source = read_source(given.file, given.channel)
    for text in source.remarks:
        remark(f"{given.file}: {text}")
    if given.transpose:
        transpose(source, given)
    surface = in_metres(source, given, given.file)
    if given.region:
        surface = treatment.cut_out(surface, given.region, given.file)
        # a part of a period is no period
        surface.is_periodic = bool(given.periodic)
    missing = treatment.missing_points(surface, given.most_missing, given.file)
    trend = treatment.choose_trend(surface, given.detrend, given.file)
    read = SimpleNamespace(points=surface.heights.size, missing=missing, trend=trend, lengths=surface.lengths)
    surface, read.coefficients = treatment.remove_trend(surface, trend, given.file)
    surface = treatment.average(treatment.fill_gaps(surface), given.average, given.file)
    if surface.heights.data.min() == surface.heights.data.max():
        raise BadInput(f"{given.file}: all heights are the same")
    results = SimpleNamespace(moments=analysis.moments_of(surface), spectra=analysis.spectra_of(surface),
                              binned=analysis.binned(surface), distribution=analysis.distribution_of(surface),
                              seams=analysis.seams_of(surface))
    attributes = report.surface_attributes(given, arguments, source, surface, read)
    if surface.is_periodic and any(step > report.OPEN_SEAM * largest for step, largest in results.seams):
        remark(f"{given.file}: the opposite edges do not meet: this is hardly one period")

    def write(path, picture):
        writing.write_surface(path, surface, results, attributes)
        draw_surface(surface, results, given.file.name, picture)

    return report.surface_lines(given, source, surface, read, results), write


def import_curve(given, arguments):
    """A master curve: the lines to show, and what writes its files."""
    from . import report
    from .master_curve import read_master_curve, write_master_curve
    from .picture import draw_master_curve

    curve = read_master_curve(given.file, given)

    def write(path, picture):
        write_master_curve(path, curve, report.file_attributes(given, arguments, "text"))
        draw_master_curve(curve, given.file.name, picture)

    return report.curve_lines(given, curve), write


def read_source(path, channel):
    """Heights as the file has them, by the reader that knows it best."""
    from .arrays import read_numpy
    from .instrument_files import has_instrument_head, read_instrument_file
    from .tables import count_columns
    from .text_surface import read_text_surface

    ending = path.suffix.lower()
    try:
        if ending in (".npy", ".npz"):
            return read_numpy(path, channel)
        if ending in TEXT and not has_instrument_head(path):
            columns = count_columns(path)
            # other texts with a head of their own are left to the reader that knows such heads
            if columns in (2, 3) or ending in (".csv", ".xyz"):
                return read_text_surface(path)
        return read_instrument_file(path, channel) or read_text_surface(path)
    except OSError as problem:
        raise FileFailure(f"{path}: cannot read: {problem.strerror or first_line(problem)}") from None


def transpose(source, given):
    """Change the places of x and y."""
    if source.heights.ndim == 1:
        raise BadInput(f"{given.file}: --transpose is for maps, this is a line")
    source.heights = source.heights.T
    source.spacing = source.spacing and source.spacing[::-1]


def remark(text):
    """A warning, on standard error."""
    print(printable(f"import_surface: warning: {text}"), file=sys.stderr)
