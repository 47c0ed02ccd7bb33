# SPDX-License-Identifier: GPL-3.0-or-later
"""The scene of a run in words: what the input says, group by group, with the values that the file has."""

from dataclasses import dataclass
from html import escape

import numpy as np

from .inputs import groups_of, source_of
from .words import number_of, numbers_of, words_of

# groups of an input that say how something is computed or written, and not what
ASIDE = {"job", "sweep", "output", "numerics", "sample", "uncertain", "blocks", "profile"}
# the part of a scene that a group of an input speaks of; older inputs have other groups
PARTS = {"surface": "surface", "indenter": "surface", "sphere": "surface", "punch": "surface", "wave": "surface", "traction": "surface",
         "solid": "solid", "foundation": "solid", "layer": "solid", "adhesion": "adhesion", "friction": "friction", "operating": "operating",
         "history": "operating"}
# what an older model is called in scenes
MODELS = {"sphere": "paraboloid on an elastic half-space", "indenter": "indenter on an elastic half-space",
          "wavy_sliding": "wavy surface on a foundation, sliding", "hertz": "bodies of Hertz, pressed"}
# kinds of surfaces that have other words in a sentence
KINDS = {"wave_1d": "cosine wave", "wave_2d": "sum of two cosine waves", "wave_product": "product of two cosine waves",
         "cosines": "sum of cosine waves", "profile": "measured line", "heights": "measured surface", "polynomial": "body with a polynomial profile",
         "power": "body with a power profile", "line_polynomial": "line with a polynomial profile"}


@dataclass
class Scene:
    """What is known of a scene.

    sentence    the whole in one phrase
    kind        the kind of its surface
    groups      (name of the group, [(name, value in words)])
    swept       lines, one for each swept variable
    source      where the results come from
    """

    sentence: str
    kind: str
    groups: list
    swept: list
    source: object

    def part(self, name, most=3):
        """The first numbers of a part of the scene, in a few words each."""
        items = [(key, value) for group, pairs in self.groups if PARTS.get(group) == name for key, value in pairs]
        return [f"{words_of(key).lower()} {value}" for key, value in items if is_number(value)][:most]

    def has(self, name):
        """Does the input speak of a part of the scene?"""
        return any(PARTS.get(group) == name for group, _ in self.groups)


def is_number(text):
    """Does a value in words begin with a number?"""
    return text[:1].isdigit() or (text[:1] == "-" and text[1:2].isdigit())


def scene_of(results):
    """The scene of a run."""
    source = source_of(results)
    sentence = source.attributes.get("scene") or MODELS.get(results.model, results.model)
    kind = str(results.words.get("kind") or sentence.split()[0])
    groups = [(group, pairs) for group, names in groups_of(source.text)
              if group not in ASIDE and (pairs := _pairs(results, group, names))]
    swept = [f"{words_of(axis.name)}: {numbers_of(axis.values, axis.unit)}" for axis in results.several]
    swept += [f"{words_of(name)}, along {words_of(axis).lower()}: {numbers_of(field.values, field.unit)}"
              for name, (field, axis) in results.companions.items()]
    first, _, rest = sentence.partition(" ")
    return Scene(f"{KINDS.get(first, first.replace('_', ' '))} {rest.replace('_', ' ')}".strip(), kind, groups, swept, source)


def _pairs(results, group, names):
    """Names of a group with their values in words, as far as the file has them."""
    pairs = []
    for name in dict.fromkeys(names):
        key = f"{group}_{name}" if f"{group}_{name}" in results.constants else name
        if key in results.words:
            pairs.append((name, str(results.words[key]).replace("_", " ")))
        elif key in results.constants and np.all(np.isfinite(results.constants[key].values)):
            pairs.append((name, number_of(float(results.constants[key].values), results.constants[key].unit)))
        elif axis := next((axis for axis in results.several if axis.name in (name, f"{group}_{name}")), None):
            pairs.append((name, numbers_of(axis.values, axis.unit)))
    return pairs


def scene_html(scene):
    """The scene in words."""
    article = "An" if scene.sentence[:1].lower() in "aeiou" else "A"
    rows = "".join(f"<tr><th>{escape(group.replace('_', ' '))}</th><td>{'; '.join(_pair_html(*pair) for pair in pairs)}</td></tr>"
                   for group, pairs in scene.groups)
    swept = "".join(f"<li>{escape(line)}</li>" for line in scene.swept)
    return (f"<p class='sentence'>{article} {escape(scene.sentence)}.</p>" + (f"<table class='groups'>{rows}</table>" if rows else "")
            + (f"<p>Swept:</p><ul class='swept'>{swept}</ul>" if swept else ""))


def _pair_html(name, value):
    return f"{escape(words_of(name).lower())} <b>{escape(value)}</b>"
