# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces in files of instruments, as SurfaceTopography reads them.

Where its readers complete what a file does not say, they are not believed: the unit of heights in a text file, the period, and
formats without any mark of their own, for which other files would be taken.
"""

import dataclasses
import io
import json
from contextlib import redirect_stderr, redirect_stdout

import numpy as np

from .arrays import read_hdf5
from .problems import BadInput, first_line
from .source import Source, masked
from .text_surface import line_of
from .units import exponent_of

# formats that no mark tells; only the ending of the name does
WITHOUT_MARK = ("hgt", "nms")
# formats whose sizes SurfaceTopography 1.27 gets wrong by powers of ten: its own example would be 160 m wide
WRONG_SIZE = ("nms",)
# formats that say whether heights are one period; the readers of others call all heights a part
STATE_PERIOD = ("nc",)
# arrays that state nothing; as everywhere in the project x is the last index
ARRAYS = ("mat", "npy", "npz")
# first words of the tables of positions that state their units (HFM, Dektak)
INSTRUMENT_HEADS = (b"X;Y;valid", b"Scan Parameters")


def read_instrument_file(path, channel):
    """Read a file of an instrument; None where it is a table of positions, which `text_surface` reads."""
    # imported here, since it takes seconds that a bad option need not cost
    from SurfaceTopography.IO import CannotDetectFileFormat, open_topography

    # some readers print what they find
    with redirect_stdout(io.StringIO()), redirect_stderr(io.StringIO()):
        try:
            reader = open_topography(str(path))
        except CannotDetectFileFormat:
            raise BadInput(f"{path}: {reason_of(path)}") from None
        with reader:
            form = reader.format()
            if form in WITHOUT_MARK and path.suffix.lower() != f".{form}":
                raise BadInput(f"{path}: none of the formats that SurfaceTopography knows")
            if form == "h5":
                return read_hdf5(path, channel)
            if form == "xyz" and not has_instrument_head(path):
                return None
            return read_channel(reader, choose_channel(reader, channel, path), path)


def has_instrument_head(path):
    """Does a table of positions begin as profilometers write it, with units?"""
    with path.open("rb") as file:
        return file.read(64).startswith(INSTRUMENT_HEADS)


def reason_of(path):
    """Why no reader takes a file: what the reader of its ending says."""
    from SurfaceTopography.IO import readers

    for reader in readers:
        if path.suffix.lower().lstrip(".") in reader.file_extensions():
            try:
                reader(str(path)).close()
            except Exception as problem:
                return f"no {reader.format()} file that can be read: {first_line(problem)}"
    return "none of the formats that SurfaceTopography knows"


def choose_channel(reader, wanted, path):
    """The channel that is asked for; otherwise the only one with heights."""
    channels = {channel.channel_id: channel for channel in reader.channels}
    heights = [name for name, channel in channels.items() if channel.is_height_channel]
    if wanted is None and len(heights) == 1:
        return channels[heights[0]]
    if wanted is None:
        raise BadInput(f"{path}: there are no heights in it" if not heights else
                       f"{path}: choose one of its channels by --channel: {', '.join(heights)}")
    if wanted not in channels:
        raise BadInput(f"{path}: there is no channel '{wanted}', there are {', '.join(channels)}")
    if wanted not in heights:
        raise BadInput(f"{path}: the channel '{wanted}' has no heights")
    return channels[wanted]


def read_channel(reader, channel, path):
    """Heights of a channel and what the file says of them."""
    has_size = channel.physical_sizes is not None and channel.is_uniform is not False
    if has_size and len(channel.physical_sizes) != channel.dim:
        raise BadInput(f"{path}: the file states a size along one direction alone")
    is_line = channel.is_uniform is False
    sizes = {} if has_size or is_line else {"physical_sizes": tuple(map(float, channel.nb_grid_pts))}
    try:
        topography = reader.topography(channel_index=channel.index, **sizes)
        heights = topography.heights()
    except Exception as problem:
        raise BadInput(f"{path}: SurfaceTopography cannot read it: {first_line(problem)}") from None
    is_period = channel.is_periodic if channel.is_periodic or reader.format() in STATE_PERIOD else None
    source = Source(f"{reader.format()} ({reader.name()})", heights_of(topography, heights, reader.format()),
                    None, topography.unit, topography.unit, is_period, facts_of(topography.info, channel))
    if not topography.is_uniform:
        x, z = (np.asarray(values, dtype=float) for values in topography.positions_and_heights())
        line = line_of(x, z, source.format, [source.unit, source.height_unit], path)
        return dataclasses.replace(line, facts=source.facts)
    if reader.format() in WRONG_SIZE:
        source.unit = None
    elif has_size:
        source.spacing = tuple(float(size) / n for size, n in zip(topography.physical_sizes, topography.nb_grid_pts))
    return state_text_units(source, channel, path) if reader.format() == "asc" else source


def heights_of(topography, heights, form):
    """Heights with x as the last index."""
    if topography.dim == 2 and form not in ARRAYS:
        heights = heights.T
    return masked(heights)


def state_text_units(source, channel, path):
    """Units of a text file: what its reader has completed is taken back."""
    said = channel.info.get("raw_metadata", {})
    if said.get("format_flavor") in ("wyko", "spip"):
        return source
    source.height_unit = said.get("zunit") or None
    lateral = (said.get("xunit") or "").strip() or None
    if source.height_unit and lateral and source.spacing:
        # sizes are in the unit of the heights now
        return source
    if source.height_unit and source.spacing:
        raise BadInput(f"{path}: the file states a size, and no unit of it")
    if lateral and exponent_of(lateral, "length") is None:
        raise BadInput(f"{path}: the unit '{lateral}' of the size is not known")
    source.unit = lateral
    return source


def facts_of(info, channel):
    """What the file says of its making, as attributes."""
    instrument = info.get("instrument") or {}
    facts = {"channel": channel.channel_id, "acquisition_time": info.get("acquisition_time"),
             **{f"instrument_{key}": instrument.get(key) for key in ("name", "vendor", "serial", "software")}}
    facts = {key: str(value) for key, value in facts.items() if value}
    for key, value in (("instrument_parameters", instrument.get("parameters")), ("source_metadata", info.get("raw_metadata"))):
        if value:
            facts[key] = json.dumps(value, default=str, ensure_ascii=False)
    return facts
