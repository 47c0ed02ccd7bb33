# SPDX-License-Identifier: GPL-3.0-or-later
"""Measured force curves and master curves."""

import io
import os
import warnings
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import xarray as xr

from .errors import FailedError, InputError
from .files import name_of
from .surfaces import in_words_of_python

# segments of force curves that may be wanted alone
SEGMENTS = ("approach", "dwell", "retraction")


def read_curve(path, *, segment=None, sign=None, flip_load=False, spring_constant=None, sensitivity=None, height=None, tip=False, grid=None,
               format=None, height_column=None, load_column=None, deflection_column=None, unit=None, load_unit=None,  # noqa: A002
               deflection_unit=None):
    """Read force curves, as `scripts/import_curve` does: a stack that `fit` takes. Formats of instruments need afmformats:
    `pip install adfric[curves]`.

    Parameters
    ----------
    path : path, or list of paths
        What an instrument has written, or tables of text with heads (docs/guide/import.md). All curves make one stack.
    segment : str
        'approach', 'dwell' or 'retraction': the samples of this segment alone. Default: all, with a column `segment`.
    sign : str
        'towards' or 'away': heights rise towards the surface, or away from it. Default: as the load tells.
    flip_load : bool
        Are loads of the file negative where the surface is pressed?
    spring_constant, sensitivity : float
        Of the lever [N/m], of the deflection [m/V], where the file states none or another one.
    height : str
        'measured' or 'piezo', where an instrument states both.
    tip : bool
        Are heights those of the tip, and not of the base of the lever?
    grid : pair of int
        The curves are a map of so many along x and y.
    format, height_column, load_column, deflection_column, unit, load_unit, deflection_unit : str
        As the options of the script.

    Returns
    -------
    xarray.Dataset
        `load` [N], `position` and `approach` [m], where the file has them `deflection` and `time`, and `contact`, over (y, x, sample),
        (curve, sample) or (sample).
    """
    try:
        from .importing.curve_reading import options, read_stack
        from .importing.curve_stack import image_of_stack
        from .importing.problems import BadInput, FileFailure
    except ImportError as problem:
        raise ImportError(f"adfric.read_curve needs h5py: {problem}") from None
    files = [Path(name_of(one, "path")) for one in (path if isinstance(path, (list, tuple)) else [path])]
    if not files:
        raise InputError("path: given an empty list, allowed: at least one file")
    for file in files:
        if not os.path.isfile(file):
            raise FailedError(f"{file}: there is no such file")
    check_given(segment, sign, height, spring_constant, sensitivity, grid)
    given = options(files=files, sign=sign, flip_load=flip_load, spring_constant=spring_constant, sensitivity=sensitivity, height=height,
                    tip=tip, grid=None if grid is None else list(grid), format=format, height_column=height_column,
                    load_column=load_column, deflection_column=deflection_column, unit=unit, load_unit=load_unit,
                    deflection_unit=deflection_unit)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            stack, _, _, remarks = read_stack(given)
            image = image_of_stack(stack, {})
    except ImportError as problem:
        raise ImportError(f"adfric.read_curve needs afmformats for this file: {problem}") from None
    except BadInput as problem:
        raise InputError(in_words_of_python(problem)) from None
    except FileFailure as problem:
        raise FailedError(str(problem)) from None
    for remark in remarks:
        warnings.warn(remark, stacklevel=2)
    return dataset_of_stack(image, segment, files)


def check_given(segment, sign, height, spring_constant, sensitivity, grid):
    """Have options a value that they may have?"""
    for name, value, allowed in (("segment", segment, SEGMENTS), ("sign", sign, ("towards", "away")),
                                 ("height", height, ("measured", "piezo"))):
        if value is not None and value not in allowed:
            raise InputError(f"{name}: given {value!r}, allowed: {', '.join(allowed)}")
    for name, value in (("spring_constant", spring_constant), ("sensitivity", sensitivity)):
        if value is not None and not (np.isfinite(value) and value > 0):
            raise InputError(f"{name}: given {value}, allowed: a number > 0")
    if grid is not None and (len(grid) != 2 or min(grid) < 1):
        raise InputError(f"grid: given {grid}, allowed: two numbers of curves, along x and along y")


def dataset_of_stack(image, segment, files):
    """The stack as a dataset, or a segment of it with what is said of each curve."""
    with xr.open_dataset(io.BytesIO(image), engine="h5netcdf") as found:
        whole = found.load()
    if segment is None:
        return whole
    try:
        with xr.open_dataset(io.BytesIO(image), engine="h5netcdf", group=f"segments/{segment}") as found:
            part = found.load()
    except OSError:
        raise InputError(f"{files[0]}: no curve has a segment {segment!r}") from None
    beside = {name: values for name, values in whole.variables.items() if "sample" not in values.dims and name not in part.variables}
    return part.assign({name: values for name, values in beside.items() if name not in whole.coords}).assign_coords(
        {name: values for name, values in beside.items() if name in whole.coords})


def read_master_curve(path, *, frequency_unit=None, modulus_unit=None, poisson_ratio=None, reference_temperature=None, columns=None,
                      log10=None):
    """Read a master curve, as `scripts/import_surface --master-curve` does.

    Parameters
    ----------
    path : path
        A table with heads: frequency, storage modulus, and loss modulus or tan delta (docs/guide/import.md).
    frequency_unit, modulus_unit : str
        Where the table states none: 'Hz' or 'rad/s', 'Pa', 'MPa' ...
    poisson_ratio : float
        By which shear moduli become Young's moduli.
    reference_temperature : float
        [K], where the file states none.
    columns : dict
        Names of the columns where heads are not known: those of 'frequency', 'storage', 'loss', 'tan_delta'.
    log10 : list of str
        Which of these are decimal logarithms.

    Returns
    -------
    xarray.Dataset
        `storage` and `loss` [Pa], Young's moduli over `omega` [rad/s], which rises; `attrs` has `reference_temperature` [K]. A model takes
        them as `master_curve=[curve.omega, curve.storage, curve.loss]`.
    """
    from .importing import master_curve
    from .importing.problems import BadInput, FileFailure

    file = Path(name_of(path, "path"))
    if not os.path.isfile(file):
        raise FailedError(f"{file}: there is no such file")
    columns = columns or {}
    given = SimpleNamespace(file=file, frequency_unit=frequency_unit, modulus_unit=modulus_unit, poisson_ratio=poisson_ratio,
                            reference_temperature=reference_temperature, log10=[one.replace("_", " ") for one in log10 or []],
                            **{f"{name}_column": columns.get(name) for name in ("frequency", "storage", "loss", "tan_delta")})
    try:
        curve = master_curve.read_master_curve(file, given)
    except BadInput as problem:
        raise InputError(in_words_of_python(problem)) from None
    except FileFailure as problem:
        raise FailedError(str(problem)) from None
    attributes = {"reference_temperature": curve.temperature}
    if curve.poisson_ratio is not None:
        attributes["poisson_ratio"] = curve.poisson_ratio
    return xr.Dataset({"storage": ("omega", curve.storage, {"units": "Pa", "long_name": "storage modulus"}),
                       "loss": ("omega", curve.loss, {"units": "Pa", "long_name": "loss modulus"})},
                      {"omega": ("omega", curve.omega, {"units": "rad/s", "long_name": "angular frequency"})}, attributes)
