# SPDX-License-Identifier: GPL-3.0-or-later
"""The wheel of the Python package in a fresh environment, where there is no compiler and no library of this machine is used but
those that every Linux has."""

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from runs import main

SOURCE = Path(os.environ["ADFRIC_SOURCE"])
TOOLS = SOURCE/".venv_wheel/bin/python"
# versions of what is installed, so that the test is the same tomorrow
PINS = [word for name in ("requirements", "requirements_import", "requirements_tests", "requirements_tutorial")
        for word in ("--constraint", SOURCE/f"scripts/{name}.txt")]
# libraries of the C library and of the compiler's run time, as PEP 600 lets a wheel use them
OF_LINUX = re.compile(r"(linux-vdso|ld-linux[\w-]*|libc|libm|libmvec|libdl|libpthread|librt|libresolv|libgcc_s|libstdc\+\+|libz)\.so")


def run(*words, **options):
    """What a command has printed that must succeed."""
    done = subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False,
                          **options)
    assert done.returncode == 0, done.stdout
    return done.stdout


@unittest.skipUnless(TOOLS.exists(), "scripts/setup tests could not make .venv_wheel")
class Wheel(unittest.TestCase):
    """The wheel, installed."""

    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = Path(temporary.name)
        run(SOURCE/"scripts/wheel", "--quick", cls.folder/"wheels")
        (cls.wheel,) = (cls.folder/"wheels").glob("*.whl")
        run(sys.executable, "-m", "venv", cls.folder/"fresh")
        cls.bin = cls.folder/"fresh/bin"
        run(cls.bin/"python", "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--only-binary", ":all:", *PINS,
            f"{cls.wheel}[plot,surfaces]", "pint-xarray", "nbclient", "ipykernel")
        # nothing but this environment is found
        cls.alone = {"PATH": str(cls.bin), "HOME": str(cls.folder), "ADFRIC_SOURCE": str(SOURCE), "OMP_NUM_THREADS": "2",
                     "MPLBACKEND": "Agg", "PYTHONDONTWRITEBYTECODE": "1"}

    def test_package(self):
        """All tests of the package, none of them skipped."""
        shown = run(self.bin/"python", "-m", "unittest", "discover", "-s", SOURCE/"tests/python", env=self.alone, cwd=self.folder)
        self.assertRegex(shown, r"\nOK\n$")

    def test_tutorial(self):
        """The notebook prints what docs/guide/tutorial.md shows."""
        run(self.bin/"python", SOURCE/"scripts/tutorial.py", env={key: self.alone[key] for key in ("PATH", "HOME", "OMP_NUM_THREADS")})

    def test_command(self):
        shown = run(self.bin/"adfric", "run", SOURCE/"inputs/hertz_axes.nml", env=self.alone, cwd=self.folder)
        self.assertIn("solved", shown)
        self.assertTrue((self.folder/"hertz_axes.h5").is_file())

    def test_libraries(self):
        """Other libraries come with the wheel."""
        for path in self.folder.glob("fresh/lib/python*/site-packages/adfric/*/*adfric*"):
            for name, place in re.findall(r"(\S+) => (\S+)", run("ldd", path)):
                self.assertTrue(OF_LINUX.match(name) or "/adfric" in place, f"{path.name}: {name} => {place}")

    def test_version(self):
        version = re.search(r"project\(adfric VERSION ([0-9.]+)", (SOURCE/"CMakeLists.txt").read_text())[1]
        self.assertTrue(self.wheel.name.startswith(f"adfric-{version}-py3-none-manylinux"), self.wheel.name)


if __name__ == "__main__":
    main()
