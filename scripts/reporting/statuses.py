# SPDX-License-Identifier: GPL-3.0-or-later
"""Which points have no value or lie beyond a bound of their theory, how many, and where they are."""

from html import escape

import numpy as np

from .shared import NONE, REASONS, SOLVED, is_doubted, runs_of
from .words import number_of, words_of

# rows of a list of where points are
MOST_ROWS = 12


def status_html(results, words):
    """A table of what is not as it should be, and a line if all is; the words of statuses by their numbers, as the file has them."""
    words = {**REASONS, **{number: word.replace("_", " ") for number, word in words.items()}}
    kinds = [(words.get(number, f"status {number}"), results.status == number) for number in np.unique(results.status) if number != SOLVED]
    if (doubted := is_doubted(results)) is not None:
        for word in sorted({word for word in results.states["doubt"].ravel() if word not in (None, NONE)}):
            kinds.append((f"doubt: {word.replace('_', ' ')}", doubted & (results.states["doubt"] == word)))
    points = results.status.size
    rows = [f"<tr><td>{escape(what)}</td><td>{int(np.count_nonzero(where))} of {points}</td><td>{_places_html(results, where)}</td></tr>"
            for what, where in kinds if np.any(where)]
    solved = int(np.count_nonzero(results.status == SOLVED))
    line = f"<p class='solved'>{solved} of {points} point{'s are' if points > 1 else ' is'} {escape(words.get(SOLVED, 'solved'))}.</p>"
    if doubted is None:
        line += "<p>The file says nothing of doubts: it is of an older version.</p>"
    elif not doubted.any():
        line += "<p>No point lies beyond a bound of the theory.</p>"
    if not rows:
        return line
    return f"{line}<table class='statuses'><tr><th>what</th><th>points</th><th>where</th></tr>{''.join(rows)}</table>"


def _places_html(results, where):
    """Where points are: for each row along the axis that varies fastest, from which value to which."""
    places = list(places_of(results, where))
    more = f"<br>and {len(places) - MOST_ROWS} more such rows" if len(places) > MOST_ROWS else ""
    return "<br>".join(map(escape, places[:MOST_ROWS])) + more


def places_of(results, where):
    """The same, in words."""
    if np.ndim(where) == 0:
        yield "the one point"
        return
    if np.all(where):
        yield "everywhere"
        return
    if np.array_equal(where, results.status == SOLVED):
        yield "wherever there is a value"
        return
    axes, last = results.axes[:-1], results.axes[-1]
    order = np.argsort(last.values, kind="stable")
    for index in np.ndindex(*where.shape[:-1]):
        for first, end in runs_of(where[index][order]):
            ends = [number_of(last.values[order[k]], last.unit, last.values) for k in (first, end)]
            words = [f"{words_of(axis.name).lower()} {number_of(axis.values[k], axis.unit, axis.values)}" for axis, k in zip(axes, index)
                     if axis.values.size > 1]
            words.append(f"{words_of(last.name).lower()} {ends[0] if first == end else ' to '.join(ends)}")
            yield ", ".join(words)
