#!/usr/bin/env bash
# The README's animation: a run's frames as one GIF. It needs ffmpeg (apt-get install ffmpeg).
#
# Run     scripts/pictures/animation.sh                         Case I into scripts/pictures/case1.gif, about a minute
#         scripts/pictures/animation.sh FOLDER FILE.gif [WIDTH] the frames of any run that hinge wrote into FOLDER
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
hinge=$here/../../build/hinge
folder=${1:-} file=${2:-$here/case1.gif} width=${3:-640}

if [ -z "$folder" ]; then
  folder=$(mktemp -d)
  trap 'rm -rf "$folder"' EXIT
  "$hinge" run --quiet "$here/../ten_storey_impact.lua" duration=0.15 frame_every=250 --out "$folder"
fi
"$hinge" render "$folder"
# Sixteen frames a second, one palette for all, and a second's rest on the last frame.
ffmpeg -v error -y -framerate 16 -pattern_type glob -i "$folder/frames/*.png" -filter_complex \
  "scale=$width:-1:flags=lanczos,tpad=stop_mode=clone:stop_duration=1,split[a][b];[a]palettegen=max_colors=40[p];[b][p]paletteuse=dither=none:diff_mode=rectangle" \
  "$file"
ls -l "$file"
