# SPDX-License-Identifier: GPL-3.0-or-later
"""Points that lie beyond a bound of their theory: hatched in panels along a swept variable, and named below every figure."""

import numpy as np

NONE = "none"
HATCHED = {"facecolor": "none", "edgecolor": "0.75", "hatch": "////", "linewidth": 0.0, "zorder": 0.5}
# behind the points of a curve where others at the same place are not doubted
SHADOW = {"color": "0.82", "linewidth": 7.0, "solid_capstyle": "butt", "zorder": 0.6}


def is_doubted(results):
    """Which points of a sweep lie beyond a bound? None in files that do not say."""
    words = results.states.get("doubt")
    if words is None:
        return None
    return np.vectorize(lambda word: word is not None and word != NONE, otypes=[bool])(words)


def describe_doubts(runs):
    """How many points lie beyond which bound, in a line; empty if none does."""
    counts, points = {}, 0
    for results in runs:
        if is_doubted(results) is None:
            continue
        points += results.status.size
        for word in results.states["doubt"].ravel():
            if word not in (None, NONE):
                counts[word] = counts.get(word, 0) + 1
    if not counts:
        return ""
    parts = [f"{word.replace('_', ' ')} at {count}" for word, count in counts.items()]
    return f"Beyond a bound of the theory: {', '.join(parts)} of {points} points"


def hatch_doubts(panel, x, ys, doubted, logarithmic=False):
    """Hatch where all curves of a panel are doubted, and shade behind a curve where it is and others are not.

    x has the order of the axis; ys and doubted have a row for each curve."""
    doubted = np.asarray(doubted, dtype=bool)
    if not doubted.any():
        return
    everywhere = doubted.all(axis=0)
    edges = edges_of(x, logarithmic)
    for first, last in runs_of(everywhere):
        panel.axvspan(edges[first], edges[last + 1], **HATCHED)
    for y, own in zip(ys, doubted):
        shade_doubts(panel, x, y, own & ~everywhere)


def shade_doubts(panel, x, y, doubted):
    """Shade behind the doubted points of a curve."""
    if doubted.any():
        # a single point has no line
        panel.plot(x, np.where(doubted, y, np.nan), marker="s" if doubted.sum() == 1 else None, markersize=7, **SHADOW)


def edges_of(x, logarithmic):
    """Where the neighbourhood of each point begins, and that of the last one ends."""
    x = np.asarray(x, dtype=float)
    if x.size == 1:
        return np.array([x[0], x[0]])
    middles = np.sqrt(x[1:] * x[:-1]) if logarithmic else (x[1:] + x[:-1]) / 2
    return np.concatenate([x[:1], middles, x[-1:]])


def runs_of(flags):
    """First and last place of each row of true flags."""
    steps = np.diff(np.concatenate([[0], flags.astype(int), [0]]))
    return zip(np.flatnonzero(steps == 1), np.flatnonzero(steps == -1) - 1)
