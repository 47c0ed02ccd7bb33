# SPDX-License-Identifier: GPL-3.0-or-later
"""Write the pages of docs/reference that repeat what the program and its sources say: scripts/reference_pages.py [--check] [PROGRAM].

--check compares the pages and writes nothing. Exit status: 0, 1 if a page is out of date, 2 for a bad command line.
"""

import ast
import re
import subprocess
import sys
import textwrap
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
FOLDER = "docs/reference"
# characters of a line, at most
WIDTH = 120
# groups, names with their units, and their words
GROUP = re.compile(r"&(\w+)$")
VARIABLE = re.compile(r"  (\w+)(?: \[([^]]+)\])?(?: +(\S.*))?$")
# what stands behind the variables
RESULTS = "Results, where they have a meaning"
WORDS = re.compile(r" {10,}(\S.*)$")
# a state of a point or of a fit, and what it means
STATE = re.compile(r"    (\w+) {2,}(\S.*)$")
FORTRAN_MODULES = {"adfric_api": "api/api.f90", "adfric_contact_sphere": "contact/sphere.f90", "adfric_contact_strip": "contact/strip.f90",
                   "adfric_contact_periodic": "contact/periodic.f90"}
PYTHON_FILES = ("cases", "fits", "files", "figures", "surfaces", "measured", "tables", "errors", "contacts")


def cell(text):
    """A text as a cell of a table, or as a paragraph: code stays, and an asterisk is one."""
    parts = re.split(r"(`[^`]*`)", " ".join(text.split()))
    return "".join(part if place % 2 else part.replace("|", "\\|").replace("*", "\\*").replace("<", "\\<") for place, part in enumerate(parts))


def table(head, rows):
    """The lines of a table, or of a list where a row is too long; nothing without rows."""
    lines = [f"| {' | '.join(row)} |" for row in (head, ["---"] * len(head), *rows)]
    if max(map(len, lines)) > WIDTH:
        return items([(f"{head[0]} {row[0]}" if head[0] in ("returns", "raises") else row[0], *row[1:]) for row in rows])
    return [*lines, ""] if rows else []


def items(rows):
    """The lines of a list: the last cell of a row behind the others."""
    return [*(f"- {', '.join(filter(None, row[:-1]))}: {row[-1]}" for row in rows), ""]


def with_units(variables):
    """Variables as rows: a name with its unit, and what it means."""
    return [(f"`{name}` [{unit}]" if unit else f"`{name}`", meaning_of(meaning)) for name, unit, meaning in variables]


def in_lines(text):
    """A page whose paragraphs and items are wrapped; blocks, tables and headings stay."""
    lines, is_block = [], False
    for line in text.splitlines():
        is_fence = line.startswith("```")
        is_block = is_block != is_fence
        if is_block or is_fence or len(line) <= WIDTH or line.startswith(("|", "#")):
            lines.append(line)
        else:
            lines += textwrap.wrap(line, WIDTH, subsequent_indent="  " if line.startswith("- ") else "", break_long_words=False,
                                   break_on_hyphens=False)
    return "\n".join(lines) + "\n"


def block(kind, text):
    """The lines of a block."""
    return [f"```{kind}", *text.rstrip().splitlines(), "```", ""]


def read_variables(text):
    """Groups and their variables: name, unit, and lines of what it means and of its words."""
    groups = []
    for line in text[text.index("\nVariables\n"):].splitlines()[2:]:
        if found := GROUP.match(line):
            groups.append((f"&{found[1]}", []))
        elif line == RESULTS:
            groups.append(("Results", []))
        elif found := WORDS.match(line):
            groups[-1][1][-1][2].append(found[1])
        elif found := VARIABLE.match(line):
            groups[-1][1].append((found[1], found[2] or "", [found[3]] if found[3] else []))
    return groups


def meaning_of(meaning):
    """What a variable means, and then its words."""
    # choices follow what the variable means
    says, choices = ([], meaning) if meaning[0].startswith("'") else (meaning[:1], meaning[1:])
    words = ": ".join(part for part in (*says, " ".join(choices)) if part)
    return re.sub(r"('[a-z0-9_]+')", r"`\1`", cell(words))


def variables_page(help_of):
    """Variables of scenes."""
    lines = ["Every variable of [the language of scenes](language.md), as `adfric help scenes` prints it. `adfric help NAME` says",
             "what is allowed, and what each solver takes where nothing is given. [Results](results.md) have a page of their own.", ""]
    for group, variables in read_variables(help_of("scenes")):
        if group != "Results":
            lines += [f"## {group}", "", *items(with_units(variables))]
    return lines


def results_page(help_of):
    """Results of scenes, with their units."""
    found = dict(read_variables(help_of("scenes")))["Results"]
    return ["What a results file has beside the swept variables: those of these results that have a meaning in its scene.",
            "Where two units stand, one is for a body, the other for one per length of it, or per area of the surface.",
            "In the file each result has its unit as an attribute. [The solvers](solvers.md) say which of them give it.", "",
            "Every run has `status`, `doubt` and `error_estimate` beside them: [what they mean](status.md).", "",
            *items(with_units(found))]


def states_of(text, name):
    """The states of a status, with their numbers and meanings, as `adfric help` prints them."""
    entry = text[text.index(f"  {name} "):]
    numbers = dict(re.findall(r"(\w+)=(-?\d+)", re.sub(r"(-?\d+) (\w+)", r"\2=\1", entry)))
    return [(numbers.get(word, ""), f"`{word}`", cell(meaning)) for word, meaning in re.findall(STATE.pattern, entry, re.MULTILINE) if word in numbers]


def status_page(help_of):
    """What has become of points, of fits, and of the program."""
    usage = help_of("")
    exits = re.search(r"Exit status: (.*?)\nAny other is a failure", usage, re.DOTALL)[1]
    rows = re.findall(r"(128 \+ N|\b[0-3]) ((?:(?!, [0-3] |,\n[0-3] |,\n128).)*)", exits, re.DOTALL)
    return ["A run says four things of itself: the exit status of the command, and of each point its `status`, its `doubt`",
            "and its `error_estimate`.", "",
            "## Exit status of the command", "", *table(("exit status", "meaning"), [(number, cell(text.rstrip(","))) for number, text in rows]),
            "## Status of a point", "", *table(("number", "`status`", "meaning"), states_of(help_of("status"), "status")),
            "## Doubt of a point", "", *table(("number", "`doubt`", "meaning"), states_of(help_of("doubt"), "doubt")),
            "The number -1 is a point without a value. [Where theories end](doubts.md) has the reasons and the errors.", "",
            "## Error of a point", "",
            "`error_estimate` [-] is the relative error of the main result, as the solver estimates it. `relative_tolerance` of",
            "`&numerics` asks for less. [Speed against error](../validation/accuracy.md) compares estimates with true errors.", "",
            "## Status of a fit", "", *table(("number", "`status`", "meaning"), fit_states()),
            "A value that is not there is NaN; a state that is not there is -1."]


def fit_states():
    """The states of a fit, as the comments of its source say them."""
    text = (ROOT / "src/fit/solution.f90").read_text()
    words = re.search(r"fit_status_meanings = '(.*)'", text)[1].split()
    return [(number, f"`{words[int(number)]}`", cell(meaning)) for meaning, number in re.findall(r"!> (.*)\n.* :: fit_\w+ = (\d)$", text, re.MULTILINE)]


def command_page(help_of):
    """The command, in its own words."""
    usage, models = help_of("").split("\nModels\n")
    outputs = help_of("outputs")
    fits = help_of("fit").split("\nInputs of adfric fit", 1)[1]
    return ["What `adfric help` and its topics print. [A first run](../guide/first_run.md) shows the commands at work.", "",
            "## Commands: `adfric help`", "", *block("text", usage),
            "## The form of an input: `adfric help input`", "", *block("text", help_of("input")),
            "## Groups and who has them: `adfric help groups`", "", *block("text", help_of("groups")),
            "## Tables of numbers: `adfric help tables`", "", *block("text", help_of("tables")),
            "## What a results file has: `adfric help outputs`", "", *block("text", outputs[:outputs.index("\nmodel = ")]),
            "## Groups of a fit: `adfric help fit`", "", *block("text", "Inputs of adfric fit" + fits),
            "## Solvers", "", *block("text", "Models\n" + models)]


def solvers_page(help_of):
    """Variables and results of each solver by its own names."""
    names = re.findall(r"^  (\w+) ", help_of("").split("\nModels\n")[1], re.MULTILINE)
    lines = ["A scene names no solver: the program finds it. These are the solvers by their own names, as `adfric help NAME` prints",
             "them: what each takes, what is allowed, the default, and what it gives. An input that names one in `&job model`",
             "uses these names.", ""]
    for name in names:
        lines += [f"## {name}", "", *block("text", help_of(name))]
    return lines


def c_page(_):
    """The C header: what stands before each declaration, and the declaration."""
    text = (ROOT / "include/adfric.h").read_text()
    head = re.search(r"/\* adfric for C and C\+\+.*?\n\n(.*?)\*/", text, re.DOTALL)[1]
    lines = ["What `include/adfric.h` declares. [The library](library.md) shows it at work.", "", "## All calls", ""]
    for part in head.split("\n\n"):
        lines += block("text", part) if "--->" in part else [cell(part), ""]
    for found in re.finditer(r"^/\* ---- (?P<section>.*?) ----(?P<intro>.*?)\*/|^/\*\* (?P<says>.*?)\*/\n(?P<code>(?:enum|typedef struct) \{.*?^\}.*?;|.*?;)",
                             text, re.DOTALL | re.MULTILINE):
        lines += c_entry(**found.groupdict())
    return lines


def c_entry(section, intro, says, code):
    """The lines of a section of the header, or of a declaration."""
    if section:
        return [f"## {section}", "", *([cell(intro), ""] if intro.strip() else [])]
    says, *parameters = re.split(r"@param |@return 0, or ", says)
    pattern = r"\} (\w+);$" if code.startswith("typedef struct") else r"\(\*(\w+)\)|(\w+)\(|(\w+);"
    name = re.search(pattern, code) if not code.startswith("enum") else None
    title = f"`{next(filter(None, name.groups()))}`" if name else cell(says.split(".")[0])
    rows = [re.match(r"([\w, ]+?)  +(.*)|(.*)", parameter, re.DOTALL) for parameter in parameters]
    return [f"### {title}", "", cell(says), "", *block("c", code),
            *table(("argument", "meaning"), [(f"`{row[1]}`", cell(row[2])) if row[1] else ("returns", "0, or " + cell(row[3])) for row in rows])]


def docstring_lines(text):
    """A docstring in Markdown: paragraphs, parameters as a table, examples and lists as blocks."""
    lines, rows, head = [], [], ""
    for part in re.split(r"\n\s*\n", text or ""):
        title = re.match(r"(Parameters|Returns|Raises|Examples)\n-+\n", part)
        if title and title[1] == "Examples":
            lines += block("text", part[title.end():])
        elif title:
            head, part = title[1], part[title.end():]
            rows = []
            for line in part.splitlines():
                if not line.startswith(" "):
                    name, _, kind = line.partition(" : ")
                    rows.append([f"`{name}`" if head == "Parameters" else cell(name), cell(kind), ""])
                else:
                    rows[-1][2] += " " + line.strip()
            lines += table(("argument", "is", "meaning") if head == "Parameters" else (head.lower(), "", "meaning"),
                           [(name, kind, cell(says)) for name, kind, says in rows])
        elif part.startswith((">>>", "    ")) or re.search(r"^\w[\w, ]* {2,}\S", part, re.MULTILINE):
            lines += block("text", part)
        else:
            lines += [cell(part), ""]
    return lines


def python_page(_):
    """The functions and classes of the package, by their docstrings."""
    package = ROOT / "python/adfric"
    public = next(ast.literal_eval(node.value) for node in ast.parse((package / "__init__.py").read_text()).body
                  if isinstance(node, ast.Assign) and node.targets[0].id == "__all__")
    lines = ["What the docstrings of the package say. [Python](python.md) shows it at work.", ""]
    for file in PYTHON_FILES:
        where = "adfric.contacts" if file == "contacts" else "adfric"
        for node in ast.parse((package / f"{file}.py").read_text()).body:
            is_shown = isinstance(node, (ast.FunctionDef, ast.ClassDef)) and (
                node.name in (*public, "open_file") or where == "adfric.contacts" and node.name.startswith(("sphere_", "strip_")))
            if not is_shown:
                continue
            name = f"{where}.{'open' if node.name == 'open_file' else node.name}"
            lines += [f"## `{name}`", ""]
            if isinstance(node, ast.FunctionDef):
                lines += block("text", f"{name}({ast.unparse(node.args)})")
            lines += docstring_lines(ast.get_docstring(node))
            for method in node.body if isinstance(node, ast.ClassDef) else ():
                if isinstance(method, ast.FunctionDef) and not method.name.startswith("_") and ast.get_docstring(method):
                    lines += [f"### `{name.rpartition('.')[2]}.{method.name}`", "",
                              *block("text", f"{method.name}({ast.unparse(method.args)})"), *docstring_lines(ast.get_docstring(method))]
    return lines


def comments_of(code):
    """Pairs of a comment `!>` and the statement below it, of what stands together."""
    joined = re.sub(r"&\n\s*&? *", "", code)
    return [(cell(re.sub(r"\n\s*!> ?", " ", "\n" + comment)), statement.strip())
            for comment, statement in re.findall(r"((?:^ *!>.*\n)+) *([^\s!].*)$", joined, re.MULTILINE)]


def fortran_procedure(text, name):
    """What a procedure does, its head, and its arguments: name, declaration, meaning."""
    found = re.search(rf"((?:^ *!>.*\n)*)^ *((?:[\w()]+ )*(?:subroutine|function) {name}\((?:.*&\n)*.*\).*)\n((?:.*\n)*?) *end (?:subroutine|function) {name}$",
                      text, re.MULTILINE)
    says = cell(re.sub(r"^ *!> ?", "", found[1], flags=re.MULTILINE))
    head = " ".join(re.sub(r"&\s*&?", "", found[2]).split())
    rows = []
    for comment, statement in comments_of(found[3]):
        kind, _, names = statement.partition(" :: ")
        if "intent(" in kind or kind.startswith("procedure") or re.fullmatch(r".*result\((\w+)\)", head) and names.split("(")[0] in head:
            rows.append((names, kind, comment))
    return says, head, rows


def fortran_page(_):
    """The public modules and their procedures, by the comments of their sources."""
    sources = {path: path.read_text() for path in sorted((ROOT / "src").rglob("*.f90"))}
    lines = ["What the comments of the public modules say. [The library](library.md) shows them at work.", ""]
    for module, file in FORTRAN_MODULES.items():
        text = sources[ROOT / "src" / file]
        head = re.search(rf"((?:^!>.*\n)+)module {module}$", text, re.MULTILINE)[1]
        lines += [f"## `{module}`", ""]
        for part in re.sub(r"^!> ?", "", head, flags=re.MULTILINE).split("\n\n"):
            lines += block("text", part) if "--->" in part else [cell(part), ""]
        public = [name.strip() for found in re.findall(r"^ *public :: (.*)$", text, re.MULTILINE) for name in found.split(",")]
        for name in public:
            where = next((source for source in (text, *sources.values())
                          if re.search(rf"^ *(?:[\w()]+ )*(?:subroutine|function) {name}\(", source, re.MULTILINE)), None)
            if where:
                lines += shown_procedure(f"`{name}`", [fortran_procedure(where, name)])
        for bound, specifics in bindings_of(text):
            lines += shown_procedure(f"`simulation_t%{bound}`", [fortran_procedure(text, name) for name in specifics])
    return lines


def bindings_of(text):
    """Public bindings of a type, and the procedures behind them."""
    for line in re.findall(r"^ *procedure :: (.*)$", text, re.MULTILINE):
        name, _, target = line.partition(" => ")
        yield name, [target or name]
    for name, targets in re.findall(r"^ *generic :: (\w+) => (.*)$", text, re.MULTILINE):
        yield name, targets.split(", ")


def shown_procedure(title, found):
    """The lines of a procedure, or of several that have one name."""
    lines = [f"### {title}", "", *dict.fromkeys(says for says, _, _ in found), "", *block("text", "\n".join(head for _, head, _ in found))]
    rows = {}
    for _, _, arguments in found:
        for names, kind, comment in arguments:
            kinds = rows.setdefault((names.split("(")[0], comment), [])
            kinds += [f"`{kind} :: {names}`"] if f"`{kind} :: {names}`" not in kinds else []
    return lines + table(("argument", "declaration", "meaning"), [(f"`{name}`", ", ".join(kinds), comment) for (name, comment), kinds in rows.items()])


PAGES = {"variables": ("Variables of scenes", variables_page), "results": ("Results of scenes", results_page),
         "status": ("Status, doubt and error", status_page), "command": ("The command", command_page),
         "solvers": ("Solvers by their own names", solvers_page), "c_functions": ("Functions of C", c_page),
         "python_functions": ("Functions of Python", python_page), "fortran_procedures": ("Procedures of Fortran", fortran_page)}
WRITTEN = tuple(f"{FOLDER}/{name}.md" for name in PAGES)


def pages_of(help_of):
    """The text of each page, by its file, from what the program prints for a topic."""
    texts = {}
    for file, (title, lines_of) in zip(WRITTEN, PAGES.values()):
        text = "\n".join([f"# {title}", "", *lines_of(help_of)])
        texts[file] = in_lines(text.rstrip() + "\n\n`scripts/reference_pages.py` writes this page.\n")
    return texts


def main(arguments):
    """Write the pages, or compare them."""
    check = "--check" in arguments
    rest = [word for word in arguments if word != "--check"]
    if len(rest) > 1 or any(word.startswith("-") for word in rest):
        print(__doc__.strip(), file=sys.stderr)
        return 2
    program = rest[0] if rest else ROOT / "build/release/adfric"

    def help_of(topic):
        return subprocess.run([program, "help", *topic.split()], check=True, capture_output=True, text=True).stdout

    outdated = 0
    for file, text in pages_of(help_of).items():
        path = ROOT / file
        if not check:
            path.write_text(text)
        elif not path.exists() or path.read_text() != text:
            print(f"{file} is out of date: scripts/reference_pages.py", file=sys.stderr)
            outdated = 1
    return outdated


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
