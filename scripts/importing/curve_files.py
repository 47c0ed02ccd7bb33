# SPDX-License-Identifier: GPL-3.0-or-later
"""Force curves in files of instruments, as afmformats reads them.

Where its readers take any text for theirs, they are not believed: a table of numbers is one of NT-MDT's Nova only if the user says so.
"""

import warnings
import zipfile
from importlib.metadata import version

import numpy as np

from .curve_source import Curve, Source
from .problems import BadInput, first_line

# formats by the words of --format, with their endings
FORMATS = {"nt-mdt": ".txt"}
# endings of tables of text, which other programs write as well
TABLES = (".txt", ".csv", ".tsv", ".tab", ".dat", ".asc")
HEIGHTS = {"measured": "height (measured)", "piezo": "height (piezo)"}


def find_recipe(path, wanted):
    """The reader of afmformats for a file; None where it is a table, which `text_curve` reads."""
    suffix = path.suffix.lower()
    try:
        # imported here, since it takes a second that a bad option need not cost
        from afmformats.formats import formats_by_suffix
    except ImportError:
        if suffix in TABLES and not wanted:
            return None
        raise BadInput(f"{path}: files of instruments need the package afmformats") from None
    recipes = [recipe for recipe in formats_by_suffix.get(suffix, []) if ("NT-MDT" in recipe.maker) == (wanted == "nt-mdt")]
    if wanted and not recipes:
        raise BadInput(f"{path}: files of the format {wanted} end with {FORMATS[wanted]}")
    for recipe in recipes:
        try:
            if "detect" not in recipe.recipe or recipe.recipe["detect"](path):
                if suffix == ".csv" and "Force-Distance Curve" not in path.open(encoding="latin-1").read(200):
                    continue
                return recipe
        except (Exception, *problems_of_afmformats()):
            continue
    if suffix in formats_by_suffix and suffix not in TABLES:
        raise BadInput(f"{path}: no file of {', '.join(sorted({recipe.maker for recipe in formats_by_suffix[suffix]}))} "
                       "that afmformats can read")
    return None


def problems_of_afmformats():
    """What afmformats raises; these are no usual exceptions."""
    from afmformats import errors

    return errors.AFMFileFormatError, errors.MissingMetaDataError, AssertionError


def read_instrument_curves(path, recipe, given):
    """Force curves of a file."""
    from afmformats.meta import MetaData

    datasets = load(path, recipe, given)
    heights = {}
    source = Source(f"{recipe.maker}, {recipe.descr}", [], [], software=f"afmformats {version('afmformats')}")
    for number, dataset in enumerate(datasets):
        says = MetaData(dataset["metadata"])
        curve = Curve(f"{path.name} {says.get('enum', number)}" if len(datasets) > 1 else path.name)
        source.curves.append(curve)
        say(curve, says)
        try:
            column = fill(curve, dataset["data"], given.height)
            heights[column] = heights.get(column, 0) + 1
        except (Exception, *problems_of_afmformats()) as problem:
            curve.problem = f"cannot be read: {first_line(problem)}"
    if not source.curves:
        raise BadInput(f"{path}: there is no force curve in it")
    if not heights:
        raise BadInput(f"{path}: no curve can be read: {source.curves[0].problem}")
    source.taken += [("height", ", ".join(f"{column}, of {count} curve{'s' * (count > 1)}" for column, count in heights.items()))]
    return source


def load(path, recipe, given):
    """Data and metadata of all curves; a calibration that is missing is taken from the options."""
    override = {}
    from afmformats.errors import MissingMetaDataError

    while True:
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                return recipe.loader(path, meta_override=override or None)
        except MissingMetaDataError as problem:
            missing = [key for key in problem.meta_keys if key not in override]
            options = {key: getattr(given, key.replace(" ", "_")) for key in missing}
            if not missing or None in options.values():
                asked = " and ".join(f"--{key.replace(' ', '-')}" for key, value in options.items() if value is None)
                raise BadInput(f"{path}: the file does not state the {' and the '.join(missing)}: give {asked}") from None
            override.update(options)
        except (Exception, *problems_of_afmformats()) as problem:
            if isinstance(problem, zipfile.BadZipFile | OSError):
                raise BadInput(f"{path}: cannot read: {first_line(problem)}") from None
            raise BadInput(f"{path}: afmformats cannot read it: {first_line(problem)}") from None


def say(curve, says):
    """What a file says of a curve."""
    for name in ("spring constant", "sensitivity"):
        value = says.get(name)
        if value is not None and np.isfinite(value) and value > 0:
            setattr(curve, name.replace(" ", "_"), float(value))
    for name, key in (("index", "grid index"), ("shape", "grid shape"), ("position", "position")):
        values = tuple(says.get(f"{key} {axis}") for axis in "xy")
        if None not in values and np.isfinite(values).all():
            setattr(curve, name, tuple(float(value) if name == "position" else int(round(value)) for value in values))


def fill(curve, data, wanted):
    """Numbers of a curve; the name of the column that is its height."""
    there = [name for name in HEIGHTS.values() if name in data]
    if "force" not in data:
        raise BadInput("there is no load")
    curve.load = np.asarray(data["force"], float)
    for name in ("time", "segment"):
        if name in data:
            setattr(curve, name, np.asarray(data[name], float))
    if "tip position" in data:
        # a file may call the height of the tip measured: that of the base is the one that differs from the tip by the deflection
        there.sort(key=lambda name: off_by(data, name, curve))
        if not there:
            curve.height, curve.is_tip = np.asarray(data["tip position"], float), True
            return "tip position"
    if wanted:
        there = [name for name in there if name == HEIGHTS[wanted]]
    failure = BadInput(f"there is no {HEIGHTS[wanted] if wanted else 'height'}")
    for name in there:
        try:
            curve.height = np.asarray(data[name], float)
            return name
        except (Exception, *problems_of_afmformats()) as problem:
            # some readers promise a column that the file does not have
            failure = problem
    raise failure


def off_by(data, name, curve):
    """How far a height differs from the position of the tip by more than the deflection, of either sign [m]."""
    if not curve.spring_constant:
        return 0.0
    deflection = curve.load / curve.spring_constant
    difference = np.asarray(data[name], float) - np.asarray(data["tip position"], float)
    return min(np.nanstd(difference - sign * deflection) for sign in (-1, 1))
