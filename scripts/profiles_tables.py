# SPDX-License-Identifier: GPL-3.0-or-later
"""Compute the tables of docs/theory/columns_any_shape.md and columns_material.md from the inputs: scripts/tables [PROGRAM]."""

import os
import tempfile

import h5py
import numpy as np

from make_measurement import TEMPERATURE, complex_modulus, make_line
from make_surface import make_heights, write_surface
from table_tools import head, row, solve

EDGES = ("continuous", "instantaneous", "front")
VELOCITIES = [1e-4, 1e-3, 1e-2, 0.1, 0.32, 1.0, 10.0, 100.0, 1000.0]
ROOM = "298.15"
# of the line of scripts/make_measurement
LINE = {"samples": 4000, "spacing": 2.0e-6, "hurst": 0.8, "longest": 2.0e-3, "shortest": 1.0e-4, "rms": 4.0e-5}


def velocities(values):
    return [f"V = {value:g} m/s" for value in values]


def write_line(**changes):
    """line_scan.h5 in the current folder, without tilt and missing samples."""
    shape = {**LINE, "seed": 1, **changes}
    with h5py.File("line_scan.h5", "w") as file:
        file["z"] = make_line(**shape)
        file["z"].attrs["units"] = "m"
        file["z"].attrs["dx"] = shape["spacing"]


def solve_line(**changes):
    return solve("line_scan", output__profiles=".false.", **changes)


def show_rubber():
    head("Rubber on an asphalt-like line, 298.15 K", "", *velocities(VELOCITIES))
    results = solve("rubber_velocity", operating__temperature=ROOM, operating__velocity=VELOCITIES)
    row("mu", *results["friction_coefficient"])
    row("share in contact", *results["contact_fraction"])
    row("contacts", *(f"{count:.0f}" for count in results["contact_count"]))
    full = solve("rubber_velocity", operating__temperature=ROOM, operating__velocity=VELOCITIES, operating__mean_pressure="1.0e12")
    assert (full["full_contact_fraction_of_strips"] == 1).all()
    row("mu if contact were full", *(full["friction_stress"] / results["mean_pressure"]))


def show_temperatures():
    head("Temperatures", "T [K]", "a_T", "largest mu", "at V [m/s]", "at a_T V [m/s]", "largest relative difference from 298.15 K at the same a_T V")
    fine = np.geomspace(1e-3, 1e2, 501)
    for temperature in (273.15, 298.15, 323.15):
        factor = 10 ** (-4.57 * (temperature - 298.15) / (113.6 + temperature - 298.15))
        mu = solve("rubber_velocity", operating__temperature=repr(temperature), operating__velocity=fine)["friction_coefficient"]
        same = solve("rubber_velocity", operating__temperature=ROOM, operating__velocity=fine * factor)["friction_coefficient"]
        place = mu.argmax()
        difference = np.abs(mu / same - 1).max()
        row(f"{temperature:g}", factor, mu[place], f"{fine[place]:.3g}", f"{factor * fine[place]:.3g}",
            "below 1e-11" if difference < 1e-11 else f"{difference:.1g}")


def show_master_curve():
    head("The same rubber from its master curve without scatter: mu", "terms in a decade", *velocities(VELOCITIES[::2]))
    omega = np.geomspace(1e-3, 1e11, 57)
    with h5py.File("dma.h5", "w") as file:
        group = file.create_group("master_curve")
        group.attrs["reference_temperature"] = TEMPERATURE
        group["omega"], group["storage"], group["loss"] = omega, complex_modulus(omega).real, complex_modulus(omega).imag
    for terms in ("0.5", "1.0", "1.5", "2.0", "3.0"):
        results = solve("rubber_master_curve", solid__terms_per_decade=terms, operating__velocity=VELOCITIES[::2])
        row(terms, *results["friction_coefficient"])


def show_edges():
    shown = [0.2, 2.0, 20.0, 200.0, 2000.0]
    head("Edge rules on a rough line: mu", "edge", *velocities(shown), "edge_loss/T at 20 m/s")
    for edge in EDGES:
        results = solve(f"edge_rules_{edge}", operating__velocity=shown)
        row(edge, *results["friction_coefficient"], f"{results['edge_loss'][2] / results['friction_stress'][2]:.2g}")


def show_preparation():
    write_line()
    head("A line scan: what its preparation changes, mu", "", "period [m]", *velocities([1e-3, 0.1, 10.0]), "largest error_estimate")
    for words, changes in (
        ("as in the input", {}),
        ("periodise = 'mirror'", {"surface__periodise": "'mirror'"}),
        ("periodise = 'taper'", {"surface__periodise": "'taper'"}),
        ("periodise = 'none'", {"surface__periodise": "'none'", "surface__blend_fraction": None}),
        ("blend_fraction = 0.2", {"surface__blend_fraction": "0.2"}),
        ("interpolation = 'linear'", {"surface__interpolation": "'linear'"}),
        ("shortest_wavelength = 2.0e-4", {"surface__shortest_wavelength": "2.0e-4"}),
        ("direction = 3.14159265", {"operating__direction": "3.14159265"}),
    ):
        results = solve_line(**changes)
        row(words, results["period"], *results["friction_coefficient"], f"{results['error_estimate'].max():.1g}")


def show_scatter():
    results = []
    for seed in range(1, 21):
        write_line(seed=seed)
        results.append(solve_line()["friction_coefficient"])
    head("20 lines of one kind: mu", "", *velocities([1e-3, 0.1, 10.0]))
    row("mean", *np.mean(results, axis=0))
    row("standard deviation", *np.std(results, axis=0, ddof=1))
    row("relative", *(f"{value:.2g}" for value in np.std(results, axis=0, ddof=1) / np.mean(results, axis=0)))


def show_map():
    head("A map", "samples", "rows", *(f"{what}, V = {value:g} m/s" for value in (1e-3, 0.1)
                                       for what in ("mu", "standard error", "error_estimate", "share in contact")))
    for cells in (128, 256, 512):
        write_surface("surface.h5", make_heights(cells, 0.8, 1 / 4, 1 / 64, 1.0e-7, 1), 1.0e-4)
        results = solve("rubber_map", output__profiles=".false.")
        cells_of_row = []
        for i in range(2):
            cells_of_row += [f"{results['friction_coefficient'][i]:.5g}", f"{results['friction_standard_error'][i] / results['mean_pressure'][i]:.2g}",
                             f"{results['error_estimate'][i]:.2g}", f"{results['contact_fraction'][i]:.4g}"]
        row(str(cells), str(cells), *cells_of_row)


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    show_rubber()
    show_temperatures()
    show_master_curve()
    show_edges()
    show_preparation()
    show_scatter()
    show_map()
    os.chdir("/")
