# SPDX-License-Identifier: GPL-3.0-or-later
"""What a results file says of its scene: the input, group by group, and the values that it led to."""

import re
from dataclasses import dataclass

import h5py

GROUP = re.compile(r"^\s*&(\w+)", re.MULTILINE)
NAME = re.compile(r"(?:^|[\s,&/])([a-z]\w*)\s*(?:\([\d,: ]*\)\s*)?=", re.IGNORECASE)


@dataclass
class Source:
    """Where results come from: the attributes of the file, what each dataset means, and the words of its statuses by their numbers."""

    attributes: dict
    meanings: dict
    statuses: dict

    @property
    def text(self):
        """The input; empty if the file has none."""
        return self.attributes.get("input", "")


def source_of(results):
    """Where results come from."""
    with h5py.File(results.source, "r") as file:
        attributes = {key: _text(value) for key, value in file.attrs.items()}
        meanings = {name: _text(item.attrs.get("long_name", "")) for name, item in file.items() if isinstance(item, h5py.Dataset)}
        about = file["status"].attrs
        words = _text(about.get("flag_meanings", "")).split()
        statuses = dict(zip([int(number) for number in about.get("flag_values", [])], words))
    return Source(attributes, meanings, statuses)


def groups_of(text):
    """Groups of an input with the names that stand in them, in the order of the input."""
    bare = re.sub(r"'[^'\n]*'|\"[^\"\n]*\"", "''", text)
    bare = re.sub(r"![^\n]*", "", bare)
    starts = list(GROUP.finditer(bare))
    ends = [start.start() for start in starts[1:]] + [len(bare)]
    return [(start[1].lower(), [name.lower() for name in NAME.findall(bare[start.end():end])]) for start, end in zip(starts, ends)]


def _text(value):
    return value.decode() if isinstance(value, bytes) else str(value)
