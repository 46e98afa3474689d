#!/usr/bin/env bash
# Makes lua/hinge/report/viewer.js, the one file that a report holds, from src and three.js. Needed only after a change
# of src: the file is part of the tree. built.sha256 lists the hashes of all that went into it;
# tests/script/report/viewer_test.lua compares them, without npm.
#
# Run     src/viewer/build.sh          needs Node.js 18 or later, with npm
#         src/viewer/build.sh --check  makes it elsewhere, and says whether the tree's is the same
set -euo pipefail
cd "$(dirname -- "${BASH_SOURCE[0]}")"
made=../../lua/hinge/report/viewer.js
out=$made
if [ "${1:-}" = --check ]; then
  out=$(mktemp)
  trap 'rm -f "$out"' EXIT
fi

[ -d node_modules ] || npm ci --ignore-scripts --no-audit --no-fund
{
  echo '/* The player of hinge report, made by src/viewer/build.sh. It holds parts of three.js:'
  cat node_modules/three/LICENSE
  echo '*/'
  node_modules/.bin/esbuild src/main.js --bundle --minify --format=iife --target=es2022 --charset=utf8 \
    --loader:.css=text --legal-comments=none --log-level=warning
} >"$out"
if [ "${1:-}" = --check ]; then
  cmp -- "$out" "$made" && echo "$made is what these sources make"
else
  cd ../..
  LC_ALL=C  # the order of the list
  sha256sum -- "${made#../../}" src/viewer/build.sh src/viewer/package*.json src/viewer/src/* >src/viewer/built.sha256
fi
