# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of results."""

import io
from pathlib import Path

import xarray as xr

from .errors import FailedError, InputError
from .files import name_of


def plot(results, *, x=None, y=None, data=None, output=None):
    """Draw the figure of results, or of several in one figure; needs matplotlib.

    Parameters
    ----------
    results : xarray.Dataset, path, or a list of these
        Results of `solve`, `run` or `open`, or results files.
    x : str
        Swept variable or result along the axis; default: the last one that is swept.
    y : str or list of str
        Results to draw, a panel for each. Without x and y what is drawn follows from what was swept.
    data : path
        Points to draw as well: a CSV file whose header has the names of x and of results, in SI units.
    output : path
        File to write, .png, .pdf or .svg; an existing one is replaced.

    Returns
    -------
    matplotlib.figure.Figure
    """
    try:
        from .plotting.command import make_figure, save_figure
        from .plotting.results import BadFile, Results
    except ImportError as problem:
        raise ImportError(f"adfric.plot needs matplotlib and h5py: {problem}") from None
    several = results if isinstance(results, (list, tuple)) else [results]
    if not several:
        raise InputError("results: given an empty list, allowed: at least one dataset or results file")
    data = None if data is None else Path(name_of(data, "data"))
    output = None if output is None else Path(name_of(output, "output"))
    try:
        runs = [results_of(one, Results) if isinstance(one, xr.Dataset) else read(one, Results) for one in several]
        figure = make_figure(runs, x, [y] if isinstance(y, str) else y, data)
        if output is not None:
            save_figure(figure, output)
    except BadFile as problem:
        raise InputError(str(problem)) from None
    except OSError as problem:
        raise FailedError(f"{output}: cannot write: {problem.strerror or problem}") from None
    return figure


def read(path, kind):
    """The results of a file."""
    if not isinstance(path, (str, bytes)) and not hasattr(path, "__fspath__"):
        raise InputError(f"results: given {type(path).__name__}, allowed: a dataset or the path of a results file")
    return kind(Path(name_of(path, "results")))


def results_of(dataset, kind):
    """The results of a dataset, as the figures want them: from an image of its file."""
    image = io.BytesIO()
    dataset.to_netcdf(image, engine="h5netcdf")
    image.seek(0)
    return kind(Path("results"), image)
