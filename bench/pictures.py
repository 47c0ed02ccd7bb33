# SPDX-License-Identifier: GPL-3.0-or-later
"""A picture of each benchmark, from its tables: pictures.py FOLDER [NAME ...]. `bench/run` calls it."""

import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "scripts")]

import numpy as np  # noqa: E402

from plotting.style import COLOURS, plt, use_style  # noqa: E402
from tools import read_table  # noqa: E402

#: Errors below this are round-off, and stand there.
ROUND_OFF = 1e-16


def table(folder, name):
    """Rows of a table, with numbers where there are any; none if the benchmark has not been run."""
    path = folder / f"{name}.csv"
    if not path.exists():
        return []
    return [{key: number(text) for key, text in row.items()} for row in read_table(path)[1]]


def number(text):
    try:
        return float(text)
    except (TypeError, ValueError):
        return text


def column(rows, key):
    return np.array([row[key] if isinstance(row[key], float) else np.nan for row in rows])


def floor(errors):
    """Errors for a logarithmic axis."""
    return np.maximum(np.abs(errors), ROUND_OFF)


def pick(rows, **wanted):
    return [row for row in rows if all(row[key] == value for key, value in wanted.items())]


def strips(folder):
    rows, scipy = table(folder, "strip_methods"), table(folder, "strip_scipy")
    if not rows:
        return None
    regimes = ["contact without adhesion", "saturated adhesion", "adhesion zones", "adhesion zones with snap"]
    figure, axes = plt.subplots(1, 4, figsize=(11, 3.4), sharey=True)
    for axis, regime in zip(axes, regimes):
        lines = [("solver, cold", pick(rows, regime=regime, method="cold"), "o"),
                 ("solver, warm", pick(rows, regime=regime, method="warm"), "s"),
                 ("GSL, near start", pick(rows, regime=regime, method="gsl from lengths"), "^-"),
                 ("GSL, from rest", pick(rows, regime=regime, method="gsl from rest"), "^:"),
                 ("SciPy, near start", pick(scipy, regime=regime, method="scipy from lengths"), "v-"),
                 ("SciPy, from rest", pick(scipy, regime=regime, method="scipy from rest"), "v:"),
                 ("march, 1e2 to 1e6 steps", pick(rows, regime=regime, method="time march"), "x-")]
        for (label, found, mark), colour in zip(lines, ("#000000", *COLOURS[2:4], COLOURS[3], *COLOURS[5:7], COLOURS[1])):
            colour = {"GSL": COLOURS[2], "Sci": COLOURS[3], "mar": COLOURS[1]}.get(label[:3], colour)
            axis.plot(column(found, "us"), floor(column(found, "error_median")), mark, color=colour, label=label, markersize=4)
            if found and "rest" in label:
                # GSL's above its line, SciPy's below
                is_gsl = "GSL" in label
                last, place = found[-1], found[0 if is_gsl else -1]
                wrong = int(last["failed"] + last["inadmissible"] + last["elsewhere"])
                axis.annotate(f"{wrong} of 300 wrong", (place["us"], max(place["error_median"], ROUND_OFF)), fontsize=6,
                              xytext=(0, 5) if is_gsl else (4, -9), textcoords="offset points", color=colour,
                              ha="center" if is_gsl else "left")
        axis.set(xscale="log", yscale="log", title=regime, xlabel="time of a strip [us]")
    axes[0].set_ylabel("median error of load and friction")
    figure.legend(*axes[0].get_legend_handles_labels(), loc="outside lower center", ncols=7)
    return figure


def surface_3d(folder):
    rows = table(folder, "surface_3d_strips")
    if not rows:
        return None
    cases = ["no adhesion", "release across the surface", "snap into contact"]
    figure, axes = plt.subplots(2, 3, figsize=(9, 5.6), sharey=True)
    for pair, case in zip(axes.T, cases):
        for rule, label, colour in (("equal", "equal strips", COLOURS[1]), ("gauss", "Gauss, equal panels", COLOURS[2]),
                                    ("adaptive", "our rule", COLOURS[0])):
            found = pick(rows, case=case, rule=rule)
            for axis, key in zip(pair, ("strips", "us")):
                axis.plot(column(found, key), floor(column(found, "load_error")), "o-", color=colour, label=label, markersize=3)
                axis.plot(column(found, key), floor(column(found, "mu_error")), ":", color=colour)
                axis.plot(column(found, key), floor(column(found, "contact_error")), "--", color=colour, linewidth=0.8)
                axis.set(xscale="log", yscale="log")
        pair[0].set(title=case, xlabel="strips")
        pair[1].set_xlabel("time [us]")
    for axis in axes[:, 0]:
        axis.set_ylabel("error")
    axes[0, 0].plot([], [], "k:", label="of $\\mu$")
    axes[0, 0].plot([], [], "k--", linewidth=0.8, label="of the area")
    figure.legend(*axes[0, 0].get_legend_handles_labels(), loc="outside lower center", ncols=5)
    return figure


def sphere(folder):
    rows = table(folder, "sphere_side_by_side")
    if not rows:
        return None
    figure, axes = plt.subplots(1, 2, figsize=(8.5, 3.6))
    for method, label, colour in (("ours", "ours", COLOURS[0]), ("m-form", "textbook's form in m", COLOURS[1]),
                                  ("JKR", "JKR", COLOURS[2]), ("DMT", "DMT", COLOURS[3]),
                                  ("Adhesion", "package Adhesion", COLOURS[4])):
        found = pick(rows, method=method)
        lam = column(found, "lambda")
        axes[0].plot(lam, floor(column(found, "error")), "o-", color=colour, label=label, markersize=3)
        axes[1].plot(lam, column(found, "us"), "o-", color=colour, markersize=3)
        if method in ("JKR", "DMT"):
            # only where every radius has a bound is it that of the error shown
            whole = column(found, "proved") >= 1
            if whole.any():
                axes[0].plot(lam[whole], column(found, "bound")[whole], ":", color=colour, label=f"its bound, {method}")
    axes[0].set(xscale="log", yscale="log", xlabel="$\\lambda$", ylabel="largest error of load and approach")
    axes[1].set(xscale="log", yscale="log", xlabel="$\\lambda$", ylabel="time of a radius [us]")
    figure.legend(*axes[0].get_legend_handles_labels(), loc="outside lower center", ncols=4)
    return figure


def wave_2d(folder):
    rows, public = table(folder, "wave_2d"), table(folder, "wave_2d_public")
    if not rows:
        return None
    figure, axes = plt.subplots(1, 3, figsize=(10.5, 3.6))
    for load, colour in zip(sorted({row["load"] for row in rows}), (*COLOURS,)):
        found = sorted(pick(rows, surface="quarter", load=load), key=lambda row: row["cells"])
        cells = column(found, "cells")
        below, area = cells < cells.max(), column(found, "area")
        axes[0].plot(cells[below], floor(area[below] - area[-1]), "o-", color=colour, markersize=3, label=f"{load:g}")
        axes[0].plot(cells[below], column(found, "area_error_estimate")[below], ":", color=colour)
        axes[1].plot(cells[below], floor(column(found, "peak_difference")[below]), "o-", color=colour, markersize=3)
    axes[1].legend(*axes[0].get_legend_handles_labels(), title="$p/p^*$", ncols=2, fontsize=7)
    axes[0].plot([], [], "k:", label="bound")
    axes[0].legend(handles=axes[0].get_lines()[-1:], loc="lower left")
    for k, solver in enumerate(sorted({row["solver"] for row in public})):
        found = pick(public, solver=solver, load=0.5)
        axes[2].plot(column(found, "cells"), column(found, "ms"), "o-", color=COLOURS[k], markersize=3, label=solver)
    axes[2].legend(fontsize=7)
    labels = "area against 2048 cells", "largest pressure against 2048 cells [E*]", "time at $p/p^* = 0.5$ [ms]"
    for axis, label in zip(axes, labels):
        axis.set(xscale="log", yscale="log", xlabel="cells along a period", ylabel=label)
        axis.set_xticks([128, 256, 512, 1024], ["128", "256", "512", "1024"])
        axis.minorticks_off()
    return figure


def wave_1d(folder):
    rows = table(folder, "wave_1d")
    if not rows:
        return None
    figure, axes = plt.subplots(1, 2, figsize=(8, 3.4))
    for load, colour in zip(sorted({row["load"] for row in rows}), (*COLOURS, "#999999")):
        found = pick(rows, load=load)
        for axis, key in zip(axes, ("cells", "ms")):
            axis.plot(column(found, key), floor(column(found, "peak_error")), "o-", color=colour, markersize=3,
                      label=f"{load:g}")
    for axis, label in zip(axes, ("cells along a period", "time of a load [ms]")):
        axis.set(xscale="log", yscale="log", xlabel=label, ylabel="error of the largest pressure [p*]")
        axis.axhline(1e-7, color="#999999", linewidth=0.7)
    axes[0].axvline(4096, color="#999999", linewidth=0.7)
    axes[1].legend(title="$p/p^*$", ncols=2)
    return figure


def whole_program(folder):
    rows, phases = table(folder, "whole_program_points"), table(folder, "whole_program_phases")
    if not rows:
        return None
    figure, axes = plt.subplots(1, 3, figsize=(11, 3.4))
    for threads, colour in ((1, COLOURS[0]), (2, COLOURS[1])):
        found = pick(rows, threads=threads)
        label = f"{threads} thread" + "s" * (threads > 1)
        axes[0].plot(column(found, "points"), column(found, "points_per_second"), "o-", color=colour, label=label, markersize=3)
        axes[1].plot(column(found, "points"), column(found, "peak_mb"), "o-", color=colour, markersize=3)
    axes[0].set(xscale="log", yscale="log", xlabel="points", ylabel="points per second")
    axes[0].legend()
    axes[1].set(xscale="log", xlabel="points", ylabel="peak memory [MB]", ylim=(0, None))
    left = np.zeros(len(phases))
    names = [row["case"] for row in phases]
    for part, colour in zip(("input", "name", "waiting", "closing", "solution"), (*COLOURS[1:5], "#cccccc")):
        axes[2].barh(names, column(phases, part), left=left, color=colour, label=part)
        left = left + column(phases, part)
    axes[2].set(xlabel="share of the time, a million points", xlim=(0, 1))
    axes[2].invert_yaxis()
    axes[2].legend(fontsize=6, ncols=5, loc="lower center", bbox_to_anchor=(0.35, 1.0), handlelength=1, columnspacing=0.8)
    return figure


def error_estimates(folder):
    rows = table(folder, "error_estimates")
    if not rows:
        return None
    figure, axis = plt.subplots(figsize=(7, 4))
    names = [name for name in dict.fromkeys(row["cases"] for row in rows) if name != "all"]
    decades = sorted({row["decade"] for row in rows if isinstance(row["decade"], float)})
    below = np.zeros(len(decades))
    for name, colour in zip(names, (*COLOURS, "#999999")):
        counts = np.array([pick(rows, cases=name, decade=decade)[0]["count"] for decade in decades])
        # each kind counts alike, however many cases it has
        share = counts / counts.sum() / len(names)
        axis.bar(np.array(decades) + 0.5, share, 0.9, below, color=colour, label=name)
        below += share
    axis.axvline(0, color="k", linewidth=0.8)
    axis.axvline(2, color="k", linewidth=0.8, linestyle=":")
    axis.set(xlabel="log$_{10}$ of estimate over true error; below 0 the estimate is too small", xticks=decades,
             ylabel="share of cases, each kind with the same weight")
    axis.legend(fontsize=7)
    return figure


def bars(rows, names, keys, label):
    """A bar for each row, with its range; keys: value, least, most."""
    figure, axis = plt.subplots(figsize=(7.5, 4))
    value, low, high = (column(rows, key) for key in keys)
    axis.barh(names, value, xerr=[value - low, high - value], color=COLOURS[2], ecolor="k", error_kw={"linewidth": 0.8})
    axis.set(xscale="log", xlabel=label)
    axis.tick_params(axis="y", labelsize=7)
    axis.invert_yaxis()
    return figure, axis


def scenes(folder):
    rows = table(folder, "scenes")
    if not rows:
        return None
    figure, axis = bars(rows, [f"{row['saving']} ({row['scene']})" for row in rows], ("ratio", "ratio_least", "ratio_most"),
                        "time without the saving over time with it")
    axis.axvline(1, color="k", linewidth=0.8)
    return figure


def closed_forms(folder):
    rows = table(folder, "closed_forms")
    if not rows:
        return None
    names = [f"{row['model']}, {row['case']}: {row['swept']}" for row in rows]
    label = "time of a point [us]; the variable that is swept stands behind the colon"
    return bars(rows, names, ("us", "us_least", "us_most"), label)[0]


def scaling(folder):
    rows = table(folder, "scaling")
    if not rows:
        return None
    figure, axis = plt.subplots(figsize=(6, 4))
    for case, colour in zip(dict.fromkeys(row["case"] for row in rows), COLOURS[1:]):
        for threads, mark in ((1, "o"), (2, "s")):
            found = pick(rows, case=case, threads=threads)
            axis.plot(column(found, "points"), column(found, "wall_seconds"), mark, color=colour, markersize=5,
                      fillstyle="full" if threads == 1 else "none", label=f"{case}, {threads} thread" + "s" * (threads > 1))
        found = pick(rows, case=case, threads=1)
        axis.plot(column(found, "points"), column(found, "model_seconds"), "-", color=colour, linewidth=0.8,
                  label="model, 1 thread")
    axis.set(xscale="log", yscale="log", xlabel="points", ylabel="time of a run [s]")
    axis.legend(fontsize=7)
    return figure


PICTURES = {"strips": strips, "surface_3d": surface_3d, "sphere": sphere, "wave_2d": wave_2d, "wave_1d": wave_1d,
            "whole_program": whole_program, "error_estimates": error_estimates, "scenes": scenes,
            "closed_forms": closed_forms, "scaling": scaling}


def main():
    if len(sys.argv) < 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    use_style()
    for name in sys.argv[2:] or PICTURES:
        try:
            figure = PICTURES[name](folder)
        except KeyError:
            # the table of an older benchmark
            figure = None
        if figure is None:
            print(f"pictures: no table for {name}")
            continue
        figure.savefig(folder / f"{name}.png", dpi=110)
        plt.close(figure)


if __name__ == "__main__":
    main()
