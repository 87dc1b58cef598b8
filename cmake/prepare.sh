# SPDX-License-Identifier: Apache-2.0
# Shared by ./run and ./test: the packages of Debian 12 that Handsight needs, and how it is built.

build_packages=(clang g++ cmake ninja-build ccache libeigen3-dev libceres-dev libopencv-dev libopencv-contrib-dev libtinyxml2-dev
  libcli11-dev nlohmann-json3-dev libfmt-dev libboost-dev libmuparser-dev libyaml-cpp-dev
  libsqlite3-dev libzstd-dev liblz4-dev libbz2-dev pkg-config libfcl-dev libompl-dev)
window_packages=(qt6-base-dev libqt6opengl6-dev qt6-svg-dev libqt6svg6 libgl-dev libvtk9-dev libqcustomplot-dev
  libqcustomplot2.1-qt6 fonts-dejavu-core)
test_packages=(libgtest-dev libgmock-dev libbenchmark-dev xvfb xauth libgl1-mesa-dri libglx-mesa0 imagemagick poppler-utils
  fonts-liberation fonts-noto-core fonts-freefont-ttf fonts-open-sans  # how the window looks with other fonts
  python3 dpkg-dev  # dpkg-dev: what a package depends on
  clang-format codespell doxygen  # form, spelling, and the pages of docs
  libmujoco-dev libsdformat-dev liburdfdom-dev  # readers of robot descriptions
  python3-rosbag python3-sensor-msgs python3-tf2-msgs  # writers of ROS 1 bags
  python3-rosmaster python3-rospy python3-trajectory-msgs python3-actionlib  # a ROS 1 robot for the example driver; 3 MB
  python3-opencv python3-scipy python3-yaml)  # writers of strangers' recordings
python_packages=(pybind11-dev python3-dev python3-numpy python3-venv python3-matplotlib)  # the module, an environment to try its wheel in, plots of the examples

new_packages=""
# install_missing WHY PACKAGE...: asks apt for those that are not there; says what and why before it does.
install_missing() {
  local why=$1 missing=() package
  shift
  for package in "$@"; do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return 0
  echo "Installing $why (with what they need; two minutes or so): ${missing[*]}"
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      echo "These packages are missing and only root may install them; as root: apt-get install ${missing[*]}" >&2
      return 1
    fi
    as_root=(sudo)
  fi
  "${as_root[@]}" apt-get update -qq
  local plan
  plan=$(apt-get install --assume-no --no-install-recommends "${missing[@]}" 2>/dev/null | grep -E 'newly installed|Need to get|disk space') || true
  [ -n "$plan" ] && echo "$plan"
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
  new_packages=yes  # what can be built may be more than before
}

# left_of SECONDS PERCENT: "about 7 minutes left", from how long the steps so far took.
left_of() {
  local left=$(($1 * (100 - $2) / $2))
  if [ "$left" -ge 100 ]; then echo "about $(((left + 30) / 60)) minutes left"; else echo "about $left s left"; fi
}

# How far ninja is and how long it will still take here: one line that changes on a terminal, elsewhere a line every
# twentieth; everything else as it comes.
show_progress() {
  local line next_told=2 shown="" progress='^\[ *([0-9]+)% ([0-9]+/[0-9]+) ([0-9]+)\.[0-9]* s\]'
  while IFS= read -r line; do
    if [[ $line =~ $progress ]]; then
      local percent=${BASH_REMATCH[1]} seconds=${BASH_REMATCH[3]} text
      text="[$percent % of the steps, $seconds s"
      if [ "$percent" -ge 2 ] && [ "$seconds" -ge 5 ]; then text+=", $(left_of "$seconds" "$percent")"; fi
      text+="]"
      if [ -t 1 ]; then
        printf '\r\033[K%s' "$text"
        shown=yes
      elif [ "$percent" -ge "$next_told" ]; then
        echo "$text"
        next_told=$((percent - percent % 5 + 5))
      fi
    elif [ "$line" != "ninja: no work to do." ] && [[ $line != "ninja: Entering directory"* ]]; then
      if [ -n "$shown" ]; then printf '\r\033[K'; fi
      printf '%s\n' "$line"
    fi
  done
  if [ -n "$shown" ]; then printf '\r\033[K'; fi
}

# build TARGET [WHAT]: configures once and builds; two builds at once wait for each other. Says what is built and how far
# it is; a fresh machine compiles for minutes.
build() {
  mkdir -p build
  exec 8>build/.lock
  if command -v flock >/dev/null; then flock 8; fi
  local status=0
  if [ ! -f build/build.ninja ] || [ -n "$new_packages" ]; then
    new_packages=""
    echo "Looking at what is installed (cmake)..."
    local compiler=()
    # clang, unless CC or CXX name another or the folder was begun with one: it takes half of GCC's time for the same bits.
    if [ ! -f build/CMakeCache.txt ] && [ -z "${CC:-}${CXX:-}" ] && command -v clang++ >/dev/null; then
      compiler=(-DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++)
    fi
    cmake -S . -B build -G Ninja "${compiler[@]}" >build/configure.txt 2>&1 || { cat build/configure.txt; status=1; }
  fi
  if [ $status -eq 0 ]; then
    local steps
    steps=$(ninja -C build -n "$1" 2>/dev/null | grep -c '^\[' || true)
    [ "$steps" -gt 20 ] && echo "Building ${2:-$1}: $steps steps on $(nproc) processors; the first time takes minutes, later seconds."
    (set -o pipefail; NINJA_STATUS='[%p %f/%t %e s] ' ninja -C build "$1" | show_progress) || status=1
  fi
  exec 8>&-
  return $status
}
