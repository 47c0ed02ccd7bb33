# SPDX-License-Identifier: GPL-3.0-or-later
"""Fewer points where a file has more than a page should hold."""

import copy

import numpy as np

from .shared import Field


def thin(results, most, of_each=1):
    """Results with at most so many numbers, and what was left out, in words: the longest axes keep every second value, and so on."""
    thinned, steps = results, dict.fromkeys(results.axis_names, 1)
    while thinned.status.size * of_each > most and max(thinned.status.shape, default=1) > 2:
        along = int(np.argmax(thinned.status.shape))
        thinned = _every_second(thinned, along)
        steps[results.axis_names[along]] *= 2
    left = [f"one of {step} values of {name.replace('_', ' ')}" for name, step in steps.items() if step > 1]
    return thinned, f"The page has {' and '.join(left)}." if left else ""


def _every_second(results, along):
    """The same results with every second value of an axis."""
    name = results.axis_names[along]
    cut = (slice(None),) * along + (slice(None, None, 2),)
    part = copy.copy(results)
    part.axes = [Field(axis.name, axis.unit, axis.values[::2]) if axis.name == name else axis for axis in results.axes]
    part.companions = {key: (Field(key, field.unit, field.values[::2]) if axis == name else field, axis)
                       for key, (field, axis) in results.companions.items()}
    part.status = results.status[cut]
    part.fields, part.profiles = ({key: Field(key, field.unit, field.values[cut]) for key, field in fields.items()}
                                  for fields in (results.fields, results.profiles))
    part.states = {key: words[cut] for key, words in results.states.items()}
    return part
