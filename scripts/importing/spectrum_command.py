# SPDX-License-Identifier: GPL-3.0-or-later
"""The command scripts/import_spectrum: the order of its steps."""

from .spectrum_options import read_command_line


def main(arguments):
    """Join measurements; return the exit status: 0, 2 for bad input or options, 3 for files that cannot be read or written."""
    from .command import run

    return run("import_spectrum", arguments, read_command_line, import_files)


def import_files(given, arguments):
    """Read and join: the lines to show, remarks, and the bytes of the file and the picture."""
    from .disagreement import check_agreement
    from .joined_spectrum import join
    from .periodogram import periodogram_of
    from .problems import BadInput, NoSpectrum
    from .report import file_attributes, joined_lines
    from .spectrum_sources import read_measurements
    from .writing import image_of_spectrum

    measurements = read_measurements(given)
    periodograms, remarks = [], []
    for each in measurements:
        if given.window and each.surface.is_periodic:
            raise BadInput(f"{each.name}: --window is for parts of a surface, and this is a period, which needs none")
        try:
            found = periodogram_of(each.surface, each.name, each.shortest, each.reason, given.window or each.window)
        except NoSpectrum as problem:
            remarks.append(f"{each.name}: left out: {problem}")
            continue
        found.trend = each.trend
        periodograms.append(found)
    if not periodograms:
        raise BadInput("no measurement has waves enough for a power spectrum")
    remarks += check_agreement(periodograms) + gaps(periodograms)
    joined = join(periodograms)
    contents = [image_of_spectrum(joined, periodograms, file_attributes("import_spectrum", given.files, arguments, "heights"))]
    if given.picture:
        from .spectrum_picture import draw_joined

        contents.append(draw_joined(joined, periodograms, given.output.name))
    return joined_lines(given, joined, periodograms), remarks, contents


def gaps(periodograms):
    """A line for each range in which there are no data."""
    import numpy as np

    remarks = []
    ends = sorted(each.ends for each in periodograms)
    last = ends[0][1]
    for begin, end in ends[1:]:
        if begin > last * 1.001:
            remarks.append(f"no measurement has waves of {2 * np.pi / begin:.3g} to {2 * np.pi / last:.3g} m: the spectrum between is a guess, "
                           "as its error shows")
        last = max(last, end)
    return remarks
