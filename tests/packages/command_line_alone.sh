#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# command_line_alone.sh SOURCE BUILD FOLDER: where Qt and VTK are not there everything that is to be built is the command line; its
# package, made in BUILD, is unpacked elsewhere and runs.
set -euo pipefail
source=$1 build=$2 folder=$3
fail() {
  echo "FAILED: $*" >&2
  exit 1
}
mkdir -p "$folder"

cmake -S "$source" -B "$folder/without" -G Ninja -DHANDSIGHT_TESTS=OFF -DCMAKE_DISABLE_FIND_PACKAGE_Qt6=ON \
  -DCMAKE_DISABLE_FIND_PACKAGE_VTK=ON >"$folder/cmake.txt" 2>&1 || { cat "$folder/cmake.txt"; fail "cmake"; }
grep -q "The command line alone is built" "$folder/cmake.txt" || fail "cmake does not say that the command line alone is built"
targets=$(ninja -C "$folder/without" -t targets all)
[[ $targets == *app/cli/handsight-cli:* ]] || fail "the command line is not among what is built"
[[ $targets != *widgets/* && $targets != *handsight_app* ]] || fail "a part of the window is built without Qt"

rm -rf "$folder/packages" "$folder/root"
cpack --config "$build/CPackConfig.cmake" -G DEB -D CPACK_COMPONENTS_ALL=cli -B "$folder/packages" >"$folder/cpack.txt" 2>&1 ||
  { tail -20 "$folder/cpack.txt"; fail "cpack"; }
debs=("$folder"/packages/*.deb)
[ ${#debs[@]} -eq 1 ] || fail "expected one package, found ${debs[*]}"
depends=$(dpkg-deb -f "${debs[0]}" Depends)
[[ $depends == *libopencv-core* && $depends == *libmuparser* && $depends == *libzstd1* && $depends == *liblz4-1* && $depends == *libbz2* && $depends == *libc6* ]] || fail "dependencies are missing: $depends"
[[ $depends != *qt6* && $depends != *vtk* ]] || fail "the command line needs the window's libraries: $depends"
controls=$(dpkg-deb --ctrl-tarfile "${debs[0]}" | tar t | grep -v '/$' | sort | tr '\n' ' ')
[ "$controls" = "./control ./md5sums " ] || fail "it runs scripts: $controls"

dpkg-deb -x "${debs[0]}" "$folder/root"
cli=$folder/root/usr/bin/handsight-cli
if ldd "$cli" | grep -iE 'not found|libQt|libvtk'; then fail "its libraries"; fi
fitted=$("$cli" fit "$source/sample_sessions/hidden_1" --json -)
[[ $fitted == *'"converged": true'* ]] || fail "fit"
# The reader of images is found from there, too.
checked=$(env -i "$cli" check "$source/sample_sessions/first_steps")
[[ $checked == *"Everything in the session"* ]] || fail "images: $checked"
for file in man/man1/handsight-cli.1.gz bash-completion/completions/handsight-cli zsh/vendor-completions/_handsight-cli \
  fish/vendor_completions.d/handsight-cli.fish doc/handsight-cli/copyright doc/handsight-cli/changelog.gz; do
  [ -s "$folder/root/usr/share/$file" ] || fail "$file is missing"
done
if command -v man >/dev/null; then
  warnings=$(man --warnings=w -l "$folder/root/usr/share/man/man1/handsight-cli.1.gz" 2>&1 >/dev/null || true)
  [ -z "$warnings" ] || fail "the manual page: $warnings"
fi
bash -n "$folder/root/usr/share/bash-completion/completions/handsight-cli"
echo "The command line alone: described, packed, run."
