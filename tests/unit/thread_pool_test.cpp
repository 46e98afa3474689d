// The thread pool: each piece once, in every loop, for any number of threads; sums with the same bits.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>

#include <catch2/catch.hpp>

#include "core/thread_pool.h"

using hinge::ThreadPool;

namespace {

/// Loops of all lengths up to 40 pieces, one right after the other; sometimes so late that the threads sleep.
/// Returns how many pieces were not done exactly once.
int wrong_pieces(int threads) {
    ThreadPool pool(threads);
    int wrong = pool.threads() != threads;
    for (int loop = 0; loop < 20000; ++loop) {
        const int count = loop % 157, size = 4;
        std::atomic<int> done[40] = {};
        std::atomic<int> items = 0;
        pool.share(count, size, [&](int first, int end, int piece) {
            ++done[piece];
            items += first == piece * size && end > first && end - first <= size ? end - first : 1000;
        });
        for (int i = 0; i < 40; ++i) wrong += done[i] != (i < (count + size - 1) / size);
        wrong += items != count;
        if (loop % 4000 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return wrong;
}

}  // namespace

TEST_CASE("each piece of a loop is done once, for any number of threads", "[threads]") {
    for (const int threads : {1, 2, 3, 8}) {
        CHECK(wrong_pieces(threads) == 0);
        std::vector<std::atomic<int>> times(10000);
        ThreadPool(threads).share(10000, 256, [&](int first, int end, int) {
            for (int i = first; i < end; ++i) ++times[i];
        });
        CHECK(std::all_of(times.begin(), times.end(), [](int n) { return n == 1; }));
    }
}

TEST_CASE("a sum has the same bits for any number of threads", "[threads]") {
    const auto sum = [](int threads) {
        ThreadPool pool(threads);
        return pool.sum(10007, 16, [](int first, int end) {
            double s = 0;
            for (int i = first; i < end; ++i) s += std::sin(i) * std::pow(10, i % 17);
            return s;
        });
    };
    CHECK(ThreadPool(2).sum(0, 16, [](int, int) { return 1.0; }) == 0);
    const double alone = sum(1);
    CHECK(std::isfinite(alone));
    for (const int threads : {2, 3, 8})
        for (int again = 0; again < 20; ++again) CHECK(sum(threads) == alone);
}

TEST_CASE("pools live in any thread and one beside the other", "[threads]") {
    std::atomic<int> wrong = 0;
    {
        std::vector<std::jthread> hosts;
        for (int i = 0; i < 3; ++i) hosts.emplace_back([&] { wrong += wrong_pieces(2); });
    }
    CHECK(wrong == 0);
}
