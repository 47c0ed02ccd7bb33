# SPDX-License-Identifier: GPL-3.0-or-later
"""Measured surfaces."""

import os
import re
import warnings
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import xarray as xr

from .errors import FailedError, InputError
from .files import name_of


def read_surface(path, *, unit=None, height_unit=None, spacing=None, channel=None, transpose=False, periodic=None, region=None,
                 detrend=None, average=1, most_missing=0.05):
    """Read a measured surface, as `scripts/import_surface` does; needs SurfaceTopography: `pip install adfric[surfaces]`.

    Parameters
    ----------
    path : path
        What an instrument has written, .npy, .npz, .h5, .xyz or .csv (docs/guide/import.md).
    unit, height_unit : str
        Units of lengths and heights, where the file states none.
    spacing : float or pair of floats
        Distance of neighbouring samples in this unit, along x first, where the file states none.
    channel : str
        Which of several channels or arrays.
    transpose : bool
        Do x and y change places, before all else?
    periodic : bool
        Is this one period? Default: what the file states, otherwise it is a part of a larger surface.
    region : sequence of float
        Keep the samples between these positions (x0, x1, y0, y1) [m].
    detrend : str
        What is removed by least squares: 'none', 'mean', 'line', 'plane' or 'curvature'. Default: line or plane; mean of a period.
    average : int
        Means over so many samples along each direction.
    most_missing : float
        Largest share of missing samples, which are interpolated.

    Returns
    -------
    xarray.DataArray
        Heights [m], summits positive, of dimensions (y, x) or (x), which are the middles of the cells [m]; `attrs` has `length_x`
        and `length_y` [m], `dx`, `dy` and what was removed.
    """
    try:
        from .importing.problems import BadInput, FileFailure
        from .importing.reading import check_values, read_source, treat
        from .importing.source import in_metres
    except ImportError as problem:
        raise ImportError(f"adfric.read_surface needs SurfaceTopography and h5py: {problem}") from None
    path = name_of(path, "path")
    given = SimpleNamespace(unit=unit, height_unit=height_unit, channel=channel, transpose=transpose, periodic=periodic,
                            region=region, detrend=detrend, average=average, most_missing=most_missing,
                            spacing=None if spacing is None else list(np.atleast_1d(spacing)), file=Path(path))
    if not os.path.isfile(path):
        raise FailedError(f"{path}: there is no such file")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            check_values(given)
            source = read_source(given.file, channel)
            surface, read = treat(in_metres(source, given, given.file), given)
    except BadInput as problem:
        raise InputError(in_words_of_python(problem)) from None
    except FileFailure as problem:
        raise FailedError(str(problem)) from None
    for remark in source.remarks:
        warnings.warn(f"{path}: {remark}", stacklevel=2)
    return array_of(surface, read)


def in_words_of_python(problem):
    """A message whose options are named as arguments."""
    return re.sub(r"--([a-z]+(?:-[a-z]+)*)", lambda option: option[1].replace("-", "_"), str(problem))


def array_of(surface, read):
    """The heights with their axes."""
    names = "xy"[:surface.heights.ndim]
    axes = {}
    attributes = {"units": "m", "long_name": "height of the rough body, summits positive", "periodic": int(surface.is_periodic),
                  "detrend": read.trend, "missing_samples": read.missing}
    for name, n, step, origin, length in zip(names, surface.samples, surface.spacing, surface.origin, surface.lengths):
        axes[name] = (name, origin + step*(np.arange(n) + 0.5), {"units": "m", "long_name": f"position along {name}"})
        attributes.update({f"d{name}": step, f"length_{name}": length})
    return xr.DataArray(np.asarray(surface.heights.data), axes, tuple(reversed(names)), "z", attributes)
