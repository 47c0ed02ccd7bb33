# SPDX-License-Identifier: GPL-3.0-or-later
"""Results files."""

import os

import xarray as xr

from .errors import FailedError, InputError


def name_of(path, what):
    """The name of a file as the system takes it."""
    try:
        name = os.fsdecode(os.fspath(path))
    except (TypeError, ValueError):
        raise InputError(f"{what}: given {path!r}, allowed: the name of a file") from None
    if "\0" in name:
        raise InputError(f"{what}: given {name!r}, allowed: a name without characters that are 0")
    return name


def open_file(path):
    """Open a results file.

    Parameters
    ----------
    path : path
        What `adfric run` has written. A file larger than the memory is for `xarray.open_dataset(path, engine="h5netcdf")`, which
        reads what is asked for.

    Returns
    -------
    xarray.Dataset
        All of it, in memory; the file is closed.
    """
    name = name_of(path, "path")
    if not os.path.isfile(name):
        raise FailedError(f"{name}: there is no such file")
    try:
        with xr.open_dataset(name, engine="h5netcdf") as results:
            if not {"model", "adfric_version"} <= set(results.attrs):
                raise InputError(f"{name}: not a results file of adfric")
            return results.load()
    except OSError as problem:
        raise FailedError(f"{name}: cannot be read: {problem.strerror or 'not an HDF5 file, or a damaged one'}") from None
