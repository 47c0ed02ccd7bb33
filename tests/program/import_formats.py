# SPDX-License-Identifier: GPL-3.0-or-later
"""Measured surfaces in many formats: the same heights, units and axes come out of each."""

# first, since it starts the file again with the Python that has SurfaceTopography
from imports import Imports, rough

import zipfile

import h5py
import numpy as np
import scipy.io
from runs import main
from SurfaceTopography import NonuniformLineScan, Topography, UniformLineScan

NY, NX, DY, DX = 6, 9, 0.5, 0.25
UNITS = ("--unit", "um", "--height-unit", "nm")
SPACING = ("--spacing", f"{DX},{DY}")
# formats that keep numbers as text of 17 digits or in other units differ by round-off
ROUND_OFF = 4 * np.finfo(float).eps


class Formats(Imports):
    def setUp(self):
        super().setUp()
        self.heights = rough(NY, NX)
        y, x = np.meshgrid(DY * np.arange(NY), DX * np.arange(NX), indexing="ij")
        self.columns = np.stack([x.ravel(), y.ravel(), self.heights.ravel()], axis=1)

    def topography(self, **more):
        """The heights as SurfaceTopography has them, in micrometres, with a missing sample if wanted."""
        return Topography(self.heights.T / 1000, (DX * NX, DY * NY), unit="µm", **more)

    def check(self, name, *arguments, heights=None, exact=True):
        """The file has the heights [nm], the spacing and the axes."""
        expected = (self.heights if heights is None else heights) / 1e9
        z, attributes = self.read(name, *arguments, "--detrend", "none")
        np.testing.assert_allclose(z, expected, rtol=0 if exact else ROUND_OFF, atol=0 if exact else ROUND_OFF * 5e-7)
        self.assertEqual(attributes["units"], "m")
        self.assertAlmostEqual(attributes["dx"] * 1e6, DX, places=13)
        with h5py.File("read.h5") as file:
            for along, axis, step in ((1, "x", DX), (0, "y", DY))[:z.ndim]:
                scale = file["z"].dims[along - 2 + z.ndim][0]
                self.assertEqual(scale.name, "/" + axis)
                self.assertEqual(scale.attrs["units"], "m")
                np.testing.assert_allclose(scale[()], 1e-6 * step * (np.arange(len(scale)) + 0.5), rtol=1e-14)
            self.assertEqual(file.attrs["source_file"], name)
            return dict(file.attrs), attributes

    def test_numpy(self):
        np.save("a.npy", self.heights)
        self.check("a.npy", *UNITS, *SPACING)
        np.save("a.npy", self.heights.astype(np.int16))
        self.check("a.npy", *UNITS, *SPACING)
        np.savez("a.npz", front=self.heights, back=-self.heights)
        self.check("a.npz", *UNITS, *SPACING, "--channel", "front")
        self.check("a.npz", *UNITS, *SPACING, "--channel", "back", heights=-self.heights)
        np.save("line.npy", self.heights[0])
        self.check("line.npy", *UNITS, "--spacing", DX, heights=self.heights[0])

    def test_positions(self):
        head = "x [um], y [um], z [nm]"
        np.savetxt("a.xyz", self.columns, header=head)
        self.check("a.xyz")
        # in any order
        np.savetxt("a.xyz", np.random.default_rng(3).permutation(self.columns), header="x (µm)\ty (µm)\tz (nm)", encoding="utf-8")
        self.check("a.xyz")
        np.savetxt("a.csv", self.columns, header=head, comments="", delimiter=",")
        self.check("a.csv")
        np.savetxt("a.txt", self.columns)
        self.check("a.txt", *UNITS)
        # Gwyddion's head
        np.savetxt("a.txt", self.columns, header="Channel: Z\nLateral units: µm\nValue units: nm", encoding="utf-8")
        self.check("a.txt")
        # a line, with decimal commas, a line break of Windows, and a separator at the end
        rows = "".join(f"{x:.2f};{z:.1f};\r\n".replace(".", ",") for x, _, z in self.columns[:NX])
        self.write("x [um];z [nm]\r\n" + rows, "line.csv")
        self.check("line.csv", heights=self.heights[0])
        # a scan from right to left
        self.write("x [um];z [nm]\n" + "".join(f"{x};{z}\n" for x, _, z in self.columns[NX - 1::-1]), "line.csv")
        self.check("line.csv", heights=self.heights[0])
        # rows with numbers, in an encoding of two bytes
        rows = "".join(f"{i},{x},{z}\n" for i, (x, _, z) in enumerate(self.columns[:NX]))
        (self.folder / "line.csv").write_bytes(("index,x in \u00b5m,z in nm\n" + rows).encode("utf-16"))
        self.check("line.csv", heights=self.heights[0])

    def test_matrix(self):
        np.savetxt("a.csv", self.heights, delimiter=",")
        self.check("a.csv", *UNITS, *SPACING)
        head = f"Channel: Z\nWidth: {DX * NX} µm\nHeight: {DY * NY} µm\nValue units: nm"
        np.savetxt("a.asc", self.heights, header=head, encoding="utf-8")
        self.check("a.asc", exact=False)

    def test_size_in_the_head(self):
        """The head of a text export decides, however many columns there are, in any language of Gwyddion."""
        for columns, width, height, unit in ((2, "Width", "Height", "Value units"), (3, "Breite", "Höhe", "Einheit des Wertes"),
                                             (5, "Largeur", "Hauteur", "Unités")):
            with self.subTest(columns=columns):
                part = self.heights[:, :columns]
                head = f"Channel: Z\n{width}: {DX * columns} µm\n{height}: {DY * NY:g} µm\n{unit}: nm"
                for name, delimiter in (("a.txt", "\t"), ("a.dat", " "), ("a.csv", ","), ("a.asc", " ")):
                    np.savetxt(name, part, header=head, encoding="utf-8", delimiter=delimiter)
                    given = () if unit == "Value units" else ("--height-unit", "nm")
                    if columns < 4:
                        self.refuse(f"{columns} x {NY} samples are too few", name, *given)
                    else:
                        self.check(name, *given, heights=part, exact=False)

    def test_text_without_the_unit_of_its_heights(self):
        """SurfaceTopography would give sizes and heights one unit."""
        np.savetxt("a.asc", self.heights, header=f"Width: {DX * NX} um\nHeight: {DY * NY} um")
        self.refuse("--height-unit", "a.asc")
        self.check("a.asc", "--height-unit", "nm", exact=False)
        self.refuse("the file states the unit um, --unit says nm", "a.asc", "--unit", "nm")
        np.savetxt("a.asc", self.heights, header=f"Width: {DX * NX}\nHeight: {DY * NY}\nValue units: nm")
        self.refuse("a size, and no unit", "a.asc")

    def test_netcdf(self):
        self.topography(periodic=True).to_netcdf("a.nc")
        _, heights = self.check("a.nc", exact=False)
        self.assertEqual(heights["periodic"], 1)
        self.topography().to_netcdf("a.nc")
        _, heights = self.check("a.nc", exact=False)
        self.assertEqual(heights["periodic"], 0)
        UniformLineScan(self.heights[0], DX * NX * 1e3, unit="nm").to_netcdf("line.nc")
        self.check("line.nc", heights=self.heights[0])

    def test_x3p(self):
        self.topography().to_unit("m").to_x3p("a.x3p", manufacturer="Someone", model="A microscope")
        file, heights = self.check("a.x3p", exact=False)
        self.assertTrue(file["source_format"].startswith("x3p"))
        self.assertIn("A microscope", file["instrument_name"])
        self.assertEqual(file["instrument_vendor"], "Someone")
        self.assertIn("Record1", file["source_metadata"])
        output, _ = self.call("a.x3p")
        self.assertIn("periodic         no, the file does not say", output)

    def test_gwyddion(self):
        self.topography().to_gwy("a.gwy")
        self.check("a.gwy", exact=False)

    def test_matlab(self):
        scipy.io.savemat("a.mat", {"heights": self.heights})
        self.check("a.mat", *UNITS, *SPACING)

    def test_hdf5(self):
        """Datasets of the project have units and spacing; others are asked for them."""
        with h5py.File("a.h5", "w") as file:
            file["deep/z"] = self.heights
            file["deep/other"] = self.heights
        self.check("a.h5", *UNITS, *SPACING, "--channel", "/deep/z")
        with h5py.File("a.h5", "a") as file:
            file["deep/z"].attrs.update(units="nm", dx=DX * 1e-6, dy=DY * 1e-6)
        self.check("a.h5", "--channel", "deep/z")
        self.call("a.h5", "--channel", "deep/z", "-o", "first.h5", "--detrend", "none")
        self.check("first.h5", "--channel", "z")

    def test_missing_samples(self):
        mask = np.zeros((NY, NX), bool)
        mask[2, 3] = True
        heights = np.ma.array(self.heights, mask=mask)
        around = [self.heights[place] for place in ((1, 3), (3, 3), (2, 2), (2, 4))]
        filled = np.where(mask, np.mean(around), self.heights)
        np.save("a.npy", heights.filled(np.nan))
        Topography(heights.T / 1000, (DX * NX, DY * NY), unit="µm").to_netcdf("a.nc")
        np.savetxt("a.xyz", self.columns[~mask.ravel()])
        np.savetxt("b.xyz", np.where(mask.ravel()[:, None] & [False, False, True], np.nan, self.columns))
        text = "\n".join(",".join("" if gap else f"{z:g}" for z, gap in zip(*row)) for row in zip(self.heights, mask))
        self.write(text, "a.csv")
        for name, options in (("a.npy", UNITS + SPACING), ("a.nc", ()), ("a.xyz", UNITS), ("b.xyz", UNITS),
                              ("a.csv", UNITS + SPACING)):
            with self.subTest(name=name):
                _, attributes = self.check(name, *options, heights=filled, exact=False)
                self.assertEqual(attributes["missing_samples"], 1)

    def test_other_positions(self):
        """Positions that are not equidistant are interpolated, and the user is told."""
        x = np.array([0.0, 1.0, 2.5, 3.0, 4.5, 5.0])
        np.savetxt("line.csv", np.stack([x, 3 * x], axis=1))
        NonuniformLineScan(x, 3 * x, unit="um").to_netcdf("line.nc")
        for name, options in (("line.csv", ("--unit", "um")), ("line.nc", ())):
            _, errors = self.call(name, *options, "--detrend", "none", "--force")
            self.assertIn("not equidistant", errors)
            with h5py.File("line.h5") as file:
                np.testing.assert_allclose(file["z"][()], 3e-6 * np.arange(6), atol=1e-20)
        # a gap in equal steps is a missing sample
        np.savetxt("line.csv", np.stack([x := np.array([0.0, 1, 2, 4, 5, 6]), 3 * x], axis=1))
        z, attributes = self.read("line.csv", "--unit", "um", "--detrend", "none", "--most-missing", "0.2")
        np.testing.assert_allclose(z, 3e-6 * np.arange(7), atol=1e-20)
        self.assertEqual(attributes["missing_samples"], 1)


class Refused(Imports):
    def test_files(self):
        table = np.arange(24.0).reshape(6, 4)
        np.save("a.npy", table)
        np.save("cube.npy", np.zeros((4, 4, 4)))
        np.save("complex.npy", table + 1j)
        np.save("small.npy", table[:3])
        np.savez("two.npz", a=table, b=table)
        np.savez("empty.npz")
        with zipfile.ZipFile("none.npz", "w") as file:
            file.writestr("notes.txt", "no array")
        for name, data in (("bad.npy", b"no array"), ("noise.bin", bytes(range(256)) * 2), ("noise.hgt.bin", bytes(2 * 16 * 16)),
                           ("bad.x3p", b"PK\3\4 and no more"), ("bad.nc", b"CDF\1"), ("empty.csv", b""), ("zero.csv", b"1,2\0"),
                           ("bad.h5", b"\x89HDF\r\n\x1a\n")):
            (self.folder / name).write_bytes(data)
        for words, name in (
            ("there is no such file", "none.npy"), ("this is no file", "."), ("no array of real numbers", "cube.npy"),
            ("no array of real numbers", "complex.npy"), ("4 x 3 samples are too few", "small.npy"),
            ("by --channel: a, b", "two.npz"),
            ("no array of real numbers", "none.npz"),
            ("no array of real numbers", "empty.npz"),
            ("no numpy file", "bad.npy"), ("none of the formats", "noise.bin"), ("none of the formats", "noise.hgt.bin"),
            ("no x3p file that can be read", "bad.x3p"), ("no nc file that can be read", "bad.nc"), ("bad.h5: ", "bad.h5"),
            ("empty.csv: ", "empty.csv"), ("zero.csv: ", "zero.csv"),
        ):
            with self.subTest(name=name):
                self.refuse(words, name, "--unit", "m", "--spacing", "1", "--output", "out.h5")
        self.refuse("there is no channel 'c', there are a, b", "two.npz", "--channel", "c")

    def test_tables(self):
        for words, text in (
            ("line 3 has 1 columns, the table has 2", "0 1\n1 2\n2\n3 4\n"), ("line 2: 'two' is no number", "0 1\n1 two\n2 3\n"),
            ("each comma stands before three digits", "1,500 2,500\n2,500 3,500\n"),
            ("1.000,5: parts of thousands are not read", "1.000,5;2\n2.000,5;3\n"),
            ("which of the marks is decimal is not clear", "1.5;2,5\n2.5;3,5\n"),
            ("a position is missing", "0 1\nnan 2\n2 3\n3 4\n"),
            ("a position occurs twice", "0 1\n0 2\n2 3\n3 4\n"), ("back and forth", "0 1\n1 2\n0.5 3\n3 4\n"),
            ("not on a grid", "0 0 1\n1.3 1 1\n2 2.2 1\n3 0 1\n1 7 1\n"),
            ("a position occurs twice", "0 0 1\n0 1 1\n1 0 1\n1 1 1\n1 1 2\n"), ("no row of numbers", "nothing here\n"),
            ("which is not known for a length", "x [um] z [V]\n0 1\n1 2\n2 3\n"),
            ("different units", "x [um] y [mm] z [nm]\n0 0 1\n0 1 1\n1 0 1\n1 1 1\n"),
        ):
            with self.subTest(words=words):
                self.write(text, "a.csv")
                self.refuse(words, "a.csv", "--unit", "um")


if __name__ == "__main__":
    main()
