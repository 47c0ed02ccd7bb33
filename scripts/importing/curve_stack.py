# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves in one stack, along a grid where they are a map, and the file that `adfric fit` reads."""

from dataclasses import dataclass

import h5py
import numpy as np

from .curve_treatment import NOTHING, SEGMENTS, STATUS
from .problems import BadInput
from .text_surface import distinct, grid_step, places_on
from .writing import add_axis, add_dataset, hdf5_image

MEANINGS = {
    "load": ("N", "load, positive where the surface is pressed"),
    "position": ("m", "position of the base of the lever, rising towards the surface"),
    "approach": ("m", "position of the tip, rising towards the surface: that of the base less the deflection"),
    "deflection": ("m", "deflection of the lever, positive where the surface is pressed"),
    "time": ("s", "time"),
}
# a map has at least this share of its places filled, where positions alone make it one
FILLED = 0.75
# positions are on the grid of their indices where they miss it by less than this part of its step
OFF_GRID = 0.05


@dataclass
class Stack:
    """Curves by their places."""

    # list of `Treated`, None where a map has no curve
    curves: list
    # () for one curve, (n,) or (ny, nx)
    shape: tuple
    # positions along x and y [m], or indices; None of what is no map
    axes: tuple | None = None
    unit: str = "m"

    @property
    def samples(self):
        """Samples of the longest curve."""
        return max(len(curve.columns["load"]) for curve in self.curves if curve and curve.columns)


def make_stack(curves, grid):
    """The curves as a map, where they are one, and one after the other otherwise."""
    if not any(curve.columns for curve in curves):
        raise BadInput(f"no curve can be used: {curves[0].name} {curves[0].problem}")
    if grid:
        if grid[0] * grid[1] != len(curves):
            raise BadInput(f"--grid: given {grid[0]} x {grid[1]}, and there are {len(curves)} curves")
        return Stack(curves, (grid[1], grid[0]), (np.arange(grid[0]), np.arange(grid[1])), "1")
    if len(curves) == 1:
        return Stack(curves, ())
    return by_index(curves) or by_position(curves) or Stack(curves, (len(curves),))


def by_index(curves):
    """A map of curves that state their indices on a grid; None where they do not."""
    places = [(curve.source.index, curve.source.shape) for curve in curves]
    if any(index is None or shape is None for index, shape in places) or len({shape for _, shape in places}) > 1:
        return None
    (nx, ny), indices = places[0][1], [index for index, _ in places]
    if nx * ny < 2 or len(set(indices)) < len(indices) or any(not (0 <= i < nx and 0 <= j < ny) for i, j in indices):
        return None
    cells = [None] * (nx * ny)
    for curve, (i, j) in zip(curves, indices):
        cells[j * nx + i] = curve
    axes = [axis_of([index[along] for index in indices], [curve.source.position[along] if curve.source.position else np.nan
                                                          for curve in curves], count) for along, count in ((0, nx), (1, ny))]
    if any(axis is None for axis in axes):
        return Stack(cells, (ny, nx), (np.arange(nx), np.arange(ny)), "1")
    return Stack(cells, (ny, nx), tuple(axes))


def axis_of(indices, positions, count):
    """Positions along an axis, from those of some of its indices; None where these are not on a grid."""
    indices, positions = np.array(indices), np.array(positions, float)
    if np.isnan(positions).any() or np.ptp(indices) == 0:
        return None
    step, first = np.polyfit(indices, positions, 1)
    if not step or np.abs(first + step * indices - positions).max() > OFF_GRID * abs(step):
        return None
    return first + step * np.arange(count)


def by_position(curves):
    """A map of curves whose positions are on a grid; None where they are not."""
    if any(curve.source.position is None for curve in curves):
        return None
    axes, places = [], []
    for values in np.array([curve.source.position for curve in curves]).T:
        step = grid_step(distinct(values)) if np.ptp(values) > 0 else None
        place = None if step is None else places_on(values, step)
        if place is None:
            return None
        places.append(place)
        axes.append(values.min() + step * np.arange(place.max() + 1))
    nx, ny = map(len, axes)
    cells = [None] * (nx * ny)
    for curve, i, j in zip(curves, *places):
        if cells[j * nx + i] is not None:
            return None
        cells[j * nx + i] = curve
    return Stack(cells, (ny, nx), tuple(axes)) if len(curves) >= FILLED * len(cells) else None


def array_of(stack, name, segment=None, fill=np.nan):
    """A column of all curves, not a number behind the end of each; of one segment alone, if wanted. None if no curve has it."""
    rows = []
    for curve in stack.curves:
        values = None
        if curve and curve.columns:
            values = {"segment": curve.segment, "contact": curve.contact}.get(name, curve.columns.get(name))
            if values is not None and segment is not None:
                values = values[curve.segment == segment]
        rows.append(values)
    if not any(values is not None and len(values) for values in rows):
        return None
    longest = max(len(values) for values in rows if values is not None)
    array = np.full((len(rows), longest), fill)
    for row, values in zip(array, rows):
        if values is not None:
            row[:len(values)] = values
    return array.reshape(*stack.shape, longest)


def per_curve(stack, get, fill=np.nan):
    """A number of each curve."""
    return np.array([fill if curve is None else get(curve) for curve in stack.curves]).reshape(stack.shape)


def image_of_stack(stack, attributes):
    """The bytes of the file."""
    with hdf5_image() as (file, get_bytes):
        for key, value in attributes.items():
            file.attrs[key] = value
        axes = []
        if stack.axes:
            for name, values in zip("xy", stack.axes):
                add_axis(file, name, values, stack.unit, f"{'position' if stack.unit == 'm' else 'index'} along {name}")
            axes = ["y", "x"]
        elif stack.shape:
            add_axis(file, "curve", np.arange(stack.shape[0]), "1", "number of the curve")
            axes = ["curve"]
        add_columns(file, file, stack, axes)
        for number, name in enumerate(SEGMENTS):
            if array_of(stack, "load", number) is not None:
                group = file.create_group(f"segments/{name}")
                group.attrs["long_name"] = f"the samples of the {name} alone"
                add_columns(file, group, stack, axes, number)
        add_facts(file, stack, axes)
    return get_bytes()


def add_columns(file, group, stack, axes, segment=None):
    """The columns of all curves, or of one segment of each."""
    load = array_of(stack, "load", segment)
    add_axis(group, "sample", np.arange(load.shape[-1]), "1", "number of the sample")
    scales = [f"/{axis}" for axis in axes] + [f"{group.name.rstrip('/')}/sample"]
    for name, (unit, meaning) in MEANINGS.items():
        values = array_of(stack, name, segment)
        if values is not None:
            attach(file, add_dataset(group, name, values, unit, meaning), scales)
    contact = array_of(stack, "contact", segment)
    attach(file, add_dataset(group, "contact", contact, "1", "1 in contact, 0 free, not a number where that is not clear"), scales)
    if segment is None:
        values = array_of(stack, "segment", fill=NOTHING).astype(np.int8)
        enumerate_values(attach(file, add_dataset(group, "segment", values, "1", "segment of the sample"), scales),
                         {NOTHING: "none", **dict(enumerate(SEGMENTS))})


def attach(file, dataset, scales):
    """The dataset with its scales."""
    for dimension, scale in zip(dataset.dims, scales):
        dimension.attach_scale(file[scale])
    return dataset


def enumerate_values(dataset, meanings):
    """A dataset with what its values mean."""
    dataset.attrs["flag_values"] = np.array(list(meanings), np.int8)
    dataset.attrs["flag_meanings"] = " ".join(meanings.values())


def add_facts(file, stack, axes):
    """What belongs to each curve."""
    scales = [f"/{axis}" for axis in axes]
    missing = STATUS.index("missing")
    status = per_curve(stack, lambda curve: STATUS.index(curve.status), missing).astype(np.int8)
    enumerate_values(attach(file, add_dataset(file, "curve_status", status, "1", "what became of the curve"), scales), dict(enumerate(STATUS)))
    for name, unit, meaning in (("spring_constant", "N/m", "spring constant of the lever"),
                                ("sensitivity", "m/V", "deflection sensitivity of the lever"),
                                ("noise", "N", "standard deviation of the load on the base line")):
        values = per_curve(stack, lambda curve: np.nan if getattr(curve, name) is None else getattr(curve, name))
        if np.isfinite(values).any():
            attach(file, add_dataset(file, name, values, unit, meaning), scales)
    for name in ("name", "problem"):
        values = np.array([getattr(curve, name) if curve else "" for curve in stack.curves], object).reshape(stack.shape)
        dataset = file.create_dataset(f"curve_{name}", data=values, dtype=h5py.string_dtype())
        dataset.attrs["units"], dataset.attrs["long_name"] = "1", f"{name} of the curve"
        attach(file, dataset, scales)
