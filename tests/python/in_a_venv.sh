#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# in_a_venv.sh PYTHON WHEEL_FOLDER VENV: installs the wheel into a new environment, without a network, and runs the tests.
set -euo pipefail
python=$1 wheels=$(realpath "$2") venv=$(realpath -m "$3") tests=$(realpath "$(dirname "${BASH_SOURCE[0]}")")
rm -rf "$venv"
"$python" -m venv --system-site-packages "$venv"
"$venv/bin/pip" install --quiet --no-index --no-deps --force-reinstall "$wheels"/handsight-*.whl
cd "$venv"  # not the source: the module must come from the wheel
"$venv/bin/python" -m unittest discover -s "$tests"
