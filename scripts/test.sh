#!/usr/bin/env bash
# All tests: installs what is missing, builds, runs ctest and returns its exit status.
#
# Run     scripts/test.sh
#         scripts/test.sh -R contact          whatever follows goes to ctest

# shellcheck source=scripts/setup.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/setup.sh"

[ "${system:-debian}" = debian ] ||
  stop "the tests are held to the tools of Debian 12: Catch2 2, clang-format 14, luacheck"
install_missing
with_tests
build_targets all
exec ctest --test-dir "$build" --output-on-failure --no-tests=error -j 2 "$@"
