#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# examples.sh PYTHON WHEEL_FOLDER SOURCE FOLDER: unpacks the wheel into FOLDER and runs docs/examples/python with it. Skipped (77)
# where Matplotlib is not installed.
set -euo pipefail
python=$1 wheels=$2 source=$3 folder=$4
fail() {
  echo "FAILED: $*" >&2
  exit 1
}
"$python" -c "import matplotlib" 2>/dev/null || { echo "Matplotlib is not installed."; exit 77; }
rm -rf "$folder"
mkdir -p "$folder"
"$python" -m zipfile -e "$wheels"/handsight-*.whl "$folder/module"
export PYTHONPATH=$folder/module MPLBACKEND=Agg MPLCONFIGDIR=$folder/settings
cd "$folder"
run() { "$python" -W error::DeprecationWarning:__main__ "$source/docs/examples/python/$1" "$source/sample_sessions/$2" "$folder" | tee "$1.txt"; }
run why_is_the_hand_elsewhere.py hidden_3 || fail "why_is_the_hand_elsewhere.py"
grep -q "^missing_effect" why_is_the_hand_elsewhere.py.txt || fail "nothing was missing"
grep -qE "off by [1-9].* corrected 0\.0000" why_is_the_hand_elsewhere.py.txt || fail "no pose was corrected"
run how_sure_elsewhere.py hidden_1 || fail "how_sure_elsewhere.py"
awk '/^standard deviation/ { exit !($3 > 0 && $3 < $12) }' how_sure_elsewhere.py.txt || fail "the edge is surer than the middle"
for plot in candidates errors how_sure; do [ -s $plot.png ] || fail "$plot.png was not drawn"; done
grep -q "<handsight_calibration" calibration.xml || fail "no calibration was written"
