# SPDX-License-Identifier: GPL-3.0-or-later
"""Write pages of the guide as notebooks: python3 scripts/notebooks.py FOLDER.

A notebook has the words of its page, without its commands and figures; its input is written, solved and drawn by cells. Nothing of it is
kept: the site is built with notebooks, and tests/program/notebooks.py runs them. Pages whose data are no text have none.
"""

import json
import re
import sys
from pathlib import Path

from document_prose import FENCE, LINK

ROOT = Path(__file__).resolve().parents[1]
GUIDE, INPUTS = ROOT / "docs/guide", ROOT / "inputs"
# pages whose inputs stand alone, or beside a table of text in `inputs`
PAGES = ("friction_of_a_tip", "fretting", "rubber_on_a_road", "fit")
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
            cells += solving_cells(name, title, part)
            is_solved = True
        elif language in ("fortran", "text", "python"):
            cells.append(("markdown", f"```{language}\n{part}\n```"))
    cells.insert(1, ("markdown", NEEDS))
    return cells


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
