# SPDX-License-Identifier: GPL-3.0-or-later
"""Maps: of the surface, as profiles with two axes give them, and of a result over two swept variables. What is shown is found by maps.js."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from bokeh.layouts import column, row
from bokeh.models import BasicTicker, ColorBar, ColumnDataSource, CustomJS, CustomJSTickFormatter, HoverTool, LinearColorMapper, Select, Slider
from bokeh.palettes import Viridis256, interp_palette
from bokeh.plotting import figure

from .columns import FIRST_PROFILE, axis_about, ordered_results, small
from .shared import edges_of, scale_of
from .words import words_of

SCRIPT = Path(__file__).with_name("maps.js")
# cells along an axis of a map of the surface, and maps of a sweep
MOST_CELLS, MOST_MAPS = 128, 24
# fewer values along an axis are curves, and no map
FEWEST = 3
# the axis that points into the solid
DEPTH = "z"
MISSING = "#d9d9d9"
# blue for tension, white, red for compression
DIVERGING = interp_palette(["#053061", "#4393c3", "#f7f7f7", "#d6604d", "#67001f"], 256)


@dataclass
class Maps:
    """Values over two axes, for each value of further ones.

    slow, fast    the two axes: along y and along x of the map
    others        the further axes, as the script is told of them
    values        by name: (further axes ..., slow, fast), with units
    """

    slow: object
    fast: object
    others: list
    values: dict
    units: dict


def surface_maps(results):
    """The maps of profiles with two axes, and what was left out, in words; None without such profiles."""
    if not results.profiles or len(results.profile_axes) != 2:
        return None, ""
    slow, fast = results.profile_axes
    shape = results.status.shape + (slow.values.size, fast.values.size)
    steps = [-(-axis.values.size // MOST_CELLS) for axis in (slow, fast)]
    names = sorted((name for name, profile in results.profiles.items() if profile.values.shape == shape), key=lambda name: name != FIRST_PROFILE)
    if not names or min(shape[-2:]) < 2:
        return None, ""
    kept, others = [], []
    for axis in results.axes:
        most = max(MOST_MAPS // max(int(np.prod([len(some) for some in kept])), 1), 1)
        kept.append(np.unique(np.linspace(0, axis.values.size - 1, min(axis.values.size, most)).round().astype(int)))
        about = axis_about(axis)
        others.append(about | {"texts": [about["texts"][k] for k in kept[-1]], "values": [about["values"][k] for k in kept[-1]]})
    places = np.ix_(*kept, np.arange(shape[-2])[::steps[0]], np.arange(shape[-1])[::steps[1]])
    left = [f"one of {step} cells along {axis.name}" for step, axis in zip(steps, (slow, fast)) if step > 1]
    left += [f"{len(some)} of {axis.values.size} values of {axis.name.replace('_', ' ')}" for some, axis in zip(kept, results.axes)
             if len(some) < axis.values.size]
    values = {name: results.profiles[name].values[places] for name in names}
    axes = [type(axis)(axis.name, axis.unit, axis.values[::step]) for axis, step in zip((slow, fast), steps)]
    return (Maps(*axes, others, values, {name: results.profiles[name].unit for name in names}),
            f"The maps have {' and '.join(left)}." if left else "")


def sweep_maps(results):
    """Maps of results over the two swept variables that vary fastest; None where a sweep has no two such."""
    several = [k for k, axis in enumerate(results.axes) if axis.values.size >= FEWEST]
    if len(several) < 2:
        return None
    slow, fast = several[-2:]
    others = [k for k in range(len(results.axes)) if k not in (slow, fast)]
    names = ordered_results(results)
    values = {name: np.transpose(results.fields[name].values, (*others, slow, fast)) for name in names}
    return Maps(results.axes[slow], results.axes[fast], [axis_about(results.axes[k]) for k in others], values,
                {name: results.fields[name].unit for name in names})


def make_maps(maps, prefix, is_surface):
    """The controls and the figure of maps."""
    scaled, about = {}, {}
    for name, values in maps.values.items():
        factor, unit = scale_of(values, maps.units[name])
        scaled[name] = small(values * factor)
        about[name] = {"label": words_of(name, unit), "words": words_of(name).lower(), "unit": unit}
    x, y = axis_about(maps.fast), axis_about(maps.slow)
    chosen = next(iter(about))
    what = Select(title="map of", value=chosen, options=[(name, one["words"]) for name, one in about.items()], name=f"{prefix}quantity")
    sliders = [_make_slider(axis, prefix) for axis in maps.others]
    is_log = (x["log"], y["log"]) if not is_surface else (False, False)
    one = figure(height=460, width=620, x_axis_type="log" if is_log[0] else "linear", y_axis_type="log" if is_log[1] else "linear",
                 x_axis_label=x["label"], y_axis_label=y["label"], tools="pan,box_zoom,wheel_zoom,reset,save", active_drag="box_zoom",
                 match_aspect=is_surface, name=f"{prefix}figure")
    one.toolbar.logo = None
    one.grid.visible = False
    one.y_range.flipped = maps.slow.name == DEPTH
    cells = _cells_of(x, y, is_log)
    cells["value"] = np.zeros(cells["x"].size, np.float32)
    source = ColumnDataSource(cells, name=f"{prefix}cells")
    colours = LinearColorMapper(palette=Viridis256, low=0, high=1, nan_color=MISSING)
    if is_surface and _is_even(x["values"]) and _is_even(y["values"]):
        source = _draw_image(one, x["values"], y["values"], colours, f"{prefix}cells")
    else:
        shown = one.quad("left", "right", "bottom", "top", source=source, line_color=None, fill_color={"field": "value", "transform": colours})
        one.add_tools(HoverTool(renderers=[shown], tooltips=[(x["words"], f"@x{{%.5g}} {x['unit']}"), (y["words"], f"@y{{%.5g}} {y['unit']}"),
                                                           ("value", "@value{%.5g}")],
                                formatters={"@x": "printf", "@y": "printf", "@value": "printf"}))
    bar = ColorBar(color_mapper=colours, ticker=BasicTicker(desired_num_ticks=8), title=about[chosen]["label"], title_text_font_style="normal")
    one.add_layout(bar, "right")
    script = CustomJS(args={"what": what, "about": about, "data": ColumnDataSource(scaled), "sliders": sliders, "source": source,
                            "colours": colours, "bar": bar, "sequential": list(Viridis256), "diverging": list(DIVERGING),
                            "sizes": [len(axis["values"]) for axis in maps.others], "n_cells": len(x["values"]) * len(y["values"])},
                      code=SCRIPT.read_text())
    for control in [what, *(slider for slider in sliders if slider)]:
        control.js_on_change("value", script)
    return column(row(what, *(slider for slider in sliders if slider), sizing_mode="stretch_width"), one, sizing_mode="stretch_width"), script


def _make_slider(axis, prefix):
    """A slider for a further axis; None if it has one value."""
    if len(axis["values"]) < 2:
        return None
    return Slider(start=0, end=len(axis["values"]) - 1, value=0, step=1, title="", name=f"{prefix}slider {axis['name']}",
                  format=CustomJSTickFormatter(args={"texts": axis["texts"]}, code="return texts[Math.round(tick)]"))


def _is_even(values):
    """Do values have equal steps?"""
    steps = np.diff(values)
    return bool(np.all(np.abs(steps - steps[0]) <= 1e-6 * np.abs(steps[0])) and steps[0] > 0)


def _cells_of(x, y, is_log):
    """The rectangles around the points of two axes, x the faster one."""
    sides = []
    for axis, log in zip((x, y), is_log):
        values = np.array(axis["values"])
        order = np.argsort(values)
        edges = edges_of(values[order], log)
        if not log:
            # cells at the ends are whole
            edges[0], edges[-1] = 2 * values[order[0]] - edges[1], 2 * values[order[-1]] - edges[-2]
        low, high = np.empty(values.size), np.empty(values.size)
        low[order], high[order] = edges[:-1], edges[1:]
        sides.append((values, low, high))
    (x_values, left, right), (y_values, bottom, top) = sides
    wide, tall = x_values.size, y_values.size
    return {"x": np.tile(x_values, tall), "left": np.tile(left, tall), "right": np.tile(right, tall),
            "y": np.repeat(y_values, wide), "bottom": np.repeat(bottom, wide), "top": np.repeat(top, wide)}


def _draw_image(one, x, y, colours, name):
    """An image, for maps of even cells; its source."""
    step_x, step_y = x[1] - x[0], y[1] - y[0]
    source = ColumnDataSource({"image": [np.zeros((len(y), len(x)), np.float32)], "x": [x[0] - step_x / 2], "y": [y[0] - step_y / 2],
                               "dw": [step_x * len(x)], "dh": [step_y * len(y)]}, name=name)
    shown = one.image("image", "x", "y", "dw", "dh", source=source, color_mapper=colours)
    one.x_range.range_padding = one.y_range.range_padding = 0
    one.add_tools(HoverTool(renderers=[shown], tooltips=[("x", "$x{%.4g}"), ("y", "$y{%.4g}"), ("value", "@image{%.5g}")],
                            formatters={"$x": "printf", "$y": "printf", "@image": "printf"}))
    return source
