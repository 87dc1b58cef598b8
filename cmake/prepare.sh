# SPDX-License-Identifier: Apache-2.0
# Shared by ./run and ./test: the packages of Debian 12 that Handsight needs, and how it is built.

build_packages=(g++ cmake ninja-build ccache mold libeigen3-dev libceres-dev libopencv-dev libtinyxml2-dev libcli11-dev
  nlohmann-json3-dev libfmt-dev libboost-dev libmuparser-dev pkg-config)
window_packages=(qt6-base-dev libqt6opengl6-dev qt6-svg-dev libqt6svg6 libgl-dev libvtk9-dev libqcustomplot-dev
  libqcustomplot2.1-qt6 fonts-dejavu-core)
test_packages=(libgtest-dev libgmock-dev libbenchmark-dev xvfb xauth libgl1-mesa-dri libglx-mesa0 imagemagick poppler-utils)

# install_missing WHY PACKAGE...: asks apt for those that are not there; says what and why before it does.
install_missing() {
  local why=$1 missing=() package
  shift
  for package in "$@"; do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return 0
  echo "Installing $why: ${missing[*]}"
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      echo "These packages are missing and only root may install them; as root: apt-get install ${missing[*]}" >&2
      return 1
    fi
    as_root=(sudo)
  fi
  "${as_root[@]}" apt-get update -qq
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}

# build TARGET: configures once and builds; two builds at once wait for each other.
build() {
  mkdir -p build
  exec 8>build/.lock
  if command -v flock >/dev/null; then flock 8; fi
  local status=0
  if [ ! -f build/build.ninja ]; then
    cmake -S . -B build -G Ninja >build/configure.txt 2>&1 || { cat build/configure.txt; status=1; }
  fi
  if [ $status -eq 0 ]; then ninja -C build --quiet "$1" | sed '/^ninja: no work to do\.$/d' || status=1; fi
  exec 8>&-
  return $status
}
