#include "core/thread_pool.h"

#include <string>
#include <system_error>

#include "core/errors.h"

namespace hinge {
namespace {

/// How often a thread looks again before it goes to sleep: about the time that waking it would take.
constexpr int patience = 20000;

}  // namespace

ThreadPool::ThreadPool(int threads) {
    try {
        for (int i = 1; i < threads; ++i) others_.emplace_back([this] { serve(); });
    } catch (const std::system_error& e) {
        dismiss();  // those that began would wait for work, and we for them
        throw OutsideError("cannot start " + std::to_string(threads) + " threads: " + e.code().message() +
                           "; ask for fewer");
    }
}

ThreadPool::~ThreadPool() { dismiss(); }

void ThreadPool::dismiss() {
    over_ = true;
    ++round_;
    round_.notify_all();
}

void ThreadPool::run(int pieces, const std::function<void(int)>& work) {
    work_ = &work;
    pieces_ = pieces;
    next_ = 0;
    busy_ = int(others_.size());
    ++round_;
    round_.notify_all();
    take_part();
    for (int left; (left = busy_) > 0;) {  // the others are at their last piece
        for (int i = 0; i < patience && busy_ == left; ++i) {}
        if (busy_ == left) busy_.wait(left);
    }
}

void ThreadPool::take_part() {
    for (int i; (i = next_.fetch_add(1)) < pieces_;) (*work_)(i);
}

void ThreadPool::serve() {
    unsigned seen = 0;
    for (;;) {
        for (int i = 0; i < patience && round_ == seen; ++i) {}
        round_.wait(seen);
        ++seen;
        if (over_) return;
        take_part();
        --busy_;
        busy_.notify_one();
    }
}

}  // namespace hinge
