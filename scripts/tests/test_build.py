# SPDX-License-Identifier: GPL-3.0-or-later
"""The script that builds the program, and what CMake says of compilers and warnings."""

import json
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

    def run_script(self, name, *arguments, path=""):
        """Run one of them in the tree."""
        path = path or f"{self.tree / 'bin'}:{os.environ['PATH']}"
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
        self.calls.unlink()
        self.assertEqual(0, self.build("--library").returncode)
        self.assertEqual("--preset release\n--build --preset release --target installable\n", self.calls.read_text())

    def test_missing_libraries(self):
        """What CMake misses is said line by line, without the rest of its log; the next attempt looks anew."""
        self.write_program("bin/cmake", "#!/bin/sh\necho much\necho 'missing: GSL (Debian: libgsl-dev)'\necho 'missing: LAPACK'\nexit 1\n")
        cache = self.tree / "build/release/CMakeCache.txt"
        cache.write_text("")
        done = self.build()
        self.assertEqual(1, done.returncode)
        self.assertIn("\nbuild: missing: GSL (Debian: libgsl-dev)\nbuild: missing: LAPACK\nbuild: install it, load its module,", done.stderr)
        self.assertNotIn("much", done.stderr)
        self.assertFalse(cache.exists())

    def test_without_ninja(self):
        """Then make does."""
        for name in ("bash", "dirname", "flock", "mkdir", "nproc", "sh", "sed", "grep", "cat"):
            (self.tree / "bin" / name).symlink_to(shutil.which(name))
        done = self.run_script("build", path=str(self.tree / "bin"))
        self.assertEqual(0, done.returncode, done.stderr)
        self.assertRegex(self.calls.read_text(), r"^--preset release -G Unix Makefiles\n"
                         r"--build --preset release --target adfric --parallel \d+\n$")

    def test_unknown_words(self):
        """They are refused."""
        for arguments in (["fast"], ["release", "debug"], ["--test"]):
            done = self.build(*arguments)
            self.assertEqual(2, done.returncode)
            self.assertIn("usage: ", done.stderr)
        self.assertFalse(self.calls.exists())


class TestScriptTest(TreeTest):
    """scripts/test, with a build and a CTest that only note how they are called."""

    def calls_of(self, *arguments):
        """How both are called."""
        shutil.copy(ROOT / "scripts/test", self.tree / "scripts/test")
        self.write_program("scripts/build", '#!/bin/sh\necho "build $*" >>"$CALLS"\n')
        self.write_program("bin/ctest", '#!/bin/sh\necho "ctest $2" >>"$CALLS"\n')
        self.calls.unlink(missing_ok=True)
        done = self.run_script("test", *arguments)
        self.assertEqual(0, done.returncode, done.stderr)
        return self.calls.read_text().splitlines()

    def test_presets(self):
        """A whole run leaves debug to sanitize, which has all its checks."""
        self.assertEqual(["build release --tests", "ctest release", "build sanitize --tests", "ctest sanitize", "build gfortran11 --tests", "ctest gfortran11"], self.calls_of())
        self.assertEqual(["build debug --tests", "ctest debug"], self.calls_of("debug"))

    def test_nothing_is_left_out(self):
        """Sanitize has the tests of debug, but for those that only run the program many times, with the same environment and flags."""
        presets = json.loads((ROOT / "CMakePresets.json").read_text())
        of = {preset["name"]: preset for preset in presets["testPresets"]}
        left_out, of_sanitize = (set(of[name]["filter"]["exclude"]["name"].split("|")) for name in ("debug", "sanitize"))
        self.assertEqual(of_sanitize, left_out | {"_inputs", "^report$", "force_map"})
        self.assertEqual(of["debug"]["environment"]["ADFRIC_RANDOM_CASES"], of["sanitize"]["environment"]["ADFRIC_RANDOM_CASES"])
        self.assertIn("malloc_fill_byte=127", of["sanitize"]["environment"]["ASAN_OPTIONS"])
        types = {preset["name"]: preset.get("cacheVariables", {}).get("CMAKE_BUILD_TYPE") for preset in presets["configurePresets"]}
        self.assertEqual(types["debug"], types["sanitize"])


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
        self.assertIn("install: could not install to ", done.stderr)
        self.assertEqual("no room\n", (self.tree / "build/install.log").read_text())
        self.write_program("bin/cmake", "#!/bin/sh\nexit 1\n")
        self.assertEqual((1, ""), (self.run_script("install").returncode, self.run_script("install", "there").stdout))
        self.assertEqual(2, self.run_script("install", "--prefix=there").returncode)
        self.assertEqual(2, self.run_script("install", "a", "b").returncode)

    def test_prefix_that_cannot_be_written(self):
        """It is told in one line, before anything is built."""
        (self.tree / "file").write_text("")
        (self.tree / "closed").mkdir()
        (self.tree / "closed").chmod(0o555)
        # root may write everywhere but where there is a file
        for prefix in ("file", "file/below", *(["closed", "closed/below"] if os.geteuid() else [])):
            done = self.run_script("install", prefix)
            self.assertEqual((3, "", 1), (done.returncode, done.stdout, done.stderr.count("\n")), done.stderr)
            self.assertRegex(done.stderr, f"^install: cannot .*{self.tree}/{prefix}")
        self.assertFalse(self.calls.exists())


class SetupScriptTest(unittest.TestCase):
    """scripts/setup where no package can be installed."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.bin = Path(folder.name)
        for name in ("bash", "cat", "dirname", "env", "grep", "mktemp", "rm", "touch", "true"):
            (self.bin / name).symlink_to(shutil.which(name))
        # a Debian on which nothing is installed, and a user like all others
        self.write_program("id", 'case $1 in -u) echo 1000 ;; *) echo people ;; esac')
        self.write_program("dpkg-query", "exit 1")
        self.write_program("apt-get", f'touch "{self.bin}/called"')

    def write_program(self, name, text):
        """Write a program of the machine."""
        (self.bin / name).write_text(f"#!/bin/sh\n{text}\n")
        (self.bin / name).chmod(0o755)

    def set_up(self, *arguments):
        """Run it on this machine."""
        return subprocess.run([ROOT / "scripts/setup", *arguments], capture_output=True, text=True, check=False,
                              stdin=subprocess.DEVNULL, env={"PATH": str(self.bin)})

    def test_missing_tools(self):
        """Each has a line with its package and its module; nobody is asked for a password."""
        for sudo in (False, True):
            if sudo:
                self.write_program("sudo", f'[ "$1" = --non-interactive ] && exit 1\ntouch "{self.bin}/called"')
            done = self.set_up("system")
            self.assertEqual(1, done.returncode)
            self.assertEqual("setup: missing: gfortran (Debian: gfortran, module: gcc)\n"
                             "setup: missing: CMake 3.22 or newer (Debian: cmake, module: cmake)\n"
                             "setup: missing: Ninja or make (Debian: ninja-build, module: ninja)\n"
                             "setup: no package can be installed here: load the module of what is missing, or build it "
                             "(docs/guide/clusters.md)\n", done.stderr)
        self.assertFalse((self.bin / "called").exists())

    def test_tools_of_modules(self):
        """Nothing is missing where the tools are there, whatever the packages are; make does for Ninja."""
        for name in ("gfortran", "cmake", "make"):
            self.write_program(name, "exit 0")
        done = self.set_up("system")
        self.assertEqual((0, ""), (done.returncode, done.stderr))
        self.assertFalse((self.bin / "called").exists())

    def test_sudo(self):
        """Who is let through by sudo installs packages by it."""
        self.write_program("sudo", '[ "$1" != --non-interactive ] || shift\nexec "$@"')
        done = self.set_up("system")
        self.assertEqual(0, done.returncode, done.stderr)
        self.assertIn("setup: installing gfortran cmake ninja-build libhdf5-dev", done.stderr)
        self.assertTrue((self.bin / "called").exists())


class LibrariesTest(unittest.TestCase):
    """What CMake says of libraries that are missing."""

    def test_all_are_named(self):
        """Each has a line, with its package and its module."""
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run(["cmake", "-S", ROOT, "-B", folder, "-DCMAKE_DISABLE_FIND_PACKAGE_GSL=TRUE",
                                   "-DCMAKE_DISABLE_FIND_PACKAGE_HDF5=TRUE", "-DBUILD_TESTING=OFF"],
                                  capture_output=True, text=True, check=False)
        self.assertNotEqual(0, done.returncode)
        self.assertEqual(["missing: GSL (Debian: libgsl-dev, Fedora: gsl-devel, module: gsl)",
                          "missing: HDF5 with its interfaces Fortran and HL (Debian: libhdf5-dev, Fedora: hdf5-devel, module: hdf5)"],
                         [line for line in done.stderr.splitlines() if line.startswith("missing: ")])


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
