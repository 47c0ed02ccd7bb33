# SPDX-License-Identifier: GPL-3.0-or-later
"""The letters of a text file, whatever wrote it."""

import codecs
import re

from .problems import BadTable, FileFailure

UTF16 = (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)
UTF32 = (codecs.BOM_UTF32_LE, codecs.BOM_UTF32_BE)
CONTROL = re.compile(r"[\x00-\x08\x0b\x0c\x0e-\x1f\x7f]")


def read_lines(path):
    """Lines of a text file, which end as on Unix, Windows or an old Macintosh."""
    try:
        data = path.read_bytes()
    except OSError as problem:
        raise FileFailure(f"{path}: cannot read: {problem.strerror or problem}") from None
    text = decode(data, path)
    found = CONTROL.search(text)
    if found:
        raise BadTable("encoding", f"{path}: this is no text: it has the control character {ord(found[0])}")
    return text.replace("\r\n", "\n").replace("\r", "\n").split("\n")


def decode(data, path):
    """UTF-8 with or without its mark, UTF-16 with one, and Latin-1 where the bytes are no UTF-8."""
    if data.startswith(UTF32):
        raise BadTable("encoding", f"{path}: the text is UTF-32, allowed: UTF-8, UTF-16 or Latin-1")
    try:
        return data.decode("utf-16" if data.startswith(UTF16) else "utf-8-sig")
    except UnicodeDecodeError:
        if data.startswith(UTF16):
            raise BadTable("encoding", f"{path}: the text is no UTF-16, though it begins as such") from None
    return data.decode("latin-1")
