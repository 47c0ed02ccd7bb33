# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of docs/validation/accuracy.md, docs/validation/rough_surfaces.md, docs/validation/peers.md, docs/reference/python.md, docs/validation/scenes.md and docs/validation/theories.md from those of the benchmarks.

usage: tables.py [FOLDER [--write]]

Prints every table that FOLDER (build/bench) has the numbers of; with --write it replaces, in the documents, what stands between
`<!-- table NAME -->` and `<!-- end -->`. Times are the least of each range.
"""

import math
import pathlib
import re
import sys

from tools import read_table

ROOT = pathlib.Path(__file__).resolve().parents[1]
DOCUMENTS = [ROOT / "docs" / f"{name}.md" for name in ("validation/accuracy", "validation/rough_surfaces", "validation/peers", "reference/python", "validation/scenes",
                                                     "validation/theories")]


def rows_of(folder, name, **wanted):
    """Rows of a table, of those with the wanted texts."""
    rows = read_table(folder / f"{name}.csv")[1]
    return [row for row in rows if all(row[key].strip() == text for key, text in wanted.items())]


def one(folder, name, **wanted):
    """The one row with the wanted texts."""
    return rows_of(folder, name, **wanted)[0]


def time(text):
    """A time with two digits."""
    number = float(text)
    if not number > 0:
        return "0"
    return f"{number:.{max(0, 1 - math.floor(math.log10(number)))}f}"


def error(text):
    """An error with one digit."""
    number = float(text)
    if number == 0:
        return "0"
    mantissa, exponent = f"{number:.0e}".split("e")
    return f"{mantissa}e{int(exponent)}"


def power(text):
    """A power of ten."""
    return f"{float(text):.0e}".replace("e-0", "e-").replace("e+0", "e")


def table(head, body):
    """A table in Markdown."""
    lines = [head, ["---"] * len(head), *body]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def wrong(row):
    """Answers that are no answers, or another state's."""
    return sum(int(row[key]) for key in ("failed", "inadmissible", "elsewhere"))


def strips(folder):
    """One strip by several methods."""
    regimes = ["adhesion without contact", "contact without adhesion", "saturated adhesion", "adhesion zones",
               "adhesion zones with snap"]
    body, others = [], []
    for regime in regimes:
        cells = [regime]
        for method in ("cold", "warm"):
            row = one(folder, "strip_methods", regime=regime, method=method)
            cells.append(f"{time(row['us_least'])}, {error(row['error_median'])}, {wrong(row)}")
        for name, library in (("strip_methods", "gsl"), ("strip_scipy", "scipy")):
            for start in ("lengths", "rest"):
                row = rows_of(folder, name, regime=regime, method=f"{library} from {start}")[-1]
                us = row["us_least" if library == "gsl" else "us"]
                cells.append(f"{time(us)}, {error(row['error_median'])}, {wrong(row)}")
        for row in rows_of(folder, "strip_methods", regime=regime, method="time march")[2::2]:
            cells.append(f"{time(row['us_least'])}, {error(row['error_median'])}, {row['elsewhere']} of {row['strips']}")
        body.append(cells[:5])
        others.append([regime, *cells[5:]])
    return "\n\n".join((table(["regime", "ours, cold", "ours, warm", "GSL, near", "GSL, from rest"], body),
                        table(["regime", "SciPy, near", "SciPy, from rest", "time stepping, 1e4", "time stepping, 1e6"], others)))


def random_strips(folder):
    """Random strips."""
    body = [[row["regime"], row["strips"], str(sum(int(row[key]) for key in ("not_converged", "not_steady", "not_first"))),
             time(row["cold_us"]), time(row["warm_us"]), time(row["cold_worst_us"])]
            for row in rows_of(folder, "random_strips")]
    return table(["regime", "strips", "wrong or unsolved", "cold us", "warm us", "slowest us"], body)


def surface_strips(folder):
    """Error against number of strips."""
    shown = [("equal", "16 equal strips", 2), ("equal", "128", 5), ("equal", "4096", 10),
             ("gauss", "16 strips on each of 16 panels", 4), ("gauss", "256 panels", 8), ("adaptive", "our rule, 1e-4", 2), ("adaptive", "1e-8", 6)]
    keys = ["load_error", "friction_error", "mu_error", "contact_error", "adhesion_error"]
    body = []
    for case in ("no adhesion", "release across the surface", "snap into contact"):
        for rule, name, place in shown:
            row = rows_of(folder, "surface_3d_strips", case=case, rule=rule)[place]
            body.append([case if rule == "equal" and place == 2 else "", name, f"{float(row['strips']):.0f}", time(row["us_least"]),
                         *(error(row[key]) for key in keys)])
    return table(["case", "rule", "strips", "us", "P", "T", "mu", "contact", "adhesion"], body)


def surface_points(folder):
    """Points under load."""
    body = [[row["case"], f"{time(row['us_least'])} to {time(row['us_most'])}", f"{float(row['strips_per_point']):.0f}",
             time(row["us_no_equilibrium"]) if float(row["us_no_equilibrium"]) > 0 else ""]
            for row in rows_of(folder, "surface_3d_points")]
    return table(["2000 loads", "us per point with equilibrium", "strips", "us per point without"], body)


def sphere(folder):
    """Every method at given radii."""
    names = ["ours", "m-form", "JKR", "DMT", "Adhesion"]
    body = []
    for lam in dict.fromkeys(row["lambda"] for row in rows_of(folder, "sphere_side_by_side")):
        cells = [power(lam)]
        for name in names:
            row = one(folder, "sphere_side_by_side", **{"lambda": lam}, method=name)
            text = f"{time(row['us'])}, {error(row['error'])}"
            if row["proved"] and float(row["proved"]) > 0:
                text += f" ({error(row['bound'])} for {100 * float(row['proved']):.0f} %)"
            cells.append(text)
        body.append(cells)
    return table(["lambda", "ours", "textbook's form in m", "JKR", "DMT", "package Adhesion"], body)


def sphere_held(folder):
    """What is held, ours and the package."""
    body = []
    for row in rows_of(folder, "sphere_public"):
        if row["held"] in ("load", "pull-off of load") and row["lambda"] in ("1e-03", "1e-01", "1e+00", "1e+01", "1e+03", "1e+06"):
            body.append([row["held"], power(row["lambda"]), f"{time(row['our_us'])}, {error(row['our_error'])}",
                         f"{time(row['us_least'])}, {error(row['error'])}"])
    return table(["prescribed", "lambda", "ours: us, error", "package: us, error"], sorted(body, key=lambda cells: cells[0]))


def sphere_times(folder):
    """Least and most of the medians over lambda."""
    names = {"radius": "load and approach of a radius", "load": "radius of a load", "approach": "radius of an approach",
             "load below -3/2": "radius of a load between pull-off and -3/2", "pull-off of load": "pull-off under load",
             "pull-off of approach": "pull-off under approach"}
    found = {}
    for row in rows_of(folder, "sphere_times"):
        found.setdefault(row["held"].strip(), {}).setdefault(row["order"].strip() or "cold", []).append(float(row["us"]))
    body = [[name, *(f"{time(min(times[order]))} to {time(max(times[order]))}" if order in times else ""
                     for order in ("swept", "shuffled", "cold"))] for held, name in names.items() for times in [found[held]]]
    return table(["us", "swept", "shuffled", "cold"], body)


def sphere_auto(folder):
    """What `auto` saves."""
    body = [["maugis_dugdale" if not float(row["tolerance"]) > 0 else error(row["tolerance"]),
             f"{100 * float(row['share_of_limit_theories']):.0f} %", time(row["us_least"]), error(row["largest_error"])]
            for row in rows_of(folder, "sphere_auto")]
    return table(["tolerance", "limit theories", "us per point", "largest error"], body)


def wave_2d(folder):
    """Area, pressure and time against cells."""
    finest = {row["load"]: row for row in rows_of(folder, "wave_2d", surface="quarter", cells="2048")}
    body = []
    for cells in ("128", "256", "512", "1024", "2048"):
        quarter, general = (rows_of(folder, "wave_2d", surface=kind, cells=cells) for kind in ("quarter", "general"))
        times = [f"{time(min(least))} to {time(max(least))}" if least else ""
                 for least in [[float(row["ms_least"]) for row in found] for found in (quarter, general)]]
        if cells == "2048":
            body.append([cells, *times, "", error(max(float(row["area_error_estimate"]) for row in quarter)), ""])
            continue
        body.append([cells, *times,
                     error(max(abs(float(row["area"]) - float(finest[row["load"]]["area"])) for row in quarter)),
                     error(max(float(row["area_error_estimate"]) for row in quarter)),
                     error(max(abs(float(row["peak_difference"])) for row in quarter))])
    return table(["cells along a period", "quarter [ms]", "general [ms]", "difference of area", "its bound", "difference of largest pressure"], body)


def wave_2d_public(folder):
    """Beside the public libraries."""
    rows = rows_of(folder, "wave_2d_public")
    solvers = [name for name in dict.fromkeys(row["solver"] for row in rows) if not name.startswith("adfric")]
    body = []
    for cells, load in dict.fromkeys((row["cells"], row["load"]) for row in rows):
        line = [cells, load]
        for solver in ("adfric, quarter", "adfric, general", *solvers):
            found = [row for row in rows if (row["cells"], row["load"], row["solver"]) == (cells, load, solver)]
            line.append(f"{time(found[0]['ms'])}, {error(found[0]['residual'])}, {time(found[0]['slower'])}" if found else "")
        body.append(line)
    return table(["cells", "p/p*", "quarter: ms, residual, ratio", "general", *solvers], body)


def slip_public(folder):
    """Partial slip beside a public library."""
    body = [[row["share"], row["solver"], f"{float(row['ms']) / 1000:.0f}", f"{float(row['ratio']):.0f}", error(row["pressure"]), error(row["along"]),
             error(row["across"]), error(row["displacement"]), row["slip_adfric"], row["slip"]] for row in rows_of(folder, "slip_public")]
    return table(["T/(mu P)", "Tamaas 2.9.0", "s", "ratio of times", "pressure", "along T", "across", "displacement", "adfric",
                  "Tamaas"], body)


def sliding_public(folder):
    """Sliding waves beside time stepping."""
    body = []
    rows = rows_of(folder, "sliding_public")
    for row in rows:
        if row["solver"] == "Tamaas":
            ours = [mine for mine in rows if mine["solver"] == "adfric" and (mine["case"], mine["speed"], mine["cells"]) == (
                row["case"], row["speed"], row["beside"])][0]
            body.append([f"`{row['case']}`", row["speed"], row["cells"], row["steps"], f"{time(row['ms'])}, {error(row['error'])}",
                         ours["cells"], f"{time(ours['ms'])}, {error(ours['error'])}", time(row["slower"])])
    return table(["wave", "k V t", "cells of Tamaas 2.9.0", "steps", "ms, error", "our cells", "ms, error", "ratio of times"], body)


def closed_forms(folder):
    """Time of a point."""
    body = [[f"`{row['model']}`", row["case"], f"`{row['swept']}`", time(row["us_least"]), error(row["error_estimate"])]
            for row in rows_of(folder, "closed_forms")]
    return table(["model", "case", "swept", "us per point", "largest error estimate"], body)


def wave_1d(folder):
    """Largest pressure against Westergaard."""
    loads = list(dict.fromkeys(row["load"] for row in rows_of(folder, "wave_1d")))
    body = []
    for cells in ("64", "256", "1024", "4096", "16384"):
        rows = rows_of(folder, "wave_1d", cells=cells)
        body.append([cells, time(max(float(row["ms_least"]) for row in rows)), *(error(row["peak_error"]) for row in rows)])
    return table(["cells", "ms", *(f"{'' if place else 'p/p* = '}{float(load):g}" for place, load in enumerate(loads))], body)


def whole_cases(folder):
    """A million points."""
    body = [[row["case"], f"{float(row['us_least']):.2f} to {float(row['us_most']):.2f}", f"{float(row['peak_mb']):.0f}",
             f"{float(row['file_mb']):.0f}"] for row in rows_of(folder, "whole_program_cases")]
    return table(["a million points, one thread", "us per point", "peak MB", "file MB"], body)


def whole_points(folder):
    """Points per second."""
    body = []
    for points in dict.fromkeys(row["points"] for row in rows_of(folder, "whole_program_points")):
        line = [power(points)]
        for threads in "12":
            row = one(folder, "whole_program_points", points=points, threads=threads)
            line += [f"{1e6 / float(row['us_least']):.0f}", f"{float(row['peak_mb']):.0f}"]
        body.append(line)
    return table(["points", "points/s, 1 thread", "peak MB", "points/s, 2 threads", "peak MB"], body)


def whole_phases(folder):
    """Where the time goes."""
    keys = ["input", "name", "solution", "waiting", "closing", "beside", "share", "share_least"]
    body = [[row["case"], *(f"{100 * float(row[key]):.1f}" for key in keys)] for row in rows_of(folder, "whole_program_phases")]
    return table(["% of the time", "input", "file name", "solution", "waiting", "closing",
                  "writing, beside it", "all but the solution", "least"], body)


def reader(folder):
    """Large inputs."""
    body = [[row["shape"], time(row["s"]), time(row["s_half"]), f"{float(row['peak_mb']):.0f}"] for row in rows_of(folder, "reader")]
    return table(["an input of 10 MB that repeats", "s", "s for 5 MB", "peak MB"], body)


def error_estimates(folder):
    """Estimates and true errors."""
    body = []
    for name in dict.fromkeys(row["cases"] for row in rows_of(folder, "error_estimates")):
        found = {row["decade"]: float(row["count"]) for row in rows_of(folder, "error_estimates", cases=name)}
        counts = [sum(n for decade, n in found.items() if decade.lstrip("-").isdigit() and low <= int(decade) < high)
                  for low, high in ((-99, 0), (0, 1), (1, 2), (2, 3), (3, 99))]
        body.append([name, f"{found['cases']:.0f}", *(f"{n:.0f}" for n in counts), f"{100 * found['share_held']:.1f}",
                     f"{100 * found['share_within_100']:.1f}"])
    return table(["estimate over error", "cases", "below 1", "1 to 10", "10 to 100", "100 to 1000", "above",
                  "% not below 1", "% within 100"], body)


def scenes(folder):
    """What each saving is worth."""
    body = [[row["saving"], row["scene"], time(row["ratio"]), error(row["change"]), error(row["allowed"])]
            for row in rows_of(folder, "scenes")]
    return table(["saving", "scene", "time without over with", "change of the results", "allowed"], body)


def profiles(folder):
    """A rough profile under a load."""
    body = []
    for row in rows_of(folder, "profiles"):
        plain = float(row["plain_us"])
        body.append([row["arms"], row["adhesion"].strip(), time(row["prepare_ns"]), time(row["us"]), row["periods"].strip(),
                     *(("", "") if plain == 0 else (f"{plain / float(row['us']):.0f}", error(row["difference"])))])
    return table(["relaxation times", "adhesion", "preparation [ns a sample]", "a load [us]", "periods",
                  "plain over this", "friction"], body)


def timed_adhesion(folder):
    """Bodies that adhere to a viscoelastic half-space in time."""
    body = [[row["family"], f"{float(row['tolerance']):.0e}".replace("e-0", "e-"), row["runs"], time(row["ms"]), time(row["ms_largest"]), error(row["error"]),
             error(row["error_largest"])] for row in rows_of(folder, "timed_adhesion")]
    return table(["runs", "tolerance", "number", "ms, median", "longest", "error, median", "largest"], body)


def sliding(folder):
    """Waves and random surfaces that slide over a viscoelastic half-space."""
    body = []
    cases = {}
    for row in rows_of(folder, "sliding"):
        if row["threads"] == "1":
            cases.setdefault((row["case"].strip(), int(row["cells"])), []).append(row)
    for (name, cells), rows in cases.items():
        times, pairs, errors, imbalances = ([abs(float(row[key])) for row in rows] for key in ("ms", "pairs", "error", "imbalance"))
        body.append([f"`{name}`" if name.startswith("wave") else f"random, {name}", str(cells), between(times, time), between(pairs, lambda n: f"{float(n):.0f}"),
                     between(errors, error) if max(errors) > 0 else "", error(max(imbalances))])
    return table(["surface", "cells along x", "time [ms]", "pairs of transforms", "error of the friction", "largest imbalance"], body)


def sliding_layers(folder):
    """Random surfaces that slide over viscoelastic layers."""
    cases = {}
    for row in rows_of(folder, "sliding_layers"):
        cases.setdefault((row["case"].strip(), row["cells"], float(row["thickness"])), []).append(float(row["pairs"]))
    names = list(dict.fromkeys((name, cells) for name, cells, _ in cases))
    body = []
    for thickness in dict.fromkeys(key[2] for key in cases):
        body.append(["half-space" if thickness == 0 else f"{thickness:g}",
                     *(f"{sum(pairs)/len(pairs):.0f}, {max(pairs):.0f}" for pairs in (cases[*name, thickness] for name in names))])
    return table(["thickness over period", *(f"{name}, {cells} cells" for name, cells in names)], body)


def partial_slip(folder):
    """Random surfaces in partial slip."""
    body = []
    cases = {}
    for row in rows_of(folder, "partial_slip"):
        cases.setdefault(row["tau"], []).append(row)
    for tau, rows in cases.items():
        errors = [error(max(float(row[key]) for row in rows)) for key in (
            "error_displacement", "error_stiffness", "error_energy", "error_defect", "error_traction")]
        body.append([f"{float(tau):g}", between([float(row["ratio"]) for row in rows], lambda ratio: f"{float(ratio):.2f}"), *errors,
                     str(max(int(row["stick_cells"]) for row in rows))])
    return table(["T/(mu P)", "pairs", "displacement", "stiffness", "energy over T u", "`poisson_defect`", "traction", "cells"], body)


def between(numbers, text):
    """The least and the largest of some numbers."""
    ends = [text(str(end)) for end in (min(numbers), max(numbers))]
    return ends[0] if ends[0] == ends[1] else " to ".join(ends)


def adhesion_cells(folder):
    """What cells make of zones of few of them."""
    body = [[f"{float(row['cells_per_zone']):g}", row["other"], row["below"], error(row["area_median"]), error(row["area_largest"]),
             error(row["penetration_largest"]), error(row["pull_off_strong"]), error(row["pull_off_weak"])] for row in rows_of(folder, "adhesion_cells")]
    return table(["cells per zone", "another state", "error above estimate", "area, median", "largest", "penetration [D]", "too strong", "weak"], body)


def free_surface(folder):
    """Bodies that end, on a half-space that goes on."""
    body = [[row["body"], row["cells"], time(row["ms"]), row["steps"],
             *(["", ""] if row["body"] == "rough" else [error(row["error"]), error(row["area_error"])]), error(row["estimate"]), error(row["area_estimate"])]
            for row in rows_of(folder, "free_surface")]
    return table(["body", "cells along x", "time [ms]", "steps", "error", "of the area", "estimate", "of the area"], body)


def free_public(folder):
    """Bodies that end, beside the public library."""
    body = [[row["body"], row["cells"], time(row["ms"]), error(row["error"]) if row["error"] else "", time(row["library_ms"]),
             error(row["library_error"]) if row["library_error"] else "", time(row["slower"]), error(row["apart"]) if row["apart"] else ""]
            for row in rows_of(folder, "free_public")]
    return table(["body", "cells along x", "adfric [ms]", "error", "ContactMechanics 1.8.3 [ms]", "error", "ratio", "apart"], body)


def adhesion_laws(folder):
    """A wave that adheres by each law of attraction."""
    body = [[f"`{row['law']}`", row["cells"], f"{time(row['ms_least'])} to {time(row['ms_most'])}",
             f"{float(row['pairs_least']):.0f} to {float(row['pairs_most']):.0f}", error(row["contact_error"]), error(row["gap_error"]), row["above"]]
            for row in rows_of(folder, "adhesion_laws")]
    return table(["law", "cells along a period", "time [ms]", "pairs of transforms", "contact", "mean gap", "above its estimate"], body)


def random_transients(folder):
    """Random waves that adhere while they slide, beside transients."""
    body = [[row["prescribed"], row["branch"], *(row[name] for name in ("waves", "judged", "friction_known", "apart", "restless", "not_converged",
                                                                        "wrong"))] for row in rows_of(folder, "random_transients")]
    return table(["prescribed", "branch", "waves", "judged", "friction known", "apart", "restless", "`not_converged`", "wrong"], body)


def adhesion_public(folder):
    """States that adhere beside the public libraries."""
    rows = rows_of(folder, "adhesion_public")
    solvers = [name for name in dict.fromkeys(row["solver"] for row in rows) if name != "adfric"]
    case = ("surface", "law", "cells", "stress", "range", "branch", "load")
    body = []
    for key in dict.fromkeys(tuple(row[name] for name in case) for row in rows):
        line = list(key)
        for solver in ("adfric", *solvers):
            found = [row for row in rows if tuple(row[name] for name in case) == key and row["solver"] == solver]
            line.append(", ".join([time(found[0]["ms"]), *([error(found[0]["error"])] if found[0]["error"] else []),
                                   *([time(found[0]["slower"])] if solver != "adfric" else [])]) if found else "")
        body.append(line)
    return table(["surface", "law", "cells", "p0/E*", "h0", "branch", "p/E*", "adfric", *solvers], body)


def fit_public(folder):
    """Fits of curves beside the public package."""
    body = [[row["theory"] if row["theory"] == "no curve" else f"`{row['theory']}`", row["method"], time(row["ms_least"]), time(row["ratio"]) if row["ratio"] else "",
             error(row["error"]) if row["error"] else "", error(row["error_largest"]) if row["error_largest"] else "", row["failed"]]
            for row in rows_of(folder, "fit_public")]
    return table(["theory", "by", "ms per curve", "ratio of times", "error of the modulus, median", "largest", "no answer"], body)


def python_calls(folder):
    """What calls from Python cost."""
    rows = read_table(folder / "python_calls.csv")[1]
    return table(["", "microseconds, or ratio"], [[row["what"], f"{float(row['value']):.2g}"] for row in rows])


#: Short words for results of theories, and for theories.
SHORT = {"contact_fraction": "area", "mean_gap": "gap", "normal_stiffness": "K", "elastic_energy": "U", "persson": "P",
         "yang_persson": "YP", "wang_mueser": "WM", "greenwood_williamson": "GW", "bush_gibson_thomas": "BGT",
         "greenwood_elliptic": "GE", "nayak_sphere": "NS"}


def of_names(quantity, theory):
    """Short words for a result."""
    return f"{SHORT[quantity]} {SHORT[theory]}"


def ratios(rows):
    """Least and largest ratio of rows."""
    found = [float(row["ratio"]) for row in rows if row["ratio"] not in ("", "nan")]
    return f"{min(found):.2f} to {max(found):.2f}" if found else ""


def theories_pressed(folder):
    """Least and largest ratio of theories over cells, over the spectra, at each pressure."""
    rows = rows_of(folder, "theories_pressed")
    pressures = list(dict.fromkeys(row["pressure"] for row in rows))
    body = []
    for quantity, theory in dict.fromkeys((row["quantity"], row["theory"]) for row in rows):
        own = [row for row in rows if (row["quantity"], row["theory"]) == (quantity, theory)]
        complete = [[row for row in own if row["pressure"] == pressure] for pressure in pressures]
        # a theory that has no state for one of the spectra has no band there
        body.append([of_names(quantity, theory),
                     *("" if any(row["ratio"] == "nan" for row in part) else ratios(part).replace(" to ", "-") for part in complete)])
    return table(["", *pressures], body)


def theories_within(folder):
    """How many of the spectra are within 5, 10 and 30 %."""
    rows = [row for row in rows_of(folder, "theories_pressed") if row["theory"] in ("persson", "yang_persson", "wang_mueser")]
    pressures = list(dict.fromkeys(row["pressure"] for row in rows))
    body = []
    for quantity, theory in dict.fromkeys((row["quantity"], row["theory"]) for row in rows):
        line = [of_names(quantity, theory)]
        for pressure in pressures:
            own = [abs(float(row["ratio"]) - 1) for row in rows if (row["quantity"], row["theory"], row["pressure"]) == (quantity, theory, pressure)]
            line.append("/".join(str(sum(one <= most for one in own)) for most in (0.05, 0.1, 0.3)))
        body.append(line)
    return table(["", *pressures], body)


def theories_spectra(folder):
    """Area, gap and stiffness of each spectrum at two pressures."""
    rows = rows_of(folder, "theories_pressed")
    shown = [("contact_fraction", "persson"), ("contact_fraction", "yang_persson"), ("contact_fraction", "wang_mueser"), ("mean_gap", "wang_mueser"),
             ("normal_stiffness", "yang_persson")]
    body = []
    for name, pressure in ((name, pressure) for pressure in ("0.02", "0.2") for name in dict.fromkeys(row["spectrum"] for row in rows)):
        own = [row for row in rows if (row["spectrum"], row["pressure"]) == (name, pressure)]
        line = [pressure, name, own[0]["hurst_exponent"], "{longest}, {rolloff}, {shortest}".format(**own[0]), f"{float(own[0]['nayak_parameter']):.3g}"]
        for quantity, theory in shown:
            row = next(row for row in own if (row["quantity"], row["theory"]) == (quantity, theory))
            line.append(f"{float(row['ratio']):.2f} +- {float(row['ratio'])*float(row['error']):.2f}")
        body.append(line)
    body.sort(key=lambda line: (float(line[0]), float(line[4])))
    return table(["p/(E g)", "spectrum", "H", "waves", "Nayak", *(of_names(quantity, theory) for quantity, theory in shown)], body)


def theories_parting(folder):
    """Pull-off by the bearing area over that of cells."""
    rows = rows_of(folder, "theories_parting")
    body = []
    for tension, reach in dict.fromkeys((row["tension"], row["range"]) for row in rows):
        for hurst in dict.fromkeys(row["hurst_exponent"] for row in rows):
            own = {row["theory"]: row for row in rows if (row["tension"], row["range"], row["hurst_exponent"]) == (tension, reach, hurst)}
            first = own["yang_persson"]
            body.append([tension, reach, hurst, f"{float(first['mean']):.2g} +- {100*float(first['error']):.0f} %",
                         *(f"{float(own[theory]['ratio']):.2f}" for theory in ("yang_persson", "wang_mueser")), f"{float(first['pastewka_robbins']):.3g}",
                         f"{float(first['work_ratio']):.2g}"])
    return table(["p0/(E g)", "r/h", "H", "pull-off over p0", "YP", "WM", "`pastewka_robbins_ratio`", "`full_contact_work_ratio`"], body)


def theories_sliding(folder):
    """Friction by theories over that of cells."""
    rows = rows_of(folder, "theories_sliding")
    body = []
    for pressure, hurst, theory in dict.fromkeys((row["pressure"], row["hurst_exponent"], row["theory"]) for row in rows):
        own = [row for row in rows if (row["pressure"], row["hurst_exponent"], row["theory"]) == (pressure, hurst, theory)]
        body.append([pressure, hurst, SHORT[theory], *(f"{float(row['ratio']):.2f} +- {float(row['ratio'])*float(row['error']):.2f}" for row in own)])
    return table(["p/(E0 g)", "H", "theory", *dict.fromkeys(f"q V t = {row['speed']}" for row in rows)], body)


TABLES = {function.__name__: function for function in (
    random_strips, strips, surface_strips, surface_points, sphere, sphere_held, sphere_times, sphere_auto, closed_forms, wave_2d,
    wave_2d_public, slip_public, sliding_public, adhesion_cells, adhesion_laws, free_surface, free_public, random_transients, adhesion_public, fit_public, python_calls, wave_1d, whole_cases, whole_points, whole_phases, reader, error_estimates, scenes, profiles, timed_adhesion, sliding, sliding_layers, partial_slip, theories_pressed, theories_within,
    theories_spectra, theories_parting, theories_sliding)}


def main():
    arguments = [argument for argument in sys.argv[1:] if argument != "--write"]
    if arguments and arguments[0].startswith("-"):
        sys.exit(__doc__)
    folder = pathlib.Path(arguments[0]) if arguments else ROOT / "build" / "bench"
    texts = {}
    for name, function in TABLES.items():
        try:
            texts[name] = function(folder)
        except (FileNotFoundError, IndexError, KeyError) as problem:
            # not run yet, or by an older benchmark
            print(f"tables: nothing for {name}: {problem}", file=sys.stderr)
    if "--write" not in sys.argv:
        for name, text in texts.items():
            print(f"\n{name}\n\n{text}")
        return
    for path in DOCUMENTS:
        document = path.read_text()
        for name, text in texts.items():
            document = re.sub(rf"(<!-- table {name} -->\n)(?:.*?\n)??(<!-- end -->)", lambda m: f"{m[1]}{text}\n{m[2]}", document,
                              flags=re.DOTALL)
        path.write_text(document)


if __name__ == "__main__":
    main()
