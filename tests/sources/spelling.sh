#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# spelling.sh SOURCE: does codespell know a word that is spelt wrongly? What it does not read is in .codespellrc. Skipped (77) where it
# is not installed.
set -euo pipefail
cd "$1"
command -v codespell >/dev/null || { echo "codespell is not installed."; exit 77; }
codespell || { echo "FAILED: put these right, or tell .codespellrc why they are words."; exit 1; }
echo "No word is known to be spelt wrongly."
