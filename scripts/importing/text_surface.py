# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces in tables: two columns are a line (x, z), three a map (x, y, z), more a map of heights, one a line of heights."""

import re

import numpy as np

from .letters import read_lines
from .problems import BadInput
from .source import Source, masked
from .tables import MOST_HEAD_LINES, read_table
from .units import exponent_of, number_with_unit

# positions are on a grid where they miss it by less than this part of its step
OFF_GRID = 0.05
# gaps between positions that are smaller than this part of the largest are noise of one and the same position
NOISE = 0.1
# heads of a first column that numbers the rows
NUMBERS = {"index", "no", "no.", "nr", "nr.", "number", "point", "row"}
# headers that Gwyddion writes above positions
LATERAL = re.compile(r"Lateral units:\s*(\S+)")
VERTICAL = re.compile(r"Value units:\s*(\S+)")
# words for width and height above a map of heights, in the languages of Gwyddion
WIDTH = re.compile(r"(?:width|breite|largeur|ancho|anchura|larghezza|largura|\u0161\u00ed\u0159ka|\u0448\u0438\u0440\u0438\u043d\u0430)\s*:\s*(\S.*)",
                   re.IGNORECASE)
HEIGHT = re.compile(r"(?:height|h\u00f6he|hauteur|alto|altura|altezza|v\u00fd\u0161ka|\u0432\u044b\u0441\u043e\u0442\u0430)\s*:\s*(\S.*)", re.IGNORECASE)


def read_text_surface(path):
    """Read a line or a map."""
    table = read_table(path)
    values, units, read = table.all_values(), units_of(table, path), table.summary()
    size = size_of(table.comments)
    if size:
        return map_of_size(values, size, units[-1], read, path)
    if table.heads and table.heads[0].name.lower() in NUMBERS:
        values, units = values[:, 1:], units[1:]
    columns = values.shape[1]
    if columns == 1:
        return Source(f"text, heights of a line ({read})", masked(values[:, 0]), None, None, units[0])
    if columns > 3:
        return Source(f"text, heights of a map ({read})", masked(values), None, None, None)
    if columns == 2:
        return line_of(values[:, 0], values[:, 1], f"text, x z ({read})", units, path)
    x, y, z = values.T
    if np.ptp(y) == 0:
        return line_of(x, z, f"text, x y z along a line ({read})", [units[0], units[2]], path)
    return map_of(x, y, z, units, read, path)


def states_size(path):
    """Does the head of a text state the size of a map?"""
    return size_of([line.strip().lstrip("#").strip() for line in read_lines(path)[:MOST_HEAD_LINES]]) is not None


def size_of(comments):
    """Width and height that stand above a map of heights, as [(number, unit), ...], as Gwyddion writes them in any language."""
    found = [next((number_with_unit(line[1], "length") for line in map(word.fullmatch, comments) if line), None)
             for word in (WIDTH, HEIGHT)]
    return None if None in found else found


def map_of_size(heights, size, unit, read, path):
    """A map whose head states its size."""
    (width, lateral), (height, other) = size
    if bool(lateral) != bool(other) or lateral and exponent_of(lateral, "length") != exponent_of(other, "length"):
        raise BadInput(f"{path}: the head states a width in '{lateral}' and a height in '{other}'")
    if not lateral and unit:
        raise BadInput(f"{path}: the file states a size, and no unit of it")
    return Source(f"text, heights of a map whose head states its size ({read})", masked(heights),
                  (width / heights.shape[1], height / heights.shape[0]), lateral or None, unit)


def units_of(table, path):
    """Units of the columns that heads or comments state, None where they do not."""
    units = [table.unit(place) or None for place in range(table.values.shape[1])]
    units = [unit if unit is None or exponent_of(unit, "length") is not None else refuse_unit(unit, path) for unit in units]
    for pattern, places in ((LATERAL, range(len(units) - 1)), (VERTICAL, [len(units) - 1])):
        found = next((pattern.search(line)[1] for line in table.comments if pattern.search(line)), None)
        for place in places if found else ():
            units[place] = found
    return units


def refuse_unit(unit, path):
    """A head with a unit that is none of length."""
    raise BadInput(f"{path}: the head of a column has the unit '{unit}', which is not known for a length")


def lateral_unit(units, path):
    """The unit that all positions have."""
    if len({unit and exponent_of(unit, "length") for unit in units}) > 1:
        raise BadInput(f"{path}: the heads of the positions have different units: {', '.join(str(unit) for unit in units)}")
    return units[0]


def check_positions(path, *positions):
    """Positions may not be missing."""
    if not all(np.isfinite(values).all() for values in positions):
        raise BadInput(f"{path}: a position is missing")


def line_of(x, z, form, units, path):
    """A line, from positions that rise or fall; positions that are not equidistant are interpolated."""
    check_positions(path, x)
    if len(x) > 1 and x[-1] < x[0]:
        x, z = x[::-1], z[::-1]
    if (np.diff(x) == 0).any():
        raise BadInput(f"{path}: a position occurs twice")
    if (np.diff(x) < 0).any():
        raise BadInput(f"{path}: the positions go back and forth along the line: this is no single height at each of them")
    source = Source(form, masked(z), None, units[0], units[-1])
    step = grid_step(x)
    if step is not None:
        places = places_on(x, step)
        heights = np.full(places[-1] + 1, np.nan)
        heights[places] = z
        source.heights = masked(heights)
    else:
        n = len(x)
        if np.isnan(z).any():
            raise BadInput(f"{path}: heights are missing at positions that are not equidistant")
        step = (x[-1] - x[0]) / (n - 1)
        source.heights = masked(np.interp(x[0] + step * np.arange(n), x, z))
        source.remarks.append(f"the positions are not equidistant: heights interpolated linearly at {n} positions that are")
    source.spacing = (step,)
    return source


def map_of(x, y, z, units, read, path):
    """A map, from positions on a grid in any order; samples that are not there are missing."""
    check_positions(path, x, y)
    steps = [grid_step(distinct(values)) for values in (x, y)]
    places = [None if step is None else places_on(values, step) for values, step in zip((x, y), steps)]
    if any(place is None for place in places):
        raise BadInput(f"{path}: the positions are not on a grid along x and y with equal steps")
    nx, ny = (int(place.max()) + 1 for place in places)
    # a scattered cloud would make an empty grid of any size
    if nx * ny > 100 * len(z):
        raise BadInput(f"{path}: {len(z)} samples are too few for the grid of {nx} x {ny} on which they stand")
    flat = places[1] * nx + places[0]
    if len(np.unique(flat)) < len(flat):
        raise BadInput(f"{path}: a position occurs twice")
    heights = np.full(ny * nx, np.nan)
    heights[flat] = z
    return Source(f"text, x y z ({read})", masked(heights.reshape(ny, nx)), tuple(steps), lateral_unit(units[:2], path), units[2])


def distinct(values):
    """The different positions, in order; those that differ by noise count as one, their mean."""
    values = np.sort(values)
    gaps = np.diff(values)
    if not gaps.size or gaps.max() == 0:
        return values[:1]
    return np.array([group.mean() for group in np.split(values, np.flatnonzero(gaps > NOISE * gaps.max()) + 1)])


def grid_step(values):
    """Step of the grid on which ordered positions stand, with gaps or without; None if there is none."""
    if len(values) < 2:
        return None
    span = values[-1] - values[0]
    step = span / max(1, round(span / np.median(np.diff(values))))
    places = (values - values[0]) / step
    is_on_grid = np.abs(places - np.round(places)).max() < OFF_GRID and (np.diff(np.round(places)) > 0).all()
    return step if is_on_grid else None


def places_on(values, step):
    """Numbers of positions on their grid; None if they are not on it."""
    places = (values - values.min()) / step
    near = np.round(places)
    return near.astype(int) if np.abs(places - near).max() < OFF_GRID else None
