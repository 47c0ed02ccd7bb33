# SPDX-License-Identifier: GPL-3.0-or-later
"""The rooms (folders) of src/ and who may use whom: dependencies point one way, and a module is named by its path."""

import re
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
# What stands in a line uses what stands in the lines above it, and itself. "" is src/ itself: which models there are.
LEVELS = (("base",), ("numerics", "system"), ("model", "hdf5"), ("material", "shape", "scene"), ("wavy", "sphere", "classical", "indenter", "periodic"),
          ("contact", "fit"), ("",), ("run",), ("input", "output"), ("api", "command"), ("c",), ("drivers",))
LEVEL_OF = {room: level for level, rooms in enumerate(LEVELS) for room in rooms}
# The library adfric::physics, as CMakeLists.txt names its folders: it knows neither files nor processes.
PHYSICS = ("base", "numerics", "model", "material", "shape", "scene", "wavy", "sphere", "classical", "indenter", "periodic", "contact", "fit", "")
NOT_FOR_PHYSICS = ("system", "hdf5")
# Modules from outside that a room may use; bindings of libraries for numbers, and locks of threads, stand in numerics alone.
FOREIGN = {"physics": {"iso_fortran_env", "ieee_arithmetic"},
           "numerics": {"iso_fortran_env", "ieee_arithmetic", "iso_c_binding", "omp_lib"},
           "rest": {"iso_fortran_env", "ieee_arithmetic", "iso_c_binding", "omp_lib", "hdf5", "h5ds", "h5lt", "mpi_f08"}}
# Two files of one module, of which CMake takes one (cmake/AdfricMpi.cmake); and the library's interface, which has a short name.
ALTERNATIVES = {"run/world_mpi": "run/world", "run/world_serial": "run/world", "api/api": "api"}
# Folders of tests that are no room of src/.
OTHER_TESTS = {"asserts", "hard", "program", "python", "old_inputs", "reference", "runner", "search", "selftest", "support"}
# The first module of a file, and what it uses.
MODULE = re.compile(r"^\s*(?:module|program)\s+(?!procedure\b)(\w+)\s*$", re.IGNORECASE)
USE = re.compile(r"^\s*use\b(?:\s*,\s*(?:non_)?intrinsic\s*)?(?:\s*::)?\s*(\w+)", re.IGNORECASE)


def files_of(root):
    """The sources and their rooms; a folder in a room is a part of it."""
    for folder in ("src", "drivers"):
        for path in sorted((root / folder).rglob("*.f90*")):
            yield path, ("drivers" if folder == "drivers" else "".join(path.relative_to(root / "src").parts[:-1][:1]))


def room_of(module):
    """The room of a module of the project, by its name; None for a module from outside."""
    if module in ("adfric", "adfric_api"):
        return module[len("adfric_"):]
    room = re.match(r"adfric_([a-z0-9]+)_", module)
    return room and room[1].replace("driver", "drivers")


def name_by_path(path, root):
    """The name that a module of src/ has."""
    place = path.relative_to(root / "src").as_posix().split(".")[0]
    return "adfric_" * (place != "adfric") + ALTERNATIVES.get(place, place).replace("/", "_")


def fault_of_use(room, module):
    """What is wrong with the use of a module in a room; nothing if it is right."""
    other = room_of(module)
    if other is None:
        kind = "numerics" if room == "numerics" else "physics" if room in PHYSICS else "rest"
        return "" if module in FOREIGN[kind] else f"{room or 'src'} does not use {module}"
    if other not in LEVEL_OF:
        return f"there is no room {other}"
    if room in PHYSICS and other in NOT_FOR_PHYSICS:
        return f"{room or 'src'} is physics and does not use {other}"
    if room != other and LEVEL_OF[other] >= LEVEL_OF[room]:
        return f"{room or 'src'} does not use {other or 'src'}, see LEVELS of tests/rooms.py"
    return ""


def faults_of(root):
    """Every line of the sources that breaks the order, as FILE:LINE: what is wrong."""
    faults = []
    for path, room in files_of(root):
        if room not in LEVEL_OF:
            faults.append(f"{path.relative_to(root).as_posix()}:1: there is no room {room}")
            continue
        modules = []
        for number, line in enumerate(path.read_text().splitlines(), 1):
            where = f"{path.relative_to(root).as_posix()}:{number}: {line.strip()}: "
            if module := MODULE.match(line):
                modules.append(module[1].lower())
                if len(modules) > 1:
                    faults.append(f"{where}a file has one module")
                elif room != "drivers" and modules[0] != name_by_path(path, root):
                    faults.append(f"{where}the name by its path is {name_by_path(path, root)}")
            elif use := USE.match(line):
                fault = fault_of_use(room, use[1].lower())
                if fault:
                    faults.append(where + fault)
        if not modules:
            faults.append(f"{path.relative_to(root).as_posix()}:1: there is no module")
    return faults


class Rooms(unittest.TestCase):
    """The sources as they are."""

    def test_order(self):
        """No line breaks the order."""
        faults = faults_of(ROOT)
        self.assertEqual([], faults, "\n" + "\n".join(faults))

    def test_every_room_is_there(self):
        """The rooms of the order are those of src/, so none is left out of the test."""
        rooms = {room for _, room in files_of(ROOT)}
        self.assertEqual(set(LEVEL_OF), rooms)

    def test_targets(self):
        """The library of the physics is made of the rooms that are held to be physics."""
        named = re.search(r"^set\(physics_rooms ([^)]*)\)", (ROOT / "CMakeLists.txt").read_text(), re.MULTILINE)
        self.assertEqual(set(PHYSICS) - {""}, set(named[1].split()))

    def test_tests_mirror_the_sources(self):
        """A folder of tests is a room; its tests are named by their path, and their modules are."""
        for folder in sorted({path.parent for path in (ROOT / "tests").glob("[!_]*/*")}):
            self.assertIn(folder.name, set(LEVEL_OF) | OTHER_TESTS)
            for path in folder.glob("*.pf") if folder.name != "selftest" else ():
                with self.subTest(path=path.relative_to(ROOT).as_posix()):
                    self.assertTrue(path.name.startswith(f"{folder.name}_"))
                    self.assertRegex(path.read_text(), re.compile(rf"^module {path.stem}$", re.MULTILINE))


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
        """Rooms below, the own one, and what a language has."""
        self.check("src/wavy/a.f90", "module adfric_wavy_a\n use, intrinsic :: iso_fortran_env, only: real64\n"
                   "   use adfric_wavy_b, only: b\n   use adfric_numerics_gauss\n   use :: adfric_shape_map, only: m\nend module\n")

    def test_upwards(self):
        """A room above, one beside, and one that does not exist, with their lines."""
        self.check("src/wavy/a.f90", "module adfric_wavy_a\n   use adfric_run_plan, only: plan_t\n"
                   "      USE ::adfric_sphere_jkr\n   use adfric_attic_chest, only: c\n   use adfric, only: new_model\nend module\n",
                   "src/wavy/a.f90:2: use adfric_run_plan, only: plan_t: wavy does not use run",
                   "src/wavy/a.f90:3: USE ::adfric_sphere_jkr: wavy does not use sphere",
                   "src/wavy/a.f90:4: use adfric_attic_chest, only: c: there is no room attic",
                   "src/wavy/a.f90:5: use adfric, only: new_model: wavy does not use src")

    def test_input_and_output(self):
        """Neither knows the other."""
        self.check("src/input/a.f90", "module adfric_input_a\n   use adfric_output_names\nend module\n", "input does not use output")
        self.check("src/output/a.f90", "module adfric_output_a\n   use adfric_input_item\nend module\n", "output does not use input")

    def test_physics(self):
        """No files, no signals, no bindings, though these stand below."""
        self.check("src/model/a.f90", "module adfric_model_a\n   use adfric_system_files\n   use hdf5\n"
                   "   use, intrinsic :: iso_c_binding, only: c_int\nend module\n",
                   "model is physics and does not use system", "model does not use hdf5", "model does not use iso_c_binding")

    def test_names(self):
        """A module of another name, a second one, and none."""
        self.check("src/base/a.f90", "module adfric_base_b\nend module\nmodule adfric_base_c\nend module\n",
                   "src/base/a.f90:1: module adfric_base_b: the name by its path is adfric_base_a", "a file has one module")
        self.check("src/run/world_mpi.f90", "module adfric_run_world\nend module\n")
        self.check("src/base/a.f90", "subroutine a()\nend subroutine\n", "there is no module")
        self.check("src/attic/a.f90", "module adfric_attic_a\nend module\n", "there is no room attic")


if __name__ == "__main__":
    unittest.main()
