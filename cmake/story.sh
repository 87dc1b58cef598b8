# SPDX-License-Identifier: Apache-2.0
# The command line's whole story on a sample session: story.sh HANDSIGHT_CLI. Works on a copy; the sample stays as it is.
set -euo pipefail
cli=$1
here=$(cd "$(dirname "$0")/.." && pwd)
work=$(mktemp -d "${TMPDIR:-/tmp}/handsight-story-XXXXXX")
trap 'rm -rf "$work"' EXIT
cp -r "$here/sample_sessions/first_steps" "$work/"
session=$work/first_steps

bold='' plain=''
if [ -t 1 ]; then bold=$'\033[1m' plain=$'\033[0m'; fi
step() { printf '\n%s%s%s\n' "$bold" "$1" "$plain"; }

step "1. What is in the session?"
"$cli" check "$session"
step "2. The first observation is labelled by hand: three clicks near the markers in the left image."
"$cli" label "$session" --observation 0 --left "421,338" "408,411" "473,378"
step "3. The others are tracked by themselves; each is taken, or rejected with its reason."
"$cli" online "$session" --save
step "4. TCP->Body from all of them, with its uncertainty."
"$cli" fit "$session" --export "$here/build/first_steps_calibration.xml"
step "5. Where is the TCP really, in a pose that was not measured?"
"$cli" predict "$session" --position "0 -0.2 0.6 -0.6 -0.9 0.2 1.4 0 0.2 0.4 -0.3 0.4"
step "The calibration is in build/first_steps_calibration.xml. Next: README.md, a five-minute tour; $(basename "$cli") --help."
