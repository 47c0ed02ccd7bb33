# SPDX-License-Identifier: GPL-3.0-or-later
"""Every script answers --help at once: nothing is installed, built or written, and no package is needed."""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPTS = Path(__file__).resolve().parents[1]
# what would install or build; none of them may be called
TOOLS = ("apt-get", "cmake", "cc", "gfortran", "ninja", "pip", "sudo", "mpirun", "sbatch")


class HelpTest(unittest.TestCase):
    """Scripts in a tree of their own, with a Python that has no packages and tools that tell that they were called."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        shutil.copytree(SCRIPTS, self.root / "tree/scripts", ignore=shutil.ignore_patterns("__pycache__", "tests"))
        (self.root / "tools").mkdir()
        for tool in TOOLS:
            self.write_tool(tool, f"echo {tool} >>'{self.root}/called'; exit 1")
        # -S leaves out everything that is installed beside Python itself
        self.write_tool("python3", f'exec "{sys._base_executable}" -S -s "$@"')
        self.environment = {"PATH": f"{self.root}/tools:{os.environ['PATH']}", "HOME": str(self.root),
                            "ADFRIC_PYTHON": str(self.root / "tools/python3")}

    def write_tool(self, name, line):
        """A command that does one line."""
        path = self.root / "tools" / name
        path.write_text(f"#!/bin/sh\n{line}\n")
        path.chmod(0o755)

    def test_every_script(self):
        """The help stands on standard output, and nothing is left behind."""
        names = [path.name for path in SCRIPTS.iterdir() if path.is_file() and path.read_bytes().startswith(b"#!")]
        self.assertGreater(len(names), 15)
        before = sorted(self.root.rglob("*"))
        for name in names:
            for option in ("--help", "-h"):
                with self.subTest(name=name, option=option):
                    done = subprocess.run([self.root / "tree/scripts" / name, option], cwd=self.root / "tree", env=self.environment,
                                          capture_output=True, text=True, check=False)
                    self.assertEqual(done.returncode, 0, done.stderr)
                    self.assertTrue(done.stdout.startswith("usage: scripts/"), done.stdout)
                    self.assertIn(name, done.stdout.split("\n")[0])
                    self.assertEqual(done.stderr, "")
        self.assertEqual(sorted(self.root.rglob("*")), before)


if __name__ == "__main__":
    unittest.main()
