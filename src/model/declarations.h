// What a model declares for effects, and the load cases by which a run chooses among it.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/archive.h"
#include "core/types.h"
#include "model/load_cases.h"

namespace hinge {

/// Declarations of one effect (effects/*.cpp). They are copied with the model for each run.
class Declaration {
public:
    virtual ~Declaration() = default;
    virtual std::shared_ptr<Declaration> copy() const = 0;
    virtual std::size_t count() const = 0;  ///< number of declared objects, for the fingerprint of a checkpoint
    /// Writes all numbers that influence results, and of functions only their presence, for the same fingerprint.
    virtual void save(Writer& to) const = 0;
    /// Selects the loads of a run (choose_loads).
    virtual int choose(const Declaration* before, const ChosenLoads& chosen) { return (void)before, (void)chosen, 0; }
};

/// Declarations of an effect as a list of T. T lists its fields (core/archive.h), of functions only their presence.
/// T chooses the loads of a run by choose(list, before, chosen), or has what choose_loads needs.
template <class T>
class DeclaredList : public Declaration {
public:
    std::vector<T> list;
    std::shared_ptr<Declaration> copy() const override { return std::make_shared<DeclaredList>(*this); }
    std::size_t count() const override { return list.size(); }
    void save(Writer& to) const override { to(list); }
    int choose(const Declaration* before, const ChosenLoads& chosen) override {
        [[maybe_unused]] const auto* list_before = before ? &static_cast<const DeclaredList*>(before)->list : nullptr;
        if constexpr (requires { T::choose(list, list_before, chosen); }) return T::choose(list, list_before, chosen);
        else if constexpr (requires(T load) { load.times(1.0); }) return choose_loads(list, list_before, chosen);
        else return 0;
    }
};

/// Declarations of all effects by name. A copy is independent.
struct Declarations : std::map<std::string, std::shared_ptr<Declaration>> {
    Declarations() = default;
    Declarations(const Declarations& other) : std::map<std::string, std::shared_ptr<Declaration>>() {  // NOLINT: deep
        for (const auto& [effect, what] : other) emplace(effect, what->copy());
    }
    Declarations(Declarations&&) = default;
    Declarations& operator=(Declarations&&) = default;
};

/// Declarations of effects. Functions that change them raise InputError inside a step.
class EffectDeclarations {
public:
    /// Locks the model while a run of it is inside a step: every change then raises InputError.
    void lock(bool locked) { locked_ = locked; }
    /// Adds a declaration to the list of an effect; T is always the same for one name. `effect` is the name of an
    /// EffectKind. Raises InputError inside a step, as all functions that declare.
    template <class T>
    void declare(const std::string& effect, T what) {
        change_declared<T>(effect).push_back(std::move(what));
    }
    /// Declarations of an effect, to be changed.
    template <class T>
    std::vector<T>& change_declared(const std::string& effect) {
        check_open();
        auto& kept = declared_[effect];
        if (!kept) kept = std::make_shared<DeclaredList<T>>();
        return static_cast<DeclaredList<T>&>(*kept).list;
    }
    /// Declarations of an effect; empty if there are none.
    template <class T>
    const std::vector<T>& declared(const std::string& effect) const {
        static const std::vector<T> none;
        const auto at = declared_.find(effect);
        return at == declared_.end() ? none : static_cast<const DeclaredList<T>&>(*at->second).list;
    }
    const Declarations& declarations() const { return declared_; }
    /// Removes the declarations of an effect.
    void undeclare(const std::string& effect);
    /// A number for a declaration that can be removed: it rises with each call.
    int next_number() { return next_number_++; }
    /// Records the script line that requests an effect; the first one counts. asked_at returns it, or "".
    void ask(const std::string& effect, const std::string& line) { asked_.try_emplace(effect, line); }
    bool asked(const std::string& effect) const { return asked_.count(effect) > 0; }
    std::string asked_at(const std::string& effect) const { return asked(effect) ? asked_.at(effect) : ""; }

protected:
    void check_open() const;
    Declarations declared_;

private:
    int next_number_ = 0;
    bool locked_ = false;
    std::map<std::string, std::string> asked_;
};

/// Load cases and combinations; in a run's own copy of the model also their factors there.
class LoadCases : public EffectDeclarations {
public:
    int add_case(const std::string& name);
    int find_case(const std::string& name) const;  ///< -1 when there is none
    void add_combination(LoadCombination combination);
    const LoadCombination* find_combination(const std::string& name) const;
    const std::vector<std::string>& cases() const { return cases_; }
    const std::vector<LoadCombination>& combinations() const { return combinations_; }
    /// Selects and scales the loads of a run, in the run's own copy of the model. Without cases only is_static has an
    /// effect.
    void choose(const LoadChoice& choice);
    /// Factors of the load cases in a run, and those of the previous run that a static run holds. Empty without cases.
    const std::vector<double>& case_factors() const { return case_factors_; }
    const std::vector<double>& held_factors() const { return held_factors_; }
    bool holds_loads() const { return !held_factors_.empty(); }
    int set_aside() const { return set_aside_; }  ///< number of loads with a history that a static run leaves out

private:
    std::vector<std::string> cases_;
    std::vector<LoadCombination> combinations_;
    std::vector<double> case_factors_, held_factors_;
    double held_permanent_ = 0;  ///< of the loads without a case
    int set_aside_ = 0;
};

}  // namespace hinge
