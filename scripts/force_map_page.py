# SPDX-License-Identifier: GPL-3.0-or-later
"""Run the commands of docs/guide/force_map.md: force_map_page.py [--write].

Each block of text behind a command has what the command prints. With --write the page gets it, and docs/guide/force_map/ the figures; without it
both are compared: words one by one, numbers to a thousandth, since compilers differ in round-off. Exit status: 1 if they differ.
"""

import os
import re
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PAGE, FIGURES = ROOT / "docs/guide/force_map.md", ROOT / "docs/guide/force_map"
PROGRAM = os.environ.get("ADFRIC_PROGRAM", ROOT / "build/release/adfric")
PLAIN, CURVE = ROOT / ".venv/bin/python", ROOT / ".venv_curve/bin/python"
COMMANDS = {"scripts/make_force_map": [PLAIN, ROOT / "scripts/make_force_map.py"],
            "scripts/import_curve": [CURVE, ROOT / "scripts/import_curve.py"],
            "build/release/adfric": [PROGRAM]}
# what a run leaves in its folder, and where it stands in the documents
SHOWN = {"force_map.png": "curves.png", "maps.png": "maps.png"}
WIDTH, COLOURS = 760, 128
BLOCK = re.compile(r"(?:^```sh\n(?P<command>\S.*)\n```\n|^```python\n(?P<code>(?:.*\n)*?)```\n)(?:\n```text\n(?P<text>(?:.*\n)*?)```\n)?", re.MULTILINE)
NUMBER = re.compile(r"[-+]?\d+\.?\d*(?:[eE][-+]?\d+)?")
# lines that tell of the machine
OF_THE_RUN = re.compile(r"^time .*\n", re.MULTILINE)


def main(arguments):
    """Run the page in a folder of its own, and write or compare."""
    page, problems = PAGE.read_text(), []
    with tempfile.TemporaryDirectory() as folder:
        def run(found):
            printed = OF_THE_RUN.sub("", output_of(found, Path(folder)))
            if found["text"] is None:
                return found[0]
            if not is_like(printed, found["text"]):
                problems.append(f"{found['command'] or 'the code'} prints\n{printed}")
            start, end = (place - found.start() for place in found.span("text"))
            return found[0][:start] + printed + found[0][end:]

        written = BLOCK.sub(run, page)
        if arguments == ["--write"]:
            PAGE.write_text(written)
            write_figures(Path(folder))
            return
        problems += [f"{made} is not drawn" for made in SHOWN if not (Path(folder) / made).exists()]
    if problems:
        sys.exit("force_map_page: docs/guide/force_map.md is not what its commands print; scripts/tutorial writes it\n" + "\n".join(problems))


def output_of(found, folder):
    """What a command or code prints."""
    if found["code"] is not None:
        words = [PLAIN, "-c", found["code"]]
    else:
        first, *rest = shlex.split(found["command"])
        words = COMMANDS[first] + [ROOT / word if word.startswith("inputs/") else word for word in rest]
    done = subprocess.run(words, cwd=folder, capture_output=True, text=True, check=False, env={**os.environ, "MPLBACKEND": "Agg"})
    if done.returncode != 0:
        sys.exit(f"force_map_page: {found[0]}{done.stdout}{done.stderr}")
    return done.stderr + done.stdout


def is_like(one, other):
    """Are two texts the same, but for the last digits of numbers?"""
    numbers = [[float(number) for number in NUMBER.findall(text)] for text in (one, other)]
    return (NUMBER.sub("0", one).split() == NUMBER.sub("0", other).split() and
            all(abs(a - b) <= 1e-3 * abs(b) for a, b in zip(*numbers)))


def write_figures(folder):
    """Write the figures."""
    from PIL import Image

    FIGURES.mkdir(exist_ok=True)
    for made, name in SHOWN.items():
        image = Image.open(folder / made).convert("RGB")
        image = image.resize((WIDTH, round(image.height * WIDTH / image.width)), Image.Resampling.LANCZOS)
        image.quantize(COLOURS).save(FIGURES / name, optimize=True)


if __name__ == "__main__":
    main(sys.argv[1:])
