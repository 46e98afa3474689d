// The time that each effect takes in the steps of dynamics. It is measured in some of the steps only, spread over the
// run: to read the clock at each call would cost more than an idle effect.
#pragma once

#include <algorithm>
#include <chrono>
#include <map>
#include <memory>
#include <string>

#include "effects/effect_list.h"

namespace hinge {

class EffectTimes {
public:
    /// A step begins: one of `planned`.
    void begin_step(long step, long planned) {
        every_ = std::clamp(planned / least_steps, 1L, most_apart);
        measures_ = step % every_ == 0;
    }
    /// Calls f(role) for each effect in the list.
    template <class Role, class F>
    void each(const RoleList<Role>& list, F f) {
        for (const InRole<Role>& r : list) timed(*r.effect, [&] { f(*r.role); });
    }
    template <class F>
    void each(const std::vector<std::unique_ptr<Effect>>& list, F f) {
        for (const auto& effect : list) timed(*effect, [&] { f(*effect); });
    }
    /// Adds the time of each effect, s, to its line of the plan.
    void add_to(std::vector<PlanLine>& plan) const {
        for (PlanLine& line : plan)
            if (const auto found = seconds_.find(line.name); line.active && found != seconds_.end())
                line.seconds += found->second;
    }
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.seconds_);
    }

private:
    static constexpr long least_steps = 100;  ///< that are measured: with 100 an even load is known to some percent
    static constexpr long most_apart = 61;    ///< a prime: what comes at every 2nd, 5th or 32nd step is not missed

    template <class F>
    void timed(const Effect& effect, F f) {
        if (!measures_) return f();
        const auto start = std::chrono::steady_clock::now();
        f();
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
        seconds_[effect.name()] += double(every_) * took.count();
    }

    std::map<std::string, double> seconds_;
    long every_ = 1;
    bool measures_ = true;
};

}  // namespace hinge
