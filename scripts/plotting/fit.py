# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of fits: data with the best curve, residuals and profiles of a single fit; images of what a stack of curves gives."""

from dataclasses import dataclass

import h5py
import numpy as np

from .labels import axis_label, scale_of
from .style import COLOURS, is_logarithmic, plt

# levels of S - S_min that bound sets of 68 % and of 95 % where the standard errors are given
LEVELS = ((1.0, "68 %"), (3.841, "95 %"))
# the part of a profile that is drawn
MOST_EXCESS = 8.0
POINT = {"marker": "o", "markersize": 2.6, "linestyle": "none", "linewidth": 0.6, "elinewidth": 0.5, "capsize": 0, "zorder": 1}
CURVE = {"color": COLOURS[1], "zorder": 3}
SECOND = {"color": COLOURS[2], "linestyle": (0, (4, 2)), "linewidth": 1.0, "zorder": 4}
# values of a variable that have a colour each
MOST_VALUES = 8
CONTACT, FREE, LEFT_OUT = "0.25", "0.65", "#c00000"
# abscissas of the events, by their kind
EVENT_AXES = {"pull_off_load": "load", "jump_in_approach": "approach", "pull_off_approach": "approach"}


@dataclass
class Column:
    """A dataset of a fit."""

    values: np.ndarray
    unit: str
    long_name: str


@dataclass
class DataSet:
    """What the file has of one measured curve; a column that is not there is None."""

    columns: dict
    suffix: str

    def __getitem__(self, name):
        column = self.columns.get(name + self.suffix)
        return None if column is None else column.values

    def variable(self):
        """Of the variables that have a value for each point that of most values, if these are few; None if there is none."""
        counts = {}
        for name in self.columns:
            if name.startswith("point_") and name.endswith(self.suffix):
                points = self[name.removesuffix(self.suffix)]
                if points.dtype.kind == "f" and np.any(np.isfinite(points)):
                    counts[name.removeprefix("point_").removesuffix(self.suffix)] = len(np.unique(points[np.isfinite(points)]))
        counts = {name: count for name, count in counts.items() if count <= MOST_VALUES}
        return max(counts, key=counts.get) if counts else None

    def about(self, name):
        """Name and unit of what is measured."""
        column = self.columns[name + self.suffix]
        return column.long_name, column.unit


def read_columns(path):
    """Every dataset of a single fit with its unit."""
    columns = {}
    with h5py.File(path, "r") as file:
        for name, dataset in file.items():
            if isinstance(dataset, h5py.Dataset):
                unit = _text(dataset.attrs.get("units", "1"))
                values = dataset[()]
                if "flag_meanings" in dataset.attrs and dataset.dtype.kind == "i":
                    words = dict(zip(np.asarray(dataset.attrs["flag_values"]).tolist(), _text(dataset.attrs["flag_meanings"]).split()))
                    values = np.array([words.get(int(value)) for value in np.ravel(values)], dtype=object).reshape(np.shape(values))
                elif dataset.dtype.kind == "O":
                    values = np.array([_text(word) for word in values], dtype=object)
                columns[name] = Column(values, "-" if unit == "1" else unit, _text(dataset.attrs.get("long_name", "")))
    return columns


def _text(value):
    return value.decode() if isinstance(value, bytes) else str(value)


def is_fit(results):
    """Is it the file of adfric fit?"""
    return {"degrees_of_freedom", "points_used", "n_minima"} <= set(results.fields)


def draw_fit(results):
    """The figure of a fit, or of a stack of fits."""
    if results.several:
        return draw_stack(results)
    columns = read_columns(results.source)
    sets = [DataSet(columns, suffix) for suffix in suffixes_of(columns)]
    profiles = [name for name in _names(columns) if f"{name}_profile" in columns]
    figure, panels = _make_panels(len(sets), bool(profiles))
    for k, data in enumerate(sets):
        _draw_points(panels[0][k], data, columns, k + 1)
        _draw_residuals(panels[1][k], data)
    if profiles:
        name = "lambda" if "lambda" in profiles else profiles[0]
        _draw_profile(panels[2], columns, name)
    return figure


def suffixes_of(columns):
    """What stands behind the names of the columns of each data set: nothing if there is only one."""
    if "ordinate" in columns:
        return [""]
    numbers = sorted(int(name.rsplit("_", 1)[1]) for name in columns if name.startswith("ordinate_") and name.rsplit("_", 1)[1].isdigit())
    return [f"_{number}" for number in numbers]


def _names(columns):
    """Names of the free variables."""
    return [str(name) for name in columns["variable"].values] if "variable" in columns else []


def _make_panels(n_sets, has_profile):
    """Panels for points and residuals of each data set, and one for the profile."""
    heights = [3.0, 1.1] + ([2.0] if has_profile else [])
    figure = plt.figure(figsize=(4.8 if n_sets == 1 else 3.9 * n_sets, sum(heights) * 0.95 + 0.4))
    grid = figure.add_gridspec(len(heights), n_sets, height_ratios=heights)
    above = [figure.add_subplot(grid[0, k]) for k in range(n_sets)]
    below = [figure.add_subplot(grid[1, k], sharex=above[k]) for k in range(n_sets)]
    return figure, (above, below, figure.add_subplot(grid[2, :]) if has_profile else None)


def _draw_points(axes, data, columns, number):
    """Points with their errors by branch, the best curve with its band, the second minimum, and the events."""
    x_name, x_unit = data.about("abscissa")
    y_name, y_unit = data.about("ordinate")
    x, y = data["abscissa"], data["ordinate"]
    x_factor, x_unit = scale_of(x, x_unit)
    y_factor, y_unit = scale_of(y, y_unit)
    sigma = data["sigma"] if data["sigma"] is not None else np.zeros_like(y)
    x_sigma = data["abscissa_sigma"] if data["abscissa_sigma"] is not None else np.zeros_like(x)
    used = data["used"] == "true" if data["used"] is not None else np.isfinite(x * y)
    free = data["branch"] == "free" if data["branch"] is not None else np.zeros(len(x), dtype=bool)
    for here, colour, label in ((used & ~free, CONTACT, "in contact" if np.any(free) else "measured"), (used & free, FREE, "free"),
                                (~used, LEFT_OUT, "left out")):
        if np.any(here & np.isfinite(x * y)):
            axes.errorbar(x[here] * x_factor, y[here] * y_factor, sigma[here] * y_factor, x_sigma[here] * x_factor, color=colour,
                          label=label, **POINT)
    several = data.variable()
    if several is not None:
        _draw_curves(axes, data, several, x_factor, y_factor)
    elif data["curve"] is not None:
        curve_x = data["curve_x"] * x_factor
        axes.fill_between(curve_x, data["band_low"] * y_factor, data["band_high"] * y_factor, color=CURVE["color"], alpha=0.25,
                          linewidth=0, zorder=2.5)
        axes.plot(curve_x, data["curve"] * y_factor, label="best fit, 95 %", **CURVE)
        if data["second_curve"] is not None:
            excess = columns["minima_chi2"].values
            axes.plot(curve_x, data["second_curve"] * y_factor, label=f"second minimum, {excess[1] - excess[0]:+.2g}", **SECOND)
    _draw_events(axes, columns, number, x_name, y_name, x_factor, y_factor)
    if is_logarithmic(x[used] if several is None else np.unique(x[used])):
        axes.set_xscale("log")
    axes.set_ylabel(axis_label(y_name, y_unit))
    axes.legend(loc="best")
    axes.tick_params(labelbottom=False)


def _draw_curves(axes, data, name, x_factor, y_factor):
    """The points and curves of each value of a variable in a colour of its own."""
    points, unit = data[f"point_{name}"], data.columns[f"point_{name}{data.suffix}"].unit
    factor, unit = scale_of(points, unit)
    values = np.unique(points[np.isfinite(points)])
    colours = plt.get_cmap("viridis")(np.linspace(0, 0.85, len(values)))
    for value, colour in zip(values, colours):
        here = points == value
        axes.plot(data["abscissa"][here] * x_factor, data["ordinate"][here] * y_factor, color=colour, marker="o", markersize=2.6, linestyle="none",
                  zorder=2)
        if data["curve"] is not None:
            # curves of other values are left out, and so are the points between two
            curve = np.where(data[f"curve_{name}"] == value, data["curve"], np.nan) * y_factor
            axes.plot(data["curve_x"] * x_factor, curve, color=colour, linewidth=1.0, label=f"{value * factor:.5g} {unit}", zorder=3)


def _draw_events(axes, columns, number, x_name, y_name, x_factor, y_factor):
    """A bar of one standard error to both sides at each event of a data set."""
    if "event_kind" not in columns:
        return
    for kind, data, value, sigma in zip(*(columns[f"event_{name}"].values for name in ("kind", "data", "value", "sigma"))):
        if int(data) != number:
            continue
        label = kind.replace("_", " ")
        for name, factor, draw in ((x_name, x_factor, axes.axvspan), (y_name, y_factor, axes.axhspan)):
            if EVENT_AXES[kind] == name:
                draw((value - sigma) * factor, (value + sigma) * factor, color=COLOURS[3], alpha=0.4, linewidth=0, label=label, zorder=0)
                break


def _draw_residuals(axes, data):
    """Residuals in standard errors, with lines at 1 and 3."""
    x_name, x_unit = data.about("abscissa")
    x_factor, x_unit = scale_of(data["abscissa"], x_unit)
    residual = data["residual"]
    for level, style in ((0, "-"), (1, "--"), (-1, "--"), (3, ":"), (-3, ":")):
        axes.axhline(level, color="0.6", linewidth=0.6, linestyle=style, zorder=0)
    if residual is not None:
        free = data["branch"] == "free" if data["branch"] is not None else np.zeros(len(residual), dtype=bool)
        for here, colour in ((~free, CONTACT), (free, FREE)):
            axes.plot(data["abscissa"][here] * x_factor, residual[here], color=colour, marker="o", markersize=2.2, linestyle="none")
        largest = np.nanmax(np.abs(residual), initial=3.5)
        axes.set_ylim(-1.05 * largest, 1.05 * largest)
    axes.set_xlabel(axis_label(x_name, x_unit))
    axes.set_ylabel("Residual\n(standard errors)")


def _draw_profile(axes, columns, name):
    """S less its least value with one variable held, with both levels, and the minima."""
    values, excess = columns[f"{name}_profile_value"], columns[f"{name}_profile"].values
    unit = columns[name].unit if name in columns else "-"
    factor, unit = scale_of(values.values, unit)
    x = values.values * factor
    axes.plot(x, excess, color=CURVE["color"], marker=".", markersize=2.5, linestyle="none")
    for level, label in LEVELS:
        axes.axhline(level, color="0.5", linewidth=0.7, linestyle="--", zorder=0)
        axes.annotate(label, (1, level), xycoords=("axes fraction", "data"), ha="right", va="bottom", fontsize="small", color="0.4")
    place = _names(columns).index(name)
    for minimum, height in zip(columns["minima"].values[:, place], columns["minima_chi2"].values - columns["minima_chi2"].values[0]):
        axes.plot(minimum * factor, height, marker="v", color=COLOURS[2], linestyle="none", markersize=5, clip_on=False)
    # no wider than what is shown, and a node to both sides
    shown = np.flatnonzero(excess <= MOST_EXCESS)
    if shown.size:
        x = x[max(shown[0] - 1, 0):shown[-1] + 2]
        axes.set_xlim(x[0], x[-1])
    is_log = np.all(x > 0) and x[-1] > 3 * x[0]
    if is_log:
        axes.set_xscale("log")
    axes.plot(*_joined(values.values * factor, excess, is_log), color=CURVE["color"], zorder=3)
    axes.set_ylim(-0.2, MOST_EXCESS)
    axes.set_xlabel(axis_label(name, unit))
    axes.set_ylabel(r"$S - S_{min}$")


def _joined(x, excess, is_log, n_between=20):
    """A profile between its nodes. Its root, with a sign that changes at the least S, is nearly straight: monotone cubics join its nodes
    (F. N. Fritsch, R. E. Carlson, SIAM J. Numer. Anal. 17, 1980, 238)."""
    if len(x) < 3:
        return x, excess
    u = np.log(x) if is_log else x
    root = np.sqrt(np.maximum(excess, 0.0)) * np.where(np.arange(len(x)) < np.argmin(excess), -1, 1)
    step = np.diff(u)
    secant = np.diff(root) / step
    weight = np.stack([2 * step[1:] + step[:-1], step[1:] + 2 * step[:-1]])
    same = secant[1:] * secant[:-1] > 0
    safe = np.where(same, secant[:-1], 1.0), np.where(same, secant[1:], 1.0)
    inner = np.where(same, weight.sum(axis=0) / (weight[0] / safe[0] + weight[1] / safe[1]), 0.0)
    slope = np.concatenate([secant[:1], inner, secant[-1:]])
    t = np.linspace(0, 1, n_between, endpoint=False)[None, :]
    left, right, width = root[:-1, None], root[1:, None], step[:, None]
    between = (left * (1 + 2 * t) * (1 - t)**2 + right * t**2 * (3 - 2 * t)
               + width * t * (1 - t) * (slope[:-1, None] * (1 - t) - slope[1:, None] * t))
    places = np.append((u[:-1, None] + width * t).ravel(), u[-1])
    return np.exp(places) if is_log else places, np.append(between.ravel(), root[-1])**2


def draw_stack(results):
    """An image of each free variable and of Q; of a row of curves, the values with their errors."""
    names = [name for name in results.fields if f"{name}_error" in results.fields and f"{name}_bound" in results.fields]
    if "p_value" in results.fields and np.any(np.isfinite(results.fields["p_value"].values)):
        names.append("p_value")
    if len(results.several) == 1:
        return _draw_row(results, names)
    rows = -(-len(names) // 3)
    figure, panels = plt.subplots(rows, min(3, len(names)), squeeze=False, figsize=(3.1 * min(3, len(names)) + 0.2, 2.7 * rows + 0.2))
    for panel in panels.flat[len(names):]:
        panel.remove()
    # of more than two dimensions the first place along the slower ones
    first = (0,) * (results.status.ndim - 2)
    slow, fast = results.axes[-2], results.axes[-1]
    for panel, name in zip(panels.flat, names):
        field = results.fields[name]
        values = np.squeeze(field.values[first])
        factor, unit = scale_of(values[np.isfinite(values)], field.unit)
        image = panel.imshow(np.ma.masked_invalid(values * factor), origin="lower", aspect="equal", interpolation="nearest",
                             extent=(fast.values[0] - 0.5, fast.values[-1] + 0.5, slow.values[0] - 0.5, slow.values[-1] + 0.5))
        panel.set_facecolor("0.85")
        figure.colorbar(image, ax=panel, shrink=0.85)
        panel.set_title(axis_label(name, unit) if name != "p_value" else "Probability $Q$")
        panel.set_xlabel(fast.name.capitalize())
        panel.set_ylabel(slow.name.capitalize())
    return figure


def _draw_row(results, names):
    """Values with their errors against the number of the curve."""
    axis = results.several[0]
    figure, panels = plt.subplots(len(names), 1, squeeze=False, sharex=True, figsize=(4.8, 1.7 * len(names) + 0.4))
    for panel, name in zip(panels.flat, names):
        field = results.fields[name]
        values = np.ravel(field.values)
        factor, unit = scale_of(values[np.isfinite(values)], field.unit)
        errors = results.fields.get(f"{name}_error")
        panel.errorbar(axis.values, values * factor, None if errors is None else np.ravel(errors.values) * factor, color=CONTACT, **POINT)
        panel.set_ylabel(axis_label(name, unit) if name != "p_value" else "Probability $Q$")
    panels.flat[-1].set_xlabel(axis.name.capitalize())
    return figure
