# SPDX-License-Identifier: GPL-3.0-or-later
"""Make the gallery: scripts/gallery [--check].

Every input is run, and docs/gallery.md shows its figure, with what the head of the input says of it. Results stay in build/gallery, and a
figure keeps a digest of its inputs and of what draws it, so that nothing is run or drawn twice. Six figures stand in the repository, the
others only where they have been drawn. --check tells, a line each, what of the page and of the six is missing or out of date, and which
figures belong to nothing; it runs nothing. Exit status: 0, 1 if --check has found something, 2 for a bad command line, 3 if a
run or a figure fails.
"""

import argparse
import hashlib
import io
import os
import re
import shlex
import subprocess
import sys
import textwrap
from dataclasses import dataclass
from pathlib import Path

from PIL import Image, PngImagePlugin

from document_prose import LONGEST_LINE

ROOT = Path(__file__).resolve().parents[1]
INPUTS, PAGE, FIGURES, WORK = ROOT / "inputs", ROOT / "docs/gallery.md", ROOT / "docs/gallery", ROOT / "build/gallery"
# Width of a figure [pixels], colours, letters of a text.
WIDTH, COLOURS = 760, 64
MOST_LETTERS = 420
KEY = "made-from"
COMMAND = re.compile(r"scripts/((?:make_\w+|import_surface|import_curve)\b[^\n]*)")
# a space where no line is broken
KEPT_SPACE = "\0"
# an input whose results another one fits, and what tells a fit from a run
RUN_BEFORE = re.compile(r"adfric run inputs/(\w+)\.nml")
CUT_SHORT = re.compile(r"\b(?:Acta|Appl|Arch|Colloid|Eng|Int|Lett|Lond|Math|Mech|Mater|Phys|Proc|Rev|Sci|Soc|Struct|Trans)$")
FIT = re.compile(r"^\s*&free\b", re.MULTILINE | re.IGNORECASE)


@dataclass(frozen=True)
class Entry:
    """A figure: its inputs, and the options of scripts/plot."""

    inputs: tuple
    options: str = ""

    @property
    def name(self):
        """Its name, that of the first input."""
        return self.inputs[0]

    @property
    def figure(self):
        """Its file."""
        return FIGURES / f"{self.name}.png"


def one(*inputs, options=""):
    """A figure of one input or several."""
    return Entry(inputs, options)


# What a user wants comes first, and in each area the simplest; the figures of papers come last.
AREAS = {
    "Friction and pull-off of a tip": (
        one("johnson1997_fig5", "johnson1997_fig5_jkr"), one("hertz_jkr"), one("pulloff_map_load"), one("pulloff_map_approach"),
        one("sphere_pressure"), one("indenter_spring"), one("indenter_opening"),
        one("sphere_pressure_factor", options="--y tangential_force stick_radius edge_slip"),
        one("stick_slip", options="--y tangential_force contact_radius edge_slip"), one("sphere_pull_off_edge"),
        one("sphere_sample"), one("sphere_uncertain")),
    "Fits of measured data": (
        one("fit_friction"), one("fit_force_distance"), one("fit_map"), one("force_map"), one("fit_soft_sample"), one("fit_cell"),
        one("fit_velocity"), one("fit_interface"), one("fit_interface_all"), one("fit_johnson1997_fig5")),
    "Tips and punches of any shape": (
        one("indenter_cone"), one("indenter_sphere"), one("indenter_flat"), one("indenter_power"), one("indenter_polynomial"),
        one("indenter_rounded_punch"), one("indenter_rounded_cone"), one("indenter_flat_cone"), one("indenter_pull_off"),
        one("indenter_range"), one("pull_off_of_laws"), one("indenter_friction"), one("indenter_interaction", options="--y contact_radius adhesion_ratio"),
        one("indenter_peeling", options="--y contact_radius tangential_displacement")),
    "Soft samples in time": (
        one("soft_dwell"), one("soft_creep"), one("soft_oscillation"),
        one("soft_pull_off", options="--y pull_off_load pull_off_approach"),
        one("soft_dwell_adhesion", options="--y pull_off_load pull_off_approach"), one("rough_ageing")),
    "Hertz's contacts, punches and given loads": (
        one("hertz_axes"), one("hertz_ratio"), one("punch_flat"), one("punch_cylinder"), one("punch_wedge"), one("rigid_punch"),
        one("punch_stress"), one("line_load"), one("strip_load"), one("strip_load_maps"), one("strip_load_sampled"),
        one("point_load"), one("rectangle_load", options="--y stress_zz stress_xx displacement_z")),
    "Fretting and partial slip": (
        one("hertz_slip"), one("hertz_hysteresis"), one("indenter_slip"), one("indenter_hysteresis"), one("indenter_fretting"),
        one("wave_1d_slip"), one("surface_slip"),
        one("cylinder_rolling", options="--y tangential_force stick_fraction dissipation")),
    "Rubber that slides": (
        one("rubber_velocity"), one("rubber_master_curve"), one("line_scan"), one("rubber_map"), one("hertz_line_sliding"),
        one("wave_1d_sliding", "wave_1d_sliding_cells", options="--y friction_coefficient contact_fraction contact_shift peak_pressure"),
        one("wave_2d_sliding"), one("surface_sliding"),
        one("theories_rubber", options="--y friction_coefficient_yang_persson contact_fraction_persson"),
        one("surface_sliding_strips", "surface_sliding_layer", options="--y friction_coefficient contact_fraction approach")),
    "Rubber that slides, with an interface, adhesion or heat": (
        one("wave_1d_interface"),
        one("wave_1d_adhesive_sliding", options="--x velocity --y friction_stress friction_stress_without_adhesion pull_off_pressure"),
        one("cylinder_adhesive_sliding", options="--x velocity --y friction_force friction_force_without_adhesion pull_off_load"),
        one("wave_2d_sliding_adhesion", options="--y friction_stress friction_stress_without_adhesion contact_fraction"),
        one("wave_1d_sliding_laws", options="--y friction_stress contact_fraction"),
        one("rubber_all_parts"),
        one("wave_1d_coupling", options="--y friction_coefficient hysteretic_friction_stress contact_shift"),
        one("ball_flash_temperature", options="--y friction_force contact_temperature"), one("rubber_flash_temperature")),
    "Waves and rough surfaces: contact": (
        one("wave_1d"), one("wave_1d_pressure"), one("wave_2d_elastic"), one("wave_2d_contact"),
        one("wave_2d_coating", options="--y contact_fraction peak_pressure penetration"),
        one("lecture_wave_cuts", options="--cut y=0 y=x"), one("surface_elastic"), one("free_rough_tip"),
        one("theories_pressure", options="--y contact_fraction_wang_mueser mean_gap_wang_mueser"),
        one("theories_of_map", options="--y contact_fraction_persson contact_fraction_wang_mueser mean_gap_wang_mueser"),
        one("spectrum_seeds", options="--y contact_fraction mean_gap"), one("spectrum_ensemble"),
        one("surface_hardness", options="--y contact_fraction plastic_fraction"),
        one("contact_conductance", "contact_conductance_theory", options="--y electrical_conductance thermal_conductance"),
        one("depth_stresses", options="--y largest_von_mises_stress largest_shear_stress")),
    "Waves and rough surfaces: adhesion": (
        one("surface_adhesion_maps"), one("surface_work_map"), one("surface_stickiness"), one("surface_opening", options="--y pull_off_pressure contact_fraction"),
        one("surface_adhesion_friction"),
        one("free_tip_adhesion", "free_tip_adhesion_approach", options="--x approach --y load contact_area"),
        one("free_tip_law", "free_tip_adhesion", options="--x approach --y load contact_area"),
        one("wave_1d_adhesion", "wave_1d_adhesion_approach", options="--x penetration --y mean_pressure contact_fraction"),
        one("wave_1d_adhesion_pressure"), one("wave_1d_pull_off"), one("wave_2d_adhesion", "wave_2d_adhesion_approach"),
        one("wave_2d_adhesion_penetration", "wave_2d_adhesion_penetration_approach", options="--y mean_pressure contact_fraction"),
        one("wave_2d_pull_off")),
    "Columns: edges of adhesion and thin layers": (
        one("edge_rule_fig5"), one("edge_rule_fig6"), one("edge_rule_front"),
        one("edge_rules_continuous", "edge_rules_instantaneous", "edge_rules_front"),
        one("columns_laws", options="--y friction_stress contact_fraction"),
        one("layer_limit_columns", "layer_limit_thin", "layer_limit_thick", options="--y friction_stress contact_fraction")),
    "Figures of Goryacheva and Makhovskaya 2011": (
        one("gm2011_fig4_reconciled"), one("gm2011_fig4_printed"), one("gm2011_fig5"), one("gm2011_fig6"), one("gm2011_fig7"),
        one("gm2011_fig8"), one("gm2011_stress", options="--y friction_stress contact_width"),
        one("gm2011_pull_off", options="--y friction_stress"), one("gm2011_velocity", options="--y friction_stress")),
    "Figures of Johnson 1997 and of the lecture": (
        one("johnson1997_fig1", options="--x gap --y pressure"), one("johnson1997_fig2", options="--y pressure"),
        one("johnson1997_fig3"), one("johnson1997_fig4", options="--y friction_radius"), one("johnson1997_fig6"),
        one("johnson1997_fig7"), one("johnson1997_fig8"), one("johnson1997_fig9a"), one("johnson1997_fig9b"),
        one("johnson1997_fig10", options="--y tangential_displacement edge_slip"), one("johnson1997_fig11"),
        one("johnson1997_savkoor", options="--y friction_area"),
        one("johnson1997_lambda", options="--y friction_area pull_off_load"), one("lecture_jkr")),
}
# Columns of the overview: their widths [pixels] and figures.
OVERVIEW = (
    (560, (one("surface_adhesion_maps"),)),
    (380, (one("gm2011_fig6", options="--y friction_coefficient"), one("johnson1997_fig5", "johnson1997_fig5_jkr"))),
    (380, (one("wave_1d_sliding", options="--y friction_coefficient"), one("pulloff_map_load"))))
OVERVIEW_FILE = FIGURES / "overview.png"
# The figures that stand in the repository, see .gitignore; the first pages show them.
KEPT = ("overview", "fit_map", "gm2011_fig5", "hertz_hysteresis", "johnson1997_fig5", "rubber_velocity")


def all_entries():
    """All figures."""
    return [entry for entries in AREAS.values() for entry in entries]


def digest_of(*parts):
    """A digest of texts."""
    return hashlib.sha256("\0".join(parts).encode()).hexdigest()[:16]


def text_of(name):
    """The text of an input."""
    return (INPUTS / f"{name}.nml").read_text()


def digest_of_entry(entry):
    """What an up-to-date figure was made from: its inputs, its options and what draws it."""
    drawing = [path.read_text() for path in sorted((ROOT / "scripts/plotting").glob("*.py"))]
    return digest_of(*map(text_of, entry.inputs), entry.options, *drawing)


def digest_of_overview():
    """The same of the overview."""
    return digest_of(*(f"{width} {digest_of_entry(entry)}" for width, entries in OVERVIEW for entry in entries))


def digest_in(path):
    """What a figure was made from; empty if there is no figure."""
    if not path.is_file():
        return ""
    with Image.open(path) as image:
        return image.info.get(KEY, "")


def head_of(name):
    """What the head of an input says first: whole sentences, before any command, of about `MOST_LETTERS`."""
    lines = []
    for line in text_of(name).splitlines():
        if not line.startswith("!"):
            break
        lines.append(line.removeprefix("!").strip())
    text = " ".join(lines)
    shown = text.partition("scripts/")[0]
    # an initial of a name, or a word of a source that is cut short, ends no sentence
    ends = [match.end() for match in re.finditer(r"(?<=[a-z0-9)\]*])\.(?=\s|$)", shown) if not CUT_SHORT.search(shown[:match.start()])]
    short = [end for end in ends if end <= MOST_LETTERS]
    return shown[:max(short, default=min(ends))]


def title_of(name):
    """The title of an input."""
    return re.search(r"title\s*=\s*'([^']*)'", text_of(name))[1]


def commands_of(entry):
    """The commands that make its data, as the heads of its inputs name them."""
    found = []
    for name in entry.inputs:
        head = "\n".join(line for line in text_of(name).splitlines() if line.startswith("!"))
        found += [command.strip().rstrip(".") for command in COMMAND.findall(head)]
    return list(dict.fromkeys(found))


def run(entry, name):
    """Run an input in the folder of its entry, unless that was done already; the results file."""
    folder = WORK / entry.name
    # data and results may have one name
    (folder / "results").mkdir(parents=True, exist_ok=True)
    results, stamp = folder / f"results/{name}.h5", folder / f"results/{name}.made_from"
    made_from = digest_of(text_of(name), *map(text_of, RUN_BEFORE.findall(text_of(name))), *commands_of(entry))
    if results.exists() and stamp.exists() and stamp.read_text() == made_from:
        return results
    for command in commands_of(entry):
        call([ROOT / "scripts" / shlex.split(command)[0], *shlex.split(command)[1:], *(["--force"] if command.startswith("import") else [])],
             folder)
    for before in RUN_BEFORE.findall(text_of(name)):
        call([ROOT / "build/release/adfric", "run", "--quiet", "--force", INPUTS / f"{before}.nml"], folder, (0, 1))
    print(f"gallery: {name}", flush=True)
    command = "fit" if FIT.search(text_of(name)) else "run"
    call([ROOT / "build/release/adfric", command, "--quiet", "--force", "--output", results, INPUTS / f"{name}.nml"], folder, (0, 1))
    stamp.write_text(made_from)
    return results


def call(words, folder, allowed=(0,)):
    """Run a command."""
    done = subprocess.run([str(word) for word in words], cwd=folder, capture_output=True, text=True)
    if done.returncode not in allowed:
        print(f"gallery: {' '.join(map(str, words))}: {done.stdout}{done.stderr}", file=sys.stderr)
        sys.exit(3)


def draw(entry):
    """Draw the figure of an entry; the file as scripts/plot writes it."""
    results = [run(entry, name) for name in entry.inputs]
    drawn = WORK / entry.name / f"figure_{digest_of(entry.options)}.png"
    call([sys.executable, ROOT / "scripts/plot.py", *results, *shlex.split(entry.options), "--output", drawn], WORK / entry.name)
    return Image.open(drawn).convert("RGB")


def save(image, path, made_from):
    """Save a figure in a small file that says from what it was made."""
    notes = PngImagePlugin.PngInfo()
    notes.add_text(KEY, made_from)
    data = io.BytesIO()
    image.quantize(COLOURS, dither=Image.Dither.NONE).save(data, "PNG", optimize=True, pnginfo=notes)
    path.write_bytes(data.getvalue())


def narrowed(image, width):
    """A figure of this width, if it is wider."""
    if image.width <= width:
        return image
    return image.resize((width, round(image.height * width / image.width)), Image.Resampling.LANCZOS)


def draw_overview():
    """The columns of the overview side by side, each in the middle of the height."""
    columns = [[narrowed(draw(entry), width) for entry in entries] for width, entries in OVERVIEW]
    heights = [sum(image.height for image in column) for column in columns]
    overview = Image.new("RGB", (sum(width for width, _ in OVERVIEW), max(heights)), "white")
    left = 0
    for (width, _), column, height in zip(OVERVIEW, columns, heights):
        top = (max(heights) - height) // 2
        for image in column:
            overview.paste(image, (left + (width - image.width) // 2, top))
            top += image.height
        left += width
    return overview


def page():
    """The text of docs/gallery.md."""
    lines = ["<!-- written by scripts/gallery -->", "", "# Gallery", "",
             "Every input of `inputs/` with its figure, as `scripts/run inputs/NAME.nml` draws it, or `scripts/plot` where it stands",
             "below. The texts are those of the inputs. `scripts/gallery` makes this page and draws the figures, of which",
             "the repository has six. The site (`scripts/site`) has all.", ""]
    for area, entries in AREAS.items():
        lines += [f"## {area}", ""]
        for entry in entries:
            links = ", ".join(f"[`{name}.nml`](../inputs/{name}.nml)" for name in entry.inputs)
            lines += [f"### {title_of(entry.name)}", "", *wrapped(f"{links}: {plain(head_of(entry.name))}"), "",
                      f"![{title_of(entry.name)}](gallery/{entry.name}.png)", ""]
            commands = [f"scripts/{command}" for command in commands_of(entry)]
            commands += [f"build/release/adfric run inputs/{before}.nml" for name in entry.inputs for before in RUN_BEFORE.findall(text_of(name))]
            commands += [f"scripts/run inputs/{name}.nml" for name in entry.inputs]
            if len(entry.inputs) > 1 or entry.options:
                command = " ".join(["scripts/plot", *(output_of(name) for name in entry.inputs), entry.options]).strip()
                commands.append(command if len(command) <= LONGEST_LINE else command.replace(" --y", " \\\n  --y"))
            lines += ["```sh", *commands, "```", ""]
    return "\n".join(lines)


def wrapped(text):
    """The lines of a paragraph, none of which begins as an item of a list does."""
    marked = re.sub(r" (?=(?:[-+*#>|=]|\d+[.)])(?: |$))", KEPT_SPACE, text)
    return [line.replace(KEPT_SPACE, " ") for line in textwrap.wrap(marked, LONGEST_LINE, break_long_words=False, break_on_hyphens=False)]


def plain(text):
    """A text whose asterisks are no emphasis."""
    return text.replace("*", r"\*")


def output_of(name):
    """The results file of an input."""
    return re.search(r"output\s*=\s*'([^']*)'", text_of(name))[1]


def faults():
    """What is missing, out of date or superfluous; a figure that is not kept may be so."""
    shown = [name for entry in all_entries() for name in entry.inputs]
    there = {path.stem for path in INPUTS.glob("*.nml")}
    yield from (f"inputs/{name}.nml is not shown" for name in sorted(there - set(shown)))
    yield from (f"inputs/{name}.nml is shown, but does not exist" for name in sorted(set(shown) - there))
    if not set(shown) <= there:
        return
    figures = {entry.figure: digest_of_entry(entry) for entry in all_entries()} | {OVERVIEW_FILE: digest_of_overview()}
    for path, made_from in figures.items():
        if path.stem in KEPT and digest_in(path) != made_from:
            yield f"docs/gallery/{path.name} is {'out of date' if path.exists() else 'missing'}"
    yield from (f"docs/gallery/{path.name} is superfluous" for path in sorted(set(FIGURES.glob("*")) - set(figures)))
    if not PAGE.is_file() or PAGE.read_text() != page():
        yield f"docs/gallery.md is {'out of date' if PAGE.exists() else 'missing'}"


def make():
    """Make what is not up to date."""
    os.environ["MPLBACKEND"] = "Agg"
    FIGURES.mkdir(exist_ok=True)
    for entry in all_entries():
        if digest_in(entry.figure) != digest_of_entry(entry):
            save(narrowed(draw(entry), WIDTH), entry.figure, digest_of_entry(entry))
    if digest_in(OVERVIEW_FILE) != digest_of_overview():
        save(draw_overview(), OVERVIEW_FILE, digest_of_overview())
    kept = {entry.figure for entry in all_entries()} | {OVERVIEW_FILE}
    for path in set(FIGURES.glob("*")) - kept:
        path.unlink()
    PAGE.write_text(page())


def main(arguments):
    """Make or check the gallery; the exit status."""
    parser = argparse.ArgumentParser(prog="scripts/gallery", description="Make docs/gallery.md: every input with its figure.")
    parser.add_argument("--check", action="store_true", help="say what is not up to date, and make nothing")
    if not parser.parse_args(arguments).check:
        make()
    found = list(faults())
    for fault in found:
        print(f"gallery: {fault}", file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
