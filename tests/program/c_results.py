# SPDX-License-Identifier: GPL-3.0-or-later
"""What the interface for C finds is what the results file of the same input has, name by name and bit by bit."""

import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

SOURCE = Path(os.environ["ADFRIC_SOURCE"])
SHOW_RESULTS = os.environ["ADFRIC_SHOW_RESULTS"]
# Small inputs: every kind of model, sweeps, profiles along one and two axes, events, lists, datasets.
INPUTS = ("johnson1997_fig5", "johnson1997_fig9a", "gm2011_fig8", "hertz_axes", "punch_stress", "line_load", "strip_load_maps", "point_load",
          "wave_1d_adhesion", "wave_2d_contact")
WAVE_3D = """
&job model = 'wavy_sliding', title = 'A wave' /
&surface kind = 'wave_3d', period = 1e-2, height = 1e-4 /
&foundation stiffness = 1e8, relaxation_time = 1e-3, retardation_ratio = 10 /
&adhesion range = 1e-5 /
&operating velocity = 0.5 /
&sweep variable = 'stress', values = 0, 2e3 /
&sweep variable = 'penetration', values = 2e-5, 8e-5, 9e-4 /
&output profiles = .true., n_x = 9, n_y = 5 /
"""
COSINES = """
&job model = 'wavy_sliding' /
&surface kind = 'cosines', period = 1e-2, amplitudes = 1e-4, 0.5e-4, phases = 0, 1 /
&foundation stiffness = 1e8, relaxation_time = 1e-3, retardation_ratio = 10 /
&operating velocity = 0.5, load = 1e3 /
"""
DATA = """
&job model = 'surface_elastic' /
&surface heights = 'surface.h5:/heights', length_x = 1e-4, length_y = 1e-4 /
&solid contact_modulus = 1e9 /
&operating mean_pressure = 1e6 /
&output profiles = .true. /
"""
# What differs from run to run, or is said of a file.
OF_THE_FILE = {"created", "history", "wall_seconds"}


def text_of(word):
    """A text that stands in hexadecimal digits behind an x."""
    return bytes.fromhex(word[1:]).decode()


def arrays_of(lines):
    """Arrays and attributes that were printed."""
    arrays, attributes = {}, {}
    for line in lines:
        kind, name, *words = line.split()
        if kind == "attribute":
            value = words[0] if words else "x"
            attributes[text_of(name)] = text_of(value) if value.startswith("x") else float.fromhex(value)
            continue
        unit, long_name, meanings = (text_of(word) for word in words[:3])
        first_flag, _, what, rank = int(words[3]), int(words[4]), words[5], int(words[6])
        dimensions = [text_of(word) for word in words[7:7 + rank]]
        shape = [int(word) for word in words[7 + rank:7 + 2*rank]]
        convert, dtype = (float.fromhex, "f8") if what == "values" else (int, "i1")
        values = np.array([convert(word) for word in words[7 + 2*rank:]], dtype=dtype).reshape(shape)
        arrays[text_of(name)] = (values, unit, long_name, meanings, first_flag, dimensions)
    return arrays, attributes


def text(value):
    """An attribute as a text."""
    return value.decode() if isinstance(value, bytes) else value


class CResults(unittest.TestCase):
    """Both ways to the results of one input."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)

    def check_input(self, path):
        """The arrays and attributes of C, and the file."""
        subprocess.run([os.environ["ADFRIC_PROGRAM"], "run", "--quiet", "--output", "results.h5", path], cwd=self.folder, check=True)
        shown = subprocess.run([SHOW_RESULTS, path], cwd=self.folder, check=True, capture_output=True, text=True)
        self.assertEqual("", shown.stderr)
        arrays, attributes = arrays_of(shown.stdout.splitlines())
        with h5py.File(self.folder / "results.h5") as file:
            names = {name for name, item in file.items() if isinstance(item, h5py.Dataset)}
            self.assertEqual(names, set(arrays))
            for name in names:
                with self.subTest(path=str(path), name=name):
                    self.check_array(file[name], *arrays[name])
            self.assertEqual(set(file.attrs) - OF_THE_FILE, set(attributes) - OF_THE_FILE)
            for name in set(attributes) - OF_THE_FILE:
                self.assertEqual(text(file.attrs[name]), attributes[name], name)

    def check_array(self, dataset, values, unit, long_name, meanings, first_flag, dimensions):
        """One array."""
        self.assertEqual(dataset.dtype, values.dtype)
        np.testing.assert_array_equal(dataset[()], values)
        self.assertEqual(text(dataset.attrs["units"]), unit)
        self.assertEqual(text(dataset.attrs["long_name"]), long_name)
        self.assertEqual(text(dataset.attrs.get("flag_meanings", "")), meanings)
        if meanings:
            self.assertEqual(dataset.attrs["flag_values"][0], first_flag)
        if not dataset.is_scale:
            scales = [dimension.keys()[0] if len(dimension) else "" for dimension in dataset.dims]
            self.assertEqual(scales, dimensions)

    def test_inputs(self):
        """Shipped inputs."""
        for name in INPUTS:
            self.check_input(SOURCE / f"inputs/{name}.nml")
            (self.folder / "results.h5").unlink()

    def test_texts(self):
        """Maps, lists and datasets."""
        generator = np.random.default_rng(1)
        with h5py.File(self.folder / "surface.h5", "w") as file:
            file["heights"] = 1e-6*generator.random((16, 32))
        for number, words in enumerate((WAVE_3D, COSINES, DATA)):
            path = self.folder / f"input_{number}.nml"
            path.write_text(words)
            self.check_input(path)
            (self.folder / "results.h5").unlink()


if __name__ == "__main__":
    unittest.main()
