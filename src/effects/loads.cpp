// Loads on nodes: numbers with a history, or functions of time and the run.
#include "effects/loads.h"

#include <algorithm>
#include <map>

#include "core/text.h"
#include "effects/history_jump.h"
#include "effects/kinds.h"

namespace hinge {
namespace {

class Loads : public Effect, public Load, public StepLimiter {
public:
    Loads(Workspace& w, Host& host)
        : Effect(loads_effect, w, host, {.mean_forces = true}),
          declared_(w.structure.model().declared<NodalLoad>(loads_effect)) {
        std::vector<int> place(w.structure.position().size(), -1);
        for (const NodalLoad& load : declared_) {
            if (place[load.node] < 0) {
                place[load.node] = int(loaded_.size());
                loaded_.push_back({load.node});
            }
            if (load.follows_state()) values_[load_at_.size()] = {};
            if (load.history && load.history.may_jump_in(steep * w.kind.dt)) {
                const double factor = load.history.from(w.state.time);
                jumping_[load_at_.size()] = {factor, factor, factor};
            }
            load_at_.push_back(place[load.node]);
            traits_.calls_script =
                traits_.calls_script || load.follows_state() || (load.history && !load.history.points());
        }
        traits_.forces_vanish = !values_.empty() || !jumping_.empty();
    }

    /// A run has no loads with a history in statics (Model::choose). The linear solution that decides on elements has,
    /// and takes them as they are at time 0, or in full where that is nothing.
    void add_static_loads(const Pose&, std::vector<Vec6>& external) const override {
        for (const NodalLoad& l : declared_) {
            if (l.held) continue;
            const double factor = l.history ? l.history(0) : 1.0;
            external[l.node].head<3>() += (l.history && factor == 0 ? 1.0 : factor) * l.force;
            external[l.node].tail<3>() += (l.history && factor == 0 ? 1.0 : factor) * l.moment;
        }
    }
    void add_held_loads(const Pose&, std::vector<Vec6>& external) const override {
        for (const NodalLoad& l : declared_)
            if (l.held) external[l.node].head<3>() += l.force, external[l.node].tail<3>() += l.moment;
    }

    /// F at the end of the step. What functions of the state give where a run begins is known in its first step only:
    /// the first acceleration is recomputed with it. So it is where a history has jumped.
    void begin(const Step& step) override {
        const bool jumped = find_jumps(step);
        if (!begun_ && !values_.empty()) {
            call_functions(step.begin);
            keep_values();
            found_anew_ =
                std::any_of(values_.begin(), values_.end(), [](const auto& a) { return !a.second.kept.isZero(0); });
            if (found_anew_) return host_.accelerations_anew();
            begun_ = true;
        }
        if (jumped) {
            found_anew_ = true;
            if (w_.kind.explicit_steps) leave_jump(step.dt);
            return host_.accelerations_anew();
        }
        call_functions(step.end());
        act(step.end(), &FunctionValue::tried, &StepFactor::end);
    }
    void act_at(double time) override { act(time, &FunctionValue::kept, &StepFactor::begin); }
    void acceleration_found() override {
        if (!found_anew_) return;
        begun_ = true, found_anew_ = false;
        if (!left_.empty()) arrive_from_jump();
        for (LoadedNode& l : loaded_) l.before = l.now;
        for (auto& [i, b] : jumping_) b.kept = b.begin;
    }

    void started(const std::vector<Vec6>&) override {
        for (LoadedNode& l : loaded_) l.before = l.now;
    }

    /// By the trapezium rule.
    void accumulate_energy(const Step&, Accounts& sums) const override {
        double work = of_jumps_;
        for (const LoadedNode& l : loaded_) {
            const Vec6 mean = 0.5 * (l.now + l.before);
            work += mean.head<3>().dot(w_.trial.displacement[l.node] - w_.state.displacement[l.node]) +
                    mean.tail<3>().dot(w_.rotation_step[l.node]);
        }
        sums["work"] += work;
    }

    void before_commit(const Step&) override {
        for (LoadedNode& l : loaded_) l.before = l.now;
        for (auto& [i, b] : jumping_) b.kept = b.end;
        of_jumps_ = 0;
        keep_values();
    }

    void show_loads(std::vector<ShownLoad>& to) const override {
        const auto show = [&](int node, const Vec6& f) {
            if (!f.isZero(0)) to.push_back({node, -1, -1, {f.head<3>(), Vec3::Zero()}, {f.tail<3>(), Vec3::Zero()}});
        };
        if (w_.kind.dynamic) {
            for (const LoadedNode& l : loaded_) show(l.node, l.now);
            return;
        }
        for (const NodalLoad& l : declared_) {
            Vec6 f;
            f << l.force, l.moment;
            show(l.node, (l.held ? 1 : w_.state.factor) * f);
        }
    }

    void keep_from_rest(const Bodies& bodies, std::vector<char>& rests) const override {
        for (const NodalLoad& l : declared_)
            if ((l.history || l.follows_state()) && bodies.of_node[l.node] >= 0) rests[bodies.of_node[l.node]] = 0;
    }
    bool allows_long_step() const override { return values_.empty(); }
    bool is_unsymmetric() const override {
        return std::any_of(declared_.begin(), declared_.end(), [](const NodalLoad& l) { return !l.moment.isZero(); });
    }
    bool changes_within(double now, std::span<const double> after) const override {
        for (const NodalLoad& load : declared_) {
            if (!load.history || is_gone(load.node)) continue;
            if (load.history.bends_within(now, now + after.back())) return true;
            const double factor = load.history(now);
            for (const double t : after)
                if (load.history(now + t) != factor) return true;
        }
        return false;
    }

    void save(Writer& to) const override { fields(*this, to); }
    void restore(Reader& from) override { fields(*this, from); }

private:
    /// A node with loads: F is the sum of what is steady there and what acts now.
    struct LoadedNode {
        int node;
        Vec6 now = Vec6::Zero(), before = Vec6::Zero();
    };
    /// Values of a function of the state at the end of the last step, and for the end of this one.
    struct FunctionValue {
        Vec6 kept = Vec6::Zero(), tried = Vec6::Zero();
    };
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        for (auto& l : s.loaded_) a(l.now, l.before);
        for (auto& [load, value] : s.values_) a(value.kept);
        for (auto& [load, b] : s.jumping_) a(b.kept, b.begin, b.end);
        a(s.begun_);
    }

    /// A support that joints alone join to its members is no part of the state, and takes loads all the same.
    bool is_gone(int node) const { return w_.state.gone[node] && !w_.structure.is_alone(node); }

    void call_functions(double t) {
        for (auto& [i, value] : values_) {
            const NodalLoad& load = declared_[i];
            if (is_gone(load.node)) continue;
            if (load.force_rule) value.tried.head<3>() = load.force_rule(t);
            if (load.moment_rule) value.tried.tail<3>() = load.moment_rule(t);
        }
    }
    void keep_values() {
        for (auto& [i, value] : values_) value.kept = value.tried;
    }
    /// Finds the factors of the coming step. True where one does not begin with what the acceleration was found with.
    bool find_jumps(const Step& step) {
        bool jumped = false;
        for (auto& [i, b] : jumping_) {
            const History::Over over = declared_[i].history.over(step.begin, step.end());
            b.begin = over.begin, b.end = over.end;
            jumped = jumped || b.jumps();
        }
        return jumped;
    }
    /// The kinetic energy of explicit steps, by the trapezium rule for the velocities, is ahead of the work by dt^2/8 a
    /// M a wherever a step ends. It goes away again as the acceleration does, but where the acceleration is recomputed
    /// it stays: dt^2/8 (F1 - F2) (a1 + a2) belongs to the work of a jump from F1 to F2.
    void leave_jump(double dt) {
        left_.clear();
        left_by_ = dt * dt / 8;
        for (const LoadedNode& l : loaded_) left_.push_back(w_.state.acceleration[l.node]);
    }
    void arrive_from_jump() {
        for (std::size_t i = 0; i < loaded_.size(); ++i)
            of_jumps_ +=
                left_by_ * (loaded_[i].before - loaded_[i].now).dot(left_[i] + w_.state.acceleration[loaded_[i].node]);
        left_.clear();
    }
    /// Only nodes with loads change.
    void act(double t, Vec6 FunctionValue::*which, double StepFactor::*of_step) {
        for (LoadedNode& l : loaded_) l.now.setZero();
        auto jumping = jumping_.begin();
        for (std::size_t i = 0; i < declared_.size(); ++i) {
            const NodalLoad& load = declared_[i];
            const bool may_jump = jumping != jumping_.end() && jumping->first == i;
            const double in_step = may_jump ? (jumping++)->second.*of_step : 0;
            if (is_gone(load.node)) continue;
            const double factor = may_jump ? in_step : load.history ? load.history(t) : 1.0;
            loaded_[load_at_[i]].now.head<3>() += factor * load.force;
            loaded_[load_at_[i]].now.tail<3>() += factor * load.moment;
        }
        for (const auto& [i, value] : values_)
            if (!is_gone(declared_[i].node)) loaded_[load_at_[i]].now += value.*which;
        for (const LoadedNode& l : loaded_)
            if (!w_.rests(l.node)) w_.external[l.node] = w_.steady[l.node] + l.now;
    }

    const std::vector<NodalLoad>& declared_;
    std::vector<LoadedNode> loaded_;
    std::map<std::size_t, FunctionValue> values_;  ///< of the loads that are functions of the state
    std::map<std::size_t, StepFactor> jumping_;    ///< of the loads whose history may jump within a step
    std::vector<int> load_at_;                     ///< of each of the model's loads, its place in loaded_
    std::vector<Vec6> left_;   ///< explicit steps, while a jump is taken: of loaded_, the acceleration before it
    double left_by_ = 0;       ///< s^2, dt^2/8 of the step
    double of_jumps_ = 0;      ///< J, to be added to the work of the step
    bool begun_ = false;       ///< the functions were called at the start of the run
    bool found_anew_ = false;  ///< with what they gave there the acceleration is being found
};

std::vector<PlanLine> loads_plan(const Structure& s, const RunKind&) {
    const std::size_t n = s.model().declared<NodalLoad>(loads_effect).size();
    std::string text = n > 0                           ? std::to_string(n) + " on nodes"
                       : s.model().asked(loads_effect) ? "none acts"
                                                       : "not declared";
    for (std::size_t i = 0; i < s.model().case_factors().size(); ++i)
        text += (i == 0 ? "; cases " : ", ") + s.model().cases()[i] + " " + number_text(s.model().case_factors()[i]);
    if (const int aside = s.model().set_aside())
        text += "; " + std::to_string(aside) + " with a history " + (aside == 1 ? "waits" : "wait") + " for dynamics";
    return {{loads_effect, n > 0, text, s.model().asked_at(loads_effect)}};
}

}  // namespace

void NodalLoad::times(double factor) {
    force *= factor, moment *= factor;
    for (auto* rule : {&force_rule, &moment_rule})
        if (*rule) *rule = [factor, rule = *rule](double t) { return Vec3(factor * rule(t)); };
}

int add_load(Model& model, NodalLoad load) {
    must_be_finite(load.force, "force", "N");
    must_be_finite(load.moment, "moment", "N m");
    auto& loads = model.change_declared<NodalLoad>(loads_effect);
    load.number = model.next_number();
    loads.push_back(std::move(load));
    return loads.back().number;
}

const NodalLoad* find_load(const Model& model, int number) {
    const auto& loads = model.declared<NodalLoad>(loads_effect);
    const auto at =
        std::lower_bound(loads.begin(), loads.end(), number, [](const NodalLoad& l, int n) { return l.number < n; });
    return at != loads.end() && at->number == number ? &*at : nullptr;
}

void remove_load(Model& model, int number) {
    auto& loads = model.change_declared<NodalLoad>(loads_effect);
    if (const NodalLoad* load = find_load(model, number)) loads.erase(loads.begin() + (load - loads.data()));
}

EffectKind loads_kind() {
    return {.name = loads_effect,
            .accounts = {{"work", 100, "done by loads (not gravity) and by supports that move", {}, true}},
            .plan = loads_plan,
            .make = [](Workspace& w, Host& host) -> std::unique_ptr<Effect> {
                if (w.structure.model().declared<NodalLoad>(loads_effect).empty()) return nullptr;
                return std::make_unique<Loads>(w, host);
            },
            .declarer = {.loads =
                             [](const Model& model) {
                                 std::vector<DeclaredLoad> list;
                                 for (const NodalLoad& l : model.declared<NodalLoad>(loads_effect)) {
                                     DeclaredLoad load{"the load on node " + std::to_string(l.node + 1),
                                                       "load " + std::to_string(l.number), l.node};
                                     if (l.history) load.history = &l.history;
                                     load.follows_state = l.follows_state();
                                     load.constant = !l.history && !load.follows_state;
                                     load.load_case = l.load_case, load.force = l.force, load.moment = l.moment;
                                     list.push_back(std::move(load));
                                 }
                                 return list;
                             },
                         .functions =
                             [](const Model& model) {
                                 const auto any = [&](auto has) {
                                     const auto& loads = model.declared<NodalLoad>(loads_effect);
                                     return std::any_of(loads.begin(), loads.end(), has);
                                 };
                                 const std::string asked_at = model.asked_at(loads_effect);
                                 std::vector<ScriptFunctions> list;
                                 if (any([](const NodalLoad& l) { return l.follows_state(); }))
                                     list.push_back({2, "a load that is a function", true, asked_at});
                                 if (any([](const NodalLoad& l) { return bool(l.history); }))
                                     list.push_back({3, "a load's history", false, asked_at});
                                 return list;
                             }}};
}

}  // namespace hinge
