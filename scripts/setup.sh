# shellcheck shell=bash
# Sourced by demo.sh and test.sh: installs what Debian 12 lacks and builds in release mode into build/.
# Both are quick when there is nothing to do.
set -euo pipefail
root=$(CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd -P)
build=$root/build
options=()  # of cmake, beside the mode

# What each is for stands in README.md.
packages=(g++ cmake ninja-build libeigen3-dev libspectra-dev liblua5.4-dev lua5.4 catch2 libvtk9-dev nlohmann-json3-dev
  libcli11-dev libedit-dev zlib1g-dev xvfb fonts-dejavu-core clang-format lua-check)

stop() {
  echo "hinge: $*" >&2
  exit 1
}

missing_packages() {
  local installed package
  installed=$(dpkg-query -W -f='${db:Status-Status} ${Package}\n' "${packages[@]}" 2>/dev/null || true)
  for package in "${packages[@]}"; do
    grep -qxF "installed $package" <<<"$installed" || echo "$package"
  done
}

install_missing() {
  command -v dpkg-query >/dev/null ||
    stop "this is not Debian (no dpkg-query): install what README.md lists, then cmake -S . -B build && cmake --build build"
  local missing as=()
  mapfile -t missing < <(missing_packages)
  [ ${#missing[@]} -eq 0 ] && return
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || stop "missing: ${missing[*]}; to install them, run this as root or install sudo"
    as=(sudo)
  fi
  echo "hinge: installing ${missing[*]}${as:+ with sudo}"
  local apt=("${as[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300)
  "${apt[@]}" update || stop "apt-get update failed; is the network there?"
  "${apt[@]}" install -y --no-install-recommends "${missing[@]}" || stop "apt-get could not install ${missing[*]}"
}

# Whether build/ is a release build of this folder: it may have been copied here, or made by hand in another mode.
configured() {
  [ -f "$build/build.ninja" ] && grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$build/CMakeCache.txt" &&
    grep -qxF CMAKE_BUILD_TYPE:STRING=Release "$build/CMakeCache.txt"
}

build_targets() {
  { mkdir -p "$build" && [ -w "$build" ]; } 2>/dev/null ||
    stop "cannot write to $build; copy the repository to a folder you may write to"
  exec 9>"$build/.lock" && flock 9  # two of these at once would build over each other
  configured || cmake --fresh -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release "${options[@]}" || stop "cmake failed; see above"
  cmake --build "$build" --parallel "$(nproc)" --target "$@" || stop "the build failed; see above"
  exec 9>&-
}
