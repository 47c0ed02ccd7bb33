# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of periodic surfaces that adhere to the half-space."""

import numpy as np

from .curves import draw_panels, relimit
from .labels import axis_label
from .results import Field
from .sphere import draw_limits, lambda_of, relative_pull_off
from .style import COLOURS, label_few_decades, plt

# result that the figures of both models share
RELATIVE = "relative_pull_off_load"
# what is drawn where no pull-off was wanted or found
WITHOUT_PULL_OFF = ("contact_fraction", "adhesion_fraction", "penetration")


def known(results, *names):
    """A variable, a result or what has one value in the whole run, by the first of its names that the file has; None where it has none."""
    for name in names:
        if name in results.fields or name in results.axis_names:
            return results.values(name)
        if name in results.constants:
            return results.constants[name].values
    return None


def add_pull_off(results):
    """Give a bi-sinusoidal wave and a sphere Maugis's lambda and the pull-off load of a summit in pi w R, as far as the file has what
    they follow from. The summit of the wave is a sphere of R = l^2/(4 pi^2 D), one in a period."""
    if results.model == "wave_2d_elastic":
        period, amplitude, stress, span, energy, modulus, pressure = (
            known(results, *names) for names in (["period"], ["amplitude"], ["adhesion_stress", "stress"], ["adhesion_range", "range"],
                                                 ["work_of_adhesion", "surface_energy"], ["contact_modulus"], ["pull_off_pressure"]))
        if period is None or amplitude is None:
            return
        radius = period**2 / (4 * np.pi**2 * amplitude)
        load = None if pressure is None else pressure * period**2
    elif results.model == "sphere":
        radius, stress, span, energy, modulus, load = (
            known(results, name) for name in ("radius", "adhesion_stress", "adhesion_range", "work_of_adhesion", "contact_modulus",
                                              "pull_off_load"))
        if load is not None and results.fields["pull_off_load"].unit == "-":
            _add(results, RELATIVE, load)
            return
    else:
        return
    if energy is None and stress is not None and span is not None:
        energy = stress * span
    if energy is None or radius is None:
        return
    if stress is None and span is not None:
        stress = energy / span
    if stress is not None and modulus is not None:
        _add(results, "lambda", lambda_of(stress, radius, energy, modulus))
    if load is not None:
        _add(results, RELATIVE, relative_pull_off(load, radius, energy))


def _add(results, name, values):
    """A result of the shape of the sweep, unless there is one of this name."""
    if name not in results.axis_names and name not in results.fields:
        results.fields[name] = Field(name, "-", np.broadcast_to(np.asarray(values, dtype=float), results.status.shape))


def draw_pull_off(results):
    """Pull-off load of a summit of the wave against Maugis's lambda, with the limits of the simpler theories; where that cannot be
    told, results against what is swept."""
    add_pull_off(results)
    is_told = {"lambda", RELATIVE} <= set(results.fields) and np.isfinite(results.fields[RELATIVE].values).any()
    if not is_told or len(results.several) > 1:
        return _draw_sweep(results)
    order = np.argsort(results.fields["lambda"].values, axis=None)
    x, y = (results.fields[name].values.ravel()[order] for name in ("lambda", RELATIVE))
    figure, axes = plt.subplots(figsize=(4.8, 3.5))
    axes.plot(x, y, color=COLOURS[0], marker="o" if x.size <= 30 else None, markersize=3)
    axes.set_xscale("log")
    label_few_decades(axes, x)
    axes.set_xlabel("Maugis's " + axis_label("lambda", ""))
    axes.set_ylabel(axis_label(RELATIVE, ""))
    draw_limits(axes, "load")
    return figure


def draw_stickiness(results):
    """Tension at pull-off, on a logarithmic axis, and share in contact against the roughness."""
    pressure = results.fields.get("pull_off_pressure")
    if pressure is None or not np.any(pressure.values < 0):
        return _draw_sweep(results)
    tension = np.where(pressure.values < 0, -pressure.values, np.nan)
    results.fields["pull_off_tension"] = Field("pull_off_tension", pressure.unit, tension)
    figure = draw_panels(results, results.several[-1].name, ["pull_off_tension", "contact_fraction"])
    axes = figure.axes[0]
    axes.set_yscale("log")
    relimit(axes)
    return figure


def _draw_sweep(results):
    """What a sweep without a pull-off has: the contact, as far as it is known."""
    names = [name for name in WITHOUT_PULL_OFF if name in results.fields]
    return draw_panels(results, results.several[-1].name, names)
