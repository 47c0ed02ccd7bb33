# SPDX-License-Identifier: GPL-3.0-or-later
"""The cells of a line, and the numbers in them."""

import re

import numpy as np

from .heads import is_unit
from .problems import BadTable

# what stands in a cell without a value
MISSING = {"", "nan", "na", "n/a", "null", "none", "missing", "-", "--"}
NUMBER = re.compile(r"[+-]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eEdD][+-]?\d+)?")
# a comma or point that may part thousands, and more of them, which do
MAY_PART = re.compile(r"[+-]?[1-9]\d{0,2}[.,]\d{3}(?:[eEdD].*)?")
PARTED = re.compile(r"[+-]?\d{1,3}(?:(?:,\d{3}){2,}|(?:\.\d{3}){2,}|(?:,\d{3})+\.\d*|(?:\.\d{3})+,\d*)(?:[eEdD].*)?")
# a cell by its separator: in quotes, which open at its beginning, or plain
CELLS = {separator: re.compile(rf'[ ]*(?:"(?P<quoted>(?:[^"]|"")*)"[ ]*|(?P<plain>(?!")[^{separator}]*))(?P<end>{separator}|$)')
         for separator in "\t;,"} | {
    " ": re.compile(r'[ \t]*(?:"(?P<quoted>(?:[^"]|"")*)"|(?P<plain>(?!")[^ \t]*))(?P<end>[ \t]+|$)')}


def split(line, separator):
    """Cells of a line without their quotes; None where quotes do not close, or letters stand behind the closing one."""
    if '"' not in line:
        return line.split() if separator == " " else [cell.strip() for cell in line.split(separator)]
    cells = quoted_cells(line, separator)
    return None if cells is None else [cell for cell, _ in cells]


def quoted_cells(line, separator):
    """Cells of a line, each with whether it stood in quotes; None where quotes do not fit."""
    line, cells, position = line.strip() if separator == " " else line, [], 0
    while True:
        found = CELLS[separator].match(line, position)
        if found is None:
            return None
        is_quoted = found["quoted"] is not None
        cells.append((found["quoted"].replace('""', '"').strip() if is_quoted else found["plain"].strip(), is_quoted))
        if not found["end"]:
            return cells
        position = found.end()


def split_names(line, separator):
    """Names in a line; None where one of them has what separates columns and stands in no quotes."""
    cells = quoted_cells(line, separator)
    if cells is None or any(not is_quoted and re.search(r"[\t;,]", cell) for cell, is_quoted in cells):
        return None
    return [cell for cell, _ in cells]


def blank_heads(line):
    """Names between blanks, where a unit belongs to the name before it; and those told apart by two blanks or more."""
    if re.search(r"[;,]", re.sub(r'"[^"]*"', "", line)):
        return []
    cells = quoted_cells(line, " ")
    if cells is None:
        return []
    names, joins = [], False
    for cell, is_quoted in cells:
        is_mark = not is_quoted and cell in ("/", "in")
        is_bracket = not is_quoted and re.fullmatch(r"[\[(].*|.*[\])]", cell) and not re.fullmatch(r"\w.*[\[(].*[\])]", cell)
        if names and (joins or is_mark or is_bracket or not is_quoted and len(names) and is_unit(cell) and cell not in ("-", "1")):
            names[-1] += " " + cell
        else:
            names.append(cell)
        joins = is_mark
    wide = [part.strip('" ') for part in re.split(r"[ \t]{2,}|\t", line.strip())]
    return [names, wide, [cell for cell, _ in cells]]


def value_of(cell, separator):
    """The number in a cell, not a number where it has no value; None where it is no number."""
    if cell.lower() in MISSING:
        return np.nan
    if separator == "," and "," in cell or not NUMBER.fullmatch(cell):
        return None
    return float(re.sub("[dD]", "e", cell.replace(",", ".")))


def settle_mark(rows, separator, path):
    """The decimal mark of a table; what may be thousands is refused."""
    if separator == ",":
        for number, line in rows:
            if '"' in line:
                for cell in split(line, ",") or ():
                    if "," in cell and re.fullmatch(r"[\d.,+\-eEdD]+", cell):
                        refuse_mark(number, cell, path, "where commas separate the decimal mark is a point")
        return "."
    text = "\n".join(line for _, line in rows)
    if "," not in text and not re.search(r"\d\.\d{3}\.\d{3}", text):
        return "."
    comma = point = is_shown = None
    for number, line in rows:
        for cell in split(line, separator) or ():
            if PARTED.fullmatch(cell):
                refuse_mark(number, cell, path, "parts of thousands are not read")
            if not NUMBER.fullmatch(cell):
                continue
            if "," in cell:
                comma = comma or (number, cell)
                is_shown = is_shown or not MAY_PART.fullmatch(cell)
            elif "." in cell:
                point = point or (number, cell)
    if comma and point:
        refuse_mark(*comma, path, f"line {point[0]} has {point[1]}: which of the marks is decimal is not clear")
    if comma and not is_shown and separator != ";":
        refuse_mark(*comma, path, "each comma stands before three digits, so it may part thousands")
    return "," if comma else "."


def refuse_mark(number, cell, path, why):
    """A decimal mark that is not clear."""
    raise BadTable("decimal", f"{path}: line {number}: {cell}: {why}")


def numbers_in(rows, separator, mark, columns, path):
    """Numbers of all rows, and the columns with cells that are none; `columns` is 0 where there are no names."""
    values = quick_numbers([line for _, line in rows], separator, mark)
    if values is not None and columns in (0, values.shape[1]):
        return values, {}
    cells = [split(line, separator) for _, line in rows]
    for (number, _), row in zip(rows, cells):
        if row is None:
            raise BadTable("quote", f"{path}: line {number}: a quote does not close, or something stands behind the closing one")
    if not columns:
        columns = len(cells[0])
        # a separator at the end of each line makes a column of nothing
        columns -= columns > 1 and all(len(row) == columns and not row[-1] for row in cells)
    values, flaws = np.full((len(rows), columns), np.nan), {}
    for i, ((number, _), row) in enumerate(zip(rows, cells)):
        if len(row) < columns or any(row[columns:]):
            raise BadTable("cells", f"{path}: line {number} has {len(row)} columns, the table has {columns}")
        for place, cell in enumerate(row[:columns]):
            value = value_of(cell, separator)
            if value is None or np.isinf(value):
                flaws.setdefault(place, ("decimal" if PARTED.fullmatch(cell) else "number",
                                         f"{path}: line {number}: '{cell}' is no number" + (" that can be kept" if value else "")))
            else:
                values[i, place] = value
    return values, flaws


def quick_numbers(lines, separator, mark):
    """Numbers of rows without gaps, quotes and words; None where these are no such."""
    if any('"' in line for line in lines):
        return None
    try:
        plain = [line.replace(",", ".") for line in lines] if mark == "," else lines
        values = np.loadtxt(plain, delimiter=None if separator == " " else separator, ndmin=2, comments=None)
    except ValueError:
        return None
    return values if np.isfinite(values).all() else None
