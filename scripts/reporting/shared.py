# SPDX-License-Identifier: GPL-3.0-or-later
"""What pages and figures have in common: how results are read, named and judged."""

if __package__ == "reporting":
    # beside the package, in scripts/
    from importing.problems import FileFailure
    from importing.writing import write_files
    from plotting import fit
    from plotting.curves import UP_TO, load_of, passes_zero
    from plotting.doubts import NONE, edges_of, is_doubted, runs_of
    from plotting.figures import choose_results
    from plotting.jumps import find_jumps
    from plotting.labels import axis_label, scale_of
    from plotting.printable import printable
    from plotting.results import REASONS, SOLVED, BadFile, Field, NothingToDraw, Results
    from plotting.samples import AXES as SAMPLE_AXES
    from plotting.style import COLOURS, is_logarithmic
else:
    from ..importing.problems import FileFailure
    from ..importing.writing import write_files
    from ..plotting import fit
    from ..plotting.curves import UP_TO, load_of, passes_zero
    from ..plotting.doubts import NONE, edges_of, is_doubted, runs_of
    from ..plotting.figures import choose_results
    from ..plotting.jumps import find_jumps
    from ..plotting.labels import axis_label, scale_of
    from ..plotting.printable import printable
    from ..plotting.results import REASONS, SOLVED, BadFile, Field, NothingToDraw, Results
    from ..plotting.samples import AXES as SAMPLE_AXES
    from ..plotting.style import COLOURS, is_logarithmic

__all__ = ["COLOURS", "NONE", "REASONS", "SAMPLE_AXES", "SOLVED", "UP_TO", "BadFile", "Field", "FileFailure", "NothingToDraw", "Results", "axis_label",
           "choose_results", "edges_of", "find_jumps", "fit", "is_doubted", "is_logarithmic", "load_of", "passes_zero", "printable",
           "runs_of", "scale_of", "write_files"]
