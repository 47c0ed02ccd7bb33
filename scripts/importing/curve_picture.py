# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of what was read from force curves."""

import numpy as np

from plotting.labels import scale_of
from plotting.style import COLOURS, plt, use_style

from .curve_stack import per_curve
from .curve_treatment import APPROACH, DWELL, RETRACTION
from .picture import bytes_of

# so many curves are drawn in full, and more of a stack only by their outlines
MOST_CURVES = 30
DRAWN = ((APPROACH, COLOURS[2], "approach"), (DWELL, COLOURS[5], "dwell"), (RETRACTION, COLOURS[1], "retraction"))


@use_style()
def draw_stack(stack, title):
    """Load against the position of the tip, and over a map the largest and least load: the bytes of a PNG file."""
    used = [curve for curve in stack.curves if curve and curve.columns]
    is_map = len(stack.shape) == 2
    figure, panels = plt.subplots(1, 3 if is_map else 2, figsize=(11.0, 3.4) if is_map else (7.6, 3.3))
    shown = used[::-(-len(used) // MOST_CURVES)]
    middle = min(used, key=lambda curve: abs(np.ptp(curve.columns["load"]) - np.median([np.ptp(one.columns["load"]) for one in used])))
    draw_curves(panels[0], shown, f"{len(shown)} of {len(used)} curves" if len(shown) < len(used) else
                f"{len(used)} curves" if len(used) > 1 else "")
    if is_map:
        for panel, get, label in ((panels[1], np.max, "Largest load"), (panels[2], np.min, "Least load")):
            draw_map(figure, panel, stack, get, label)
    else:
        draw_curves(panels[1], [middle], f"{middle.name}, contact marked" if len(used) > 1 else "contact marked", marks=True)
    return bytes_of(figure, title)


def draw_curves(panel, curves, title, marks=False):
    """Load of curves against the position of the tip, each from its place of largest load, by segments."""
    # zeros of the positions of instruments say nothing: curves begin where they are least loaded in contact
    places = [curve.columns["approach"] - touch_of(curve) for curve in curves]
    factor, unit = scale_of(np.concatenate(places), "m")
    load_factor, load_unit = scale_of(np.concatenate([curve.columns["load"] for curve in curves]), "N")
    named = set()
    for curve, place in zip(curves, places):
        for number, colour, name in DRAWN:
            part = curve.segment == number
            if not part.any():
                continue
            panel.plot(np.where(part, place, np.nan) * factor, curve.columns["load"] * load_factor, color=colour,
                       linewidth=0.8 if len(curves) > 1 else 1.2, alpha=0.6 if len(curves) > 3 else 1.0,
                       label=None if number in named else name)
            named.add(number)
        if marks:
            for state, colour, name in ((0, "0.6", "free"), (np.nan, COLOURS[4], "not clear")):
                is_state = np.isnan(curve.contact) if np.isnan(state) else curve.contact == state
                panel.plot(place[is_state] * factor, curve.columns["load"][is_state] * load_factor, ".", color=colour, markersize=3,
                           label=name if is_state.any() else None, zorder=0)
    panel.set(xlabel=f"Tip towards the surface ({unit})", ylabel=f"Load ({load_unit})", title=title)
    panel.legend(loc="best")


def touch_of(curve):
    """Where a curve first is in contact; its end where it never is."""
    inside = curve.columns["approach"][curve.contact == 1]
    return inside.min() if inside.size else curve.columns["approach"].max()


def draw_map(figure, panel, stack, get, label):
    """A number of each curve over the map; curves that are not used are crossed out."""
    values = per_curve(stack, lambda curve: get(curve.columns["load"]) if curve.columns else np.nan)
    factor, unit = scale_of(values, "N")
    edges = [edges_of(axis) for axis in stack.axes]
    length_factor, length_unit = scale_of(np.concatenate(edges), "m") if stack.unit == "m" else (1.0, "index")
    image = panel.pcolormesh(edges[0] * length_factor, edges[1] * length_factor, values * factor, cmap="viridis")
    bad = np.argwhere(per_curve(stack, lambda curve: curve.status != "used", False))
    panel.plot([stack.axes[0][i] * length_factor for _, i in bad], [stack.axes[1][j] * length_factor for j, _ in bad], "x",
               color=COLOURS[1], markersize=4)
    panel.set(xlabel=f"$x$ ({length_unit})", ylabel=f"$y$ ({length_unit})", title="x: not used" if len(bad) else None)
    panel.set_aspect("equal")
    figure.colorbar(image, ax=panel, label=f"{label} ({unit})", shrink=0.85)


def edges_of(middles):
    """Edges of cells around their middles."""
    if len(middles) == 1:
        return np.array([middles[0] - 0.5, middles[0] + 0.5])
    half = np.diff(middles) / 2
    return np.concatenate([[middles[0] - half[0]], middles[:-1] + half, [middles[-1] + half[-1]]])
