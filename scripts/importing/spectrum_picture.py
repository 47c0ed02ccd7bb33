# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of a joined spectrum."""

import numpy as np

from plotting.style import COLOURS, plt, use_style

from .picture import bytes_of, positive, use_decades

# bars are at most a factor of the exponential of this
WIDEST = 1.5


@use_style()
def draw_joined(joined, periodograms, title):
    """The density with its error, and what each measurement is over it: the bytes of a PNG file."""
    figure, (panel, ratio) = plt.subplots(1, 2, figsize=(8.6, 3.4))
    q, density = joined.wave_numbers, joined.density
    wide = np.exp(np.sqrt(np.diag(joined.covariance)))
    panel.fill_between(q, density / wide, density * wide, color=COLOURS[2], alpha=0.3, linewidth=0)
    panel.plot(q, density, color=COLOURS[2], label="joined")
    ratio.axhline(1, color="0.6", linewidth=0.8)
    for k, (each, model) in enumerate(zip(periodograms, joined.models)):
        middle = np.exp(np.sum(each.shares * np.log(each.waves), axis=1))
        colour, name = COLOURS[k % len(COLOURS)], each.name if len(each.name) < 24 else each.name[:21] + "..."
        # bars of a factor, which stay above 0
        value, wide = each.density / model, np.exp(np.minimum(1 / np.sqrt(each.weight), WIDEST))
        ratio.errorbar(middle, value, [value - value / wide, value * wide - value], fmt="o" if each.is_map else "s",
                       color=colour, markersize=3, linewidth=0.8, label=name)
        if each.is_map:
            panel.plot(middle, each.density, "o", color=colour, markersize=3)
    panel.set_ylabel("Density $C$ (m⁴)")
    use_decades(panel, "y", positive(density))
    panel.legend()
    ratio.set(yscale="log", ylabel="Measured over joined")
    ratio.legend(fontsize="x-small")
    for each in (panel, ratio):
        use_decades(each, "x", q)
        each.set_xlabel("Wave number $q$ (rad/m)")
    figure.tight_layout()
    return bytes_of(figure, title)
