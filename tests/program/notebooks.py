# SPDX-License-Identifier: GPL-3.0-or-later
"""The notebooks of the guide: each runs from its first cell to its last one, draws a figure, and has the words of its page."""

from environments import SOURCE, restart_in

restart_in(".venv_tutorial", "nbclient")

import os  # noqa: E402
import re  # noqa: E402
import sys  # noqa: E402
import tempfile  # noqa: E402
import unittest  # noqa: E402
from pathlib import Path  # noqa: E402

import nbformat  # noqa: E402
from nbclient import NotebookClient  # noqa: E402

from document_prose import prose_of  # noqa: E402
from notebooks import GUIDE, NEEDS, PAGES, parts_of, words_alone, write_notebooks  # noqa: E402

# a cell that asks of what the others have found
SOLVED = """
if "results" in globals():
    assert "status" not in results or (results.status == 0).any() and not (results.status == 2).any()
    assert any(values.dtype.kind == "f" and values.notnull().all() for name, values in results.data_vars.items() if values.size > 1 or values.ndim)
elif found.is_single:
    assert found.status == "fitted"
else:
    # what a map was made with lies within five standard errors, and the errors are small
    assert (found.results.status == 0).all()
    for name, truth in (("contact_modulus", moduli[None, :]), ("work_of_adhesion", works[:, None])):
        error = found.results[f"{name}_error"]
        assert (abs(found.results[name] - truth) < 5 * error).all() and (error < 0.1 * found.results[name]).all(), name
"""


class Notebooks(unittest.TestCase):
    """All notebooks, written to a folder."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        cls.files = write_notebooks(cls.folder / "notebooks")

    def test_run(self):
        """Cells run without a warning; the last one draws, and the input is solved."""
        for file in self.files:
            with self.subTest(file.stem):
                notebook = nbformat.read(file, 4)
                nbformat.validate(notebook)
                notebook.cells.append(nbformat.v4.new_code_cell(SOLVED))
                work = self.folder / file.stem
                work.mkdir()
                NotebookClient(notebook, timeout=600, extra_arguments=["--IPKernelApp.log_level=ERROR"], resources={"metadata": {"path": work}}).execute()
                outputs = [output for cell in notebook.cells if cell.cell_type == "code" for output in cell.outputs]
                self.assertEqual([], [output.text for output in outputs if output.get("name") == "stderr"])
                self.assertIn("image/png", outputs[-1].data)

    def test_words(self):
        """A notebook has every sentence of its page but those of commands, and no link that leads nowhere."""
        for file in self.files:
            notebook = nbformat.read(file, 4)
            text = "\n\n".join(cell.source for cell in notebook.cells if cell.cell_type == "markdown")
            self.assertIn(NEEDS, text)
            page = re.sub(r"^!.*\n", "", (GUIDE / f"{file.stem}.md").read_text(), flags=re.MULTILINE)
            self.assertEqual([words for _, words in prose_of(page)], [words for _, words in prose_of(text.replace(f"{NEEDS}\n\n", ""))], file.stem)
            self.assertEqual([], re.findall(r"\]\((?!http)[^)]*\)", text))
        self.assertEqual({path.stem for path in self.files}, set(PAGES))

    def test_parts(self):
        """Blocks and words are told apart, and figures and links leave words alone."""
        self.assertEqual([(None, "a"), ("sh", "b\nc"), (None, "d"), ("", "e")], parts_of("a\n\n```sh\nb\nc\n```\n\nd\n```\ne\n```\n"))
        self.assertEqual("a b\n\nc [d](https://example.org)", words_alone("a [b](b.md#c)\n\n![e](e.png)\n\nc [d](https://example.org)\n"))


if __name__ == "__main__":
    if "ADFRIC_LIBRARY" not in os.environ:
        print("skipped: there is no library for Python in this build")
        sys.exit(77)
    os.environ["PYTHONPATH"] = str(SOURCE / "python")
    # the figures of a notebook are its own
    os.environ.pop("MPLBACKEND", None)
    unittest.main()
