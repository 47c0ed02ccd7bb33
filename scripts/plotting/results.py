# SPDX-License-Identifier: GPL-3.0-or-later
"""A results file, read into arrays that know their axes and units."""

import copy
import os
from dataclasses import dataclass

import h5py
import numpy as np

SOLVED, NOT_CONVERGED = 0, 2
# names of results in files of earlier versions
RENAMED = {"area_fraction": "contact_fraction", "area_fraction_error": "contact_fraction_error"}
# how the meaning of a standard error begins
ERROR_OF = "standard error of "
# why a point is empty, by its status
REASONS = {-1: "not reached", 1: "no equilibrium", 2: "not converged"}


class BadFile(Exception):
    """A file that cannot be drawn; the text names the file and the reason."""


class LostScale(Exception):
    """A dataset is attached to a scale that is not in the file any more."""


class NothingToDraw(BadFile):
    """A results file without a figure."""


@dataclass
class Field:
    """A dataset with its unit."""

    name: str
    unit: str
    values: np.ndarray


class Results:
    """What a results file holds.

    source    what is read: the file, or its image in memory
    axes      swept variables, the slowest first
    fields    results by name, of the shape of the sweep
    states    the same for enumerated results, as words; None where there is no value
    constants what has one value in the whole run, by name
    companions    variables that change in step along an axis, by name, with the name of the axis
    beside    names of results that say how others change or how uncertain they are
    errors    name of the standard error of a result, by its name
    words     the same for what is a word
    profile_axes, profiles    the same for values on the surface; their shape is that of the sweep, then of the axes
    """

    def __init__(self, path, image=None):
        """Read a file; or its image in memory, which messages call by the path."""
        self.path = path
        self.source = path if image is None else image
        if image is None and not path.is_file():
            raise BadFile(f"{path}: no such file")
        try:
            with h5py.File(image or path, "r") as file:
                self._read(file)
        except LostScale:
            raise BadFile(f"{path}: not a results file of adfric: its axes are missing") from None
        except OSError as problem:
            if "unable to lock file" in str(problem):
                raise BadFile(f"{path}: a run is writing this file") from None
            if not os.access(path, os.R_OK):
                raise BadFile(f"{path}: no permission to read it") from None
            raise BadFile(f"{path}: not an HDF5 file, or a damaged one") from None

    def _read(self, file):
        if not {"model", "adfric_version"} <= set(file.attrs) or "status" not in file:
            raise BadFile(f"{self.path}: not a results file of adfric")
        self.model = _text(file.attrs["model"])
        self.title = _text(file.attrs.get("title", ""))
        self.status = file["status"][()]
        names = _scales(file["status"])
        if not set(names) <= set(file):
            raise BadFile(f"{self.path}: not a results file of adfric: its axes are missing")
        self.axes = [_field(file, name) for name in names]
        self.fields = {}
        self.states = {}
        self.beside, self.errors = set(), {}
        named = [name for name in _text(file["status"].attrs.get("coordinates", "")).split() if name in file]
        self.constants = {name: _field(file, name) for name in named if file[name].ndim == 0}
        self.companions = {name: (_field(file, name), _scales(file[name])[0]) for name in named if file[name].ndim == 1}
        self.words = {name: _words(file[name])[()] for name in self.constants if "flag_meanings" in file[name].attrs}
        self.profiles = {}
        self.profile_axes = []
        for name, dataset in file.items():
            # groups hold what the program needs to go on with a run
            if not isinstance(dataset, h5py.Dataset):
                continue
            if dataset.attrs.get("CLASS") == b"DIMENSION_SCALE" or dataset.dtype.kind not in "fi" or name in named:
                continue
            scales = _scales(dataset)
            if dataset.dtype.kind == "i":
                if scales == names and name != "status" and "flag_meanings" in dataset.attrs:
                    self.states[name] = _words(dataset)
                continue
            if scales == names:
                self.fields[name] = _field(file, name)
                self._note_beside(name, _text(dataset.attrs.get("long_name", "")))
            elif scales[: len(names)] == names:
                self.profiles[name] = _field(file, name)
                self.profile_axes = [_field(file, axis) for axis in scales[len(names):]]
        self._note_spreads()
        self._take_old_names()

    def _note_spreads(self):
        """Take note of the spreads between the surfaces of an ensemble, and of the errors of its means."""
        for name in self.fields:
            if name.endswith("_spread") and name.removesuffix("_spread") in self.fields:
                self.errors.setdefault(name.removesuffix("_spread"), name)
                self.beside |= {name, name.removesuffix("_spread") + "_error_of_mean"}

    def _note_beside(self, name, meaning):
        """Take note of a result that is said beside another one, by what it means."""
        if meaning.startswith(ERROR_OF):
            self.errors[meaning.removeprefix(ERROR_OF)] = name
        if meaning.startswith((ERROR_OF, "derivative of ")) or meaning.endswith("of the samples") or name == "sampled_fraction":
            self.beside.add(name)

    def _take_old_names(self):
        """Give results of earlier versions their names of today."""
        for old, new in RENAMED.items():
            if old in self.fields and new not in self.fields:
                self.fields[new] = Field(new, self.fields[old].unit, self.fields.pop(old).values)
        if self.model == "sphere" and "contact_area" in self.fields and "friction_area" not in self.fields:
            # it was pi b^2
            area = self.fields.pop("contact_area")
            self.fields["friction_area"] = Field("friction_area", area.unit, area.values)

    @property
    def axis_names(self):
        return [axis.name for axis in self.axes]

    @property
    def several(self):
        """The swept variables with several values, the slowest first."""
        return [axis for axis in self.axes if axis.values.size > 1]

    def values(self, name):
        """A result, or a swept variable in the shape of the sweep."""
        if name in self.fields:
            return self.fields[name].values
        along = self.axis_names.index(name)
        shape = [-1 if k == along else 1 for k in range(self.status.ndim)]
        return np.broadcast_to(self.axes[along].values.reshape(shape), self.status.shape)

    def at(self, name, place):
        """What belongs to one value of a swept variable: the same results without this axis; no profiles."""
        along = self.axis_names.index(name)
        part = copy.copy(self)
        part.axes = [axis for axis in self.axes if axis.name != name]
        part.companions = {key: (field, axis) for key, (field, axis) in self.companions.items() if axis != name}
        part.status = np.take(self.status, place, axis=along)
        part.fields = {key: Field(key, field.unit, np.take(field.values, place, axis=along))
                       for key, field in self.fields.items()}
        part.states = {key: np.take(words, place, axis=along) for key, words in self.states.items()}
        part.profiles, part.profile_axes = {}, []
        return part

    def describe(self, index):
        """The swept values of a point, as pairs of axis and value."""
        return [(axis, axis.values[i]) for axis, i in zip(self.axes, index)]


def _field(file, name):
    unit = _text(file[name].attrs.get("units", "1"))
    return Field(name, "-" if unit == "1" else unit, file[name][()])


def _words(dataset):
    """The words of an enumerated result; None without a value."""
    words = np.full(dataset.shape, None, dtype=object)
    for number, word in zip(dataset.attrs["flag_values"], _text(dataset.attrs["flag_meanings"]).split()):
        words[dataset[()] == number] = word if number >= 0 else None
    return words


def _scales(dataset):
    """Names of the axes of a dataset."""
    return [_scale_of(dimension, k) for k, dimension in enumerate(dataset.dims)]


def _scale_of(dimension, k):
    """Name of the scale of a dimension. One that was deleted leaves a reference to nothing, or an object without a name."""
    try:
        name = dimension[0].name if len(dimension) else f"dimension {k}"
    except (KeyError, OSError, RuntimeError, ValueError):
        raise LostScale from None
    if name is None:
        raise LostScale
    return name.rsplit("/", 1)[-1]


def _text(value):
    return value.decode() if isinstance(value, bytes) else str(value)
