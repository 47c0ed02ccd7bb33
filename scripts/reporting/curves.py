# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves whose axes are chosen on the page, with a slider for each further swept variable. What is drawn is found by curves.js."""

from pathlib import Path

from bokeh.layouts import column, row
from bokeh.models import ColumnDataSource, CustomJS, CustomJSTickFormatter, Div, HoverTool, Legend, LegendItem, Select, Slider
from bokeh.palettes import Viridis256
from bokeh.plotting import figure

from .shared import COLOURS

TOOLS = "pan,box_zoom,wheel_zoom,reset,save"
SCALES = ("linear", "logarithmic x", "logarithmic y", "both logarithmic")
SCRIPT = Path(__file__).with_name("curves.js")
# the first value of a slider stands for all values
ALL = 0
# more curves than this are not drawn together at first
MOST_CURVES = 60
HOVER = "<div><b>@label</b></div><div>@x_text</div><div>@y_text</div><div>@note</div>"


def make_curves(tables, x=None, y=None, prefix=""):
    """The controls and the figures of one run or several; `prefix` begins the names of the controls."""
    names_x, names_y = _common_names(tables)
    choose = {
        "x": Select(title="x", value=x or _first_x(tables, names_x), options=list(names_x.items()), name=f"{prefix}x"),
        "y": Select(title="y", value=y or next(iter(names_y)), options=list(names_y.items()), name=f"{prefix}y"),
        "scale": Select(title="axes", value=SCALES[0], options=list(SCALES), name=f"{prefix}scale"),
    }
    along = _common_axes(tables)
    choose["along"] = Select(title="a curve along", value=tables[0].about["axes"][tables[0].about["along"]]["name"],
                             options=[(axis["name"], axis["words"]) for axis in along], name=f"{prefix}along")
    choose["along"].visible = len(along) > 1
    sliders = _make_sliders(tables, prefix)
    drawn = {name: ColumnDataSource({column: [] for column in columns}, name=f"{prefix}{name}") for name, columns in (
        ("lines", ("xs", "ys", "colour", "label")), ("points", ("x", "y", "colour", "label", "x_text", "y_text", "note", "size")),
        ("doubts", ("x", "y")), ("missed", ("x", "y")), ("errors", ("x0", "y0", "x1", "y1", "colour")))}
    figures = [_make_figure(drawn, scale, prefix) for scale in SCALES]
    remark = Div(text="", name=f"{prefix}remark")
    script = CustomJS(args={
        "runs": [table.about for table in tables], "sources": [ColumnDataSource(table.columns) for table in tables], "choose": choose,
        "sliders": sliders, "drawn": drawn, "figures": figures, "axes_x": [one.xaxis[0] for one in figures],
        "axes_y": [one.yaxis[0] for one in figures], "ranges": [[one.x_range, one.y_range] for one in figures],
        "legends": [one.legend[0] for one in figures], "scales": list(SCALES), "remark": remark, "colours": list(COLOURS),
        "palette": list(Viridis256), "most_curves": MOST_CURVES}, code=SCRIPT.read_text())
    for one in [*choose.values(), *sliders.values()]:
        one.js_on_change("value", script)
    controls = [choose["x"], choose["y"], choose["scale"], choose["along"]]
    layout = column(row(*controls, sizing_mode="stretch_width"), *([row(*sliders.values(), sizing_mode="stretch_width")] if sliders else []),
                    *figures, remark, sizing_mode="stretch_width")
    return layout, script


def _common_names(tables):
    """What may be along x and y: axes with several values, and what all runs have; by name with its label."""
    def named(about):
        axes = {axis["name"]: axis["words"] for axis in about["axes"] if len(axis["values"]) > 1}
        return axes | {name: one["words"] for name, one in about["names"].items()}

    first, *others = (named(table.about) for table in tables)
    names = {name: words for name, words in first.items() if all(name in other for other in others)}
    owned = set().union(*(table.about["owners"] for table in tables), *({axis["name"] for axis in table.about["axes"]} for table in tables))
    return names, {name: words for name, words in names.items() if name not in owned}


def _first_x(tables, names):
    """What is along x at first: the axis that varies fastest, or the first variable that changes along it."""
    about = tables[0].about
    axis = about["axes"][about["along"]]
    companions = [name for name, along in about["owners"].items() if along == about["along"]]
    name = companions[0] if axis["sampled"] and companions else axis["name"]
    return name if name in names else next(iter(names))


def _common_axes(tables):
    """The axes with several values that all runs have, and so may be those of curves."""
    first, *others = ({axis["name"]: axis for axis in table.about["axes"] if len(axis["values"]) > 1} for table in tables)
    return [axis for name, axis in first.items() if all(name in other for other in others)]


def _make_sliders(tables, prefix):
    """A slider for each swept variable of a single run, whose first value stands for all values. Several runs show all their curves."""
    if len(tables) > 1:
        return {}
    about, sliders = tables[0].about, {}
    several = [axis for axis in about["axes"] if len(axis["values"]) > 1]
    along = about["axes"][about["along"]]["name"]
    curves = 1
    for axis in several:
        if len(several) == 1:
            break
        curves *= 1 if axis["name"] == along else len(axis["values"])
        texts = [f"all values of {axis['words']}", *axis["texts"]]
        # so many curves are none to look at
        value = ALL if curves <= MOST_CURVES else 1
        slider = Slider(start=0, end=len(axis["values"]), value=value, step=1, title="", name=f"{prefix}slider {axis['name']}",
                        format=CustomJSTickFormatter(args={"texts": texts}, code="return texts[Math.round(tick)]"))
        sliders[axis["name"]] = slider
    return sliders


def _make_figure(drawn, scale, prefix):
    """The figure of one kind of axes; only one of them is seen."""
    one = figure(height=430, sizing_mode="stretch_width", tools=TOOLS, active_drag="box_zoom", x_range=(0, 1), y_range=(0, 1),
                 x_axis_type="log" if scale in (SCALES[1], SCALES[3]) else "linear",
                 y_axis_type="log" if scale in SCALES[2:] else "linear", name=f"{prefix}{scale}", visible=scale == SCALES[0])
    one.scatter("x", "y", source=drawn["doubts"], size=11, color="#cccccc", marker="square")
    one.segment("x0", "y0", "x1", "y1", source=drawn["errors"], color="colour", line_alpha=0.5)
    lines = one.multi_line("xs", "ys", source=drawn["lines"], color="colour", line_width=1.8)
    points = one.scatter("x", "y", source=drawn["points"], size="size", color="colour")
    one.scatter("x", "y", source=drawn["missed"], size=8, color="#c00000", marker="x", line_width=2)
    one.add_layout(Legend(items=[LegendItem(label={"field": "label"}, renderers=[lines])], background_fill_alpha=0.7, border_line_color=None,
                          label_text_font_size="12px"), "right")
    one.add_tools(HoverTool(renderers=[points], tooltips=HOVER))
    one.toolbar.logo = None
    return one
