#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# installed_library.sh SOURCE BUILD FOLDER COMPILER: installs the library below FOLDER, compiles each public header alone, and builds
# and runs docs/examples/cpp against what was installed, with nothing of the source's folders in reach.
set -euo pipefail
source=$1 build=$2 folder=$3 compiler=$4
fail() {
  echo "FAILED: $*" >&2
  exit 1
}
rm -rf "$folder"
mkdir -p "$folder"
cmake --install "$build" --component development --prefix "$folder/prefix" >"$folder/install.txt" || fail "install"
[ -z "$(find "$folder/prefix" -name 'handsight-cli*' -o -name '*.a')" ] || fail "more than the library was installed"
if grep -rnE '#include "' "$folder/prefix/include" | grep -v '#include "handsight/'; then
  fail "a header includes what is found only in the source"
fi

eigen=$(pkg-config --cflags-only-I eigen3 | sed 's/-I/-isystem /g')
count=0
for header in "$folder"/prefix/include/handsight/*.h; do
  echo "#include <handsight/$(basename "$header")>" >"$folder/alone.cpp"
  # shellcheck disable=SC2086
  "$compiler" -std=c++20 -fsyntax-only -Wall -Wextra -Werror -I "$folder/prefix/include" $eigen "$folder/alone.cpp" ||
    fail "$(basename "$header") does not compile alone"
  count=$((count + 1))
done
[ "$count" -ge 13 ] || fail "only $count public headers"

cp -r "$source/docs/examples/cpp" "$folder/example"
cmake -S "$folder/example" -B "$folder/built" -DCMAKE_PREFIX_PATH="$folder/prefix" -DCMAKE_CXX_COMPILER="$compiler" \
  -DCMAKE_BUILD_TYPE=Release >"$folder/cmake.txt" 2>&1 || { cat "$folder/cmake.txt"; fail "find_package"; }
cmake --build "$folder/built" >"$folder/built.txt" 2>&1 || { cat "$folder/built.txt"; fail "build"; }
cp -r "$source/sample_sessions/hidden_1" "$folder/session"
cd "$folder"
./built/correct_a_pose session | tee told.txt || fail "run"
grep -q "found: " told.txt || fail "nothing was found"
grep -qE "corrected, \+- 0\.[0-9]+ mm" told.txt || fail "no pose was corrected"
grep -q "<robot" calibrated.urdf || fail "no URDF was written"
grep -q "<handsight_calibration" calibration.xml || fail "no calibration was written"
status=0
./built/correct_a_pose nowhere 2>refused.txt || status=$?
[ "$status" -eq 2 ] && grep -q "nowhere" refused.txt || fail "a session that is not there was not refused in a sentence"
echo "$count headers alone; installed, found, built, run."
