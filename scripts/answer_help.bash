# SPDX-License-Identifier: GPL-3.0-or-later
# Answer --help at once, with any Python and without packages, before anything is installed: answer_help MODULE ARGUMENTS.
# The module, which needs nothing but Python, prints the help when it is run with these arguments.
answer_help() {
   local module=$1 argument python
   shift
   for argument in "$@"; do
      case $argument in
      -h | --help)
         if python=$(command -v "${ADFRIC_PYTHON:-python3}" || command -v /usr/bin/python3); then
            PYTHONPATH=$root/scripts PYTHONDONTWRITEBYTECODE=1 exec "$python" -m "$module" "$@"
         fi
         ;;
      esac
   done
}
