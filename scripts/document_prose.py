# SPDX-License-Identifier: GPL-3.0-or-later
"""What a reader stumbles over in a document: long sentences and lines, words with another meaning, and blocks that nobody can run."""

import re

from reference_pages import WRITTEN as REFERENCE

LONGEST_SENTENCE = 25
LARGEST_MEAN = 15
LONGEST_LINE = 120
GLOSSARY = "docs/reference/glossary.md"
# The section of the glossary that names the words.
BAN_LIST = "## Words that are not used"
# Pages that a program writes, and the history of versions; the sources of their words have tests of their own.
WRITTEN = ("CHANGELOG.md", *REFERENCE)
# What the blocks of a document are in.
LANGUAGES = {"sh", "fortran", "python", "cmake", "c", "text", "math", "diff"}
# Letters of names stand two or more together, as in J. C. Hay; a single one, as in "the load P.", ends a sentence.
ABBREVIATIONS = (r"\b(?:[A-Z](?=\.\s[A-Z]\.)|(?<=\b[A-Z]\.\s)[A-Z]|Figs?|Eqs?|Refs?|Sect?|Chap|No|pp?|vol|cf|vs|al|e\.g|i\.e"
                 r"|approx|Int|Eng|Sci|Mater|Res|Phys|Proc|Soc|Lett|Appl|Mech|Rev|Trans)")
SENTENCE_END = re.compile(rf"(?<!\.\.)[.!?][\"')\]*_]*(?=\s|$)")
FENCE = re.compile(r"\s*(```+|~~~+)(\w*)")
ITEM = re.compile(r"^\s*(?:[-*+]|\d+\.)\s+")
LINK = re.compile(r"!?\[((?:[^\[\]]|\[[^\]]*\])*)\](?:\([^()\s]*(?:\([^()]*\))?[^()\s]*\)|\[[^\[\]]+\])")
# Where the links of a label lead.
LABEL = re.compile(r"\[[^\]]+\]:\s*\S+\s*$")
# One link, or picture, that stands alone on its line, and so has nowhere to be broken.
LONE_LINK = re.compile(rf"\s*(?:[-*+]\s+)?{LINK.pattern}[.,:;]?$")
# The volume, year and page of a source belong to no sentence.
SOURCE = re.compile(r"\((?:[^()]|\([^()]*\))*?(?:\((?:1[89]|20)\d\d\)|\b(?:1[89]|20)\d\d\b)(?:[^()]|\([^()]*\))*\)")

# A number that was measured or computed, and what a reader can run or read to have it again.
MEASURED = re.compile(r"(?<![\w.])\d+\.\d+|\d+ %|\d+ (?:ms|s)\b")
SHOWN = re.compile(r"`[^`\n]*(?:tests/|inputs/|bench/|scripts/|adfric |\.nml|\.csv|\.pf|\.py)[^`\n]*`|```|\]\([^)\s]*(?:inputs|tests|bench)/")
# Pages that derive and explain have numbers of other kinds, too: constants, bounds, exponents, equations, sections. There a number is
# measured if it has a unit, or four decimals; and what an algorithm takes stands in its source.
UNITS = (r"%|°C|K|[munµ]?s|[kMG]?Pa|[munµk]?N|[munµk]?m|[munµ]?J|[kMG]B|[munµ]?m/s|N/m|m?J/m\^2")
MEASURED_ELSEWHERE = re.compile(rf"(?<![\w.])\d+(?:\.\d+)?(?:e-?\d+)? (?:{UNITS})(?![\w/*^])|(?<![\w.])\d+\.\d{{4,}}")
SHOWN_ELSEWHERE = re.compile(rf"{SHOWN.pattern}|`[^`\n]*src/[^`\n]*`")


def blocks_of(text):
    """The parts of a document: (kind, number of the first line, lines), of kind `code LANGUAGE`, `indented`, `table`, `math`,
    `heading`, `labels` or `text`."""
    blocks, fence, kind = [], "", ""

    def add(new, number, line, joined):
        if joined and blocks and blocks[-1][0] == new:
            blocks[-1][2].append(line)
        else:
            blocks.append((new, number, [line]))

    for number, line in enumerate(text.splitlines(), 1):
        mark = FENCE.match(line)
        before, kind = kind, ""
        if fence:
            if mark and mark[1].startswith(fence) and not mark[2]:
                fence = ""
            else:
                blocks[-1][2].append(line)
        elif mark:
            fence = mark[1]
            blocks.append((f"code {mark[2]}", number, []))
        elif before == "math":
            kind = "" if line.rstrip().endswith("$$") else "math"
            add("math", number, line, True)
        elif re.match(r"\s*\$\$", line):
            kind = "math" if line.count("$$") == 1 else ""
            blocks.append(("math", number, [line]))
        elif not line.strip() or re.match(r"\s*<!--.*-->\s*$", line):
            continue
        elif re.match(r"\s*\|", line):
            kind = "table"
            add(kind, number, line, before == kind)
        elif LABEL.match(line):
            kind = "labels"
            add(kind, number, line, before == kind)
        elif re.match(r"#{1,6}\s", line):
            blocks.append(("heading", number, [line]))
        elif ITEM.match(line) and not line.startswith("    "):
            kind = "text"
            blocks.append((kind, number, [line]))
        elif line.startswith("    ") and before != "text":
            kind = "indented"
            add(kind, number, line, before == kind)
        else:
            kind = "text"
            add(kind, number, line, before == kind)
    return blocks


def words_of(text):
    """A text as a reader hears it: a link is its words; code, a formula and a number with its unit are one word each."""
    text = re.sub(r"(`+)(?!`).*?(?<!`)\1(?!`)", "code", text)
    text = re.sub(r"\$[^$]+\$", "formula", text)
    text = LINK.sub(r"\1", text)
    text = re.sub(r"<[^<>]+>", "", text)
    return SOURCE.sub("", text).replace("**", "")


def sentences_of(text):
    """The sentences of a text, as lists of words."""
    text = re.sub(rf"{ABBREVIATIONS}\.", lambda found: found[0][:-1], text)
    return [words for part in SENTENCE_END.split(text) if (words := [word for word in part.split() if re.search(r"\w", word)])]


def prose_of(text):
    """The sentences of the paragraphs and lists of a document, with the number of the line where the paragraph begins."""
    for kind, number, lines in blocks_of(text):
        if kind == "text":
            joined = ITEM.sub("", " ".join(line.strip().removeprefix("> ") for line in lines), count=1)
            for words in sentences_of(words_of(joined)):
                yield number, words


def cells_of(text):
    """The sentences of the tables; a link is one word there, since many cells are lists of links."""
    for kind, number, lines in blocks_of(text):
        if kind == "table":
            for place, line in enumerate(lines):
                for cell in re.split(r"(?<!\\)\|", re.sub(r"(`+)(?!`).*?(?<!`)\1(?!`)", "code", line)):
                    for part in re.split(r"[;:]\s", words_of(LINK.sub("link", cell))):
                        for words in sentences_of(part):
                            yield number + place, words


def faults_of_sentences(text):
    """Sentences that are too long, and a page whose sentences are too long on the whole."""
    prose = list(prose_of(text))
    faults = [f"{number}: a sentence of {len(words)} words: {' '.join(words[:6])} ..." for number, words in [*prose, *cells_of(text)]
              if len(words) > LONGEST_SENTENCE]
    if prose and (mean := sum(len(words) for _, words in prose) / len(prose)) > LARGEST_MEAN:
        faults.append(f"1: sentences have {mean:.1f} words on average")
    return faults


def faults_of_lines(text):
    """Lines and rows of tables that are too long, but for links alone on their line, and what a program prints."""
    faults = []
    for kind, number, lines in blocks_of(text):
        if kind != "code text":
            first = number + kind.startswith("code")
            faults += [f"{first + place}: a line of {len(line)} characters" for place, line in enumerate(lines)
                       if len(line) > LONGEST_LINE and not LONE_LINK.match(line)]
    return faults


def faults_of_blocks(text):
    """Blocks that do not say what they are in, and words of explanation among commands."""
    faults = []
    for kind, number, lines in blocks_of(text):
        if kind == "indented":
            faults.append(f"{number}: a block that does not say what it is in")
        elif kind.startswith("code ") and kind[5:] not in LANGUAGES:
            faults.append(f"{number}: a block in '{kind[5:]}'")
        elif kind == "code sh":
            faults += [f"{number + place}: words behind a command" for place, line in enumerate(lines, 1) if re.search(r"\S {3,}[^\s#]", line)]
    return faults


def faults_of_formulas(text):
    """Formulas with a thin space, which the readers of Markdown do not agree about."""
    return [f"{number}: \\, in a formula" for number, line in enumerate(text.splitlines(), 1) if "$" in line and "\\," in line]


def banned_words(glossary):
    """The words of the ban list: each with what stands instead, and phrases in which the word has its other, usual meaning.

    A row without a word has further phrases of the word above."""
    rows = re.search(rf"^{BAN_LIST}\n.*?^\| not .*?\n\|[ -|]+\n(.*?)(?:\n\n|\Z)", glossary, re.MULTILINE | re.DOTALL)
    banned = {}
    for row in rows[1].splitlines() if rows else ():
        word, instead, usual = (cell.strip() for cell in row.strip().strip("|").split("|"))
        phrases = [phrase.strip() for phrase in usual.split(",") if phrase.strip()]
        if word:
            last = word.strip("*")
            banned[last] = (instead, phrases)
        else:
            banned[last][1].extend(phrases)
    return banned


def faults_of_words(text, banned):
    """Words of the ban list, in prose, headings and tables."""
    faults, is_list = [], False
    for kind, number, lines in blocks_of(text):
        if kind == "heading":
            is_list = lines[0] == BAN_LIST
        if is_list or kind not in ("text", "table", "heading"):
            continue
        # a phrase may go on in the next line
        joined = "\n".join(re.sub(r"\$[^$]+\$|`[^`]*`", "code", line) for line in lines).lower()
        joined = LINK.sub(r"\1", joined)
        for word, (instead, usual) in banned.items():
            for phrase in sorted(usual, key=len, reverse=True):
                joined = re.sub(rf"\b{re.escape(phrase)}\b".replace(r"\ ", r"\s+"), lambda found: "\n" * found[0].count("\n"), joined)
            for found in re.finditer(rf"\b{re.escape(word)}s?\b", joined):
                faults.append(f"{number + joined[:found.start()].count(chr(10))}: '{found[0]}', better {instead}")
    return faults


def faults_of_numbers(text, measured=MEASURED, shown=SHOWN):
    """Sections with measured numbers that name neither a command nor a test, an input or a file from which the numbers come."""
    faults, line = [], 1
    for section in re.split(r"(?m)^(?=## )", text):
        plain = re.sub(r"\$\$.*?\$\$|\$[^$]*\$|```.*?```|`[^`]*`", "", LINK.sub("", section), flags=re.DOTALL)
        if measured.search(plain) and not shown.search(section):
            faults.append(f"{line}: numbers without the command that gives them: {section.partition(chr(10))[0]}")
        line += section.count("\n")
    return faults


def faults_of_prose(text, banned):
    """Everything in a document that a reader stumbles over, by the numbers of the lines."""
    faults = (faults_of_sentences(text) + faults_of_lines(text) + faults_of_blocks(text) + faults_of_formulas(text)
              + faults_of_words(text, banned))
    return sorted(faults, key=lambda fault: int(fault.partition(":")[0]))
