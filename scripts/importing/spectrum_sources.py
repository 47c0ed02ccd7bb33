# SPDX-License-Identifier: GPL-3.0-or-later
"""Measurements of one surface: files of scripts/import_surface, and containers of contact.engineering."""

import hashlib
import io
import zipfile
from contextlib import redirect_stderr, redirect_stdout
from dataclasses import dataclass

import h5py
import numpy as np

from . import treatment
from .problems import BadInput, FileFailure, first_line
from .periodogram import shortest_wave
from .source import FEWEST_SAMPLES, Surface, masked
from .text_surface import line_of
from .units import exponent_of, to_si


@dataclass
class Measurement:
    """Heights of one measurement without tilt, down to which wave they count, and why."""

    name: str
    surface: Surface
    shortest: float
    reason: str
    window: str | None
    trend: str


def read_measurements(given):
    """The measurements of all files, but for those that are left out."""
    found = []
    for path in given.files:
        try:
            if zipfile.is_zipfile(path):
                found += read_container(path, given)
            elif h5py.is_hdf5(path):
                found.append(read_imported(path))
            else:
                raise BadInput(f"{path}: neither a file of scripts/import_surface nor a container; scripts/import_surface reads "
                               "files of instruments")
        except OSError as problem:
            raise FileFailure(f"{path}: cannot read: {problem.strerror or first_line(problem)}") from None
    if not found:
        raise BadInput(f"{given.files[0]}: there is no measurement in it")
    number_names(found)
    names = [each.name for each in found]
    for name in given.leave_out:
        if name not in names:
            raise BadInput(f"--leave-out: there is no measurement '{name}', there are {', '.join(names)}")
    found = [each for each in found if each.name not in given.leave_out]
    if not found:
        raise BadInput("--leave-out: no measurement is left")
    refuse_same(found)
    return found


def number_names(found):
    """Give measurements of one name a number behind it, so that each can be meant."""
    names = [each.name for each in found]
    seen = {}
    for each, name in zip(found, names):
        if names.count(name) > 1:
            seen[name] = seen.get(name, 0) + 1
            each.name = f"{name} ({seen[name]})"


def refuse_same(found):
    """Refuse a measurement that is there twice: its errors would shrink without reason."""
    first = {}
    for each in found:
        heights = each.surface.heights.data
        key = heights.shape, each.surface.spacing, hashlib.sha256(np.ascontiguousarray(heights).tobytes()).digest()
        if key in first:
            raise BadInput(f"{first[key]} and {each.name} have the same heights: one measurement counts once; give one of them, or --leave-out "
                           f"'{each.name}'")
        first[key] = each.name


def read_imported(path):
    """Heights that scripts/import_surface has written, with the shortest wave and the window that it was told."""
    with h5py.File(path) as file:
        z, spectrum = file.get("z"), file.get("power_spectrum")
        if z is None or any(name not in z.attrs for name in ("dx", "periodic", "detrend")):
            raise BadInput(f"{path}: scripts/import_surface has not written this file")
        if spectrum is None:
            raise BadInput(f"{path}: there is no power spectrum in it: too few waves, or written by an older version")
        surface = Surface(masked(z[()]), tuple(float(z.attrs[step]) for step in ("dx", "dy")[:z.ndim]), bool(z.attrs["periodic"]))
        return Measurement(path.name, surface, float(spectrum.attrs["shortest_waves"][0]), str(spectrum.attrs["shortest_because"][0]),
                           str(spectrum.attrs["windows"][0]), str(z.attrs["detrend"]))


def read_container(path, given):
    """The measurements of a surface in a container, behind the filters that it states."""
    from SurfaceTopography.Container.IO import open_container

    with redirect_stdout(io.StringIO()), redirect_stderr(io.StringIO()):
        try:
            reader = open_container(str(path))
            containers = [reader.container(i) for i in range(reader.nb_containers)]
        except Exception:
            raise BadInput(f"{path}: no container that SurfaceTopography can read") from None
        names = [str(getattr(each, "info", {}).get("name", f"surface {i + 1}")) for i, each in enumerate(containers)]
        container = containers[choose(names, given.surface, path)]
        members = reader.members(names.index(given.surface) if given.surface else 0)
        return [read_member(container, i, f"{path.name}: {member.name}", given) for i, member in enumerate(members)]


def choose(names, wanted, path):
    """Index of the surface that is meant."""
    if not names:
        raise BadInput(f"{path}: there is no surface in it")
    if wanted is None and len(names) == 1:
        return 0
    if wanted is None or wanted not in names:
        raise BadInput(f"{path}: choose one of its surfaces by --surface: {', '.join(names)}")
    return names.index(wanted)


def read_member(container, index, name, given):
    """One measurement of a container."""
    try:
        topography = container[index]
        is_uniform, unit, is_periodic = topography.is_uniform, topography.unit, bool(topography.is_periodic)
        if is_uniform:
            heights = masked(np.ma.asarray(topography.heights()).T)
            spacing = tuple(float(size) / n for size, n in zip(topography.physical_sizes, topography.nb_grid_pts))
        else:
            x, z = (np.asarray(values, dtype=float) for values in topography.positions_and_heights())
        reliable = topography.short_reliability_cutoff()
    except Exception as problem:
        raise BadInput(f"{name}: SurfaceTopography cannot read it: {first_line(problem)}; --leave-out leaves it out") from None
    if unit is None or exponent_of(str(unit), "length") is None:
        raise BadInput(f"{name}: its unit is not known, given {unit}")
    if not is_uniform:
        line = line_of(x, z, "", [str(unit)] * 2, name)
        heights, spacing = line.heights, line.spacing
    if min(heights.shape) < FEWEST_SAMPLES:
        raise BadInput(f"{name}: too few samples; --leave-out leaves it out")
    surface = Surface(masked(to_si(heights, str(unit), "length")), tuple(to_si(step, str(unit), "length") for step in spacing), is_periodic)
    treatment.missing_samples(surface, given.most_missing, name)
    trend = treatment.choose_trend(surface, None, name)
    surface, _ = treatment.remove_trend(surface, trend, name)
    surface = treatment.fill_gaps(surface)
    length, reason = shortest_wave(surface, resolution=to_si(float(reliable), str(unit), "length") if reliable else None)
    return Measurement(name, surface, length, reason, None, trend)
