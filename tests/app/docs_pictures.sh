#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# docs_pictures.sh [BUILD]: takes the window's pictures of docs/pictures anew: each that take_pictures makes under the
# same name, in light and at 100 %.
set -eu
here=$(cd "$(dirname "$0")/../.." && pwd)
build=${1:-$here/build}
made=$(mktemp -d)
trap 'rm -rf "$made"' EXIT
"$here/tests/app/with_display.sh" "$build/tests/app/take_pictures" "$made" light
for picture in "$here"/docs/pictures/*.png; do
  name=$(basename "$picture" .png)
  if [ -f "$made/${name}_light_100.png" ]; then
    cp "$made/${name}_light_100.png" "$picture"
    if command -v convert >/dev/null; then  # 256 colours are enough, and a third of the size
      convert "$picture" -strip +dither -colors 256 "PNG8:$picture"
    fi
    echo "$name"
  fi
done
