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
    """Import one file; return the exit status: 0, 2 for bad input or options, 3 for files that cannot be read or written."""
    try:
        given = read_command_line(arguments)
        with warnings.catch_warnings():
            # what they would say of the libraries; numbers that are none are refused
            warnings.simplefilter("ignore")
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


def import_file(given, arguments):
    """Read, treat, write and show."""
    from .writing import check_target, write_files

    targets = [target for target in (given.output, given.picture) if target]
    for target in targets:
        check_target(target, given.file, given.force)
    lines, remarks, contents = import_curve(given, arguments) if given.master_curve else import_heights(given, arguments)
    write_files(dict(zip(targets, contents)), given.force)
    for text in remarks:
        print(printable(f"import_surface: warning: {given.file}: {text}"), file=sys.stderr)
    for line in [*lines, *(f"  {name:<17}{target}" for name, target in zip(("file", "picture"), targets))]:
        print(printable(line))


def import_heights(given, arguments):
    """A surface: the lines to show, remarks, and the bytes of its file and picture."""
    from . import analysis, report, writing
    from .reading import read_source, treat
    from .source import in_metres

    source = read_source(given.file, given.channel)
    surface, read = treat(in_metres(source, given, given.file), given)
    results = analysis.analyse(surface, given.file)
    contents = [writing.image_of_surface(surface, results, report.surface_attributes(given, arguments, source, surface, read))]
    if given.picture:
        from .picture import draw_surface

        contents.append(draw_surface(surface, results, given.file.name))
    if surface.is_periodic and analysis.is_open(results.seams):
        source.remarks.append("the opposite edges do not meet: this is hardly one period")
    return report.surface_lines(given, source, surface, read, results), source.remarks, contents


def import_curve(given, arguments):
    """A master curve: the lines to show, no remarks, and the bytes of its file and picture."""
    from . import report
    from .master_curve import image_of_curve, read_master_curve

    curve = read_master_curve(given.file, given)
    contents = [image_of_curve(curve, report.file_attributes(given, arguments, "text"))]
    if given.picture:
        from .picture import draw_master_curve

        contents.append(draw_master_curve(curve, given.file.name))
    return report.curve_lines(given, curve), [], contents
