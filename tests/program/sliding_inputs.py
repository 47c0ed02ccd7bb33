# SPDX-License-Identifier: GPL-3.0-or-later
"""The shipped inputs of sliding that stand side by side: cells beside a closed form, and a thin layer beside the strips it stands for."""

import re
import sys
import unittest
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from input_runs import SOURCE, InputRuns  # noqa: E402
from plotting import figures, split  # noqa: E402
from plotting.results import Results  # noqa: E402


class SlidingInputs(InputRuns):
    def assert_within(self, values, expected, bounds):
        np.testing.assert_array_less(abs(values - expected), bounds)

    def test_wave_on_cells(self):
        """Friction and share in contact are those of the closed form within their own errors, the shift within a cell."""
        exact = self.solve("wave_1d_sliding", **{"count = 241": "count = 13"})
        cells = self.solve("wave_1d_sliding_cells", **{"count = 25": "count = 13"})
        np.testing.assert_array_equal(cells["velocity"], exact["velocity"])
        np.testing.assert_array_equal(cells["mean_pressure"], exact["mean_pressure"])
        # the slowest friction is small, and known to a part of a hundred
        self.assertLess(cells["error_estimate"].max(), 0.02)
        self.assert_within(cells["friction_stress"] / exact["friction_stress"], 1, cells["error_estimate"])
        # in full contact both are 1
        self.assert_within(cells["contact_fraction"], exact["contact_fraction"], cells["contact_fraction_error"] + np.finfo(float).eps)
        partial = exact["regime"] == cells["regime"]
        partial &= np.isfinite(exact["contact_shift"])
        self.assertGreater(partial.sum(), 20)
        self.assert_within(cells["contact_shift"][partial], exact["contact_shift"][partial], cells["period"] / 4096)

    def test_layer_and_strips(self):
        """A thin layer has the friction of its foundation within the error of its cells, a thick one has not. The layer itself is 1e-4
        away: 1.2e-4 for a wave of k H = 0.1, which only the shortest waves here have."""
        few = {"to = 1.0e2": "to = 1.0e0", "from = 1.0e-6": "from = 1.0e-4"}
        self.make_surface("surface_sliding_layer", 256)
        layer = self.solve("surface_sliding_layer", **few, **{"count = 17": "count = 3"})
        strips = self.solve("surface_sliding_strips", **few, **{"count = 65": "count = 3"})
        for name in ("velocity", "mean_pressure", "thickness", "young_modulus", "poisson_ratio"):
            np.testing.assert_array_equal(layer[name], strips[name])
        for name in ("young_moduli", "relaxation_times"):
            lists = [re.search(rf"{name} =[^\n]*((?:\n +[0-9][^\n]*)+)", (SOURCE / "inputs" / f"surface_sliding_{kind}.nml").read_text())[1]
                     for kind in ("layer", "strips")]
            self.assertEqual(*lists)
        np.testing.assert_allclose(strips["stiffness"], layer["modulus"] / layer["thickness"], rtol=1e-14)
        self.assertLess(layer["error_estimate"].max(), 0.05)
        self.assert_within(layer["friction_coefficient"] / strips["friction_coefficient"], 1, layer["error_estimate"] + 1.2e-4)
        thick = {"thickness = 6.0e-5": "thickness = 6.0e-3"}
        layer = self.solve("surface_sliding_layer", **few, **thick, **{"count = 17": "count = 3"})
        strips = self.solve("surface_sliding_strips", **few, **thick, **{"count = 65": "count = 3"})
        np.testing.assert_array_less(3 * layer["error_estimate"], abs(layer["friction_coefficient"] / strips["friction_coefficient"] - 1))

    def test_all_parts(self):
        """Losses, adhesion, interface and heat in one scene: the parts make the friction, and the figure shows each as an area."""
        found = self.solve("rubber_all_parts", **{"cells = 512": "cells = 64", "count = 61": "count = 11"})
        total, losses, interface = (found[name] for name in ("friction_stress", "hysteretic_friction_stress", "interfacial_friction_stress"))
        np.testing.assert_allclose(losses + interface, total, rtol=1e-12)
        # slow rubber loses nothing; where losses are, adhesion adds to them
        self.assertGreater(interface[0]/total[0], 0.9999)
        self.assertLess(interface[-1]/total[-1], 0.1)
        np.testing.assert_array_less(found["friction_stress_without_adhesion"][4:9], losses[4:9])
        self.assertGreater(found["flash_temperature"].max(), 1e-3)
        self.assertLess(found["flash_temperature"].max(), 0.03)
        results = Results(self.folder / "run.h5")
        self.assertIs(figures.choose_figure(results), split.draw_split)
        figure = split.draw_split(results)
        self.assertEqual([text.get_text() for text in figure.axes[0].get_legend().get_texts()],
                         ["losses without adhesion", "losses by adhesion", "interface"])
        self.assertIn("K)", figure.axes[3].get_ylabel())


if __name__ == "__main__":
    unittest.main()
