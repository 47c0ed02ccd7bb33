# SPDX-License-Identifier: GPL-3.0-or-later
"""A sketch of a scene as SVG, not to scale: a body, the solid below, and what acts on them."""

import math
from html import escape

WIDTH, HEIGHT = 560, 300
# middle, half width and height of the body; where the solid begins and ends
MIDDLE, HALF, TALL, SURFACE, BOTTOM = 190, 120, 80, 160, 240
SAMPLES = 120
LETTERS = 46
# the heights of a body above its lowest point, over the half width, from -1 to 1
SHAPES = {
    "paraboloid": lambda x: x * x,
    "sphere": lambda x: 1 - math.sqrt(max(1 - x * x, 0.0)),
    "ellipsoid": lambda x: 1 - math.sqrt(max(1 - x * x, 0.0)),
    "cylinder": lambda x: 1 - math.sqrt(max(1 - x * x, 0.0)),
    "cone": abs,
    "wedge": abs,
    "power": lambda x: x**4,
    "polynomial": lambda x: 0.6 * x * x + 0.4 * x**6,
    "line_polynomial": lambda x: 0.6 * x * x + 0.4 * x**6,
    "flat_punch": lambda x: 0.0 if abs(x) < 0.6 else 1.0,
    "line_punch": lambda x: 0.0 if abs(x) < 0.6 else 1.0,
    "flat_cone": lambda x: max(abs(x) - 0.35, 0.0) / 0.65,
    "flat_paraboloid": lambda x: max(x * x - 0.12, 0.0) / 0.88,
    "rounded_punch": lambda x: (max(abs(x) - 0.5, 0.0) / 0.5)**2,
    "rounded_cone": lambda x: (math.hypot(x, 0.3) - 0.3) / (math.hypot(1, 0.3) - 0.3),
    "indenter": lambda x: x * x,
}
WAVES = ("wave_1d", "wave_2d", "wave_product", "wave_3d")
ROUGH = ("cosines", "profile", "heights")
# kinds of given loads, which have no body
LOADS = ("line", "strip", "point")


def height_of(kind, x):
    """The height of a body above its lowest point at x, from 0 to 1."""
    if kind in WAVES:
        return 0.5 - 0.5 * math.cos(3 * math.pi * x)
    if kind in ROUGH:
        return 0.5 - sum(size * math.cos(k * x + shift) for size, k, shift in ((0.22, 5, 0.3), (0.15, 11, 1.9), (0.08, 23, 0.7), (0.04, 47, 2.6)))
    return SHAPES.get(kind, SHAPES["paraboloid"])(x)


def sketch_of(scene):
    """The sketch of a scene."""
    sentence, parts = scene.sentence, []
    is_foundation = "foundation" in sentence or "columns" in sentence
    is_layer = "layer" in sentence
    parts += _foundation() if is_foundation else _solid(is_layer)
    if scene.kind in LOADS or "traction" in dict(scene.groups):
        parts += [_arrow(MIDDLE + shift, SURFACE - 50, MIDDLE + shift, SURFACE - 3) for shift in (-40, -20, 0, 20, 40)]
    else:
        parts += _body(scene.kind)
        parts.append(_arrow(MIDDLE, 14, MIDDLE, 52))
    if "sliding" in sentence or "friction" in sentence or "tangential" in sentence or scene.has("friction"):
        parts.append(_arrow(MIDDLE + 40, 34, MIDDLE + 105, 34))
    if "adhesion" in sentence or scene.has("adhesion"):
        parts += [_arrow(MIDDLE + x, SURFACE - 13, MIDDLE + x, SURFACE + 8, "#0072b2") for x in (-64, -52, 52, 64)]
    labels = [(58, "operating", 3, "#000000"), (104, "surface", 3, "#000000"), (150, "adhesion", 2, "#0072b2"), (186, "friction", 2, "#d55e00"),
              (218, "solid", 3, "#000000")]
    for top, name, most, colour in labels:
        parts += [f"<text x='345' y='{top + 14 * k}' fill='{colour}'>{escape(text[:LETTERS])}</text>" for k, text in enumerate(scene.part(name, most))]
    return (f"<svg class='sketch' role='img' viewBox='0 0 {WIDTH} {HEIGHT}' xmlns='http://www.w3.org/2000/svg'>"
            f"<title>{escape(sentence)}, not to scale</title>{''.join(parts)}"
            f"<text x='{MIDDLE}' y='{HEIGHT - 14}' text-anchor='middle' fill='#777777'>sketch, not to scale</text></svg>")


def _body(kind):
    """The body, its lowest point a little below the surface of the solid."""
    lowest = SURFACE + 6
    xs = [2 * k / SAMPLES - 1 for k in range(SAMPLES + 1)]
    points = [(MIDDLE + HALF * x, lowest - TALL * (0.45 if kind in WAVES + ROUGH else 1.0) * height_of(kind, x)) for x in xs]
    top = SURFACE - TALL - 22
    outline = [(MIDDLE - HALF, top), *points, (MIDDLE + HALF, top)]
    return [f"<path d='M{' L'.join(f'{x:.1f},{y:.1f}' for x, y in outline)} Z' fill='#c9ced6' stroke='#333333' stroke-width='1.4'/>"]


def _solid(is_layer):
    """A half-space, or a layer on a base."""
    left, right = MIDDLE - 165, MIDDLE + 145
    parts = [f"<rect x='{left}' y='{SURFACE}' width='{right - left}' height='{BOTTOM - SURFACE}' fill='#f1e4cf'/>",
             f"<line x1='{left}' y1='{SURFACE}' x2='{right}' y2='{SURFACE}' stroke='#333333'/>"]
    return parts + (_base(left, right) if is_layer else [])


def _foundation():
    """Columns side by side, each as a spring, on a base."""
    left, right = MIDDLE - 165, MIDDLE + 145
    springs = []
    for x in range(left + 10, right, 20):
        steps = [(x + (5 if k % 2 else -5), SURFACE + 8 + k * (BOTTOM - SURFACE - 16) / 8) for k in range(9)]
        points = [(x, SURFACE), *steps, (x, BOTTOM)]
        springs.append(f"<polyline points='{' '.join(f'{a:.1f},{b:.1f}' for a, b in points)}' fill='none' stroke='#b08a4a'/>")
    return [*springs, f"<line x1='{left}' y1='{SURFACE}' x2='{right}' y2='{SURFACE}' stroke='#333333'/>", *_base(left, right)]


def _base(left, right):
    """A rigid base."""
    hatch = [f"<line x1='{x}' y1='{BOTTOM}' x2='{x - 8}' y2='{BOTTOM + 9}' stroke='#777777'/>" for x in range(left + 8, right + 1, 12)]
    return [f"<line x1='{left}' y1='{BOTTOM}' x2='{right}' y2='{BOTTOM}' stroke='#333333'/>", *hatch]


def _arrow(x1, y1, x2, y2, colour="#333333"):
    """An arrow."""
    length = math.hypot(x2 - x1, y2 - y1)
    ex, ey = (x2 - x1) / length, (y2 - y1) / length
    size = min(9, length / 2)
    back = (x2 - size * ex, y2 - size * ey)
    wings = [(back[0] + s * 0.45 * size * ey, back[1] - s * 0.45 * size * ex) for s in (1, -1)]
    head = " ".join(f"{x:.1f},{y:.1f}" for x, y in [(x2, y2), *wings])
    return (f"<line x1='{x1}' y1='{y1}' x2='{back[0]:.1f}' y2='{back[1]:.1f}' stroke='{colour}' stroke-width='1.6'/>"
            f"<polygon points='{head}' fill='{colour}'/>")
