"""Which figure a run has. The paper is GM: Goryacheva, Makhovskaya, acta mechanica et automatica 5(4), 2011."""

import numpy as np

from .curves import add_key, draw_curves, find_curves
from .results import NothingToDraw
from .style import plt
from .surface import draw_pressure_maps, draw_stresses

# results in the order in which they are worth drawing; others follow
MAIN_RESULTS = ("friction_force", "friction_coefficient", "contact_width", "contact_area", "contact_radius", "approach",
                "penetration", "load", "adhesion_area", "adhesion_radius")
CHECKS = ("error_estimate", "energy_imbalance", "residual")
MOST_PANELS = 6


def choose_figure(results):
    """The procedure that draws a run: by its profiles, by its model and what was swept, or the general one."""
    if "pressure" in results.profiles:
        return draw_pressure_maps if len(results.profile_axes) == 2 else draw_stresses
    several = [axis.name for axis in results.axes if axis.values.size > 1]
    if not several:
        raise NothingToDraw(f"{results.path}: one point without profiles of the pressure: nothing to draw")
    return FIGURES.get((results.model, frozenset(several)), draw_sweep)


def draw_width_and_friction(results):
    """Contact width and friction force against load (GM Fig. 5)."""
    return draw_panels(results, "load", ["contact_width", "friction_force"])


def draw_coefficient(results):
    """Friction coefficient against velocity (GM Fig. 6)."""
    return draw_panels(results, "velocity", ["friction_coefficient"])


def draw_friction(results):
    """Friction force against load (GM Fig. 8)."""
    return draw_panels(results, "load", ["friction_force"])


def draw_sweep(results):
    """Every result worth drawing against the variable that varies fastest among those with several values."""
    several = [axis.name for axis in results.axes if axis.values.size > 1]
    return draw_panels(results, several[-1], choose_results(results))


def choose_results(results):
    """Names of the results that vary, the main ones first."""
    names = [name for name in MAIN_RESULTS if name in results.fields]
    names += [name for name in results.fields if name not in MAIN_RESULTS + CHECKS]
    varying = [name for name in names if _varies(results.fields[name].values)]
    if not varying:
        raise NothingToDraw(f"{results.path}: no result varies: nothing to draw")
    return varying[:MOST_PANELS]


def _varies(values):
    finite = values[np.isfinite(values)]
    return finite.size > 1 and np.ptp(finite) > 1e-12 * np.max(np.abs(finite))


def draw_panels(results, abscissa, ordinates):
    """A panel for each result."""
    curves = find_curves(results, abscissa)
    columns = min(len(ordinates), 2 if len(ordinates) in (2, 4) else 3)
    rows = -(-len(ordinates) // columns)
    size = (4.6, 3.4) if len(ordinates) == 1 else (3.3 * columns, 2.7 * rows + 0.2)
    figure, panels = plt.subplots(rows, columns, squeeze=False, figsize=size)
    for panel in panels.flat[len(ordinates):]:
        panel.remove()
    for panel, ordinate in zip(panels.flat, ordinates):
        draw_curves(panel, results, abscissa, ordinate, curves)
    add_key(figure, panels.flat[0], results, abscissa, curves)
    return figure


# figures of their own, by model and the variables with several values; all others have that of draw_sweep
FIGURES = {
    ("wavy_sliding", frozenset({"load", "stress"})): draw_width_and_friction,
    ("wavy_sliding", frozenset({"load", "stress", "velocity"})): draw_friction,
    ("wavy_sliding", frozenset({"stress", "velocity"})): draw_coefficient,
}
