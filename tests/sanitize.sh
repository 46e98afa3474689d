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
  script_objects      # these two bound the memory of the process; ASan keeps for a while what is freed
  script_isolation
  script_sandbox      # these bound the address space; ASan asks for terabytes of it
  script_guide_sandbox
  script_size
  script_study
  script_interrupt
  script_cost
  script_install      # the compiler, which the test calls, leaks
  script_package      # empties the environment, and with it the sanitizer that is to be loaded before Lua
  script_startup      # bounds how long a script takes to begin
  script_sandbox_walls  # its walls forbid what the leak checker does when a process ends
  script_slurm        # starts daemons, which would get the sanitizer too
)
# Mesa leaks in our own process.
leaks_of_others=(output_test)

kind=${1:-}
shift || true
build=$root/build-$kind

# The tests with the sanitizer loaded before Lua, which is not compiled with it; and C++, which is to be there when errors
# are thrown. What the tests start has the sanitizer too: leaks count in the programs that tests/asan names.
tests() {
  local runtime
  runtime=$(g++ -print-file-name="$1.so"):$(g++ -print-file-name=libstdc++.so)
  shift
  ASAN_OPTIONS=detect_leaks=0:include_if_exists=$root/tests/asan/%b HINGE_SANITIZED=1 \
    LD_PRELOAD=$runtime ctest --test-dir "$build" --output-on-failure -j 2 "$@"
}
any_of() (IFS='|' && echo "^($*)\$")

case $kind in
  address)
    install_missing
    options=(-DHINGE_SANITIZE=address)
    build_targets all
    failed=0
    tests libasan -E "$(any_of "${not_under_asan[@]}" "${leaks_of_others[@]}")" "$@" || failed=1
    ASAN_OPTIONS=detect_leaks=0 tests libasan -R "$(any_of "${leaks_of_others[@]}")" || failed=1
    exit $failed
    ;;
  thread)
    install_missing
    options=(-DHINGE_SANITIZE=thread -DHINGE_PICTURES=OFF)
    build_targets all
    tests libtsan -R "$(any_of checkpoint_test solver_test script_threads)" "$@"
    ;;
  fuzz)
    packages+=(clang libclang-rt-14-dev)
    install_missing
    options=(-DHINGE_SANITIZE=fuzzer -DHINGE_PICTURES=OFF -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++)
    build_targets checkpoint_fuzzer
    mkdir -p "$build/seeds" "$build/corpus" "$build/findings"
    HINGE_SEEDS=$build/seeds "$build/tests/checkpoint_fuzzer" "$build/corpus" "$build/seeds" \
      -max_total_time="${1:-600}" -timeout=10 -print_final_stats=1 -artifact_prefix="$build/findings/" ||
      stop "a finding is in $build/findings; $build/tests/checkpoint_fuzzer FILE shows it again"
    echo "hinge: no finding"
    ;;
  *) stop "tests/sanitize.sh address, thread or fuzz" ;;
esac
