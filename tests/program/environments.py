# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests that need packages of an environment of their own."""

import os
import sys
from pathlib import Path

SOURCE = Path(os.environ["ADFRIC_SOURCE"])
# see tests/CMakeLists.txt
ALL_SKIPPED = 77


def restart_in(environment, package):
    """Start this test again with the Python of an environment, if it is not that one."""
    python = SOURCE / environment / "bin/python"
    if Path(sys.executable) != python:
        if not python.exists():
            print(f"skipped: there is no {python}: scripts/setup tests could not install {package}")
            sys.exit(ALL_SKIPPED)
        os.execv(python, [str(python), *sys.argv])
    sys.path.insert(0, str(SOURCE / "scripts"))
