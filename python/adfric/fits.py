# SPDX-License-Identifier: GPL-3.0-or-later
"""Fits of a model to measured curves."""

import ctypes
import tempfile
from pathlib import Path

import numpy as np

from . import library as _library
from .cases import Case
from .errors import InputError
from .fit_data import group_of
from .fit_text import block, free_blocks, variable_blocks
from .library import library, text_for

SETTINGS = ("intervals", "levels", "starts", "theories", "derived", "curves", "relative_tolerance", "refits", "seed")


def fit(model, data=None, /, abscissa=None, ordinate=None, *, free=(), data_options=None, events=(), intervals=None, levels=None,
        starts=None, theories=None, derived=None, curves=None, relative_tolerance=None, refits=None, seed=None, title=None, threads=0,
        progress=None, **variables):
    """Fit a model to measured curves, as `adfric fit` does (docs/guide/fit.md).

    Parameters
    ----------
    model : str or path
        Name of the model. Without data: an input of `adfric fit`, to which nothing else belongs but threads and progress.
    data : table, or list of tables
        The measured points: a mapping of names to columns (a dictionary, a dataset of xarray, a frame of pandas), or the path of a
        table, or of 'FILE.h5:/DATASET'. Columns have the names of the abscissa and the ordinate, and if there are any `sigma`,
        `branch` (1 in contact, 0 free) and `segment`. They are in SI units where they state none, as `load [nN]`, by an attribute
        `units`, or as a quantity of pint. An ordinate of several dimensions is a stack of curves, its last dimension that of the points.
        A table with settings of its own is a dictionary of the variables of `&data`, with the table as its `file`.
    abscissa, ordinate : str
        The variable of the model that was varied, and the result that was measured; by default for every table.
    free : list of str, or dict
        What is to be found: names, or names with `start`, `minimum`, `maximum`, `scale`, `prior`, `prior_sigma` in a dictionary.
    data_options : dict
        Other variables of `&data` for every table, such as `sigma`, `relative_sigma`, `abscissa_sigma`, `loss`, `load_offset`.
    events : list of dict
        `&event` groups, such as {"kind": "pull_off_load", "value": -125e-9, "sigma": 1e-9}.
    intervals, levels, starts, theories, derived, curves, relative_tolerance, refits, seed
        Variables of `&fit`.
    threads, progress
        As for `solve`; what is counted are the curves.
    **variables
        Variables of the model that are known, as for `solve`: numbers, words, lists of numbers.

    Returns
    -------
    Fit
        Estimates, errors, intervals, other minima, and all that the results file has.

    Examples
    --------
    >>> found = adfric.fit("sphere", {"load": loads, "friction_force": forces, "sigma": errors}, "load", "friction_force",
    ...                    free=["work_of_adhesion", "shear_strength"], radius=140e-9, contact_modulus=44e9, theory="jkr", state="sliding")
    >>> found.estimates["work_of_adhesion"], found.errors["work_of_adhesion"]
    >>> found.plot()
    """
    given = dict(zip(SETTINGS, (intervals, levels, starts, theories, derived, curves, relative_tolerance, refits, seed)))
    if data is None:
        if abscissa or ordinate or free or data_options or events or title or variables or any(v is not None for v in given.values()):
            raise InputError("data: not given, needed beside what is free: a table, or an input of adfric fit alone")
        with Case.read(model) as case:
            return solved(case, threads, progress)
    several = data if isinstance(data, (list, tuple)) else [data]
    if not several:
        raise InputError("data: given an empty list, allowed: at least one table")
    with tempfile.TemporaryDirectory(prefix="adfric-") as folder:
        defaults = {"abscissa": abscissa, "ordinate": ordinate, **(data_options or {})}
        groups, tables = zip(*(group_of(one, defaults, model, f"data[{k}]" if len(several) > 1 else "data", Path(folder))
                               for k, one in enumerate(several, 1)))
        text = "".join([block("job", {"model": model, "title": title}), *(block("data", group) for group in groups),
                        *(block("event", event) for event in events), *free_blocks(free), block("fit", given),
                        *variable_blocks(model, variables)])
        with opened(text, [table for table in tables if table is not None]) as case:
            return solved(case, threads, progress)


def opened(text, tables):
    """The case of a fit of tables in memory."""
    kept = []
    infos = (_library.Table*max(len(tables), 1))()
    for info, table in zip(infos, tables):
        kept.append(table.values)
        info.name = text_for(table.name, "data")
        info.columns = (ctypes.c_char_p*len(table.columns))(*(text_for(name, "column") for name in table.columns))
        info.units = (ctypes.c_char_p*len(table.units))(*(text_for(unit, "unit") for unit in table.units))
        info.values = table.values.ctypes.data
        info.n_columns, info.n = table.values.shape
    return Case._opened(lambda given, handle: library.adfric_read_fit(given, len(tables), infos, handle), text_for(text, "text"),
                        ("tables", None))


def solved(case, threads, progress):
    """What a fit has found."""
    results = case.solve(threads=threads, progress=progress)
    if "n_minima" not in results:
        raise InputError("data: the input has none, needed for a fit: &data and &free")
    return Fit(results)


class Fit:
    """What a fit has found.

    status      what has become of it: 'fitted', 'too_few_points', 'not_converged' or 'not_identifiable'; of a stack an array of these
    estimates   best values in SI units by the name of the free variable; of a stack arrays, NaN where there is no answer
    errors      their standard errors, NaN for a variable at its bound
    units       their units
    intervals   by name and level the pieces of the set, as pairs of ends; an end is infinite where the set is open. Of one fit alone
    minima      all distinct minima, the best first: values by name, and `excess`, by how much S is above its least value. Of one fit alone
    correlation, covariance   arrays over the variables, None where there is no answer. Of one fit alone
    curve       the best curve and its band, and the second one if there is one, as a list of datasets, one a table. Of one fit alone
    results     all of this and the rest as the results file has it: a dataset of xarray
    """

    def __init__(self, results):
        """What a dataset holds, of `fit` or of a results file of `adfric fit`."""
        if not {"n_minima", "degrees_of_freedom"} <= set(results):
            raise InputError("results: given those of no fit, allowed: results of adfric fit")
        self.results = results
        named = [name.removesuffix("_bound") for name in results if name.endswith("_bound")]
        self._names = [name for name in named if name in results]

    @property
    def is_single(self):
        """Is it one fit, and no stack of curves?"""
        return self.results.status.ndim == 0

    @property
    def status(self):
        states = self.results.status
        words = np.array(states.attrs["flag_meanings"].split(), dtype=object)
        found = words[np.asarray(states.data, dtype=int)]
        return str(found) if self.is_single else states.copy(data=found)

    def _by_name(self, ending):
        """Results by the name of their variable."""
        found = {name: self.results[name + ending] for name in self._names}
        return {name: values.item() for name, values in found.items()} if self.is_single else found

    @property
    def estimates(self):
        return self._by_name("")

    @property
    def errors(self):
        return self._by_name("_error")

    @property
    def units(self):
        return {name: self.results[name].attrs["units"] for name in self._names}

    def _need_single(self, what):
        if not self.is_single:
            raise InputError(f"{what}: of a stack of curves, allowed: of one curve; results has what each curve of a stack has")

    @property
    def intervals(self):
        self._need_single("intervals")
        if "interval" not in self.results:
            return {}
        found = {}
        sets, counts = self.results.interval, self.results.interval_pieces
        for k, name in enumerate(self.results.variable.values):
            found[str(name)] = {}
            for j, level in enumerate(self.results.level.values):
                pieces = sets.values[k, j, :max(int(counts.values[k, j]), 0)]
                found[str(name)][float(level)] = [(-np.inf if np.isnan(low) else float(low), np.inf if np.isnan(high) else float(high))
                                                  for low, high in pieces]
        return found

    @property
    def minima(self):
        self._need_single("minima")
        if "minima" not in self.results:
            return []
        heights = self.results.minima_chi2.values
        names = [str(name) for name in self.results.variable.values]
        return [{**dict(zip(names, row.tolist())), "excess": float(height - heights[0])}
                for row, height in zip(self.results.minima.values, heights)]

    @property
    def covariance(self):
        self._need_single("covariance")
        return self.results.get("covariance")

    @property
    def correlation(self):
        self._need_single("correlation")
        return self.results.get("correlation")

    @property
    def curve(self):
        self._need_single("curve")
        endings = [name.removeprefix("ordinate") for name in self.results if name.startswith("ordinate")]
        return [self.results[[name for name in (f"{one}{ending}" for one in ("curve", "band_low", "band_high", "second_curve"))
                              if name in self.results]] for ending in sorted(endings, key=lambda end: (len(end), end))]

    def plot(self, output=None):
        """Draw the data with the best curve, residuals and a profile; of a stack what each curve has. See `adfric.plot`."""
        from .figures import plot

        return plot(self.results, output=output)

    def __repr__(self):
        if not self.is_single:
            n_fitted = int(np.sum(np.asarray(self.results.status) == 0))
            return f"<adfric fit of {self.results.status.size} curves, {n_fitted} of them fitted: {', '.join(self._names)}>"
        if self.status != "fitted":
            return f"<adfric fit without an answer: {self.status}>"
        units = {name: "" if unit == "1" else f" {unit}" for name, unit in self.units.items()}
        lines = [f"{name} = {self.estimates[name]:.6g} +- {self.errors[name]:.2g}{units[name]}" for name in self._names]
        lines += ["another minimum, S - S_min = {:.3g}: {}".format(
            one["excess"], ", ".join(f"{name} = {one[name]:.4g}" for name in self._names if name in one)) for one in self.minima[1:]]
        return "\n".join(lines)
