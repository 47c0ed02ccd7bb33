# SPDX-License-Identifier: GPL-3.0-or-later
"""The figures of a page as a notebook shows them."""

from html import escape

HEIGHT = 640


class InteractiveFigure:
    """Figures to hover, to zoom and to choose from; the last value of a cell of a notebook is shown.

    html      the page, which needs nothing else
    """

    def __init__(self, html):
        """Figures, by their page."""
        self.html = html

    def _repr_html_(self):
        """The page in a frame, which keeps its scripts and styles apart from those of the notebook."""
        return (f'<iframe srcdoc="{escape(self.html)}" width="100%" height="{HEIGHT}" style="border: none" '
                'sandbox="allow-scripts allow-downloads"></iframe>')
