# SPDX-License-Identifier: GPL-3.0-or-later
"""Write pages of the guide as notebooks: python3 scripts/notebooks.py FOLDER.

A notebook has the words of its page, without its commands and figures; its input is written, solved and drawn by cells. Data that are
no text are made by a cell. Nothing of it is kept: the site is built with notebooks, and tests/program/notebooks.py runs them.
"""

import json
import re
import shlex
import sys
from pathlib import Path

from document_prose import FENCE, LINK
from make_options.surface import read_command_line

ROOT = Path(__file__).resolve().parents[1]
GUIDE, INPUTS = ROOT / "docs/guide", ROOT / "inputs"
# pages whose inputs stand alone, beside a table of text in `inputs`, or beside data that a cell makes
PAGES = ("friction_of_a_tip", "fretting", "rubber_on_a_road", "fit", "pull_off_of_a_rough_surface", "fit_of_a_force_map")
# sweeps that take long have fewer values in a notebook: what stands on the page, and in the notebook
SHORTER = {"pull_off_of_a_rough_surface": ("count = 25", "count = 5")}
SURFACE = re.compile(r"^scripts/make_surface (.*)$", re.MULTILINE)
# a map of 4 x 4 curves: the modulus grows along x, the work of adhesion along y; the lever gives way by the load over its stiffness
FORCE_MAP = """
# A small map of force curves with their base lines, made by the same theory, with noise
import adfric
import h5py
import numpy as np

stiffness, noise = 0.05, 2.0e-10                                                  # [N/m], [N]
moduli, works = np.linspace(1.0e4, 2.0e4, 4), np.linspace(2.0e-4, 4.0e-4, 4)      # [Pa], [J/m^2]
approach = np.linspace(-5.0e-8, 8.0e-7, 60)                                       # in contact [m]
apart = np.linspace(-2.0e-6, -6.0e-7, 40)                                         # the base line [m]
random = np.random.default_rng(1)
load, position = np.zeros((2, 4, 4, 100))
for row, work in enumerate(works):
    for column, modulus in enumerate(moduli):
        curve = adfric.scene(surface={"kind": "paraboloid", "radius": 5.0e-6}, solid={"contact_modulus": modulus},
                             adhesion={"work_of_adhesion": work, "theory": "jkr"}, sweep={"approach": approach}).solve()
        load[row, column, 40:] = curve["load"]
        position[row, column] = [*apart, *(approach + curve["load"] / stiffness)]
load += random.normal(scale=noise, size=load.shape)
with h5py.File("map.h5", "w") as file:
    for name, values, unit in (("load", load, "N"), ("position", position, "m"), ("contact", np.arange(100) >= 40, "1")):
        file[name] = np.asarray(values, dtype=float)
        file[name].attrs["units"] = unit
"""
TABLE = re.compile(r"file\s*=\s*'([^':]+)'")
# what is written once
KERNEL = {"kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"}, "language_info": {"name": "python"}}
NEEDS = "This notebook needs the Python package `adfric` with its figures: `pip install adfric[plot]`."


def parts_of(text):
    """The parts of a page in order: (language, text), with no language for words."""
    parts, language, lines = [], None, []
    for line in text.splitlines():
        mark = FENCE.match(line)
        if mark:
            parts.append((language, "\n".join(lines)))
            language, lines = (mark[2] if language is None else None), []
        else:
            lines.append(line)
    parts.append((language, "\n".join(lines)))
    return [(language, part.strip("\n")) for language, part in parts if part.strip()]


def words_alone(text):
    """Words without figures, and without links to other pages, which are not beside a notebook."""
    text = re.sub(r"^!\[[^\]]*\]\([^)]*\)\n?", "", text, flags=re.MULTILINE)
    return re.sub(r"\n{3,}", "\n\n", LINK.sub(lambda link: link[0] if "](http" in link[0] else link[1], text)).strip("\n")


def cells_of(name):
    """The cells of a page: (kind, text)."""
    text = (GUIDE / f"{name}.md").read_text()
    title = re.search(r"^# (.*)$", text, re.MULTILINE)[1]
    cells, is_solved = [], False
    for language, part in parts_of(text):
        if language is None and words_alone(part):
            cells.append(("markdown", words_alone(part)))
        elif language == "fortran" and not is_solved and "## The input" in text.partition(part)[0]:
            cells += [*data_cells(name, text), *solving_cells(name, title, part.replace(*SHORTER.get(name, ("", ""))))]
            is_solved = True
        elif language in ("fortran", "text", "python"):
            cells.append(("markdown", f"```{language}\n{part}\n```"))
    cells.insert(1, ("markdown", NEEDS))
    return cells


def data_cells(name, text):
    """Cells that make the data of a page that are no text."""
    if name == "fit_of_a_force_map":
        return [("code", FORCE_MAP.strip())]
    command = SURFACE.search(text)
    if not command:
        return []
    given = read_command_line(shlex.split(command[1]))
    script = ROOT.joinpath("scripts/make_surface.py").read_text()
    made = script[script.index("def make_heights("):script.index("\n\n\ndef main(")]
    values = ", ".join(f"{key}={getattr(given, key)!r}" for key in ("cells", "hurst", "longest", "shortest", "rms", "seed"))
    return [("code", f"# What {command[0].split()[0]} does\nimport h5py\nimport numpy as np\n\n\n{made}\n\n\n"
                     f"write_surface({given.file!r}, make_heights({values}), {given.length!r})")]


def solving_cells(name, title, text):
    """Cells that write an input with its tables, solve it and draw its figure."""
    tables = [("code", f"%%writefile {table}\n{(INPUTS / table).read_text().rstrip()}") for table in TABLE.findall(text)]
    written = ("code", f"%%writefile {name}.nml\n&job title = '{title}' /\n{text}")
    if re.search(r"^&free\b", text, re.MULTILINE):
        return [*tables, written, ("code", f'import adfric\n\nfound = adfric.fit("{name}.nml")\nfound'), ("code", "found.plot();")]
    return [*tables, written, ("code", f'import adfric\n\nresults = adfric.run("{name}.nml")\nresults'), ("code", "adfric.plot(results);")]


def notebook_of(name):
    """The notebook of a page, in version 4.5 of the format."""
    cells = [{"cell_type": kind, "id": f"cell{number}", "metadata": {}, "source": text.splitlines(keepends=True)}
             | ({"execution_count": None, "outputs": []} if kind == "code" else {}) for number, (kind, text) in enumerate(cells_of(name), 1)]
    return {"cells": cells, "metadata": KERNEL, "nbformat": 4, "nbformat_minor": 5}


def write_notebooks(folder):
    """Write all notebooks to a folder; their files."""
    folder.mkdir(parents=True, exist_ok=True)
    files = [folder / f"{name}.ipynb" for name in PAGES]
    for name, file in zip(PAGES, files):
        file.write_text(json.dumps(notebook_of(name), indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
    return files


if __name__ == "__main__":
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    for written in write_notebooks(Path(sys.argv[1])):
        print(written)
