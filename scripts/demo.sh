#!/usr/bin/env bash
# The main job: installs what is missing, builds, and flies a small aircraft into a ten-storey frame.
#
# Run     scripts/demo.sh                     Case I; the first call installs and builds, which takes minutes
#         scripts/demo.sh --case II           whatever follows goes to: hinge run scripts/ten_storey_impact.lua
# Expect  out/ten_storey_impact with summary.json, history.csv, frames.pvd and two pictures

# shellcheck source=scripts/setup.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/setup.sh"

without_tests
install_missing
build_targets hinge_program hinge_output hinge_module  # the module: what README.md says next is typed at once
exec "$build/hinge" run "$root/scripts/ten_storey_impact.lua" "$@"
