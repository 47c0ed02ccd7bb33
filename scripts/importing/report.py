# SPDX-License-Identifier: GPL-3.0-or-later
"""The short table of what was read, and the same as attributes of the file."""

import datetime
import hashlib
import importlib.metadata
import shlex

import numpy as np

from .spectrum_moments import MEANINGS, moments_of


def file_attributes(program, files, arguments, form, software=None):
    """Where a file comes from."""
    now = datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ")
    names = [file.name for file in files]
    return {"title": names[0] + (f" and {len(names) - 1} more" if len(names) > 1 else ""), "source_file": "\n".join(names),
            "source_format": form, "source_sha256": "\n".join(hashlib.sha256(file.read_bytes()).hexdigest() for file in files),
            "created": now, "history": f"{now} scripts/{program} {shlex.join(map(str, arguments))}",
            "software": software or f"SurfaceTopography {importlib.metadata.version('SurfaceTopography')}"}


def surface_attributes(given, arguments, source, surface, read):
    """Attributes of the file and of the heights."""
    lengths = {f"length_{name}": length for name, length in zip("xy", surface.lengths)}
    steps = {f"d{name}": step for name, step in zip("xy", surface.spacing)}
    heights = {**steps, **lengths, "periodic": int(surface.is_periodic), "detrend": read.trend, "missing_samples": read.missing}
    if read.coefficients:
        heights["detrend_coefficients"] = read.coefficients
    return {"file": file_attributes("import_surface", [given.file], arguments, source.format) | source.facts, "heights": heights}


def surface_lines(given, source, surface, read, results):
    """The table of a surface, and how an input names it."""
    periodic = "yes" if surface.is_periodic else "no"
    origin = "as the option says" if given.periodic is not None else (
        "as the file states" if source.is_periodic is not None and not given.region else "the file does not say")
    rows = [("format", source.format),
            ("samples", " x ".join(map(str, surface.samples)) + (" (x, y)" if len(surface.samples) > 1 else "")),
            ("spacing", " x ".join(f"{step:.6g}" for step in surface.spacing) + " m"),
            ("length", " x ".join(f"{length:.6g}" for length in surface.lengths) + " m"),
            ("periodic", f"{periodic}, {origin}"),
            ("missing samples", f"{read.missing} of {read.samples}" + (", interpolated" if read.missing else "")),
            ("detrend", read.trend + slopes_of(read))]
    for moment in results.moments:
        unit = "" if moment.unit == "1" else f" {moment.unit}"
        rows.append((moment.name.replace("_", " "), f"{moment.value:.6g}{unit}" + (f" ({moment.symbol})" if moment.symbol else "")))
    rows += spectrum_rows(results.joined, [results.periodogram]) if results.joined else [("power spectrum", f"none: {results.why_none}")]
    for name, (step, largest) in zip("xy", results.seams):
        rows.append((f"seam along {name}", f"{step:.3g} m, largest step inside {largest:.3g} m"))
    lengths = "".join(f", length_{name} = {length!r}" for name, length in zip("xy", map(float, surface.lengths)))
    return [*table(given.file, rows), f"  {'input':<17}heights = '{given.output}:/z'{lengths}",
            *([spectrum_input(given.output)] if results.joined else [])]


def spectrum_rows(joined, periodograms):
    """What the table says of a power spectrum: its waves, and numbers with their errors."""
    longest, shortest = joined.longest, 2 * np.pi / joined.wave_numbers[-1]
    one = periodograms[0]
    rows = [("power spectrum", f"waves of {shortest:.4g} to {longest:.4g} m"
             + (f", window {one.window}, shortest: {one.reason}" if len(periodograms) == 1 else ""))]
    for name, (value, error) in moments_of(joined).items():
        unit = MEANINGS[name][0]
        rows.append(("  " + name.replace("root_mean_square_", "rms ").replace("nayak_parameter", "Nayak's alpha"),
                     f"{value:.4g} +- {error:.2g}" + ("" if unit == "1" else f" {unit}")))
    if one.is_map and len(periodograms) == 1:
        rows.append(("  anisotropy", f"{one.anisotropy:.2g}, by chance {one.anisotropy_noise:.2g}"))
    return rows


def joined_lines(given, joined, periodograms):
    """The tables of measurements and of the joined spectrum, and how an input names it."""
    lines = []
    for each, (ratio, error) in zip(periodograms, joined.ratios):
        longest, shortest = (2 * np.pi / end for end in each.ends)
        lines += table(each.name, [("waves", f"{shortest:.4g} to {longest:.4g} m, {'map' if each.is_map else 'line'}, shortest: {each.reason}"),
                                   ("window, detrend", f"{each.window}, {each.trend}"),
                                   ("over joined", f"{ratio:.3g} +- {error:.2g}")])
    return [*lines, *table("joined", [*spectrum_rows(joined, periodograms), ("scatter", f"{joined.scatter:.2g} times that of a Gaussian surface, squared")]),
            spectrum_input(given.output).replace("or   ", "input", 1)]


def spectrum_input(output):
    """How an input names the spectrum."""
    return (f"  {'or':<17}wave_numbers = '{output}:/power_spectrum/wave_number', densities = '{output}:/power_spectrum/density', "
            "convention = 'variance'")


def slopes_of(read):
    """The slopes of the line or plane that was removed."""
    if read.trend not in ("line", "plane"):
        return ""
    slopes = (f"{rise / length:.4g} along {name}" for name, rise, length in zip("xy", read.coefficients[1:], read.lengths))
    return ", slope " + ", ".join(slopes)


def curve_lines(given, curve):
    """The table of a master curve, and how an input names it."""
    rows = [("rows", str(len(curve.omega))),
            ("frequency", f"{curve.omega[0]:.6g} to {curve.omega[-1]:.6g} rad/s"),
            ("storage modulus", f"{curve.storage.min():.6g} to {curve.storage.max():.6g} Pa"),
            ("loss modulus", f"{curve.loss.min():.6g} to {curve.loss.max():.6g} Pa"),
            ("temperature", f"{curve.temperature:.6g} K")]
    if curve.poisson_ratio is not None:
        rows.append(("moduli", f"Young's, from those of shear with Poisson's ratio {curve.poisson_ratio:g}"))
    return [*table(given.file, rows), f"  {'input':<17}master_curve = '{given.output}:/master_curve'"]


def table(path, rows):
    """Lines of a table under the name of the file."""
    return [str(path), *(f"  {name:<17}{text}" for name, text in rows)]
