// The stages of a step and the time spent in each.
#pragma once

#include <chrono>
#include <vector>

#include "effects/all_effects.h"
#include "run/run.h"

namespace hinge {

class Stages {
public:
    int add(const char* name) {
        list_.push_back({name});
        return int(list_.size()) - 1;
    }
    template <class F>
    void timed(int stage, F f) {
        const auto start = std::chrono::steady_clock::now();
        f();
        list_[stage].seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
    std::vector<StageTime> times() const {
        std::vector<StageTime> times;
        for (const Stage& s : list_) times.push_back({s.name, s.seconds});
        return times;
    }
    void add_to(std::vector<PlanLine>& plan) const {
        for (const Stage& s : list_) add_stage_time(s.name, s.seconds, plan);
    }
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        for (auto& stage : s.list_) a(stage.seconds);
    }

private:
    struct Stage {
        const char* name;
        double seconds = 0;
    };
    std::vector<Stage> list_;
};

}  // namespace hinge
