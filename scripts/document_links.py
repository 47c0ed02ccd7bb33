# SPDX-License-Identifier: GPL-3.0-or-later
"""Links of the documents: where they lead, and whether that is there."""

import re
from pathlib import Path

# Documents that belong to the site, as patterns of files.
DOCUMENTS = ("README.md", "CHANGELOG.md", "CONTRIBUTING.md", "docs/*.md", "docs/*/*.md", "bench/README.md")
INLINE = re.compile(r"!?\[(?:[^\[\]]|\[[^\]]*\])*\]\(\s*<?([^)\s>]+)>?(?:\s+\"[^\"]*\")?\s*\)")
DEFINED = re.compile(r"^\[[^\]]+\]:\s*<?(\S+?)>?\s*$", re.MULTILINE)
# `[words][label]`, where a line `[label]: target` of the page says where it leads; `[label]` alone is one, too, if there is such a line
REFERRED = re.compile(r"!?\[((?:[^\[\]]|\[[^\]]*\])*)\](?:\[([^\[\]]*)\])?(?![(:])")
LABEL = re.compile(r"^\[([^\]]+)\]:\s*\S+\s*$", re.MULTILINE)
HTML = re.compile(r"<(?:a|img)\s[^>]*?\b(?:href|src)=\"([^\"]+)\"")
# Files of the project that a text names.
NAMED = re.compile(r"(?<![\w/.])(?:docs(?:/\w+)+\.md|(?:src|tests|scripts|bench|drivers)(?:/\w+)+\.(?:f90(?:\.in)?|pf|py|c|md|csv|nml))\b")
HEADING = re.compile(r"^#{1,6}\s+(.*?)\s*#*$")


def documents_of(root):
    """All documents below a folder."""
    return [path for pattern in DOCUMENTS for path in sorted(root.glob(pattern))]


def lines_of(path):
    """The lines of a document with their numbers, without those of code."""
    fence = ""
    for number, line in enumerate(path.read_text().splitlines(), 1):
        mark = re.match(r" {0,3}(```+|~~~+)", line)
        if fence:
            if mark and mark[1].startswith(fence):
                fence = ""
        elif mark:
            fence = mark[1]
        elif not line.startswith("    "):
            yield number, line


def paragraphs_of(path):
    """The lines of a document with their numbers, in stretches without an empty line: a link may go on in the next line."""
    paragraph = []
    for number, line in lines_of(path):
        if paragraph and (not line.strip() or number != paragraph[-1][0] + 1):
            yield paragraph
            paragraph = []
        if line.strip():
            paragraph.append((number, line))
    if paragraph:
        yield paragraph


def words_of_paragraphs(path):
    """The paragraphs of a document, each with its text without what stands between backticks."""
    for paragraph in paragraphs_of(path):
        text = "\n".join(line for _, line in paragraph)
        # line breaks stay, so that lines can be counted
        yield paragraph, re.sub(r"(`+)(?!`).*?(?<!`)\1(?!`)", lambda span: "`" + "\n" * span[0].count("\n"), text, flags=re.DOTALL)


def links_of(path):
    """The links of a document with the numbers of the lines where they begin; what stands between backticks is no link."""
    for paragraph, words in words_of_paragraphs(path):
        for pattern in (INLINE, DEFINED, HTML):
            for match in pattern.finditer(words):
                yield paragraph[words.count("\n", 0, match.start())][0], match[1]


def faults_of_labels(path):
    """Labels of links that no line defines, are defined twice or lead from nowhere, with the numbers of their lines."""
    used, defined = [], []
    for paragraph, words in words_of_paragraphs(path):
        for pattern, found in ((REFERRED, used), (LABEL, defined)):
            for match in pattern.finditer(words):
                has_label = pattern is REFERRED and match[2] is not None
                label = " ".join(match[2 if has_label else 1].lower().split())
                found.append((paragraph[words.count("\n", 0, match.start())][0], label, has_label))
    labels, names = [label for _, label, _ in defined], {label for _, label, _ in used}
    faults = [(number, f"[{label}] is defined nowhere") for number, label, has_label in used if has_label and label not in labels]
    faults += [(number, f"[{label}] leads from nowhere") for number, label, _ in defined if label not in names]
    faults += [(number, f"[{label}] is defined twice") for place, (number, label, _) in enumerate(defined) if label in labels[:place]]
    return sorted(faults)


def is_inside(link):
    """Does a link stay in the documents?"""
    return not re.match(r"[a-zA-Z][a-zA-Z0-9+.-]*:|//", link)


def anchors_of(path):
    """The names of the headings of a document, as links have them."""
    anchors, counts = set(), {}
    for _, line in lines_of(path):
        anchors.update(re.findall(r"<a\s[^>]*?\b(?:id|name)=\"([^\"]+)\"", line))
        if heading := HEADING.match(line):
            text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading[1])
            name = re.sub(r"[^\w\- ]", "", text.lower()).replace(" ", "-")
            counts[name] = counts.get(name, 0) + 1
            anchors.add(name if counts[name] == 1 else f"{name}-{counts[name] - 1}")
    return anchors


def is_drawn(file, root):
    """Is a file a figure that the gallery or a tutorial draws? Most of them do not stand in the repository."""
    name = file.relative_to(root.resolve())
    if name.parent == Path("docs/gallery"):
        return (root / "inputs" / f"{name.stem}.nml").exists() and name.suffix == ".png"
    return name.parent in (Path("docs/guide/tutorial"), Path("docs/guide/force_map")) and name.suffix == ".png"


def fault_of_link(path, link, root):
    """What is wrong with a link of a document; nothing if it leads somewhere."""
    target, _, anchor = link.partition("#")
    file = (path.parent / target).resolve() if target else path
    if target.startswith("/") or not file.is_relative_to(root.resolve()):
        return f"{link} leads out of the project"
    if not file.exists() and not is_drawn(file, root):
        return f"{link}: there is no {file.relative_to(root.resolve()).as_posix()}"
    if anchor and (file.suffix != ".md" or anchor not in anchors_of(file)):
        return f"{link}: there is no heading #{anchor}"
    return ""


def faults_of(root):
    """Every link inside the documents that leads nowhere, and every document that is named and is not there, as FILE:LINE."""
    faults = []
    for path in documents_of(root):
        place = path.relative_to(root).as_posix()
        faults += [f"{place}:{number}: {fault}" for number, link in links_of(path) if is_inside(link)
                   if (fault := fault_of_link(path, link, root))]
        faults += [f"{place}:{number}: {fault}" for number, fault in faults_of_labels(path)]
        # versions that are gone may name what was there
        if path.name != "CHANGELOG.md":
            faults += [f"{place}:{number}: there is no {name}" for number, line in enumerate(path.read_text().splitlines(), 1)
                       for name in NAMED.findall(line) if not Path(root, name).exists()]
    return faults
