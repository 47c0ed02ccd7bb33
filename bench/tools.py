# SPDX-License-Identifier: GPL-3.0-or-later
"""What the benchmarks in Python share: environments of their own for public packages, the machine, tables."""

import contextlib
import csv
import os
import pathlib
import re
import statistics
import subprocess
import sys

ONE_THREAD = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")
#: A public library: name, folder, packages, and what must be importable.
TAMAAS = ("Tamaas 2.9.0", "tamaas", ["tamaas==2.9.0", "numpy"], "import tamaas, numpy")


def last_line(text):
    """The line in which a program says what went wrong."""
    lines = [line for line in text.splitlines() if line.strip()]
    return lines[-1] if lines else "no message"


def make_environment(folder, packages, check):
    """The Python of an environment that has the packages, made where it is missing, and else why there is none."""
    home = pathlib.Path(folder).absolute()
    python = home / "bin" / "python"
    works = [python, "-c", check]
    if python.exists() and subprocess.run(works, capture_output=True).returncode == 0:
        return python, ""
    for step in ([sys.executable, "-m", "venv", "--clear", home],
                 [python, "-m", "pip", "install", "--quiet", "--no-input", "--disable-pip-version-check",
                  "--prefer-binary", *packages], works):
        try:
            done = subprocess.run(step, capture_output=True, text=True)
        except OSError as problem:
            return None, str(problem)
        if done.returncode != 0:
            return None, f"cannot install {' '.join(packages)}: {last_line(done.stderr or done.stdout)}"
    return python, ""


def machine():
    """Name of the processor."""
    match = re.search(r"model name\s*:\s*(.+)", pathlib.Path("/proc/cpuinfo").read_text())
    return match.group(1) if match else "unknown processor"


def compiler():
    """The compiler, as it calls itself."""
    return subprocess.run(["gfortran", "--version"], capture_output=True, text=True).stdout.split("\n")[0]


def read_table(path):
    """Heading (machine and compiler) and rows of a table."""
    with open(path, newline="") as file:
        lines = file.readlines()
    heading = lines[0].strip("# \n") if lines[0].startswith("#") else ""
    return heading, list(csv.DictReader(line for line in lines if not line.startswith("#")))


@contextlib.contextmanager
def table_writer(path, heading, columns):
    """A table with its heading, row by row."""
    with open(path, "w", newline="") as file:
        file.write(f"# {heading}\n")
        writer = csv.writer(file)
        writer.writerow(columns)
        yield writer


def spread(sample):
    """Median, least and most."""
    return statistics.median(sample), min(sample), max(sample)
