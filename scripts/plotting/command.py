# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line."""

import sys

from .options import read_command_line
from .printable import literal, printable
from .results import BadFile, NothingToDraw, Results

FORMATS = (".png", ".pdf", ".svg")


def main(arguments):
    """Draw one figure; return the exit status: 0, 2 for a bad command line or file, 3 if there is nothing to draw."""
    given = read_command_line(arguments)
    figure_file = given.output or given.files[0].with_suffix(".png")
    try:
        check_format(figure_file)
        runs = [Results(path) for path in given.files]
        for source in [*given.files, *([given.data] if given.data else [])]:
            if figure_file.exists() and source.exists() and figure_file.samefile(source):
                raise BadFile(f"{figure_file}: the figure would replace {'the table' if source == given.data else 'the results'}")
        save_figure(make_figure(runs, given.x, given.y, given.data, given.cut), figure_file)
    except NothingToDraw as problem:
        print(printable(f"plot: {problem}"), file=sys.stderr)
        return 3
    except BadFile as problem:
        print(printable(f"plot: {problem}"), file=sys.stderr)
        return 2
    except OSError as problem:
        print(printable(f"plot: {figure_file}: cannot write: {problem.strerror or problem}"), file=sys.stderr)
        return 2
    print(printable(f"figure {figure_file}"))
    return 0


def make_figure(runs, x=None, y=None, data=None, cuts=None):
    """The figure of results: of one run, or of several in one; or maps of one run along lines."""
    # imported here, since it takes a second that a bad file need not cost
    from .chosen import draw_chosen
    from .cuts import draw_cuts
    from .doubts import describe_doubts
    from .figures import choose_figure
    from .style import use_style
    from .titles import break_titles

    with use_style():
        if cuts:
            if len(runs) > 1 or x or y or data:
                raise BadFile("--cut: not with several files, --x, --y or --data")
            figure, title = draw_cuts(runs[0], cuts), runs[0].title
        elif len(runs) > 1 or x or y or data:
            figure, title = draw_chosen(runs, x, y, data)
        else:
            figure, title = choose_figure(runs[0])(runs[0]), runs[0].title
        whole = []
        # a run without a title has that of its model
        if title and title != runs[0].model:
            whole.append(figure.suptitle(literal(title), fontsize="medium"))
        if doubts := describe_doubts(runs):
            whole.append(figure.supxlabel(doubts, fontsize="small", color="0.35"))
        break_titles(figure, whole)
    return figure


def save_figure(figure, figure_file):
    """Save a figure."""
    from .style import use_style

    check_format(figure_file)
    with use_style():
        figure.savefig(figure_file)


def check_format(figure_file):
    """Can a figure be saved under this name?"""
    if figure_file.suffix.lower() not in FORMATS:
        raise BadFile(f"{figure_file}: a figure is one of {', '.join(FORMATS)}")
