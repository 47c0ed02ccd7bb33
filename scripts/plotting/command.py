"""The command line."""

import argparse
import sys
from pathlib import Path

from .printable import printable
from .results import BadFile, NothingToDraw, Results

FORMATS = (".png", ".pdf", ".svg")


class Parser(argparse.ArgumentParser):
    """A parser whose messages show what a name has, instead of obeying it."""

    def _print_message(self, message, file=None):
        super()._print_message("\n".join(printable(line) for line in message.split("\n")), file)


def main(arguments):
    """Draw one figure; return the exit status: 0, 2 for a bad command line or file, 3 if there is nothing to draw."""
    parser = Parser(
        prog="scripts/plot",
        description="Draw the figure of a results file; what is drawn follows from what was swept.",
    )
    parser.add_argument("file", metavar="FILE.h5", type=Path, help="results of adfric run")
    parser.add_argument("-o", "--output", metavar="FIGURE", type=Path,
                        help="figure, .png, .pdf or .svg (default: FILE.png)")
    given = parser.parse_args(arguments)
    figure_file = given.output or given.file.with_suffix(".png")
    try:
        if figure_file.suffix.lower() not in FORMATS:
            raise BadFile(f"{figure_file}: a figure is one of {', '.join(FORMATS)}")
        results = Results(given.file)
        if figure_file.exists() and figure_file.samefile(given.file):
            raise BadFile(f"{figure_file}: the figure would replace the results")
        draw(results, figure_file)
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


def draw(results, figure_file):
    """Draw and save the figure of these results."""
    # imported here, since it takes a second that a bad file need not cost
    from .figures import choose_figure
    from .style import plt, use_style

    use_style()
    figure = choose_figure(results)(results)
    if results.title:
        figure.suptitle(results.title, fontsize="medium")
    figure.savefig(figure_file)
    plt.close(figure)
