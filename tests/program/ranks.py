# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of several processes by MPI: the same file as that of one process, to the bit, whatever ends them on the way."""

import contextlib
import os
import random
import re
import shutil
import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path

import h5py

sys.path.insert(0, str(Path(__file__).parent))
from runs import IN_ORDER, LOADS, MAP, PROFILES, PROGRAM, STACK, Runs  # noqa: E402

MPIRUN = shutil.which("mpirun")
N_KILLS = 10
# as long as a run that ends in order may take to do so [s]
PATIENCE = 60
# a sweep whose file is larger than what MPI itself keeps in files
MANY = """
&job model = 'sphere', output = 'run.h5' /
&sphere units = 'reduced', lambda = 0.8 /
&model theory = 'jkr' /
&sweep variable = 'load', from = -1, to = 10, count = {count} /
"""


def launcher(n_ranks, *options):
    """What stands before the program; more processes than cores are allowed."""
    as_root = ["--allow-run-as-root"] if os.geteuid() == 0 else []
    return [MPIRUN, *as_root, "--quiet", "--oversubscribe", *options, "-n", str(n_ranks)]


def children(process):
    """Numbers of the processes that a process has started itself."""
    return [int(number) for task in Path(f"/proc/{process.pid}/task").glob("*/children") for number in task.read_text().split()]


def open_files(numbers):
    """Names of the files that processes have open; none of one that has ended."""
    names = set()
    for number in numbers:
        with contextlib.suppress(OSError):
            names.update(os.path.basename(os.readlink(link)) for link in Path(f"/proc/{number}/fd").iterdir())
    return names


def without_mpirun(errors):
    """Lines of the program; those of MPI itself stand between lines of dashes, or begin with the name of a part of it."""
    kept = re.sub(r"^-{20,}\n.*?^-{20,}\n", "", errors, flags=re.MULTILINE | re.DOTALL)
    return [line for line in kept.splitlines() if line.strip() and not line.startswith(("mpirun", "mca_", "["))]


@unittest.skipUnless(MPIRUN, "mpirun is not installed")
class Ranks(Runs):
    def start_ranks(self, n_ranks, *arguments, threads=1, program=(PROGRAM,), options=()):
        environment = dict(os.environ, OMP_NUM_THREADS=str(threads))
        return subprocess.Popen([*launcher(n_ranks, *options), *program, *arguments], cwd=self.folder, env=environment, text=True,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    def run_ranks(self, n_ranks, *arguments, status=IN_ORDER, **options):
        process = self.start_ranks(n_ranks, *arguments, **options)
        output, errors = process.communicate(timeout=120)
        self.assertIn(process.returncode, status, errors)
        return output, without_mpirun(errors)

    def run_whole(self, text):
        """What one process without mpirun finds; how long that takes, and the table that it prints."""
        self.write(text)
        start = time.monotonic()
        output, _ = self.run_program("run", "--force", "run.nml", "--output", "whole.h5", threads=1)
        return time.monotonic() - start, output

    def test_fits(self):
        """The curves of a map are shared out as the points of a sweep are."""
        self.write(STACK.format(file=MAP))
        output, _ = self.run_program("fit", "--force", "run.nml", "--output", "whole.h5", threads=1)
        for n_ranks, threads in ((2, 1), (4, 1), (2, 2)):
            with self.subTest(n_ranks=n_ranks, threads=threads):
                of_ranks, errors = self.run_ranks(n_ranks, "fit", "run.nml", threads=threads)
                self.assertEqual(errors, [])
                self.assertEqual(of_ranks.splitlines()[:-2], output.splitlines()[:-2])
                self.assert_same(self.snapshot("whole.h5"), self.snapshot("run.h5"))
                (self.folder / "run.h5").unlink()

    def test_same_results(self):
        for text in (LOADS.format(strips=16, count=400), PROFILES.format(strips=16, count=200)):
            _, table = self.run_whole(text)
            for n_ranks, threads in ((1, 1), (2, 1), (4, 1), (2, 2)):
                with self.subTest(n_ranks=n_ranks, threads=threads):
                    output, errors = self.run_ranks(n_ranks, "run", "run.nml", threads=threads)
                    self.assertEqual(errors, [])
                    # one table, of all points; its last lines are the time and the file
                    self.assertEqual(output.splitlines()[:-2], table.splitlines()[:-2])
                    self.assert_same(self.snapshot("whole.h5"), self.snapshot("run.h5"))
                    (self.folder / "run.h5").unlink()
                    self.assertEqual(self.names(), ["run.nml", "whole.h5"])

    def test_few_blocks(self):
        self.run_whole(LOADS.format(strips=16, count=2).replace("0, 1e3, 2e3", "0"))
        self.run_ranks(4, "run", "run.nml")
        self.assert_same(self.snapshot("whole.h5"), self.snapshot("run.h5"))

    def test_shard(self):
        self.run_whole(LOADS.format(strips=16, count=200))
        for number in (1, 2, 3):
            self.run_ranks(2, "run", "run.nml", "--shard", f"{number}/3")
        self.run_program("merge", "run.h5", *(f"run.part-000{number}-of-0003.h5" for number in (1, 2, 3)))
        self.assert_same(self.snapshot("whole.h5"), self.snapshot("run.h5"))

    def test_kill(self):
        """One process dies at a random moment; other numbers of processes, or one without mpirun, go on."""
        duration, _ = self.run_whole(PROFILES.format(strips=16, count=self.count_of_lasting(PROFILES)))
        moment = random.Random(1)
        n_killed, n_resumed, most = 0, 0, 0
        while n_killed < N_KILLS:
            process = self.start_ranks(2 + n_killed % 2, "run", "--quiet", "--resume", "run.nml")
            self.wait_for_file(process)
            try:
                # every other time at any moment; mpirun takes about a second to end
                if n_killed % 2 == 0:
                    self.wait_for_points("run.h5.partial", process)
                    process.communicate(timeout=moment.uniform(0.0, 0.3 * duration))
                else:
                    process.communicate(timeout=moment.uniform(0.0, 1 + 0.5 * duration))
            except subprocess.TimeoutExpired:
                ranks = children(process)
                if ranks:
                    os.kill(moment.choice(ranks), signal.SIGKILL)
                    n_killed += 1
                process.communicate(timeout=PATIENCE)
            if (self.folder / "run.h5").exists():
                self.assert_same(self.snapshot("whole.h5"), self.snapshot("run.h5"))
                (self.folder / "run.h5").unlink()
                most = 0
            elif (self.folder / "run.h5.partial").exists():
                n_done = self.check_truth("run.h5.partial", "whole.h5")
                self.assertGreaterEqual(n_done, most, "results of a former run are lost")
                most = n_done
                n_resumed += n_done > 0
                if n_killed == N_KILLS // 2:
                    self.run_program("run", "--quiet", "--resume", "run.nml")
        self.assertGreater(n_resumed, 0, "no kill met a run with results on the disk")
        self.run_ranks(4, "run", "--quiet", "--resume", "run.nml")
        self.assert_same(self.snapshot("whole.h5"), self.snapshot("run.h5"))
        self.assertEqual(self.names(), ["run.h5", "run.nml", "whole.h5"])

    def wait_for_file(self, process):
        """Wait until a process has the file of the run open: all have met by then, and mpirun knows of each of them.

        Of a process that dies before, the mpirun of Open MPI may not hear, and waits for ever."""
        end = time.monotonic() + PATIENCE
        while process.poll() is None and "run.h5.partial" not in open_files(children(process)):
            self.assertLess(time.monotonic(), end)
            time.sleep(0.005)

    def stop_run(self, choose, n_ranks=2):
        """End status and lines of a run that gets SIGTERM where `choose` says."""
        # mpirun waits so long before it kills what it has asked to end [s], by default 1
        process = self.start_ranks(n_ranks, "run", "--quiet", "run.nml",
                                   options=("--mca", "odls_base_sigkill_timeout", "5"))
        self.wait_for_points("run.h5.partial")
        for number in choose(process):
            os.kill(number, signal.SIGTERM)
        output, errors = process.communicate(timeout=PATIENCE)
        self.assertEqual(output, "")
        return process.returncode, without_mpirun(errors)

    def check_sigterm(self, choose, status):
        count = 2 * self.count_of_lasting(PROFILES)
        n_points = 3 * count
        self.run_whole(PROFILES.format(strips=16, count=count))
        found, lines = self.stop_run(choose)
        self.assertEqual(found, status, lines)
        n_done = self.check_truth("run.h5.partial", "whole.h5")
        self.assertGreater(n_done, 0)
        self.assertLess(n_done, n_points)
        self.assertEqual(len(lines), 1, lines)
        self.assertRegex(lines[0], rf"^run.nml: stopped by SIGTERM, {n_done} of {n_points} points are in run.h5.partial; "
                                   r"adfric run --resume run.nml goes on$")
        self.assertEqual(self.names(), ["run.h5.partial", "run.nml", "whole.h5"])
        self.run_ranks(3, "run", "--quiet", "--resume", "run.nml")
        self.assert_same(self.snapshot("whole.h5"), self.snapshot("run.h5"))

    def test_sigterm_of_mpirun(self):
        # it passes the signal on after a while, in which the run may be completed, and ends with a status of its own
        self.run_whole(PROFILES.format(strips=16, count=6000))
        status, lines = self.stop_run(lambda process: [process.pid])
        self.assertIn(status, (0, 1), lines)
        if not (self.folder / "run.h5").exists():
            self.assertGreater(self.check_truth("run.h5.partial", "whole.h5"), 0)
            self.run_ranks(2, "run", "--quiet", "--resume", "run.nml")
        self.assert_same(self.snapshot("whole.h5"), self.snapshot("run.h5"))

    def test_sigterm_of_all(self):
        # as srun does
        self.check_sigterm(children, 143)

    def test_sigterm_of_one(self):
        self.check_sigterm(lambda process: children(process)[-1:], 143)

    def test_damaged_profiles(self):
        """Whichever process solves a point again that has no solution, what stands in the place of its profiles goes."""
        self.run_whole(PROFILES.format(strips=16, count=1000))
        shutil.copy(self.folder / "whole.h5", self.folder / "run.h5.partial")
        with h5py.File(self.folder / "run.h5.partial", "r+") as file:
            status = file["status"][()]
            self.assertGreater((status > 0).sum(), 0)
            for name in [name for name, item in file.items() if isinstance(item, h5py.Dataset) and item.ndim > status.ndim]:
                values = file[name][()]
                values[status > 0] = 1.0
                file[name][...] = values
            file["status"][...] = -1
        self.run_ranks(3, "run", "--quiet", "--resume", "run.nml")
        self.assert_same(self.snapshot("whole.h5"), self.snapshot("run.h5"))

    def test_bad_input(self):
        self.write(LOADS.format(strips=16, count=20).replace("period", "perid"))
        for arguments, expected in [(("run", "run.nml"), "perid"), (("run", "nothing.nml"), "nothing.nml"),
                                    (("run", "--rezume", "run.nml"), "--rezume"), (("check", "run.nml"), "perid")]:
            with self.subTest(arguments=arguments):
                output, lines = self.run_ranks(3, *arguments, status=(2,))
                self.assertEqual(output, "")
                self.assertEqual(len([line for line in lines if expected in line]), 1, lines)
        output, _ = self.run_ranks(3, "--version", status=(0,))
        self.assertRegex(output, r"^adfric .*, MPI\)\n$")

    def test_nothing_is_overwritten(self):
        self.run_whole(LOADS.format(strips=16, count=20))
        for n_ranks in (1, 3):
            _, lines = self.run_ranks(n_ranks, "run", "run.nml", "--output", "whole.h5", status=(3,))
            self.assertEqual(lines, ["whole.h5: this file exists; --force overwrites it, --output writes another one"])
        output, lines = self.run_ranks(3, "run", "--resume", "run.nml", "--output", "whole.h5")
        self.assertEqual((output.splitlines()[-1], lines), ("this run was complete already", []))

    def test_write_that_fails(self):
        """A process of two may not write beyond the first tenths of the file."""
        n_bytes = 40_000_000
        self.run_whole(MANY.format(count=2_000_000))
        self.assertGreater((self.folder / "whole.h5").stat().st_size, 3 * n_bytes)
        for rank in (0, 1):
            with self.subTest(rank=rank):
                limited = f'[ "$OMPI_COMM_WORLD_RANK" = {rank} ] && ulimit -f {n_bytes // 512}; exec "$@"'
                program = ("sh", "-c", limited, "sh", PROGRAM)
                _, lines = self.run_ranks(2, "run", "--quiet", "run.nml", status=(3,), program=program)
                self.assertEqual(len(lines), 1, lines)
                if rank == 0:
                    self.assertRegex(lines[0], "^run.h5: cannot create: File too large")
                    self.assertEqual(self.names(), ["run.nml", "whole.h5"])
                else:
                    self.assertRegex(lines[0], "^run.h5: cannot write: .*; the results so far stay in run.h5.partial, "
                                               "--resume goes on with them$")
                    self.check_truth("run.h5.partial", "whole.h5")
                    self.run_ranks(2, "run", "--quiet", "--resume", "run.nml")
                    self.assert_same(self.snapshot("whole.h5"), self.snapshot("run.h5"))


if __name__ == "__main__":
    unittest.main()
