#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# coverage.sh [TEST_PROGRAM...]: after cmake --preset coverage && cmake --build build-coverage, runs test programs (all of them without
# an argument; test_cli runs handsight-cli, which counts too) and tells which share of core's lines they run. Needs llvm.
# Each program has one processor to itself: threads that count the same lines on two take several times as long. A test that
# fails is said; its lines count all the same. Runs of one program add to one file; one that is broken, of a program that was
# killed, is left out.
set -euo pipefail
cd "$(dirname "$0")/.."
export folder=build-coverage
tool() { command -v "$1" || command -v "$1-14" || { echo "$1 is not installed (apt-get install llvm)." >&2; exit 1; }; }
profdata=$(tool llvm-profdata) cov=$(tool llvm-cov)
programs=("$@")
[ ${#programs[@]} -gt 0 ] || for program in "$folder"/tests/test_*; do [ -x "$program" ] && programs+=("$(basename "$program")"); done
rm -rf "$folder/profiles"
mkdir -p "$folder/profiles"
run() {  # number of the processor, program
  local start=$SECONDS says="passed"
  LLVM_PROFILE_FILE="$folder/profiles/$2-%m.profraw" taskset -c "$1" "$folder/tests/$2" --gtest_brief=1 \
    > "$folder/profiles/$2.log" 2>&1 || says="a test failed ($folder/profiles/$2.log)"
  echo "$2: $says, $((SECONDS - start)) s"
}
export -f run
printf '%s\n' "${programs[@]}" | xargs -P "$(nproc)" --process-slot-var=slot -I{} bash -c 'run "$slot" {}'
objects=()
for program in "${programs[@]}"; do objects+=(-object "$folder/tests/$program"); done
[ -x "$folder/app/cli/handsight-cli" ] && objects+=(-object "$folder/app/cli/handsight-cli")
"$profdata" merge -sparse -failure-mode=all "$folder"/profiles/*.profraw -o "$folder/all.profdata"
"$cov" report "${objects[@]}" -instr-profile="$folder/all.profdata" -ignore-filename-regex='tests/|/usr/' |
  tee "$folder/coverage.txt" | tail -1
echo "By file: $folder/coverage.txt"
