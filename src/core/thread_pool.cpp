#include "core/thread_pool.h"

#include <pthread.h>
#include <sched.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <system_error>

#include "core/errors.h"

namespace hinge {
namespace {

/// Number of checks by a thread before it sleeps: some 100 us, about the time that waking it would take. Between checks
/// it yields the core to other threads.
constexpr int patience = 300;

template <class Number>
void look_again(const std::atomic<Number>& value, Number seen) {
    for (int i = 0; i < patience && value == seen; ++i) std::this_thread::yield();
}

constexpr std::size_t elements_of_thread = 1000;
constexpr int most_threads = 16;

/// How many times this process has been forked from one that had loaded the engine.
std::atomic<unsigned> forks{0};
[[maybe_unused]] const int counts_forks = ::pthread_atfork(nullptr, nullptr, [] { ++forks; });
std::atomic<int> processes_side_by_side{1};

/// Cores of time that the control group lets this process have; 0: no limit is known.
int quota_of_group() {
    std::ifstream file("/sys/fs/cgroup/cpu.max");
    double quota = 0, period = 0;  // us; "max" is no number
    if (!(file >> quota >> period) || !(quota > 0 && period > 0)) return 0;
    return std::max(1, int(quota / period));
}

}  // namespace

int usable_cores() {
    static const int quota = quota_of_group();
    cpu_set_t set;
    CPU_ZERO(&set);
    int cores = ::sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 1;
    if (quota > 0) cores = std::min(cores, quota);
    return std::max(1, cores / processes_side_by_side);
}

void share_cores_among(int processes) { processes_side_by_side = std::max(1, processes); }

int threads_for(std::size_t elements) {
    const std::size_t most = std::size_t(std::min(usable_cores(), most_threads));
    return int(std::clamp(elements / elements_of_thread, std::size_t(1), most));
}

ThreadPool::ThreadPool(int threads, bool or_fewer) : process_(forks), parts_(std::max(threads, 1)) {
    try {
        for (int i = 1; i < threads; ++i) others_.emplace_back([this, i] { serve(i); });
    } catch (const std::system_error& e) {
        if (or_fewer) return;
        dismiss();  // those that began would wait for work, and we for them
        throw OutsideError("cannot start " + std::to_string(threads) + " threads: " + e.code().message() +
                           "; ask for fewer");
    }
}

ThreadPool::~ThreadPool() { dismiss(); }

bool ThreadPool::of_other_process() const { return process_ != forks; }

void ThreadPool::dismiss() {
    if (of_other_process())
        for (std::jthread& other : others_) other.detach();  // it is not here, and would be waited for
    over_ = true;
    ++round_;
    round_.notify_all();
}

void ThreadPool::run(int pieces, const std::function<void(int)>& work) {
    const auto first = [&](std::size_t part) { return int(std::size_t(pieces) * part / parts_.size()); };
    work_ = &work;
    unfinished_ = pieces;
    for (std::size_t i = 0; i < parts_.size(); ++i) parts_[i].first = first(i);
    for (std::size_t i = 0; i < parts_.size(); ++i)
        parts_[i].left = first(i + 1) - first(i);  // from here on all may take
    ++round_;
    round_.notify_all();
    take_pieces(0);
    for (int left; (left = unfinished_) > 0;) {  // the others are at their last piece
        look_again(unfinished_, left);
        unfinished_.wait(left);
    }
}

/// Whoever finds no piece left must look at nothing else of the loop: it may be over, and the next one in the making.
void ThreadPool::take_pieces(std::size_t own) {
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        Part& part = parts_[(own + i) % parts_.size()];
        for (int left; (left = part.left.fetch_sub(1)) > 0;) {
            (*work_)(part.first + left - 1);
            if (unfinished_.fetch_sub(1) == 1) unfinished_.notify_one();
        }
    }
}

void ThreadPool::serve(std::size_t own) {
    for (unsigned seen = 0; !over_;) {
        take_pieces(own);
        look_again(round_, seen);
        round_.wait(seen);
        seen = round_;
    }
}

}  // namespace hinge
