# SPDX-License-Identifier: GPL-3.0-or-later
"""What was set of a case, in an order that makes the same case again."""

import numpy as np


class Journal:
    """The last value of each variable. The order of sweeps is kept: the one that begins last varies fastest."""

    def __init__(self):
        self._entries = []
        # places of the last values of variables, of those behind the last sweep of several
        self._places = {}

    def note(self, name, value, unit):
        """A variable was set; None: it has its default."""
        place = self._places.get(name)
        is_sweep = isinstance(value, np.ndarray)
        if place is not None and (not is_sweep or isinstance(self._entries[place][1], np.ndarray)):
            self._entries[place] = (name, value, unit)
            return
        if place is not None:
            # a sweep that begins stands behind the others
            self._entries[place] = None
        self._places[name] = len(self._entries)
        self._entries.append((name, value, unit))

    def note_together(self, names):
        """Variables were put together; what was set before has its order from now on."""
        self._places.clear()
        self._entries.append((None, list(names), None))

    def entries(self):
        """Name, value and unit of each entry; several names without one of their own are swept together."""
        return [entry for entry in self._entries if entry is not None]
