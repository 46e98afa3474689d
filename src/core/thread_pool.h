// A pool of threads that share out loops. Who does which piece never shows in a result: pieces are cut the same way for
// any number of threads, and sums are added up in the order of the pieces.
#pragma once

#include <atomic>
#include <functional>
#include <thread>
#include <vector>

namespace hinge {

class ThreadPool {
public:
    explicit ThreadPool(int threads = 1);  ///< the calling one included
    ~ThreadPool();
    int threads() const { return int(others_.size()) + 1; }

    /// f(first, end, piece) for every piece of 0..count, `size` long but for the last. Returns when all are done. f
    /// must not throw.
    template <class F>
    void share(int count, int size, F f) {
        const int pieces = (count + size - 1) / size;
        const auto do_piece = [&](int i) { f(i * size, i + 1 < pieces ? (i + 1) * size : count, i); };
        if (others_.empty() || pieces < 2)
            for (int i = 0; i < pieces; ++i) do_piece(i);
        else run(pieces, do_piece);
    }

    /// The sum of f(first, end) over the pieces, in their order.
    template <class F>
    double sum(int count, int size, F f) {
        partial_.resize((count + size - 1) / size);
        share(count, size, [&](int first, int end, int piece) { partial_[piece] = f(first, end); });
        double all = 0;
        for (double p : partial_) all += p;
        return all;
    }

private:
    void run(int pieces, const std::function<void(int)>& work);
    void take_part();
    void serve();
    void dismiss();

    std::vector<double> partial_;
    const std::function<void(int)>* work_ = nullptr;
    int pieces_ = 0;
    std::atomic<unsigned> round_{0};
    std::atomic<int> next_{0}, busy_{0};
    std::atomic<bool> over_{false};
    std::vector<std::jthread> others_;  // last: they end before what they use
};

}  // namespace hinge
