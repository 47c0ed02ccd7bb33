# SPDX-License-Identifier: GPL-3.0-or-later
"""Every link inside the documents leads to a file and to a heading that are there, and the site has a place for every document."""

import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "scripts"))

from document_links import anchors_of, documents_of, faults_of, links_of  # noqa: E402
from site_areas import missing_in_areas  # noqa: E402


class Links(unittest.TestCase):
    """The documents as they are, and documents with faults."""

    def test_documents(self):
        """No link leads nowhere; the documents are those that there are."""
        faults = faults_of(ROOT)
        self.assertEqual([], faults, "\n" + "\n".join(faults))
        self.assertGreater(len(documents_of(ROOT)), 15)
        self.assertGreater(sum(1 for path in documents_of(ROOT) for _ in links_of(path)), 50)

    def test_areas(self):
        """Every document stands in one area of the site, and nothing else does."""
        self.assertEqual([], missing_in_areas(ROOT))

    def write(self, text, other="# Other\n"):
        """A folder with a document and another one."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        root = Path(folder.name)
        (root / "docs").mkdir()
        (root / "README.md").write_text(text)
        (root / "docs/other.md").write_text(other)
        return root

    def test_right(self):
        """Files, headings here and there, with signs and twice the same, pictures, and what is no link."""
        root = self.write("# A b\n[a](docs/other.md) [b](#a-b) [c](docs/other.md#its-x_y-2-d) ![d](docs/a.png) <img src=\"docs/a.png\">\n"
                          "[e](docs/other.md#twice-1) [f]\n\n[f]: docs/other.md\n\n`[g](no.md)` ``[h](no.md) ` `` [i](https://example.org/no)\n\n"
                          "    [j](no.md)\n\n```\n[k](no.md)\n# No heading\n```\n", "# Its `x_y`, 2-D\n## Twice\n## Twice\n")
        (root / "docs/a.png").touch()
        self.assertEqual([], faults_of(root))
        self.assertEqual({"a-b"}, anchors_of(root / "README.md"))

    def test_broken(self):
        """A link that goes on in the next line is one, and its line is the first; an empty line ends it, as code does."""
        root = self.write("# A\n\ntext [a\nb](docs/no.md) [c](docs/other.md),\n`[d\ne](no.md)` [f](docs/gone.md)\n\n[g\n\nh](no.md)\n\n[i\n```\n```\nj](no.md)\n")
        self.assertEqual(["README.md:3: docs/no.md: there is no docs/no.md", "README.md:6: docs/gone.md: there is no docs/gone.md",
                          "README.md:4: there is no docs/no.md", "README.md:6: there is no docs/gone.md"], faults_of(root))

    def test_labels(self):
        """Words with a label lead where its line says, in any case of letters and over a line break; labels are defined once, and used."""
        root = self.write("# A\n\n| [a][other] | [b `c`][Two\nwords] | `[d][no]` | [other] | [e] |\n\n[other]: docs/other.md\n[two words]: #a\n")
        self.assertEqual([], faults_of(root))
        root = self.write("# A\n\n[a][gone] or\n[b][other]\n\n[other]: docs/no.md\n[unused]: docs/other.md\n[Other]: docs/other.md\n")
        self.assertEqual(["README.md:6: docs/no.md: there is no docs/no.md", "README.md:3: [gone] is defined nowhere",
                          "README.md:7: [unused] leads from nowhere", "README.md:8: [other] is defined twice",
                          "README.md:6: there is no docs/no.md"], faults_of(root))

    def test_wrong(self):
        """A file, a heading, a picture and a document that are not there, and a place out of the project."""
        root = self.write("# A\n[a](docs/no.md) and [b](#b)\n[c](docs/other.md#no) ![d](docs/no.png)\n"
                          "`docs/gone.md` [e](../e.md) [f](/docs/other.md)\n[g](docs/other.md \"x\") <a href=\"no.html\">\n", "[h](a.md)\n")
        self.assertEqual(["README.md:2: docs/no.md: there is no docs/no.md", "README.md:2: #b: there is no heading #b",
                          "README.md:3: docs/other.md#no: there is no heading #no", "README.md:3: docs/no.png: there is no docs/no.png",
                          "README.md:4: ../e.md leads out of the project", "README.md:4: /docs/other.md leads out of the project",
                          "README.md:5: no.html: there is no no.html", "README.md:2: there is no docs/no.md",
                          "README.md:4: there is no docs/gone.md", "docs/other.md:1: a.md: there is no docs/a.md"], faults_of(root))


if __name__ == "__main__":
    unittest.main()
