# SPDX-License-Identifier: GPL-3.0-or-later
"""What `cmake --install` puts into a prefix: it works wherever the prefix is, and programs outside the tree are built with it."""

import os
import re
import shlex
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(os.environ["ADFRIC_SOURCE"])
TREE = Path(os.environ["ADFRIC_PROGRAM"]).parent
OUTSIDE = SOURCE / "tests/program/installed"
COMPILER = os.environ["ADFRIC_COMPILER"]
# programs of the folder `installed`, by the part of the library that they use
PROGRAMS = {"use_physics": "adfric_physics", "use_run": "adfric", "use_c": "adfric"}
if shutil.which("c++"):
    PROGRAMS["use_cpp"] = "adfric"


def run(*words, folder=None, **variables):
    """Run a command, whatever its status."""
    return subprocess.run([str(word) for word in words], cwd=folder, env={**os.environ, **variables}, text=True, check=False,
                          capture_output=True)


class Installed(unittest.TestCase):
    """A prefix with blanks in its name, to which it was moved after the installation."""

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.temporary.cleanup)
        cls.room = Path(cls.temporary.name)
        cls.keep_manifest()
        first, cls.prefix = cls.room / "first", cls.room / "a prefix"
        cls.install(first)
        # a second time is as good as the first
        before = contents(first)
        cls.install(first)
        assert contents(first) == before
        first.rename(cls.prefix)

    @classmethod
    def keep_manifest(cls):
        """What was installed before this test can be taken away after it."""
        manifest = TREE / "install_manifest.txt"
        if manifest.exists():
            cls.addClassCleanup(manifest.write_bytes, manifest.read_bytes())
        else:
            cls.addClassCleanup(manifest.unlink)

    @classmethod
    def install(cls, prefix, **variables):
        """Install the build tree."""
        done = run("cmake", "--install", TREE, "--prefix", prefix, **variables)
        assert done.returncode == 0, done.stderr

    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(dir=self.room))

    def succeed(self, *words, **options):
        """What a command that must succeed has printed."""
        done = run(*words, **options)
        self.assertEqual(0, done.returncode, done.stdout + done.stderr)
        return done.stdout

    def check_program(self, path):
        """A program of ours runs, in a folder of its own."""
        folder = Path(tempfile.mkdtemp(dir=self.room))
        part = path.name.removeprefix("use_")
        self.assertRegex(self.succeed(path, folder=folder), rf"^{part} [0-9.]+\n$")

    def configure(self, prefix, *options, source=OUTSIDE):
        """Configure the programs outside the tree."""
        return run("cmake", "-G", "Ninja", "-S", source, "-B", self.folder / "build", f"-DCMAKE_Fortran_COMPILER={COMPILER}",
                   f"-DCMAKE_PREFIX_PATH={prefix}", *options)

    def build(self, prefix, *options, source=OUTSIDE):
        """Configure and build the programs outside the tree."""
        self.folder = Path(tempfile.mkdtemp(dir=self.room))
        done = self.configure(prefix, *options, source=source)
        self.assertEqual(0, done.returncode, done.stderr)
        self.succeed("cmake", "--build", self.folder / "build")


class PrefixTest(Installed):
    """The files of the prefix."""

    def test_program(self):
        """The program runs, though it was moved."""
        said = self.succeed(self.prefix / "bin/adfric", "--version")
        self.assertEqual(self.succeed(TREE / "adfric", "--version"), said)
        self.succeed(self.prefix / "bin/adfric", "check", self.prefix / "share/adfric/inputs/johnson1997_fig5.nml")

    def test_no_place_of_the_build(self):
        """No file of the packages names the tree, where it was built or where it was installed first."""
        for path in [*self.prefix.rglob("*.cmake"), *self.prefix.rglob("*.pc")]:
            for place in (SOURCE, TREE, self.room):
                self.assertNotIn(str(place), path.read_text(), path)

    def test_run_path(self):
        """Neither the program nor a library looks for libraries in the build tree."""
        for path in [self.prefix / "bin/adfric", *self.prefix.glob("lib*/**/libadfric*.so")]:
            header = self.succeed("readelf", "--dynamic", path)
            self.assertNotIn(str(TREE), header)

    def test_staging(self):
        """DESTDIR stands before every name, and whatever was installed can be taken away."""
        stage = self.folder / "stage"
        self.install("/opt/of/adfric", DESTDIR=str(stage))
        self.assertEqual(contents(self.prefix), contents(stage / "opt/of/adfric"))
        other = stage / "opt/of/adfric/share/adfric/inputs/own.nml"
        other.write_text("")
        self.succeed("cmake", f"-DMANIFEST={TREE}/install_manifest.txt", "-P", SOURCE / "cmake/uninstall.cmake", DESTDIR=str(stage))
        self.assertEqual([other], [path for path in stage.rglob("*") if not path.is_dir()])


class CMakeTest(Installed):
    """find_package(adfric)."""

    def test_kinds(self):
        """Programs are built with either kind, and run; of physics alone without HDF5."""
        for options, is_shared in (([], True), (["-DKIND=shared", "-Dadfric_USE_STATIC_LIBS=ON"], True), (["-DKIND=static"], False),
                                   (["-Dadfric_USE_STATIC_LIBS=ON"], False)):
            self.build(self.prefix, *options)
            for name in PROGRAMS:
                self.check_program(self.folder / "build" / name)
                needs = self.succeed("readelf", "--dynamic", self.folder / "build" / name)
                self.assertEqual(is_shared, "libadfric" in needs, options)
        self.build(self.prefix, "-DPARTS=physics", "-DKIND=static", "-DCMAKE_DISABLE_FIND_PACKAGE_HDF5=TRUE")

    def test_without_fortran(self):
        """A project of C and C++ alone takes the shared library."""
        self.build(self.prefix, "-DPARTS=c", "-DLANGUAGES=C")
        for name in PROGRAMS.keys() & {"use_c", "use_cpp"}:
            self.check_program(self.folder / "build" / name)

    def test_build_tree(self):
        """The build tree is found as a prefix is."""
        self.build(TREE, "-DPARTS=physics", "-DKIND=static")
        self.check_program(self.folder / "build/use_physics")

    def check_refused(self, done, reason):
        """CMake has ended with a reason in one sentence."""
        self.assertNotEqual(0, done.returncode)
        self.assertIn(reason, " ".join(done.stderr.split()))

    def test_other_compiler(self):
        """Modules of another compiler are refused; here it is the package that pretends to be another one's."""
        copy = self.folder / "copy"
        shutil.copytree(self.prefix, copy, symlinks=True)
        config, = copy.rglob("adfricConfig.cmake")
        text = config.read_text()
        other = re.sub(r"GNU( Fortran)? [0-9]+", r"GNU\1 5", text)
        self.assertNotEqual(text, other)
        config.write_text(other)
        self.check_refused(self.configure(copy), "adfric was built with GNU Fortran 5, and this project has GNU")

    def test_unknown_component(self):
        """What is not there is named, with what is."""
        self.check_refused(self.configure(self.prefix, "-DPARTS=friction"),
                           "adfric has no component friction here, known are physics run c static shared")

    def test_no_fortran(self):
        """A project without Fortran is told so."""
        (self.folder / "CMakeLists.txt").write_text("cmake_minimum_required(VERSION 3.22)\nproject(c LANGUAGES C)\n"
                                                    "find_package(adfric REQUIRED)\n")
        self.check_refused(self.configure(self.prefix, source=self.folder), "has not enabled the language Fortran")


@unittest.skipUnless(shutil.which("pkg-config"), "there is no pkg-config")
class PkgConfigTest(Installed):
    """adfric.pc and adfric_physics.pc."""

    def compile(self, prefix, name, *options):
        """Build a program as one does with a makefile, by the compiler of its language."""
        source = next(OUTSIDE.glob(f"{name}.*"))
        compiler = {".c": "cc", ".cpp": "c++"}.get(source.suffix, COMPILER)
        package, = prefix.glob("lib*/**/pkgconfig")
        flags = self.succeed("pkg-config", "--cflags", "--libs", *options, PROGRAMS[name], PKG_CONFIG_PATH=str(package))
        self.succeed(compiler, source, "-o", self.folder / name, *shlex.split(flags), *["-lm"] * (source.suffix == ".c"),
                     folder=self.folder)
        return self.folder / name

    def test_kinds(self):
        """Programs are built with shared libraries, and with static ones where there are no others."""
        alone = self.folder / "alone"
        shutil.copytree(self.prefix, alone, symlinks=True)
        for path in alone.rglob("libadfric*.so*"):
            path.unlink()
        for name in PROGRAMS:
            self.check_program(self.compile(self.prefix, name))
            self.check_program(self.compile(alone, name, "--static"))


@unittest.skipUnless((SOURCE / "examples/CMakeLists.txt").exists(), "there are no examples")
class ExamplesTest(Installed):
    """Every example of the documents."""

    def test_by_cmake(self):
        """They are built outside the tree with either kind, and run."""
        for is_static in ("OFF", "ON"):
            self.build(self.prefix, f"-Dadfric_USE_STATIC_LIBS={is_static}", source=SOURCE / "examples")
            for path in every_example():
                self.succeed(self.folder / "build" / path.stem, folder=self.folder)

    @unittest.skipUnless(shutil.which("pkg-config"), "there is no pkg-config")
    def test_by_pkg_config(self):
        """They are built by one command each, and run."""
        package, = self.prefix.glob("lib*/**/pkgconfig")
        flags = self.succeed("pkg-config", "--cflags", "--libs", "adfric", PKG_CONFIG_PATH=str(package))
        for path in every_example():
            compiler, more = ("cc", ["-lm"]) if path.suffix == ".c" else (COMPILER, [])
            self.succeed(compiler, path, "-o", self.folder / path.stem, *shlex.split(flags), *more, folder=self.folder)
            self.succeed(self.folder / path.stem, folder=self.folder)


@unittest.skipUnless(shutil.which("man"), "there is no man")
class ManualTest(Installed):
    """man adfric."""

    def test_page(self):
        """It is set without a warning, and has the version and every command and option of the program, and no other."""
        page = self.prefix / "share/man/man1/adfric.1"
        done = run("man", "--warnings", "--local-file", page, MANWIDTH="100", LC_ALL="C.UTF-8", MAN_KEEP_FORMATTING="")
        self.assertEqual((0, ""), (done.returncode, done.stderr))
        text = re.sub(".\b", "", done.stdout).replace("\u2010", "-")
        self.assertIn(self.succeed(TREE / "adfric", "--version").split()[1], text)
        said = self.succeed(TREE / "adfric", "help")
        self.assertEqual(known_options(), options_of(text))
        self.assertLessEqual(options_of(said), options_of(text))
        commands = set(re.findall(r"^ +adfric ([a-z]+)", said, re.MULTILINE))
        self.assertEqual(commands, set(re.findall(r"^ +(?:adfric )?([a-z]+) (?:INPUT|FILE|\[TOPIC)", text, re.MULTILINE)))
        for status in re.findall(r"\b(\d+) (?:every|some|bad|file|SIGHUP|Ctrl|SIGTERM)", said):
            self.assertRegex(text, rf"(?m)^ +(\d+, )*{status}\b")


class CompletionTest(Installed):
    """Completion in the shells."""

    def complete(self, line):
        """What bash offers for the last word of a line."""
        (self.folder / "inner").mkdir(exist_ok=True)
        for name in ("first case.nml", "first.h5", "other.txt"):
            (self.folder / name).write_text("")
        words = line.split(" ")
        script = (f'. "{self.prefix}/share/bash-completion/completions/adfric"\nCOMP_WORDS=({shlex.join(words)})\n'
                  f"COMP_CWORD={len(words) - 1}\n_adfric\nprintf '%s\\n' \"${{COMPREPLY[@]}}\"\n")
        return set(self.succeed("bash", "-c", script, folder=self.folder,
                                PATH=f"{self.prefix}/bin:{os.environ['PATH']}").split("\n")) - {""}

    def test_words(self):
        """Commands and options are those of the program."""
        refused = run(TREE / "adfric", "draw").stderr.split("allowed: ")[1]
        self.assertEqual(set(refused.split(";")[0].split()), self.complete("adfric "))
        offered = set.union(*(self.complete(f"adfric {command}--") for command in ("", "run ", "merge ", "check ", "help ")))
        self.assertEqual(known_options(), offered)
        for command in ("run", "merge"):
            for option in self.complete(f"adfric {command} --") - {"--help"}:
                value = {"--output": ["a.h5"], "--shard": ["1/2"]}.get(option, [])
                done = run(TREE / "adfric", command, option, *value, "absent.nml", "absent.h5", folder=self.folder)
                self.assertNotIn("is an option of", done.stderr)
        self.assertEqual({"--virtual"}, self.complete("adfric merge a.h5 --v"))

    def test_files(self):
        """Inputs for what reads inputs, results files for what reads or writes these; and folders."""
        self.assertEqual({"inner", "first case.nml"}, self.complete("adfric run "))
        self.assertEqual({"first case.nml"}, self.complete("adfric check --quiet fi"))
        self.assertEqual({"inner", "first.h5"}, self.complete("adfric merge all.h5 "))
        self.assertEqual({"inner", "first.h5"}, self.complete("adfric run --output "))

    def test_topics(self):
        """Every topic that is offered has a page, and models, groups, variables and results are among them."""
        topics = self.complete("adfric help ")
        self.assertLessEqual({"models", "input", "outputs", "sphere", "surface_elastic", "foundation", "load", "contact_area"}, topics)
        for topic in sorted(topics)[::10]:
            self.succeed(TREE / "adfric", "help", topic)
        self.assertEqual({"wave_1d", "wave_1d_elastic", "wave_2d", "wave_2d_elastic", "wave_3d", "wave_numbers", "wave_product"},
                         self.complete("adfric help wave_"))

    @unittest.skipUnless(shutil.which("zsh"), "there is no zsh")
    def test_zsh(self):
        """A real zsh completes commands, options, files and topics."""
        for line, offered in (("adfric mer", "merge"), ("adfric run --outp", "--output"), ("adfric check fir", "first"),
                              ("adfric help surface_el", "surface_elastic")):
            self.ask_zsh(line, offered)

    def ask_zsh(self, line, offered):
        """After the key of completion zsh shows a word, sooner or later; what moves the cursor or rings is not seen."""
        (self.folder / "first.nml").write_text("")
        script = ("zmodload zsh/zpty\nzpty shell zsh -f -i\n"
                  "zpty -w shell $'PS1=\"\" fpath=(\"$FUNCTIONS\" $fpath); autoload -U compinit; compinit -u -D; echo rea\"\"dy'\n"
                  "zpty -r -m shell all '*ready*'\n"
                  f"zpty -n -w shell {shlex.quote(line)}$'\\t'\n"
                  f"seen=\nfor ((i = 0; i < 600; i++)); do\n[[ ${{seen//[[:cntrl:]]/}} == *{offered}* ]] && break\n"
                  "sleep 0.1; part=; zpty -r -t shell part && seen+=$part\ndone\n"
                  "zpty -d shell\nprint -r -- $seen\n(( i < 600 ))\n")
        self.succeed("zsh", "-f", "-c", script, folder=self.folder, FUNCTIONS=str(self.prefix / "share/zsh/site-functions"),
                     PATH=f"{self.prefix}/bin:{os.environ['PATH']}", TERM="dumb")


def every_example():
    """The programs of the documents."""
    return sorted(path for path in (SOURCE / "examples").iterdir() if path.suffix in (".f90", ".c"))


def contents(folder):
    """Names of all files below a folder."""
    return sorted(str(path.relative_to(folder)) for path in folder.rglob("*") if not path.is_dir())


def options_of(text):
    """The options that a text names."""
    return set(re.findall(r"(?<![\w-])--[a-z][a-z-]*", text))


def known_options():
    """The options that the program says it knows."""
    return options_of(run(TREE / "adfric", "run", "--unknown").stderr.split("allowed: ")[1].split(";")[0])


if __name__ == "__main__":
    unittest.main()
