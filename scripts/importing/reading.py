# SPDX-License-Identifier: GPL-3.0-or-later
"""Heights of a file, and what is done to them."""

from types import SimpleNamespace

from .problems import BadInput, FileFailure, first_line

# endings of text files that may be tables of positions
TEXT = (".csv", ".xyz", ".txt", ".dat", ".asc")
# windows of spectra by their words
WINDOWS = ("hann", "none")


def check_values(given):
    """May numbers that say what is done to heights have these values?"""
    if given.average < 1:
        raise BadInput(f"--average: given {given.average}, allowed: 1 or more")
    if not 0 <= given.most_missing < 1:
        raise BadInput(f"--most-missing: given {given.most_missing:g}, allowed: 0 or more, below 1")
    for name in ("shortest_reliable", "tip_radius"):
        value = getattr(given, name, None)
        if value is not None and not 0 < value < float("inf"):
            raise BadInput(f"--{name.replace('_', '-')}: given {value:g}, allowed: above 0")
    if getattr(given, "shortest_reliable", None) and given.tip_radius:
        raise BadInput("--shortest-reliable and --tip-radius say the same thing: give one")


def read_source(path, channel):
    """Heights as the file has them, by the reader that knows it best."""
    from .arrays import read_numpy
    from .instrument_files import has_instrument_head, read_instrument_file
    from .tables import count_columns
    from .text_surface import read_text_surface, states_size

    ending = path.suffix.lower()
    try:
        if ending in (".npy", ".npz"):
            return read_numpy(path, channel)
        if ending in TEXT and not has_instrument_head(path):
            columns = count_columns(path)
            # other texts with a head of their own are left to the reader that knows such heads
            if columns in (2, 3) or ending in (".csv", ".xyz") or columns and states_size(path):
                return read_text_surface(path)
        return read_instrument_file(path, channel) or read_text_surface(path)
    except OSError as problem:
        raise FileFailure(f"{path}: cannot read: {problem.strerror or first_line(problem)}") from None


def treat(surface, given):
    """The surface without gaps and tilt, and what was found on the way."""
    from . import treatment

    path = given.file
    if given.transpose:
        surface = treatment.transpose(surface, path)
    if given.region:
        surface = treatment.cut_out(surface, given.region, path)
        # a part of a period is no period
        surface.is_periodic = bool(given.periodic)
    missing = treatment.missing_samples(surface, given.most_missing, path)
    trend = treatment.choose_trend(surface, given.detrend, path)
    read = SimpleNamespace(samples=surface.heights.size, missing=missing, trend=trend, lengths=surface.lengths)
    surface, read.coefficients = treatment.remove_trend(surface, trend, path)
    surface = treatment.average(treatment.fill_gaps(surface), given.average, path)
    if surface.heights.data.min() == surface.heights.data.max():
        raise BadInput(f"{path}: all heights are the same")
    return surface, read
