# SPDX-License-Identifier: GPL-3.0-or-later
"""The folders of src/ and who may use whom: dependencies point one way, and a module is named by its path."""

import collections
import itertools
import re
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
# What stands in a line uses what stands in the lines above it, and itself. "" is src/ itself: which models there are.
LEVELS = (("base",), ("numerics", "system"), ("describe", "hdf5"), ("solid", "shape"), ("interface",), ("round", "plane", "foundation", "periodic"), ("rough",),
          ("contact", "fit"), ("",), ("run",), ("input", "output"), ("api", "command"), ("c",), ("drivers",))
LEVEL_OF = {folder: level for level, folders in enumerate(LEVELS) for folder in folders}
# The library adfric::physics, as CMakeLists.txt names its folders: it knows neither files nor processes.
PHYSICS = ("base", "numerics", "describe", "solid", "interface", "shape", "round", "plane", "foundation", "periodic", "rough", "contact", "fit", "")
NOT_FOR_PHYSICS = ("system", "hdf5")
# Modules from outside that a folder may use; bindings of libraries for numbers, and locks of threads, stand in numerics alone.
FOREIGN = {"physics": {"iso_fortran_env", "ieee_arithmetic"},
           "numerics": {"iso_fortran_env", "ieee_arithmetic", "iso_c_binding", "omp_lib"},
           "rest": {"iso_fortran_env", "ieee_arithmetic", "iso_c_binding", "omp_lib", "hdf5", "h5ds", "h5lt", "mpi_f08"}}
# Two files of one module, of which CMake takes one (cmake/AdfricMpi.cmake); and the library's interface, which has a short name.
ALTERNATIVES = {"run/world_mpi": "run/world", "run/world_serial": "run/world", "api/api": "api"}
# Folders of tests that are no folder of src/.
OTHER_TESTS = {"asserts", "hard", "program", "python", "old_inputs", "reference", "runner", "search", "selftest", "support"}
# The first module of a file, and what it uses.
MODULE = re.compile(r"^\s*(?:module|program)\s+(?!procedure\b)(\w+)\s*$", re.IGNORECASE)
USE = re.compile(r"^\s*use\b(?:\s*,\s*(?:non_)?intrinsic\s*)?(?:\s*::)?\s*(\w+)", re.IGNORECASE)


def files_of(root):
    """The sources and their folders; no folder of src/ has folders."""
    for folder in ("src", "drivers"):
        for path in sorted((root / folder).rglob("*.f90*")):
            yield path, ("drivers" if folder == "drivers" else "/".join(path.relative_to(root / "src").parts[:-1]))


def folder_of(module):
    """The folder of a module of the project, by its name; None for a module from outside."""
    if module in ("adfric", "adfric_api"):
        return module[len("adfric_"):]
    folder = re.match(r"adfric_([a-z0-9]+)_", module)
    return folder and folder[1].replace("driver", "drivers")


def name_by_path(path, root):
    """The name that a module of src/ has."""
    place = path.relative_to(root / "src").as_posix().split(".")[0]
    return "adfric_" * (place != "adfric") + ALTERNATIVES.get(place, place).replace("/", "_")


def fault_of_use(folder, module):
    """What is wrong with the use of a module in a folder; nothing if it is right."""
    other = folder_of(module)
    if other is None:
        kind = "numerics" if folder == "numerics" else "physics" if folder in PHYSICS else "rest"
        return "" if module in FOREIGN[kind] else f"{folder or 'src'} does not use {module}"
    if other not in LEVEL_OF:
        return f"there is no folder {other}"
    if folder in PHYSICS and other in NOT_FOR_PHYSICS:
        return f"{folder or 'src'} is physics and does not use {other}"
    if folder != other and LEVEL_OF[other] >= LEVEL_OF[folder]:
        return f"{folder or 'src'} does not use {other or 'src'}, see LEVELS of tests/folders.py"
    return ""


def faults_of(root):
    """Every line of the sources that breaks the order, as FILE:LINE: what is wrong."""
    faults = []
    for path, folder in files_of(root):
        if folder not in LEVEL_OF:
            faults.append(f"{path.relative_to(root).as_posix()}:1: there is no folder {folder}")
            continue
        modules = []
        for number, line in enumerate(path.read_text().splitlines(), 1):
            where = f"{path.relative_to(root).as_posix()}:{number}: {line.strip()}: "
            if module := MODULE.match(line):
                modules.append(module[1].lower())
                if len(modules) > 1:
                    faults.append(f"{where}a file has one module")
                elif folder != "drivers" and modules[0] != name_by_path(path, root):
                    faults.append(f"{where}the name by its path is {name_by_path(path, root)}")
            elif use := USE.match(line):
                fault = fault_of_use(folder, use[1].lower())
                if fault:
                    faults.append(where + fault)
        if not modules:
            faults.append(f"{path.relative_to(root).as_posix()}:1: there is no module")
    return faults


class Folders(unittest.TestCase):
    """The sources as they are."""

    def test_order(self):
        """No line breaks the order."""
        faults = faults_of(ROOT)
        self.assertEqual([], faults, "\n" + "\n".join(faults))

    def test_every_folder_is_there(self):
        """The folders of the order are those of src/, so none is left out of the test."""
        folders = {folder for _, folder in files_of(ROOT)}
        self.assertEqual(set(LEVEL_OF), folders)

    def test_targets(self):
        """The library of the physics is made of the folders that are held to be physics."""
        named = re.search(r"^set\(physics_folders ([^)]*)\)", (ROOT / "CMakeLists.txt").read_text(), re.MULTILINE)
        self.assertEqual(set(PHYSICS) - {""}, set(named[1].split()))

    def test_tests_mirror_the_sources(self):
        """A folder of tests is a folder; its tests are named by their path, and their modules are."""
        for folder in sorted({path.parent for path in (ROOT / "tests").glob("[!_]*/*")}):
            self.assertIn(folder.name, set(LEVEL_OF) | OTHER_TESTS)
            for path in folder.glob("*.pf") if folder.name != "selftest" else ():
                with self.subTest(path=path.relative_to(ROOT).as_posix()):
                    self.assertTrue(path.name.startswith(f"{folder.name}_"))
                    self.assertRegex(path.read_text(), re.compile(rf"^module {path.stem}$", re.MULTILINE))


class Words(unittest.TestCase):
    """One word has one meaning: the field's own (docs/reference/glossary.md)."""

    BANNED = {"way", "ways", "place", "places", "held", "room", "rooms", "march", "marched", "marches"}
    # a constant of MPI
    ALLOWED = {"mpi_in_place"}

    def banned_in(self, text):
        """The names of a source that have a banned word."""
        found = set()
        for line in text.splitlines():
            code = re.sub(r"'(?:[^']|'')*'|\"[^\"]*\"", "", line).partition("!")[0]
            found |= {name for name in re.findall(r"[a-z]\w*", code.lower()) if self.BANNED & set(name.split("_"))}
        return found - self.ALLOWED

    def test_sources(self):
        """No name of the sources has a banned word."""
        for path, _ in files_of(ROOT):
            with self.subTest(path=path.relative_to(ROOT).as_posix()):
                self.assertEqual(set(), self.banned_in(path.read_text()))

    def test_faults(self):
        """Names are found, texts and comments are not."""
        self.assertEqual({"way", "last_place"}, self.banned_in("! the way\nx = way(last_place) ! held\ny = 'no room'\ncall MPI_IN_PLACE\n"))


class Sizes(unittest.TestCase):
    """A long procedure or file says why it is long, a type has a name of its own, and a module says what it uses."""

    MOST_OF_PROCEDURE, MOST_OF_FILE = 80, 400
    # words of a reason
    REASON = re.compile(r"\b(?:is|It is) long\b")
    PROCEDURE = re.compile(r"^\s*(?!end\b)(?:(?:pure|impure|elemental|recursive|logical|integer|real|complex|character|type|class)(?:\s*\([^)]*\))?\s+)*"
                           r"(?:subroutine|function)\s+(\w+)", re.IGNORECASE)
    TYPE = re.compile(r"^\s*type\s*(?:,[^:]*)?::\s*(\w+)", re.IGNORECASE | re.MULTILINE)
    # declared by the file for MPI and by the one without it
    ALTERNATIVES = {"world_t"}

    def long_in(self, lines):
        """The file, as `file`, and its procedures that are long and do not say why."""
        found = []
        head = "\n".join(line for line in itertools.takewhile(lambda line: line.startswith("!"), lines))
        if len(lines) > self.MOST_OF_FILE and not self.REASON.search(head):
            found.append("file")
        begun, in_interface = [], False
        for number, line in enumerate(lines):
            if re.match(r"\s*(?:abstract )?interface\b", line):
                in_interface = True
            elif re.match(r"\s*end interface\b", line):
                in_interface = False
            elif in_interface:
                continue
            elif re.match(r"\s*end (?:subroutine|function)\b", line):
                first = begun.pop()
                comment = itertools.takewhile(lambda above: above.strip().startswith("!"), reversed(lines[:first]))
                if number - first + 1 > self.MOST_OF_PROCEDURE and not self.REASON.search("\n".join(comment)):
                    found.append(self.PROCEDURE.match(lines[first])[1])
            elif self.PROCEDURE.match(line):
                begun.append(number)
        return found

    def test_lengths(self):
        """What is long has a reason in its head."""
        for path, _ in files_of(ROOT):
            with self.subTest(path=path.relative_to(ROOT).as_posix()):
                self.assertEqual([], self.long_in(path.read_text().splitlines()))

    def test_types(self):
        """No name of a type is defined twice."""
        names = collections.Counter(name.lower() for path, _ in files_of(ROOT) for name in self.TYPE.findall(path.read_text()))
        self.assertGreater(len(names), 500)
        self.assertEqual(self.ALTERNATIVES, {name for name, count in names.items() if count > 1})

    def test_use(self):
        """Every use says what it takes."""
        for path, _ in files_of(ROOT):
            with self.subTest(path=path.relative_to(ROOT).as_posix()):
                self.assertEqual([], [line for line in path.read_text().splitlines() if USE.match(line) and not re.search(r",\s*only\s*:", line)])

    def test_faults(self):
        """What is long without a reason is found, and what has one is not."""
        long = ["   x = 1"]*self.MOST_OF_PROCEDURE
        body = ["   pure real(dp) function f(x)", *long, "   end function f"]
        self.assertEqual(["f"], self.long_in(["   !> The value.", *body]))
        self.assertEqual([], self.long_in(["   !> The value. It is long by its", "   !> cases.", *body]))
        self.assertEqual([], self.long_in(["   interface", *body, "   end interface"]))
        self.assertEqual([], self.long_in([body[0], *long[2:], body[-1]]))
        self.assertEqual(["file"], self.long_in(["! A file.", *long*6]))
        self.assertEqual([], self.long_in(["! The file is long by its cases.", *long*6]))


class Names(unittest.TestCase):
    """What C calls."""

    def test_no_module_has_the_name_of_a_function(self):
        """Both are global in Fortran, and gfortran takes one for the other without a word."""
        texts = [path.read_text() for path, _ in files_of(ROOT)]
        modules = {module for text in texts for module in re.findall(r"^module (adfric\w*)$", text, re.MULTILINE)}
        functions = {function for text in texts for function in re.findall(r"bind\(c, name='(\w+)'\)", text)}
        self.assertGreater(len(functions), 50)
        self.assertEqual(set(), modules & functions)

    def test_header(self):
        """Every function of the header is there, and those of src/c that are not bindings stand in it."""
        declared = set(re.findall(r"^(?:int|const char \*)\s*(adfric_\w+)\(", (ROOT / "include/adfric.h").read_text(), re.MULTILINE))
        written = set()
        for path in sorted((ROOT / "src/c").iterdir()):
            text = path.read_text()
            if path.suffix == ".c":
                written |= set(re.findall(r"/\* See adfric.h[^/]*\*/\n[\w ]+[ *](adfric_\w+)\(", text))
            else:
                written |= set(re.findall(r"name='(adfric_\w+)'", text[text.index("\ncontains\n"):]))
        self.assertGreater(len(declared), 30)
        self.assertEqual(declared, written)


class Faults(unittest.TestCase):
    """Sources that break the order are found."""

    def check(self, path, text, *expected):
        """The faults of one file, as far as the given words say."""
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, path)
            file.parent.mkdir(parents=True)
            file.write_text(text)
            faults = faults_of(Path(folder))
        self.assertEqual(len(expected), len(faults), faults)
        for words, fault in zip(expected, faults):
            self.assertIn(words, fault)

    def test_right(self):
        """Folders below, the own one, and what a language has."""
        self.check("src/foundation/a.f90", "module adfric_foundation_a\n use, intrinsic :: iso_fortran_env, only: real64\n"
                   "   use adfric_foundation_b, only: b\n   use adfric_numerics_gauss\n   use :: adfric_shape_map, only: m\nend module\n")

    def test_upwards(self):
        """A folder above, one beside, and one that does not exist, with their lines."""
        self.check("src/foundation/a.f90", "module adfric_foundation_a\n   use adfric_run_plan, only: plan_t\n"
                   "      USE ::adfric_round_sphere_jkr\n   use adfric_attic_chest, only: c\n   use adfric, only: new_model\nend module\n",
                   "src/foundation/a.f90:2: use adfric_run_plan, only: plan_t: foundation does not use run",
                   "src/foundation/a.f90:3: USE ::adfric_round_sphere_jkr: foundation does not use round",
                   "src/foundation/a.f90:4: use adfric_attic_chest, only: c: there is no folder attic",
                   "src/foundation/a.f90:5: use adfric, only: new_model: foundation does not use src")

    def test_input_and_output(self):
        """Neither knows the other."""
        self.check("src/input/a.f90", "module adfric_input_a\n   use adfric_output_names\nend module\n", "input does not use output")
        self.check("src/output/a.f90", "module adfric_output_a\n   use adfric_input_item\nend module\n", "output does not use input")

    def test_physics(self):
        """No files, no signals, no bindings, though these stand below."""
        self.check("src/describe/a.f90", "module adfric_describe_a\n   use adfric_system_files\n   use hdf5\n"
                   "   use, intrinsic :: iso_c_binding, only: c_int\nend module\n",
                   "describe is physics and does not use system", "describe does not use hdf5", "describe does not use iso_c_binding")

    def test_names(self):
        """A module of another name, a second one, and none."""
        self.check("src/base/a.f90", "module adfric_base_b\nend module\nmodule adfric_base_c\nend module\n",
                   "src/base/a.f90:1: module adfric_base_b: the name by its path is adfric_base_a", "a file has one module")
        self.check("src/run/world_mpi.f90", "module adfric_run_world\nend module\n")
        self.check("src/base/a.f90", "subroutine a()\nend subroutine\n", "there is no module")
        self.check("src/attic/a.f90", "module adfric_attic_a\nend module\n", "there is no folder attic")


if __name__ == "__main__":
    unittest.main()
