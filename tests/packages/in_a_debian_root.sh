#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# in_a_debian_root.sh ROOT SAMPLE DEB...: installs the packages in a new Debian 12 (debootstrap; root and a network are needed) and
# runs what they bring. Not part of ./test.
set -euo pipefail
root=$1 sample=$2
shift 2
if [ ! -d "$root/usr" ]; then debootstrap --variant=minbase bookworm "$root" http://deb.debian.org/debian; fi
# Programs find what they load beside themselves by /proc.
mountpoint -q "$root/proc" || mount -t proc proc "$root/proc"
trap 'umount "$root/proc"' EXIT
mkdir -p "$root/packages" "$root/session"
cp "$@" "$root/packages/"
cp -r "$sample/." "$root/session/"
inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }
inside apt-get update -qq
inside sh -c 'apt-get install -y -qq --no-install-recommends /packages/*.deb' >/dev/null
inside handsight-cli check /session | tail -1
rm -rf "$root/made"
inside handsight-cli simulate --like /session --observations 20 --out /made
inside handsight-cli fit /made | head -8
if inside test -x /usr/bin/handsight; then
  inside ldd /usr/bin/handsight | grep 'not found' && exit 1
  inside env QT_QPA_PLATFORM=offscreen handsight --version
fi
inside apt-get remove -y -qq handsight-cli >/dev/null
! inside test -e /usr/bin/handsight-cli
echo "Installed, run and removed in $(cat "$root/etc/debian_version")."
