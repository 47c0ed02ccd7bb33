# SPDX-License-Identifier: GPL-3.0-or-later
"""Heights as a file has them, and the same in metres."""

import json
from dataclasses import dataclass, field

import numpy as np

from .problems import BadInput
from .units import exponent_of, settle, to_si

# a surface has so many samples along each direction at least, as the models want it
FEWEST_SAMPLES = 4


@dataclass
class Source:
    """What a file says; None stands for what it does not say."""

    # name of the format
    format: str
    # heights, shape (n) or (ny, nx), as the file has them; missing samples are masked
    heights: np.ma.MaskedArray
    # distance of neighbouring samples along x, and along y of a map
    spacing: tuple | None = None
    # unit of the spacing
    unit: str | None = None
    # unit of the heights
    height_unit: str | None = None
    # is one period given?
    is_periodic: bool | None = None
    # instrument, time and the like, as attributes of the file that is written
    facts: dict = field(default_factory=dict)
    # what the user should know, a line each
    remarks: list = field(default_factory=list)


@dataclass
class Surface:
    """Heights [m], shape (n) or (ny, nx), and distances of neighbouring samples [m], along x first."""

    heights: np.ma.MaskedArray
    spacing: tuple
    is_periodic: bool
    # how far the first sample is from the edge of what was measured [m], along x first
    origin: tuple = (0.0, 0.0)

    @property
    def samples(self):
        """Numbers of samples, along x first."""
        return self.heights.shape[::-1]

    @property
    def lengths(self):
        """Lengths [m], those of the cells around the samples; along x first."""
        return tuple(n * step for n, step in zip(self.samples, self.spacing))


def masked(heights):
    """Heights as 64-bit numbers, those that are no finite number masked."""
    heights = np.ma.masked_invalid(np.ma.asarray(heights, dtype=float))
    return np.ma.array(np.where(np.ma.getmaskarray(heights), 0.0, heights.data), mask=np.ma.getmaskarray(heights))


def in_metres(source, given, path):
    """The surface in metres: what the file states counts, and options say the rest."""
    check_shape(source.heights, path)
    unit = settle(source.unit, given.unit, "--unit", "length", path)
    height_unit = settle(source.height_unit, given.height_unit or (given.unit if source.height_unit is None else None),
                         "--height-unit", "length", path)
    spacing = settle_spacing(source, given.spacing, path)
    is_periodic = given.periodic if given.periodic is not None else bool(source.is_periodic)
    heights = masked(to_si(source.heights, height_unit, "length"))
    return Surface(heights, tuple(to_si(step, unit, "length") for step in spacing), is_periodic)


def check_shape(heights, path):
    """Are these heights of a line or a map, with samples enough?"""
    if heights.ndim not in (1, 2):
        raise BadInput(f"{path}: heights in {heights.ndim} dimensions, allowed: 1 or 2")
    if min(heights.shape) < FEWEST_SAMPLES:
        shape = " x ".join(map(str, heights.shape[::-1]))
        raise BadInput(f"{path}: {shape} samples are too few, allowed: at least {FEWEST_SAMPLES} along each direction")


def stated_length(source, name):
    """A length that the file states of its instrument, such as `tip_radius` or `resolution` [m]; None where there is none."""
    stated = json.loads(source.facts.get("instrument_parameters", "{}")).get(name)
    if not isinstance(stated, dict) or exponent_of(str(stated.get("unit")), "length") is None:
        return None
    length = to_si(float(stated.get("value") or 0), str(stated["unit"]), "length")
    return length if 0 < length < np.inf else None


def settle_spacing(source, given, path):
    """Distances of neighbouring samples in the unit of the file, along x first."""
    spacing = source.spacing
    if spacing is not None and given is not None:
        raise BadInput(f"{path}: the file states the spacing of its samples, --spacing is for files that do not")
    if spacing is None:
        if given is None:
            raise BadInput(f"{path}: the file does not state the spacing of its samples: give --spacing DX or DX,DY")
        if len(given) > source.heights.ndim:
            raise BadInput(f"{path}: --spacing has two numbers, and the file is a line")
        spacing = tuple(given) if len(given) == source.heights.ndim else (given[0],) * source.heights.ndim
    if not all(np.isfinite(step) and step > 0 for step in spacing):
        raise BadInput(f"{path}: the spacing of the samples is {', '.join(map(str, spacing))}, allowed: above 0")
    return spacing
