# SPDX-License-Identifier: GPL-3.0-or-later
"""Heights, lists and master curves from files to results: what is refused, what check says, parts, and runs that go on."""

import sys
import unittest
from pathlib import Path

import h5py
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from runs import Runs  # noqa: E402

PROFILE = """
&job model = 'wavy_sliding', title = 'line', output = 'run.h5' /
&surface kind = '{kind}', heights = 'data.h5:/z' {surface} /
&foundation {foundation} /
&operating velocity = 0.1 {operating} /
"""
COMMON = {"kind": "profile", "surface": "", "operating": ", penetration = 2e-5",
          "foundation": "stiffness = 1e8, moduli = 1e8, 3e8, relaxation_times = 1e-4, 1e-2"}
CURVE = "master_curve = 'curve.h5:/dma', poisson_ratio = 0.5, thickness = 1e-2"


def line(n=64):
    x = np.arange(n)*2*np.pi/n
    return 3e-5*np.cos(x) + 1e-5*np.sin(3*x)


class Heights(Runs):
    def give(self, heights, units="m", **attributes):
        """Write the file of the heights."""
        with h5py.File(self.folder / "data.h5", "w") as file:
            file["z"] = heights
            if units:
                file["z"].attrs["units"] = units
            file["z"].attrs.update(attributes)

    def give_curve(self, relaxed=1e6, last=6):
        """Write a master curve of one arm, from 1 rad/s to a power of ten."""
        omega = np.logspace(0, last, 10*last + 1)
        modulus = relaxed + 1e8*1j*omega*1e-3/(1 + 1j*omega*1e-3)
        with h5py.File(self.folder / "curve.h5", "w") as file:
            for name, values, units in (("omega", omega, "rad/s"), ("storage", modulus.real, "Pa"), ("loss", modulus.imag, "Pa")):
                file[f"dma/{name}"] = values
                file[f"dma/{name}"].attrs["units"] = units

    def write_case(self, more="", **changes):
        self.write(PROFILE.format(**(COMMON | changes)) + more)

    def refused(self, *words, **changes):
        """One line on standard error that has these words, and exit status 2, by all commands that read an input."""
        self.write_case(**changes)
        for arguments in (("check", "run.nml"), ("run", "run.nml"), ("run", "run.nml", "--shard", "1/2")):
            _, errors = self.run_program(*arguments, status=2)
            for word in words:
                self.assertIn(word, errors)
        self.assertFalse((self.folder / "run.h5").exists())

    def results(self, *arguments):
        self.run_program("run", "--quiet", "--force", "run.nml", *arguments)
        with h5py.File(self.folder / "run.h5", "r") as file:
            return {name: file[name][()] for name in ("load", "friction_force", "contact_area", "error_estimate", "status")}

    def test_units(self):
        self.give(line(), dx=1e-4)
        self.write_case()
        expected = self.results()
        self.assertEqual(expected["status"], 0)
        self.give(line()*1e3, units="mm", dx=1e-4)
        for name, value in self.results().items():
            np.testing.assert_allclose(value, expected[name], rtol=1e-9, atol=1e-14, err_msg=name)
        # the distance of samples by the input
        self.give(line()*1e6, units="um")
        self.write_case(surface=", spacing = 1e-4")
        for name, value in self.results().items():
            np.testing.assert_allclose(value, expected[name], rtol=1e-9, atol=1e-14, err_msg=name)

    def test_refused_heights(self):
        heights = line()
        self.give(heights)
        self.refused("&surface spacing: is missing [m]; it is needed for heights without an attribute dx")
        self.give(heights, dx=-1e-4)
        self.refused("&surface heights:", "dx")
        self.give(heights, units="Pa", dx=1e-4)
        self.refused("&surface heights:", "Pa")
        self.give(np.ones(64), dx=1e-4)
        self.refused("&surface heights: are all the same")
        self.give(np.arange(64.0), dx=1e-4)
        self.refused("&surface heights: are flat once trend and short waves are taken out")
        self.give(np.where(np.arange(64) == 9, np.nan, heights), dx=1e-4)
        self.refused("&surface heights:")
        self.give(heights[:3], dx=1e-4)
        self.refused("&surface heights: have too few samples along x, 4 are needed")
        self.give(np.stack([heights, heights]), dx=1e-4)
        self.refused("&surface heights: of a profile have one dimension; a dataset of two is a map")
        self.give(heights, dx=1e-4, dy=1e-4)
        self.refused("&surface heights: of a map have two dimensions, y and x", kind="map")
        self.give(np.stack([heights, heights]), dx=1e-4)
        self.refused("&surface strip_spacing: is missing [m]", kind="map")
        self.give(np.zeros((2, 2, 2)), dx=1e-4)
        self.refused("&surface heights:", kind="map")
        (self.folder / "data.h5").unlink()
        self.refused("&surface heights: there is no such file")

    def test_refused_foundations(self):
        self.give(line(), dx=1e-4)
        self.refused("&foundation moduli: are not as many as relaxation_times",
                     foundation="stiffness = 1e8, moduli = 1e8, relaxation_times = 1e-4, 1e-2")
        self.refused("&foundation relaxation_times", foundation="stiffness = 1e8, moduli = 1e8, 1e8, relaxation_times = 1e-4, -1e-2")
        # what is wrong is said once, and nothing that follows from it
        self.refused("&foundation master_curve: there is no such file", foundation=CURVE)
        self.give_curve(relaxed=0)
        self.refused("&foundation master_curve: gives a fluid", foundation=CURVE)

    def test_check(self):
        self.give(line(), dx=1e-4)
        self.write_case()
        output, _ = self.run_program("check", "run.nml")
        for words in ("arm 1: stiffness 1.000000E+08 Pa/m, relaxation time 1.000000E-04 s, retardation time",
                      "arm 2: stiffness 3.000000E+08 Pa/m, relaxation time 1.000000E-02 s, retardation time",
                      "the surface excites", "stiffness_ratio"):
            self.assertIn(words, output)
        ratio = next(words for words in output.splitlines() if "stiffness_ratio" in words).split()
        self.assertEqual([float(word) for word in ratio if word.replace(".", "").isdigit()][:1], [5.0], ratio)
        # the seam of heights that rise
        self.give(np.linspace(0, 1e-4, 64) + line(), dx=1e-4)
        self.write_case(surface=", periodise = 'none', detrend = 'none'")
        output, _ = self.run_program("check", "run.nml")
        self.assertIn("the heights do not meet where the period ends: a step of", output)

    def test_check_of_master_curves(self):
        self.give(line(), dx=1e-4)
        self.give_curve()
        self.write_case(foundation=CURVE)
        output, _ = self.run_program("check", "run.nml")
        self.assertIn("master curve: 61 frequencies,", output)
        self.assertIn("misfit of |E| at most", output)
        self.assertNotIn("beyond it friction is missing", output)
        self.give_curve(last=2)
        output, _ = self.run_program("check", "run.nml")
        self.assertIn("beyond it friction is missing", output)

    def test_parts(self):
        self.give(np.stack([line(), 0.8*line(), 0.9*line()[::-1]]), dx=1e-4, dy=1e-3)
        self.write_case(more="&sweep variable = 'penetration', from = 1e-6, to = 8e-5, count = 24 /\n", kind="map", operating="")
        self.run_program("run", "--quiet", "run.nml", "--output", "whole.h5", threads=1)
        parts = []
        for number in (1, 2, 3):
            self.run_program("run", "--quiet", "run.nml", "--shard", f"{number}/3", threads=number)
            parts.append(f"run.part-{number:04}-of-0003.h5")
        self.run_program("merge", "run.h5", *parts)
        self.assert_same(self.snapshot("whole.h5"), self.snapshot("run.h5"))

    def test_resume(self):
        self.give(line(), dx=1e-4)
        self.write_case(more="&sweep variable = 'penetration', from = 1e-6, to = 8e-5, count = 900 /\n", operating="")
        self.run_program("run", "--quiet", "run.nml", "--output", "whole.h5")
        content = (self.folder / "whole.h5").read_bytes()
        (self.folder / "run.h5.partial").write_bytes(content)
        with h5py.File(self.folder / "run.h5.partial", "r+") as file:
            file["status"][450:] = -1
        self.run_program("run", "--quiet", "--resume", "run.nml")
        self.assert_same(self.snapshot("whole.h5"), self.snapshot("run.h5"))
        # other heights are another run
        (self.folder / "run.h5").unlink()
        (self.folder / "run.h5.partial").write_bytes(content)
        self.give(2*line(), dx=1e-4)
        _, errors = self.run_program("run", "--quiet", "--resume", "run.nml", status=3)
        self.assertIn("run.h5.partial: does not belong to this run: it was made from other data", errors)


if __name__ == "__main__":
    unittest.main()
