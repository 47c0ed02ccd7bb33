# SPDX-License-Identifier: GPL-3.0-or-later
"""Name and unit of the head of a column: `load [nN]`, `load (nN)`, `load / nN`, `load in nN`, `load_nN`, by the rules of docs/reference/tables.md.

A head with a part that is not understood is never taken for one without a unit: its unit is one that nobody knows, or it has a flaw.
"""

import re
from dataclasses import dataclass

from .quantities import is_like, read_unit

# what stands between a name and a unit without brackets, and what is left out at the end of a name
JOINTS = " _-.,:;"
ENDS = JOINTS + "/"
BRACKETS = {")": "(", "]": "[", "}": "{"}
# units that are no powers of ten of SI units: they are recognised, and refused
FOREIGN = set("lb lbf psi ksi kgf gf dyn inch inches ft deg degree degrees degC degF percent".split())
# the same where nothing but units stands, in a line of them
OTHER = FOREIGN | set("% min h C F \u00b0 \u00b0C \u00b0F a.u. arb. arb au counts cts ppm".split())


@dataclass
class Head:
    """A head."""

    # the whole of it, its name, and its unit, empty where there is none
    text: str
    name: str
    unit: str = ""
    # what is wrong with it; empty if nothing is
    flaw: str = ""
    # do nothing but its own letters tell that the unit is one, as in `load_nN`?
    is_bare: bool = False


def split_head(text):
    """The parts of a head without quotes and blanks around it."""
    head = Head(text, text)
    if text and text[-1] in BRACKETS:
        split_brackets(head)
    elif re.search(r"[\[(]", text):
        head.flaw = f"something stands behind a bracket, or it is not closed, given {text}"
    else:
        split_words(head)
    return head


def is_unit(text):
    """Is a text a unit that is known, a hyphen or 1 among them?"""
    return bool(text) and read_unit(text) is not None


def is_unit_like(text):
    """Is a text of a line of units a unit, be it known or not?"""
    return is_unit(text) or bool(text) and all(is_unit(factor) or factor in OTHER for factor in re.split(r"[ */]+", text) if factor)


def cut(head, last, first):
    """Name and unit of a head whose name ends before `last`, and whose unit begins at `first`."""
    head.name = head.text[:last].rstrip(ENDS)
    head.unit = head.text[first:].strip()


def split_words(head):
    """Take a head without brackets apart."""
    place = (" " + head.text.lower()).rfind(" in ")
    if place > 0:
        cut(head, place - 1, place + 3)
        return
    place = head.text.find(" / ") + 1
    if place < 2:
        split_letters(head)
        if head.is_bare:
            return
        place = head.text.find("/")
    if place > 0:
        cut(head, place, place + 1)


def split_brackets(head):
    """Take a head apart that ends with a bracket."""
    first = head.text.rfind(BRACKETS[head.text[-1]])
    if first < 0:
        head.flaw = f"a bracket closes that has not opened, given {head.text}"
        return
    head.name, head.unit = head.text[:first].rstrip(ENDS), head.text[first + 1:-1].strip()
    if not head.unit:
        head.flaw = f"no unit in the brackets, given {head.text}"
    elif is_unit(head.unit):
        head.flaw = contradiction(head.name, head.unit)


def split_letters(head):
    """Take a head apart whose last word is a unit; the longest one is meant: N m-1, and not m-1."""
    text = head.text.rstrip(JOINTS)
    for place in range(1, len(text) - 1):
        unit = text[place + 1:]
        if text[place] not in JOINTS or unit[0] in JOINTS + "+0123456789" or not (is_unit(unit) or unit in FOREIGN):
            continue
        if not text[:place].strip(ENDS):
            return
        cut(head, place, place + 1)
        head.unit, head.is_bare = unit, True
        # load_in_nN
        head.name = re.sub(rf"[{re.escape(JOINTS)}]+in$", "", head.name, flags=re.IGNORECASE)
        return


def add_unit(head, unit):
    """The same head with the unit that stands in a line of units."""
    if not unit:
        return head
    if head.unit and is_unit(head.unit) and not head.flaw:
        head.flaw = contradiction(head.text, unit)
        if head.flaw or is_like(head.unit, unit):
            return head
    # what looked like a unit is a part of the name
    return Head(head.text, head.text, unit)


def contradiction(text, unit):
    """What to say of a name whose own unit another unit contradicts; empty if it does not."""
    inner = Head(text, text)
    if text and text[-1] in BRACKETS:
        inner.unit = text[max(text.rfind(bracket) for bracket in BRACKETS.values()) + 1:-1]
    elif text:
        split_words(inner)
    one, other = inner.unit and read_unit(inner.unit), read_unit(unit)
    if not one or not other or is_like(inner.unit, unit) or inner.is_bare and one.powers != other.powers:
        return ""
    return f"two units that contradict each other, given {inner.unit} and {unit}"


def plain(name):
    """A name as it is compared: capitals do not count, and blanks, hyphens and underscores are alike."""
    return re.sub(r"[\s_-]+", " ", name.strip()).lower()
