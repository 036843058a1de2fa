#!/usr/bin/env bash
# Gradescope runs this once, when it makes the autograder's image. Nothing needs a network afterwards.
#
# With a blossom-grade beside this script, that one is used; otherwise it is built from the sources in blossom/.
# BLOSSOM_AUTOGRADER stands for /autograder in tests.
set -euo pipefail

source="${BLOSSOM_AUTOGRADER:-/autograder}/source"
program="$source/blossom-grade"

install() {
  apt-get update
  DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "$@"
}

if [[ -f "$program" ]]; then
  chmod +x "$program"
  "$program" --version >/dev/null 2>&1 || install libarchive13 libseccomp2 libssl3 libutf8proc2
elif [[ -f "$source/blossom/CMakeLists.txt" ]]; then
  install g++ cmake ninja-build libboost-dev libcli11-dev libglm-dev nlohmann-json3-dev libarchive-dev \
    libseccomp-dev libssl-dev libutf8proc-dev
  cmake -S "$source/blossom" -B "$source/build" -G Ninja -DBLOSSOM_PLAYER=OFF -DBLOSSOM_TESTS=OFF
  cmake --build "$source/build" --target blossom-grade
  cp "$source/build/bin/blossom-grade" "$program"
  rm -rf "$source/build"
else
  echo "setup.sh: neither blossom-grade nor blossom/ is in the zip file; see README.md" >&2
  exit 1
fi

# What does not run, or an assignment with mistakes, should be known now and not at the first submission.
"$program" --version
mkdir -p "$source/nothing"
options=()
[[ -f "$source/course/secret" ]] && options+=(--secret-file "$source/course/secret")
status=0
"$program" grade "$source/course/assignment.json" "$source/nothing" --student nobody ${options[@]+"${options[@]}"} || status=$?
if ((status != 0)); then
  echo "setup.sh: course/assignment.json cannot be used; see above" >&2
  exit "$status"
fi
