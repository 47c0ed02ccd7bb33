# SPDX-License-Identifier: GPL-3.0-or-later
"""The command scripts/import_curve for tests, with the Python of its own environment, .venv_curve; and curves to import."""

from environments import SOURCE, restart_in  # noqa: F401

restart_in(".venv_curve", "afmformats")

import numpy as np  # noqa: E402

from importing.curve_command import main as import_main  # noqa: E402
from importing_case import ImportCase  # noqa: E402

# a lever [N/m] and [m/V], a sphere and what it touches: load = STIFFNESS approach^(3/2), less PULL on the way back
SPRING, SENSITIVITY, STIFFNESS, PULL = 0.5, 4e-8, 4e3 / 3, 4e-9


class Curves(ImportCase):
    """Imports of force curves."""

    program = "import_curve"
    import_main = staticmethod(import_main)

    def table(self, name, columns, **form):
        """Write columns by their heads."""
        np.savetxt(name, np.stack(list(columns.values()), axis=1), header=form.pop("separator", ",").join(columns), comments="",
                   **{"delimiter": ",", "fmt": "%.9g", **form})


def make_curve(samples=200, depth=6e-8, free=1.5e-7, dwell=0, noise=0.0, seed=1):
    """Position of the base, load and segment: an approach, a dwell if wanted, and a retraction that sticks until the pull-off."""
    rng = np.random.default_rng(seed)
    tips = np.linspace(-3e-9, depth, 20001)
    hertz = STIFFNESS * np.maximum(tips, 0) ** 1.5
    highest = depth + hertz[-1] / SPRING
    ramp = np.linspace(-free, highest, samples)
    position = np.concatenate([ramp, np.full(dwell, highest), ramp[::-1]])
    segment = np.repeat([0, 1, 2], (samples, dwell, samples))
    in_contact = np.interp(position, tips + hertz / SPRING, hertz)
    sticks = np.interp(position, tips + (hertz - PULL) / SPRING, hertz - PULL, left=0.0)
    load = np.where(segment == 2, sticks, in_contact)
    return position, load + noise * rng.normal(size=load.size), segment
