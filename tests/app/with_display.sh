#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# with_display.sh PROGRAM ...: runs a program of the window's tests on an X server of its own, with the fonts of DejaVu
# whatever else is installed; HANDSIGHT_FONTS names another of the sets in fonts/.
case "$*" in *--gtest_list_tests*) exec "$@" ;; esac
if ! command -v xvfb-run >/dev/null; then
  echo "xvfb-run is missing: install xvfb and xauth, as ./test does." >&2
  exit 1
fi
runtime=$(mktemp -d)
trap 'rm -rf "$runtime"' EXIT
chmod 700 "$runtime"
export FONTCONFIG_FILE="$(cd "$(dirname "$0")" && pwd)/fonts/${HANDSIGHT_FONTS:-dejavu}.conf"
export XDG_RUNTIME_DIR="$runtime" LIBGL_ALWAYS_SOFTWARE=1 QT_QPA_PLATFORM=xcb
unset DBUS_SESSION_BUS_ADDRESS
xvfb-run -a -s "-screen 0 ${HANDSIGHT_SCREEN:-1600x1000}x24" "$@"
