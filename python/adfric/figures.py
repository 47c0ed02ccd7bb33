# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of results."""

import io
from pathlib import Path

import xarray as xr

from .errors import FailedError, InputError
from .files import name_of


def plot(results, *, x=None, y=None, data=None, output=None, interactive=False):
    """Draw the figure of results, or of several in one figure; needs matplotlib.

    Parameters
    ----------
    results : xarray.Dataset, path, or a list of these
        Results of `solve`, `run` or `open`, or results files.
    x : str
        Swept variable or result along the axis; default: the last one that is swept. Or a profile, as gap.
    y : str or list of str
        Results to draw, a panel for each; or profiles, as pressure. Without x and y what is drawn follows from what was swept.
    data : path
        Points to draw as well: a CSV file whose header has the names of x and of results, in SI units.
    output : path
        File to write, .png, .pdf or .svg, or .html where the figure is interactive; an existing one is replaced.
    interactive : bool
        Figures to hover, to zoom and to choose from, as `scripts/report` has them, for a notebook; needs bokeh, too. x and y are
        drawn at first; y is one name, and there is no data.

    Returns
    -------
    matplotlib.figure.Figure, or an object that a notebook shows, whose `html` is the page of the figures
    """
    if interactive:
        return plot_interactively(results, x, y, data, output)
    try:
        from .plotting.command import make_figure, save_figure
        from .plotting.results import BadFile, Results
    except ImportError as problem:
        raise ImportError(f"adfric.plot needs matplotlib and h5py: {problem}") from None
    several = several_of(results)
    data = None if data is None else Path(name_of(data, "data"))
    output = None if output is None else Path(name_of(output, "output"))
    try:
        runs = [read(one, Results) for one in several]
        figure = make_figure(runs, x, [y] if isinstance(y, str) else y, data)
        if output is not None:
            save_figure(figure, output)
    except BadFile as problem:
        raise InputError(str(problem)) from None
    except OSError as problem:
        raise FailedError(f"{output}: cannot write: {problem.strerror or problem}") from None
    return figure


def plot_interactively(results, x, y, data, output):
    """Figures to hover, to zoom and to choose from."""
    try:
        from .importing.problems import FileFailure
        from .importing.writing import write_files
        from .plotting.results import BadFile, Results
        from .reporting.notebook import InteractiveFigure
        from .reporting.page import page_of
    except ImportError as problem:
        raise ImportError(f"adfric.plot(interactive=True) needs bokeh, matplotlib and h5py: {problem}") from None
    if data is not None:
        raise InputError("data: not with interactive=True")
    if isinstance(y, (list, tuple)):
        if len(y) != 1:
            raise InputError(f"y: given {len(y)} names, allowed with interactive=True: one")
        y = y[0]
    output = None if output is None else Path(name_of(output, "output"))
    if output is not None and output.suffix.lower() not in (".html", ".htm"):
        raise InputError(f"{output}: an interactive figure is one of .html, .htm")
    try:
        figure = InteractiveFigure(page_of([read(one, Results) for one in several_of(results)], x, y, has_words=False))
        if output is not None:
            write_files({output: figure.html.encode()}, True)
    except BadFile as problem:
        raise InputError(str(problem)) from None
    except FileFailure as problem:
        raise FailedError(str(problem)) from None
    return figure


def several_of(results):
    """Results as a list, which is not empty."""
    several = results if isinstance(results, (list, tuple)) else [results]
    if not several:
        raise InputError("results: given an empty list, allowed: at least one dataset or results file")
    return several


def read(results, kind):
    """The results of a dataset, or of a file."""
    if isinstance(results, xr.Dataset):
        return results_of(results, kind)
    path = results
    if not isinstance(path, (str, bytes)) and not hasattr(path, "__fspath__"):
        raise InputError(f"results: given {type(path).__name__}, allowed: a dataset or the path of a results file")
    return kind(Path(name_of(path, "results")))


def results_of(dataset, kind):
    """The results of a dataset, as the figures want them: from an image of its file."""
    image = io.BytesIO()
    dataset.to_netcdf(image, engine="h5netcdf")
    image.seek(0)
    return kind(Path("results"), image)
