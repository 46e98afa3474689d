// A pool of threads for parallel loops. Results do not depend on the number of threads: a loop is always divided into
// the same pieces, and sums are added in the order of the pieces.
//
// A loop ends when its pieces are done, even if some threads have not woken. Each thread begins with its own part of
// the pieces, the same in every loop of that length, so its data stay in its cache; then it takes pieces of other
// threads.
//
// OpenMP and oneTBB were measured in its place, with the same bits (us a step of frames of 1,300 and 20,202 elements on
// two cores, medians of alternating runs):
//
//                        1,300 Newmark   1,300 explicit   20,202 Newmark   20,202 explicit
//   one thread                137              52              2640               995
//   two, this pool            139              53              1514               554
//   two, oneTBB 2021.8        138              47              1499               546
//   two, OpenMP (gcc 12)      136              47              1668               605
//
// Where other programs use the cores too, OpenMP's threads spin on them at the end of each loop: an explicit step of
// 1,300 elements then took 5,900 us and one by Newmark's method of 20,202 elements 14,000, where this pool is within 3
// % of one thread. Only the environment can change that, before the program starts, and the engine also runs inside
// programs of others. OpenMP ends the program where a thread cannot start; oneTBB does not report it, and warns on the
// standard error stream where there are more threads than cores. The thread sanitizer, which checks this pool
// (tests/sanitize.sh), can check neither.
#pragma once

#include <atomic>
#include <functional>
#include <thread>
#include <vector>

namespace hinge {

/// Cores that this process may use: those of its affinity, no more than the quota of its control group (Linux, version
/// 2), divided by the number of processes that share them.
int usable_cores();
/// This process is one of so many that work side by side, as the cases of a study do.
void share_cores_among(int processes);
/// Threads for a model of so many elements: one for each thousand, no more than there are cores, and sixteen. On two
/// cores of a shared machine two threads were 1.3 times as fast as one at 2,000 elements, 1.6 times at 10,000 and
/// 100,000 (explicit steps 1.1 and 1.3 times); at 1,040 an explicit step was 4 % slower.
int threads_for(std::size_t elements);

/// A fixed number of threads that execute the pieces of loops.
class ThreadPool {
public:
    /// The calling thread included. `or_fewer`: where the system starts no more of them, those it has started do; else
    /// that throws OutsideError.
    explicit ThreadPool(int threads = 1, bool or_fewer = false);
    ~ThreadPool();
    int threads() const { return int(others_.size()) + 1; }

    /// Calls f(first, end, piece) for every piece of 0..count; all but the last are `size` long. Returns when all are
    /// done. f must not throw.
    template <class F>
    void share(int count, int size, F f) {
        const int pieces = (count + size - 1) / size;
        const auto do_piece = [&](int i) { f(i * size, i + 1 < pieces ? (i + 1) * size : count, i); };
        if (others_.empty() || pieces < 2 || of_other_process())
            for (int i = 0; i < pieces; ++i) do_piece(i);
        else run(pieces, do_piece);
    }

    /// Sums f(first, end) over the pieces, in their order.
    template <class F>
    double sum(int count, int size, F f) {
        partial_.resize((count + size - 1) / size);
        share(count, size, [&](int first, int end, int piece) { partial_[piece] = f(first, end); });
        double all = 0;
        for (double p : partial_) all += p;
        return all;
    }

private:
    bool of_other_process() const;
    void run(int pieces, const std::function<void(int)>& work);
    void take_pieces(std::size_t own);
    void serve(std::size_t own);
    void dismiss();

    const unsigned process_;  ///< in which its threads are: a process that is forked has none of them
    std::vector<double> partial_;
    const std::function<void(int)>* work_ = nullptr;
    /// The pieces of a loop with which one thread begins, taken from the last to the first.
    struct alignas(64) Part {  // a line of the cache
        int first = 0;
        std::atomic<int> left{0};
    };
    std::vector<Part> parts_;
    std::atomic<int> unfinished_{0};  ///< pieces
    std::atomic<unsigned> round_{0};
    std::atomic<bool> over_{false};
    std::vector<std::jthread> others_;  // last: they end before what they use
};

}  // namespace hinge
