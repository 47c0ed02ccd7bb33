# SPDX-License-Identifier: GPL-3.0-or-later
"""Compute the tables of docs/theory/columns_strips.md and columns_adhesion.md from the inputs: scripts/tables [PROGRAM]."""

import numpy as np

from table_tools import head, row, solve

EDGES = ("continuous", "instantaneous", "front")


def force(results, dimensions):
    """Friction force on a period of a wave along one direction [N/m] or two [N]."""
    return results["friction_stress"] * results["period"] ** dimensions


def saturation_load(stress, near):
    """Least load, to 1e-5 N/m, at which Fig. 5 is in contact everywhere."""
    loads = near + 1e-5 * np.arange(-50, 51)
    results = solve("gm2011_fig5", adhesion__adhesion_stress=stress, operating__load=loads)
    return loads[np.argmax(results["regime"] == 5)]


def show_figures():
    head("Published figures", "figure, input", "quantity", "without adhesion", "with adhesion")
    for name in ("fig4_printed", "fig4_reconciled", "fig7"):
        results = solve(f"gm2011_{name}", output__profiles=".false.")
        row(name, "mu", *results["friction_coefficient"])
        row(name, "share in contact", *(results["contact_fraction"] / results["contact_fraction"][1]))
        row(name, "approach [m]", *results["approach"])
    row("fig5", "saturation load [N/m]", f"{saturation_load('0.0', 0.9986):.5f}", f"{saturation_load('5.0e3', 0.4986):.5f}")
    results = solve("gm2011_fig5")
    row("fig5", "friction force at saturation [N/m]", *force(results, 1)[:, -1])
    results = solve("gm2011_fig6")
    for i, stress in enumerate(results["adhesion_stress"]):
        mu, velocity = results["friction_coefficient"][i], results["velocity"]
        row("fig6", f"p0 = {stress:g} Pa", f"largest mu {mu.max():.4g} at V = {velocity[mu.argmax()]:.3g} m/s",
            f"mu {mu[0]:.3g} at V = {velocity[0]:g} m/s, {mu[-1]:.3g} at {velocity[-1]:g} m/s")
    for velocity in ("0.1", "1.0"):
        results = solve("gm2011_fig8", operating__velocity=velocity, operating__load=[0.0, 40.0e-6])
        for i, load in enumerate(results["load"]):
            row("fig8", f"friction force at V = {velocity} m/s, P = {load:g} N [N]", *force(results, 2)[:, i])


def show_edge_rule():
    head("Edge rule, load by load", "case", "edge", "pull-off load", "friction there", "friction at P = 0",
         "largest friction, its load", "edge_loss over friction at P = 0")
    for name, dimensions in (("edge_rule_fig5", 1), ("edge_rule_fig6", 2)):
        for edge in EDGES:
            results = solve(name, adhesion__edge=f"'{edge}'")
            load, friction = results["load"], force(results, dimensions)
            solved = np.where(results["status"] == 0, load, np.inf)
            zero = np.argmin(np.abs(load))
            largest = np.nanmax(friction)
            row(name, edge, solved.min(), friction[solved.argmin()], friction[zero],
                f"{largest:.5g}, {load[friction > largest * (1 - 1e-9)].min():.4g}",
                f"{results['edge_loss'][zero] / results['friction_stress'][zero]:.2g}")
    head("Edge rule, Fig. 6 at p0 = 5e4 Pa, velocity by velocity", "edge", "largest mu", "mu at V = 0.1 m/s", "mu at V = 100 m/s")
    for edge in EDGES:
        results = solve("gm2011_fig6", adhesion__adhesion_stress="5.0e4", adhesion__edge=f"'{edge}'")
        mu, velocity = results["friction_coefficient"], results["velocity"]
        row(edge, mu.max(), mu[np.argmin(np.abs(velocity - 0.1))], mu[-1])


def show_thin_layer():
    velocities = [0.02, 0.1, 0.5, 2.5, 20.0, 200.0]
    head("A wave on a thin layer: friction force [N/m]", "edge", *(f"V = {velocity:g} m/s" for velocity in velocities))
    for edge in EDGES:
        results = solve("edge_rule_front", adhesion__edge=f"'{edge}'", operating__velocity=velocities)
        row(edge, *force(results, 1))


def show_branches():
    head("Branches, Fig. 5 with adhesion, to 1e-3 N/m", "edge", "branch", "lowest load [N/m]", "jump of friction at [N/m]",
         "from [N/m]", "to [N/m]")
    for edge in EDGES[:2]:
        for branch in ("adhered", "loading"):
            results = solve("edge_rule_fig5", adhesion__edge=f"'{edge}'", operating__branch=f"'{branch}'",
                            operating__load=1e-3 * np.arange(-200, 301))
            load, friction = results["load"], force(results, 1)
            k = np.nan_to_num(np.abs(np.diff(friction))).argmax()
            row(edge, branch, load[results["status"] == 0].min(), f"{load[k]:.3f} to {load[k + 1]:.3f}", friction[k],
                friction[k + 1])


def show_slow_and_fast():
    velocities = [1e-9, 1e-6, 1e-3, 1.0, 1e2, 1e4]
    head("Slow and fast sliding: friction force [N] of Fig. 6 at p0 = 5e3 Pa and P = 0.01 N", "edge",
         *(f"V = {velocity:g} m/s" for velocity in velocities))
    for edge in EDGES:
        results = solve("gm2011_fig6", adhesion__adhesion_stress="5.0e3", adhesion__edge=f"'{edge}'", operating__load="1.0e-2",
                        operating__velocity=velocities)
        row(edge, *force(results, 2))


show_figures()
show_edge_rule()
show_thin_layer()
show_branches()
show_slow_and_fast()
