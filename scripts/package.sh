#!/usr/bin/env bash
# A Debian package for any processor of this kind: installs what is missing, builds without -march=native in
# build-package/, and packs.
#
# Run     scripts/package.sh                  on Debian 12, or Ubuntu 24.04 or later, for a system like it
# Expect  build-package/hinge_VERSION_ARCHITECTURE.deb; its last line says how to install it

# shellcheck source=scripts/setup.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/setup.sh"

[ "$system" = debian ] || [ "$system" = ubuntu ] ||
  stop "a Debian package is made on Debian or Ubuntu; elsewhere use cmake --install"
build=$root/build-package
options=(-DHINGE_NATIVE=OFF)
without_tests
install_missing
build_targets all
rm -f "$build"/*.deb
cpack --config "$build/CPackConfig.cmake" -B "$build" || stop "cpack failed; see above"
echo "sudo apt-get install '$(echo "$build"/hinge_*.deb)'"
