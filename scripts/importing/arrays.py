# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces in arrays without a word about their axes, as numpy and HDF5 files have them: shape (ny, nx), x runs fastest."""

import zipfile

import h5py
import numpy as np

from .problems import BadInput, FileFailure, first_line
from .source import Source, masked


def read_numpy(path, channel):
    """Heights in a `.npy` file, or those of a name in a `.npz` file."""
    try:
        loaded = np.load(path, allow_pickle=False)
        if isinstance(loaded, np.ndarray):
            arrays = {"": loaded}
        else:
            with loaded:
                # what is no array comes as bytes
                arrays = {name: array for name in loaded.files if isinstance(array := loaded[name], np.ndarray)}
    except OSError as problem:
        raise FileFailure(f"{path}: cannot read: {problem.strerror or first_line(problem)}") from None
    except (ValueError, EOFError, zipfile.BadZipFile) as problem:
        raise BadInput(f"{path}: no numpy file that can be read: {first_line(problem)}") from None
    name = choose({name: array for name, array in arrays.items() if is_surface(array)}, channel, path)
    return Source("npz" if name else "npy", masked(arrays[name]), facts={"channel": name} if name else {})


def read_hdf5(path, channel):
    """Heights in a dataset; its attributes `units`, `dx` and `dy` [m], as this script writes them, are honoured."""
    found = {}
    with h5py.File(path) as file:
        file.visititems(lambda name, item: found.update({name: item}) if is_dataset(item) else None)
        name = choose(found, channel.lstrip("/") if channel else channel, path)
        dataset = found[name]
        units = dataset.attrs.get("units")
        units = units.decode() if isinstance(units, bytes) else units
        spacing = tuple(float(dataset.attrs[step]) for step in ("dx", "dy")[:dataset.ndim] if step in dataset.attrs)
        is_complete = len(spacing) == dataset.ndim
        periodic = dataset.attrs.get("periodic")
        return Source("hdf5", masked(dataset[()]), spacing if is_complete else None, "m" if is_complete else None,
                      str(units) if units else None, None if periodic is None else bool(periodic), {"channel": name})


def is_dataset(item):
    """Is this a dataset that may be a surface, and not one of its axes?"""
    return isinstance(item, h5py.Dataset) and is_surface(item) and not item.is_scale


def is_surface(array):
    """Are these real numbers along one or two dimensions?"""
    return array.dtype.kind in "iuf" and array.ndim in (1, 2) and min(array.shape) > 0


def choose(arrays, channel, path):
    """Name of the array that is meant."""
    if not arrays:
        raise BadInput(f"{path}: there is no array of real numbers in one or two dimensions")
    if channel is not None:
        if channel not in arrays:
            raise BadInput(f"{path}: there is no channel '{channel}', there are {', '.join(arrays)}")
        return channel
    if len(arrays) > 1:
        raise BadInput(f"{path}: choose one of its arrays by --channel: {', '.join(arrays)}")
    return next(iter(arrays))
