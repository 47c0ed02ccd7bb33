"""The script that builds the program, and what CMake says of compilers and warnings."""

import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

# Stands for CMake: notes how it was called, and builds a program of which it is known that it is new.
CMAKE = """#!/bin/sh
echo "$*" >>"$CALLS"
case $1 in
--build) mkdir -p build/release && echo new >build/release/adfric ;;
esac
"""

CALLER = """cmake_minimum_required(VERSION 3.22)
project(trial LANGUAGES C Fortran)
list(APPEND CMAKE_MODULE_PATH "{root}/cmake")
include(AdfricOptions)
add_library(trial STATIC unused.f90)
adfric_set_flags(trial)
"""

UNUSED = """module unused
   implicit none (type, external)
contains
   subroutine idle()
      integer :: nothing
   end subroutine idle
end module unused
"""


class TreeTest(unittest.TestCase):
    """Scripts in a tree of their own, with a CMake that only notes how it is called."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.tree = Path(folder.name)
        self.calls = self.tree / "calls"
        (self.tree / "scripts").mkdir()
        (self.tree / "bin").mkdir()
        (self.tree / "CMakePresets.json").write_text("{}")
        for name in ("build", "install"):
            shutil.copy(ROOT / "scripts" / name, self.tree / "scripts" / name)
        self.write_program("scripts/setup", "#!/bin/sh\n")
        self.write_program("bin/cmake", CMAKE)
        self.program = self.tree / "build/release/adfric"
        self.program.parent.mkdir(parents=True)
        self.program.write_text("old\n")

    def write_program(self, name, text):
        """Write a script that can be run."""
        (self.tree / name).write_text(text)
        (self.tree / name).chmod(0o755)

    def run_script(self, name, *arguments):
        """Run one of them in the tree."""
        path = f"{self.tree / 'bin'}:{os.environ['PATH']}"
        return subprocess.run([self.tree / "scripts" / name, *arguments], capture_output=True, text=True, check=False,
                              cwd=self.tree, env={**os.environ, "PATH": path, "CALLS": str(self.calls)})


class BuildScriptTest(TreeTest):
    """scripts/build."""

    def build(self, *arguments):
        """Run it."""
        return self.run_script("build", *arguments)

    def test_log_that_cannot_be_written(self):
        """It is a failure, and no CMake is run."""
        (self.tree / "build/release.log").mkdir()
        done = self.build()
        self.assertEqual(1, done.returncode)
        self.assertIn("build: cannot write the log build/release.log; nothing was built\n", done.stderr)
        self.assertFalse(self.calls.exists())
        self.assertEqual("old\n", self.program.read_text())

    def test_failure(self):
        """A failure of CMake is one of the script, which shows the log."""
        self.write_program("bin/cmake", "#!/bin/sh\necho no such thing\nexit 5\n")
        done = self.build()
        self.assertEqual(1, done.returncode)
        self.assertIn("no such thing\n", done.stderr)

    def test_program_alone(self):
        """Tests are built when they are asked for."""
        self.assertEqual(0, self.build().returncode)
        self.assertEqual("--preset release\n--build --preset release --target adfric\n", self.calls.read_text())
        self.assertEqual("new\n", self.program.read_text())
        self.calls.unlink()
        self.assertEqual(0, self.build("release", "--tests").returncode)
        self.assertEqual("--preset release\n--build --preset release\n", self.calls.read_text())

    def test_unknown_words(self):
        """They are refused."""
        for arguments in (["fast"], ["release", "debug"], ["--test"]):
            done = self.build(*arguments)
            self.assertEqual(2, done.returncode)
            self.assertIn("usage: ", done.stderr)
        self.assertFalse(self.calls.exists())


class InstallScriptTest(TreeTest):
    """scripts/install."""

    def test_prefix(self):
        """A relative folder is seen from where the command is given; the folder that is missing in the path is named."""
        for prefix in ("there", str(self.tree / "there")):
            self.calls.write_text("")
            done = self.run_script("install", prefix)
            self.assertEqual(0, done.returncode, done.stderr)
            self.assertIn(f"--install {self.tree}/build/release --prefix {self.tree}/there\n", self.calls.read_text())
            self.assertIn(f"install: {self.tree}/there/bin/adfric\n", done.stdout)
            self.assertIn(f'export PATH="{self.tree}/there/bin:$PATH"', done.stdout)

    def test_path(self):
        """Nothing is said of a folder that is in the path."""
        self.assertNotIn("PATH", self.run_script("install", str(self.tree)).stdout)

    def test_failures(self):
        """A program that cannot be built or copied is not installed."""
        self.write_program("bin/cmake", '#!/bin/sh\n[ "$1" != --install ] || { echo no room; exit 1; }\n')
        done = self.run_script("install", "there")
        self.assertEqual((3, ""), (done.returncode, done.stdout))
        self.assertIn("no room\ninstall: could not install to ", done.stderr)
        self.write_program("bin/cmake", "#!/bin/sh\nexit 1\n")
        self.assertEqual((1, ""), (self.run_script("install").returncode, self.run_script("install", "there").stdout))
        self.assertEqual(2, self.run_script("install", "--prefix=there").returncode)
        self.assertEqual(2, self.run_script("install", "a", "b").returncode)


class CompilerTest(unittest.TestCase):
    """Compilers and warnings."""

    def ask(self, name, version):
        """What CMake says of a compiler."""
        with tempfile.TemporaryDirectory() as folder:
            script = Path(folder, "ask.cmake")
            script.write_text(f'set(CMAKE_Fortran_COMPILER_ID "{name}")\nset(CMAKE_Fortran_COMPILER_VERSION "{version}")\n'
                              f'set(CMAKE_Fortran_COMPILER /bin/compiler)\n'
                              f'include("{ROOT}/cmake/AdfricCompiler.cmake")\nadfric_check_compiler()\n')
            return subprocess.run(["cmake", "-P", script], capture_output=True, text=True, check=False)

    def test_compilers(self):
        """gfortran from 11 on; what is refused is named."""
        for version in ("11.0.1", "11.4.0", "12.2.0", "15.1.0"):
            self.assertEqual(0, self.ask("GNU", version).returncode)
        for name, version in (("GNU", "9.5.0"), ("GNU", "10.5.0"), ("IntelLLVM", "2024.1")):
            done = self.ask(name, version)
            self.assertNotEqual(0, done.returncode)
            said = " ".join(done.stderr.split())
            self.assertIn(f"adfric needs gfortran 11 or newer; found /bin/compiler, which is {name} {version}", said)

    def test_warnings(self):
        """A warning stops the build only where that is asked for."""
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "CMakeLists.txt").write_text(CALLER.format(root=ROOT))
            Path(folder, "unused.f90").write_text(UNUSED)
            for options, is_stopped in (([], False), (["-DADFRIC_WARNINGS_AS_ERRORS=ON"], True)):
                tree = Path(folder, "build")
                subprocess.run(["cmake", "-S", folder, "-B", tree, *options], capture_output=True, check=True)
                done = subprocess.run(["cmake", "--build", tree], capture_output=True, text=True, check=False)
                self.assertIn("unused-variable", done.stdout + done.stderr)
                self.assertEqual(is_stopped, done.returncode != 0)


if __name__ == "__main__":
    unittest.main()
