# SPDX-License-Identifier: GPL-3.0-or-later
"""Master curves: units, heads, temperature, and what is refused."""

# first, since it starts the file again with the Python that has SurfaceTopography
from imports import Imports

import h5py
import numpy as np
from runs import main

FREQUENCIES, STORAGE, LOSS = (0.5, 4.0, 32.0), (2.0, 3.0, 5.0), (0.25, 0.0, 1.5)
ROWS = "".join(f"{f},{e},{l}\n" for f, e, l in zip(FREQUENCIES, STORAGE, LOSS))
HEAD = "frequency [Hz],E' [MPa],E'' [MPa]\n"
COLD = ("--reference-temperature", "298.15")


class Curve(Imports):
    def curve(self, text, *options):
        """The group that is made of a table."""
        self.write(text, "a.csv")
        output, errors = self.call("a.csv", "--master-curve", "--force", "--no-picture", *options)
        self.assertEqual(errors, "")
        self.assertIn("master_curve = 'a.h5:/master_curve'", output)
        with h5py.File("a.h5") as file:
            group = file["master_curve"]
            self.assertEqual([group[name].attrs["units"] for name in ("omega", "storage", "loss")], ["rad/s", "Pa", "Pa"])
            self.assertEqual(group["storage"].dims[0][0].name, "/master_curve/omega")
            return {name: group[name][()] for name in group} | dict(group.attrs)

    def test_units(self):
        """The same curve in other words."""
        expected = self.curve(HEAD + ROWS, *COLD)
        np.testing.assert_array_equal(expected["omega"], 2 * np.pi * np.array(FREQUENCIES))
        np.testing.assert_array_equal(expected["storage"], 1e6 * np.array(STORAGE))
        np.testing.assert_array_equal(expected["loss"], 1e6 * np.array(LOSS))
        self.assertEqual(expected["reference_temperature"], 298.15)
        kilo = "".join(f"{f / 1000},{e * 1000},{l * 1000}\n" for f, e, l in zip(FREQUENCIES, STORAGE, LOSS))
        backwards = "\n".join(reversed(ROWS.split()))
        columns = "".join(f"{l};{f};1;{e}\n".replace(".", ",") for f, e, l in zip(FREQUENCIES, STORAGE, LOSS))
        for text, *options in (
            ("freq (kHz),storage modulus (kPa),loss modulus (kPa)\n" + kilo, *COLD),
            (HEAD + backwards, *COLD), ("Loss [MPa];Frequency [Hz];Temperature [C];Storage [MPa]\n" + columns, *COLD),
            ("f,E',E''\n" + ROWS, "--frequency-unit", "Hz", "--modulus-unit", "MPa", *COLD),
            ("f / Hz,E\u2032 / MPa,E\u2033 / MPa\n" + ROWS, *COLD), ('f [Hz],E\' [MPa],E" [N/mm^2]\n' + ROWS, *COLD),
            ("# reference temperature: 25 \u00b0C\n" + HEAD + ROWS,), ("reference temperature = 298.15 K\n" + HEAD + ROWS, *COLD),
            ("omega [Hz],E' [MPa],E'' [MPa]\n" + ROWS, "--frequency-unit", "Hz", *COLD),
        ):
            with self.subTest(text=text, options=options):
                found = self.curve(text, *options)
                for name, values in expected.items():
                    np.testing.assert_array_equal(found[name], values, name)

    def test_loss_tangent(self):
        """tan delta in place of the loss modulus; beside it only if it is named."""
        expected = self.curve(HEAD + ROWS, *COLD)
        rows = "".join(f"{f},{e},{l / e!r}\n" for f, e, l in zip(FREQUENCIES, STORAGE, LOSS))
        for head in ("tan delta", "tan(delta)", "tan_d", "Tan \u03b4", "loss factor"):
            with self.subTest(head=head):
                found = self.curve(f"f [Hz],E' [MPa],{head}\n" + rows, *COLD)
                np.testing.assert_allclose(found["loss"], expected["loss"], rtol=1e-15)
                np.testing.assert_array_equal(found["storage"], expected["storage"])
        both = "".join(f"{row},7\n" for row in rows.split())
        found = self.curve("f [Hz],E' [MPa],tan delta,E'' [MPa]\n" + both, *COLD)
        np.testing.assert_array_equal(found["loss"], 7e6)
        found = self.curve("f [Hz],E' [MPa],tan delta,E'' [MPa]\n" + both, *COLD, "--tan-delta-column", "tan delta")
        np.testing.assert_allclose(found["loss"], expected["loss"], rtol=1e-15)

    def test_logarithms(self):
        """Decimal logarithms of frequency and moduli, as heads or options say."""
        expected = self.curve("f [Hz],E' [MPa],E'' [MPa]\n" + ROWS.replace(",0.0\n", ",0.5\n"), *COLD)
        rows = "".join(f"{np.log10(f)!r},{np.log10(e)!r},{np.log10(l or 0.5)!r}\n".replace("np.float64(", "").replace(")", "")
                       for f, e, l in zip(FREQUENCIES, STORAGE, LOSS))
        for head, *options in (
            ("log f [Hz],log E' [MPa],log E'' [MPa]",), ("log10(f) [Hz],log10(E') [MPa],log10(E'') [MPa]",),
            ("log(f / Hz),lg(E' / MPa),log10(E'' [MPa])",),
            ("f [Hz],E' [MPa],E'' [MPa]", "--log10", "frequency", "storage", "loss"),
            ("a [Hz],b [MPa],c [MPa]", "--log10", "frequency", "storage", "loss", "--frequency-column", "a", "--storage-column", "b",
             "--loss-column", "c"),
            ("log_f,log_storage,log_loss", "--frequency-unit", "Hz", "--modulus-unit", "MPa"),
        ):
            with self.subTest(head=head):
                found = self.curve(head + "\n" + rows, *options, *COLD)
                for name in ("omega", "storage", "loss"):
                    np.testing.assert_allclose(found[name], expected[name], rtol=1e-14, err_msg=name)

    def test_picture(self):
        self.write(HEAD + ROWS, "a.csv")
        self.call("a.csv", "--master-curve", *COLD)
        self.assertEqual(self.names(), ["a.csv", "a.h5", "a.png"])
        self.assertTrue((self.folder / "a.png").read_bytes().startswith(b"\x89PNG"))

    def test_radians(self):
        for text, *options in (("frequency [rad/s],E' [MPa],E'' [MPa]\n",),
                               ("omega,E' [MPa],E'' [MPa]\n", "--frequency-unit", "rad/s"),
                               ("omega [Hz],E' [MPa],E'' [MPa]\n", "--frequency-unit", "rad/s")):
            with self.subTest(text=text):
                np.testing.assert_array_equal(self.curve(text + ROWS, *options, *COLD)["omega"], FREQUENCIES)

    def test_shear(self):
        found = self.curve("f [Hz],G' [MPa],G'' [MPa]\n" + ROWS, "--poisson-ratio", "0.5", *COLD)
        np.testing.assert_array_equal(found["storage"], 3e6 * np.array(STORAGE))
        np.testing.assert_array_equal(found["loss"], 3e6 * np.array(LOSS))
        self.assertEqual(found["poisson_ratio"], 0.5)

    def test_refused(self):
        for words, text, *options in (
            ("give --frequency-unit, such as Hz or rad/s", "f,E' [Pa],E'' [Pa]\n" + ROWS),
            ("give --frequency-unit", "omega,E' [Pa],E'' [Pa]\n" + ROWS), ("give --modulus-unit", "f [Hz],E',E'' [Pa]\n" + ROWS),
            ("whether that is Hz or rad/s", "omega [Hz],E' [Pa],E'' [Pa]\n" + ROWS),
            ("the unit '1/s' is not known for a frequency", "f [1/s],E' [Pa],E'' [Pa]\n" + ROWS),
            ("the unit 'psi' is not known for a modulus", "f [Hz],E' [psi],E'' [psi]\n" + ROWS),
            ("the file states the unit Hz, --frequency-unit says rad/s", HEAD + ROWS, "--frequency-unit", "rad/s"),
            ("the file states the unit MPa, --modulus-unit says Pa", HEAD + ROWS, "--modulus-unit", "Pa"),
            ("no column of the frequency", ROWS), ("no column of the loss modulus", "f [Hz],E' [Pa],eta\n" + ROWS),
            ("more than one column of the storage modulus", "f [Hz],E' [Pa],storage [Pa]\n" + ROWS),
            ("no column of the frequency", "ln f [Hz],E' [Pa],E'' [Pa]\n" + ROWS),
            ("the frequency in row 1 is inf", "log f [Hz],E' [Pa],E'' [Pa]\n400,1,1\n401,2,1\n"),
            ("the loss tangent in row 4 is -1, allowed: 0 or more", "f [Hz],E' [Pa],tan delta\n" + ROWS + "64,1,-1\n"),
            ("there is no column 'g'", HEAD + ROWS, "--storage-column", "g"), ("invalid choice", HEAD + ROWS, "--log10", "x"),
            ("both E and G", "f [Hz],E' [Pa],G'' [Pa]\n" + ROWS), ("--poisson-ratio makes", "f [Hz],G' [Pa],G'' [Pa]\n" + ROWS),
            ("--poisson-ratio: given 0.6", "f [Hz],G' [Pa],G'' [Pa]\n" + ROWS, "--poisson-ratio", "0.6"),
            ("--poisson-ratio is for shear moduli", HEAD + ROWS, "--poisson-ratio", "0.5"),
            ("the frequency in row 4 is 0 in SI units", HEAD + ROWS + "0,1,1\n"),
            ("the storage modulus in row 4 is missing", HEAD + ROWS + "64,,1\n"),
            ("the loss modulus in row 4 is -1e+06 in SI units", HEAD + ROWS + "64,1,-1\n"),
            ("a frequency occurs twice", HEAD + ROWS + "32,1,1\n"), ("1 row is no curve", HEAD + "32,1,1\n"),
            ("the file states the reference temperature 300 K", "# reference temperature: 300 K\n" + HEAD + ROWS),
            ("the reference temperature has the unit '', allowed", "# reference temperature: 300\n" + HEAD + ROWS),
            ("--unit is for surfaces", HEAD + ROWS, "--unit", "nm"),
        ):
            with self.subTest(words=words, text=text):
                self.write(text, "a.csv")
                self.refuse(words, "a.csv", "--master-curve", *options, *COLD)
        self.write(HEAD + ROWS, "a.csv")
        self.refuse("give --reference-temperature in K", "a.csv", "--master-curve")
        self.refuse("temperature is -1 K", "a.csv", "--master-curve", "--reference-temperature", "-1")


if __name__ == "__main__":
    main()
