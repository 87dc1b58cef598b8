#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# pictures.sh [BUILD [ARGUMENT ...]]: pictures of every workspace on a laptop and on a large screen, the same at twice the
# scale, light and dark, in English and German, each kind in a folder of its own in BUILD/pictures. The arguments are
# those of take_pictures (--gtest_filter=...); HANDSIGHT_PICTURES names the folders to be made, all where it is not set.
set -eu
here=$(cd "$(dirname "$0")/../.." && pwd)
build=${1:-$here/build}
[ $# -eq 0 ] || shift
for size in 1366x728 1920x1040; do
  for scale in 1 2; do
    [ "$size" = 1920x1040 ] || [ $scale = 1 ] || size=1280x760
    for theme in light dark; do
      for language in en de; do
        folder="${size}_${scale}_${theme}_$language"
        case " ${HANDSIGHT_PICTURES:-$folder} " in *" $folder "*) ;; *) continue ;; esac
        HANDSIGHT_WINDOW=$size HANDSIGHT_LANGUAGE=$language QT_SCALE_FACTOR=$scale \
          HANDSIGHT_SCREEN=$((1950 * scale))x$((1100 * scale)) \
          "$here/tests/app/with_display.sh" "$build/tests/app/take_pictures" "$build/pictures/$folder" $theme "$@"
      done
    done
  done
done
