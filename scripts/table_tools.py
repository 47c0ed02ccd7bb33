# SPDX-License-Identifier: GPL-3.0-or-later
"""Run inputs with changes, and print tables of the documents."""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

import h5py

ROOT = Path(__file__).resolve().parents[1]
PROGRAM = Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/release/adfric").resolve()


def solve(name, **changes):
    """Results of an input with some variables changed, given as group__variable='text'; a list makes a sweep,
    None leaves the variable out."""
    text = (ROOT / "inputs" / f"{name}.nml").read_text()
    for key, value in changes.items():
        group, variable = key.split("__")
        text = re.sub(rf"&sweep\s+variable = '{variable}'.*?\n/\n", "", text, flags=re.DOTALL)
        text = re.sub(rf"(&{group}\n(?:.*\n)*?)  {variable} = .*\n", r"\1", text, count=1)
        if value is None:
            continue
        if isinstance(value, str):
            if f"&{group}\n" not in text:
                text += f"\n&{group}\n/\n"
            text = text.replace(f"&{group}\n", f"&{group}\n  {variable} = {value}\n", 1)
        else:
            text += f"\n&sweep variable = '{group}%{variable}', values = {', '.join(repr(float(v)) for v in value)} /\n"
    with tempfile.TemporaryDirectory() as folder:
        source, target = Path(folder, "input.nml"), Path(folder, "results.h5")
        source.write_text(text)
        subprocess.run([PROGRAM, "run", source, "--output", target, "--quiet"], check=True)
        with h5py.File(target) as file:
            return {key: data[()] for key, data in file.items() if isinstance(data, h5py.Dataset)}


def row(*cells):
    print("| " + " | ".join(cell if isinstance(cell, str) else f"{cell:.5g}" for cell in cells) + " |")


def head(title, *cells):
    print(f"\n{title}\n")
    row(*cells)
    row(*["---"] * len(cells))
