# SPDX-License-Identifier: GPL-3.0-or-later
"""The areas of the site, each with the titles of its pages and their files."""

from document_links import documents_of

# The first page that FORD makes.
FORTRAN = "fortran/index.html"
AREAS = {
    "Guide": {
        "Friction of a tip": "docs/guide/friction_of_a_tip.md",
        "Pull-off of a rough surface": "docs/guide/pull_off_of_a_rough_surface.md",
        "Rubber on a road": "docs/guide/rubber_on_a_road.md",
        "Fretting": "docs/guide/fretting.md",
        "Fit of a force map": "docs/guide/fit_of_a_force_map.md",
        "A scan on a cluster": "docs/guide/a_scan_on_a_cluster.md",
    },
    "Use": {
        "Overview": "README.md",
        "Installing": "docs/install.md",
        "A first run": "docs/first_run.md",
        "Tutorial": "docs/tutorial.md",
        "Tutorial: a force map": "docs/force_map.md",
        "Gallery": "docs/gallery.md",
        "The language of scenes": "docs/language.md",
        "Columns or half-space": "docs/columns.md",
        "The input": "docs/namelist.md",
        "Variables of scenes": "docs/variables.md",
        "Tables of text": "docs/tables.md",
        "The results file": "docs/file_format.md",
        "Measured surfaces and force curves": "docs/import.md",
        "Fits of measured data": "docs/fit.md",
        "Big scans": "docs/clusters.md",
    },
    "Models": {
        "A wavy surface on a foundation": "docs/wavy.md",
        "Rough lines and real materials": "docs/profiles.md",
        "A sphere": "docs/sphere.md",
        "Indenters of any shape": "docs/indenter.md",
        "The half-space": "docs/halfspace.md",
        "Periodic surfaces": "docs/periodic.md",
    },
    "Library": {
        "Fortran, C and C++": "docs/library.md",
        "Python": "docs/python.md",
        "Modules of Fortran": FORTRAN,
    },
    "Accuracy": {
        "Speed against error": "docs/accuracy.md",
        "What simple points save": "docs/scenes.md",
        "How it scales": "docs/scaling.md",
        "Hard cases": "docs/hard_cases.md",
        "Where theories end": "docs/doubts.md",
        "What it cannot do": "docs/limits.md",
        "Benchmarks": "bench/README.md",
    },
    "Project": {
        "Glossary": "docs/glossary.md",
        "Contributing": "CONTRIBUTING.md",
        "Changes": "CHANGELOG.md",
    },
}


def missing_in_areas(root):
    """Documents without an area, and pages of areas without a document."""
    listed = [file for pages in AREAS.values() for file in pages.values()]
    there = {path.relative_to(root).as_posix() for path in documents_of(root)}
    return ([f"{file} stands in no area of scripts/site_areas.py" for file in sorted(there - set(listed))]
            + [f"there is no {file}" for file in listed if file not in there | {FORTRAN}]
            + [f"{file} stands in two places" for file in sorted({file for file in listed if listed.count(file) > 1})])
