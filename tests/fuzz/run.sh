#!/usr/bin/env bash
# run.sh PROGRAM SECONDS: one fuzz target, from its seeds, what is shipped of its kind, and what earlier runs found
# interesting. An input that breaks it is kept beside the programs; `PROGRAM FILE` shows it again. Once understood it
# belongs into corpus/.
set -euo pipefail
program=$1 seconds=$2
here=$(dirname "${BASH_SOURCE[0]}")
name=${program##*/fuzz_}
build=$(dirname "$(dirname "$program")")

seeds=("$here/corpus/$name")
case $name in
  lessons) seeds+=(lessons) ;;
  scenes) seeds+=(lessons/scenes) ;;
  exercises) seeds+=(exercises) ;;
  answers) seeds+=(exercises/demo-class) ;;
esac
# In CI a run is to tell what a change broke, not what chance finds.
[[ ${CI:-} == true ]] && seed=1 || seed=0
mkdir -p "$build/corpus/$name" "$build/found"
options=(-seed="$seed" -max_total_time="$seconds" -timeout=30 -rss_limit_mb=2500 -max_len=16384 -dict="$here/words.dict"
  -artifact_prefix="$build/found/$name-" -verbosity=1)
if "$program" "${options[@]}" "$build/corpus/$name" "${seeds[@]}" >"$build/$name.log" 2>&1; then
  printf '%-12s %s\n' "$name" "$(grep -a '^Done ' "$build/$name.log")"
else
  tail -n 60 "$build/$name.log"
  echo "fuzz target $name is broken by an input in $build/found; all it said is in $build/$name.log"
  exit 1
fi
