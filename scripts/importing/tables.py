# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of numbers in text files, by the rules of docs/reference/tables.md: what could be read in two ways is refused."""

import re
from dataclasses import dataclass, field

import numpy as np

from .cells import PARTED, blank_heads, numbers_in, refuse_mark, settle_mark, split, split_names, value_of
from .heads import add_unit, is_unit_like, plain, split_head
from .letters import UTF16, read_lines
from .problems import BadTable

# what separates, in the order in which it is tried, and what it is called; the last one is blanks
SEPARATORS = {"\t": "tab", ";": "semicolon", ",": "comma", " ": "blanks"}
# a cell with nothing but the sign makes no comment: a percent sign is a unit, and # the name of a column
COMMENT = re.compile(r"\s*[#%](?! *[;,\t])")
# lines without numbers that may stand before a table without names
MOST_HEAD_LINES = 200


@dataclass
class Table:
    """Columns of numbers, and how they were read."""

    path: object
    # shape (rows, columns), not a number where there is none
    values: np.ndarray
    # a `Head` of each column; empty where the table has no names
    heads: list
    # why a column has a cell that is no number, by its index: (reason, text)
    flaws: dict
    # comments, and what stands above the rows, names included
    comments: list
    # tab, semicolon, comma, blanks or none
    separator: str
    # point or comma
    decimal: str
    # lines, from 1, with the names and the units; None where there are none
    names_line: int | None = None
    units_line: int | None = None

    def find(self, wanted):
        """Index of the column that is asked for, by its name or by its whole head."""
        place = self.place_of(wanted)
        if place is None:
            names = ", ".join(head.text for head in self.heads if head.text)
            raise BadTable("column", f"{self.path}: there is no column '{wanted}', there are {names or 'no names'}")
        return place

    def place_of(self, wanted):
        """The same, or None where there is no such column."""
        for fits in (lambda head: wanted in (head.name, head.text), lambda head: plain(wanted) in (plain(head.name), plain(head.text))):
            found = [place for place, head in enumerate(self.heads) if head.text and fits(head)]
            if len(found) > 1:
                raise BadTable("column", f"{self.path}: more than one column is '{wanted}': "
                               f"{', '.join(self.heads[place].text for place in found)}")
            if found:
                return found[0]
        return None

    def unit(self, place):
        """The unit that a column states, empty where it states none; a head that is not understood is refused."""
        if not self.heads:
            return ""
        if self.heads[place].flaw:
            raise BadTable("unit", f"{self.path}: the head of a column: {self.heads[place].flaw}")
        return self.heads[place].unit

    def column(self, place):
        """The numbers of a column."""
        if place in self.flaws:
            raise BadTable(*self.flaws[place])
        return self.values[:, place]

    def all_values(self):
        """All numbers; a cell that is none is refused."""
        for place in range(self.values.shape[1]):
            self.column(place)
        return self.values

    def summary(self):
        """How the table was read, in words."""
        marks = {"none": "one column", "blanks": "columns between blanks"}
        words = [marks.get(self.separator, f"columns between {self.separator}s"), f"decimal {self.decimal}"]
        words += [f"{what} in line {line}" for what, line in (("names", self.names_line), ("units", self.units_line)) if line]
        return ", ".join(words)


@dataclass
class Layout:
    """Which lines of a table are what."""

    separator: str
    # lines (number, text) with the numbers
    rows: list
    # heads of the columns, as texts, and the units of the line of units
    names: list = field(default_factory=list)
    units: list = field(default_factory=list)
    names_line: int | None = None
    units_line: int | None = None


def read_table(path, needs_names=False):
    """Read a table of numbers whose rows have the same number of columns."""
    lines = [(number, line) for number, line in enumerate(read_lines(path), 1) if line.strip()]
    comments = [(number, line.strip().lstrip("#%").strip()) for number, line in lines if COMMENT.match(line)]
    body = [(number, line) for number, line in lines if not COMMENT.match(line)]
    layout = find_layout(body, comments, path, needs_names)
    mark = settle_mark(layout.rows, layout.separator, path)
    values, flaws = numbers_in(layout.rows, layout.separator, mark, len(layout.names), path)
    heads = [split_head(name) for name in layout.names]
    heads = [add_unit(head, unit) for head, unit in zip(heads, layout.units)] if layout.units else heads
    first = layout.rows[0][0]
    above = [text for _, text in sorted([(number, text.strip()) for number, text in body if number < first] + comments)]
    separator = SEPARATORS[layout.separator] if values.shape[1] > 1 or layout.separator == "," else "none"
    return Table(path, values, heads, flaws, above, separator, "comma" if mark == "," else "point",
                 layout.names_line, layout.units_line)


def count_columns(path):
    """Number of columns in the first row of numbers; 0 where there is no text with numbers."""
    with path.open("rb") as file:
        head = file.read(1 << 16)
    text = head.decode("utf-16", "ignore") if head.startswith(UTF16) else head.decode("latin-1")
    if "\0" in text:
        return 0
    lines = (line for line in re.split(r"\r\n|\r|\n", text) if not COMMENT.match(line))
    found = next((candidates for candidates in map(fitting, lines) if candidates), [])
    return max((count for _, count in found), default=0)


def find_layout(body, comments, path, needs_names):
    """What separates the columns, and which lines are names, units and rows."""
    first = next((i for i, (_, line) in enumerate(body) if fitting(line)), None)
    if first is None:
        return layout_of_texts(body, comments, path)
    candidates = fitting(body[first][1])
    for separator, count in candidates:
        for above, is_comment in ((body[:first], False), ([item for item in comments if item[0] < body[first][0]], True)):
            layout = with_names(above[-MOST_HEAD_LINES:], separator, split(body[first][1], separator), is_comment)
            if layout:
                start = body.index((layout.last_line, dict(body)[layout.last_line])) + 1 if not is_comment else first
                layout.rows = body[start:]
                if not is_comment:
                    take_units_below(layout, body, comments)
                return layout
    if needs_names or first > MOST_HEAD_LINES:
        raise_without_names(body, first, candidates, path)
    separator = next((separator for separator, count in candidates if count > 1), candidates[0][0])
    return Layout(separator, body[first:])


def fitting(line):
    """Separators by which a line has numbers alone, each with the number of cells."""
    found = []
    for separator in SEPARATORS:
        cells = split(line, separator)
        if cells is None:
            continue
        values = [value_of(cell, separator) for cell in cells]
        if all(value is not None for value in values) and not all(np.isnan(value) for value in values):
            found.append((separator, len(cells)))
    return found


def with_names(above, separator, row, is_comment):
    """The layout with the names in the nearest of the lines above that has a name for each column; None if there is none."""
    units = units_line = None
    spare = None
    for number, line in reversed(above[-2:] if is_comment else above):
        for names in name_cells(line, separator, row, is_comment):
            if are_units(names) and units is None:
                units, units_line = [name.strip("[]() ") for name in names], number
                spare = (names, number)
                break
            return make_layout(separator, names, number, units, units_line)
    # what looks like units alone are the names, such as N
    return make_layout(separator, *spare, None, None) if spare else None


def are_units(cells):
    """Are all cells units, in brackets or not, known or not?"""
    return all(is_unit_like(cell.strip("[]() ")) for cell in cells if cell)


def take_units_below(layout, body, comments):
    """Take the units of the line directly below the names, if it has nothing else; it may be a comment."""
    number, text = min((line for line in body + comments if line[0] > layout.names_line), default=(0, ""))
    if layout.units_line or not text:
        return
    is_row = (number, text) in body
    # the sign of a comment may be a unit
    for line in [text] if is_row else [text, f"% {text}"]:
        for units in name_cells(line, layout.separator, ["1"] * len(layout.names), False):
            if len(units) == len(layout.names) and are_units(units) and any(unit.strip("-1[]() ") for unit in units):
                layout.units, layout.units_line = [unit.strip("[]() ") for unit in units], number
                layout.rows = layout.rows[is_row:]
                return


def make_layout(separator, names, number, units, units_line):
    """A layout with names; the last of its lines is where the rows begin."""
    units = None if units is None else [*units, *[""] * (len(names) - len(units))]
    layout = Layout(separator, [], names, units or [], number, units_line)
    layout.last_line = max(number, units_line or 0)
    return layout


def name_cells(line, separator, row, is_comment):
    """The names in a line, one for each of so many columns, in each of the ways in which it has so many."""
    # names in a comment may be separated otherwise than numbers by blanks
    ways = (separator, ";", ",", "\t") if is_comment and separator == " " else (separator,)
    for way in ways:
        for names in (blank_heads(line) if way == " " else [split_names(line, way)]):
            if names is None or any(is_number(name, way) for name in names):
                continue
            while len(names) > 1 and not names[-1]:
                names = names[:-1]
            # empty cells behind the last name do not count
            if any(names) and len(names) <= len(row) and not any(row[len(names):]):
                yield names


def is_number(cell, separator):
    """Is a cell a number, and not one without a value?"""
    value = value_of(cell, separator)
    return value is not None and not np.isnan(value)


def layout_of_texts(body, comments, path):
    """The layout where every row has a text: the first line has the names."""
    if not body:
        raise BadTable("names", f"{path}: there is no row of numbers, and there are no names of columns")
    for separator in SEPARATORS:
        names = next(iter(blank_heads(body[0][1])), None) if separator == " " else split_names(body[0][1], separator)
        cells = split(body[1][1], separator) if len(body) > 1 else None
        if cells and len(body) > 2 and are_units(cells):
            cells = split(body[2][1], separator)
        if len(body) == 1 and names and len(names) > 1:
            raise BadTable("rows", f"{path}: there is no row of numbers below the names")
        if names and cells and 1 < len(names) == len(cells) and any(is_number(cell, separator) for cell in cells):
            layout = Layout(separator, body[1:], names, [], body[0][0])
            take_units_below(layout, body, comments)
            return layout
    for number, line in body:
        for cell in re.split(r"[\t; ]+", line):
            if PARTED.fullmatch(cell):
                refuse_mark(number, cell, path, "parts of thousands are not read")
    raise BadTable("names", f"{path}: there is no row of numbers")


def raise_without_names(body, first, candidates, path):
    """Say why a table has no names."""
    number, line = body[first]
    for above_number, above in reversed(body[:first]):
        for separator, count in candidates:
            names = split_names(above, separator) if separator != " " else None
            if names and len(names) > 1 and not any(is_number(name, separator) for name in names):
                raise BadTable("names", f"{path}: line {number} has {count} cells, and line {above_number} {len(names)} names")
    raise BadTable("names", f"{path}: no line above the first row, line {number}, has a name for each of its columns")
