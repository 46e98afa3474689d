#!/usr/bin/env bash
# What demo.sh, test.sh and package.sh share: installs what the system lacks and builds in release mode into build/.
# Quick when there is nothing to do. Debian 12, Ubuntu 24.04 or later, Fedora.
#
# Run     scripts/setup.sh                    installs what is missing, and no more
#         scripts/setup.sh --print [SYSTEM]   prints the commands that install and build, for this system or for debian,
#                                             ubuntu, fedora; does nothing
set -euo pipefail
root=$(CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd -P)
build=$root/build
options=()  # of cmake, beside the mode

# What each is for stands in lua/guide/install.md.
debian=(g++ cmake ninja-build libeigen3-dev libspectra-dev liblua5.4-dev lua5.4 libvtk9-dev nlohmann-json3-dev
  libcli11-dev libedit-dev zlib1g-dev libgif-dev xvfb fonts-dejavu-core
  gnuplot-nox tcl python3 dpkg-dev file)
# The tests hold the tree to these tools as Debian 12 has them, look at the page of hinge report in a browser, and
# submit a study to a Slurm of their own. python3-pandas: the guide's page on Python. ccache: two builds of one tree
# share what does not depend on the processor. demo.sh and package.sh do without.
debian_tests=(catch2 clang-format lua-check chromium-headless-shell nodejs slurm-wlm munge ccache python3-pandas)
fedora=(gcc-c++ cmake ninja-build eigen3-devel spectra-devel lua-devel lua vtk-devel json-devel cli11-devel
  libedit-devel zlib-devel giflib-devel libX11-devel libxcb-devel libglvnd-devel xorg-x11-server-Xvfb dejavu-sans-fonts
  gnuplot tcl python3)

stop() {
  echo "hinge: $*" >&2
  exit 1
}

# debian, ubuntu, fedora, or nothing: by the tools that are there, and by what the system calls itself.
this_system() {
  local ID='' ID_LIKE=''
  # shellcheck source=/dev/null
  [ ! -r "${os_release:=/etc/os-release}" ] || . "$os_release"
  if command -v dpkg-query >/dev/null; then
    case " $ID $ID_LIKE " in *" ubuntu "*) echo ubuntu ;; *) echo debian ;; esac
  elif command -v rpm >/dev/null && command -v dnf >/dev/null; then
    echo fedora
  fi
}

# Sets what depends on the system: packages, update, install, options of cmake.
choose_system() {
  local apt=(apt-get -q -o DPkg::Lock::Timeout=300)
  case $1 in
    debian | ubuntu)
      packages=("${debian[@]}")
      update=(env DEBIAN_FRONTEND=noninteractive "${apt[@]}" update)
      install=(env DEBIAN_FRONTEND=noninteractive "${apt[@]}" install -y --no-install-recommends)
      ;;
    fedora)
      packages=("${fedora[@]}")
      update=()
      install=(dnf install -y --setopt=install_weak_deps=False)
      ;;
    *) stop "no system '$1': debian, ubuntu or fedora" ;;
  esac
  if [ "$1" = debian ]; then packages+=("${debian_tests[@]}"); else options+=(-DHINGE_TESTS=OFF); fi
}

missing_packages() {
  local installed package
  if [ "$system" = fedora ]; then
    for package in "${packages[@]}"; do
      rpm -q --quiet --whatprovides "$package" || echo "$package"
    done
    return
  fi
  installed=$(dpkg-query -W -f='${db:Status-Status} ${Package}\n' "${packages[@]}" 2>/dev/null || true)
  for package in "${packages[@]}"; do
    grep -qxF "installed $package" <<<"$installed" || echo "$package"
  done
}

install_missing() {
  [ -n "$system" ] ||
    stop "this is neither Debian, Ubuntu nor Fedora: lua/guide/install.md lists what to install, and how to build"
  local missing as=()
  mapfile -t missing < <(missing_packages)
  [ ${#missing[@]} -eq 0 ] && return
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || stop "missing: ${missing[*]}; to install them, run this as root or install sudo"
    as=(sudo)
  fi
  echo "hinge: installing ${missing[*]}${as:+ with sudo}"
  [ ${#update[@]} -eq 0 ] || "${as[@]}" "${update[@]}" || stop "apt-get update failed; is the network there?"
  "${as[@]}" "${install[@]}" "${missing[@]}" || stop "${install[0]/env/apt-get} could not install ${missing[*]}"
}

# Whether build/ is a release build of this folder: it may have been copied here, or made by hand in another mode.
configured() {
  [ -f "$build/build.ninja" ] && grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$build/CMakeCache.txt" &&
    grep -qxF CMAKE_BUILD_TYPE:STRING=Release "$build/CMakeCache.txt"
}

# Leaves the tests out: of the packages, and of a first build. A build that has them already keeps them.
without_tests() {
  if [ "$system" = debian ]; then packages=("${debian[@]}"); fi
  [[ " ${options[*]} " = *HINGE_TESTS* ]] || options+=(-DHINGE_TESTS=OFF)
}

# Adds the tests to a build that was made without them. What was compiled stays.
with_tests() {
  if configured && grep -qxF HINGE_TESTS:BOOL=OFF "$build/CMakeCache.txt"; then
    cmake -S "$root" -B "$build" -DHINGE_TESTS=ON || stop "cmake failed; see above"
  fi
}

mode=(-G Ninja -DCMAKE_BUILD_TYPE=Release)
export CCACHE_BASEDIR=$root  # VTK has each build folder include a file of its own; ccache sees its path from there

build_targets() {
  { mkdir -p "$build" && [ -w "$build" ]; } 2>/dev/null ||
    stop "cannot write to $build; copy the repository to a folder you may write to"
  exec 9>"$build/.lock" && flock 9  # two of these at once would build over each other
  configured || cmake --fresh -S "$root" -B "$build" "${mode[@]}" "${options[@]}" || stop "cmake failed; see above"
  cmake --build "$build" --parallel "$(nproc)" --target "$@" || stop "the build failed; see above"
  exec 9>&-
}

# The commands on a bare system, to be pasted at the top level of the repository.
print_commands() {
  local as=()
  [ "$(id -u)" -eq 0 ] || as=(sudo)
  [ ${#update[@]} -eq 0 ] || echo "${as[@]}" "${update[@]}"
  echo "${as[@]}" "${install[@]}" "${packages[@]}"
  echo cmake -S . -B build "${mode[@]}" "${options[@]}"
  echo cmake --build build
}

system=$(this_system)
[ -z "$system" ] || choose_system "$system"

if [ "${BASH_SOURCE[0]}" = "$0" ]; then  # called, not sourced
  case ${1:-} in
    '') install_missing ;;
    --print)
      options=()
      [ -n "${2:-$system}" ] || stop "which system? debian, ubuntu or fedora"
      choose_system "${2:-$system}"
      print_commands
      ;;
    *) stop "setup.sh takes nothing, or --print [debian|ubuntu|fedora]" ;;
  esac
fi
