# SPDX-License-Identifier: GPL-3.0-or-later
"""Single fits: the estimates, data with the best curve, residuals, and how the sum of squares rises with each variable."""

from html import escape

import numpy as np
from bokeh.layouts import column
from bokeh.models import Band, ColumnDataSource, HoverTool, Span
from bokeh.plotting import figure

from .shared import COLOURS, fit, is_logarithmic, scale_of
from .words import number_of, words_of

TOOLS = "pan,box_zoom,wheel_zoom,reset,save"
# numbers that tell how good a fit is, as far as a file has them
QUALITY = ("chi2", "degrees_of_freedom", "p_value", "points_used", "n_outliers", "lag_correlation", "runs_p_value", "n_minima",
           "second_minimum", "sigma_estimate")
LEFT_OUT = "#c00000"


def names_of(columns):
    """Names of the free variables."""
    return [str(name) for name in columns["variable"].values] if "variable" in columns else []


def fit_html(columns):
    """The estimates with their errors and intervals, and how good the fit is."""
    names = names_of(columns)
    levels = columns["level"].values if "level" in columns else []
    head = "".join(f"<th>{level * 100:.4g} %</th>" for level in levels)
    rows = []
    for k, name in enumerate(names):
        found, error = columns.get(name), columns.get(f"{name}_error")
        if found is None:
            continue
        value, unit = float(found.values), found.unit
        spread = "none" if error is None or not np.isfinite(error.values) else number_of(float(error.values), unit, [value])
        bound = columns.get(f"{name}_bound")
        at = {-1: ", at its lower bound", 1: ", at its upper bound"}.get(int(bound.values) if bound is not None and np.isfinite(bound.values) else 0, "")
        cells = "".join(f"<td>{escape(_pieces(columns, k, level, value, unit))}</td>" for level in range(len(levels)))
        rows.append(f"<tr><td>{escape(words_of(name))}</td><td>{escape(number_of(value, unit))}{at}</td><td>{escape(spread)}</td>{cells}</tr>")
    table = f"<table class='fit'><tr><th>variable</th><th>best value</th><th>standard error</th>{head}</tr>{''.join(rows)}</table>" if rows else ""
    quality = "".join(f"<tr><td>{escape(columns[name].long_name or name)}</td><td>{escape(number_of(float(columns[name].values), columns[name].unit))}</td></tr>"
                      for name in QUALITY if name in columns and np.isfinite(columns[name].values))
    return table + (f"<table class='quality'>{quality}</table>" if quality else "")


def _pieces(columns, variable, level, value, unit):
    """The pieces of an interval in words; an end that is open has no number."""
    if "interval" not in columns:
        return ""
    pieces = columns["interval"].values[variable, level]
    some = pieces[np.any(np.isfinite(pieces), axis=-1)]
    ends = [[number_of(end, unit, [value]) if np.isfinite(end) else "open" for end in piece] for piece in some]
    return " and ".join(" to ".join(piece) for piece in ends)


def make_fit(columns):
    """The figures of a fit."""
    figures = []
    for number, suffix in enumerate(fit.suffixes_of(columns), 1):
        data = fit.DataSet(columns, suffix)
        figures += _draw_data(data, columns, number)
    figures += [_draw_profile(columns, name) for name in names_of(columns) if f"{name}_profile" in columns]
    return column(*figures, sizing_mode="stretch_width")


def _figure(x_label, y_label, height, is_log=False, **options):
    """A figure of the page."""
    one = figure(height=height, sizing_mode="stretch_width", tools=TOOLS, active_drag="box_zoom", x_axis_label=x_label, y_axis_label=y_label,
                 x_axis_type="log" if is_log else "linear", **options)
    one.toolbar.logo = None
    return one


def _draw_data(data, columns, number):
    """Points and curves, and below them the residuals along the same axis."""
    (x_name, x_unit), (y_name, y_unit) = data.about("abscissa"), data.about("ordinate")
    x, y = data["abscissa"], data["ordinate"]
    x_factor, x_unit = scale_of(x, x_unit)
    y_factor, y_unit = scale_of(y, y_unit)
    used = data["used"] == "true" if data["used"] is not None else np.isfinite(x * y)
    is_log = is_logarithmic(x[used] if data.variable() is None else np.unique(x[used]))
    above = _figure(words_of(x_name, x_unit), words_of(y_name, y_unit), 380, is_log, name=f"data {number}")
    sigma = data["sigma"] if data["sigma"] is not None else np.zeros_like(y)
    residual = data["residual"] if data["residual"] is not None else np.full(y.shape, np.nan)
    points = ColumnDataSource({"x": x * x_factor, "y": y * y_factor, "low": (y - sigma) * y_factor, "high": (y + sigma) * y_factor,
                               "residual": residual, "colour": np.where(used, "#404040", LEFT_OUT),
                               "label": np.where(used, "measured", "left out")}, name=f"points {number}")
    above.segment("x", "low", "x", "high", source=points, color="colour", line_alpha=0.5)
    dots = above.scatter("x", "y", source=points, size=5, color="colour", legend_field="label")
    tips = [(words_of(x_name).lower(), f"@x{{%.5g}} {x_unit}"), (words_of(y_name).lower(), f"@y{{%.5g}} {y_unit}"),
            ("residual", "@residual{%.3g} standard errors")]
    formats = {"@x": "printf", "@y": "printf", "@residual": "printf"}
    above.add_tools(HoverTool(renderers=[dots], tooltips=tips, formatters=formats))
    if data["curve"] is not None:
        curve = ColumnDataSource({"x": data["curve_x"] * x_factor, "y": data["curve"] * y_factor})
        if data["band_low"] is not None:
            curve.add(data["band_low"] * y_factor, "low")
            curve.add(data["band_high"] * y_factor, "high")
            above.add_layout(Band(base="x", lower="low", upper="high", source=curve, fill_color=COLOURS[1], fill_alpha=0.25))
        above.line("x", "y", source=curve, color=COLOURS[1], line_width=2, legend_label="best fit")
        if data["second_curve"] is not None:
            above.line(data["curve_x"] * x_factor, data["second_curve"] * y_factor, color=COLOURS[2], line_dash="dashed", legend_label="second minimum")
    below = _figure(words_of(x_name, x_unit), "standard errors", 190, is_log, x_range=above.x_range, name=f"residuals {number}")
    for level, dash in ((0, "solid"), (1, "dashed"), (-1, "dashed"), (3, "dotted"), (-3, "dotted")):
        below.add_layout(Span(location=level, dimension="width", line_color="#999999", line_dash=dash, line_width=0.8))
    dots = below.scatter("x", "residual", source=points, size=5, color="colour")
    below.add_tools(HoverTool(renderers=[dots], tooltips=tips, formatters=formats))
    return [above, below]


def _draw_profile(columns, name):
    """The least sum of squares S with one variable at a value, less the least of all."""
    values, excess = columns[f"{name}_profile_value"].values, columns[f"{name}_profile"].values
    factor, unit = scale_of(values, columns[name].unit if name in columns else "-")
    shown = excess <= fit.MOST_EXCESS
    is_log = bool(np.any(shown) and np.all(values[shown] > 0) and values[shown].max() > 3 * values[shown].min())
    one = _figure(words_of(name, unit), "S less its least value", 240, is_log, name=f"profile {name}")
    source = ColumnDataSource({"x": values[shown] * factor, "y": excess[shown]})
    one.line("x", "y", source=source, color=COLOURS[1])
    dots = one.scatter("x", "y", source=source, color=COLOURS[1], size=5)
    for level, _ in fit.LEVELS:
        one.add_layout(Span(location=level, dimension="width", line_color="#999999", line_dash="dashed", line_width=0.8))
    one.add_tools(HoverTool(renderers=[dots], tooltips=[(words_of(name).lower(), f"@x{{%.5g}} {unit}"), ("S less its least value", "@y{%.3g}")],
                            formatters={"@x": "printf", "@y": "printf"}))
    return one
