# SPDX-License-Identifier: GPL-3.0-or-later
"""HDF5 files with axes and units, and how files appear: whole or not at all, and never in the place of another by accident."""

import io
import os
from contextlib import contextmanager, suppress

import h5py
import numpy as np

from .problems import FileFailure, first_line


def check_target(target, source, is_forced):
    """May this file be written?"""
    if target.exists():
        if target.samefile(source):
            raise FileFailure(f"{target}: this is the file to read, --output writes another one")
        if not is_forced:
            raise FileFailure(f"{target}: this file exists; --force overwrites it, --output writes another one")
        if not target.is_file():
            raise FileFailure(f"{target}: this is no file that could be overwritten")
    if not target.parent.is_dir():
        raise FileFailure(f"{target}: there is no such folder")


def write_files(contents, is_forced):
    """Write files, given as their bytes by their names: all of them with a name of their own first, so that none is half."""
    partial = {target: target.with_name(f"{target.name}.{os.getpid()}.partial") for target in contents}
    target = None
    try:
        for target, data in contents.items():
            with partial[target].open("xb") as file:
                file.write(data)
                file.flush()
                os.fsync(file.fileno())
        for target, written in partial.items():
            put_in_place(written, target, is_forced)
    except OSError as problem:
        raise FileFailure(f"{target}: cannot write: {problem.strerror or first_line(problem)}") from None
    finally:
        for written in partial.values():
            with suppress(OSError):
                written.unlink(missing_ok=True)


def put_in_place(written, target, is_forced):
    """Give a written file its name."""
    if is_forced:
        os.replace(written, target)
        return
    try:
        # unlike a change of name this never takes the place of a file that has come in the meantime
        os.link(written, target)
    except FileExistsError:
        raise FileFailure(f"{target}: this file exists; --force overwrites it, --output writes another one") from None
    except OSError:
        # a file system without links
        os.rename(written, target)


@contextmanager
def hdf5_image():
    """An HDF5 file in memory, where no disk is full, and a function that gives its bytes once it is closed."""
    image = io.BytesIO()
    with h5py.File(image, "w") as file:
        yield file, image.getvalue


def image_of_surface(surface, results, attributes):
    """The bytes of a file with the heights as `z`, their axes, moments, spectra and distribution."""
    with hdf5_image() as (file, get_bytes):
        for key, value in attributes["file"].items():
            file.attrs[key] = value
        names = "xy"[:surface.heights.ndim]
        for name, samples, step, origin in zip(names, surface.samples, surface.spacing, surface.origin):
            middles = [origin + step * (i + 0.5) for i in range(samples)]
            add_axis(file, name, middles, "m", f"position along {name}, in the middle of a cell")
        z = add_dataset(file, "z", surface.heights.data, "m", "height of the rough body, summits positive", names[::-1])
        for key, value in attributes["heights"].items():
            z.attrs[key] = value
        for moment in results.moments:
            dataset = add_dataset(file, moment.name, moment.value, moment.unit, moment.meaning)
            if moment.symbol:
                dataset.attrs["symbol"] = moment.symbol
        for spectrum in results.spectra:
            add_axis(file, spectrum.axis, spectrum.wave_numbers, "rad/m", "wave number")
            add_dataset(file, spectrum.name, spectrum.density, spectrum.unit, spectrum.meaning, [spectrum.axis])
        middles, density = results.distribution
        add_axis(file, "height", middles, "m", "height")
        add_dataset(file, "height_density", density, "1/m", "share of the samples per interval of the height", ["height"])
        if results.joined:
            add_spectrum(file, results.joined, [results.periodogram])
    return get_bytes()


def image_of_spectrum(joined, periodograms, attributes):
    """The bytes of a file with a joined spectrum, and what it was joined from."""
    with hdf5_image() as (file, get_bytes):
        for key, value in attributes.items():
            file.attrs[key] = value
        add_spectrum(file, joined, periodograms)
        for number, (each, model, (ratio, error)) in enumerate(zip(periodograms, joined.models, joined.ratios), 1):
            group = file.create_group(f"measurement_{number}")
            group.attrs.update({"name": each.name, "window": each.window, "detrend": each.trend, "shortest_because": each.reason})
            middle = np.exp(np.sum(each.shares * np.log(each.waves), axis=1))
            unit, what = ("m^4", "over the plane") if each.is_map else ("m^3", "along the line, two-sided")
            add_axis(group, "wave_number", middle, "rad/m", "wave number, geometric mean of a bin")
            add_dataset(group, "density", each.density, unit, f"variance of the heights per wave number {what}", ["wave_number"])
            add_dataset(group, "density_error", each.density / np.sqrt(each.weight), unit, "its standard error, if the surface is Gaussian",
                        ["wave_number"])
            add_dataset(group, "joined_density", model, unit, "the same of the joined spectrum", ["wave_number"])
            add_dataset(group, "ratio", ratio, "1", "mean of density over joined_density")
            add_dataset(group, "ratio_error", error, "1", "its standard error, if the surface is Gaussian")
    return get_bytes()


def add_spectrum(file, joined, periodograms):
    """The group of an isotropic spectrum, as `&power_spectrum` reads it: convention `variance`."""
    from .spectrum_moments import MEANINGS, moments_of

    group = file.create_group("power_spectrum")
    one = periodograms[0]
    group.attrs.update({"convention": "variance", "measurements": [each.name for each in periodograms],
                        "windows": [each.window for each in periodograms], "detrend": [each.trend for each in periodograms], "scatter": joined.scatter,
                        "shortest_waves": [2 * np.pi / each.ends[1] for each in periodograms],
                        "shortest_because": [each.reason for each in periodograms]})
    add_axis(group, "wave_number", joined.wave_numbers, "rad/m", "wave number")
    add_dataset(group, "density", joined.density, "m^4", "variance of the heights per area of wave numbers", ["wave_number"])
    add_dataset(group, "density_error", joined.error, "m^4", "standard error of density", ["wave_number"])
    for name, (value, error) in moments_of(joined).items():
        unit, meaning = MEANINGS[name]
        add_dataset(group, name, value, unit, f"{meaning}, of the waves of the table")
        add_dataset(group, f"{name}_error", error, unit, f"standard error of {name}")
    add_dataset(group, "shortest_wavelength", 2 * np.pi / joined.wave_numbers[-1], "m", "shortest wave of the table")
    add_dataset(group, "longest_wavelength", 2 * np.pi / joined.wave_numbers[0], "m", "longest wave of the table")
    if one.is_map and len(periodograms) == 1:
        add_dataset(group, "anisotropy", one.anisotropy, "1", "(a - b)/(a + b) of the mean square slopes along the directions in which "
                    "they are largest, a, and smallest, b")
        add_dataset(group, "anisotropy_noise", one.anisotropy_noise, "1", "what an isotropic Gaussian map has of it by chance")


def add_dataset(group, name, values, units, long_name, axes=()):
    """A dataset with its unit and, where it has dimensions, their scales."""
    dataset = group.create_dataset(name, data=values)
    dataset.attrs["units"] = units
    dataset.attrs["long_name"] = long_name
    for dimension, axis in zip(dataset.dims, axes):
        dimension.attach_scale(group[axis])
    return dataset


def add_axis(group, name, values, units, long_name):
    """A dimension scale."""
    add_dataset(group, name, values, units, long_name).make_scale(name)
