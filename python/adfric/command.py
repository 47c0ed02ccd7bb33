# SPDX-License-Identifier: GPL-3.0-or-later
"""The command `adfric` that comes with the package."""

import os
import subprocess
import sys
from pathlib import Path

from .errors import FailedError, InputError, StoppedError
from .files import name_of, open_file

PROGRAM = os.environ.get("ADFRIC_PROGRAM") or Path(__file__).parent/"bin"/"adfric"
# Exit statuses of `adfric run` that have results.
ANSWERED, PARTLY_CONVERGED = 0, 1


def main():
    """Become the command."""
    try:
        os.execv(PROGRAM, [str(PROGRAM), *sys.argv[1:]])
    except OSError as problem:
        sys.exit(f"adfric: cannot start {PROGRAM}: {problem.strerror}")


def run_command(path, output, force, threads):
    """Run an input by the command, and open the results file that it has written."""
    path, output = name_of(path, "path"), name_of(output, "output")
    arguments = [PROGRAM, "run", "--quiet", "--output", output, *(["--force"] if force else []), "--", path]
    environment = dict(os.environ, **({"OMP_NUM_THREADS": str(threads)} if threads else {}))
    done = subprocess.run(arguments, stderr=subprocess.PIPE, env=environment, check=False)
    message = done.stderr.decode("utf-8", "replace").strip()
    if done.returncode == 2:
        raise InputError(message)
    if done.returncode < 0 or done.returncode > 128:
        raise StoppedError(message or f"adfric run was stopped by signal {done.returncode % 128}")
    if done.returncode not in (ANSWERED, PARTLY_CONVERGED):
        raise FailedError(message)
    return open_file(output)
