# SPDX-License-Identifier: GPL-3.0-or-later
"""Run the tutorial: tutorial.py [--write], with a Python that has adfric, nbclient and ipykernel.

docs/guide/tutorial.ipynb is run cell by cell. With --write docs/guide/tutorial.md gets its texts, code, what it prints and its figures, which stand in
docs/guide/tutorial/; without it what the cells print is compared with what stands there. Exit status 1: it differs, or a cell fails.
"""

import base64
import io
import sys
import tempfile
from pathlib import Path

import nbformat
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError

DOCS = Path(__file__).resolve().parents[1] / "docs/guide"
NOTEBOOK, PAGE, FIGURES = DOCS / "tutorial.ipynb", DOCS / "tutorial.md", DOCS / "tutorial"
# Pixels of a figure's width, and its colours.
WIDTH, COLOURS = 640, 128
HEAD = "<!-- written by scripts/tutorial from tutorial.ipynb -->\n\n"


def main(arguments):
    """Run the notebook, and write or compare the page."""
    notebook = nbformat.read(NOTEBOOK, 4)
    with tempfile.TemporaryDirectory() as folder:
        try:
            NotebookClient(notebook, timeout=600, extra_arguments=["--IPKernelApp.log_level=ERROR"],
                           resources={"metadata": {"path": folder}}).execute()
        except CellExecutionError as problem:
            sys.exit(f"tutorial: {problem}")
    text, figures = page_of(notebook)
    if arguments == ["--write"]:
        write(text, figures)
        return
    if text != PAGE.read_text():
        sys.exit(f"tutorial: {PAGE} is not what the notebook gives; scripts/tutorial writes it\n{text}")


def page_of(notebook):
    """The page of a notebook that has been run, and its figures by name."""
    parts, figures = [], {}
    for cell in notebook.cells:
        if cell.cell_type == "markdown":
            parts.append(cell.source)
            continue
        parts.append(f"```python\n{cell.source}\n```")
        for output in cell.outputs:
            if "image/png" in output.get("data", {}):
                name = f"figure_{len(figures) + 1}.png"
                figures[name] = base64.b64decode(output.data["image/png"])
                parts.append(f"![{cell.metadata.get('shows', 'figure')}](tutorial/{name})")
            elif output.get("name") != "stderr":
                shown = output.text if "text" in output else output.data["text/plain"]
                parts.append(f"```text\n{shown.rstrip()}\n```")
            else:
                sys.exit(f"tutorial: a cell warns: {output.text}")
    return HEAD + "\n\n".join(parts) + "\n", figures


def write(text, figures):
    """Write the page and its figures, and take away those of before."""
    from PIL import Image

    FIGURES.mkdir(exist_ok=True)
    for path in FIGURES.glob("*"):
        path.unlink()
    for name, data in figures.items():
        image = Image.open(io.BytesIO(data)).convert("RGB")
        if image.width > WIDTH:
            image = image.resize((WIDTH, round(image.height * WIDTH / image.width)), Image.Resampling.LANCZOS)
        image.quantize(COLOURS).save(FIGURES / name, optimize=True)
    PAGE.write_text(text)


if __name__ == "__main__":
    main(sys.argv[1:])
