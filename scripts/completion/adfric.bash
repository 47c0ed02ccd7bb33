# SPDX-License-Identifier: GPL-3.0-or-later
# Completion of adfric in bash: commands, options, topics of help, inputs and results files.

# Topics of `adfric help`: the program itself lists them, one a line.
_adfric_topics() {
   "$1" help names 2>/dev/null | sort -u
}

# Files with one of some endings, and folders: _adfric_files WORD ENDING ...
_adfric_files() {
   local word=$1 ending
   shift
   compopt -o filenames 2>/dev/null
   mapfile -t COMPREPLY < <(
      compgen -d -- "$word"
      for ending in "$@"; do compgen -f -X "!*.$ending" -- "$word"; done
   )
}

_adfric() {
   local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command='' options='--help' i
   COMPREPLY=()
   for ((i = 1; i < COMP_CWORD; i++)); do
      case ${COMP_WORDS[i]} in
      run | fit | merge | check | modernise | help)
         command=${COMP_WORDS[i]}
         break
         ;;
      esac
   done
   case $command in
   '') options='--help --version' ;;
   run | fit) options='--output --force --quiet --resume --shard --help' ;;
   merge) options='--virtual --force --quiet --help' ;;
   check) options='--quiet --output-name --help' ;;
   modernise) options='--help' ;;
   esac

   if [ "$before" = --output ]; then
      _adfric_files "$word" h5
   elif [ "$before" = --shard ]; then
      return
   elif [[ $word == -* ]]; then
      mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
   else
      case $command in
      '') mapfile -t COMPREPLY < <(compgen -W 'run fit merge check modernise help' -- "$word") ;;
      run | fit | check | modernise) _adfric_files "$word" nml ;;
      merge) _adfric_files "$word" h5 ;;
      help) mapfile -t COMPREPLY < <(compgen -W "$(_adfric_topics "${COMP_WORDS[0]}")" -- "$word") ;;
      esac
   fi
}

complete -F _adfric adfric
