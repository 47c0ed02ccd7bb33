# SPDX-License-Identifier: GPL-3.0-or-later
"""Power spectra, moments and the distribution of imported heights against closed forms."""

# first, since it starts the file again with the Python that has SurfaceTopography
from imports import Imports

import re
import warnings
from contextlib import contextmanager

import h5py
import numpy as np
from importing import joined_spectrum, periodogram
from importing.source import Surface, masked
from importing.spectrum_command import main as join_main
from importing.spectrum_moments import moments_of, numbers_of
from importing.treatment import remove_trend
from runs import main
from scipy.special import gamma
from SurfaceTopography import Topography, UniformLineScan
from SurfaceTopography.Container.IO import write_containers
from SurfaceTopography.Container.SurfaceContainer import InMemorySurfaceContainer

NM = ("--unit", "nm", "--spacing", "100")
N = 64


def waves(*pairs):
    """Sum of cosines of amplitude [nm] and number over N samples."""
    x = 2 * np.pi * np.arange(N) / N
    return sum(amplitude * np.cos(number * x) for amplitude, number in pairs)


class Analysis(Imports):
    def spectrum(self, heights, *options, number=1):
        """Wave numbers and density of the spectrum along x, or over the plane."""
        np.save("a.npy", heights)
        self.read("a.npy", *NM, *options)
        with h5py.File("read.h5") as file:
            density = file[f"spectrum_{number}d"]
            self.assertEqual(density.attrs["units"], f"m^{number + 2}")
            return density.dims[0][0][()], density[()]

    def test_waves_of_a_line(self):
        """A cosine of amplitude a has L a^2/4 at its wave number; Parseval: the sum over both signs is L times the variance."""
        heights = waves((100, 2), (30, 7), (10, 20))
        length = N * 100e-9
        q, density = self.spectrum(heights, "--periodic")
        np.testing.assert_allclose(q, 2 * np.pi / length * np.arange(1, N // 2), rtol=1e-14)
        for amplitude, number in ((100e-9, 2), (30e-9, 7), (10e-9, 20)):
            self.assertAlmostEqual(density[number - 1] / (length * amplitude**2 / 4), 1, places=12)
        variance = heights.var() * 1e-18
        self.assertAlmostEqual(2 * density.sum() / length / variance, 1, places=12)

    def test_waves_behind_a_window(self):
        """A part of a surface: the window spreads a wave over three wave numbers, and keeps its power."""
        q, density = self.spectrum(waves((100, 10)), "--detrend", "none")
        length = N * 100e-9
        self.assertEqual(density.argmax(), 9)
        self.assertAlmostEqual(2 * density.sum() / length / 5e-15, 1, places=12)
        self.assertLess(np.delete(density, (8, 9, 10)).max(), 1e-20 * density.max())

    def test_peak(self):
        """One sample of height h has the same power (h dx dy)^2/A in all modes of the plane."""
        heights = np.zeros((12, 16))
        heights[5, 3] = 200
        q, density = self.spectrum(heights, "--periodic", number=2)
        expected = (200e-9 * 1e-14) ** 2 / (12 * 16 * 1e-14)
        np.testing.assert_allclose(density, expected, rtol=1e-12)
        self.assertGreaterEqual(len(q), 5)
        _, density = self.spectrum(heights, "--periodic")
        np.testing.assert_allclose(density, (200e-9 * 1e-7) ** 2 / (16 * 1e-7) / 12, rtol=1e-12)

    def test_moments(self):
        """A cosine on a grid: differences of neighbours have the amplitude 2 a sin(q dx/2)."""
        amplitude, number = 100e-9, 4
        half = np.sin(np.pi * number / N)
        slope = 2 * amplitude * half / 100e-9 / np.sqrt(2)
        curvature = 4 * amplitude * half**2 / 100e-9**2 / np.sqrt(2)
        line = waves((100, number))
        for heights, letter, factor in ((line, "P", 1.0), (np.tile(line, (8, 1)), "S", 0.5)):
            expected = {"rms_height": (amplitude / np.sqrt(2), letter + "q"), "skewness": (0, letter + "sk"),
                        "kurtosis": (1.5, letter + "ku"),
                        "peak_height": (amplitude, letter + "p"), "pit_depth": (amplitude, letter + "v"),
                        "rms_slope": (slope, letter + "dq"), "rms_curvature": (factor * curvature, None),
                        "mean_deviation": (np.abs(line).mean() * 1e-9, letter + "a")}
            np.save("a.npy", heights)
            self.read("a.npy", *NM, "--periodic")
            with h5py.File("read.h5") as file:
                for name, (value, symbol) in expected.items():
                    with self.subTest(name=name, letter=letter):
                        self.assertAlmostEqual(file[name][()] / (value or 1), bool(value), places=12)
                        self.assertEqual(file[name].attrs.get("symbol"), symbol)
                width = np.diff(file["height"][:2])[0]
                self.assertAlmostEqual(file["height_density"][()].sum() * width, 1, places=12)


def density_of(q, hurst, rolloff):
    """A self-affine spectrum of density 1 at the roll-off."""
    return np.where(q < rolloff, 1.0, (np.maximum(q, rolloff) / rolloff) ** (-2 - 2 * hurst))


def draw(cells, hurst, rolloff, shortest, seed):
    """Gaussian heights of that spectrum on a period 2 pi, whose waves are the whole numbers up to the shortest one."""
    waves = np.fft.fftfreq(cells, 1 / cells)
    q = np.hypot(waves[:, None], waves[None, :])
    amplitude = np.where((q > 0) & (q <= shortest), np.sqrt(density_of(q, hurst, rolloff)), 0)
    return np.fft.ifft2(amplitude * np.fft.fft2(np.random.default_rng(seed).normal(size=q.shape))).real * cells


class Isotropic(Imports):
    """The table for `&power_spectrum`, from one measurement and from several."""

    def join(self, *arguments, status=0):
        """What import_spectrum shows on standard output and on standard error."""
        with self.joins():
            return self.call(*arguments, status=status)

    @contextmanager
    def joins(self):
        """The other command instead of import_surface."""
        type(self).import_main, type(self).program = staticmethod(join_main), "import_spectrum"
        try:
            yield
        finally:
            del type(self).import_main, type(self).program

    def table(self, name):
        """Wave numbers, densities, errors and numbers of a file."""
        with h5py.File(name) as file:
            group = file["power_spectrum"]
            self.assertEqual(group.attrs["convention"], "variance")
            self.assertEqual([group[each].attrs["units"] for each in ("wave_number", "density", "density_error")], ["rad/m", "m^4", "m^4"])
            return {each: group[each][()] for each in group}, dict(group.attrs)

    def test_windows_of_a_part(self):
        """Seams of a part put a spectrum of q^-3 over the short waves; a window takes it away. Both in either unit of the file."""
        excess = {}
        for window in ("none", "hann"):
            excess[window] = []
            for seed in (1, 2, 3):
                np.save("a.npy", draw(256, 0.8, 4, 64, seed)[:128, :128])
                # a wave of number k has 2 pi k/256 um
                self.call("a.npy", "--unit", "um", "--spacing", f"{2 * np.pi / 256:.16g}", "--window", window, "--force", "--no-picture")
                found, attributes = self.table("a.h5")
                self.assertEqual((attributes["windows"][0], attributes["detrend"][0]), (window, "plane"))
                q = found["wave_number"] * 1e-6
                np.testing.assert_allclose(q[[0, -1]], (4, 64), rtol=1e-9)
                excess[window].append(np.log(found["density"] / 1e-24 / density_of(q, 0.8, 4)))
                if window == "hann":
                    true = numbers_of(found["wave_number"], density_of(q, 0.8, 4) * 1e-24)
                    for name, value in true.items():
                        self.assertLess(abs(found[name] - value), 4 * found[f"{name}_error"], name)
        # where waves are shorter than a quarter of the roll-off
        mean = {window: np.exp(np.mean([one[q > 16] for one in of_seeds])) for window, of_seeds in excess.items()}
        self.assertGreater(mean["none"], 1.3)
        self.assertLess(abs(mean["hann"] - 1), 0.05)
        np.save("a.npy", draw(256, 0.8, 4, 64, 3)[:128, :128] * 1e3)
        self.call("a.npy", "--unit", "nm", "--spacing", f"{2000 * np.pi / 256:.16g}", "--force", "--no-picture")
        for name, values in self.table("a.h5")[0].items():
            np.testing.assert_allclose(values, found[name], rtol=1e-7, err_msg=name)

    def test_errors(self):
        """Moments miss those of the spectrum by their errors, over 40 parts."""
        found = []
        for seed in range(40):
            part = draw(96, 0.5, 6, 24, seed)[:48, :48]
            surface = Surface(masked(part - part.mean()), (2 * np.pi / 96,) * 2, False)
            joined = joined_spectrum.join([periodogram.periodogram_of(surface, "", *periodogram.shortest_wave(surface))])
            true = numbers_of(joined.wave_numbers, density_of(joined.wave_numbers, 0.5, 6))
            found.append([(value - true[name]) / error for name, (value, error) in moments_of(joined).items()])
        spread = np.sqrt(np.mean(np.square(found), axis=0))
        self.assertTrue((spread > 0.6).all() and (spread < 1.6).all(), spread)

    def spectrum_of(self, heights, cells, is_periodic=True):
        """Spectrum and periodogram of heights with 2 pi/cells between the samples."""
        surface = Surface(masked(heights - heights.mean()), (2 * np.pi / cells,) * heights.ndim, is_periodic)
        each = periodogram.periodogram_of(surface, "", *periodogram.shortest_wave(surface))
        return joined_spectrum.join([each]), each

    def test_ring_of_a_period(self):
        """Without chance in the powers the table has the variances of the waves, whose longest one is the period or a part of it."""
        for hurst, longest, shortest in ((0.2, 1, 16), (0.8, 1, 16), (1.0, 1, 9), (0.8, 4, 13)):
            part = draw(64, hurst, 1, shortest, 1)
            x = np.fft.fftfreq(64, 1 / 64)
            q = np.hypot(x[:, None], x[None, :])
            power = np.where((q >= longest) & (q <= shortest), np.maximum(q, 1) ** (-2 - 2 * hurst), 0)
            transform = np.fft.fft2(part)
            phases = np.where(power > 0, transform / np.maximum(np.abs(transform), 1e-300), 0)
            joined, each = self.spectrum_of(np.fft.ifft2(np.sqrt(power) * phases).real * 64**2, 64)
            # the waves of the lattice that are there
            there = q[power > 0]
            np.testing.assert_allclose(each.ends, (there.min(), there.max()), rtol=1e-9)
            self.assertEqual(each.reason, "4 samples" if shortest == 16 else "shorter waves have no power")
            found = moments_of(joined)
            for name, n in (("root_mean_square_height", 0), ("root_mean_square_slope", 2)):
                exact = np.sqrt(np.sum(power * q**n))
                self.assertLess(abs(found[name][0] / exact - 1), 0.03, (hurst, longest, shortest, name))
            self.assertGreater(found["root_mean_square_height"][1], 0.01 * found["root_mean_square_height"][0])

    def test_ring_of_a_rectangle(self):
        """Waves of a period of 2 to 1 that are no longer than its width; the row before them stands for the rest of their area."""
        ring = periodogram.first_ring((4 * np.pi, 2 * np.pi), 1.0, 8.0)
        self.assertAlmostEqual(np.pi * ring.begin**2, 3 * 0.5, places=12)
        self.assertAlmostEqual(np.pi * (ring.end**2 - ring.begin**2), len(ring.waves) * 0.5, places=12)
        # waves of (0, 1), (1/2, 1) and (1, 0)
        np.testing.assert_allclose(np.sort(ring.waves), [1] * 4 + [np.sqrt(1.25)] * 4, rtol=1e-12)

    def test_steep_part_behind_a_window(self):
        """A window mixes longer waves into steep spectra: height and slope would be too large."""
        found, mixed = [], []
        for seed in range(12):
            part = draw(128, 1.0, 1, 32, seed)[:64, :64]
            surface = remove_trend(Surface(masked(part), (2 * np.pi / 128,) * 2, False), "plane", "")[0]
            joined, each = self.spectrum_of(surface.heights.data, 128, False)
            each.blur = 0.0
            mixed.append(moments_of(joined_spectrum.join([each]))["root_mean_square_height"][0])
            true = numbers_of(joined.wave_numbers, joined.wave_numbers**-4.0)
            found.append([(value / true[name] - 1, error / value) for name, (value, error) in moments_of(joined).items()][:2])
        bias = np.mean(found, axis=0)
        self.assertGreater(np.mean(mixed) / true["root_mean_square_height"], 1.15)
        self.assertLess(abs(bias[0, 0]), 0.08)
        self.assertLess(abs(bias[1, 0]), 0.04)
        self.assertTrue((np.abs(bias[:, 0]) < bias[:, 1]).all(), bias)

    def test_line_of_a_power(self):
        """C = q^(-2 - 2H) has C1 = sqrt(pi) gamma(H + 1/2)/gamma(H + 1) q^(-1 - 2H)."""
        q = np.geomspace(2, 300, 7)
        one = np.ones((7, 1))
        each = periodogram.Periodogram("", False, one[:, 0], one[:, 0], q[:, None], one, (2, 300), "none", "")
        x = np.linspace(np.log(2), np.log(300), 21)
        for hurst in (0.3, 0.8, 1.0):
            model, slope = joined_spectrum.evaluate([joined_spectrum.row_of(each, x)], -(2 + 2 * hurst) * x)
            exact = np.sqrt(np.pi) * gamma(hurst + 0.5) / gamma(hurst + 1) * q ** (-1 - 2 * hurst)
            np.testing.assert_allclose(np.exp(model), exact, rtol=1e-5)
            # twice the heights, four times the spectrum
            np.testing.assert_allclose(slope.sum(axis=1), 1, rtol=1e-9)

    def test_line_that_ends_as_steep_as_allowed(self):
        """The slope beyond the last wave is at most -2; the least of the likelihood of this line is there, and it is found."""
        joined, each = self.spectrum_of(draw(128, 0.2, 1, 16, 26)[5], 128)
        height, error = moments_of(joined)["root_mean_square_height"]
        self.assertAlmostEqual(each.ends[1], 16, places=9)
        q = np.geomspace(1, 16, 200)
        self.assertLess(abs(height - numbers_of(q, density_of(q, 0.2, 1))["root_mean_square_height"]), 2 * error)

    def test_program_reads_the_table(self):
        """`adfric check` has the numbers of the file."""
        np.save("a.npy", draw(64, 0.8, 3, 16, 5))
        output, _ = self.call("a.npy", "--unit", "nm", "--spacing", "50", "--periodic", "--no-picture")
        named = re.search(r"wave_numbers = .*'variance'", output).group()
        self.write(f"&surface kind = 'spectrum' /\n&power_spectrum {named} /\n&solid contact_modulus = 1e9 /\n&operating mean_pressure = 1e6 /\n")
        shown, _ = self.run_program("check", "run.nml")
        found, _ = self.table("a.h5")
        for name in ("root_mean_square_height", "root_mean_square_slope", "root_mean_square_curvature", "nayak_parameter"):
            self.assertAlmostEqual(float(re.search(rf"{name} +(\S+)", shown).group(1)) / found[name], 1, places=11)

    def measure(self, factor=1.0):
        """A line, a coarse map and a fine one of a surface, in a container; numbers of its spectrum over all their waves."""
        heights, step = 0.01 * draw(512, 0.7, 6, 128, 7), 2 * np.pi / 512
        parameters = {"tip_radius": {"value": 1e-4, "unit": "mm"}}, {"resolution": {"value": 300, "unit": "nm"}}
        line, coarse = ({"name": name, "instrument": {"name": name, "parameters": each}}
                        for name, each in zip(("line", "coarse"), parameters))
        write_containers([InMemorySurfaceContainer([
            UniformLineScan(heights[77], 2 * np.pi, unit="um", info=line),
            Topography(heights[::4, ::4].T, (2 * np.pi,) * 2, unit="um", info=coarse).to_unit("mm"),
            Topography(heights[:128, :128].T * factor, (128 * step,) * 2, unit="um", info={"name": "fine"}).to_unit("nm")])], "twin.zip")
        q = np.geomspace(2, 128, 400)
        return numbers_of(q * 1e6, density_of(q, 0.7, 6) * 1e-28)

    def test_instruments_are_joined(self):
        """A container of three measurements with units and reliable ranges of their own, and the same as single files."""
        true = self.measure()
        output, errors = self.join("twin.zip", "-o", "all.h5", "--no-picture")
        self.assertEqual(errors, "")
        found, attributes = self.table("all.h5")
        for name, value in true.items():
            self.assertLess(abs(found[name] - value), 4 * found[f"{name}_error"], name)
            self.assertLess(found[f"{name}_error"], 0.2 * value)
        self.assertEqual(list(attributes["measurements"]), ["twin.zip: line", "twin.zip: coarse", "twin.zip: fine"])
        self.assertAlmostEqual(attributes["shortest_waves"][1] / 3e-7, 1, places=9)
        self.assertIn("resolution", attributes["shortest_because"][1])
        self.assertGreater(attributes["shortest_waves"][0], 4 * 2e-6 * np.pi / 512)
        self.assertEqual(self.names(), ["all.h5", "twin.zip"])
        # the fine map alone, from its own file
        np.save("fine.npy", 0.01 * draw(512, 0.7, 6, 128, 7)[:128, :128])
        self.call("fine.npy", "--unit", "um", "--spacing", f"{2 * np.pi / 512:.16g}", "--no-picture")
        self.join("fine.h5", "-o", "one.h5")
        self.assertEqual((self.folder / "one.png").read_bytes()[:4], b"\x89PNG")
        self.join("twin.zip", "--leave-out", "twin.zip: line", "twin.zip: coarse", "-o", "other.h5", "--no-picture")
        one, other, alone = (self.table(name)[0] for name in ("one.h5", "other.h5", "fine.h5"))
        for name, values in one.items():
            np.testing.assert_allclose(values, alone[name], rtol=1e-9, err_msg=name)
            np.testing.assert_allclose(values, other[name], rtol=1e-6, err_msg=name)

    def test_what_contradicts_is_told(self):
        """Heights of another unit, and a range without data."""
        self.measure(factor=3.0)
        _, errors = self.join("twin.zip", "--no-picture")
        self.assertRegex(errors, r"warning: twin.zip: fine: its spectrum is [\d.]+ times that of twin.zip: coarse at the same waves, and it is")
        self.assertNotRegex(errors, "(line|coarse): its spectrum")
        self.assertLess(abs(np.log(float(re.search(r"is ([\d.]+) times", errors).group(1)) / 9)), 0.5)
        for name, spacing in (("a", "1"), ("b", "100")):
            np.save(f"{name}.npy", draw(32, 0.8, 2, 16, 1))
            self.call(f"{name}.npy", "--unit", "nm", "--spacing", spacing, "--no-picture")
        _, errors = self.join("a.h5", "b.h5", "--force", "--no-picture")
        self.assertIn("no measurement has waves of 1.6e-08 to 4e-07 m", errors)

    def test_what_cannot_be_joined(self):
        """A wrong unit beside two others and beside one other, one measurement twice, containers without anything."""
        # SurfaceTopography leaves files of containers open, and Python says so in the next call
        ignored = warnings.catch_warnings()
        ignored.__enter__()
        self.addCleanup(ignored.__exit__, None, None, None)
        warnings.simplefilter("ignore", ResourceWarning)
        self.measure(factor=1e3)
        with self.joins():
            self.refuse("twin.zip: fine: its spectrum is", "twin.zip")
            self.refuse("and it is further from the median of all: are the units right? --leave-out NAME", "twin.zip")
            self.refuse("and nothing says which one is wrong", "twin.zip", "--leave-out", "twin.zip: line")
        self.join("twin.zip", "--leave-out", "twin.zip: fine", "--no-picture", "-o", "good.h5")
        np.save("a.npy", draw(32, 0.8, 2, 8, 1))
        self.call("a.npy", *NM, "--no-picture")
        self.call("a.npy", *NM, "--no-picture", "-o", "b.h5")
        with self.joins():
            self.refuse("a.h5 (1) and a.h5 (2) have the same heights", "a.h5", "a.h5")
            self.refuse("a.h5 and b.h5 have the same heights", "a.h5", "b.h5")
            self.refuse("there is no measurement 'a.h5', there are a.h5 (1), a.h5 (2)", "a.h5", "a.h5", "--leave-out", "a.h5")
            write_containers([InMemorySurfaceContainer([])], "none.zip")
            self.refuse("none.zip: there is no measurement in it", "none.zip")
            write_containers([], "empty.zip")
            self.refuse("empty.zip: there is no surface in it", "empty.zip")

    def test_refused(self):
        np.save("a.npy", draw(16, 0.8, 2, 8, 1))
        for words, *options in (("--window is for a part", "--periodic", "--window", "hann"), ("--tip-radius: given 0", "--tip-radius", "0"),
                                ("give one", "--tip-radius", "1e-9", "--shortest-reliable", "1e-7")):
            self.refuse(words, "a.npy", *NM, *options)
        # waves that are too few are no error of an import: there is no group
        output, _ = self.call("a.npy", *NM, "--shortest-reliable", "1e-6", "--no-picture")
        self.assertIn("power spectrum   none: too few waves", output)
        self.measure()
        with self.joins():
            self.refuse("there is no power spectrum in it", "a.h5")
            self.refuse("neither a file of scripts/import_surface nor a container", "a.npy")
            self.refuse("there is no measurement 'b', there are twin.zip: line", "twin.zip", "--leave-out", "b")


if __name__ == "__main__":
    main()
