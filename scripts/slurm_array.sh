#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#SBATCH --job-name=adfric
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=4
#SBATCH --time=04:00:00
#SBATCH --signal=B:TERM@120
#SBATCH --open-mode=append
#SBATCH --output=%x-%A_%a.log
# One sweep as a job array of Slurm, and a job that puts the parts together.
set -euo pipefail

usage='usage: scripts/slurm_array.sh INPUT.nml N [OUTPUT.h5]

Submits a job array that solves INPUT.nml in N parts, and a job after it that merges them into OUTPUT.h5 (default: the name
of the input with .h5, in this folder). N is at most 10000. Give the command again when some tasks
have failed, or have run out of time: only parts that are not complete are submitted, and each goes on where it was.

The lines #SBATCH of this script are defaults. The variables of sbatch change them for both jobs, such as SBATCH_PARTITION,
SBATCH_ACCOUNT, SBATCH_TIMELIMIT; further options of sbatch for the array stand in ADFRIC_SBATCH, such as
ADFRIC_SBATCH="--cpus-per-task=16 --mem=8G". ADFRIC is the program (default: build/release/adfric).

Two minutes before its time is over a task is told to end, and keeps what it has.'

# A name as the shell would be told it: nothing in it is obeyed by a terminal.
shown() { LC_ALL=C printf '%q' "$1"; }

fail() {
   printf 'slurm_array: %s\n' "$*" >&2
   exit 2
}

# Largest number of parts: so many names fit on the command line that merges them.
most_parts=10000

# The name of the file of a part, as adfric calls it, into the variable part.
set_part() { printf -v part '%s.part-%04d-of-%04d.h5' "${1%.h5}" "$2" "$3"; }

# Run a command that writes a file, and ends in order when this script is told to. Points that do not converge are results,
# too: status 1. Whatever the status, there is no success without the file.
run_program() {
   local file=$1 status=0 child
   shift
   "$@" &
   child=$!
   # shellcheck disable=SC2064
   trap "kill -TERM $child 2>/dev/null || true" TERM
   while :; do
      status=0
      wait "$child" || status=$?
      # a wait that a signal has ended leaves the program running
      kill -0 "$child" 2>/dev/null || break
   done
   if [ "$status" -gt 1 ]; then return "$status"; fi
   if [ ! -f "$file" ]; then
      printf 'slurm_array: %s is missing, though the program has ended with status %s\n' "$(shown "$file")" "$status" >&2
      return 3
   fi
}

# A task of the array: solve a part.
solve() {
   local program=$1 input=$2 n=$3 output=$4 part
   set_part "$output" "$SLURM_ARRAY_TASK_ID" "$n"
   export OMP_NUM_THREADS=${SLURM_CPUS_PER_TASK:-1}
   run_program "$part" "$program" run --quiet --resume --shard "$SLURM_ARRAY_TASK_ID/$n" --output "$output" "$input"
}

# The last job: put the parts together. It says which parts are missing.
merge() {
   local program=$1 n=$2 output=$3 k part parts=()
   for ((k = 1; k <= n; k++)); do
      set_part "$output" "$k" "$n"
      if [ -e "$part" ]; then parts+=("$part"); fi
   done
   [ ${#parts[@]} -gt 0 ] || fail "no part of $(shown "$output") is complete"
   run_program "$output" "$program" merge "$output" "${parts[@]}"
}

# What the user calls: submit the parts that are missing, and the last job.
submit() {
   local input=$1 n=$2 output=$3 here root program k part job missing=() options=()
   case $n in
   '' | *[!0-9]* | 0*) fail "no number of parts: $(shown "$n")" ;;
   esac
   # compared by their lengths first: a number may have more digits than the shell can count with
   if [ ${#n} -gt ${#most_parts} ] || [ "$n" -gt "$most_parts" ]; then
      fail "too many parts: $n; allowed: up to $most_parts"
   fi
   here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
   root=$(dirname "$here")
   program=${ADFRIC:-$root/build/release/adfric}
   [ -x "$program" ] || fail "no such program: $(shown "$program"); scripts/build makes it"
   [ ! -e "$output" ] || fail "$(shown "$output") exists: the sweep is done"
   "$program" check --quiet "$input"
   for ((k = 1; k <= n; k++)); do
      set_part "$output" "$k" "$n"
      if [ ! -e "$part" ]; then missing+=("$k"); fi
   done
   if [ ${#missing[@]} -gt 0 ]; then
      # shellcheck disable=SC2086
      job=$(sbatch --parsable ${ADFRIC_SBATCH-} --array="$(list_ranges "${missing[@]}")" \
         "$here/slurm_array.sh" --solve "$program" "$input" "$n" "$output")
      job=${job%%;*}
      printf 'slurm_array: job %s solves %s of %s parts\n' "$job" "${#missing[@]}" "$n"
      # whatever becomes of the tasks: the last job says which parts are missing
      options=(--dependency="afterany:$job")
   fi
   job=$(sbatch --parsable --cpus-per-task=1 --output='%x-%j.log' "${options[@]}" \
      "$here/slurm_array.sh" --merge "$program" "$n" "$output")
   printf 'slurm_array: job %s merges them into %s\n' "${job%%;*}" "$(shown "$output")"
}

# Rising numbers as ranges: 1 2 3 7 is 1-3,7.
list_ranges() {
   local first=$1 last=$1 k text=
   shift
   for k in "$@" end; do
      if [ "$k" = $((last + 1)) ]; then
         last=$k
         continue
      fi
      text+=,$first
      if [ "$last" != "$first" ]; then text+=-$last; fi
      first=$k
      last=$k
      if [ "$k" = end ]; then break; fi
   done
   printf '%s' "${text#,}"
}

case ${1-} in
--solve)
   shift
   solve "$@"
   ;;
--merge)
   shift
   merge "$@"
   ;;
-h | --help)
   printf '%s\n' "$usage"
   ;;
*)
   if [ $# -lt 2 ] || [ $# -gt 3 ]; then
      printf '%s\n' "$usage" >&2
      exit 2
   fi
   name=$(basename -- "$1")
   submit "$1" "$2" "${3:-${name%.nml}.h5}"
   ;;
esac
