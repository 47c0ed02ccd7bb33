# SPDX-License-Identifier: GPL-3.0-or-later
"""Stacks of fits: how large the residuals of each fit are and what they say, the fits that are worst, and the residuals themselves."""

from html import escape

import numpy as np
from bokeh.layouts import row
from bokeh.models import ColumnDataSource, HoverTool, Span
from bokeh.plotting import figure

from .columns import profile_tables
from .shared import COLOURS
from .words import number_of, words_of

TOOLS = "pan,box_zoom,wheel_zoom,reset,save"
# fits below this probability are rare by chance, and this many of the worst are named
RARE, MOST_NAMED = 0.01, 10
BINS = 10
# what is drawn of the points at first
FIRST_X, FIRST_Y = "abscissa", "residual"


def root_mean_square(results):
    """Root of the mean square of the residuals of each fit, in standard errors; NaN where there is no answer."""
    chi2, freedom = (results.fields[name].values for name in ("chi2", "degrees_of_freedom"))
    answered = np.isfinite(chi2) & (freedom > 0)
    return np.sqrt(np.divide(chi2, freedom, out=np.full(chi2.shape, np.nan), where=answered))


def stack_html(results):
    """How many fits have an answer, how many are rare by chance, and which are the worst."""
    size = root_mean_square(results)
    answered = np.isfinite(size)
    lines = [f"{int(answered.sum())} of {size.size} fits have residuals. Their root mean square is that of S over its degrees of freedom."]
    probability = _values(results, "p_value")
    known = np.isfinite(probability) & answered
    if known.any():
        lines.append(f"{int((probability[known] < RARE).sum())} of {int(known.sum())} fits have a probability Q below {RARE:g}; "
                     f"by chance it is about {RARE * known.sum():.1f}.")
    text = f"<p>{' '.join(map(escape, lines))}</p>"
    worst = [place for place in np.argsort(np.where(answered, -size, np.inf), axis=None)[:MOST_NAMED] if answered.flat[place]]
    columns = [(name, words_of(name)) for name in ("p_value", "lag_correlation", "n_outliers", "points_used") if name in results.fields]
    heads = [*(words_of(axis.name) for axis in results.axes), "root mean square (standard errors)", *(words for _, words in columns)]
    rows = []
    for place in worst:
        index = np.unravel_index(place, size.shape)
        cells = [number_of(float(axis.values[k]), axis.unit) for axis, k in zip(results.axes, index)]
        cells.append(f"{size[index]:.4g}")
        cells += [f"{results.fields[name].values[index]:.4g}" if np.isfinite(results.fields[name].values[index]) else "" for name, _ in columns]
        rows.append("<tr>" + "".join(f"<td>{escape(cell)}</td>" for cell in cells) + "</tr>")
    if not rows:
        return text
    return text + "<p>The fits with the largest residuals:</p><table class='worst'><tr>" + "".join(
        f"<th>{escape(head)}</th>" for head in heads) + f"</tr>{''.join(rows)}</table>"


def make_stack(results, prefix=""):
    """Two figures: how often a probability Q occurs, and how neighbouring residuals go together with their size."""
    size = root_mean_square(results)
    answered = np.isfinite(size)
    figures = []
    probability = _values(results, "p_value")[answered]
    probability = probability[np.isfinite(probability)]
    if probability.size:
        counts, edges = np.histogram(probability, bins=BINS, range=(0.0, 1.0))
        one = _figure("probability Q", "fits", f"{prefix}probability")
        source = ColumnDataSource({"left": edges[:-1], "right": edges[1:], "top": counts}, name=f"{prefix}counts")
        bars = one.quad(left="left", right="right", bottom=0, top="top", source=source, fill_color=COLOURS[2], fill_alpha=0.6, line_color="#404040")
        one.add_layout(Span(location=probability.size / BINS, dimension="width", line_color="#999999", line_dash="dashed"))
        one.add_tools(HoverTool(renderers=[bars], tooltips=[("Q", "@left to @right"), ("fits", "@top")]))
        figures.append(one)
    correlation = _values(results, "lag_correlation")
    shown = answered & np.isfinite(correlation)
    if shown.any():
        labels = [", ".join(f"{words_of(axis.name).lower()} {number_of(float(axis.values[k]), axis.unit)}" for axis, k in zip(results.axes, index))
                  for index in np.argwhere(shown)]
        one = _figure("root mean square of the residuals (standard errors)", "correlation of neighbouring residuals", f"{prefix}correlation")
        source = ColumnDataSource({"x": size[shown], "y": correlation[shown], "label": labels}, name=f"{prefix}fits")
        dots = one.scatter("x", "y", source=source, size=5, color=COLOURS[1], alpha=0.7)
        for location, dimension in ((1.0, "height"), (0.0, "width")):
            one.add_layout(Span(location=location, dimension=dimension, line_color="#999999", line_dash="dashed"))
        one.add_tools(HoverTool(renderers=[dots], tooltips="<div><b>@label</b></div><div>@x, @y</div>"))
        figures.append(one)
    return row(*figures, sizing_mode="stretch_width") if figures else None


def residual_table(results):
    """The points of all curves with their residuals; None where the file has none."""
    return profile_tables(results) if FIRST_Y in results.profiles else None


def _values(results, name):
    """A result of each fit; NaN where the file does not have it."""
    return results.fields[name].values if name in results.fields else np.full(results.status.shape, np.nan)


def _figure(x_label, y_label, name):
    """A figure of the page."""
    one = figure(height=300, sizing_mode="stretch_width", tools=TOOLS, active_drag="box_zoom", x_axis_label=x_label, y_axis_label=y_label, name=name)
    one.toolbar.logo = None
    return one
