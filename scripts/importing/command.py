# SPDX-License-Identifier: GPL-3.0-or-later
"""The command: the order of the steps, and what is shown."""

import os
import sys
import warnings
from contextlib import suppress

from plotting.printable import printable

from .options import read_command_line
from .problems import BadInput, FileFailure


def main(arguments):
    """Import a surface or a master curve; return the exit status."""
    return run("import_surface", arguments, read_command_line, import_file)


def run(program, arguments, read_options, read):
    """Import files; return the exit status: 0, 2 for bad input or options, 3 for files that cannot be read or written.

    `read` gives the lines to show, remarks, and the bytes of the file and of the picture.
    """
    try:
        given = read_options(arguments)
        with warnings.catch_warnings():
            # what they would say of the libraries; numbers that are none are refused
            warnings.simplefilter("ignore")
            write(program, given, *read_checked(given, arguments, read))
    except (BadInput, FileFailure) as problem:
        print(printable(f"{program}: {problem}"), file=sys.stderr)
        return problem.status
    except MemoryError:
        print(printable(f"{program}: {files_of(given)[0]}: there is not enough memory for it"), file=sys.stderr)
        return FileFailure.status
    except BrokenPipeError:
        # nobody reads what is shown; the files are written
        with suppress(OSError):
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return 0


def files_of(given):
    """The files to read."""
    return getattr(given, "files", None) or [given.file]


def read_checked(given, arguments, read):
    """Read, once the files to write may be written."""
    from .writing import check_target

    for target in filter(None, (given.output, given.picture)):
        for file in files_of(given):
            check_target(target, file, given.force)
    return read(given, arguments)


def write(program, given, lines, remarks, contents):
    """Write the files, and show what was read."""
    from .writing import write_files

    targets = [target for target in (given.output, given.picture) if target]
    write_files(dict(zip(targets, contents)), given.force)
    for text in remarks:
        print(printable(f"{program}: warning: {text}"), file=sys.stderr)
    for line in [*lines, *(f"  {name:<17}{target}" for name, target in zip(("file", "picture"), targets))]:
        print(printable(line))


def import_file(given, arguments):
    """A surface or a master curve."""
    return import_curve(given, arguments) if given.master_curve else import_heights(given, arguments)


def import_heights(given, arguments):
    """A surface: the lines to show, remarks, and the bytes of its file and picture."""
    from . import analysis, report, writing
    from .reading import read_source, treat
    from .source import in_metres, stated_length

    source = read_source(given.file, given.channel)
    surface, read = treat(in_metres(source, given, given.file), given)
    if surface.is_periodic and given.window:
        raise BadInput(f"{given.file}: --window is for a part of a surface, and this is a period, which needs none")
    results = analysis.analyse(surface, given.file, given.shortest_reliable, given.tip_radius or stated_length(source, "tip_radius"),
                               stated_length(source, "resolution"), given.window)
    if results.joined:
        results.periodogram.trend = read.trend
    contents = [writing.image_of_surface(surface, results, report.surface_attributes(given, arguments, source, surface, read))]
    if given.picture:
        from .picture import draw_surface

        contents.append(draw_surface(surface, results, given.file.name))
    if surface.is_periodic and analysis.is_open(results.seams):
        source.remarks.append("the opposite edges do not meet: this is hardly one period")
    return (report.surface_lines(given, source, surface, read, results), [f"{given.file}: {remark}" for remark in source.remarks],
            contents)


def import_curve(given, arguments):
    """A master curve: the lines to show, no remarks, and the bytes of its file and picture."""
    from . import report
    from .master_curve import image_of_curve, read_master_curve

    curve = read_master_curve(given.file, given)
    contents = [image_of_curve(curve, report.file_attributes("import_surface", [given.file], arguments, "text"))]
    if given.picture:
        from .picture import draw_master_curve

        contents.append(draw_master_curve(curve, given.file.name))
    return report.curve_lines(given, curve), [], contents
