# SPDX-License-Identifier: GPL-3.0-or-later
"""One version everywhere: CMakeLists.txt has it, and CITATION.cff, CHANGELOG.md and the Python package say the same.

A version is released when CHANGELOG.md has an entry `## [X.Y.Z] - DATE`; CITATION.cff has that date then. Before, the entry
`## [Unreleased]` says `To become X.Y.Z.`, and CITATION.cff has no date.
"""

import re
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
VERSION = r"(\d+\.\d+\.\d+)"


def found_in(path, pattern):
    """What stands in the first place of a file that has this form, or None; so it is where there is no file."""
    match = re.search(pattern, path.read_text(), re.MULTILINE) if path.exists() else None
    return match and match[1]


def faults_of(root):
    """Everything that does not agree with CMakeLists.txt, as FILE: what is wrong."""
    version = found_in(root / "CMakeLists.txt", rf"^project\(adfric VERSION {VERSION}\b")
    changes = root / "CHANGELOG.md"
    date = found_in(changes, rf"^## \[{re.escape(str(version))}\] - (\d{{4}}-\d\d-\d\d)$")
    latest = found_in(changes, rf"^## \[{VERSION}\]")
    planned = found_in(changes, rf"^## \[Unreleased\]\n+To become {VERSION}\.$")
    cited = root / "CITATION.cff"
    given = found_in(root / "pyproject.toml", r"^version *= *\"([^\"]*)\"")
    checks = (
        (version, "CMakeLists.txt: no version"),
        (latest == version if date else planned == version,
         f"CHANGELOG.md: {version} is neither the latest version with a date nor what `To become ...` says"),
        (found_in(cited, r"^version: (.*)$") == version, f"CITATION.cff: version is not {version}"),
        (found_in(cited, r"^date-released: (.*)$") == date, f"CITATION.cff: date-released is not {date}, as in CHANGELOG.md"),
        (given in (None, version), f"pyproject.toml: version is not {version}"))
    return [fault for is_right, fault in checks if not is_right]


class Versions(unittest.TestCase):
    """The files as they are, and files that differ."""

    def test_files(self):
        """All say the same."""
        self.assertEqual([], faults_of(ROOT))

    def check(self, cited, changes, *expected, package=None):
        """Which files differ from a version 1.2.3."""
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            (root / "CMakeLists.txt").write_text("cmake_minimum_required(VERSION 3.22)\nproject(adfric VERSION 1.2.3)\n")
            (root / "CITATION.cff").write_text(f"cff-version: 1.2.0\n{cited}\n")
            (root / "CHANGELOG.md").write_text(f"# Changelog\n\n{changes}\n")
            if package:
                (root / "pyproject.toml").write_text(f"[project]\n{package}\n")
            self.assertEqual(expected, tuple(fault.split(":")[0] for fault in faults_of(root)))

    def test_right(self):
        """Before and at a release, and with a package that has its version from CMakeLists.txt or says it."""
        planned = "## [Unreleased]\n\nTo become 1.2.3.\n\n## [1.2.2] - 2026-01-02"
        self.check("version: 1.2.3", planned)
        self.check("version: 1.2.3\ndate-released: 2026-02-03",
                   "## [Unreleased]\n\n## [1.2.3] - 2026-02-03\n\n## [1.2.2] - 2026-01-02")
        self.check("version: 1.2.3", planned, package='dynamic = ["version"]')
        self.check("version: 1.2.3", planned, package='version = "1.2.3"')

    def test_wrong(self):
        """Each file that differs, and dates that do."""
        planned = "## [Unreleased]\n\nTo become 1.2.3."
        self.check("version: 1.2.2", planned, "CITATION.cff")
        self.check("", planned, "CITATION.cff")
        self.check("version: 1.2.3\ndate-released: 2026-02-03", planned, "CITATION.cff")
        self.check("version: 1.2.3", "## [1.2.3] - 2026-02-03", "CITATION.cff")
        self.check("version: 1.2.3", "## [Unreleased]\n\nTo become 1.3.0.", "CHANGELOG.md")
        self.check("version: 1.2.3\ndate-released: 2026-02-03", "## [1.3.0] - 2026-03-04\n\n## [1.2.3] - 2026-02-03",
                   "CHANGELOG.md")
        self.check("version: 1.2.3", planned, "pyproject.toml", package='version = "1.2.2"')


if __name__ == "__main__":
    unittest.main()
