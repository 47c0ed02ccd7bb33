# SPDX-License-Identifier: GPL-3.0-or-later
"""Every source file names its licence: an SPDX identifier in its first line, or in the second below #! and #compdef.

Inputs, documents, tables of numbers and lists of packages carry none; README.md says that they have the same licence.
"""

import re
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
LICENCE = "SPDX-License-Identifier: GPL-3.0-or-later"
FOLDERS = (".ci", ".github", "bench", "cmake", "docs", "drivers", "examples", "include", "python", "scripts", "src", "tests")
# How a line of a comment is written, by the end of the file's name; a template has the end before `.in`.
COMMENTS = {**dict.fromkeys((".f90", ".F90", ".pf"), "! {}"), **dict.fromkeys((".c", ".cpp", ".h"), "/* {} */"), ".js": "// {}", ".1": '.\\" {}',
            **dict.fromkeys((".py", ".pyi", ".cmake", ".pc", ".sh", ".bash", ".supp", ".toml", ".yml"), "# {}")}


def comment_of(path, first):
    """How a source file, whose first line is given, writes a comment; None for a file that is no source."""
    if path.name == "CMakeLists.txt" or first.startswith(("#!", "#compdef")):
        return "# {}"
    return COMMENTS.get(Path(path.name.removesuffix(".in")).suffix)


def sources_of(root):
    """The source files, each with its first two lines and with the line that it needs."""
    files = [root / "CMakeLists.txt", *root.glob("*.toml"),
             *(path for folder in FOLDERS for path in sorted((root / folder).rglob("*")))]
    for path in files:
        if not path.is_file() or "__pycache__" in path.parts:
            continue
        lines = path.read_bytes().split(b"\n", 2)[:2]
        first, second = (line.decode(errors="replace") for line in (*lines, b"")[:2])
        if comment := comment_of(path, first):
            yield path, first, second, comment.format(LICENCE)


def faults_of(root):
    """Every source file without the line, as FILE: what is missing."""
    return [f"{path.relative_to(root).as_posix()}: no line {needed}" for path, first, second, needed in sources_of(root)
            if needed != (second if re.match(r"#!|#compdef\b", first) else first)]


class Licence(unittest.TestCase):
    """The sources as they are, and files with and without the line."""

    def test_sources(self):
        """Every source file has the line, and the folders are those that there are."""
        faults = faults_of(ROOT)
        self.assertEqual([], faults, "\n" + "\n".join(faults))
        self.assertGreater(len([*sources_of(ROOT)]), 800)

    def faults_with(self, name, text):
        """What is wrong with a file."""
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "CMakeLists.txt").write_text(f"# {LICENCE}\n")
            file = Path(folder, name)
            file.parent.mkdir(parents=True)
            file.write_text(text)
            return faults_of(Path(folder))

    def test_right(self):
        """Each kind of comment, the line below a first one that has a use, and files that are no sources."""
        for name, text in (("src/base/a.f90", f"! {LICENCE}\n!> A.\n"), ("include/a.h", f"/* {LICENCE} */\n"),
                           ("cmake/a.pc.in", f"# {LICENCE}\nprefix=a\n"), ("docs/a.1.in", f'.\\" {LICENCE}\n.TH A\n'),
                           ("scripts/a", f"#!/usr/bin/env bash\n# {LICENCE}\n"), ("scripts/_a", f"#compdef a\n# {LICENCE}\n"),
                           ("docs/a.md", "# A\n"), ("tests/reference/a.csv", "# A\n"), ("scripts/requirements.txt", "# A\n")):
            self.assertEqual([], self.faults_with(name, text), name)

    def test_wrong(self):
        """No line, a line too low, another licence, and the wrong kind of comment."""
        for name, text in (("src/base/a.f90", "!> A.\n"), ("src/a.f90", ""), ("tests/base/a.pf", f"! A.\n! {LICENCE}\n"),
                           ("src/c/a.c", f"// {LICENCE}\n"), ("bench/a.py", "# SPDX-License-Identifier: MIT\n"),
                           ("scripts/a", "#!/usr/bin/env bash\nset -e\n")):
            self.assertEqual([name], [fault.split(":")[0] for fault in self.faults_with(name, text)], name)


if __name__ == "__main__":
    unittest.main()
