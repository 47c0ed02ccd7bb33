# SPDX-License-Identifier: GPL-3.0-or-later
"""Compute the tables of docs/guide/columns.md from the inputs: scripts/tables [PROGRAM]."""

from table_tools import head, row, solve

PERIOD, PRESSURE = 1.0e-3, "0.2e6"
VELOCITIES = [1e-4, 1e-2, 1.0]
THICKNESSES = (0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0)
CELLS = "1024"


def slide(extent, thickness=None, **changes):
    """Results of the wave of wave_1d_sliding on one solid."""
    return solve("wave_1d_sliding", operating__mean_pressure=PRESSURE, operating__velocity=VELOCITIES, solid__extent=f"'{extent}'",
                 solid__thickness=None if thickness is None else repr(thickness * PERIOD), **changes)


def main():
    half_space = slide("half_space")
    solved = [(thickness, slide("foundation", thickness), slide("layer", thickness, solid__base="'frictionless'", numerics__cells=CELLS))
              for thickness in THICKNESSES]
    for name, words in (("friction_coefficient", "Friction coefficient"), ("contact_fraction", "Contact fraction")):
        head(f"{words} of one wave on columns, on a layer, and on a half-space", "thickness over wave", "velocity [m/s]", "columns", "layer",
             "half-space", "columns over layer", "half-space over layer")
        for thickness, columns, layer in solved:
            for i, velocity in enumerate(VELOCITIES):
                values = [results[name][i] for results in (columns, layer, half_space)]
                row(f"{thickness:g}", f"{velocity:g}", *(f"{value:.4g}" for value in values), *(f"{values[k] / values[1]:.3f}" for k in (0, 2)))


if __name__ == "__main__":
    main()
