# SPDX-License-Identifier: GPL-3.0-or-later
"""Force curves of files in one stack."""

from types import SimpleNamespace

from .problems import BadInput, FileFailure, first_line


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
    from .curve_files import TABLES, find_recipe, read_instrument_curves
    from .text_curve import read_text_curves

    try:
        recipe = find_recipe(path, given.format)
        if recipe:
            return read_instrument_curves(path, recipe, given)
        if path.suffix.lower() in TABLES:
            return read_text_curves(path, given)
    except OSError as problem:
        raise FileFailure(f"{path}: cannot read: {problem.strerror or first_line(problem)}") from None
    raise BadInput(f"{path}: none of the formats that afmformats knows, and no table of text ({', '.join(TABLES)})")


def options(**given):
    """Options as the command line has them, those that are not given with their usual values."""
    usual = dict.fromkeys(("sign", "spring_constant", "sensitivity", "height", "grid", "format", "height_column", "load_column",
                           "deflection_column", "unit", "load_unit", "deflection_unit"), None)
    return SimpleNamespace(**{**usual, "flip_load": False, "tip": False, **given})
