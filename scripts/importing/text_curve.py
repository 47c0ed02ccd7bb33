# SPDX-License-Identifier: GPL-3.0-or-later
"""Force curves in tables with heads, such as `height [nm], load [nN]`."""

import re

import numpy as np

from .curve_source import Curve, Source
from .heads import plain
from .problems import BadInput
from .tables import read_table
from .units import exponent_of, number_with_unit, settle, to_si

# what columns may be called
NAMES = {
    "height": {"height", "z", "piezo", "z piezo", "piezo position", "position", "height (measured)", "height (piezo)", "z sensor",
               "zsensor", "zsnsr", "raw", "displacement", "z position", "z displacement", "piezo displacement", "piezo height",
               "measured height", "distance"},
    "tip": {"approach", "indentation", "indentation depth", "tip position", "separation", "tip sample separation", "penetration"},
    "load": {"load", "force", "normal force", "normal load", "f", "p"},
    "deflection": {"deflection", "defl", "vertical deflection", "vdeflection", "cantilever deflection"},
    "time": {"time", "t"}, "segment": {"segment"}, "curve": {"curve", "curve number"}, "x": {"x", "x position"},
    "y": {"y", "y position"},
}
# columns that options name
NAMED = {"height": "height_column", "load": "load_column", "deflection": "deflection_column"}
SPRING = re.compile(r"(?:(?:spring|force)[ _]constant|stiffness)\s*(?:[\[(]([^\])]*)[\])])?\s*[:=,;\t ]\s*(.*)", re.IGNORECASE)
SENSITIVITY = re.compile(r"(?:sensitivity|invols)\s*(?:[\[(]([^\])]*)[\])])?\s*[:=,;\t ]\s*(.*)", re.IGNORECASE)


def read_text_curves(path, given):
    """Force curves of a table."""
    table = read_table(path, needs_names=True)
    places, remarks = find_columns(table, given, path), []
    for what in ("time", "segment"):
        if what in places and not is_readable(table, what, places[what]):
            remarks.append(f"the column {table.heads[places.pop(what)].text} is left out: it has words, or a unit that is not known")
    columns = {what: column_of(table, what, place, given, path) for what, place in places.items()}
    if "deflection" in places and is_voltage(table, places["deflection"], given):
        columns["volts"] = columns.pop("deflection")
    constants = {"spring_constant": stated(table.comments, SPRING, "spring constant"),
                 "sensitivity": stated(table.comments, SENSITIVITY, "sensitivity")}
    if "height" in columns and "tip" in columns:
        # the tip is computed from the base where the spring constant is known, for the base is what the instrument has moved
        is_known = given.spring_constant or constants["spring_constant"] or {"load", "deflection"} <= set(columns)
        columns.pop("tip" if is_known else "height")
        places.pop("tip" if is_known else "height")
    is_tip = "tip" in columns or given.tip
    height = columns.pop("tip" if "tip" in columns else "height")
    if "volts" in columns:
        sensitivity = given.sensitivity or constants["sensitivity"]
        if sensitivity is None:
            raise BadInput(f"{path}: the deflection is in volts and the file does not state the sensitivity: give --sensitivity in m/V")
        columns["deflection"] = columns.pop("volts") * sensitivity
        # that of the option has been used, and nothing is left to change
        constants["sensitivity"] = sensitivity
    taken = [("table", table.summary())] + [(what, table.heads[place].text) for what, place in places.items()]
    source = Source("table of text", taken, [], remarks)
    for name, rows in parts_of(columns, path):
        curve = Curve(name, height[rows], is_tip=is_tip, **constants)
        for what in ("load", "deflection", "time", "segment"):
            if what in columns:
                setattr(curve, what, columns[what][rows])
        if "x" in columns:
            curve.position = (float(columns["x"][rows][0]), float(columns["y"][rows][0]))
        source.curves.append(curve)
    return source


def find_columns(table, given, path):
    """Indices of the columns by what they are."""
    places = {}
    for what, names in NAMES.items():
        wanted = getattr(given, NAMED[what], None) if what in NAMED else None
        if wanted is not None:
            places[what] = table.find(wanted)
            continue
        found = [place for place, head in enumerate(table.heads) if plain(head.name) in names and place not in places.values()]
        if len(found) > 1:
            option = f"; --{NAMED[what].replace('_', '-')} chooses one" if what in NAMED else ""
            raise BadInput(f"{path}: more than one column of the {what}: {', '.join(table.heads[place].text for place in found)}{option}")
        if found:
            places[what] = found[0]
    if given.height_column is not None:
        places.pop("tip", None)
    names = ", ".join(head.text for head in table.heads if head.text)
    if not {"height", "tip"} & set(places):
        raise BadInput(f"{path}: no column of the height among {names}: --height-column names it")
    if not {"load", "deflection"} & set(places):
        raise BadInput(f"{path}: no column of the load or the deflection among {names}: --load-column or --deflection-column names it")
    if ("x" in places) != ("y" in places):
        places.pop("x", None), places.pop("y", None)
    return places


def is_readable(table, what, place):
    """Has a column that could be left out numbers, and a unit that is known?"""
    return place not in table.flaws and not table.heads[place].flaw and (
        what != "time" or not table.heads[place].unit or exponent_of(table.heads[place].unit, "time") is not None)


def column_of(table, what, place, given, path):
    """Numbers of a column in SI units."""
    values, unit = table.column(place), table.unit(place) or None
    if what in ("segment", "curve"):
        return values
    if what == "time":
        return to_si(values, settle(unit, None if unit else "s", "--time-unit", "time", path), "time")
    if what == "deflection" and is_voltage(table, place, given):
        # volts are told by their unit, and become metres by the sensitivity
        return to_si(values, settle(unit, given.deflection_unit, "--deflection-unit", "voltage", path), "voltage")
    kind = "force" if what == "load" else "length"
    option = {"load": "load_unit", "deflection": "deflection_unit"}.get(what, "unit")
    if unit is None and getattr(given, option) is None:
        raise BadInput(f"{path}: the file does not state the unit of the {what}: give --{option.replace('_', '-')}")
    return to_si(values, settle(unit, getattr(given, option), f"--{option.replace('_', '-')}", kind, path), kind)


def is_voltage(table, place, given):
    """Is a deflection in volts?"""
    return exponent_of(table.unit(place) or given.deflection_unit or "m", "voltage") is not None


def stated(comments, pattern, kind):
    """A constant that stands above the table; None where there is none."""
    for line in comments:
        found = pattern.search(line)
        value = found and number_with_unit(f"{found[2].split(chr(9))[0].strip()} {found[1] or ''}".strip(), kind)
        if value and value[1]:
            return float(to_si(value[0], value[1], kind))
    return None


def parts_of(columns, path):
    """Names and rows of the curves in a table: those of a number, or of a position."""
    keys = [columns[what] for what in (("curve",) if "curve" in columns else ("x", "y")) if what in columns]
    if not keys:
        yield path.name, slice(None)
        return
    keys = np.stack(keys, axis=1)
    if np.isnan(keys).any():
        raise BadInput(f"{path}: the number or position of a curve is missing in row {int(np.argwhere(np.isnan(keys))[0][0]) + 1}")
    distinct, first, inverse = np.unique(keys, axis=0, return_index=True, return_inverse=True)
    for count, number in enumerate(np.argsort(first)):
        name = f"{distinct[number][0]:g}" if "curve" in columns else str(count)
        yield f"{path.name} {name}", np.flatnonzero(inverse.ravel() == number)
