// Effects that sleep while they have nothing to do.
#pragma once

#include <string>
#include <vector>

#include "effects/effect_list.h"

namespace hinge {

class Sleepers {
public:
    explicit Sleepers(const EffectList& effects) : list_(effects.sleepers), sleeps_(list_.size()) {}

    /// Once a step: effects wake when they have something to do, and sleep after a hundred steps without.
    void update(Host& host) {
        constexpr long quiet_steps = 100;
        for (std::size_t i = 0; i < list_.size(); ++i) {
            const InRole<Sleeper>& sleeper = list_[i];
            Sleep& s = sleeps_[i];
            if (sleeper->busy()) {
                if (!s.awake) host.note_activation(sleeper.effect->name(), true, sleeper->why_awake());
                s.awake = true;
                s.quiet = 0;
            } else if (s.awake && ++s.quiet >= quiet_steps) {
                s.awake = false;
                host.note_activation(sleeper.effect->name(), false,
                                     "nothing to do for " + std::to_string(quiet_steps) + " steps");
            }
        }
    }
    /// Whether that effect sleeps, and has nothing to do in the step that is tried.
    bool asleep(const Effect& effect) const {
        for (std::size_t i = 0; i < list_.size(); ++i)
            if (list_[i].effect == &effect) return !sleeps_[i].awake && !list_[i]->busy();
        return false;
    }
    /// Whether what was read from a checkpoint fits the effects.
    bool fits() const { return sleeps_.size() == list_.size(); }

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.sleeps_);
    }

private:
    struct Sleep {
        bool awake = false;
        long quiet = 0;  ///< steps without anything to do
        template <class Self, class A>
        static void fields(Self& s, A& a) {
            a(s.awake, s.quiet);
        }
    };
    const RoleList<Sleeper>& list_;
    std::vector<Sleep> sleeps_;
};

}  // namespace hinge
