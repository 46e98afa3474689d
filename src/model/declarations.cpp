#include "model/declarations.h"

#include <algorithm>

#include "core/errors.h"
#include "model/model.h"

namespace hinge {

void EffectDeclarations::undeclare(const std::string& effect) { check_open(), declared_.erase(effect); }

void EffectDeclarations::check_open() const {
    if (locked_)
        throw InputError(
            "the model cannot be changed while a run of it is inside a step; change it between steps, or before the "
            "run is made");
}

int LoadCases::add_case(const std::string& name) {
    check_open();
    cases_.push_back(name);
    return int(cases_.size()) - 1;
}

int LoadCases::find_case(const std::string& name) const {
    const auto at = std::find(cases_.begin(), cases_.end(), name);
    return at == cases_.end() ? -1 : int(at - cases_.begin());
}

void LoadCases::add_combination(LoadCombination combination) {
    check_open(), combinations_.push_back(std::move(combination));
}

const LoadCombination* LoadCases::find_combination(const std::string& name) const {
    const auto at =
        std::find_if(combinations_.begin(), combinations_.end(), [&](const auto& c) { return c.name == name; });
    return at == combinations_.end() ? nullptr : &*at;
}

void LoadCases::choose(const LoadChoice& choice) {
    if (cases_.empty() && !choice.is_static) return;
    const LoadCases* from = cases_.empty() ? nullptr : choice.from;
    const auto acted = [&](double held, double whole) { return held + choice.reached * (whole - held); };
    ChosenLoads chosen{choice, std::vector<double>(cases_.size(), 0.0)};
    const bool holds = choice.is_static && from;
    if (holds) {
        for (std::size_t i = 0; i < from->case_factors_.size(); ++i)
            chosen.held[i] = acted(from->holds_loads() ? from->held_factors_[i] : 0, from->case_factors_[i]);
        chosen.held_permanent = acted(from->held_permanent_, 1);
    }
    set_aside_ = 0;
    for (auto& [effect, what] : declared_) {
        const auto before = holds ? from->declared_.find(effect) : declared_.end();
        set_aside_ += what->choose(holds && before != from->declared_.end() ? before->second.get() : nullptr, chosen);
    }
    if (cases_.empty()) return;
    case_factors_ = choice.factor;
    if (holds) held_factors_ = chosen.held, held_permanent_ = chosen.held_permanent;
}

}  // namespace hinge
