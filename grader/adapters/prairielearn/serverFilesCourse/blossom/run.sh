#!/bin/sh
# PrairieLearn runs this in the grading container for each submission. It writes results/results.json, whatever happens,
# and ends with 0: another status would be an error of the grading job. When the grader fails, the submission is not
# gradable, so it costs no attempt.
# BLOSSOM_GRADE_ROOT stands for /grade in tests.
root="${BLOSSOM_GRADE_ROOT:-/grade}"
here="$root/serverFilesCourse/blossom"
results="$root/results/results.json"
mkdir -p "$root/results"
rm -f "$results"

program="$here/blossom-grade"
[ -f "$program" ] && chmod +x "$program" 2>/dev/null
[ -x "$program" ] || program=blossom-grade

timeout -k 5 "${BLOSSOM_SECONDS:-20}" "$program" grade "$root/tests/assignment.json" "$root/student" \
  --student prairielearn --format prairielearn --out "$results"
echo "blossom-grade ended with $?"

if [ ! -f "$results" ]; then
  printf '%s\n' '{"gradable":false,"format_errors":["The grader failed on this submission, which is not your fault. It costs no attempt. Please tell your instructor."]}' \
    > "$results.new"
  mv "$results.new" "$results"
fi
exit 0
