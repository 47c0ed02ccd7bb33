# SPDX-License-Identifier: GPL-3.0-or-later
"""Write docs/reference/variables.md, the variables of scenes as the program prints them: scripts/variables_page.py [--check] [PROGRAM].

--check compares the page and writes nothing. Exit status: 0, 1 if the page is out of date, 2 for a bad command line.
"""

import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PAGE = ROOT / "docs/reference/variables.md"
HEAD = """# Variables of scenes

Every variable of [the language of scenes](language.md), as `adfric help scenes` prints it. `adfric help NAME` says
what is allowed, and what each solver takes where nothing is given. `scripts/variables_page.py` writes this page.
"""
# groups, names with their units, and their words
GROUP = re.compile(r"&(\w+)$")
VARIABLE = re.compile(r"  (\w+)(?: \[([^]]+)\])?(?: +(\S.*))?$")
# what stands behind the variables
RESULTS = "Results, where they have a meaning"
WORDS = re.compile(r" {10,}(\S.*)$")


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


def page_of(text):
    """The page, from what the program prints."""
    lines = [HEAD]
    for group, variables in read_variables(text):
        lines += [f"## {group}", "", "| variable | unit | meaning |", "| --- | --- | --- |"]
        if group == "Results":
            lines[-2:] = ["A file has those that have a meaning in its scene, with their units.", "", "| result | meaning |", "| --- | --- |"]
        for name, unit, meaning in variables:
            # choices follow what the variable means
            says, choices = ([], meaning) if meaning[0].startswith("'") else (meaning[:1], meaning[1:])
            words = ": ".join(part for part in (*says, " ".join(choices)) if part).replace("|", "\\|").replace("*", "\\*")
            shown = re.sub(r"('[a-z0-9_]+')", r"`\1`", words)
            lines.append(f"| `{name}` | {shown} |" if group == "Results" else f"| `{name}` | {unit} | {shown} |")
        lines.append("")
    return "\n".join(lines)


def main(arguments):
    """Write the page, or compare it."""
    check = "--check" in arguments
    rest = [word for word in arguments if word != "--check"]
    if len(rest) > 1 or any(word.startswith("-") for word in rest):
        print(__doc__.strip(), file=sys.stderr)
        return 2
    program = rest[0] if rest else ROOT / "build/release/adfric"
    page = page_of(subprocess.run([program, "help", "scenes"], check=True, capture_output=True, text=True).stdout)
    if not check:
        PAGE.write_text(page)
    elif not PAGE.exists() or PAGE.read_text() != page:
        print("docs/reference/variables.md is out of date: scripts/variables_page.py", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
