# SPDX-License-Identifier: GPL-3.0-or-later
"""Formulas of the documents, $...$ and $$...$$, as MathML: a browser sets them by itself, without a script, a font of ours or a network."""

import html
import re

from latex2mathml.converter import convert
from markdown.extensions import Extension
from markdown.inlinepatterns import InlineProcessor
from markdown.preprocessors import Preprocessor

# As GitHub reads them: no blank inside the dollars, no word behind the last one.
INLINE = r"(?<![\\$\w])\$(?![\s$])((?:[^$\\`]|\\.)+?)(?<!\s)\$(?![\d\w$])"
DISPLAY = re.compile(r"^( {0,3}(?:[-*+] +|\d+\. +)?| *)\$\$(.+?)\$\$[ \t]*$", re.MULTILINE | re.DOTALL)


class FormulaError(ValueError):
    """A formula that cannot be set."""


def mathml_of(formula, is_display=False):
    """A formula of TeX as MathML; its source is its text for those who cannot see it."""
    source = " ".join(formula.split())
    braces = re.findall(r"(?<!\\)[{}]", source)
    if braces.count("{") != braces.count("}"):
        raise FormulaError(f"${source}$: a brace without the other one")
    try:
        text = convert(source, display="block" if is_display else "inline")
    except Exception as problem:
        raise FormulaError(f"${source}$: {type(problem).__name__} {problem}") from problem
    # what it does not know it copies
    if unknown := re.search(r"\\\w+", re.sub(r"<[^>]*>", "", text)):
        raise FormulaError(f"${source}$: {unknown[0]} is not known")
    return text.replace("<math ", f'<math alttext="{html.escape(source)}" ', 1)


class DisplayFormulas(Preprocessor):
    """Formulas between double dollars, before anything else is read; blocks of code are put aside before."""

    def run(self, lines):
        def put(found):
            return found[1] + self.md.htmlStash.store(f'<div class="formula">{mathml_of(found[2], is_display=True)}</div>')
        return DISPLAY.sub(put, "\n".join(lines)).split("\n")


class InlineFormulas(InlineProcessor):
    """Formulas in a line, behind spans of code and before everything else."""

    def handleMatch(self, m, data):
        return self.md.htmlStash.store(mathml_of(m[1])), m.start(0), m.end(0)


class FormulaExtension(Extension):
    """Puts both into the reader of Markdown."""

    def extendMarkdown(self, md):
        # blocks of code are put aside with 25, and spans of code are found with 190
        md.preprocessors.register(DisplayFormulas(md), "display_formulas", 22)
        md.inlinePatterns.register(InlineFormulas(INLINE, md), "inline_formulas", 185)
