#!/usr/bin/env bash
# The tests with every access watched, and the checkpoint reader fed with broken bytes.
#
# Run     tests/sanitize.sh address           all tests under ASan and UBSan, leaks too, in build-address/
#         tests/sanitize.sh thread            those that use threads under TSan, in build-thread/
#         tests/sanitize.sh fuzz [seconds]    tests/fuzz with libFuzzer, ASan and UBSan, in build-fuzz/; 600 s unless told
# What follows address and thread goes to ctest.

# shellcheck source=scripts/setup.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/../scripts/setup.sh"

# What cannot pass for the sanitizer's sake alone.
not_under_asan=(
  script_objects      # bounds the memory that models take; ASan keeps what is freed
  script_install      # compiles a host program without the sanitizer against the engine with it
  script_startup      # bounds how long a script takes to begin
  script_cost         # these three weigh the seconds of runs against each other
  script_cost_effects
  script_cost_scenes
)

kind=${1:-}
shift || true
build=$root/build-$kind

# The tests, with the sanitizer loaded before Lua, which is not compiled with it. C++ comes along: it is to be there when errors are thrown.
tests() {
  build_targets all
  local runtime
  runtime=$(g++ -print-file-name="$1.so"):$(g++ -print-file-name=libstdc++.so)
  shift
  LD_PRELOAD=$runtime ctest --test-dir "$build" --output-on-failure --no-tests=error -j 2 --timeout 3000 "$@"
}

case $kind in
  address)
    install_missing
    options=(-DHINGE_SANITIZE=address)
    tests libasan -E "^($(IFS='|' && echo "${not_under_asan[*]}"))\$" "$@"
    ;;
  thread)
    install_missing
    options=(-DHINGE_SANITIZE=thread -DHINGE_PICTURES=OFF)
    tests libtsan -R '^(checkpoint_test|solver_test|script_threads)$' "$@"
    ;;
  fuzz)
    packages+=(clang libclang-rt-14-dev)
    install_missing
    options=(-DHINGE_SANITIZE=fuzzer -DHINGE_PICTURES=OFF -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++)
    build_targets checkpoint_fuzzer
    mkdir -p "$build/seeds" "$build/corpus" "$build/findings"
    HINGE_SEEDS=$build/seeds "$build/tests/checkpoint_fuzzer" "$build/corpus" "$build/seeds" \
      -max_total_time="${1:-600}" -timeout=10 -use_value_profile=1 -print_final_stats=1 -artifact_prefix="$build/findings/" ||
      stop "a finding is in $build/findings; $build/tests/checkpoint_fuzzer FILE shows it again"
    echo "hinge: no finding"
    ;;
  *) stop "tests/sanitize.sh address, thread or fuzz" ;;
esac
