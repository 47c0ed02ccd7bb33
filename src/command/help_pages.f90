! SPDX-License-Identifier: GPL-3.0-or-later
!> Pages of `adfric help` that do not depend on the models.
module adfric_command_help_pages
   use adfric_base_text, only: newline
   implicit none (type, external)
   private
   public :: usage_page, input_page, tables_page, outputs_head

   !> The commands; the list of the models follows.
   character(*), parameter :: usage_page = &
      'adfric: adhesion and friction of real surfaces'//newline// &
      newline// &
      '  adfric run INPUT.nml [--output FILE.h5] [--force] [--quiet]'//newline// &
      '             [--resume] [--shard I/N]'//newline// &
      '      solve every point of the input''s sweep and write one HDF5 file;'//newline// &
      '      --force overwrites a file, --quiet shows nothing but errors;'//newline// &
      '      --resume goes on with FILE.h5.partial if a run was stopped, --shard I/N solves'//newline// &
      '      the part I of N into FILE.part-000I-of-000N.h5'//newline// &
      '  adfric fit INPUT.nml [--output FILE.h5] [--force] [--quiet]'//newline// &
      '             [--resume] [--shard I/N]'//newline// &
      '      fit the model to the data that the input names, and write one HDF5 file; each curve of'//newline// &
      '      a stack is a point of the run (adfric help fit shows the groups)'//newline// &
      '  adfric merge FILE.h5 PART.h5 ... [--virtual] [--force] [--quiet]'//newline// &
      '      put the parts of a run together: the file that one run would have written;'//newline// &
      '      --virtual leaves the results in the parts and refers to them'//newline// &
      '  adfric check INPUT.nml [--quiet] [--output-name]'//newline// &
      '      read and validate, write nothing; print the value of every variable, the number of points,'//newline// &
      '      how long a run takes, and what looks like a slip in the units; --quiet prints nothing but errors,'//newline// &
      '      --output-name nothing but the name of the results file'//newline// &
      '  adfric modernise INPUT.nml'//newline// &
      '      print an input that names a model as a scene'//newline// &
      '  adfric help [TOPIC]'//newline// &
      '      topics: scenes, phenomena, theories, models, groups, variables, results, units, input, tables, outputs;'//newline// &
      '      or the name of a model, group, variable, result or status, or a word that a variable or a result'//newline// &
      '      may be; or a phenomenon or an author of the field, such as stick_slip, hertz or westergaard;'//newline// &
      '      names lists all of these, one a line'//newline// &
      '  adfric --version'//newline// &
      newline// &
      'Exit status: 0 every point is answered, 1 some points did not converge, or fits have no answer,'//newline// &
      '2 bad command line or input, 3 file error or too little memory, threads or stack,'//newline// &
      '128 + N stopped by signal N (129 SIGHUP, 130 Ctrl-C, 143 SIGTERM): --resume goes on.'//newline// &
      'Any other is a failure. Threads as OMP_NUM_THREADS says.'//newline// &
      'A program that was built with MPI (adfric --version says so): mpirun -n N adfric run ...'//newline// &
      newline

   !> The form of an input.
   character(*), parameter :: input_page = &
      'An input is a file of namelist groups, in any order, with comments after !. SI units.'//newline// &
      newline// &
      '  &job'//newline// &
      '    model = ''NAME''       model to be solved (adfric help NAME shows its groups); without it the input'//newline// &
      '                         describes a scene, and the program finds the solver (adfric help scenes)'//newline// &
      '    title = ''TEXT''       stands in the results file'//newline// &
      '    output = ''FILE.h5''   results file; default: the name of the input with .h5'//newline// &
      '  /'//newline// &
      '  &GROUP'//newline// &
      '    VARIABLE = VALUE     a group of the model; a dataset is ''FILE.h5:/DATASET'' or ''FILE.csv:COLUMN'''//newline// &
      '    VARIABLE = A, B, 3*C a list of numbers, or the dataset that has them'//newline// &
      '  /'//newline// &
      '  &sweep'//newline// &
      '    variable = ''NAME''    or ''GROUP%NAME'': any numeric variable of the model'//newline// &
      '    from = A, to = B, count = N, spacing = ''linear'' or ''log'''//newline// &
      '    values = A, B, ...   instead of from, to, count and spacing; or a dataset or column, as above'//newline// &
      '    with = ''NAME''        in step with the sweep of this variable'//newline// &
      '  /'//newline// &
      '  &cases file = ''FILE.csv'' or ''FILE.h5:/GROUP'', variables = ''NAME'', ... /'//newline// &
      '                         one axis, case, of all columns'//newline// &
      '  &sample count = N, method = ''sobol'', ''latin_hypercube'' or ''random'', seed = N /'//newline// &
      '                         one axis, sample, of all &range'//newline// &
      '  &range variable = ''NAME'', from = A, to = B, spacing = ''linear'' or ''log'' /'//newline// &
      '  &refine variable = ''NAME'', result = ''NAME'', tolerance = A, resolution = A, limit = N /'//newline// &
      '                         more values where a result jumps or bends'//newline// &
      '  &uncertain variable = ''NAME'', error = A, relative_error = A, method = ''linear'' or ''samples'','//newline// &
      '             count = N, seed = N /               standard errors of all results'//newline// &
      '  &output derivatives = ''NAME'', ... /          derivatives of all results'//newline// &
      newline// &
      'Several &sweep groups, cases and a sample form the outer product; the first one varies slowest.'//newline

   !> Tables of text.
   character(*), parameter :: tables_page = &
      'A table is a text of columns, as instruments, spreadsheets and scripts write it: FILE.csv, .tsv, .txt, .dat or'//newline// &
      '.asc. &data and &cases name a table, lists and the values of &sweep a column, ''FILE.csv:COLUMN''.'//newline// &
      newline// &
      '  columns    between tabs, semicolons, commas or blanks: whatever makes numbers alone of the first row of'//newline// &
      '             numbers, and as many as there are names above it'//newline// &
      '  names      in the nearest line above, in quotes or not; capitals do not count, and blanks, hyphens and'//newline// &
      '             underscores are alike; lines before the names, empty lines and comments (# %) do not count'//newline// &
      '  units      load [nN], load (nN), load / nN, load in nN, load_nN, or a line of units below the names;'//newline// &
      '             without one SI units; a part of a head that is not understood is refused'//newline// &
      '  numbers    with a decimal point or a decimal comma, one of them in a table; where the comma may part'//newline// &
      '             thousands, as in 1,234, the table is refused'//newline// &
      '  no value   an empty cell, nan, na, n/a, null, none, missing, - or --'//newline// &
      '  encodings  UTF-8, UTF-16 with its mark, Latin-1; any line ends'//newline// &
      newline// &
      'adfric check says how each table was read. All rules: docs/reference/tables.md.'//newline

   !> What stands in every results file; the results of the models follow.
   character(*), parameter :: outputs_head = &
      'Each swept variable is a dataset and a dimension scale. Each result is a dataset with a dimension'//newline// &
      'for each &sweep, the first one slowest; NaN where there is no value. A result that is itself swept'//newline// &
      'is not written again. Every dataset has units and long_name, every enumerated one flag_values and'//newline// &
      'flag_meanings; -1 is an enumerated result without a value.'//newline// &
      newline// &
      'Every variable that is not swept, and what follows from it, is a scalar dataset of its own; a list'//newline// &
      'of numbers has one dimension.'//newline// &
      newline// &
      '  attributes of the file                title, Conventions, source, history, references, model,'//newline// &
      '                                        adfric_version, git_revision, compiler, created, wall_seconds,'//newline// &
      '                                        case_hash, input (the whole text); datasets, and dataset_NAME and'//newline// &
      '                                        checksum_NAME (64-bit FNV-1a) for each that the input names'//newline

end module adfric_command_help_pages
