# SPDX-License-Identifier: GPL-3.0-or-later
"""How figures look."""

import matplotlib.pyplot as plt
from matplotlib.colors import ListedColormap, LogNorm, Normalize, TwoSlopeNorm
from matplotlib.ticker import LogLocator, MaxNLocator, NullFormatter
import numpy as np

# colours that stay apart for every kind of colour vision and in grey
COLOURS = ("#000000", "#d55e00", "#0072b2", "#009e73", "#cc79a7", "#e69f00", "#56b4e9")
DASHES = ((0, (4, 2)), "-", ":", "-.")
MISSED = "#c00000"
# places of a map out of the range of adhesion
FREE = "0.85"
# logarithmic axes up to this ratio have more marks than one in a decade
FEW_DECADES = 100.0


def use_style():
    """A context in which figures are made and saved; outside of it nothing changes."""
    return plt.rc_context({
        "font.size": 9,
        "axes.linewidth": 0.7,
        "axes.spines.top": False,
        "axes.spines.right": False,
        "axes.titlesize": "medium",
        "lines.linewidth": 1.4,
        "legend.frameon": False,
        "legend.fontsize": "small",
        "xtick.labelsize": "small",
        "ytick.labelsize": "small",
        "figure.constrained_layout.use": True,
        "figure.constrained_layout.w_pad": 0.12,
        "figure.constrained_layout.h_pad": 0.1,
        "axes.labelpad": 5.0,
        "axes.titlepad": 7.0,
        "savefig.dpi": 200,
        "pdf.fonttype": 42,
        "svg.fonttype": "none",
    })


def make_panels(count, size=(3.3, 2.8), alone=(4.8, 3.5), shared=False):
    """Panels of a size, or one of another size, in rows of two or three; with common axes if they are shared."""
    columns = min(count, 2 if count == 4 else 3)
    rows = -(-count // columns)
    figure, panels = plt.subplots(rows, columns, squeeze=False, sharex=shared, sharey=shared,
                                  figsize=alone if count == 1 else (size[0] * columns + 0.2, size[1] * rows + 0.2))
    for panel in panels.flat[count:]:
        # panels that share their axes have the labels of the row below
        panel.set_visible(False) if shared else panel.remove()
    return figure, list(panels.flat[:count])


def is_logarithmic(values):
    """Are these values spread over decades in even ratios?"""
    values = np.unique(np.asarray(values, dtype=float))
    if values.size < 3 or not values[0] > 0 or values[-1] < 10 * values[0]:
        return False
    steps = np.diff(np.log(values))
    return bool(steps.min() > 0 and steps.max() < 3 * steps.min())


def has_few_decades(values):
    """Do positive values span so little that the marks of decades alone would be few?"""
    return np.max(values) <= (1 + 1e-9) * FEW_DECADES * np.min(values)


def label_few_decades(axes, values):
    """Marks at 1, 2, 5, 10 ... in plain numbers along a logarithmic axis x that spans few decades."""
    if has_few_decades(values):
        axes.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
        axes.xaxis.set_major_formatter("{x:g}")
        axes.xaxis.set_minor_formatter(NullFormatter())


def norm_of(values):
    """Colours along a swept variable."""
    kind = LogNorm if is_logarithmic(values) else Normalize
    return kind(np.min(values), np.max(values))


def pressure_colours(lowest, highest):
    """Compression red, tension blue, white where there is no pressure."""
    strongest = max(abs(lowest), abs(highest)) or 1.0
    where = np.linspace(min(lowest, 0), max(highest, 0), 256)
    colours = plt.get_cmap("RdBu_r")(0.5 + 0.5 * where / strongest)
    return ListedColormap(colours), Normalize(where[0], where[-1])


def adhesion_colours(lowest, highest):
    """Compression red, tension blue, each up to its largest value: the stress of adhesion is seen beside a larger pressure; places
    without a value are those without adhesion."""
    # a black line is seen on either end
    colours = ListedColormap(plt.get_cmap("RdBu_r")(np.linspace(0.12, 0.92, 256)))
    return colours.with_extremes(bad=FREE), TwoSlopeNorm(0.0, lowest, highest if highest > 0 else -lowest)


def adhesion_ticks(lowest, highest):
    """Marks beside such colours, on both sides of 0."""
    marks = [MaxNLocator(most).tick_values(*ends) for most, ends in ((3, (lowest, 0.0)), (5, (0.0, highest)))]
    return [mark for mark in np.unique(marks[0].tolist() + marks[1].tolist()) if lowest <= mark <= highest]
