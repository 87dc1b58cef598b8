#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# format.sh SOURCE: is every source as clang-format would write it? Skipped (77) where it is not installed.
set -euo pipefail
cd "$1"
command -v clang-format >/dev/null || { echo "clang-format is not installed."; exit 77; }
mapfile -d '' files < <(find app core docs tests widgets \( -name '*.h' -o -name '*.cpp' \) -print0)
[ ${#files[@]} -gt 500 ] || { echo "FAILED: only ${#files[@]} sources were found"; exit 1; }
printf '%s\0' "${files[@]}" | xargs -0 -n 100 -P "$(nproc)" clang-format --dry-run -Werror ||
  { echo "FAILED: run clang-format -i on these."; exit 1; }
echo "${#files[@]} sources are formatted."
