# SPDX-License-Identifier: GPL-3.0-or-later
"""Build the site: python scripts/site_pages.py [--without-figures] [--version NAME] FOLDER.

A figure that has not been drawn ends it, or is a grey point with --without-figures. A version stands in FOLDER/NAME, beside others. Where
the project has an address (ADFRIC_ADDRESS), each page that somebody writes has a link to where it is edited.

The documents keep their places, so that their links hold in the site as they do in the repository. MkDocs makes pages of them; FORD
makes those of the Fortran modules that other programs use, and stands below fortran/.
"""

import argparse
import os
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib
from pathlib import Path

import mkdocs
import yaml

from document_links import documents_of, faults_of, is_drawn, is_inside, links_of
from notebooks import write_notebooks
from site_areas import AREAS, missing_in_areas
from site_versions import BadVersion, add_version, check_name, versions_in

ROOT = Path(__file__).resolve().parents[1]
# The modules that a program of somebody else uses.
PUBLIC_MODULES = ("adfric_api", "adfric_contact_sphere", "adfric_contact_strip", "adfric_contact_periodic")
STYLE = """
.md-grid { max-width: 80rem; }
.md-typeset pre > code { font-size: 0.8em; line-height: 1.4; }
.md-typeset table:not([class]) td, .md-typeset table:not([class]) th { padding: 0.4em 0.7em; vertical-align: top; min-width: 0; }
.md-typeset table:not([class]) th:empty { padding: 0; border: 0; }
.md-typeset img { max-width: 100%; background: white; }
#gallery-filter { width: 24em; max-width: 70%; padding: 0.4em 0.7em; border: 1px solid; border-radius: 0.2em; color: inherit; }
#gallery-count { margin-left: 1em; font-size: 0.8em; }
.md-typeset .notebook { margin-top: 2em; font-size: 0.9em; }
.md-typeset .proofs { margin-top: 2em; padding: 0 1em 0.4em; border: 1px solid; border-radius: 0.2em; font-size: 0.95em; }
.md-typeset .formula { margin: 1em 0; overflow-x: auto; }
.md-typeset math { font-size: 1.1em; font-family: "STIX Two Math", "Latin Modern Math", "Cambria Math", "STIX Math", STIXMath, "DejaVu Math TeX Gyre", math; }
"""
# Light or dark: what the system asks for first, then what the reader clicks.
PALETTE = [
    {"media": "(prefers-color-scheme: light)", "scheme": "default", "primary": "indigo",
     "toggle": {"icon": "material/weather-night", "name": "Dark"}},
    {"media": "(prefers-color-scheme: dark)", "scheme": "slate", "primary": "indigo",
     "toggle": {"icon": "material/weather-sunny", "name": "Light"}},
]
THEME = {"name": "material", "font": False, "palette": PALETTE, "icon": {"logo": "material/ruler"},
         "features": ["navigation.tabs", "navigation.sections", "navigation.top", "navigation.footer", "search.suggest", "search.highlight",
                      "content.code.copy", "content.action.edit", "toc.follow"]}
ADDRESS = re.compile(r"https?://[\w.:-]+/[\w./~-]+")


def grey_point():
    """A picture of one grey point."""
    def part(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    return (b"\x89PNG\r\n\x1a\n" + part(b"IHDR", struct.pack(">IIBBBBB", 1, 1, 8, 0, 0, 0, 0))
            + part(b"IDAT", zlib.compress(b"\0\xcc")) + part(b"IEND", b""))


def copy_documents(folder, has_figures):
    """Copy the documents, and the files of the project that they show or lead to."""
    missing = set()
    for path in documents_of(ROOT):
        copy(path, folder)
        for _, link in links_of(path):
            file = (path.parent / link.partition("#")[0]).resolve()
            if is_inside(link) and file.is_file() and file.suffix != ".md":
                copy(file, folder)
            elif is_inside(link) and not file.exists() and is_drawn(file, ROOT):
                missing.add(file.relative_to(ROOT))
    if missing and has_figures:
        sys.exit("".join(f"site: {name} is not drawn; scripts/gallery and scripts/tutorial draw figures\n" for name in sorted(missing)))
    for name in missing:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(grey_point())


def copy(path, folder):
    """Copy a file of the project to the same place below a folder."""
    to = folder / path.relative_to(ROOT)
    to.parent.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(path, to)


def source_of(module):
    """The file of a module, or of its template."""
    text = re.compile(rf"^module {module}$", re.MULTILINE)
    return next(path for path in sorted((ROOT / "src").rglob("*.f90*")) if text.search(path.read_text()))


def modules_with(module):
    """A module, and those from which it passes names on."""
    text = source_of(module).read_text().replace("&\n", "")
    public = {name.strip() for names in re.findall(r"^ *public :: (.*)$", text, re.MULTILINE) for name in names.split(",")}
    uses = re.findall(r"^ *use (adfric_\w+), only: (.*)$", text, re.MULTILINE)
    return {module} | {other for other, names in uses if public & {name.strip(" &") for name in names.split(",")}}


def write_fortran(folder, work):
    """Write the pages of the public modules."""
    sources = work / "sources"
    sources.mkdir()
    for module in sorted(set().union(*map(modules_with, PUBLIC_MODULES))):
        path = source_of(module)
        shutil.copyfile(path, sources / path.relative_to(ROOT / "src").as_posix().replace("/", "_"))
    settings = {"project": "adfric for Fortran", "summary": "The modules that a program uses", "author": "the adfric authors",
                "src_dir": sources, "output_dir": folder, "display": "public", "sort": "alpha", "preprocess": False,
                "incl_src": False, "search": False, "quiet": True}
    project = work / "fortran.md"
    project.write_text("".join(["---\n", *(f"{key}: {value}\n" for key, value in settings.items()), "---\n\n"
                                "The modules of [the library](../docs/reference/library.html), as the comments of their sources say.\n"]))
    run("ford", str(project))
    keep_inside(folder)


def keep_inside(folder):
    """Have the pages of FORD read Bootstrap from the site, and not from a server; they have no formulas."""
    for name in ("css/bootstrap.min.css", "js/bootstrap.bundle.min.js"):
        shutil.copyfile(Path(mkdocs.__file__).parent / "themes/mkdocs" / name, folder / name)
    for path in folder.rglob("*.html"):
        up = "../" * (len(path.relative_to(folder).parts) - 1)
        text = re.sub(r'<script src="https:[^"]*/MathJax.js.*?</script>', "", path.read_text(), flags=re.DOTALL)
        text = re.sub(r'"https:[^"]*/((?:css|js)/bootstrap)', rf'"{up}\1', text)
        path.write_text(re.sub(r'\s+integrity="[^"]*" crossorigin="\w+"', "", text))


def edit_links(address):
    """Where the pages of a project at this address are edited; nothing without one. The address itself is not told to the theme: it would
    ask a server about the project whenever a page is read."""
    if not address:
        return {}
    if not ADDRESS.fullmatch(address):
        sys.exit(f"site: ADFRIC_ADDRESS: given '{address}', allowed: an address as https://HOST/OWNER/PROJECT")
    return {"edit_uri_template": address.rstrip("/") + "/edit/main/{path}"}


def write_pages(pages, folder, work, version=None):
    """Write the pages of the documents, below the areas; what is not there yet is left out."""
    nav = [{area: [{title: file} for title, file in files.items() if (pages / file).exists()]} for area, files in AREAS.items()]
    (pages / "style.css").write_text(STYLE)
    shutil.copyfile(ROOT / "scripts/site_gallery.js", pages / "gallery.js")
    settings = work / "mkdocs.yml"
    settings.write_text(yaml.safe_dump({
        "site_name": "adfric", "docs_dir": str(pages), "site_dir": str(folder), "use_directory_urls": False, "nav": nav,
        "theme": THEME,
        "plugins": ["search"], "hooks": [str(ROOT / "scripts/site_hooks.py")], "extra_css": ["style.css"], "extra_javascript": ["gallery.js"],
        "markdown_extensions": [{"codehilite": {"guess_lang": False, "css_class": "highlight"}}, {"toc": {"permalink": False}}],
        "validation": {"omitted_files": "warn", "absolute_links": "warn", "unrecognized_links": "warn", "anchors": "warn"},
        **({"extra": {"version": {"provider": "mike"}}} if version else {}), **edit_links(os.environ.get("ADFRIC_ADDRESS", "")),
    }, sort_keys=False))
    run("mkdocs", "build", "--strict", "--quiet", "--clean", "--config-file", str(settings))


def run(module, *arguments):
    """Run a program of the environment; what it says is shown only if it fails."""
    result = subprocess.run([sys.executable, "-m", module, *arguments], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if result.returncode:
        sys.exit(f"{result.stdout}site: {module} failed")


def main(folder, has_figures, version=None):
    """Build the site in a folder, or one version of it beside others."""
    if version:
        check_name(version)
        versions_in(folder)
    target = folder / version if version else folder
    if faults := faults_of(ROOT) + missing_in_areas(ROOT):
        sys.exit("\n".join(f"site: {fault}" for fault in faults))
    with tempfile.TemporaryDirectory() as name:
        work = Path(name)
        pages = work / "pages"
        copy_documents(pages, has_figures)
        write_notebooks(pages / "docs/guide")
        shutil.copy(ROOT / "docs/guide/tutorial.ipynb", pages / "docs/guide")
        write_fortran(pages / "fortran", work)
        write_pages(pages, target, work, version)
    if version:
        add_version(folder, version)
    print(target / "index.html")


def read_command_line(arguments):
    """What scripts/site asks for."""
    parser = argparse.ArgumentParser(prog="scripts/site_pages.py")
    parser.add_argument("--without-figures", action="store_true")
    parser.add_argument("--version", metavar="NAME")
    parser.add_argument("folder", metavar="FOLDER", type=Path)
    return parser.parse_args(arguments)


if __name__ == "__main__":
    given = read_command_line(sys.argv[1:])
    try:
        main(given.folder.resolve(), not given.without_figures, given.version)
    except BadVersion as problem:
        print(f"site: {problem}", file=sys.stderr)
        sys.exit(2)
