# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces drawn from a spectrum, with statistical theories of the same spectrum beside them."""

from .curves import draw_curves, find_curves
from .labels import scale_of
from .style import COLOURS, make_panels

# quantities that both have, and what the theories are called
QUANTITIES = ("contact_fraction", "mean_gap", "elastic_energy")
THEORIES = {"persson": "Persson", "yang_persson": "Yang, Persson", "wang_mueser": "Wang, Müser", "greenwood_williamson": "Greenwood, Williamson",
            "bush_gibson_thomas": "Bush, Gibson, Thomas", "greenwood_elliptic": "Greenwood, elliptic", "nayak_sphere": "Nayak, spheres"}
MOST_PANELS = 2


def has_theories(results):
    """Has a sweep of the pressure one curve of cells, and theories beside it?"""
    return (results.model == "spectrum_elastic" and len(results.several) == 1 and results.several[0].name == "mean_pressure"
            and any(f"contact_fraction_{theory}" in results.fields for theory in THEORIES))


def draw_theories(results):
    """Area and gap against the pressure: the cells, with the spread of the seeds as a band, and a line for each theory."""
    names = [name for name in QUANTITIES if any(f"{name}_{theory}" in results.fields for theory in THEORIES)][:MOST_PANELS]
    figure, panels = make_panels(len(names))
    curves = find_curves(results, "mean_pressure")
    curves[0].label = "cells"
    asked = [theory for theory in THEORIES if f"contact_fraction_{theory}" in results.fields]
    for panel, name in zip(panels, names):
        scale = scale_of(results.fields[name].values, results.fields[name].unit)
        draw_curves(panel, results, "mean_pressure", name, curves, scale)
        x = panel.get_lines()[0].get_xdata()
        order = results.several[0].values.argsort()
        for place, theory in enumerate(asked, 1):
            if f"{name}_{theory}" in results.fields:
                values = results.fields[f"{name}_{theory}"].values.ravel()[order]
                panel.plot(x, values*scale[0], color=COLOURS[place % len(COLOURS)], linestyle="--", label=THEORIES[theory])
        panel.relim()
        panel.autoscale(axis="y")
        panel.set_ylim(bottom=0)
    panels[0].legend()
    return figure
