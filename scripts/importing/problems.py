# SPDX-License-Identifier: GPL-3.0-or-later
"""What can be wrong; each problem is shown in one line, and says the exit status."""


class BadInput(Exception):
    """Options or contents of a file that are not understood, or of which the meaning would have to be guessed."""

    status = 2


class BadTable(BadInput):
    """A table that can be read in two ways or in none; says the reason, one of those of tests/reference/tables/README.md."""

    def __init__(self, reason, text):
        super().__init__(text)
        self.reason = reason


class NoSpectrum(BadInput):
    """Heights that have no power spectrum: too few waves, or none but round-off."""


class FileFailure(Exception):
    """A file that cannot be read or written."""

    status = 3


def first_line(problem):
    """The first line of what a library says, without its closing stop; the name of the problem where it says nothing."""
    lines = [line.strip() for line in str(problem).splitlines() if line.strip()]
    return lines[0].rstrip(".") if lines else type(problem).__name__
