#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# command_line_alone.sh SOURCE FOLDER: where Qt and VTK are not there the command line is built, packed, unpacked elsewhere and
# run. The compiler's cache has everything from the build of all.
set -euo pipefail
source=$1 folder=$2
fail() {
  echo "FAILED: $*" >&2
  exit 1
}

cmake -S "$source" -B "$folder/build" -G Ninja -DHANDSIGHT_TESTS=OFF -DCMAKE_DISABLE_FIND_PACKAGE_Qt6=ON \
  -DCMAKE_DISABLE_FIND_PACKAGE_VTK=ON >"$folder.txt" 2>&1 || { cat "$folder.txt"; fail "cmake"; }
grep -q "The command line alone is built" "$folder.txt" || fail "cmake does not say that the command line alone is built"
ninja -C "$folder/build" --quiet
[ ! -e "$folder/build/handsight" ] || fail "there is a window without Qt"

rm -rf "$folder"/build/*.deb "$folder/root"
(cd "$folder/build" && cpack -G DEB >>"$folder.txt" 2>&1) || { tail -20 "$folder.txt"; fail "cpack"; }
debs=("$folder"/build/*.deb)
[ ${#debs[@]} -eq 1 ] || fail "expected one package, found ${debs[*]}"
depends=$(dpkg-deb -f "${debs[0]}" Depends)
[[ $depends == *libceres* && $depends == *libopencv-core* && $depends == *libc6* ]] || fail "dependencies are missing: $depends"
[[ $depends != *qt6* && $depends != *vtk* ]] || fail "the command line needs the window's libraries: $depends"

dpkg-deb -x "${debs[0]}" "$folder/root"
cli=$folder/root/usr/bin/handsight-cli
if ldd "$cli" | grep -iE 'not found|libQt|libvtk'; then fail "its libraries"; fi
"$cli" fit "$source/sample_sessions/hidden_1" --json - | grep -q '"converged": true' || fail "fit"
# The reader of images is found from there, too.
env -i "$cli" check "$source/sample_sessions/first_steps" | grep -q 'works\|can be used' || fail "images"
for file in man/man1/handsight-cli.1.gz bash-completion/completions/handsight-cli zsh/vendor-completions/_handsight-cli \
  fish/vendor_completions.d/handsight-cli.fish doc/handsight-cli/copyright doc/handsight-cli/changelog.gz; do
  [ -s "$folder/root/usr/share/$file" ] || fail "$file is missing"
done
if command -v man >/dev/null; then
  warnings=$(man --warnings=w -l "$folder/root/usr/share/man/man1/handsight-cli.1.gz" 2>&1 >/dev/null || true)
  [ -z "$warnings" ] || fail "the manual page: $warnings"
fi
bash -n "$folder/root/usr/share/bash-completion/completions/handsight-cli"
echo "The command line alone: built, packed, run."
