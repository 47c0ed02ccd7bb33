# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of what was read."""

import io

import numpy as np
from matplotlib.ticker import NullFormatter

from plotting.labels import scale_of
from plotting.printable import printable
from plotting.style import COLOURS, plt, use_style

# a longer line is drawn by the lowest and highest samples of so many parts
MOST_DRAWN = 4000
# what is so small a part of the largest value is not drawn on logarithmic axes
ROUND_OFF = 1e-20
# the colours end at these percentiles of the heights, so that a few pits do not take them all
COLOURED = (0.1, 99.9)
# maps of other ratios of their sides are drawn with other scales along x and y
WIDEST = 4.0
# samples stay so far from the ends of a logarithmic axis [decades]
EDGE = 0.05


@use_style()
def draw_surface(surface, results, title):
    """Heights, power spectra and the distribution of heights: the bytes of a PNG file."""
    is_line = surface.heights.ndim == 1
    if is_line:
        figure, panels = plt.subplot_mosaic([["heights", "heights"], ["spectrum", "distribution"]], figsize=(7.2, 5.2))
        draw_line(panels["heights"], surface)
    else:
        figure, panels = plt.subplot_mosaic([["heights", "spectrum", "distribution"]], figsize=(11.0, 3.5))
        draw_map(figure, panels["heights"], surface)
    draw_spectra(panels["spectrum"], results)
    draw_distribution(panels["distribution"], results)
    return bytes_of(figure, title)


def draw_line(panel, surface):
    """Heights along a line."""
    x, z = (np.arange(surface.samples[0]) + 0.5) * surface.spacing[0], surface.heights.data
    if len(z) > 2 * MOST_DRAWN:
        parts = np.array_split(np.arange(len(z)), MOST_DRAWN)
        kept = sorted({place for part in parts for place in (part[z[part].argmin()], part[z[part].argmax()])})
        x, z = x[kept], z[kept]
    factor, unit = scale_of(x, "m")
    height_factor, height_unit = scale_of(z, "m")
    panel.plot(x * factor, z * height_factor, color=COLOURS[2], linewidth=0.8)
    panel.set_xlabel(f"$x$ ({unit})")
    panel.set_ylabel(f"Height $z$ ({height_unit})")
    panel.margins(x=0)


def draw_map(figure, panel, surface):
    """Heights over x and y."""
    factor, unit = scale_of(surface.lengths, "m")
    height_factor, height_unit = scale_of(surface.heights.data, "m")
    lowest, highest = np.percentile(surface.heights.data, COLOURED) * height_factor
    right, top = (length * factor for length in surface.lengths)
    image = panel.imshow(surface.heights.data * height_factor, origin="lower", extent=(0, right, 0, top), cmap="viridis",
                         vmin=lowest, vmax=highest, interpolation="antialiased",
                         aspect="equal" if 1 / WIDEST < right / top < WIDEST else "auto")
    panel.set_xlabel(f"$x$ ({unit})")
    panel.set_ylabel(f"$y$ ({unit})")
    figure.colorbar(image, ax=panel, label=f"Height $z$ ({height_unit})", shrink=0.85, extend="both")


def draw_spectra(panel, results):
    """Power spectra, each on its axis."""
    waves, density = results.binned
    panel.plot(waves, positive(density), color=COLOURS[0], label="along $x$")
    panel.set(xlabel="Wave number $q$ (rad/m)", ylabel=r"$C^\mathrm{1D}$ (m³)", title="Power spectral density")
    use_decades(panel, "x", waves)
    use_decades(panel, "y", positive(density))
    for spectrum in results.spectra[1:]:
        other = panel.twinx()
        other.spines["right"].set_visible(True)
        other.plot(spectrum.wave_numbers, positive(spectrum.density), color=COLOURS[1], linestyle="--")
        use_decades(other, "y", positive(spectrum.density))
        other.set_ylabel(r"$C^\mathrm{2D}$ (m⁴)", color=COLOURS[1])
        other.tick_params(axis="y", colors=COLOURS[1], which="both")
        panel.plot([], [], color=COLOURS[1], linestyle="--", label="all directions")
        panel.legend(loc="lower left")


def positive(values):
    """Values for a logarithmic axis: nothing below the round-off of the largest one."""
    return np.ma.masked_less_equal(values, ROUND_OFF * np.max(values))


def use_decades(panel, name, values):
    """A logarithmic axis over whole decades, which alone have numbers."""
    panel.set(**{f"{name}scale": "log"})
    axis = getattr(panel, f"{name}axis")
    axis.set_minor_formatter(NullFormatter())
    decades = np.log10([np.min(values), np.max(values)]) + (-EDGE, EDGE)
    getattr(panel, f"set_{name}lim")(*10.0 ** np.array([np.floor(decades[0]), np.ceil(decades[1])]))


def draw_distribution(panel, results):
    """The distribution of heights beside a Gaussian of the same mean and width."""
    z, density = results.distribution
    factor, unit = scale_of(z, "m")
    panel.stairs(density / factor, bin_edges(z) * factor, fill=True, color=COLOURS[6], label="measured")
    mean, deviation = np.average(z, weights=density), results.moments[0].value
    fine = np.linspace(z[0], z[-1], 200)
    bell = np.exp(-((fine - mean) / deviation) ** 2 / 2) / (deviation * np.sqrt(2 * np.pi))
    panel.plot(fine * factor, bell / factor, color=COLOURS[0], linestyle="--", label="Gaussian")
    panel.set(xlabel=f"Height $z$ ({unit})", ylabel=f"Density (1/{unit})", title="Distribution of heights")
    panel.set_ylim(top=1.25 * max(density.max(), bell.max()) / factor)
    panel.legend(loc="upper right")


def bin_edges(middles):
    """Edges of bins of equal width."""
    half = (middles[1] - middles[0]) / 2
    return np.append(middles - half, middles[-1] + half)


@use_style()
def draw_master_curve(curve, title):
    """Storage and loss modulus and their ratio over the angular frequency: the bytes of a PNG file."""
    figure, (panel, ratio) = plt.subplots(1, 2, figsize=(7.6, 3.2))
    factor, unit = scale_of(np.append(curve.storage, curve.loss), "Pa")
    panel.plot(curve.omega, curve.storage * factor, "o-", color=COLOURS[2], markersize=3, label="storage $E'$")
    panel.plot(curve.omega, positive(curve.loss) * factor, "s--", color=COLOURS[1], markersize=3, label="loss $E''$")
    panel.set(ylabel=f"Modulus ({unit})")
    use_decades(panel, "y", positive(np.append(curve.storage, curve.loss) * factor))
    panel.legend()
    ratio.plot(curve.omega, curve.loss / curve.storage, "o-", color=COLOURS[0], markersize=3)
    ratio.set(ylabel="Loss tangent $E''/E'$")
    for each in (panel, ratio):
        use_decades(each, "x", curve.omega)
        each.set_xlabel(r"Angular frequency $\omega$ (rad/s)")
    return bytes_of(figure, f"{title}, {curve.temperature:g} K")


def bytes_of(figure, title):
    """The PNG file of a figure under its title."""
    # a name of a file is no formula
    figure.suptitle(printable(title).replace("$", r"\$"), fontsize="medium")
    image = io.BytesIO()
    figure.savefig(image, format="png")
    plt.close(figure)
    return image.getvalue()
