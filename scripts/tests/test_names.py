# SPDX-License-Identifier: GPL-3.0-or-later
"""Names of files that a terminal would obey are shown, not obeyed."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPTS = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(SCRIPTS))

from plotting.printable import printable  # noqa: E402

ODD = b"\x1b[2J\xc2\x9b\xe2\x80\xae\xff.h5"


class Names(unittest.TestCase):
    def test_printable(self):
        self.assertEqual(printable("a ~\\ä€"), "a ~\\ä€")
        self.assertEqual(printable(os.fsdecode(ODD)), "\\x1b[2J\\u009b\\u202e\\xff.h5")
        self.assertEqual(printable("a\nb"), "a\\x0ab")

    def run_script(self, *command, cwd=None, **environment):
        done = subprocess.run(command, capture_output=True, cwd=cwd, env=dict(os.environ, LC_ALL="C.UTF-8", **environment))
        for stream in (done.stdout, done.stderr):
            self.assertNotIn(b"\x1b", stream)
            self.assertNotIn(b"\xc2\x9b", stream)
            self.assertNotIn(b"\xe2\x80\xae", stream)
        return done

    def test_plot(self):
        done = self.run_script(sys.executable, SCRIPTS / "plot.py", ODD)
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.stderr.count(b"\n"), 1)
        self.assertIn(b"\\x1b[2J", done.stderr)
        self.assertEqual(self.run_script(sys.executable, SCRIPTS / "plot.py", b"a.h5", ODD).returncode, 2)

    def test_run(self):
        done = self.run_script(SCRIPTS / "run", ODD)
        self.assertEqual(done.returncode, 2)
        self.assertIn(b"no such file", done.stderr)
        self.assertEqual(done.stderr.count(b"\n"), 1)

    def test_slurm_array(self):
        for arguments in ([ODD], [b"a.nml", ODD], [b"a.nml", b"1", ODD]):
            with tempfile.TemporaryDirectory() as folder:
                (Path(folder) / os.fsdecode(ODD)).touch()
                done = self.run_script(SCRIPTS / "slurm_array.sh", *arguments, cwd=folder, ADFRIC="/bin/true")
                self.assertEqual(done.returncode, 2)
        self.assertIn(b"exists: the sweep is done", done.stderr)


if __name__ == "__main__":
    unittest.main()
