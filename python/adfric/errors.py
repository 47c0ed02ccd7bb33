# SPDX-License-Identifier: GPL-3.0-or-later
"""What can go wrong. Messages have the words that the command has for an input; several problems have a line each."""


class Error(Exception):
    """What adfric says of a call that has failed."""


class InputError(Error, ValueError):
    """Something that was given is wrong."""


class FailedError(Error, RuntimeError):
    """A file cannot be read or written, or the machine has too little memory or too few threads."""


class StoppedError(Error, RuntimeError):
    """The call was stopped."""
