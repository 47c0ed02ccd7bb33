# SPDX-License-Identifier: GPL-3.0-or-later
"""Force curves as a file has them."""

from dataclasses import dataclass, field

import numpy as np


@dataclass
class Curve:
    """A force curve in SI units; None stands for what the file does not say."""

    # the file, and the number of the curve in it
    name: str
    # height of the base of the lever, or of the tip [m], of whichever sign the file has
    height: np.ndarray | None = None
    # load [N], and deflection of the lever [m]; one of them is there
    load: np.ndarray | None = None
    deflection: np.ndarray | None = None
    # time [s], and the number of the segment
    time: np.ndarray | None = None
    segment: np.ndarray | None = None
    # [N/m] and [m/V]
    spring_constant: float | None = None
    sensitivity: float | None = None
    # is the height that of the tip?
    is_tip: bool = False
    # indices on a grid along x and y, the numbers of these, and the position [m]
    index: tuple | None = None
    shape: tuple | None = None
    position: tuple | None = None
    # why the curve cannot be used; empty where it can
    problem: str = ""


@dataclass
class Source:
    """What files say."""

    # format, and what was taken for the height and the load
    format: str
    taken: list
    curves: list
    # what the user should know, a line each
    remarks: list = field(default_factory=list)
    # software that has read
    software: str = ""
