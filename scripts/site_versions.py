# SPDX-License-Identifier: GPL-3.0-or-later
"""Several versions of the site side by side: a folder for each, the list that the selector of every page reads, and where one begins.

The list has the form of mike's versions.json, which the theme Material knows. Its selector asks for ../versions.json, so that the site
needs no address of its own; pages without a server have no selector.
"""

import json
import re
from pathlib import Path

NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]*")
NUMBER = re.compile(r"\d+(?:\.\d+)*")
LIST = "versions.json"
FIRST_PAGE = """<!DOCTYPE html>
<html lang="en">
<head><meta charset="utf-8"><title>adfric</title><meta http-equiv="refresh" content="0; url={0}/index.html"></head>
<body><a href="{0}/index.html">adfric {0}</a></body>
</html>
"""


class BadVersion(Exception):
    """A version that cannot stand beside others; the text says why."""


def check_name(name):
    """Can a folder of versions have one of this name?"""
    if not NAME.fullmatch(name) or name in (LIST, "index.html"):
        raise BadVersion(f"version: given '{name}', allowed: letters, digits, dots, lines and hyphens")
    return name


def versions_in(folder):
    """The list of a folder, as it is there; empty if there is none."""
    path = Path(folder) / LIST
    if not path.exists():
        return []
    try:
        entries = json.loads(path.read_text())
        return [{"version": entry["version"], "title": entry["title"], "aliases": list(entry["aliases"])} for entry in entries]
    except (ValueError, KeyError, TypeError):
        raise BadVersion(f"{path}: not a list of versions") from None


def order_of(name):
    """Numbers come first, the newest at the top, then what has no number."""
    return (0, [*(-int(part) for part in name.split(".")), 1]) if NUMBER.fullmatch(name) else (1, [], name)


def add_version(folder, name):
    """List a version, and begin with the newest one; those whose folders are gone leave the list."""
    folder = Path(folder)
    names = {entry["version"] for entry in versions_in(folder)} | {check_name(name)}
    names = sorted((one for one in names if (folder / one).is_dir()), key=order_of)
    entries = [{"version": one, "title": one, "aliases": []} for one in names]
    (folder / LIST).write_text(json.dumps(entries, indent=1) + "\n")
    (folder / "index.html").write_text(FIRST_PAGE.format(names[0]))
