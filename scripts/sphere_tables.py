# SPDX-License-Identifier: GPL-3.0-or-later
"""Compute the tables of the pages on a sphere from the inputs: scripts/tables [PROGRAM].

The pages are docs/theory/johnson1997.md, round_adhesion.md, round_branches.md, round_peeling.md and stick_slip.md.
"""

import numpy as np

from table_tools import head, row, solve

JKR, DUGDALE = "1.0e6", "0.8"


def show_figures():
    head("Published figures", "figure", "quantity", "value")
    results = solve("johnson1997_fig3", operating__contact_radius=None, operating__load="0.0")
    for i, parameter in enumerate(results["lambda"]):
        a, c, pull_off = (results[name][i] for name in ("contact_radius", "adhesion_radius", "pull_off_load"))
        row("3", f"lambda = {parameter:g}: a, c at P = 0; pull-off load", f"{a:.6f}, {c:.6f}; {pull_off:.6f}")
    for name in ("johnson1997_fig5", "johnson1997_fig5_jkr"):
        results = solve(name, operating__load="0.0")
        row("5", f"{name}: pull-off load; friction at P = 0 [nN]",
            f"{1e9 * results['pull_off_load']:.2f}; {1e9 * results['friction_force']:.2f}")
    results = solve("johnson1997_fig5_jkr", adhesion__work_of_adhesion="0.19", operating__load="0.0")
    row("5", "the same with w = 0.19 J/m^2, as printed on page 170",
        f"{1e9 * results['pull_off_load']:.2f}; {1e9 * results['friction_force']:.2f}")
    results = solve("johnson1997_fig6", output__profiles=".false.")
    for force, e, b in zip(*(results[name] for name in ("tangential_force", "stick_radius", "friction_radius"))):
        row("6, 11", f"e/b at T/Ts = {force:g}", f"{e / b:.6f}")
    for name, parameter in (("JKR", JKR), ("lambda = 0.8", DUGDALE)):
        alpha = np.linspace(0.0, 0.5, 5001)
        results = solve("johnson1997_fig7", adhesion__lambda=parameter, operating__load="0.0", friction__interaction=alpha)
        ratio = results["pull_off_load"] / results["pull_off_load"][0]
        row("7", f"{name}: alpha at which the pull-off load is 0.89 of that without interaction",
            f"{np.interp(-0.89, -ratio, alpha):.5f}")
    for name, parameter in (("JKR", JKR), ("lambda = 0.8", DUGDALE)):
        results = solve("johnson1997_fig8", adhesion__lambda=parameter, friction__slip_energy_ratio="1.0",
                        friction__interaction=[0.0, 0.2], operating__load="0.0")
        area = results["friction_area"]
        row("8b", f"{name}: A/A* at P = 0, alpha = 0.2, g0 = 1", f"{area[1] / area[0]:.6f}")
    for name, parameter in (("JKR", JKR), ("lambda = 0.8", DUGDALE)):
        for energy in (1.0, 4.0, 1e4):
            alpha = np.linspace(0.4, 1.0, 6001)
            results = solve("johnson1997_fig8", adhesion__lambda=parameter, friction__slip_energy_ratio=repr(energy),
                            friction__interaction=alpha, operating__load="-0.75")
            row("8c", f"{name}: largest alpha with contact at P = -0.75, g0 = {energy:g}, to 1e-4",
                f"{alpha[results['status'] == 0].max():.4f}")


def show_events():
    for name, load in (("johnson1997_fig9a", "0.0"), ("johnson1997_fig9b", "0.0"), ("johnson1997_fig9a", "-0.75"),
                       ("johnson1997_fig9b", "-0.75")):
        results = solve(name, operating__tangential_displacement="0.0", operating__load=load)
        head(f"Events of {name}, P = {load}", "alpha", "largest force", "its displacement", "force of sliding",
             "drop of force", "snap-off: force", "displacement")
        for i, alpha in enumerate(results["interaction"]):
            row(f"{alpha:g}", *(_number(results[event][i]) for event in (
                "peak_tangential_force", "peak_tangential_displacement", "friction_force", "tangential_force_drop",
                "snap_off_tangential_force", "snap_off_tangential_displacement")))


def show_stick_slip():
    alphas, stiffnesses = [0.2, 0.4, 0.8, 1.0], [0.04, 0.4, 4.0, 40.0]
    results = solve("stick_slip", operating__base_displacement="0.0", friction__interaction=alphas, operating__lateral_stiffness=stiffnesses)
    head("Stick-slip, P = 0, g0 = 1", "alpha", "stiffness", "base displacement", "force", "force after it", "energy", "period", "work")
    for i, alpha in enumerate(alphas):
        for j, stiffness in enumerate(stiffnesses):
            row(f"{alpha:g}", f"{stiffness:g}", *(_number(results[event][i, j]) for event in (
                "stick_slip_base_displacement", "stick_slip_force", "arrest_force", "stick_slip_energy", "stick_slip_period",
                "stick_slip_work")))
    head("Critical lateral stiffness, lambda = 5, tau0 = 0.8, g0 = 0.6, P = 0.1", "alpha", "critical_lateral_stiffness")
    alphas = [0.8, 1.0, 1.1, 1.2, 1.25, 1.3, 1.35, 1.4, 1.5]
    results = solve("stick_slip", operating__base_displacement="0.0", friction__interaction=alphas, operating__lateral_stiffness="1.0",
                    adhesion__lambda="5.0", friction__slip_energy_ratio="0.6", operating__load="0.1")
    for i, alpha in enumerate(alphas):
        row(f"{alpha:g}", _number(results["critical_lateral_stiffness"][i]))


def show_poisson():
    ratios = [0.0, 0.3, 0.5]
    results = solve("johnson1997_fig9b", operating__tangential_displacement="0.0", friction__interaction=[0.4, 1.0],
                    solid__poisson_ratio=ratios)
    head("Fig. 9b and Poisson's ratio", "alpha", "quantity", *(f"nu = {ratio:g}" for ratio in ratios))
    for i, alpha in enumerate(results["interaction"]):
        for event in ("peak_tangential_force", "tangential_force_drop"):
            row(f"{alpha:g}", event, *(_number(value) for value in results[event][i]))


def show_pull_off():
    parameters = [1e-3, 0.1, 0.5, 0.9, 0.94, 1.0, 2.0, 5.0, 100.0]
    head("Pull-off load against lambda", "control", *(f"lambda = {parameter:g}" for parameter in parameters))
    for control in ("load", "approach"):
        results = solve(f"pulloff_map_{control}", adhesion__lambda=parameters)
        row(control, *(f"{value:.5f}" for value in results["pull_off_load"]))


def show_auto():
    """Where `auto` leaves Maugis and Dugdale, without load."""
    parameters = np.logspace(-20, 8, 2801)
    head("theory = 'auto' at P = 0", "relative_tolerance", "DMT up to lambda", "JKR from lambda")
    for tolerance in ("1.0e-2", "1.0e-4", "1.0e-8"):
        results = solve("pulloff_map_load", adhesion__lambda=parameters, adhesion__theory="'auto'", friction__edge_fraction="0.0",
                        adhesion__theory_tolerance=tolerance)
        used = results["theory_used"]
        row(tolerance, f"{parameters[used == 2].max(initial=0):.2g}", f"{parameters[used == 1].min(initial=np.inf):.2g}")


def _number(value):
    return "none" if np.isnan(value) else f"{value:.5f}"


show_figures()
show_events()
show_stick_slip()
show_poisson()
show_pull_off()
show_auto()
