# SPDX-License-Identifier: GPL-3.0-or-later
"""Fits of a scene, or of a model, to measured curves."""

import ctypes
import functools
import tempfile
from pathlib import Path

import numpy as np

from . import library as _library
from .cases import Case
from .errors import InputError
from .fit_data import group_of, words_of
from .fit_text import block, free_blocks, free_names, variable_blocks
from .library import library, text_for, text_of
from .scenes import split_scene, write_arrays
from .tables import models

SETTINGS = ("intervals", "levels", "starts", "theories", "derived", "curves", "relative_tolerance", "refits", "seed")


def fit(*given, abscissa=None, ordinate=None, free=(), data_options=None, events=(), intervals=None, levels=None, starts=None,
        theories=None, derived=None, curves=None, relative_tolerance=None, refits=None, seed=None, title=None, threads=0, progress=None,
        **variables):
    """Fit a scene, or a model, to measured curves, as `adfric fit` does (docs/guide/fit.md).

    `fit(data, abscissa, ordinate, surface={...}, ...)` fits a scene, `fit(model, data, abscissa, ordinate, ...)` a model by its name, and
    `fit(path)` an input of `adfric fit`, to which nothing else belongs but threads and progress.

    Parameters
    ----------
    model : str
        Name of the model.
    data : table, or list of tables
        The measured points: a mapping of names to columns (a dictionary, a dataset of xarray, a frame of pandas), or the path of a
        table, or of 'FILE.h5:/DATASET'. Columns have the names of the abscissa and the ordinate, and if there are any `sigma`,
        `branch` (1 in contact, 0 free) and `segment`. They are in SI units where they state none, as `load [nN]`, by an attribute
        `units`, or as a quantity of pint. An ordinate of several dimensions is a stack of curves, its last dimension that of the points.
        A table with settings of its own is a dictionary of the variables of `&data`, with the table as its `file`.
    abscissa, ordinate : str
        The variable that was varied, and the result that was measured; by default for every table.
    free : list of str, or dict
        What is to be found: names, or names with `start`, `minimum`, `maximum`, `scale`, `prior`, `prior_sigma` in a dictionary.
    data_options : dict
        Other variables of `&data` for every table, such as `sigma`, `relative_sigma`, `abscissa_sigma`, `loss`, `load_offset`, or
        `variables`: names of further variables that have a column, and so a value for each point.
    events : list of dict
        `&event` groups, such as {"kind": "pull_off_load", "value": -125e-9, "sigma": 1e-9}.
    intervals, levels, starts, theories, derived, curves, relative_tolerance, refits, seed
        Variables of `&fit`.
    threads, progress
        As for `solve`; what is counted are the curves.
    **variables
        What is known: the groups of a scene, as for `adfric.scene`, or variables of the model, as for `solve`: numbers, words, lists of
        numbers.

    Returns
    -------
    Fit
        Estimates, errors, intervals, other minima, and all that the results file has.

    Examples
    --------
    >>> found = adfric.fit({"load": loads, "friction_force": forces, "sigma": errors}, "load", "friction_force",
    ...                    free=["work_of_adhesion", "shear_strength"], surface={"kind": "paraboloid", "radius": 140e-9},
    ...                    solid={"contact_modulus": 44e9}, adhesion={"theory": "jkr"}, operating={"state": "sliding"})
    >>> found.estimates["work_of_adhesion"], found.errors["work_of_adhesion"]
    >>> found.plot()
    """
    settings = dict(zip(SETTINGS, (intervals, levels, starts, theories, derived, curves, relative_tolerance, refits, seed)))
    is_scene = describes_scene(given, variables)
    model, data, abscissa, ordinate = arranged(given, is_scene, abscissa, ordinate)
    if data is None:
        if (abscissa or ordinate or free or data_options or events or title or variables or any(v is not None for v in settings.values())
                or model is None):
            raise InputError("data: not given, needed beside what is free: a table, or an input of adfric fit alone")
        with Case.read(model) as case:
            return solved(case, threads, progress)
    several = data if isinstance(data, (list, tuple)) else [data]
    if not several:
        raise InputError("data: given an empty list, allowed: at least one table")
    with tempfile.TemporaryDirectory(prefix="adfric-") as folder:
        folder = Path(folder)
        defaults = {"abscissa": abscissa, "ordinate": ordinate, **(data_options or {})}
        known = SceneOfFit(variables, free, defaults) if is_scene else model
        groups, tables = zip(*(group_of(one, defaults, known, f"data[{k}]" if len(several) > 1 else "data", folder)
                               for k, one in enumerate(several, 1)))
        blocks = known.blocks(title, folder) if is_scene else (block("job", {"model": model, "title": title}), *variable_blocks(model, variables))
        text = "".join([*blocks, *(block("data", group) for group in groups), *(block("event", event) for event in events),
                        *free_blocks(free), block("fit", settings)])
        with opened(text, [table for table in tables if table is not None]) as case:
            return solved(case, threads, progress)


def describes_scene(given, variables):
    """Are there groups of a scene, and no model by its name?"""
    is_model = bool(given) and isinstance(given[0], str) and given[0] in models()
    return not is_model and any(isinstance(variables.get(group), dict) for group in ("surface", "traction"))


def arranged(given, is_scene, abscissa, ordinate):
    """Model, data, abscissa and ordinate of what is given in this order; a scene has no model, an input no data."""
    names = ("data", "abscissa", "ordinate") if is_scene else ("model", "data", "abscissa", "ordinate")
    if len(given) > len(names):
        raise InputError(f"given {len(given)} arguments without a name, allowed: {', '.join(names)}")
    found = dict(zip(names, given))
    for name, value in (("abscissa", abscissa), ("ordinate", ordinate)):
        if value is not None and name in found:
            raise InputError(f"{name}: given twice, allowed: once")
        found.setdefault(name, value)
        if found[name] is not None and not isinstance(found[name], str):
            raise InputError(f"{name}: given {type(found[name]).__name__}, allowed: a name; data stand before it, behind a model if one is named")
    return found.get("model"), found.get("data"), found["abscissa"], found["ordinate"]


class SceneOfFit:
    """The scene of a fit: its groups as a text, and the units of its variables and results."""

    def __init__(self, groups, free, options):
        self._groups = groups
        names = [*free_names(free), *(options[name] for name in ("abscissa",) if options.get(name)), *words_of(options.get("variables") or ())]
        # a list stands for its members; the time of a history is a variable of fits alone
        self._names = [name.split("(")[0] for name in names if name != "time"]

    @functools.cached_property
    def _case(self):
        """A case of the scene; what is free or varied counts as given."""
        text, later = split_scene(self._groups)
        return Case._of_scene((text, (*later, *self._names)))

    def unit(self, name):
        """The unit of a variable or a result."""
        info = _library.ResultInfo()
        library.adfric_describe(self._case._open_handle(), text_for(name, "name"), info)
        return text_of(info.unit)

    def get(self, name):
        """A variable."""
        return self._case._table.get(name)

    def blocks(self, title, folder):
        """The groups as an input has them; arrays that no input has are written into a folder."""
        groups = write_arrays(self._groups, self, folder)
        job = self._groups.get("job", {})
        yield block("job", {"title": title, **job} if isinstance(job, dict) else job)
        for group, values in self._groups.items():
            if group != "job":
                yield block(group, groups.get(group, values))


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
