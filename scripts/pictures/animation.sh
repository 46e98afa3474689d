#!/usr/bin/env bash
# The README's animation: Case I as a GIF, by hinge render.
#
# Run     scripts/pictures/animation.sh [FILE.gif]      into scripts/pictures/case1.gif, about half a minute
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
hinge=$here/../../build/hinge
file=${1:-$here/case1.gif}

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$hinge" run --quiet "$here/../ten_storey_impact.lua" duration=0.15 frame_every=250 --out "$folder"
# Sixteen pictures a second: twenty-five times slower than it was.
"$hinge" render "$folder" --gif --fps 16 --size 640x480 --title "Case I" --out "$file"
