# SPDX-License-Identifier: GPL-3.0-or-later
"""Small results files made here, and the plot script run on them."""

import contextlib
import io
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

SCRIPTS = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(SCRIPTS))

from plotting import command, halfspace  # noqa: E402
from plotting.style import plt  # noqa: E402

UNITS = {"stress": "Pa", "velocity": "m/s", "load": "N/m", "x": "m", "y": "m", "pressure": "Pa", "gap": "m",
         "friction_force": "N/m", "contact_width": "m", "friction_coefficient": "-", "radius": "m", "mean_pressure": "Pa",
         "friction_stress": "Pa", "full_contact_friction": "Pa"}

SPHERE = ("load", "approach", "contact_radius", "adhesion_radius", "friction_radius", "stick_radius", "friction_area",
          "pull_off_load")
HALFSPACE = {"hertz": ("contact_half_width", "minor_half_width", "peak_pressure", "approach"),
             "wave_1d": ("contact_fraction", "peak_pressure", "mean_gap", "largest_gap", "full_contact_pressure"),
             "wave_2d_elastic": ("contact_fraction", "contact_fraction_error", "full_contact_pressure"),
             "surface_elastic": ("contact_fraction", "adhesion_fraction", "mean_gap"),
             "surface_sliding": ("contact_fraction", "friction_stress", "full_contact_friction"),
             "rigid_punch": ("mean_pressure",), "line_load": ()}
STRESS_MODELS = ("line_load", "rigid_punch")
STATES = {"stable": "no_value unstable stable", "theory_used": "no_value hertz jkr dmt maugis_dugdale"}


def make_file(path, axes, profile_axes=(), model="wavy_sliding"):
    """A file as adfric writes it, with made-up values; its last point did not converge."""
    with h5py.File(path, "w") as file:
        file.attrs.update(model=model, adfric_version="0.0.0", title="A title", input="&job /")
        file["blocks/strips_per_point"] = np.ones(2)
        for name, values in [*axes, *profile_axes]:
            file[name] = np.asarray(values, dtype=float)
            file[name].make_scale(name)
        shape = [len(values) for _, values in axes]
        status = np.zeros(shape, dtype="i1")
        if axes:
            status[..., -1] = 2
        values = np.where(status == 0, np.linspace(0.0, 1.0, max(status.size, 1)).reshape(shape), np.nan)
        fields = {name: values for name in ("friction_force", "contact_width", "friction_coefficient")}
        if model == "sphere":
            fields.update({name: values for name in SPHERE if name not in dict(axes)})
            fields.update({name: np.where(status == 0, 1, -1).astype("i1") for name in STATES})
        fields.update({name: values + 1 for name in HALFSPACE.get(model, ())})
        fields["status"] = status
        if profile_axes:
            surface = [*shape, *(len(values) for _, values in profile_axes)]
            if model in STRESS_MODELS and len(profile_axes) == 2:
                fields.update({name: np.linspace(-3.0, 5.0, int(np.prod(surface))).reshape(surface) ** 3
                               for name in ("stress_xx_map", "stress_yy_map", "stress_xy_map", "largest_shear_stress_map")})
            fields["pressure"] = np.linspace(-1.0, 2.0, int(np.prod(surface))).reshape(surface)
            fields["gap"] = np.maximum(fields["pressure"], 0.0)
            fields["shear_stress"] = fields["pressure"]
        for name, data in fields.items():
            file[name] = data
            scales = [*axes, *profile_axes][: np.ndim(data)]
            for dimension, (scale, _) in zip(file[name].dims, scales):
                dimension.attach_scale(file[scale])
        for name in file:
            file[name].attrs["units"] = UNITS.get(name, "1")
            if name in STATES:
                file[name].attrs["flag_meanings"] = STATES[name]
                file[name].attrs["flag_values"] = np.arange(-1, len(STATES[name].split()) - 1, dtype="i1")


class PlotCase(unittest.TestCase):
    """A folder of its own for each test, and no figure left open."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        # what a test has drawn and not closed
        self.addCleanup(plt.close, "all")
        self.folder = Path(folder.name)
        self.file = self.folder / "run.h5"

    def plot(self, *options):
        """Exit status and what stands on the error output."""
        errors = io.StringIO()
        with contextlib.redirect_stderr(errors), contextlib.redirect_stdout(io.StringIO()):
            try:
                status = command.main([str(self.file), *options])
            except SystemExit as end:
                status = end.code
        return status, errors.getvalue()

    def assert_refused(self, words, *options, expected=2):
        status, errors = self.plot(*options)
        self.assertEqual(status, expected)
        self.assertIn(words, errors)
        self.assertEqual(errors.count("\n"), 1)
        self.assertEqual(list(self.folder.glob("*.p*")), [])
