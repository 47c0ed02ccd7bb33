# SPDX-License-Identifier: GPL-3.0-or-later
"""A case: a scene or a model whose variables are set by name, and its solution."""

import contextlib
import ctypes
import functools
import hashlib
import os
import signal
import threading
import weakref

import numpy as np

from . import library as _library
from .errors import FailedError, InputError, StoppedError
from .files import name_of
from .fit_text import plain
from .journal import Journal
from .library import library, text_for, text_of
from .results import dataset_of
from .scenes import array_of, split_scene
from .tables import SceneVariables, find_variable, models
from .values import (in_unit, is_logical, is_number, is_whole_number, number_of, numbers_of, single_of, whole_number_of)


def solve(model="", /, *, together=(), threads=0, progress=None, **variables):
    """Solve a scene, or a model by its name, at one point or many.

    Parameters
    ----------
    model : str
        Name of the model; `adfric.models()` has all of them. Empty: a scene, whose groups and sweeps are those of `adfric.scene`.
    together : sequence of str
        Names of variables that are swept together, as a list of points. All other sweeps make the outer product of their values,
        in the order in which they are given: the last one varies fastest.
    threads : int
        Number of threads; 0: as OMP_NUM_THREADS says, or all cores. The results do not depend on it.
    progress : callable
        Is called from time to time with the numbers of the points that are solved and of all points. What it raises ends the call.
    **variables
        Of a scene its groups, each a dictionary, as for `adfric.scene`.
        Variables of the model by name, in SI units: numbers, words, True or False; an array of numbers sweeps a number. Several of
        one group may be given as a dictionary by the name of the group, such as `friction={"shear_strength": 1e6}`, which is
        needed where groups share a name. `lambda_` is lambda. Quantities of pint are converted. None: the default.

    Returns
    -------
    xarray.Dataset
        The results, axes, constants and attributes that the results file of the same case has, value by value. A point without
        a value is NaN, and `status` says why.

    Raises
    ------
    InputError
        Something that was given is wrong.
    FailedError
        There is too little memory.

    Examples
    --------
    >>> results = adfric.solve(surface={"kind": "heights", "heights": heights, "length_x": 1e-5, "length_y": 1e-5},
    ...                        solid={"contact_modulus": 1e9}, operating={"mean_pressure": np.linspace(1e6, 1e7, 10)})
    >>> results.contact_fraction
    >>> results = adfric.solve("sphere", radius=1e-6, contact_modulus=1e9, work_of_adhesion=0.05, adhesion_stress=1e7,
    ...                        load=np.linspace(0, 1e-6, 101))
    """
    if isinstance(model, str) and not model:
        with scene(together=together, **variables) as case:
            return case.solve(threads=threads, progress=progress)
    with Case(model) as case:
        case.set(**variables)
        if together:
            case.sweep_together(together)
        return case.solve(threads=threads, progress=progress)


def scene(*, title=None, sweep=None, together=(), **groups):
    """A case of a scene: a surface on a solid, with an interface, in some operation.

    Parameters
    ----------
    title : str
        Stands in the results.
    sweep : dict
        Arrays of values by the names of the variables that are swept, or by "group%name"; the first one varies slowest.
    together : sequence of str
        Names of variables that are swept together, as a list of points.
    **groups
        The groups of an input, each a dictionary of its variables in SI units: surface, solid, adhesion, friction, operating,
        history, traction, position, numerics, output, job. `adfric help scenes` has all of them. `lambda_` is lambda.
        An array stands in place of a dataset or a list, such as heights; for a number it is a sweep, which varies faster than those
        of `sweep`. A table or a dataset of xarray stands in place of columns, such as a master curve. Quantities of pint are
        converted. None: the default.

    Returns
    -------
    Case
        What it solves, in words, is its `scene`; `solve()` gives the results. Where arrays are given, `check()` and `solve()` say what
        is missing.

    Raises
    ------
    InputError
        Something that was given is wrong, or nothing solves the scene.

    Examples
    --------
    >>> tip = adfric.scene(surface={"kind": "paraboloid", "radius": 140e-9}, solid={"contact_modulus": 44e9},
    ...                    adhesion={"work_of_adhesion": 0.19, "lambda_": 0.8}, friction={"shear_strength": 0.96e9},
    ...                    operating={"state": "sliding"}, sweep={"load": np.linspace(-1e-7, 3e-7, 81)})
    >>> tip.scene
    'paraboloid on an elastic half-space with adhesion and a shear strength, sliding'
    >>> tip.solve().friction_force.plot()
    """
    text, later = split_scene(groups, title, sweep, together)
    if not later:
        return Case.read_text(text)
    case = Case._of_scene((text, tuple(later)))
    for name, value in later.items():
        case._set(name, value, case._table)
    if together:
        case.sweep_together(together)
    return case


def run(path, *, output=None, force=False, threads=0, progress=None):
    """Run an input, as `adfric run` does.

    Parameters
    ----------
    path : path
        The input.
    output : path
        Results file to write, by the command; None: no file.
    force : bool
        May it take the place of a file?
    threads, progress
        As for `solve`; the command shows no progress.

    Returns
    -------
    xarray.Dataset
        The results.
    """
    if output is not None:
        from .command import run_command

        return run_command(path, output, force, threads)
    with Case.read(path) as case:
        return case.solve(threads=threads, progress=progress)


class Case:
    """A scene, or a model by its name, whose variables are set by name, for those who solve it several times. `adfric.scene` opens one
    of a scene.

    >>> with adfric.Case("sphere") as tip:
    ...     tip.set(radius=1e-6, contact_modulus=1e9, work_of_adhesion=0.05, adhesion_stress=1e7)
    ...     results = tip.solve()

    After a call that fails a case is as it was before, but for a dataset that is refused, and for variables that the same call has
    set before. A case is for one thread at a time.
    """

    def __init__(self, model):
        """Open a case of a model; its variables have their defaults, or no value."""
        self._open(library.adfric_open, text_for(model, "model"), ("model", model))

    @classmethod
    def read(cls, path):
        """Open a case as an input describes it, with its sweeps and its datasets."""
        name = name_of(path, "path")
        self = cls._opened(library.adfric_read, os.fsencode(name), ("input", os.path.abspath(name)))
        self._digest = digest_of(name)
        return self

    @classmethod
    def read_text(cls, text):
        """Open a case of the text of an input."""
        return cls._opened(library.adfric_read_text, text_for(text, "text"), ("text", text))

    @classmethod
    def _of_scene(cls, source):
        """Open a case of the text of a scene, some of whose variables come later: text and names."""
        text, later = source
        names = [text_for(name, "name of a variable") for name in later]
        listed = (ctypes.c_char_p*max(len(names), 1))(*names)
        return cls._opened(lambda given, handle: library.adfric_open_scene(given, len(names), listed, handle), text_for(text, "text"),
                           ("scene", source))

    @classmethod
    def _opened(cls, function, argument, origin):
        self = cls.__new__(cls)
        self._open(function, argument, origin)
        return self

    def _open(self, function, argument, origin):
        handle = ctypes.c_int64()
        function(argument, handle)
        self._handle = handle.value
        self._close = weakref.finalize(self, library.adfric_close_case, self._handle)
        self._close.atexit = False
        self._swept = {}
        # units that were stated, by name
        self._units = {}
        # where it is from, and what was set since then
        self._origin = origin
        self._digest = None
        self._journal = Journal()
        # the tables of models have their own names, not those of scenes
        self._table = SceneVariables(self) if self.scene else models()[self.model].variables

    def __reduce__(self):
        """A case is pickled by where it is from and what was set; an input is read once more, and must be the same."""
        self._open_handle()
        kind, source = self._origin
        if kind == "tables":
            raise TypeError("a fit of tables in memory cannot be pickled: call adfric.fit there")
        return restored, (kind, source, self._digest, self._journal.entries())

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self._close.alive:
            self.close()

    def __repr__(self):
        if not self._close.alive:
            return "<adfric case, closed>"
        return f"<adfric case of {self.scene or self.model!r}>"

    def close(self):
        """Close the case; its results stay as they are. A case is closed once."""
        handle = self._open_handle()
        self._close.detach()
        library.adfric_close_case(handle)

    def _open_handle(self):
        """The handle, if the case is open."""
        if not self._close.alive:
            raise InputError("the case is closed")
        return self._handle

    @property
    def model(self):
        """Name of its model."""
        name = ctypes.c_char_p()
        library.adfric_model_of(self._open_handle(), name)
        return text_of(name.value)

    @property
    def scene(self):
        """What is solved, in words, where the case is that of a scene; empty where it is that of a model."""
        words = ctypes.c_char_p()
        library.adfric_scene_of(self._open_handle(), words)
        return text_of(words.value)

    def set(self, **variables):
        """Set variables by name, as `adfric.solve` does: a number ends the sweep of its variable, an array of numbers begins one."""
        table = self._table
        for name, value in variables.items():
            name = plain(name)
            if isinstance(value, dict):
                self._check_group(name)
                for inner, part in value.items():
                    self._set(f"{name}%{plain(inner)}", part, table)
            else:
                self._set(name, value, table)

    def _check_group(self, name):
        """Refuse a group that the model does not have; of a scene the library says it."""
        if isinstance(self._table, SceneVariables):
            return
        groups = {variable.group for variable in self._table.values()}
        if name not in groups:
            raise InputError(f"{name}: no group of model {self.model}, allowed: {', '.join(sorted(groups))}")

    def _set(self, name, value, table):
        """Set a variable."""
        handle, key = self._open_handle(), text_for(name, "name of a variable")
        variable = find_variable(table, name)
        value, unit = in_unit(array_of(value, variable, name), variable.unit if variable else "", name)
        self._take(handle, key, name, single_of(value), unit, variable)

    def _take(self, handle, key, name, value, unit, variable):
        """Set a variable to what its unit has been taken from."""
        if value is None:
            library.adfric_unset(handle, key)
        elif is_logical(value):
            library.adfric_set_logical(handle, key, bool(value))
        elif isinstance(value, str):
            library.adfric_set_word(handle, key, text_for(value, name))
        elif is_whole_number(value) and variable is not None and variable.kind == "whole number":
            library.adfric_set_integer(handle, key, whole_number_of(value, name))
        elif is_number(value):
            library.adfric_set_real(handle, key, number_of(value, name))
        else:
            value = numbers_of(value, name)
            is_dataset = variable is not None and variable.kind == "array"
            if is_dataset:
                # one that is refused is not given any more
                self._journal.note(name, None, None)
            self._set_numbers(handle, key, value, variable)
            # what the caller does to it afterwards is not for this case
            value = value.copy()
        self._units[name] = unit
        self._journal.note(name, value, unit)

    def _set_numbers(self, handle, key, values, variable):
        """Set an array, or sweep a variable that is a number."""
        name = key.decode("utf-8", "replace")
        if variable is not None and variable.kind == "array":
            if not 1 <= values.ndim <= 2:
                raise InputError(f"{name}: given an array of {values.ndim} dimensions, allowed: 1 or 2")
            shape = (ctypes.c_int64*values.ndim)(*values.shape)
            library.adfric_set_array(handle, key, values.ndim, shape, values.ctypes.data)
            return
        if values.ndim != 1:
            raise InputError(f"{name}: given an array of {values.ndim} dimensions, allowed: a number, or one dimension for a sweep")
        if values.size == 0:
            raise InputError(f"{name}: given no value, allowed: at least one")
        library.adfric_sweep(handle, key, values.size, values.ctypes.data)
        self._swept[name] = values

    def sweep_together(self, names):
        """Sweep variables that are swept already together, as a list of points; they have arrays of one length."""
        if isinstance(names, str):
            raise InputError(f"together: given {names!r}, allowed: a list of names")
        # a name may stand without the group by which its array was given
        full = {key.rpartition("%")[2]: key for key in self._swept}
        names = [full.get(name, name) if name not in self._swept else name for name in names]
        missing = [name for name in names if name not in self._swept]
        if missing:
            raise InputError(f"together: no array was given for {', '.join(map(str, missing))}")
        sizes = {self._swept[name].size for name in names}
        if len(sizes) > 1:
            raise InputError("together: " + ", ".join(f"{name} has {self._swept[name].size} values" for name in names)
                             + ", allowed: one length")
        handle, texts = self._open_handle(), [text_for(name, "name of a variable") for name in names]
        values = np.ascontiguousarray([self._swept[name] for name in names])
        library.adfric_sweep_together(handle, len(texts), (ctypes.c_char_p*len(texts))(*texts), values.shape[1], values.ctypes.data)
        self._journal.note_together(names)

    @property
    def n_points(self):
        """Number of its points."""
        n = ctypes.c_int64()
        library.adfric_point_count(self._open_handle(), n)
        return n.value

    def check(self):
        """Check all values together, as `solve` does before it solves."""
        library.adfric_check(self._open_handle())

    def find(self, *names, **variables):
        """Set variables, solve the case, which has one point, and give back results as numbers alone: for loops, where a dataset would
        take longer than the point.

        >>> for load in loads:
        ...     radius, status = tip.find("contact_radius", "status", load=load)

        A result without a value is NaN; of one that is one of several states, as `status` is, the number of the state is given. A single
        name gives its number, several a list of theirs. Ctrl-C is heard when the point is solved.
        """
        if variables:
            self.set(**variables)
        if not names:
            raise InputError("names: given none, allowed: names of results")
        values = (ctypes.c_double*len(names))()
        library.adfric_solve_point(self._open_handle(), len(names), names_for(names), values)
        return values[0] if len(names) == 1 else values[:]

    def solve(self, *, threads=0, progress=None):
        """Solve all points; see `adfric.solve`. Ctrl-C ends it as soon as the points that are being solved are done."""
        if not is_whole_number(threads) or not 0 <= threads < 2**31:
            raise InputError(f"threads: given {threads!r}, allowed: a whole number >= 0")
        results = ctypes.c_int64()
        with listener(progress) as (heard, raised):
            try:
                library.adfric_solve(self._open_handle(), threads, heard, None, results)
            except StoppedError:
                if not raised:
                    raise
            else:
                # the thread that tells may not be the one that solves the last points
                heard(None, self.n_points, self.n_points)
        if raised:
            if results.value:
                library.adfric_close_results(results.value)
            raise raised[0]
        found = dataset_of(results.value)
        for name, unit in self._units.items():
            name = name.rpartition("%")[2]
            # of a unit that depends on the case the results know which it is
            if unit is not None and name in found and unit != found[name].attrs["units"]:
                raise InputError(f"{name}: given in {unit}, allowed: {found[name].attrs['units']}")
        return found


def restored(kind, source, digest, entries):
    """The case that was pickled, in another process."""
    if kind == "input" and digest_of(source) != digest:
        raise InputError(f"{source}: the input has changed since the case was pickled")
    self = {"model": Case, "input": Case.read, "text": Case.read_text, "scene": Case._of_scene}[kind](source)
    for name, value, unit in entries:
        if name is None:
            self.sweep_together(value)
            continue
        variable = find_variable(self._table, name)
        self._take(self._open_handle(), text_for(name, "name of a variable"), name, value, unit, variable)
    return self


def digest_of(path):
    """A checksum of a file."""
    try:
        with open(path, "rb") as file:
            return hashlib.sha256(file.read()).hexdigest()
    except OSError as problem:
        raise FailedError(f"{path}: cannot be read: {problem.strerror}") from None


@functools.lru_cache(maxsize=256)
def names_for(names):
    """Names as the library takes them."""
    return (ctypes.c_char_p*len(names))(*(text_for(name, "name of a result") for name in names))


@contextlib.contextmanager
def listener(progress):
    """A function that the library calls, and a list of what was raised meanwhile, which stops the call.

    Nothing can be raised through the library. What the caller's function raises is kept, and so is what a handler of Ctrl-C does:
    Python calls it between two of its own steps, that is while the library calls back.
    """
    raised = []

    def hear(_, n_done, n_points):
        try:
            if progress is not None and not raised:
                progress(n_done, n_points)
        except BaseException as problem:
            raised.append(problem)
        return bool(raised)

    with deferred_interrupt(raised):
        yield _library.Progress(hear), raised


@contextlib.contextmanager
def deferred_interrupt(raised):
    """Keep what the handler of Ctrl-C raises; only the main thread of Python has one."""
    before = signal.getsignal(signal.SIGINT) if threading.current_thread() is threading.main_thread() else None
    if not callable(before):
        yield
        return

    def handle(number, frame):
        try:
            before(number, frame)
        except BaseException as problem:
            raised.append(problem)

    signal.signal(signal.SIGINT, handle)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)
