# SPDX-License-Identifier: GPL-3.0-or-later
"""Small runs of the program for tests, and their files compared bit by bit."""

import os
import resource
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

import h5py
import numpy as np

PROGRAM = os.environ["ADFRIC_PROGRAM"]
# exit status: all points are answered, or some did not converge
IN_ORDER = (0, 1)
# exit status of a file of tests that cannot be run here, see tests/CMakeLists.txt
ALL_SKIPPED = 77
# attributes that tell one run from another of the same case
OF_THE_RUN = {"created", "history", "wall_seconds"}
# datasets that tell one file from another
OF_THE_FILE = {"blocks/seal"}

# Warm starts from point to point. Some of these sweeps have a point that does not converge: it belongs to the results.
LOADS = """
&job model = 'wavy_sliding', title = 'loads', output = 'run.h5' /
&surface kind = 'wave_3d', period = 1e-2, height = 1e-4 /
&foundation stiffness = 1e8, relaxation_time = 1e-3, retardation_ratio = 10 /
&adhesion range = 1e-5 /
&operating velocity = 0.5 /
&numerics strips = {strips} /
&sweep variable = 'stress', values = 0, 1e3, 2e3 /
&sweep variable = 'load', from = -0.1, to = 0.6, count = {count} /
"""
# points of about the same cost
EVEN = LOADS.replace("from = -0.1", "from = 0.1").replace("{strips}", "16")
PROFILES = LOADS + "&output profiles = .true., n_x = 9, n_y = 5 /\n"
# fits of the curves of a map; some of them have no answer
MAP = Path(__file__).resolve().parents[1] / "reference/fit/map_jkr_a.h5"
STACK = """
&job model = 'sphere', output = 'run.h5' /
&sphere radius = 5e-6 /
&model theory = 'jkr' /
&data file = '{file}:/load', abscissa = 'approach', abscissa_column = 'position', ordinate = 'load', sigma = 2e-10, spring_stiffness = 0.05 /
&free variable = 'work_of_adhesion' /
&free variable = 'contact_modulus' /
&free variable = 'contact_point' /
&free variable = 'load_offset' /
"""


class Runs(unittest.TestCase):
    """A folder of its own for each test."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def write(self, text, name="run.nml"):
        (self.folder / name).write_text(text)

    def start(self, *arguments, threads=2, **options):
        """A process that has just begun."""
        environment = dict(os.environ, OMP_NUM_THREADS=str(threads))
        process = subprocess.Popen([PROGRAM, *arguments], cwd=self.folder, env=environment, text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, **options)
        self.addCleanup(end, process)
        return process

    def run_program(self, *arguments, threads=2, status=None, **options):
        """Standard output and standard error of a run that ends as expected, by default in order."""
        process = self.start(*arguments, threads=threads, **options)
        output, errors = process.communicate(timeout=120)
        if status is None:
            self.assertIn(process.returncode, IN_ORDER, errors)
            self.assertEqual(errors, "")
        else:
            self.assertEqual(process.returncode, status, errors)
            self.assertEqual(output, "")
            self.assertEqual(errors.count("\n"), 1, errors)
        return output, errors

    def run_scene(self, scene):
        """The results of a scene, and its solver."""
        self.write("&job output = 'run.h5' /\n" + scene)
        self.run_program("run", "--quiet", "--force", "run.nml")
        with h5py.File(self.folder/"run.h5") as file:
            self.assertTrue(np.all(file["status"][()] == 0), scene)
            return {name: item[()] for name, item in file.items()
                    if isinstance(item, h5py.Dataset) and item.dtype.kind == "f"}, file.attrs["model"]

    def refuse_in_line(self, command, text, words):
        """An input is refused in one line with these words."""
        self.write(text)
        _, errors = self.run_program(command, "--quiet", "--force", "run.nml", status=2)
        self.assertEqual(1, len(errors.strip().splitlines()), errors)
        self.assertIn(words, errors)

    def names(self):
        return sorted(path.name for path in self.folder.iterdir())

    def snapshot(self, name):
        """Every dataset as bytes, with its type, shape and attributes."""
        contents = {}

        def visit(path, item):
            if isinstance(item, h5py.Dataset) and path not in OF_THE_FILE:
                attributes = {key: value for key, value in item.attrs.items()
                              if key not in ("DIMENSION_LIST", "REFERENCE_LIST")}
                scales = [[scale.name for scale in dimension.values()] for dimension in item.dims]
                values = repr(item[()].tolist()) if item.dtype.kind == "O" else item[()].tobytes()
                contents[path] = (item.dtype.str, item.shape, values, plain(attributes), scales)

        with h5py.File(self.folder / name, "r") as file:
            file.visititems(visit)
            contents["/"] = plain({key: value for key, value in file.attrs.items() if key not in OF_THE_RUN})
        return contents

    def assert_same(self, first, second):
        """The same datasets, bit by bit, and the same attributes."""
        self.assertEqual(first.keys(), second.keys())
        for key, value in first.items():
            self.assertTrue(value == second[key], f"{key} differs")

    def case_of(self, seconds):
        """An input that takes so long on one thread, whatever the build and the machine; the name of its file is big.h5."""
        text = EVEN.replace("run.h5", "big.h5")
        count, took = self.lasting(text)
        return text.format(count=int(count*seconds/took))

    def count_of_lasting(self, template, threads=1):
        """Count with which a run lasts, see there."""
        return self.lasting(template, threads)[0]

    def lasting(self, template, threads=1, seconds=0.5):
        """Count with which a run takes so long, and long enough that it can be met with results on the disk; the time that it takes at
        least, since other work makes it longer here but perhaps not later."""
        count, first, duration = 100, 0.0, 0.0
        while duration < max(seconds, 5 * first):
            count *= 2
            self.write(template.format(strips=16, count=count), "trial.nml")
            start, before = time.monotonic(), time_of_children()
            process = self.start("run", "--quiet", "trial.nml", "--output", "trial.h5", threads=threads)
            self.wait_for_points("trial.h5.partial", process)
            first = time.monotonic() - start
            _, errors = process.communicate(timeout=120)
            duration = time.monotonic() - start
            self.assertIn(process.returncode, IN_ORDER, errors)
            (self.folder / "trial.h5").unlink()
        (self.folder / "trial.nml").unlink()
        return count, min(duration, (time_of_children() - before) / threads)

    def wait_for(self, name, process=None, patience=60):
        """Wait until there is a file of this name, which a process that has ended will not write any more."""
        end = time.monotonic() + patience
        while not (self.folder / name).exists():
            if process is not None and process.poll() is not None:
                self.fail(f"no {name}: {process.communicate()[1]}")
            self.assertLess(time.monotonic(), end)
            time.sleep(0.01)

    def wait_for_points(self, name, process=None, patience=60):
        """Wait until some points of a run are on the disk; their number, 0 if its process has ended before."""
        end = time.monotonic() + patience
        while time.monotonic() < end:
            if process is not None and process.poll() is not None:
                return 0
            time.sleep(0.02)
            try:
                # the lock of the run stays as it is; a copy would take longer the longer the run is
                n_done = int((self.status_of(name, locking=False) >= 0).sum())
            except (OSError, KeyError, RuntimeError, ValueError):
                # it is not there yet, or was read while it changed
                continue
            if n_done > 0:
                return n_done
        self.fail(f"no points in {name}")

    def meet(self, number, n_parts, patience=60):
        """Wait until a part of big.h5 has results on the disk; its process."""
        partial = f"big.part-{number:04}-of-{n_parts:04}.h5.partial"
        self.wait_for(partial, patience=patience)
        self.wait_for_points(partial, patience=patience)
        process = self.process_of(f"{number}/{n_parts}")
        self.assertIsNotNone(process, "this part has ended already")
        return process

    def process_of(self, part):
        """Process that solves a part, as in 3/6, in our folder; None if there is none."""
        for path in Path("/proc").glob("[0-9]*"):
            try:
                words = (path / "cmdline").read_text().split("\0")
                if words[0] == PROGRAM and part in words and (path / "cwd").resolve() == self.folder.resolve():
                    return int(path.name)
            except OSError:
                # it has ended in the meantime
                continue
        return None

    def status_of(self, name, **options):
        with h5py.File(self.folder / name, "r", **options) as file:
            return file["status"][()]

    def check_truth(self, name, reference):
        """A point that is said to be done has the results of the whole run; number of these points."""
        with h5py.File(self.folder / name, "r") as file, h5py.File(self.folder / reference, "r") as whole:
            done = file["status"][()] >= 0
            for key, item in whole.items():
                if isinstance(item, h5py.Dataset) and item.shape[:done.ndim] == done.shape:
                    self.assertEqual(file[key][()][done].tobytes(), item[()][done].tobytes(), key)
            return int(done.sum())


class SolverRuns(Runs):
    """Scenes that one solver answers."""

    #: Name of the solver.
    solver = ""

    def solve(self, scene):
        """Results of a scene that the solver answers."""
        results, solver = self.run_scene(scene)
        self.assertEqual(self.solver, solver)
        return results

    def refuse(self, text, words):
        """A scene is refused in one line with these words."""
        self.refuse_in_line("run", "&job output = 'run.h5' /\n" + text, words)


def time_of_children():
    """Processor time of the processes that have ended [s]."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def end(process):
    """End a process that a failed test has left."""
    if process.returncode is None:
        process.kill()
        process.communicate()


def plain(attributes):
    """Attributes as things that can be compared."""
    return {key: (value.dtype.str, value.tobytes()) if isinstance(value, np.ndarray | np.generic) else value
            for key, value in attributes.items()}


def limit_file_size(n_bytes):
    """For a process that is about to start: no file may become larger."""
    def limit():
        import resource
        # Python ignores the signal, and the process would inherit that
        signal.signal(signal.SIGXFSZ, signal.SIG_DFL)
        resource.setrlimit(resource.RLIMIT_FSIZE, (n_bytes, n_bytes))
    return limit


def main():
    """Run the tests of a file; a special exit status tells ctest that they were all skipped, and the output why."""
    program = unittest.main(verbosity=2, exit=False)
    result = program.result
    if not result.wasSuccessful():
        sys.exit(1)
    sys.exit(ALL_SKIPPED if result.skipped and len(result.skipped) >= result.testsRun else 0)
