# SPDX-License-Identifier: GPL-3.0-or-later
"""Text from outside as it may be shown on a terminal, as src/base/printable.f90 does, and in a figure."""


def printable(text):
    """The text with what a terminal would obey, or would not show, written as `\\x1b` or `\\u202e`."""
    return "".join(letter if letter.isprintable() else escaped(letter) for letter in str(text))


def literal(text):
    """The text as a figure shows it letter by letter: between dollar signs would stand a formula."""
    return str(text).replace("$", r"\$")


def escaped(letter):
    """A letter by its number; a byte of a name that is no UTF-8, which Python keeps at 0xdc00, as that byte."""
    code = ord(letter)
    if 0xDC80 <= code <= 0xDCFF:
        code -= 0xDC00
        return f"\\x{code:02x}"
    return f"\\x{code:02x}" if code < 0x80 else f"\\u{code:04x}"
