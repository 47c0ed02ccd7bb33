# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line."""

import sys
from pathlib import Path

from .options import read_command_line
from .shared import BadFile, FileFailure, Results, printable, write_files


def main(arguments):
    """Write one page; return the exit status: 0, or 2 for a bad command line or file."""
    given = read_command_line(arguments)
    page_file = given.output or Path(given.files[0].with_suffix(".html").name)
    try:
        check_target(page_file, given.files, given.force)
        runs = [Results(path) for path in given.files]
        # imported here, since it takes a second that a bad file need not cost
        from .page import page_of

        text = page_of(runs, given.x, given.y)
    except BadFile as problem:
        print(printable(f"report: {problem}"), file=sys.stderr)
        return 2
    try:
        write_files({page_file: text.encode()}, given.force)
    except FileFailure as problem:
        print(printable(f"report: {problem}"), file=sys.stderr)
        return 2
    print(printable(f"report {page_file} ({len(text.encode()) / 1e6:.1f} MB)"))
    return 0


def check_target(page_file, files, force):
    """May a page be written under this name?"""
    if page_file.suffix.lower() not in (".html", ".htm"):
        raise BadFile(f"{page_file}: a page is one of .html, .htm")
    if not page_file.parent.is_dir():
        raise BadFile(f"{page_file}: there is no such folder")
    if not page_file.exists():
        return
    if any(source.exists() and page_file.samefile(source) for source in files):
        raise BadFile(f"{page_file}: the page would replace the results")
    if not force:
        raise BadFile(f"{page_file}: exists already; --force overwrites it")

