# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that are no common files: pipes, links, names with percent signs, outputs that are full, terminals that are gone."""

import contextlib
import fcntl
import os
import shutil
import signal
import socket
import subprocess
import sys
import time
import unittest
from pathlib import Path

import h5py
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from runs import IN_ORDER, LOADS, PROGRAM, Runs  # noqa: E402

SCRIPT = os.environ["ADFRIC_SOURCE"] + "/scripts/slurm_array.sh"
POINTS = """
&job model = 'hertz', output = 'run.h5' /
&contact kind = 'circular', radius = 1 /
&solid contact_modulus = 1e9 /
&sweep variable = 'load', from = 1, to = 2, count = 900 /
"""
SURFACE = """
&job model = 'surface_elastic', output = 'run.h5' /
&surface heights = '{heights}', length_x = 2e-5, length_y = 1e-5 /
&solid contact_modulus = 1e9 /
&operating mean_pressure = 1e7 /
"""
# functions of the C library that are written down before they are called
WITNESS = r"""
#define _GNU_SOURCE
#include <dlfcn.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
static void note(const char *what, const char *which)
{
   FILE *log = fopen(getenv("WITNESS"), "a");
   fprintf(log, "%s %s\n", what, which);
   fclose(log);
}
int fsync(int file)
{
   char name[64], path[4096];
   snprintf(name, sizeof name, "/proc/self/fd/%d", file);
   const ssize_t n = readlink(name, path, sizeof path - 1);
   path[n < 0 ? 0 : n] = '\0';
   note("fsync", path);
   return ((int (*)(int))dlsym(RTLD_NEXT, "fsync"))(file);
}
int rename(const char *from, const char *to)
{
   note("rename", to);
   return ((int (*)(const char *, const char *))dlsym(RTLD_NEXT, "rename"))(from, to);
}
int link(const char *from, const char *to)
{
   note("rename", to);
   return ((int (*)(const char *, const char *))dlsym(RTLD_NEXT, "link"))(from, to);
}
"""


class OddFiles(Runs):
    def run_parts(self, text, n, output="run.h5"):
        self.write(text)
        self.run_program("run", "--force", "run.nml", "--output", "whole.h5")
        for number in range(1, n + 1):
            self.run_program("run", "--quiet", "--force", "run.nml", "--shard", f"{number}/{n}", "--output", output)
        return [f"{output[:-3]}.part-{number:04}-of-{n:04}.h5" for number in range(1, n + 1)]

    def test_percent_signs(self):
        for folder, name in (("50%b", "run.h5"), ("%d", "a%s%b.h5"), ("100%", "%%.h5"), (".", "%0d%.h5")):
            with self.subTest(folder=folder, name=name):
                (self.folder / folder).mkdir(exist_ok=True)
                parts = self.run_parts(POINTS, 3, f"{folder}/{name}")
                self.run_program("merge", "--quiet", "--virtual", f"{folder}/all.h5", *parts)
                self.assert_same(self.snapshot("whole.h5"), self.snapshot(f"{folder}/all.h5"))
                # seen from another folder, by their whole names
                (self.folder / "far").mkdir(exist_ok=True)
                self.run_program("merge", "--quiet", "--virtual", "--force", "far/all.h5", *parts)
                self.assert_same(self.snapshot("whole.h5"), self.snapshot("far/all.h5"))

    def test_no_regular_part(self):
        one, _ = self.run_parts(POINTS, 2)
        os.mkfifo(self.folder / "pipe")
        (self.folder / "folder").mkdir()
        with socket.socket(socket.AF_UNIX) as server:
            here = os.getcwd()
            os.chdir(self.folder)
            server.bind("socket")
            os.chdir(here)
            for part in ("pipe", "folder", "socket", "/dev/zero", "/dev/tty", "/dev/null"):
                for options in ([], ["--virtual"]):
                    with self.subTest(part=part, options=options):
                        _, errors = self.run_program("merge", *options, "all.h5", one, part, status=3)
                        self.assertEqual(errors, f"{part}: cannot read: this is no regular file\n")
        self.assertFalse((self.folder / "all.h5").exists())

    def test_tables_that_are_no_files(self):
        # a pipe that nobody writes to, and devices: none is waited for
        (self.folder / "folder.csv").mkdir()
        os.mkfifo(self.folder / "pipe.csv")
        for table in ("pipe.csv", "folder.csv", "pipe.csv:/x"):
            name = table if ":" in table else f"{table}:load"
            self.write(POINTS.replace("from = 1, to = 2, count = 900", f"values = '{name}'"))
            with self.subTest(table=table):
                _, errors = self.run_program("check", "run.nml", status=2)
                self.assertRegex(errors, r"^run\.nml: &sweep\[1\] values: .*(no regular file|directory)")
                self.assertEqual(errors.count("\n"), 1)
        for name in ("pipe.csv", "/dev/zero", "/dev/null"):
            with self.subTest(input=name):
                _, errors = self.run_program("check", name, status=2)
                self.assertTrue(errors.startswith(f"{name}: "), errors)

    def test_link_stays(self):
        self.write(POINTS)
        (self.folder / "store").mkdir()
        (self.folder / "store/real.h5").write_text("old")
        (self.folder / "run.h5").symlink_to("store/real.h5")
        _, errors = self.run_program("run", "run.nml", status=3)
        self.assertIn("this file exists", errors)
        self.run_program("run", "--force", "run.nml")
        self.assertTrue((self.folder / "run.h5").is_symlink())
        self.assertEqual(os.readlink(self.folder / "run.h5"), "store/real.h5")
        self.run_program("run", "--force", "run.nml", "--output", "whole.h5")
        self.assert_same(self.snapshot("whole.h5"), self.snapshot("store/real.h5"))
        parts = self.run_parts(POINTS.replace("900", "800"), 2, "part.h5")
        self.run_program("merge", "--force", "run.h5", *parts)
        self.assertTrue((self.folder / "run.h5").is_symlink())
        self.assertEqual(self.status_of("store/real.h5").size, 800)
        self.assertEqual(sorted(path.name for path in (self.folder / "store").iterdir()), ["real.h5"])

    def test_lost_output(self):
        self.write(POINTS)
        for command in (["help"], ["--version"], ["check", "run.nml"], ["run", "run.nml", "--force"]):
            with self.subTest(command=command), open("/dev/full", "w") as full:
                process = subprocess.run([PROGRAM, *command], cwd=self.folder, stdout=full, stderr=subprocess.PIPE, text=True)
                self.assertEqual(process.returncode, 3)
                self.assertEqual(process.stderr, "adfric: cannot write to the standard output: No space left on device\n")
        # the results are there all the same
        self.assertTrue(np.all(self.status_of("run.h5") == 0))
        (self.folder / "run.h5").unlink()
        # closed, so that the first file to be opened would get its number
        process = subprocess.run(["sh", "-c", '"$0" run run.nml >&-', PROGRAM], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(process.returncode, 3)
        self.assertEqual(process.stderr, "adfric: cannot write to the standard output: Bad file descriptor\n")
        self.run_program("run", "--force", "run.nml", "--output", "whole.h5")
        self.assert_same(self.snapshot("whole.h5"), self.snapshot("run.h5"))
        process = subprocess.run(["sh", "-c", '"$0" run --quiet --force run.nml >&- 2>&- <&-', PROGRAM], cwd=self.folder)
        self.assertEqual(process.returncode, 0)
        self.assert_same(self.snapshot("whole.h5"), self.snapshot("run.h5"))

    def test_output_that_does_not_wait(self):
        """A pipe with little room, whose writer is told to come again."""
        whole = subprocess.run([PROGRAM, "help", "outputs"], capture_output=True, check=True).stdout
        for_reader, for_writer = os.pipe()
        room = fcntl.fcntl(for_writer, fcntl.F_SETPIPE_SZ, 4096)
        self.assertGreater(len(whole), room)
        os.set_blocking(for_writer, False)
        process = subprocess.Popen([PROGRAM, "help", "outputs"], stdout=for_writer, stderr=subprocess.PIPE)
        os.close(for_writer)
        with open(for_reader, "rb") as reader:
            # what it does when there is no more room it does soon, or later
            with contextlib.suppress(subprocess.TimeoutExpired):
                process.wait(0.5)
            self.assertEqual(reader.read(), whole)
        _, errors = process.communicate(timeout=60)
        self.assertEqual((process.returncode, errors), (0, b""))

    def test_terminal_is_gone(self):
        count = self.count_of_lasting(LOADS)
        self.write(LOADS.format(strips=16, count=count))
        process = self.start("run", "--quiet", "run.nml", threads=1)
        self.wait_for_points("run.h5.partial")
        process.send_signal(signal.SIGHUP)
        _, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 128 + signal.SIGHUP, errors)
        self.assertRegex(errors, r"^run.nml: stopped by SIGHUP, \d+ of \d+ points are in run.h5.partial; adfric run --resume")
        self.assertEqual(self.names(), ["run.h5.partial", "run.nml"])
        # nohup: it goes on
        process = self.start("run", "--quiet", "--resume", "run.nml", threads=1,
                             preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
        time.sleep(0.1)
        process.send_signal(signal.SIGHUP)
        _, errors = process.communicate(timeout=60)
        self.assertIn(process.returncode, IN_ORDER, errors)

    @unittest.skipUnless(shutil.which("cc"), "needs a C compiler")
    def test_folder_is_synchronised(self):
        self.write(POINTS)
        (self.folder / "out").mkdir()
        (self.folder / "witness.c").write_text(WITNESS)
        subprocess.run(["cc", "-shared", "-fPIC", "-o", "witness.so", "witness.c", "-ldl"], cwd=self.folder, check=True)
        for name, options in (("run.h5", []), ("out/run.h5", []), ("run.h5", ["--force"])):
            with self.subTest(name=name, options=options):
                log = self.folder / "log"
                log.unlink(missing_ok=True)
                environment = dict(os.environ, WITNESS=str(log), LD_PRELOAD=str(self.folder / "witness.so"))
                # the sanitizers want to be loaded first
                environment["ASAN_OPTIONS"] = environment.get("ASAN_OPTIONS", "") + ":verify_asan_link_order=0"
                subprocess.run([PROGRAM, "run", "--quiet", "run.nml", "--output", name, *options], cwd=self.folder, check=True,
                               env=environment)
                lines = log.read_text().splitlines()
                renamed = lines.index(f"rename {name}")
                self.assertIn(f"fsync {(self.folder / name).resolve().parent}", lines[renamed:])

    def check_surface(self, heights, status):
        self.write(SURFACE.format(heights=heights))
        if status == 0:
            self.run_program("run", "--force", "--quiet", "run.nml")
            return None
        return self.run_program("check", "run.nml", status=status)[1]

    def test_virtual_data(self):
        x, y = np.arange(16)*2*np.pi/16, np.arange(8)*2*np.pi/8
        heights = 2e-7*np.cos(x)[None, :] + 1e-7*np.cos(y)[:, None]
        layout = h5py.VirtualLayout((8, 16), "f8")
        for k in range(2):
            with h5py.File(self.folder / f"{k}%.h5", "w") as file:
                file["h"] = heights[4*k:4*k + 4]
            layout[4*k:4*k + 4] = h5py.VirtualSource(f"{k}%%.h5", "h", (4, 16))
        gap = h5py.VirtualLayout((8, 16), "f8")
        gap[:7] = h5py.VirtualSource(".", "real", (8, 16))[:7]
        own = h5py.VirtualLayout((8, 16), "f8")
        own[:] = h5py.VirtualSource(".", "real", (8, 16))
        # the same file by other names, of which HDF5 may make nothing
        named = h5py.VirtualLayout((8, 16), "f8")
        named[:4] = h5py.VirtualSource("./data.h5", "real", (8, 16))[:4]
        named[4:] = h5py.VirtualSource(f"{self.folder}/./data.h5", "real", (8, 16))[4:]
        with h5py.File(self.folder / "data.h5", "w") as file:
            file["real"] = heights
            file.create_virtual_dataset("halves", layout, fillvalue=0.0)
            file.create_virtual_dataset("own", own)
            file.create_virtual_dataset("named", named, fillvalue=0.0)
            file.create_virtual_dataset("gap", gap, fillvalue=0.0)
        through = h5py.VirtualLayout((8, 16), "f8")
        through[:] = h5py.VirtualSource("data.h5", "halves", (8, 16))
        with h5py.File(self.folder / "through.h5", "w") as file:
            file.create_virtual_dataset("h", through)
        self.check_surface("data.h5:/real", 0)
        real = self.snapshot("run.h5")
        for name in ("data.h5:/own", "data.h5:/named", "data.h5:/halves", "through.h5:/h"):
            with self.subTest(name=name):
                self.check_surface(name, 0)
                found = self.snapshot("run.h5")
                for key in real:
                    if key != "/":
                        self.assertEqual(real[key], found[key], key)
        self.assertIn("the dataset is virtual, and values of it have no source", self.check_surface("data.h5:/gap", 2))
        (self.folder / "1%.h5").unlink()
        for name in ("data.h5:/halves", "through.h5:/h"):
            with self.subTest(name=name):
                self.assertIn("its source ./1%.h5:h cannot be opened", self.check_surface(name, 2))

    def job_script(self, *arguments, program=PROGRAM, task=1):
        sbatch = self.folder / "bin" / "sbatch"
        sbatch.parent.mkdir(exist_ok=True)
        sbatch.write_text("#!/bin/sh\necho 1\n")
        sbatch.chmod(0o755)
        environment = dict(os.environ, PATH=f"{sbatch.parent}:{os.environ['PATH']}", ADFRIC=str(program),
                           SLURM_ARRAY_TASK_ID=str(task), SLURM_CPUS_PER_TASK="1")
        return subprocess.run([SCRIPT, *arguments], cwd=self.folder, env=environment, capture_output=True, text=True, timeout=60)

    def test_very_many_parts(self):
        self.write(POINTS)
        for n in ("10001", "1000000000", "99999999999999999999999"):
            process = self.job_script("run.nml", n)
            self.assertEqual((process.returncode, process.stderr),
                             (2, f"slurm_array: too many parts: {n}; allowed: up to 10000\n"))
        self.assertEqual(self.job_script("run.nml", "10000").returncode, 0)

    def test_no_success_without_a_part(self):
        self.write(POINTS)
        for status in (0, 1, 2, 77, 127, 139):
            program = self.folder / "program"
            program.write_text(f"#!/bin/sh\nexit {status}\n")
            program.chmod(0o755)
            process = self.job_script("--solve", str(program), "run.nml", "2", "run.h5")
            with self.subTest(status=status):
                self.assertEqual(process.returncode, status if status > 1 else 3, process.stderr)
                process = self.job_script("--merge", str(program), "2", "run.h5")
                self.assertNotEqual(process.returncode, 0)


if __name__ == "__main__":
    unittest.main()
