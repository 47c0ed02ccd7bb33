# SPDX-License-Identifier: GPL-3.0-or-later
"""Force curves: formats, units, the direction of heights, segments, maps, and what is refused."""

# first, since it starts the file again with the Python that has afmformats
from curve_imports import SENSITIVITY, SPRING, STIFFNESS, Curves, make_curve

import sys
import unittest.mock
import zipfile

import h5py
import numpy as np
from runs import main

from afmformats.errors import FileFormatNotSupportedError
from afmformats.mod_force_distance import AFMForceDistance
from importing.curve_files import fill
from importing.curve_reading import options, read_stack
from importing.curve_source import Curve
from importing.curve_stack import array_of

# text of nine digits keeps so much of a number, and 32-bit numbers of a table of afmformats eight
DIGITS = 1e-7
LEVER = ("--spring-constant", SPRING)


class Reads(Curves):
    """Imports that are read again."""

    def read(self, *arguments, warns=False):
        """Datasets and attributes of an import."""
        output, errors = self.call(*arguments, "-o", "read.h5", "--force", "--no-picture")
        self.assertEqual(bool(errors), warns, errors)
        with h5py.File("read.h5") as file:
            found = {name: file[name][()] for name in file if isinstance(file[name], h5py.Dataset)}
            found |= {f"{name}/load": file[f"segments/{name}/load"][()] for name in file["segments"]}
            self.assertEqual(file["load"].attrs["units"], "N")
            self.assertEqual(file["approach"].attrs["units"], "m")
            self.assertEqual(len(file["load"].dims[file["load"].ndim - 1]), 1)
        return found, output, errors

    def check(self, found, position, load, rtol=DIGITS):
        """The numbers are those of a curve; heights differ by their zero."""
        np.testing.assert_allclose(found["load"], load, rtol=rtol, atol=rtol * 1e-8)
        for name, expected in (("position", position), ("approach", position - load / SPRING), ("deflection", load / SPRING)):
            shift = 0 if name == "deflection" else np.nanmean(found[name] - expected)
            np.testing.assert_allclose(found[name] - shift, expected, atol=rtol * 1e-6, err_msg=name)


class Tables(Reads):
    def test_dialects(self):
        """The same curve in other units, heads, separators and with other signs."""
        position, load, _ = make_curve()
        nm, nn = position * 1e9, load * 1e9
        for text, columns, form, options in (
            ("brackets", {"height [nm]": nm, "load [nN]": nn}, {}, LEVER),
            ("away", {"height [nm]": 5000 - nm, "load [nN]": nn}, {}, LEVER),
            ("suffix", {"piezo_um": nm / 1e3, "force_pN": nn * 1e3}, {"delimiter": ";", "separator": ";"}, LEVER),
            ("blanks", {"Height (measured) [nm]": nm, "Load / nN": nn}, {"delimiter": "  ", "separator": "  "}, LEVER),
            ("no units", {"z": nm, "force": nn}, {}, (*LEVER, "--unit", "nm", "--load-unit", "nN")),
            ("deflection", {"z [nm]": nm, "deflection [nm]": nn / SPRING}, {}, LEVER),
            ("volts", {"z [nm]": nm, "deflection [mV]": load / SPRING / SENSITIVITY * 1e3}, {}, (*LEVER, "--sensitivity", SENSITIVITY)),
            ("both", {"z [nm]": nm, "deflection [nm]": nn / SPRING, "force [nN]": nn}, {}, ()),
            ("pushed down", {"z [nm]": nm, "force [nN]": -nn}, {}, (*LEVER, "--flip-load")),
            ("named", {"a [nm]": nm, "b [nN]": nn, "load [V]": nn}, {}, (*LEVER, "--height-column", "a", "--load-column", "b [nN]")),
        ):
            with self.subTest(text=text):
                self.table("a.csv", columns, **form)
                found, output, _ = self.read("a.csv", *options)
                self.check(found, position, load)
                self.assertIn(f"heights          rise {'away from' if text == 'away' else 'towards'} the surface", output)
        # decimal commas, a preamble with the lever, and a row of units
        rows = "".join(f"{z:.6f};{f:.6f}\r\n".replace(".", ",") for z, f in zip(nm, nn))
        self.write("Instrument;AFM 3\r\nSpring constant: 0,5 N/m\r\nheight;load\r\nnm;nN\r\n" + rows, "a.csv")
        found, output, _ = self.read("a.csv")
        self.check(found, position, load, 1e-5)
        self.assertEqual(found["spring_constant"], SPRING)
        self.assertIn("columns between semicolons, decimal comma, names in line 3, units in line 4", output)

    def test_tip(self):
        """Heights of the tip need no lever; with one the base is found."""
        position, load, _ = make_curve()
        self.table("a.csv", {"indentation [nm]": (position - load / SPRING) * 1e9, "load [nN]": load * 1e9})
        found, output, _ = self.read("a.csv", *LEVER)
        self.check(found, position, load)
        self.assertIn("tip              as the file states it", output)
        found, _, _ = self.read("a.csv")
        self.assertNotIn("position", found)
        self.table("a.csv", {"height [nm]": (position - load / SPRING) * 1e9, "load [nN]": load * 1e9})
        found, _, _ = self.read("a.csv", *LEVER, "--tip")
        self.check(found, position, load)

    def test_segments(self):
        """Those that a file states by their motion, and otherwise the two sides of the turning point."""
        for dwell in (0, 30):
            position, load, segment = make_curve(dwell=dwell)
            columns = {"z [nm]": position * 1e9, "load [nN]": load * 1e9}
            for stated in (segment, np.where(segment == 2, 7, segment), None):
                with self.subTest(dwell=dwell, stated=stated is not None):
                    self.table("a.csv", columns | ({} if stated is None else {"segment": stated}))
                    found, _, _ = self.read("a.csv", *LEVER)
                    # the turning point itself may be of any of them
                    self.assertLessEqual(np.count_nonzero(found["segment"] != segment), 0 if stated is not None else 3)
                    self.assertEqual("dwell/load" in found, dwell > 0)
                    self.assertEqual(len(found["retraction/load"]), np.count_nonzero(found["segment"] == 2))
        # words, and a time in cycles, are left out
        words = np.array(["approach", "dwell", "back"])[segment]
        rows = "".join(f"{z * 1e9},{f * 1e9},{word},{i}\n" for i, (z, f, word) in enumerate(zip(position, load, words)))
        self.write("z [nm],load [nN],segment,time (cycles)\n" + rows, "a.csv")
        found, _, errors = self.read("a.csv", *LEVER, warns=True)
        self.assertIn("the column segment is left out", errors)
        self.assertIn("the column time (cycles) is left out", errors)
        self.assertLessEqual(np.count_nonzero(found["segment"] != segment), 3)
        # an approach alone
        part = segment == 0
        self.table("a.csv", {key: values[part] for key, values in columns.items()})
        found, _, _ = self.read("a.csv", *LEVER)
        self.assertFalse(found["segment"].any())

    def test_contact(self):
        """What is marked as contact or as free is so; only what lies between is left open."""
        position, load, segment = make_curve(noise=2e-11)
        self.table("a.csv", {"z [nm]": position * 1e9, "load [nN]": load * 1e9})
        found, _, _ = self.read("a.csv", *LEVER)
        # a load of a tenth of the noise does not show
        touches = np.abs(make_curve()[1]) > 2e-12
        contact = found["contact"]
        self.assertEqual(np.flatnonzero(touches & (contact == 0)).tolist(), [])
        self.assertEqual(np.flatnonzero((make_curve()[1] == 0) & (contact == 1)).tolist(), [])
        self.assertLess(np.isnan(contact).mean(), 0.15)
        self.assertAlmostEqual(found["noise"] / 2e-11, 1, delta=0.2)

    def test_map(self):
        """Curves of different lengths on a grid, in any order; one is missing, and those that cannot be used are named."""
        parts, lengths = [], {}
        for number, (x, y) in enumerate([(1, 0), (0, 0), (2, 0), (0, 1), (1, 1)]):
            position, load, _ = make_curve(samples=100 + 10 * number)
            load = load * 0 + 1e-10 * np.sin(np.arange(load.size)) if number == 3 else load
            rows = slice(4) if number == 4 else slice(None)
            lengths[x, y] = position[rows].size
            parts.append(np.stack(np.broadcast_arrays(2.0 * x, 3.0 * y, position[rows] * 1e9, load[rows] * 1e9), axis=1))
        np.savetxt("a.csv", np.concatenate(parts), delimiter=",", header="x [um],y [um],z [nm],load [nN]", comments="")
        found, output, errors = self.read("a.csv", *LEVER, warns=True)
        self.assertEqual(found["load"].shape, (2, 3, 2 * 130))
        np.testing.assert_allclose(found["x"], [0, 2e-6, 4e-6], atol=1e-20)
        np.testing.assert_allclose(found["y"], [0, 3e-6], atol=1e-20)
        for (x, y), length in lengths.items():
            self.assertEqual(np.isfinite(found["load"][y, x]).sum(), 0 if length == 4 else length)
        self.assertEqual(found["curve_status"].tolist(), [[0, 0, 0], [5, 2, 6]])
        self.assertEqual([name.decode() for name in found["curve_name"].ravel()], [f"a.csv {n}" for n in (1, 0, 2, 3, 4)] + [""])
        self.assertIn("a.csv 4: has 4 samples, allowed: at least 10", errors)
        self.assertIn("a.csv 3: no load rises above its base line", errors)
        self.assertIn("curves           3 x 2 (x, y), 3 used", output)
        self.assertIn("missing          1 of 6 curves", output)

    def test_stacks(self):
        """Files one after the other, by numbers, and as a grid that is asked for."""
        for number in range(4):
            position, load, _ = make_curve(depth=(4 + number) * 1e-8)
            self.table(f"{number}.csv", {"z [nm]": position * 1e9, "load [nN]": load * 1e9})
        names = [f"{number}.csv" for number in range(4)]
        stack, _, _ = self.read(*names, *LEVER)
        self.assertEqual(stack["load"].shape, (4, 400))
        self.assertTrue((np.diff(stack["load"].max(axis=1)) > 0).all())
        grid, _, _ = self.read(*names, *LEVER, "--grid", "2,2")
        np.testing.assert_array_equal(grid["load"], stack["load"].reshape(2, 2, 400))
        self.refuse("--grid: given 3 x 2, and there are 4 curves", *names, *LEVER, "--grid", "3,2")
        table = np.concatenate([np.insert(np.loadtxt(name, delimiter=",", skiprows=1), 0, 10 - i, axis=1) for i, name in enumerate(names)])
        np.savetxt("all.txt", table, header="curve z[nm] load[nN]", fmt="%.9g")
        one, _, _ = self.read("all.txt", *LEVER)
        np.testing.assert_array_equal(one["load"], stack["load"])

    def test_direction(self):
        """Found where the load rises, asked for where that is not clear; few that show the other direction are named."""
        names = []
        for number in range(12):
            position, load, _ = make_curve()
            self.table(f"{number}.csv", {"curve": np.full(load.size, number), "z [nm]": (-1 if number == 7 else 1) * position * 1e9,
                                         "load [nN]": load * 1e9})
            names.append(f"{number}.csv")
        rows = [(self.folder / name).read_text().split("\n", 1)[1] for name in names]
        head = "curve,z [nm],load [nN]\n"
        self.write(head + "".join(rows), "a.csv")
        found, _, errors = self.read("a.csv", *LEVER, warns=True)
        self.assertEqual(np.flatnonzero(found["curve_status"]).tolist(), [7])
        self.assertTrue(np.isnan(found["load"][7]).all())
        self.assertIn("a.csv 7: its load rises where heights are far", errors)
        self.write(head + "".join(rows[6:9]), "a.csv")
        self.refuse("2 curves show heights that rise towards the surface, 1 away from it: give --sign", "a.csv", *LEVER)
        _, _, errors = self.read("a.csv", *LEVER, "--sign", "towards", warns=True)
        self.assertIn("1 of 3 curves look as if heights rose away from the surface", errors)
        # a contact that is a small part of the range, with a pull beside it
        position, load, _ = make_curve(depth=3e-8, free=1e-6, samples=2000)
        self.table("a.csv", {"z [nm]": -position * 1e9, "load [nN]": load * 1e9})
        found, output, _ = self.read("a.csv", *LEVER)
        self.assertIn("rise away from the surface", output)
        self.assertEqual(found["curve_status"], 0)
        flat = {"z [nm]": position * 1e9, "load [nN]": np.random.default_rng(1).normal(size=load.size)}
        self.table("a.csv", flat)
        self.refuse("which end of the heights is in contact is not clear", "a.csv", *LEVER)
        self.table("a.csv", {"z [nm]": position * 1e9, "load [nN]": -load * 1e9})
        self.refuse("--flip-load", "a.csv", *LEVER)

    def test_calibration(self):
        """Another lever than that of the file: deflections stay, loads and tips follow."""
        position, load, _ = make_curve()
        self.write("# spring constant: 0.5 N/m\n# sensitivity: 40 nm/V\nz [nm],load [nN]\n" +
                   "".join(f"{z * 1e9:.7f},{f * 1e9:.7f}\n" for z, f in zip(position, load)), "a.csv")
        found, output, _ = self.read("a.csv", "--spring-constant", "0.6", "--sensitivity", "5e-8")
        np.testing.assert_allclose(found["deflection"], load / SPRING * 5 / 4, atol=1e-15)
        np.testing.assert_allclose(found["load"], 0.6 * load / SPRING * 5 / 4, atol=1e-15)
        np.testing.assert_allclose(found["position"] - found["deflection"], found["approach"], atol=1e-20)
        self.assertIn("spring constant  0.6 N/m, as --spring-constant says", output)
        # volts become metres once
        self.write("# sensitivity: 40 nm/V\nz [nm],deflection [V]\n" +
                   "".join(f"{z * 1e9:.7f},{f / SPRING / SENSITIVITY:.9f}\n" for z, f in zip(position, load)), "a.csv")
        for options, factor in (((), 1), (("--sensitivity", "5e-8"), 5 / 4)):
            found, _, _ = self.read("a.csv", *LEVER, *options)
            np.testing.assert_allclose(found["load"], factor * load, atol=1e-15)
            self.assertAlmostEqual(found["sensitivity"] / SENSITIVITY, factor, places=12)

    def test_picture_and_history(self):
        position, load, _ = make_curve()
        self.table("a.csv", {"z [nm]": position * 1e9, "load [nN]": load * 1e9})
        output, _ = self.call("a.csv", *LEVER)
        self.assertIn("file = 'a.h5:/segments/retraction/load', abscissa = 'approach', ordinate = 'load'", output)
        self.assertRegex(output, r"with its lever   abscissa_column = 'position', sigma = [\d.e-]+, spring_stiffness = 0.5\n")
        self.assertEqual(self.names(), ["a.csv", "a.h5", "a.png"])
        self.assertTrue((self.folder / "a.png").read_bytes().startswith(b"\x89PNG"))
        with h5py.File("a.h5") as file:
            self.assertIn("scripts/import_curve a.csv --spring-constant 0.5", file.attrs["history"])
        self.refuse("this file exists; --force", "a.csv", *LEVER, status=3)

    def test_refused(self):
        position, load, _ = make_curve()
        good = {"z [nm]": position * 1e9, "load [nN]": load * 1e9}
        for words, columns, *options in (
            ("the file states no spring constant, so the height of the tip is not known", good),
            ("no column of the height among load [nN], other", {"load [nN]": load, "other": load}),
            ("no column of the load or the deflection among z [nm], other", {"z [nm]": load, "other": load}),
            ("more than one column of the height: z [nm], height [nm]", good | {"height [nm]": load}, *LEVER),
            ("the file does not state the unit of the height: give --unit", {"z": position, "load [nN]": load}, *LEVER),
            ("the file does not state the unit of the load: give --load-unit", {"z [nm]": position, "load": load}, *LEVER),
            ("the unit 'V' is not known for a force", {"z [nm]": position, "load [V]": load}, *LEVER),
            ("the unit 'nN' is not known for a length", {"z [nN]": position, "load [nN]": load}, *LEVER),
            ("give --sensitivity in m/V", {"z [nm]": position, "deflection [V]": load}, *LEVER),
            ("give --spring-constant in N/m", {"z [nm]": position, "deflection [nm]": load}),
            ("are not proportional", good | {"deflection [nm]": load**2 * 1e17}, *LEVER),
            ("load over deflection of a.csv is 0.5 N/m, the spring constant 0.6 N/m", good | {"deflection [nm]": load / SPRING * 1e9},
             "--spring-constant", "0.6"),
            ("the file states the unit nN, --load-unit says pN", good, *LEVER, "--load-unit", "pN"),
            ("there is no column 'w'", good, *LEVER, "--load-column", "w"),
            ("no curve can be used: a.csv has one height alone", {"z [nm]": 0 * position, "load [nN]": load}, *LEVER, "--sign", "away"),
            ("invalid number value", good, "--spring-constant", "-1"), ("invalid number value", good, "--grid", "3"),
            ("invalid choice", good, "--sign", "up"),
        ):
            with self.subTest(words=words):
                self.table("a.csv", columns)
                self.refuse(words, "a.csv", *options)
        self.refuse("there is no such file", "none.csv")
        self.write("1,2,3\n4,5,6\n7,8,9\n", "a.txt")
        self.refuse("has a name for each of its columns", "a.txt")
        self.write("nothing", "a.jpk-force")
        self.refuse("no file of JPK Instruments that afmformats can read", "a.jpk-force")
        self.write("nothing", "a.xyz")
        self.refuse("none of the formats that afmformats knows", "a.xyz")
        self.refuse("files of the format nt-mdt end with .txt", "a.xyz", "--format", "nt-mdt")


class Formats(Reads):
    """Files of instruments, as their software would write them."""

    def setUp(self):
        super().setUp()
        self.position, self.load, self.segment = make_curve()
        self.lever = {"spring constant": SPRING, "sensitivity": SENSITIVITY, "imaging mode": "force-distance"}

    def distance(self, number=0, **more):
        """The curve as afmformats has it: heights fall towards the surface."""
        data = {"height (measured)": -self.position, "force": self.load, "segment": (self.segment > 0).astype(np.uint8)}
        return AFMForceDistance(data, {**self.lever, "enum": number, "path": self.folder / "none", "point count": self.load.size, **more})

    def test_tab_and_hdf5(self):
        self.distance().export_data(self.folder / "a.tab", fmt="tab")
        self.distance().export_data(self.folder / "a.h5", fmt="hdf5")
        for name, form in (("a.tab", "tab-separated"), ("a.h5", "HDF5-based")):
            with self.subTest(name=name):
                found, output, _ = self.read(name)
                self.check(found, self.position, self.load)
                self.assertEqual((found["spring_constant"], found["sensitivity"]), (SPRING, SENSITIVITY))
                np.testing.assert_array_equal(found["segment"], self.segment)
                self.assertIn(form, output)
                self.assertIn("rise away from the surface", output)

    def test_map_of_hdf5(self):
        """A map by its indices; one of its curves has lost its data."""
        with h5py.File("a.h5", "w") as file:
            for number in range(6):
                where = {"grid shape x": 3, "grid shape y": 2, "grid index x": number % 3, "grid index y": number // 3,
                         "position x": (number % 3) * 1e-6, "position y": (number // 3) * 2e-6}
                self.distance(number, **where).export_data(file, fmt="hdf5")
            del file["4/force"]
        found, output, errors = self.read("a.h5", warns=True)
        self.assertEqual(found["load"].shape, (2, 3, 400))
        self.assertEqual(found["curve_status"].tolist(), [[0, 0, 0], [0, 1, 0]])
        np.testing.assert_allclose(found["y"], [0, 2e-6], atol=1e-18)
        self.assertIn("import_curve: warning: a.h5 4: cannot be read: there is no load", errors)
        self.check({name: found[name][1, 2] for name in ("load", "position", "approach", "deflection")}, self.position, self.load)

    def test_two_heights(self):
        """The base is the height that differs from the tip by the deflection."""
        data = {"height (measured)": -(self.position - self.load / SPRING), "height (piezo)": -self.position,
                "tip position": -(self.position - self.load / SPRING), "force": self.load}
        curve = AFMForceDistance(data, {**self.lever, "enum": 0, "path": self.folder / "none", "point count": self.load.size})
        curve.export_data(self.folder / "a.h5", fmt="hdf5")
        found, output, _ = self.read("a.h5")
        self.check(found, self.position, self.load)
        self.assertIn("height (piezo), of 1 curve", output)
        self.distance().export_data(self.folder / "a.h5", fmt="hdf5")
        self.refuse("no curve can be read: cannot be read: there is no height (piezo)", "a.h5", "--height", "piezo", "-o", "b.h5")

    def test_height_that_is_not_there(self):
        """A reader may promise a height that the file does not have: the other one is taken."""
        class Promises(dict):
            def __getitem__(self, name):
                if name == "height (measured)":
                    raise FileFormatNotSupportedError("No data found")
                return super().__getitem__(name)

        data = Promises({"height (measured)": None, "height (piezo)": -self.position, "force": self.load})
        curve = Curve("a", spring_constant=SPRING)
        self.assertEqual(fill(curve, data, None), "height (piezo)")
        np.testing.assert_array_equal(curve.height, -self.position)
        with self.assertRaises(FileFormatNotSupportedError):
            fill(curve, data, "measured")

    def test_chiaro(self):
        # approach and retraction meet at the largest load, by which afmformats parts them
        deflection, position = self.load / SPRING, self.position
        rows = np.stack([np.arange(position.size) * 1e-3, self.load * 1e6, (position - deflection) * 1e9, deflection * 1e9, position * 1e9,
                         position * 0], axis=1)
        head = (f"Date\t01/02/2026\tTime\t10:00:00\nDevice:\tChiaro\tSoftware version\t3\nk (N/m)\t{SPRING}\tMax load (\u00b5N)\t0.1\n"
                "Piezo position (nm) (Measured)\t100\tPiezo speed  (\u00b5m/s)\t1\n\n"
                "Time (s)\tLoad (uN)\tIndentation (nm)\tCantilever (nm)\tPiezo (nm)\tAuxiliary\n")
        (self.folder / "a.txt").write_bytes(head.encode("latin-1") + "".join("\t".join(f"{v:.9g}" for v in row) + "\n" for row in rows).encode())
        found, output, _ = self.read("a.txt")
        self.check(found, self.position, self.load)
        self.assertIn("Chiaro", output)
        self.assertIn("height (piezo)", output)

    def test_workshop(self):
        """A curve, its lever from options or from the file, and a zipped map."""
        volts = self.load / SPRING / SENSITIVITY
        half = self.load.size // 2
        rows = "".join(f"{a:.7f},{b:.9f},{c:.7f},{d:.9f}\n" for a, b, c, d in zip(
            self.position[:half] * 1e9, volts[:half], self.position[half:] * 1e9, volts[half:]))
        form = ("Force-Distance Curve\nFile Format:    3\n\nDate:    Wednesday, August 1, 2018\nTime:    1:07:47 PM\nMode:    {}\n"
                "Point:    {}\nX, um:    {}\nY, um:    {}\n\nExtend Z-Sense(nm),Extend T-B(V),Retract Z-Sense(nm),Retract T-B(V)\n")
        self.write(form.format("Single", 1, 27.25, 3.5) + rows, "a.csv")
        self.refuse("the file does not state the sensitivity and the spring constant: give --sensitivity and --spring-constant", "a.csv")
        lever = (*LEVER, "--sensitivity", SENSITIVITY)
        found, _, _ = self.read("a.csv", *lever)
        self.check(found, self.position, self.load)
        with zipfile.ZipFile("a.zip", "w") as archive:
            for number in range(4):
                archive.writestr(f"{number}.csv", form.format("Mapping", number + 1, 10 + number % 2, 20 + 2 * (number // 2)) + rows)
        found, _, _ = self.read("a.zip", *lever)
        self.assertEqual(found["load"].shape, (2, 2, 400))
        np.testing.assert_allclose(found["x"], [1e-5, 1.1e-5], rtol=1e-12)

    def test_nt_mdt(self):
        """Only if the user says so: three columns of numbers may be anything."""
        half = self.load.size // 2
        # nanometres, and nanoamperes that the sensitivity [m/A] turns into a deflection; both segments from far away inwards
        current = self.load / SPRING / SENSITIVITY * 1e9
        columns = np.stack([-self.position[:half][::-1] * 1e9, current[:half][::-1], current[half:]], axis=1)
        back = np.interp(columns[:, 0], -self.position[half:] * 1e9, current[half:])
        np.savetxt("a.txt", np.column_stack([columns[:, :2], back]), fmt="%.9g")
        self.refuse("has a name for each of its columns", "a.txt", *LEVER)
        found, _, _ = self.read("a.txt", "--format", "nt-mdt", *LEVER, "--sensitivity", SENSITIVITY)
        part = found["segment"] == 0
        self.check({name: found[name][part][-half + 2:] for name in ("load", "position", "approach", "deflection")},
                   self.position[2:half], self.load[2:half])


class Library(Reads):
    """What other programs call."""

    def test_read_stack(self):
        position, load, _ = make_curve()
        self.table("a.csv", {"z [nm]": position * 1e9, "load [nN]": load * 1e9})
        stack, sources, directions, remarks = read_stack(options(files=[self.folder / "a.csv"] * 2, spring_constant=SPRING))
        self.assertEqual((stack.shape, len(sources), directions, remarks), ((2,), 2, [1, 1], []))
        np.testing.assert_allclose(array_of(stack, "load")[1], load, rtol=DIGITS, atol=1e-15)

    def test_without_afmformats(self):
        """Tables need no package; files of instruments are refused with its name."""
        hidden = {name: None for name in sys.modules if name.split(".")[0] == "afmformats"}
        position, load, _ = make_curve()
        self.table("a.csv", {"z [nm]": position * 1e9, "load [nN]": load * 1e9})
        with unittest.mock.patch.dict(sys.modules, hidden):
            found, _, _ = self.read("a.csv", *LEVER)
            self.check(found, position, load)
            self.write("", "a.ibw")
            self.refuse("files of instruments need the package afmformats", "a.ibw")


class Fitted(Reads):
    def test_fit(self):
        """The program reads the stack and finds what the curves were made of."""
        for number in range(3):
            position, load, _ = make_curve(noise=2e-11, seed=number)
            self.table(f"{number}.csv", {"z [nm]": position * 1e9, "load [nN]": (load + 3e-10) * 1e9})
        self.read("0.csv", "1.csv", "2.csv", *LEVER)
        radius = 1e-6
        self.write(f"""&job model = 'sphere', output = 'fit.h5' /
&sphere radius = {radius} /
&model theory = 'hertz' /
&data file = 'read.h5:/segments/approach/load', abscissa = 'approach', abscissa_column = 'position', ordinate = 'load', sigma = 2e-11,
      spring_stiffness = {SPRING} /
&free variable = 'contact_modulus' /
&free variable = 'contact_point' /
&free variable = 'load_offset' /
""")
        self.run_program("fit", "run.nml")
        with h5py.File("fit.h5") as file:
            self.assertFalse(file["status"][()].any())
            modulus, error = file["contact_modulus"][()], file["contact_modulus_error"][()]
            truth = STIFFNESS * 0.75 / np.sqrt(radius)
            self.assertLess(np.abs((modulus - truth) / error).max(), 3.5)
            np.testing.assert_allclose(modulus, truth, rtol=0.02)
            np.testing.assert_allclose(file["load_offset"][()], 3e-10, atol=1e-11)


if __name__ == "__main__":
    main()
