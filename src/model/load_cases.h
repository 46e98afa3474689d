// Load cases: selects and scales the declared loads for a run.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace hinge {

class Model;

/// A load combination: load cases with factors.
struct LoadCombination {
    std::string name;
    std::vector<std::pair<int, double>> factors;
};

/// Load cases of a run with their factors.
struct LoadChoice {
    std::vector<double> factor;  ///< of each case
    std::vector<char> named;     ///< of each case: true if the script names it for this run
    bool is_static = false;      ///< loads with a history act only where their case is named, then in full
    /// The model of the previous run, null if there is none, and the load factor that it reached, 1 in dynamics.
    /// Statics holds the previous loads and applies the difference.
    const Model* from = nullptr;
    double reached = 1;
};

/// A load choice with the factors that a static run holds constant: of each case, and of loads without a case.
struct ChosenLoads {
    const LoadChoice& choice;
    std::vector<double> held;
    double held_permanent = 0;
};

/// Selects and scales the loads of a run; a load that statics holds and changes becomes two. `before`: loads of the
/// previous run, or null. Returns the number of loads with a history that are left out. T has a unique number,
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
