# SPDX-License-Identifier: GPL-3.0-or-later
"""HDF5 files with axes and units, and how files appear: whole or not at all, and never in the place of another by accident."""

import io
import os
from contextlib import contextmanager, suppress

import h5py

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
    return get_bytes()


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
