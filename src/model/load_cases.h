// Load cases: what a run takes of the loads that a script has declared.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace hinge {

class Model;

/// A sum of cases, each with its factor.
struct LoadCombination {
    std::string name;
    std::vector<std::pair<int, double>> factors;
};

/// What a run takes of the loads that a script has declared, by case.
struct LoadChoice {
    std::vector<double> factor;  ///< of each case
    std::vector<char> named;     ///< of each case: the script names it for this run
    bool is_static = false;      ///< loads with a history act only where their case is named, then in full
    /// The model of the run that it goes on from, null where there is none, and how far its loads have come, 1 in
    /// dynamics. Statics holds what acted there and brings on the difference.
    const Model* from = nullptr;
    double reached = 1;
};

/// The same as each load sees it, with what a static run holds: of each case, and of what belongs to none.
struct ChosenLoads {
    const LoadChoice& choice;
    std::vector<double> held;
    double held_permanent = 0;
};

/// Leaves in the list what the run has of them; one that statics holds and changes becomes two. `before`: those of the
/// run that it goes on from, or null. Returns how many with a history are set aside. T has a number of its own,
/// load_case, held, history, forget_history() and times(factor).
template <class T>
int choose_loads(std::vector<T>& list, const std::vector<T>* before, const ChosenLoads& chosen) {
    std::vector<T> taken;
    int aside = 0;
    const auto take = [&taken](T load, double factor, bool held) {
        if (factor == 0) return;
        if (factor != 1) load.times(factor);
        load.held = held;
        taken.push_back(std::move(load));
    };
    for (T& load : list) {
        const bool in_case = load.load_case >= 0;
        if (chosen.choice.is_static && load.history) {
            if (!in_case || !chosen.choice.named[load.load_case]) {
                ++aside;
                continue;
            }
            load.forget_history();
        }
        double held = 0;
        if (before && std::any_of(before->begin(), before->end(),
                                  [&](const T& b) { return b.number == load.number && !b.history; }))
            held = in_case ? chosen.held[load.load_case] : chosen.held_permanent;
        const double factor = in_case ? chosen.choice.factor[load.load_case] : 1;
        take(load, held, true);
        take(std::move(load), factor - held, false);
    }
    list = std::move(taken);
    return aside;
}

}  // namespace hinge
