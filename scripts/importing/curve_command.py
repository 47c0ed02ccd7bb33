# SPDX-License-Identifier: GPL-3.0-or-later
"""The command scripts/import_curve: the order of its steps."""

from .curve_options import read_command_line


def main(arguments):
    """Import force curves; return the exit status: 0, 2 for bad input or options, 3 for files that cannot be read or written."""
    from .command import run

    return run("import_curve", arguments, read_command_line, import_files)


def import_files(given, arguments):
    """Read, treat and put together: the lines to show, remarks, and the bytes of the file and the picture."""
    from .curve_reading import read_stack
    from .curve_report import remarks_of, stack_lines
    from .curve_stack import image_of_stack
    from .report import file_attributes

    stack, sources, directions, remarks = read_stack(given)
    attributes = file_attributes("import_curve", given.files, arguments, ", ".join(dict.fromkeys(source.format for source in sources)),
                                 next((source.software for source in sources if source.software), "none but this script"))
    contents = [image_of_stack(stack, attributes)]
    if given.picture:
        from .curve_picture import draw_stack

        contents.append(draw_stack(stack, given.files[0].name + (f" and {len(given.files) - 1} more" if len(given.files) > 1 else "")))
    return stack_lines(given, stack, sources, directions), remarks + remarks_of(stack), contents
