# SPDX-License-Identifier: GPL-3.0-or-later
"""Write a line scan and a master curve as instruments would: made here, not measured.

The line is rough like asphalt, with a tilt and a few samples missing. The master curve is that of a fractional Zener solid, the rubber of
inputs/rubber_velocity.nml, with a scatter. scripts/import_surface reads both files.
"""

import sys

import numpy as np

from make_options.measurement import read_command_line

# of the rubber: relaxed and glassy modulus [Pa], exponent, time [s], temperature [K]
RELAXED, GLASSY, EXPONENT, TIME, TEMPERATURE = 2.1e6, 2.0e9, 0.55, 1.0e-7, 298.15


def make_line(samples, spacing, hurst, longest, shortest, rms, seed):
    """Heights [m] of a self-affine line that is no period: a part of one that is twice as long, waves in the same units as the spacing."""
    length = 2 * samples
    number = np.fft.rfftfreq(length, spacing)
    power = np.zeros_like(number)
    is_kept = (number >= 1 / longest) & (number <= 1 / shortest)
    power[is_kept] = number[is_kept] ** (-1 - 2 * hurst)
    dice = np.random.default_rng(seed)
    amplitudes = np.sqrt(power) * (dice.normal(size=number.size) + 1j * dice.normal(size=number.size))
    heights = np.fft.irfft(amplitudes, length)[:samples]
    return (heights - heights.mean()) * (rms / heights.std())


def complex_modulus(omega):
    """E' + i E'' [Pa] of the rubber at angular frequencies [rad/s]."""
    glass = (1j * omega * TIME) ** EXPONENT
    return RELAXED + (GLASSY - RELAXED) * glass / (1 + glass)


def write_line(path, spacing, heights, tilt, missing, seed):
    """Positions in mm and heights in um, some of them missing."""
    is_missing = np.random.default_rng(seed).random(heights.size) < missing
    with open(path, "w", encoding="utf-8") as file:
        file.write("# line scan, made by scripts/make_measurement, not measured\nx [mm],z [um]\n")
        for i, height in enumerate(heights):
            shown = "" if is_missing[i] else f"{1e6 * (height + tilt * i * spacing):.4f}"
            file.write(f"{1e3 * i * spacing:.4f},{shown}\n")


def write_curve(path, lowest, highest, per_decade, scatter, seed):
    """Frequencies in Hz and moduli in MPa."""
    count = round(per_decade * np.log10(highest / lowest)) + 1
    frequency = np.geomspace(lowest, highest, count)
    modulus = complex_modulus(2 * np.pi * frequency)
    factors = 1 + scatter * np.random.default_rng(seed).normal(size=(2, count))
    with open(path, "w", encoding="utf-8") as file:
        file.write("# master curve, made by scripts/make_measurement, not measured\n")
        file.write(f"# reference temperature: {TEMPERATURE} K\nfrequency [Hz],E' [MPa],E'' [MPa]\n")
        for row in zip(frequency, modulus.real * factors[0] / 1e6, modulus.imag * factors[1] / 1e6):
            file.write(",".join(f"{value:.6e}" for value in row) + "\n")


def main():
    """Read the options and write the files."""
    given = read_command_line(sys.argv[1:])
    heights = make_line(given.samples, given.spacing, given.hurst, given.longest, given.shortest, given.rms, given.seed)
    write_line(given.folder / "line_scan.csv", given.spacing, heights, given.tilt, given.missing, given.seed + 1)
    write_curve(given.folder / "dma.csv", 1.0e-4, 1.0e10, 4, given.scatter, given.seed + 2)


if __name__ == "__main__":
    main()
