# SPDX-License-Identifier: GPL-3.0-or-later
"""From what instruments would write to friction: the shipped inputs that need imported data, and the commands in their heads."""

# first, since it starts the file again with the Python that has SurfaceTopography
from imports import SOURCE, Imports

import shlex
import sys

import h5py
import numpy as np
from runs import main

sys.path.insert(0, str(SOURCE / "scripts"))

import make_measurement  # noqa: E402


class Rubber(Imports):
    def solve(self, name, **changes):
        """Results of a shipped input, after the commands that its head names, with some lines changed."""
        text = (SOURCE / "inputs" / f"{name}.nml").read_text()
        for line in text.splitlines():
            if line.startswith("!   scripts/"):
                self.obey(*shlex.split(line[4:]))
        for old, new in changes.items():
            self.assertIn(old, text)
            text = text.replace(old, new)
        self.write(text)
        self.run_program("run", "--force", "--output", "run.h5", "run.nml")
        with h5py.File("run.h5") as file:
            self.assertFalse(file["status"][()].any())
            return {key: data[()] for key, data in file.items() if isinstance(data, h5py.Dataset)}

    def obey(self, command, *arguments):
        """Do what a command in the head of an input does."""
        if command == "scripts/make_measurement":
            sys.argv[1:] = arguments
            make_measurement.main()
        else:
            self.assertEqual(command, "scripts/import_surface")
            self.call(*arguments, "--no-picture", "--force")

    def test_master_curve(self):
        """Friction of the fitted curve is that of the arms within the scatter of the curve and the errors of both fits, where neither
        spectrum ends; at 1e-6 m/s the arms end, and at 1e-5 m/s they begin to."""
        curve, arms = (self.solve(name, **{"count = 181": "count = 10"}) for name in ("rubber_master_curve", "rubber_velocity"))
        self.assertEqual(10, curve["velocity"].size)
        room = list(arms["temperature"]).index(298.15)
        np.testing.assert_allclose(curve["friction_coefficient"][2:], arms["friction_coefficient"][room, 2:], rtol=0.05)

    def test_line_scan(self):
        """Tilt and missing samples make little of a difference."""
        scan = self.solve("line_scan")
        with h5py.File("line_scan.h5", "w") as file:
            file["z"] = make_measurement.make_line(4000, 2e-6, 0.8, 2e-3, 1e-4, 4e-5, 1)
            file["z"].attrs["dx"] = 2e-6
        self.run_program("run", "--force", "--output", "run.h5", "run.nml")
        with h5py.File("run.h5") as file:
            np.testing.assert_allclose(scan["friction_coefficient"], file["friction_coefficient"][()], rtol=1e-3)
            np.testing.assert_allclose(scan["pressure"].mean(axis=1), 2e5, rtol=0.02)


if __name__ == "__main__":
    main()
