# SPDX-License-Identifier: GPL-3.0-or-later
"""Adhesion and friction of real surfaces.

>>> import adfric, numpy as np
>>> tip = adfric.solve(surface={"kind": "paraboloid", "radius": 140e-9}, solid={"contact_modulus": 50e9},
...                    adhesion={"work_of_adhesion": 0.2, "adhesion_stress": 5e9}, operating={"load": np.linspace(-1e-7, 2e-7, 301)})
>>> tip.contact_radius.plot()

solve     a scene, or a model by its name, at one point or many -> xarray.Dataset
scene     a surface on a solid, with an interface, in some operation -> Case
run       an input, as `adfric run` does -> xarray.Dataset
open      a results file -> xarray.Dataset
plot      figures of results
models    the models, their variables and results
fit       a scene or a model to measured curves -> Fit
read_surface  a measured surface -> xarray.DataArray
read_curve  force curves of an instrument -> xarray.Dataset
read_master_curve  moduli over the frequency -> xarray.Dataset
Case      a scene or a model that is solved several times
contacts  many single contacts, microseconds each
"""

from . import contacts
from .cases import Case, run, scene, solve
from .errors import Error, FailedError, InputError, StoppedError
from .figures import plot
from .files import open_file as open  # noqa: A004
from .fits import Fit, fit
from .library import library as _library
from .measured import read_curve, read_master_curve
from .surfaces import read_surface
from .tables import Model, Result, Variable, models

__version__ = _library.adfric_version().decode().split()[0]
# but for open, which would take the place of Python's own
__all__ = ["Case", "Error", "FailedError", "Fit", "InputError", "Model", "Result", "StoppedError", "Variable", "contacts", "fit",
           "models", "plot", "read_curve", "read_master_curve", "read_surface", "run", "scene", "solve"]
