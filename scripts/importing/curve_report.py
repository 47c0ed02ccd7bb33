# SPDX-License-Identifier: GPL-3.0-or-later
"""The short table of what was read from force curves."""

import numpy as np

from .curve_treatment import SEGMENTS, STATUS
from .report import table

# so many curves that cannot be used are named on the terminal; the file names all
MOST_NAMED = 8


def stack_lines(given, stack, sources, directions):
    """The table of a stack, and how an input names it."""
    curves = [curve for curve in stack.curves if curve]
    with_data = [curve for curve in curves if curve.columns]
    rows = [("format", join(source.format for source in sources))]
    rows += [row for row in dict.fromkeys(row for source in sources for row in source.taken)][:12]
    shape = " x ".join(map(str, stack.shape[::-1])) + (" (x, y)" if len(stack.shape) == 2 else "")
    rows.append(("curves", f"{shape or 1}, {sum(curve.status == 'used' for curve in curves)} used"))
    rows.append(("samples", span([len(curve.columns["load"]) for curve in with_data], "{:d}") + " a curve"))
    dropped = sum(curve.dropped for curve in with_data)
    if dropped:
        rows.append(("left out", f"{dropped} samples without a height or a load"))
    origin = "as --sign says" if given.sign else "as the load shows, which rises there"
    rows.append(("heights", join(f"rise {'towards' if direction == 1 else 'away from'} the surface" for direction in directions) +
                 f", {origin}"))
    rows.append(("tip", join("as the file states it" if curve.source.is_tip else "position less deflection" for curve in with_data)))
    for name, key, unit in (("spring constant", "spring_constant", "N/m"), ("sensitivity", "sensitivity", "m/V")):
        values = [getattr(curve, key) for curve in with_data if getattr(curve, key)]
        rows.append((name, f"{span(values, '{:.6g}')} {unit}{option_or_file(given, key)}" if values else "not stated"))
    rows.append(("load", f"{min(curve.columns['load'].min() for curve in with_data):.6g} to "
                 f"{max(curve.columns['load'].max() for curve in with_data):.6g} N"))
    noise = [curve.noise for curve in with_data if np.isfinite(curve.noise)]
    if noise:
        rows.append(("noise", f"{np.median(noise):.3g} N, that of the load on the base line"))
    for number, name in enumerate(SEGMENTS):
        counts = [int((curve.segment == number).sum()) for curve in with_data]
        if any(counts):
            rows.append((name, f"{span([count for count in counts if count], '{:d}')} samples of "
                         f"{sum(count > 0 for count in counts)} curve{'s' * (sum(count > 0 for count in counts) > 1)}"))
    unclear = sum(int(np.isnan(curve.contact).sum()) for curve in with_data)
    if unclear:
        rows.append(("contact", f"not clear in {unclear} of {sum(len(curve.contact) for curve in with_data)} samples, which a fit leaves out"))
    for status in STATUS[1:]:
        count = sum(curve.status == status for curve in curves) + (status == "missing") * stack.curves.count(None)
        if count:
            rows.append((status.replace("_", " "), f"{count} of {len(stack.curves)} curves"))
    name = f"{given.output}:/segments/retraction/load" if any((curve.segment == 2).any() for curve in with_data) else f"{given.output}:/load"
    lines = [*table(join(map(str, given.files)), rows), f"  {'input':<17}file = '{name}', abscissa = 'approach', ordinate = 'load'"]
    springs = {curve.spring_constant for curve in with_data}
    if noise and len(springs) == 1 and None not in springs:
        # the noise is in the load alone where the base of the lever is the abscissa
        lines.append(f"  {'with its lever':<17}abscissa_column = 'position', sigma = {np.median(noise):.3g}, spring_stiffness = {springs.pop():.6g}")
    return lines


def option_or_file(given, key):
    """Whether an option takes the place of what the file states."""
    return "" if getattr(given, key) is None else f", as --{key.replace('_', '-')} says"


def remarks_of(stack):
    """Curves that cannot be used, a line each."""
    bad = [curve for curve in stack.curves if curve and curve.problem]
    lines = [f"{curve.name}: {curve.problem}" for curve in bad[:MOST_NAMED]]
    if len(bad) > MOST_NAMED:
        lines.append(f"and {len(bad) - MOST_NAMED} more curves, which curve_problem names in the file")
    return lines


def span(values, form):
    """The least and largest of some numbers."""
    low, high = min(values), max(values)
    return form.format(low) if low == high else f"{form.format(low)} to {form.format(high)}"


def join(texts):
    """Different texts, each once."""
    distinct = list(dict.fromkeys(texts))
    return ", ".join(distinct[:4]) + (f" and {len(distinct) - 4} more" if len(distinct) > 4 else "")
