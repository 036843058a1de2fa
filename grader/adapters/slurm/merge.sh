#!/usr/bin/env bash
# Puts together what the tasks of grade.sbatch wrote: the same bytes as one process writes.
#
#   merge.sh FOLDER GRADES.jsonl [SUBMISSIONS.jsonl]
#
# Waits for nothing: all parts must be there, whole and of one array; with SUBMISSIONS.jsonl, as many lines, too.
# Otherwise it says what is missing, writes nothing, and ends with status 1.
set -euo pipefail

complain() {
  printf 'merge.sh: %s\n' "$1" >&2
  exit "${2:-1}"
}
(($# == 2 || $# == 3)) || complain "usage: merge.sh FOLDER GRADES.jsonl [SUBMISSIONS.jsonl]" 2
folder=$1 merged=$2 submissions=${3:-}

# How many parts there are, as their names say.
shards=
for file in "$folder"/grades-*-of-*.jsonl; do
  [[ $file =~ grades-[0-9]+-of-([0-9]+)\.jsonl$ ]] || continue
  [[ -z $shards || $shards == "${BASH_REMATCH[1]}" ]] ||
    complain "$folder has parts of an array of $shards and of one of ${BASH_REMATCH[1]}; remove those of the wrong one"
  shards=${BASH_REMATCH[1]}
done
[[ -n $shards ]] || complain "$folder has no part, such as grades-1-of-16.jsonl"

parts=() missing=()
for ((i = 1; i <= shards; i++)); do
  part=$folder/grades-$i-of-$shards.jsonl
  if [[ ! -f $part ]]; then
    missing+=("$i")
  elif [[ -s $part && -n $(tail -c 1 "$part") ]]; then
    complain "$part ends within a line; grade that part again"
  else
    parts+=("$part")
  fi
done
((${#missing[@]} == 0)) || complain "of $shards parts these are missing: ${missing[*]}; grade them again with
  SHARDS=$shards sbatch --array=$(IFS=, && echo "${missing[*]}") grade.sbatch ..."

unfinished=$merged.unfinished-$$
trap 'rm -f "$unfinished"' EXIT
cat -- "${parts[@]}" >"$unfinished"
if [[ -n $submissions ]]; then
  # A last line without its end is a line, too.
  expected=$(wc -l <"$submissions")
  [[ ! -s $submissions || -z $(tail -c 1 "$submissions") ]] || expected=$((expected + 1))
  graded=$(wc -l <"$unfinished")
  ((graded == expected)) || complain "$graded grades for the $expected lines of $submissions; it was changed meanwhile"
fi
mv -- "$unfinished" "$merged"
