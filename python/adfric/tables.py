# SPDX-License-Identifier: GPL-3.0-or-later
"""The models, with their variables and results, as the program knows them."""

import ctypes
import difflib
import functools
import inspect
import keyword
import textwrap
import weakref
from collections.abc import Mapping
from dataclasses import dataclass, field

from . import library as _library
from .library import library, text_for, text_of, words_of

KINDS = {_library.REAL: "number", _library.INTEGER: "whole number", _library.LOGICAL: "True or False", _library.WORD: "word",
         _library.ARRAY: "array"}


@dataclass(frozen=True)
class Variable:
    """A variable of a model.

    name, group       its name, and the namelist group that has it
    unit              SI unit, "1" for a pure number, empty for words
    meaning, allowed  what it is, and what it may be
    default           its value where none is given, as in an input; empty if there is none
    choices           the words that are allowed, if it is one of several
    kind              "number", "whole number", "True or False", "word" or "array"
    largest_rank      most dimensions of an array
    is_list           an array whose numbers may stand in an input
    columns, column_units   names and units of the columns of an array that has such
    """

    name: str
    group: str
    unit: str
    meaning: str
    allowed: str
    default: str
    choices: tuple
    kind: str
    largest_rank: int
    is_list: bool = False
    columns: tuple = ()
    column_units: tuple = ()


@dataclass(frozen=True)
class Result:
    """A result or a profile of a model; units that depend on a case are right in its dataset.

    name, unit, long_name   its name, SI unit and what it is
    flag_meanings           names of the states of a result that is one of several
    """

    name: str
    unit: str
    long_name: str
    flag_meanings: tuple


@dataclass(frozen=True, repr=False)
class Model:
    """A model. Called with variables by name it is solved, as by `adfric.solve`; its docstring names all of them.

    name, summary, references     its name, one line, and where it was published
    variables, results, profiles  what it takes and gives, by name; variables as "group%name" where several groups have the name
    axes                          names of the axes of its profiles, the slowest first
    """

    name: str
    summary: str
    references: str
    variables: Mapping = field(compare=False)
    results: Mapping = field(compare=False)
    profiles: Mapping = field(compare=False)
    axes: tuple = ()

    def __call__(self, **variables):
        """Solve the model: see `adfric.solve`."""
        from .cases import solve

        return solve(self.name, **variables)

    def __repr__(self):
        return f"<adfric model {self.name!r}: {self.summary}>"

    @property
    def __doc__(self):
        return document(self)

    @property
    def __signature__(self):
        names = [f"{name}_" if keyword.iskeyword(name) else name for name in self.variables if name.isidentifier()]
        parameters = [inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=None) for name in names]
        return inspect.Signature([*parameters, inspect.Parameter("others", inspect.Parameter.VAR_KEYWORD)])


class Models(Mapping):
    """All models by name; those that were looked up stay."""

    def __init__(self, names):
        self._names = names

    def __getitem__(self, name):
        if name not in self._names:
            close = difflib.get_close_matches(str(name), self._names, 1)
            raise KeyError(f"{name}; did you mean {close[0]!r}?" if close else name)
        return model_of(name)

    def __iter__(self):
        return iter(self._names)

    def __len__(self):
        return len(self._names)

    def __repr__(self):
        return "\n".join(f"{name:<17} {self[name].summary}" for name in self)


@functools.cache
def models():
    """All models by name: `adfric.models()["sphere"].variables["load"].unit` is "N", and `help(adfric.models()["sphere"])` shows
    what the model takes and gives."""
    n = ctypes.c_int32()
    library.adfric_model_count(n)
    return Models(tuple(text_of(info_of(place).name) for place in range(n.value)))


def info_of(place):
    """What the library says of a model."""
    info = _library.ModelInfo()
    library.adfric_model(place, info)
    return info


@functools.cache
def model_of(name):
    """A model by a name that is there."""
    info = next(info for info in map(info_of, range(len(models()))) if text_of(info.name) == name)
    variables = [variable_of(name, place) for place in range(info.n_variables)]
    names = [variable.name for variable in variables]
    keys = [f"{one.group}%{one.name}" if names.count(one.name) > 1 else one.name for one in variables]
    return Model(name, text_of(info.summary), text_of(info.references), dict(zip(keys, variables)),
                 results_of(library.adfric_result, name, info.n_results), results_of(library.adfric_profile, name, info.n_profiles),
                 words_of(info.profile_axes))


def variable_of(model, place):
    """A variable by its place."""
    info = _library.VariableInfo()
    library.adfric_variable(model.encode(), place, info)
    return variable_from(info)


def variable_from(info):
    """A variable as the library describes it."""
    return Variable(text_of(info.name), text_of(info.group), text_of(info.unit), text_of(info.meaning), text_of(info.allowed),
                    text_of(info.default_text), words_of(info.choices), KINDS[info.kind], info.largest_rank, bool(info.is_list),
                    words_of(info.columns), words_of(info.column_units))


class SceneVariables:
    """The variables of a case that is a scene, by name or "group%name"; each is asked for once."""

    def __init__(self, case):
        self._case = weakref.ref(case)
        self._found = {}

    def get(self, name):
        """A variable; one that the scene does not have is refused."""
        if name not in self._found:
            info = _library.VariableInfo()
            library.adfric_variable_of(self._case()._open_handle(), text_for(name, "name of a variable"), info)
            self._found[name] = variable_from(info)
        return self._found[name]


def find_variable(table, name):
    """A variable of a table by its name, or by "group%name"; None if the table of a model has none such."""
    found = table.get(name)
    if found is None:
        found = next((one for one in table.values() if f"{one.group}%{one.name}" == name), None)
    return found


def results_of(find, model, n):
    """Results or profiles by name."""
    found = {}
    for place in range(n):
        info = _library.ResultInfo()
        find(model.encode(), place, info)
        found[text_of(info.name)] = Result(text_of(info.name), text_of(info.unit), text_of(info.long_name),
                                           words_of(info.flag_meanings))
    return found


def document(model):
    """The docstring of a model."""
    lines = [f"{model.summary[:1].upper()}{model.summary[1:]}.", "", "Parameters", "----------"]
    for key, variable in model.variables.items():
        default = f" Default: {variable.default}." if variable.default else ""
        lines += entry(key, variable.unit or variable.kind, f"{variable.meaning} (&{variable.group}); {variable.allowed}.{default}")
    lines += ["", "Returns", "-------", "xarray.Dataset"]
    for results in (model.results, model.profiles):
        for result in results.values():
            states = f": {', '.join(result.flag_meanings)}" if result.flag_meanings else ""
            lines += ["    " + line for line in entry(result.name, result.unit, f"{result.long_name}{states}.")]
    if model.references:
        lines += ["", "References", "----------", *textwrap.wrap(f"{model.references}.", 100)]
    return "\n".join(lines)


def entry(name, unit, text):
    """A name with its unit, and what it is below it."""
    return [f"{name} : {unit}", *textwrap.wrap(text, 100, initial_indent="    ", subsequent_indent="    ")]
