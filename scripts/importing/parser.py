# SPDX-License-Identifier: GPL-3.0-or-later
"""A parser of options that reports a bad one in one line."""

from plotting.options import Parser as PlainParser

from .problems import BadInput


class Parser(PlainParser):
    """A parser that reports a bad option in one line."""

    def error(self, message):
        raise BadInput(message)
