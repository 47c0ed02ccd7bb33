# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of numbers in text files: separators, heads of columns, comments.

What could be read in two ways is refused: decimal commas are taken where semicolons separate, and nowhere else.
"""

import re
from dataclasses import dataclass

import numpy as np

from .problems import BadInput, FileFailure, first_line

# lines without numbers that may stand before the table
MOST_HEAD_LINES = 200
# what stands in a field without a value
MISSING = {"", "nan", "na", "n/a", "bad", "missing", "null", "none", "-", "--", "inf", "-inf", "+inf"}
ENCODINGS = ("utf-8-sig", "latin-1")


@dataclass
class Table:
    """Columns of numbers, not a number where the file has none, and the lines above them."""

    values: np.ndarray
    # heads of the columns; empty where there are none
    heads: list
    # what stands above the table, heads included
    comments: list


def read_table(path):
    """Read a table of numbers whose rows have the same number of columns."""
    lines = read_text(path).splitlines()
    start = next((i for i, line in enumerate(lines[:MOST_HEAD_LINES + 1]) if is_row(line)), None)
    if start is None:
        raise BadInput(f"{path}: there is no row of numbers in the first {MOST_HEAD_LINES} lines")
    rows = [(number, line) for number, line in enumerate(lines[start:], start + 1)
            if line.strip() and not line.lstrip().startswith(("#", "%"))]
    separator = separator_of([line for _, line in rows], path)
    values = read_numbers(rows, separator, path)
    comments = [line.strip().lstrip("#%").strip() for line in lines[:start] if line.strip()]
    return Table(values, heads_of(comments[-1], separator, values.shape[1]) if comments else [], comments)


def read_text(path):
    """Text of a file."""
    try:
        data = path.read_bytes()
    except OSError as problem:
        raise FileFailure(f"{path}: cannot read: {problem.strerror or problem}") from None
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        encodings = ("utf-16",)
    elif b"\0" in data:
        raise BadInput(f"{path}: this is no text")
    else:
        encodings = ENCODINGS
    for encoding in encodings:
        try:
            return data.decode(encoding)
        except UnicodeDecodeError:
            continue
    raise BadInput(f"{path}: this is no text")


def count_columns(path):
    """Number of columns in the first row of numbers; 0 where there is no text with numbers."""
    with path.open("rb") as file:
        head = file.read(1 << 16)
    if b"\0" in head:
        return 0
    lines = head.decode("latin-1").splitlines()
    return next((len(re.split(r"[\s,;]+", line.strip(" \t,;"))) for line in lines if is_row(line)), 0)


def is_row(line):
    """Does a line have numbers, and nothing else but fields without a value?"""
    if line.lstrip().startswith(("#", "%")):
        return False
    fields = [field for field in re.split(r"[\s,;]+", line.strip()) if field]
    found = [field for field in fields if field.lower() not in MISSING]
    return bool(found) and all(is_number(field) for field in found)


def is_number(field):
    """Is this a number?"""
    try:
        float(field)
    except ValueError:
        return False
    return True


def separator_of(lines, path):
    """What separates the columns: `;`, `,`, or white space, which is None."""
    has = {mark: any(mark in line for line in lines) for mark in ";,\t "}
    if has[";"]:
        if has[","] and any("." in line for line in lines):
            raise BadInput(f"{path}: semicolons, commas and points in one table: which of them are decimal is not clear")
        return ";"
    if not has[","]:
        return None
    # 1,5 2,5 may be two numbers or four
    if any(re.search(r"\S[ \t]+[^\s,]", re.sub(r",\s*", ",", line.strip())) for line in lines):
        raise BadInput(f"{path}: commas and white space both separate: decimal commas are read where semicolons separate")
    return ","


def split(line, separator):
    """Fields of a line."""
    return [unquoted(field.strip()) for field in (line.split(separator) if separator else line.split())]


def unquoted(field):
    """A field without the quotes around it; E" keeps its mark."""
    return field[1:-1] if len(field) > 1 and field[0] == field[-1] == '"' else field


def heads_of(line, separator, columns):
    """Heads of the columns in the line above them, as in `x [um], y [um], z [nm]`; none if these are not so many."""
    line = re.sub(r"\s+(?=[\[(])", "", line)
    for heads in ([unquoted(head) for head in re.split(r"\s*[,;\t]\s*", line)], split(line, separator)):
        if len(heads) == columns:
            return heads
    return []


def read_numbers(rows, separator, path):
    """Numbers of all rows."""
    plain = [line.replace(",", ".") if separator == ";" else line for _, line in rows]
    try:
        # the quick way, for tables without gaps
        values = np.loadtxt(plain, delimiter=separator, ndmin=2, comments=None)
    except ValueError:
        values = read_fields(zip([number for number, _ in rows], plain), separator, path)
    values[~np.isfinite(values)] = np.nan
    # a separator at the end of each line makes a column of nothing
    if separator and values.shape[1] > 1 and all(line.rstrip().endswith(separator) for _, line in rows):
        values = values[:, :-1]
    return values


def read_fields(rows, separator, path):
    """Numbers field by field, with what is missing as not a number."""
    values = []
    for number, line in rows:
        fields = split(line, separator)
        try:
            values.append([np.nan if field.lower() in MISSING else float(field) for field in fields])
        except ValueError as problem:
            raise BadInput(f"{path}: line {number}: {first_line(problem)}") from None
        if len(values[-1]) != len(values[0]):
            raise BadInput(f"{path}: line {number} has {len(values[-1])} columns, those above have {len(values[0])}")
    return np.array(values)
