# SPDX-License-Identifier: GPL-3.0-or-later
"""The command scripts/import_curve: the order of its steps."""

from types import SimpleNamespace

from .curve_options import read_command_line
from .problems import BadInput, FileFailure, first_line

TEXT = (".txt", ".csv", ".tsv", ".tab", ".dat", ".asc")


def main(arguments):
    """Import force curves; return the exit status: 0, 2 for bad input or options, 3 for files that cannot be read or written."""
    from .command import run

    return run("import_curve", arguments, read_command_line, import_files)


def import_files(given, arguments):
    """Read, treat and put together: the lines to show, remarks, and the bytes of the file and the picture."""
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


def read_stack(given):
    """The curves of all files in one stack, their sources, which direction heights have, and remarks."""
    from .curve_stack import make_stack
    from .curve_treatment import treat

    sources, curves, directions, remarks = [], [], [], []
    for path in given.files:
        sources.append(read_source(path, given))
        treated, direction, said = treat(sources[-1], given, path)
        curves += treated
        directions.append(direction)
        remarks += [f"{path}: {remark}" for remark in said + sources[-1].remarks]
    return make_stack(curves, given.grid), sources, directions, remarks


def read_source(path, given):
    """Curves as a file has them, by the reader that knows it best."""
    from .curve_files import find_recipe, read_instrument_curves
    from .text_curve import read_text_curves

    try:
        recipe = find_recipe(path, given.format)
        if recipe:
            return read_instrument_curves(path, recipe, given)
        if path.suffix.lower() in TEXT:
            return read_text_curves(path, given)
    except OSError as problem:
        raise FileFailure(f"{path}: cannot read: {problem.strerror or first_line(problem)}") from None
    raise BadInput(f"{path}: none of the formats that afmformats knows, and no table of text ({', '.join(TEXT)})")


def options(**given):
    """Options as the command line has them, those that are not given with their usual values."""
    usual = dict.fromkeys(("sign", "spring_constant", "sensitivity", "height", "grid", "format", "height_column", "load_column",
                           "deflection_column", "unit", "load_unit", "deflection_unit"), None)
    return SimpleNamespace(**{**usual, "flip_load": False, "tip": False, **given})
