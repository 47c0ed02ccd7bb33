# SPDX-License-Identifier: GPL-3.0-or-later
"""Results of the library as a dataset of xarray. The arrays stay where the library has them, until nobody needs them any more."""

import ctypes
import weakref

import numpy as np
import xarray as xr

from . import library as _library
from .library import library, text_of, words_of

DOUBLE, BYTE = np.dtype("f8"), np.dtype("i1")


class Owner:
    """Who owns the memory of results: they are closed when the last array is gone."""

    def __init__(self, handle):
        self.handle = handle
        weakref.finalize(self, library.adfric_close_results, handle).atexit = False


class Memory:
    """Memory of the library, as NumPy wants it described; it keeps its owner."""

    def __init__(self, owner, address, dtype, shape, strides):
        self.owner = owner
        self.__array_interface__ = {"version": 3, "data": (address, False), "typestr": dtype.str, "shape": shape,
                                    "strides": tuple(dtype.itemsize*step for step in strides)}


def dataset_of(handle):
    """The dataset of results, which are closed with it."""
    owner = Owner(handle)
    n = ctypes.c_int32()
    library.adfric_array_count(handle, n)
    coordinates, variables = {}, {}
    info = _library.Array()
    for place in range(n.value):
        library.adfric_array_at(handle, place, info)
        is_coordinate = info.role in (_library.COORDINATE, _library.PARAMETER, _library.WORDS)
        (coordinates if is_coordinate else variables)[text_of(info.name)] = variable_of(owner, info)
    if all(not variable.dims for variable in (*variables.values(), *coordinates.values())):
        return single_point(variables, coordinates, attributes_of(handle))
    return xr.Dataset(variables, coordinates, attributes_of(handle))


def single_point(variables, coordinates, attributes):
    """A dataset without dimensions. There is nothing to be aligned, and what xarray does to find that takes as long as many points."""
    try:
        return xr.Dataset._construct_direct({**coordinates, **variables}, set(coordinates), dims={}, attrs=attributes, indexes={})
    except (AttributeError, TypeError):
        return xr.Dataset(variables, coordinates, attributes)


def variable_of(owner, info):
    """An array with its dimensions and what is said of it."""
    dtype, address = (DOUBLE, info.values) if info.values else (BYTE, info.states)
    values = np.asarray(Memory(owner, address, dtype, tuple(info.shape[:info.rank]), tuple(info.strides[:info.rank])))
    dimensions = tuple(text_of(name) for name in info.dimensions[:info.rank])
    attributes = {"units": text_of(info.unit), "long_name": text_of(info.long_name)}
    meanings = words_of(info.flag_meanings)
    if info.role == _library.WORDS:
        return xr.Variable(dimensions, np.array(meanings), attributes)
    if meanings:
        attributes["flag_values"] = np.arange(info.first_flag, info.first_flag + len(meanings), dtype=BYTE)
        attributes["flag_meanings"] = " ".join(meanings)
    return xr.Variable(dimensions, values, attributes, fastpath=True)


def attributes_of(handle):
    """What is said of the results as a whole."""
    n = ctypes.c_int32()
    library.adfric_attribute_count(handle, n)
    attributes = {}
    info = _library.AttributeInfo()
    for place in range(n.value):
        library.adfric_attribute(handle, place, info)
        attributes[text_of(info.name)] = info.number if info.text is None else text_of(info.text)
    return attributes
