# SPDX-License-Identifier: GPL-3.0-or-later
"""The areas of the site, each with the titles of its pages and their files."""

from document_links import documents_of

# The first page that FORD makes.
FORTRAN = "fortran/index.html"
AREAS = {
    "Guide": {
        "Overview": "README.md",
        "Installing": "docs/guide/install.md",
        "A first run": "docs/guide/first_run.md",
        "Friction of a tip": "docs/guide/friction_of_a_tip.md",
        "Pull-off of a rough surface": "docs/guide/pull_off_of_a_rough_surface.md",
        "Rubber on a road": "docs/guide/rubber_on_a_road.md",
        "Columns or half-space": "docs/guide/columns.md",
        "Fretting": "docs/guide/fretting.md",
        "Soft samples": "docs/guide/soft_samples.md",
        "Ageing of a contact": "docs/guide/ageing_of_a_contact.md",
        "Fit of a force map": "docs/guide/fit_of_a_force_map.md",
        "Tutorial: from a tip to a rough surface": "docs/guide/tutorial.md",
        "Tutorial: a force map": "docs/guide/force_map.md",
        "Measured surfaces and force curves": "docs/guide/import.md",
        "Fits of measured data": "docs/guide/fit.md",
        "A page for a colleague": "docs/guide/report.md",
        "A scan on a cluster": "docs/guide/a_scan_on_a_cluster.md",
        "Big scans": "docs/guide/clusters.md",
        "What it cannot do": "docs/guide/limits.md",
        "Gallery": "docs/gallery.md",
    },
    "Theory": {
        "Columns: the foundation": "docs/theory/columns.md",
        "Columns: strips of a wave": "docs/theory/columns_strips.md",
        "Columns: adhesion": "docs/theory/columns_adhesion.md",
        "Columns: load and pull-off": "docs/theory/columns_load.md",
        "Columns: any shape": "docs/theory/columns_any_shape.md",
        "Columns: material": "docs/theory/columns_material.md",
        "Round contacts": "docs/theory/round_contact.md",
        "Round contacts that adhere": "docs/theory/round_adhesion.md",
        "Round contacts with any law of attraction": "docs/theory/round_attraction.md",
        "Branches and pull-off": "docs/theory/round_branches.md",
        "Adhesion along a path": "docs/theory/round_paths.md",
        "Round contacts in time": "docs/theory/round_time.md",
        "Round contacts in time with adhesion": "docs/theory/round_time_adhesion.md",
        "Ageing of rough contacts": "docs/theory/ageing.md",
        "Friction of round contacts": "docs/theory/round_friction.md",
        "What friction takes from adhesion": "docs/theory/round_peeling.md",
        "Stick-slip": "docs/theory/stick_slip.md",
        "Coulomb friction and histories": "docs/theory/round_history.md",
        "Johnson 1997": "docs/theory/johnson1997.md",
        "The mathematics of fits": "docs/theory/fits.md",
        "Hertz's contacts": "docs/theory/hertz.md",
        "Punches and given loads": "docs/theory/line_contacts.md",
        "Partial slip": "docs/theory/slip.md",
        "A wave on a half-plane": "docs/theory/waves.md",
        "A wave that adheres": "docs/theory/adhesive_wave.md",
        "Lines that slide over rubber": "docs/theory/line_sliding.md",
        "Friction of the interface": "docs/theory/interface.md",
        "Heat of sliding": "docs/theory/heat.md",
        "Sliding with adhesion": "docs/theory/adhesive_sliding.md",
        "Contact of periodic surfaces": "docs/theory/periodic_contact.md",
        "Bodies that end: free boundaries": "docs/theory/free_surfaces.md",
        "Adhesion of periodic surfaces": "docs/theory/periodic_adhesion.md",
        "Laws of attraction on surfaces": "docs/theory/attraction_laws.md",
        "Opening with more work": "docs/theory/surface_opening.md",
        "Laws of attraction on surfaces": "docs/theory/attraction_laws.md",
        "Sliding over rubber": "docs/theory/periodic_sliding.md",
        "Adhesion while sliding": "docs/theory/adhesion_in_sliding.md",
        "Slip and friction of rough surfaces": "docs/theory/periodic_slip.md",
        "Layers on a rigid base": "docs/theory/layers.md",
    },
    "Reference": {
        "The language of scenes": "docs/reference/language.md",
        "Examples of every choice": "docs/reference/examples.md",
        "Variables of scenes": "docs/reference/variables.md",
        "Results of scenes": "docs/reference/results.md",
        "Status, doubt and error": "docs/reference/status.md",
        "Where theories end": "docs/reference/doubts.md",
        "The command": "docs/reference/command.md",
        "The input": "docs/reference/namelist.md",
        "Solvers by their own names": "docs/reference/solvers.md",
        "Tables of text": "docs/reference/tables.md",
        "The results file": "docs/reference/file_format.md",
        "Python": "docs/reference/python.md",
        "Functions of Python": "docs/reference/python_functions.md",
        "Fortran, C and C++": "docs/reference/library.md",
        "Procedures of Fortran": "docs/reference/fortran_procedures.md",
        "Functions of C": "docs/reference/c_functions.md",
        "Modules of Fortran": FORTRAN,
        "Glossary": "docs/reference/glossary.md",
    },
    "Validation": {
        "Published figures": "docs/validation/published.md",
        "Misprints and false conclusions": "docs/validation/misprints.md",
        "Speed against error": "docs/validation/accuracy.md",
        "Rough surfaces: speed and error": "docs/validation/rough_surfaces.md",
        "Time saved in simple cases": "docs/validation/scenes.md",
        "How it scales": "docs/validation/scaling.md",
        "Hard cases": "docs/validation/hard_cases.md",
        "Tables of the interface": "docs/validation/interface.md",
        "Beside public codes": "docs/validation/peers.md",
        "Benchmarks": "bench/README.md",
    },
    "Project": {
        "Contributing": "CONTRIBUTING.md",
        "A paper for JOSS: draft": "docs/paper/joss.md",
        "Results: draft of a paper": "docs/paper/results.md",
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
