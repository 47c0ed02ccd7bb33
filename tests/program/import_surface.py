# SPDX-License-Identifier: GPL-3.0-or-later
"""What an import does to heights, and how its files appear."""

# first, since it starts the file again with the Python that has SurfaceTopography
from imports import SOURCE, Imports, rough

import os
import subprocess

import h5py
import numpy as np
from runs import main

NM = ("--unit", "nm", "--spacing", "100")
# heights of some hundred nanometres keep so much of a metre [m]
ROUND_OFF = 1e-21
N = 64
X = 2 * np.pi * np.arange(N) / N


class Treatment(Imports):
    def test_other_units_give_the_same_file(self):
        """Bit by bit where the numbers of the file are exact, as whole numbers are; decimal fractions to round-off."""
        heights = rough(6, 8)
        files = {}
        for unit, factor in (("nm", 1), ("pm", 1e-3), ("angstrom", 0.1), ("um", 1e3), ("mm", 1e6), ("m", 1e9)):
            np.savetxt("a.csv", heights / factor, delimiter=",", fmt="%.12g")
            self.read("a.csv", "--unit", unit, "--spacing", f"{250 / factor:g},{500 / factor:g}")
            files[unit] = self.snapshot("read.h5")
            del files[unit]["/"]["source_sha256"]
            with h5py.File("read.h5") as file:
                numbers = {name: file[name][()] for name in file}
            if unit == "nm":
                first = numbers
            for name, values in numbers.items():
                np.testing.assert_allclose(values, first[name], rtol=1e-12, atol=1e-13 * np.abs(first[name]).max(), err_msg=name)
        self.assert_same(files["nm"], files["pm"])
        self.assert_same(files["nm"], files["angstrom"])

    def test_tilt(self):
        heights = rough(12, 16)
        y, x = np.meshgrid(np.arange(12), np.arange(16), indexing="ij")
        plane, bowl = 3000 + 70 * x - 20 * y, 0.5 * x**2 - 0.25 * y**2 + 0.125 * x * y
        for trend, tilt in (("plane", plane), ("curvature", plane + bowl), ("mean", 1000)):
            np.save("a.npy", heights)
            flat, _ = self.read("a.npy", *NM, "--detrend", trend)
            np.save("a.npy", heights + tilt)
            found, attributes = self.read("a.npy", *NM, "--detrend", trend)
            np.testing.assert_allclose(found, flat, rtol=0, atol=1e-12 * 3e-6)
            self.assertAlmostEqual(found.mean() / 1e-9, 0, places=9)
            self.assertEqual(attributes["detrend"], trend)
            # positions in parts of the lengths, from the first sample
            u, v = x / 16, y / 12
            terms = zip(attributes["detrend_coefficients"], (1, u, v, u**2, v**2, u * v))
            np.testing.assert_allclose(found + sum(value * term for value, term in terms), (heights + tilt) / 1e9, atol=1e-12 * 3e-6)
        # the slopes are told, per length of the line or map
        np.save("a.npy", plane.astype(float) + np.where((x + y) % 2, 1, -1))
        output, _ = self.call("a.npy", *NM, "--force")
        self.assertIn("detrend          plane, slope 0.7 along x, -0.2 along y", output)
        # missing samples have no part in the tilt, and are filled behind it
        gap = plane.astype(float) + np.where((x + y) % 2, 1, -1)
        gap[4:6, 7:9] = np.nan
        np.save("a.npy", gap)
        z, attributes = self.read("a.npy", *NM)
        self.assertEqual(attributes["missing_samples"], 4)
        np.testing.assert_allclose(np.delete(z.ravel(), np.flatnonzero(np.isnan(gap))),
                                   np.delete(np.where((x + y) % 2, 1e-9, -1e-9).ravel(), np.flatnonzero(np.isnan(gap))), atol=2e-14)

    def test_gap_in_a_plane(self):
        """Harmonic functions of a plane are the plane, wherever the gap does not touch the edge."""
        plane = np.add.outer(30.0 * np.arange(9), 70.0 * np.arange(12))
        gap = plane.copy()
        gap[2:5, 4:7] = np.inf
        np.save("a.npy", gap)
        z, _ = self.read("a.npy", *NM, "--detrend", "none", "--most-missing", "0.1")
        np.testing.assert_allclose(z, plane / 1e9, atol=ROUND_OFF)
        self.refuse("9 of 108 samples are missing, a share of 0.0833; --most-missing allows 0.05", "a.npy", *NM)

    def test_gap_at_the_edge(self):
        """The first sample of a line has two neighbours if the line is a period, otherwise one; so has the first row of a map."""
        line = np.array([np.nan, 10, 20, 40, 80, 30])
        np.save("line.npy", line)
        np.save("map.npy", np.add.outer(line, [0.0, 1, 2, 3, 8]))
        options = (*NM, "--detrend", "none", "--most-missing", "0.2")
        for period, first in (("--periodic", (30 + 10) / 2), ("--no-periodic", 10)):
            z, _ = self.read("line.npy", *options, period)
            self.assertAlmostEqual(z[0] / 1e-9, first, places=9)
            # a whole row of the map is missing: its mean is that of the rows beside it
            z, _ = self.read("map.npy", *options, period)
            self.assertAlmostEqual(z[0].mean() / 1e-9, first + 2.8, places=9)

    def test_period(self):
        heights = np.add.outer(100 * np.cos(X), 50 * np.cos(3 * X))
        np.save("a.npy", heights)
        for options, expected, trend in (((), 0, "plane"), (("--periodic",), 1, "mean"), (("--no-periodic",), 0, "plane")):
            _, attributes = self.read("a.npy", *NM, *options)
            self.assertEqual((attributes["periodic"], attributes["detrend"]), (expected, trend))
        # a period whose edges do not meet
        np.save("a.npy", heights + 20 * np.arange(N))
        output, errors = self.call("a.npy", *NM, "--periodic", "--force")
        self.assertIn("the opposite edges do not meet", errors)
        self.assertIn("periodic         yes, as the option says", output)
        # a part of a period is none
        self.call("a.npy", *NM, "--periodic", "--no-periodic", "-o", "b.h5")
        with h5py.File("b.h5", "a") as file:
            file["z"].attrs["periodic"] = 1
        _, attributes = self.read("b.h5", "--channel", "z", "--region", "0,2e-6,0,2e-6")
        self.assertEqual(attributes["periodic"], 0)

    def test_parts(self):
        heights = rough(8, 12)
        np.save("a.npy", heights)
        # cells of 100 nm, the first from 0 on
        z, attributes = self.read("a.npy", *NM, "--detrend", "none", "--region", "2e-7,1e-6,1e-7,5e-7")
        np.testing.assert_array_equal(z, heights[1:5, 2:10] / 1e9)
        self.assertAlmostEqual(attributes["length_x"] * 1e6, 0.8, places=13)
        with h5py.File("read.h5") as file:
            self.assertAlmostEqual(file["x"][0] * 1e9, 250, places=9)
        z, attributes = self.read("a.npy", *NM, "--detrend", "none", "--average", "2")
        np.testing.assert_allclose(z, heights.reshape(4, 2, 6, 2).mean(axis=(1, 3)) / 1e9, atol=ROUND_OFF)
        self.assertAlmostEqual(attributes["dx"] * 1e9, 200, places=11)
        z, attributes = self.read("a.npy", "--unit", "nm", "--spacing", "100,300", "--detrend", "none", "--transpose")
        np.testing.assert_array_equal(z, heights.T / 1e9)
        self.assertAlmostEqual(attributes["dx"] * 1e9, 300, places=11)
        self.assertAlmostEqual(attributes["dy"] * 1e9, 100, places=11)
        # what does not fill a block is left out
        np.save("a.npy", rough(1, 19)[0])
        z, _ = self.read("a.npy", *NM, "--average", "3")
        self.assertEqual(z.shape, (6,))

    def test_refused(self):
        np.save("map.npy", rough(8, 12))
        np.save("line.npy", rough(1, 12)[0])
        np.save("flat.npy", np.ones((5, 5)))
        np.save("empty.npy", np.full((5, 5), np.nan))
        np.save("huge.npy", 1e300 * rough(5, 5))
        np.save("plane.npy", np.add.outer(30.0 * np.arange(9), 70.0 * np.arange(12)))
        for words, name, *options in (
            ("give --unit", "map.npy", "--spacing", "1"), ("give --spacing", "map.npy", "--unit", "nm"),
            ("the unit 'yard' is not known for a length", "map.npy", "--unit", "yard", "--spacing", "1"),
            ("the unit 'V' is not known for a length", "map.npy", *NM, "--height-unit", "V"),
            ("allowed: above 0", "map.npy", "--unit", "nm", "--spacing", "0"),
            ("--spacing has two numbers", "line.npy", *NM[:3], "1,2"),
            ("invalid number value", "map.npy", *NM[:3], "1,2,3"), ("invalid number value", "map.npy", *NM, "--region", "0,1,2"),
            ("--region has 2 numbers, a map needs 4", "map.npy", *NM, "--region", "0,1e-6"),
            ("keeps 3 samples along x", "map.npy", *NM, "--region", "0,3e-7,0,1"),
            ("--detrend line is for lines, this is a map", "map.npy", *NM, "--detrend", "line"),
            ("--detrend plane is for maps, this is a line", "line.npy", *NM, "--detrend", "plane"),
            ("a period has no plane to remove", "map.npy", *NM, "--periodic", "--detrend", "plane"),
            ("invalid choice", "map.npy", *NM, "--detrend", "tilt"), ("--average: given 0", "map.npy", *NM, "--average", "0"),
            ("--average 4 leaves 3 x 2 samples", "map.npy", *NM, "--average", "4"),
            ("--average 5 does not divide", "map.npy", *NM, "--periodic", "--average", "5"),
            ("--most-missing: given 1", "map.npy", *NM, "--most-missing", "1"), ("all samples are missing", "empty.npy", *NM),
            ("nothing is left", "flat.npy", *NM), ("all heights are the same", "flat.npy", *NM, "--detrend", "none"),
            ("nothing is left of the heights without their plane", "plane.npy", *NM),
            ("the heights are too large or too small", "huge.npy", *NM),
            ("--transpose is for maps", "line.npy", *NM, "--transpose"), ("unrecognized arguments: --speed", "map.npy", "--speed"),
            ("--frequency-unit is for master curves", "map.npy", *NM, "--frequency-unit", "Hz"),
            ("the picture has this name", "map.npy", *NM, "--output", "a.png"),
        ):
            with self.subTest(words=words):
                self.refuse(words, name, *options)
        self.refuse("required: FILE")


class Files(Imports):
    def setUp(self):
        super().setUp()
        np.save("a.npy", rough(8, 8))

    def test_nothing_is_overwritten(self):
        for name in ("a.h5", "a.png"):
            (self.folder / name).write_text("mine")
            self.refuse(f"{name}: this file exists; --force overwrites it", "a.npy", *NM, status=3)
            self.assertEqual((self.folder / name).read_text(), "mine")
            (self.folder / name).unlink()
        self.call("a.npy", *NM)
        first = (self.folder / "a.h5").read_bytes()
        self.refuse("a.h5: this file exists", "a.npy", *NM, status=3)
        self.assertEqual((self.folder / "a.h5").read_bytes(), first)
        self.call("a.npy", *NM, "--force", "--detrend", "none", "--no-picture")
        self.assertNotEqual((self.folder / "a.h5").read_bytes(), first)
        # what is read is never replaced
        self.refuse("this is the file to read", "a.h5", "--channel", "z", "--force", status=3)
        self.refuse("there is no such folder", "a.npy", *NM, "--output", "none/a.h5", status=3)
        os.mkdir("b.h5")
        self.refuse("this is no file that could be overwritten", "a.npy", *NM, "--output", "b.h5", "--force", status=3)

    def test_failure_leaves_nothing(self):
        """A picture that cannot be drawn: neither file appears."""
        os.mkdir("closed")
        (self.folder / "closed").chmod(0o500)
        if os.access("closed", os.W_OK):
            # the superuser may write there
            limit = ("bash", "-c", 'ulimit -f 1 && exec "$@"', "bash")
        else:
            limit = ()
        done = subprocess.run([*limit, SOURCE / "scripts/import_surface", "a.npy", *NM, "--output", "closed/a.h5"], text=True,
                              capture_output=True)
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertEqual(list((self.folder / "closed").iterdir()), [])

    def test_script(self):
        done = subprocess.run([SOURCE / "scripts/import_surface", "a.npy", *NM], text=True, capture_output=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("heights = 'a.h5:/z', length_x = 8e-07, length_y = 8e-07", done.stdout)
        self.assertEqual(self.names(), ["a.h5", "a.npy", "a.png"])
        self.assertTrue((self.folder / "a.png").read_bytes().startswith(b"\x89PNG"))

    def test_names_are_shown_not_obeyed(self):
        name = "\x1b[2J$x_.npy"
        np.save(name, rough(8, 8))
        output, _ = self.call(name, *NM)
        self.assertNotIn("\x1b", output)
        self.assertIn("\\x1b[2J", output)

    def test_smallest(self):
        """The fewest samples that are allowed have moments and spectra, too."""
        for heights in (rough(4, 4), rough(4, 4)[0], rough(4, 60), rough(60, 4)):
            np.save("b.npy", heights)
            for options in ((), ("--periodic",)):
                z, _ = self.read("b.npy", *NM, *options)
                self.assertEqual(z.shape, heights.shape)
                with h5py.File("read.h5") as file:
                    for name in (name for name in file if name.startswith("spectrum")):
                        self.assertGreater(len(file[name]), 0)

    def test_contact(self):
        """The program takes an imported surface as it takes the same heights from elsewhere."""
        self.call("a.npy", *NM, "--periodic")
        with h5py.File("a.h5") as file, h5py.File("own.h5", "w") as own:
            own["heights"] = file["z"][()]
        results = []
        for heights in ("a.h5:/z", "own.h5:/heights"):
            self.write(f"""
&job model = 'surface_elastic', output = 'run.h5' /
&sweep variable = 'mean_pressure', values = 1e7, 1e8 /
&surface heights = '{heights}', length_x = 8e-7, length_y = 8e-7 /
&solid contact_modulus = 1e9 /
""")
            output, _ = self.run_program("run", "--force", "run.nml")
            self.assertRegex(output, r"solved +2\n")
            with h5py.File("run.h5") as file:
                results.append([file[name][()].tobytes() for name in ("penetration", "contact_fraction", "peak_pressure")])
        self.assertEqual(*results)


if __name__ == "__main__":
    main()
