# SPDX-License-Identifier: GPL-3.0-or-later
"""What is not up to date in a gallery."""

import shutil
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import gallery  # noqa: E402


class Gallery(unittest.TestCase):
    """A copy of the gallery that is up to date."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.docs, self.inputs = Path(folder.name) / "docs", Path(folder.name) / "inputs"
        (self.docs / "gallery").mkdir(parents=True)
        for name in gallery.KEPT:
            shutil.copy(gallery.FIGURES / f"{name}.png", self.docs / "gallery")
        shutil.copy(gallery.PAGE, self.docs)
        shutil.copytree(gallery.INPUTS, self.inputs)
        changes = {"INPUTS": self.inputs, "PAGE": self.docs / "gallery.md", "FIGURES": self.docs / "gallery",
                   "OVERVIEW_FILE": self.docs / "gallery/overview.png"}
        for name, path in changes.items():
            patch = mock.patch.object(gallery, name, path)
            patch.start()
            self.addCleanup(patch.stop)

    def test_up_to_date(self):
        self.assertEqual([], list(gallery.faults()))

    def test_changed_input(self):
        path = self.inputs / "gm2011_fig5.nml"
        path.write_text(path.read_text().replace("count", "COUNT"))
        self.assertEqual(["docs/gallery/gm2011_fig5.png is out of date"], list(gallery.faults()))

    def test_changed_head(self):
        path = self.inputs / "gm2011_fig5.nml"
        path.write_text(path.read_text().replace("! Contact width", "! Width of the contact"))
        self.assertIn("docs/gallery.md is out of date", list(gallery.faults()))

    def test_missing_and_superfluous(self):
        (self.docs / "gallery/fit_map.png").rename(self.docs / "gallery/mine.png")
        (self.docs / "gallery.md").unlink()
        self.assertEqual(["docs/gallery/fit_map.png is missing", "docs/gallery/mine.png is superfluous", "docs/gallery.md is missing"],
                         list(gallery.faults()))

    def test_inputs(self):
        """An input that no figure shows, and a figure whose input is gone."""
        (self.inputs / "hertz_axes.nml").rename(self.inputs / "mine.nml")
        self.assertEqual(["inputs/mine.nml is not shown", "inputs/hertz_axes.nml is shown, but does not exist"], list(gallery.faults()))

    def test_small(self):
        """The figures of the repository are those of .gitignore, and small files: 60 kB each on the average, 200 kB the overview."""
        ignored = (gallery.ROOT / ".gitignore").read_text().splitlines()
        self.assertEqual({f"!/docs/gallery/{name}.png" for name in gallery.KEPT}, {line for line in ignored if line.startswith("!")})
        sizes = [(gallery.FIGURES / f"{name}.png").stat().st_size for name in gallery.KEPT]
        self.assertLess(sum(sizes) / len(sizes), 60_000)
        self.assertLess(gallery.OVERVIEW_FILE.stat().st_size, 200_000)


if __name__ == "__main__":
    unittest.main()
