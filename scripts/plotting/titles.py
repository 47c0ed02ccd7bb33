# SPDX-License-Identifier: GPL-3.0-or-later
"""Titles that are wider than their figure or their panel are broken into lines, so that none is cut."""

# share of the width of a figure that its title may take
TITLE_SHARE = 0.96
# panels stand apart, so that their titles may be somewhat wider than they are
PANEL_SHARE = 1.1


def break_titles(figure, whole):
    """Break the texts that belong to the whole figure, and the titles of its panels, where they are too wide."""
    titles = [(panel.title, panel) for panel in figure.axes if panel.get_title()]
    if titles:
        # panels have their width once they are laid out
        figure.draw_without_rendering()
    for text in whole:
        break_text(text, TITLE_SHARE * figure.bbox.width)
    for text, panel in titles:
        break_text(text, PANEL_SHARE * panel.bbox.width)


def break_text(text, width):
    """Break a text into lines of at most this width [pixels], between words; a single word stays whole."""
    if width_of(text, text.get_text()) <= width:
        return
    lines = []
    for word in words_of(text.get_text()):
        if lines and width_of(text, f"{lines[-1]} {word}") <= width:
            lines[-1] += f" {word}"
        else:
            lines.append(word)
    text.set_text("\n".join(lines))


def words_of(text):
    """The words of a text; a formula between dollars, a quantity with its value and what stands in no spaces are one word."""
    words = []
    for word in text.replace(" = ", "\u00a0=\u00a0").split(" "):
        if words and (words[-1].count("$") - words[-1].count(r"\$")) % 2:
            words[-1] += f" {word}"
        else:
            words.append(word)
    return [word.replace("\u00a0", " ") for word in words]


def width_of(text, words):
    """Width of some words in the letters of a text [pixels]."""
    before = text.get_text()
    text.set_text(words)
    width = text.get_window_extent().width
    text.set_text(before)
    return width
