# SPDX-License-Identifier: GPL-3.0-or-later
"""Partial files and parts with some bits changed: the run that goes on has the right results in the end, or refuses the file."""

import random
import shutil
import struct
import subprocess
import sys
import unittest
from pathlib import Path

import h5py

sys.path.insert(0, str(Path(__file__).parent))
from runs import IN_ORDER, LOADS, PROFILES, PROGRAM, Runs  # noqa: E402

# the sanitizers are slow
N_TRIALS = 100 if b"__asan_init" in Path(PROGRAM).read_bytes() else 400
REFUSED = "cannot read: it is damaged, or no results file of adfric"
# generous: a trial takes some hundredths of a second
PATIENCE = 120


def mix(words):
    """What `adfric_mix` of src/base/checksum.c makes of words, from 0."""
    def step(total, word):
        total = ((total ^ word)*0x9E3779B97F4A7C15) % 2**64
        return total ^ (total >> 32)

    lanes = [1, 2, 3, 4]
    n = len(words) // 4*4
    for i, word in enumerate(words[:n]):
        lanes[i % 4] = step(lanes[i % 4], word)
    total = 0
    for word in [*(lanes if n > 0 else []), *words[n:]]:
        total = step(total, word)
    return total


class Damaged(Runs):
    def stopped_run(self, template, count):
        """Bytes of the file of a run that has half of its points, and the whole run beside it."""
        self.write(template.format(strips=16, count=count))
        self.run_program("run", "--quiet", "run.nml", "--output", "whole.h5")
        shutil.copy(self.folder / "whole.h5", self.folder / "run.h5.partial")
        with h5py.File(self.folder / "run.h5.partial", "r+") as file:
            status = file["status"][()]
            status.ravel()[status.size // 2:] = -1
            file["status"][...] = status
        return (self.folder / "run.h5.partial").read_bytes()

    def resume(self, content):
        """Go on with such a file; standard error, empty if the results are those of the whole run."""
        (self.folder / "run.h5.partial").write_bytes(content)
        (self.folder / "run.h5").unlink(missing_ok=True)
        process = subprocess.run([PROGRAM, "run", "--quiet", "--resume", "run.nml"], cwd=self.folder, capture_output=True,
                                 text=True, timeout=PATIENCE)
        if process.returncode in IN_ORDER:
            self.assertEqual(process.stderr, "")
            self.assert_same(self.whole, self.snapshot("run.h5"))
        else:
            self.assertEqual(process.returncode, 3, process.stderr)
            self.assertEqual(process.stderr, f"run.h5.partial: {REFUSED}\n")
            self.assertEqual((self.folder / "run.h5.partial").read_bytes(), content)
        return process.stderr

    def damage(self, good, seed, n_trials):
        dice = random.Random(seed)
        ends = {"right": 0, "refused": 0}
        for trial in range(n_trials):
            content = bytearray(good)
            # one bit, or a few bytes
            for _ in range(1 if trial % 2 == 0 else dice.randint(2, 40)):
                content[dice.randrange(len(content))] ^= 1 << dice.randrange(8)
            with self.subTest(trial=trial):
                ends["refused" if self.resume(bytes(content)) else "right"] += 1
        return ends

    def test_some_bits(self):
        good = self.stopped_run(LOADS, 100)
        self.whole = self.snapshot("whole.h5")
        self.assertEqual(self.resume(good), "")
        ends = self.damage(good, 1, N_TRIALS)
        self.assertGreater(ends["right"], 0)
        self.assertGreater(ends["refused"], 0)

    def test_profiles(self):
        good = self.stopped_run(PROFILES, 20)
        self.whole = self.snapshot("whole.h5")
        ends = self.damage(good, 2, N_TRIALS // 10)
        self.assertGreater(ends["right"], 0)

    def test_places_that_matter(self):
        good = self.stopped_run(LOADS, 100)
        self.whole = self.snapshot("whole.h5")
        with h5py.File(self.folder / "run.h5.partial") as file:
            places = {name: file[name].id.get_offset() for name in ("load", "stress", "friction_force", "status", "blocks/seal")}
            done = int((file["status"][()].ravel() >= 0).argmax())
        for name in ("load", "stress", "blocks/seal"):
            for offset in (0, 9, 23):
                content = bytearray(good)
                content[places[name] + offset] ^= 16
                with self.subTest(name=name, offset=offset):
                    self.assertIn(REFUSED, self.resume(bytes(content)))
        for name, size in (("friction_force", 8), ("status", 1)):
            content = bytearray(good)
            content[places[name] + size*done] ^= 1
            with self.subTest(name=name):
                self.assertEqual(self.resume(bytes(content)), "")
        for length in (0, 100, 3000, len(good) // 2, len(good) - 1):
            with self.subTest(length=length):
                self.assertIn(REFUSED, self.resume(good[:length]))

    def test_forged_seal(self):
        """A seal with a checksum of its own that is right, and numbers that make no sense."""
        good = self.stopped_run(LOADS, 100)
        self.whole = self.snapshot("whole.h5")
        with h5py.File(self.folder / "run.h5.partial") as file:
            place, n = file["blocks/seal"].id.get_offset(), file["blocks/seal"].size
        words = list(struct.unpack(f"<{n}Q", good[place:place + 8*n]))
        self.assertEqual(words[-1], mix(words[:-1]))
        # the size of the file, the number of holes, the first hole
        for k, value in ((2, 2**63), (2, 2**62), (4, 10**8), (4, 2**40), (4, 2**63), (4, (n - 6)//2 + 1), (5, 2**63), (6, 2**62)):
            forged = list(words)
            forged[k] = value
            forged[-1] = mix(forged[:-1])
            content = good[:place] + struct.pack(f"<{n}Q", *forged) + good[place + 8*n:]
            with self.subTest(word=k, value=value):
                self.assertIn(REFUSED, self.resume(content))

    def test_it_is_said(self):
        good = self.stopped_run(LOADS, 100)
        with h5py.File(self.folder / "run.h5.partial") as file:
            done = int((file["status"][()].ravel() >= 0).argmax())
            place = file["friction_force"].id.get_offset() + 8*done
        content = bytearray(good)
        content[place] ^= 1
        (self.folder / "run.h5.partial").write_bytes(content)
        output, _ = self.run_program("run", "--resume", "run.nml")
        self.assertRegex(output, r"damaged, solved again +\d+\n")
        # a whole file is not mended in silence
        content = bytearray((self.folder / "run.h5").read_bytes())
        with h5py.File(self.folder / "run.h5") as file:
            place = file["friction_force"].id.get_offset()
        content[place + 8] ^= 1
        (self.folder / "run.h5").write_bytes(content)
        _, errors = self.run_program("run", "--resume", "run.nml", status=3)
        self.assertRegex(errors, r"^run.h5: it is damaged, \d+ points have not the values that were written; --force")

    def test_parts(self):
        self.write(LOADS.format(strips=16, count=100))
        for number in (1, 2):
            self.run_program("run", "--quiet", "run.nml", "--shard", f"{number}/2")
        parts = [f"run.part-000{number}-of-0002.h5" for number in (1, 2)]
        good = (self.folder / parts[1]).read_bytes()
        with h5py.File(self.folder / parts[1]) as file:
            places = [file[name].id.get_offset() for name in ("friction_force", "load")]
        for place, message in zip(places, ("cannot read: it is damaged, its values are not those that were written", REFUSED)):
            content = bytearray(good)
            content[place + 1] ^= 4
            (self.folder / parts[1]).write_bytes(content)
            _, errors = self.run_program("merge", "all.h5", *parts, status=3)
            self.assertEqual(errors, f"{parts[1]}: {message}\n")
            self.assertFalse((self.folder / "all.h5").exists())


if __name__ == "__main__":
    unittest.main()
