# SPDX-License-Identifier: GPL-3.0-or-later
"""Disks that are full, become full or fail while a run writes: one clear line, nothing lost, and the same bits in the end."""

import os
import shutil
import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from runs import IN_ORDER, LOADS, PROFILES, Runs, main  # noqa: E402

# mount and mkfs are not in every path
PATH = f"{os.environ['PATH']}:/usr/sbin:/sbin"
MEGABYTE = 2**20
# HDF5 takes room for descriptions in blocks of this size; the rest of the last one is not written (H5Pset_meta_block_size)
DESCRIPTIONS = 2048


class FullDisk(Runs):
    def do(self, *command):
        """A command that this machine must allow, or the test makes no sense."""
        found = shutil.which(command[0], path=PATH)
        if os.geteuid() != 0 or not found:
            self.skipTest(f"needs root and {command[0]}")
        process = subprocess.run([found, *map(str, command[1:])], capture_output=True, text=True)
        if process.returncode != 0:
            self.skipTest(f"this machine refuses {' '.join(map(str, command))}: {process.stderr.strip()}")

    def mount(self, what, where, *options):
        where.mkdir(exist_ok=True)
        self.do("mount", *options, what, where)
        self.addCleanup(self.unmount, where)

    def unmount(self, where):
        if os.path.ismount(where):
            subprocess.run(["umount", str(where)], env=dict(os.environ, PATH=PATH), check=True)

    def small_memory_disk(self, size, name="disk"):
        disk = self.folder / name
        self.mount("none", disk, "-t", "tmpfs", "-o", f"size={size}")
        return disk

    def small_disk(self, image, n_bytes, *options):
        """An ext4 file system in a file."""
        with open(image, "wb") as file:
            file.truncate(n_bytes)
        self.do("mkfs.ext4", "-q", "-F", "-m", "0", *options, image)
        self.mount(image, self.folder / "disk", "-o", "loop")
        return self.folder / "disk"

    def fill(self, disk):
        """Others take all the room that is left."""
        with open(disk / "others", "wb", buffering=0) as file:
            for n_bytes in (65536, 1024):
                try:
                    while True:
                        file.write(bytes(n_bytes))
                except OSError:
                    continue
            os.fsync(file.fileno())
        with self.assertRaises(OSError), open(disk / "more", "wb", buffering=0) as file:
            file.write(bytes(100_000))
        (disk / "more").unlink()

    def run_whole(self, text):
        """A whole run to compare with; the size of its file."""
        self.write(text)
        self.run_program("run", "run.nml", "--output", "whole.h5")
        return (self.folder / "whole.h5").stat().st_size

    def begin(self):
        """The same run on the disk, just begun."""
        process = self.start("run", "--quiet", "run.nml", "--output", "disk/run.h5", threads=1)
        self.wait_for("disk/run.h5.partial", process)
        return process

    def check_resumed(self):
        self.run_program("run", "--quiet", "--resume", "run.nml", "--output", "disk/run.h5")
        self.assert_same(self.snapshot("whole.h5"), self.snapshot("disk/run.h5"))
        self.assertEqual(self.files("disk"), ["run.h5"])

    def files(self, name):
        return sorted(path.name for path in (self.folder / name).iterdir() if path.name != "lost+found")

    def test_asked_before(self):
        disk = self.small_memory_disk("400k")
        self.write(LOADS.format(strips=16, count=400))
        # others take the room after we have asked for it
        (disk / "others").write_bytes(bytes(300_000))
        _, errors = self.run_program("run", "run.nml", "--output", "disk/run.h5", status=2)
        self.assertIn("too large for the disk", errors)
        self.assertEqual(self.files("disk"), ["others"])

    def test_full_meanwhile_in_memory(self):
        n_bytes = self.run_whole(PROFILES.format(strips=16, count=400))
        disk = self.small_memory_disk(n_bytes + 2*MEGABYTE)
        process = self.begin()
        self.fill(disk)
        # the file has all its room from the start
        _, errors = process.communicate(timeout=120)
        self.assertIn(process.returncode, IN_ORDER, errors)
        self.assert_same(self.snapshot("whole.h5"), self.snapshot("disk/run.h5"))

    def test_full_meanwhile(self):
        # the run lasts longer than it takes to fill the disk
        count = 3 * self.count_of_lasting(PROFILES)
        n_bytes = self.run_whole(PROFILES.format(strips=16, count=count))
        # an eighth and more of the disk is for its journal and its lists of files
        disk = self.small_disk(self.folder / "image", 8*MEGABYTE + n_bytes*5//4)
        process = self.begin()
        entry = (disk / "run.h5.partial").stat()
        self.assertGreater(512*entry.st_blocks, entry.st_size - DESCRIPTIONS, "the file has holes")
        self.fill(disk)
        time.sleep(0.2)
        process.send_signal(signal.SIGTERM)
        _, errors = process.communicate(timeout=120)
        self.assertEqual(process.returncode, 128 + signal.SIGTERM, errors)
        n_done = self.check_truth("disk/run.h5.partial", "whole.h5")
        self.assertGreater(n_done, 0)
        self.assertLess(n_done, 3 * count)
        # room for a new file there is not, but the old one needs none
        self.run_program("run", "run.nml", "--output", "disk/another.h5", status=2)
        self.assertEqual(self.files("disk"), ["others", "run.h5.partial"])
        (disk / "others").unlink()
        self.check_resumed()

    def test_no_room_behind_the_disk(self):
        # the disk believes that it has room, and learns better only when it writes: thin volumes, quotas of network disks
        store = self.small_memory_disk(f"{2*MEGABYTE}", "store")
        disk = self.small_disk(store / "image", 16*MEGABYTE, "-O", "^has_journal", "-E", "nodiscard,lazy_itable_init=1")
        self.do("mount", "-o", f"remount,size={MEGABYTE}", store)
        self.write(PROFILES.format(strips=16, count=400))
        _, errors = self.run_program("run", "run.nml", "--output", "disk/run.h5", status=3)
        self.assertRegex(errors, "^disk/run.h5.*: cannot bring to the disk: ")
        self.assertEqual(self.files("disk"), [])
        self.do("mount", "-o", f"remount,size={8*MEGABYTE}", store)
        self.run_program("run", "run.nml", "--output", "whole.h5")
        self.check_resumed()

    def test_disk_that_fails(self):
        n_bytes = self.run_whole(self.case_of(5.0))
        image = self.folder / "image"
        disk = self.small_disk(image, 32*MEGABYTE + 2*n_bytes)
        process = self.begin()
        time.sleep(1.5)
        # what stands in the file is on the disk; from now on the file system takes nothing more
        self.do("sync", "-f", disk)
        self.do("mount", "-o", "remount,abort", disk)
        output, errors = process.communicate(timeout=120)
        self.assertEqual((process.returncode, output), (3, ""), errors)
        self.assertRegex(errors, r"^disk/run.h5.*: cannot .*; the results so far stay in disk/run.h5.partial, "
                                 r"--resume goes on with them\n$")
        self.unmount(disk)
        # mended, which is status 1
        subprocess.run(["e2fsck", "-p", image], env=dict(os.environ, PATH=PATH), capture_output=True)
        self.mount(image, disk, "-o", "loop")
        n_done = self.check_truth("disk/run.h5.partial", "whole.h5")
        self.assertGreater(n_done, 0)
        self.assertLess(n_done, self.status_of("whole.h5").size)
        self.check_resumed()


if __name__ == "__main__":
    main()
