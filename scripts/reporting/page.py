# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of results: its sections in order, and the scripts and styles that it needs, all in one text."""

import base64
from html import escape
from pathlib import Path

import numpy as np
from bokeh.document import Document
from bokeh.embed import file_html
from bokeh.events import DocumentReady
from bokeh.resources import Resources
from jinja2 import Template

from .columns import Table, profile_tables, table_of, varies
from .curves import make_curves
from .fits import fit_html, make_fit
from .maps import DEPTH, make_maps, surface_maps, sweep_maps
from .scene import scene_html, scene_of
from .shared import BadFile, NothingToDraw, fit
from .sketch import sketch_of
from .stacks import FIRST_X, FIRST_Y, make_stack, residual_table, stack_html
from .statuses import status_html
from .thinning import thin
from .words import number_of, words_of

FOLDER = Path(__file__).parent
# numbers of curves on a page, which take four bytes each, and a third more in the text
MOST_NUMBERS = 240_000
# what a path is drawn by at first, along x and y
LOOP = ("tangential_displacement", "tangential_force")


class Page:
    """A page that grows from top to bottom.

    parts     ("html", text) or ("root", name of what stands there)
    """

    def __init__(self, title):
        """An empty page."""
        self.title = title
        self.parts = []
        self.document = Document()

    def add(self, text):
        """Add some HTML."""
        self.parts.append(("html", text))

    def add_figure(self, name, layout, script=None):
        """Add controls and figures; their script runs when the page is ready, and whenever a control changes."""
        layout.name = name
        self.document.add_root(layout)
        if script is not None:
            self.document.js_on_event(DocumentReady, script)
        self.parts.append(("root", name))

    def text(self):
        """The page as one text, with everything that it needs."""
        template = Template(FOLDER.joinpath("page.html").read_text())
        variables = {"parts": self.parts, "style": FOLDER.joinpath("page.css").read_text()}
        if not self.document.roots:
            # there is nothing to draw, and so no need of scripts
            return template.render(title=self.title, bokeh_css="", bokeh_js="", plot_script="", **variables)
        return file_html(self.document, Resources(mode="inline"), title=self.title, template=template, template_variables=variables)


def page_of(runs, x=None, y=None, has_words=True):
    """The page of one run or several, as text; x and y are drawn at first. Without words it has the figures alone."""
    names = titles_of(runs)
    page = Page(" and ".join(dict.fromkeys(names)))
    if has_words:
        page.add(f"<header><h1>{escape(page.title)}</h1></header>")
    if has_words and len(runs) > 1:
        page.add("<nav>" + "".join(f"<a href='#run{k}'>{escape(name)}</a>" for k, name in enumerate(names, 1)) + "</nav>")
    thinned = [thin(results, MOST_NUMBERS // len(runs), max(len(results.fields), 1)) for results in runs]
    tables = [table_of_curves(results) for results, _ in thinned]
    for results, table in zip(runs, tables):
        check_names(results, table, x, y)
    if len(runs) > 1:
        add_together(page, tables, names, x, y)
    for number, (results, name, (_, left), table) in enumerate(zip(runs, names, thinned, tables), 1):
        if has_words:
            add_run(page, results, name, number, len(runs) > 1)
        if table is not None:
            page.add(f"<h3>{'Curves' if has_words or len(runs) == 1 else escape(name)}</h3>")
            page.add_figure(f"curves{number}", *make_curves([table], x, y, f"curves{number} "))
            page.add(f"<p class='left-out'>{escape(left)}</p>" if left else "")
        add_maps(page, results, number)
        add_fit(page, results, number)
    if not page.document.roots and not has_words:
        raise NothingToDraw(f"{runs[0].path}: one point without profiles: nothing to draw")
    return page.text()


def titles_of(runs):
    """A title for each run; files of one title are told apart by their names."""
    titles = [results.title or results.model for results in runs]
    if len(set(titles)) < len(titles):
        titles = [f"{title} ({results.path.stem})" for title, results in zip(titles, runs)]
    return titles


def table_of_curves(results):
    """The table of a run; None where nothing varies."""
    if not results.several:
        return None
    try:
        return table_of(results)
    except NothingToDraw:
        return None


def check_names(results, table, x, y):
    """Are the names of the command line those of a run?"""
    about = {"axes": [], "names": {}, "owners": {}} if table is None else table.about
    swept = [axis["name"] for axis in about["axes"] if len(axis["values"]) > 1]
    found = [name for name in about["names"] if name not in about["owners"]]
    for name, option, known in ((x, "x", swept + list(about["names"])), (y, "y", found)):
        if name is not None and name not in known:
            raise BadFile(f"{results.path}: {option} {name}: " + (f"allowed: {', '.join(known)}" if known else "nothing varies in this file"))


def add_together(page, tables, names, x, y):
    """The curves of all runs in one figure, where they have an axis and results in common."""
    if None in tables:
        return
    swept = [{axis["name"] for axis in table.about["axes"] if len(axis["values"]) > 1} | set(table.about["owners"]) for table in tables]
    found = [set(table.about["names"]) - set(table.about["owners"]) for table in tables]
    if not set.intersection(*swept) or not set.intersection(*found):
        return
    titled = [Table({**table.about, "title": name}, table.columns) for table, name in zip(tables, names)]
    page.add("<h2>All files together</h2>")
    page.add_figure("together", *make_curves(titled, x, y, "together "))


def add_run(page, results, name, number, is_one_of_several):
    """What a run is, how it is repeated, and whether it can be trusted."""
    scene = scene_of(results)
    page.add(f"<h2 id='run{number}'>{escape(name)}</h2>" if is_one_of_several else f"<div id='run{number}'></div>")
    about = scene.source.attributes
    made = [f"adfric {about['adfric_version']}" if "adfric_version" in about else "", about.get("created", ""), results.path.name]
    page.add(f"<p class='from'>{escape(', '.join(part for part in made if part))}</p>")
    page.add(f"<h3>Scene</h3><div class='scene'><div>{scene_html(scene)}</div><div>{sketch_of(scene)}</div></div>")
    if about.get("references"):
        page.add(f"<p class='from'>{escape(about['references'])}</p>")
    page.add(values_html(results, scene.source))
    page.add(input_html(scene.source.text, results, number))
    page.add(f"<h3>Statuses and doubts</h3>{status_html(results, scene.source.statuses)}")


def values_html(results, source):
    """Tables of what has one value: results of a single point or that do not vary, and everything else."""
    steady = {name: field for name, field in results.fields.items() if not varies(field.values) and np.any(np.isfinite(field.values))}
    rows = [(name, number_of(float(field.values[np.isfinite(field.values)].flat[0]), field.unit)) for name, field in steady.items()]
    rows += [(name, str(next(iter(words.ravel())))) for name, words in results.states.items() if words.size == 1 and name != "doubt"]
    text = _table_html("Results that do not vary" if results.several else "Results", rows, source, not results.several and not fit.is_fit(results))
    rows = [(name, str(results.words[name])) if name in results.words else (name, number_of(float(field.values), field.unit))
            for name, field in results.constants.items() if name in results.words or np.isfinite(field.values)]
    return text + _table_html("All values of the scene", rows, source, False)


def _table_html(title, rows, source, is_open):
    """A table that opens, of names, values and meanings."""
    if not rows:
        return ""
    body = "".join(f"<tr><td>{escape(words_of(name))}</td><td>{escape(value.replace('_', ' '))}</td><td>{escape(source.meanings.get(name, ''))}</td></tr>"
                   for name, value in rows)
    return f"<details{' open' if is_open else ''}><summary>{title}</summary><table>{body}</table></details>"


def input_html(text, results, number):
    """The input, to read, to copy and to save."""
    if not text:
        return "<p>The file has no input: it was not made by an input file.</p>"
    data = base64.b64encode(text.encode()).decode()
    return (f"<details><summary>The input that repeats it</summary><p><button data-copy='input{number}'>copy</button> "
            f"<a download='{escape(results.path.stem)}.nml' href='data:text/plain;charset=utf-8;base64,{data}'>save</a></p>"
            f"<pre id='input{number}'>{escape(text)}</pre></details>")


def add_maps(page, results, number):
    """Profiles along a line, maps of the surface, and maps of the sweep."""
    kept, left = thin_profiles(results)
    # those of a fit are not on a surface
    if not fit.is_fit(results) and (table := profile_tables(kept)) is not None:
        is_path = results.model.endswith("_history")
        chosen = [name if is_path and name in table.about["names"] else None for name in LOOP]
        page.add(f"<h3>{'Along the path' if is_path else 'Profiles'}</h3>")
        page.add_figure(f"profiles{number}", *make_curves([table], *chosen, prefix=f"profiles{number} "))
        page.add(f"<p class='left-out'>{escape(left)}</p>" if left else "")
    maps, left = surface_maps(results)
    if maps is not None:
        page.add(f"<h3>{'Maps inside the solid' if DEPTH in (maps.slow.name, maps.fast.name) else 'Maps of the surface'}</h3>")
        page.add_figure(f"surface{number}", *make_maps(maps, f"surface{number} ", is_surface=True))
        page.add(f"<p class='left-out'>{escape(left)}</p>" if left else "")
    kept, left = thin(results, MOST_NUMBERS, max(len(results.fields), 1))
    try:
        maps = sweep_maps(kept)
    except NothingToDraw:
        maps = None
    if maps is not None:
        page.add("<h3>Maps over two swept variables</h3>")
        page.add_figure(f"sweep{number}", *make_maps(maps, f"sweep{number} ", is_surface=False))
        page.add(f"<p class='left-out'>{escape(left)}</p>" if left else "")


def thin_profiles(results):
    """Fewer points of a sweep, where their profiles are many numbers."""
    size = int(np.prod([axis.values.size for axis in results.profile_axes])) if results.profiles else 1
    return thin(results, MOST_NUMBERS, size * max(len(results.profiles), 1))


def add_fit(page, results, number):
    """The estimates of a single fit, its curves and its residuals; of a stack what the residuals say."""
    if not fit.is_fit(results):
        return
    if results.several:
        add_stack(page, results, number)
        return
    columns = fit.read_columns(results.source)
    page.add(f"<h3>Fit</h3>{fit_html(columns)}")
    page.add_figure(f"fit{number}", make_fit(columns))


def add_stack(page, results, number):
    """The residuals of the fits of a stack."""
    page.add(f"<h3>Residuals of the fits</h3>{stack_html(results)}")
    if (figures := make_stack(results, f"stack{number} ")) is not None:
        page.add_figure(f"stack{number}", figures)
    kept, left = thin_profiles(results)
    if (table := residual_table(kept)) is not None:
        page.add_figure(f"residuals{number}", *make_curves([table], FIRST_X, FIRST_Y, f"residuals{number} "))
        page.add(f"<p class='left-out'>{escape(left)}</p>" if left else "")
    else:
        page.add("<p class='left-out'>The file has no residuals of single points: they come with &amp;fit residuals = 'all'</p>")
