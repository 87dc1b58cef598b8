#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# pictures.sh [BUILD]: pictures of every workspace, light and dark, 100 and 200 %, into BUILD/pictures.
set -eu
here=$(cd "$(dirname "$0")/../.." && pwd)
build=${1:-$here/build}
mkdir -p "$build/pictures"
for theme in light dark; do
  for scale in 1 2; do
    HANDSIGHT_SCREEN=$((1600 * scale))x$((1000 * scale)) QT_SCALE_FACTOR=$scale \
      "$here/tests/app/with_display.sh" "$build/tests/app/take_pictures" "$build/pictures" $theme
  done
done
