// Dynamics, how a run begins: which stages a step has, what is where, the first acceleration; and what it says of
// itself.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/errors.h"
#include "run/dynamics.h"

namespace hinge {

namespace {

constexpr long finest_part =
    1024;  ///< of a step, with step control: a power of two, so that times stay those of whole steps to the bit

}  // namespace

double Dynamics::crossing(const Structure& structure, double dt) {
    double most = 0;
    for (const Element& e : structure.elements()) {
        const beam::Rigidity& c = e.rigidity;
        most = std::max(most, dt * std::sqrt(c.EA / c.rhoA) / e.length);
        if (!e.yield.elastic()) most = std::max(most, dt * std::sqrt(std::max(c.GAy / c.rhoIx, c.GAx / c.rhoIy)));
    }
    return most;
}

Dynamics::Dynamics(std::shared_ptr<const Structure> structure, State start, DynamicSettings settings)
    : Run(std::move(structure), std::move(start)),
      settings_(settings),
      pace_{settings.step_control > 0 ? settings.dt / finest_part : settings.dt,
            settings.step_control > 0 ? finest_part : 1, 0},
      pool_(settings.threads),
      sweep_(*structure_, pool_, !structure_->lumped()) {
    pace_.whole = pace_.own * std::llround(settings.duration / settings.dt);
    if (explicit_steps() != structure_->lumped())
        throw InputError("dynamics: explicit steps (beta 0) go with lumped masses, and Newmark's with consistent ones");
    from_rest_ =
        !explicit_steps() && (settings_.predictor == Predictor::displacement ||
                              (settings_.predictor == Predictor::by_step && crossing(*structure_, settings_.dt) > 1));
    const Model& model = structure_->model();
    const std::size_t nodes = structure_->position().size(), elements = structure_->elements().size();
    if (!model.contact().empty() && !state_.contact) {
        std::vector<contact::ContactSettings> rules;
        for (const ContactRule& rule : model.contact()) rules.push_back(rule.settings);
        state_.contact.emplace(std::move(rules));
    }
    if (model.contact().empty()) state_.contact.reset();
    if (state_.contact) state_.contact->forget();  // it may come from a run in the middle of a step
    for (const ContactRule& rule : model.contact())
        has_rules_ = has_rules_ || rule.pairs || rule.on_touch || rule.on_release;
    for (const NodalLoad& load : model.loads()) has_rules_ = has_rules_ || load.follows_state() || load.history;
    for (const SupportMotion& m : model.motions()) {
        const double begin = state_.time, speed = state_.velocity[m.node][m.component];
        moved_.push_back({m.node, m.component, [path = m.displacement, begin, speed](double t) {
                              return t < begin ? path(begin) + speed * (t - begin) : path(t);
                          }});
        for (int e : structure_->elements_at(m.node)) support_parts_[e] = Mat12::Zero();
        has_rules_ = true;
    }
    for (const FractureRule& rule : model.fracture()) {
        has_rules_ = has_rules_ || rule.hook || rule.batch;
        kept_a_section_ = std::max(kept_a_section_, rule.keep.size());
    }
    const bool news = std::any_of(model.fracture().begin(), model.fracture().end(), [](const FractureRule& r) {
        return r.hook && r.where == FractureRule::Where::plastic;
    });
    if (const std::size_t three = news ? 3 * elements : 0; state_.strained.size() != three)
        state_.strained.assign(three, 0);
    if (const std::size_t kept = 2 * elements * kept_a_section_; state_.kept.size() != kept)
        state_.kept.assign(kept, 0);

    stages_.push_back({"loads", "loads", &Dynamics::loads});
    if (with_contact()) stages_.push_back({"contact", "contact", &Dynamics::contact});
    if (with_contact() || with_fracture()) stages_.push_back({"restart", "fracture", &Dynamics::restart});
    stages_.push_back({"predict", "inertia", &Dynamics::predict});
    stages_.push_back({"recover stresses", "large displacement", &Dynamics::recover});
    if (explicit_steps()) {
        stages_.push_back({"accelerate", "inertia", &Dynamics::accelerate});
    } else {
        if (can_yield()) stages_.push_back({"yield", "plasticity", &Dynamics::yield});
        stages_.push_back({"operator", "inertia", &Dynamics::renew_operator});
        stages_.push_back({"solve", "inertia", &Dynamics::solve});
        stages_.push_back({"correct", "inertia", &Dynamics::correct});
    }
    if (with_contact()) stages_.push_back({"part", "contact", &Dynamics::part});
    if (controlled()) stages_.push_back({"step control", "inertia", &Dynamics::weigh});
    if (with_fracture()) stages_.push_back({"fracture", "fracture", &Dynamics::fracture});
    stages_.push_back({"commit", "inertia", &Dynamics::commit});

    pace_.start = state_.time;
    trial_ = pose_of(state_);
    increment_.assign(nodes, Vec3::Zero());
    for (auto* v : {&external_, &nodal_, &change_}) v->assign(nodes, Vec6::Zero());
    force_ = state_.force;
    in_rebuild_.assign(elements, 0);
    in_candidates_.assign(elements, 0);
    if (model.gravity())
        for (std::size_t i = 0; i < elements; ++i) {
            const Element& e = structure_->elements()[i];
            if (!state_.broken[i])
                for (int end : {0, 1})
                    external_[e.node[end]].head<3>() += structure_->inertia(int(i)).weight(end) * *model.gravity();
        }
    std::vector<int> place(nodes, -1);
    for (const NodalLoad& load : model.loads()) {
        if (place[load.node] < 0)
            place[load.node] = int(loaded_.size()), loaded_.push_back({load.node, external_[load.node]});
        if (load.follows_state()) rule_loads_[load_at_.size()] = Vec6::Zero();
        load_at_.push_back(place[load.node]);
    }
    for (std::size_t i = 0; i < nodes; ++i)
        if (state_.held[i]) held_nodes_.push_back(int(i));
    lumped_mass_.assign(nodes, 0);
    for (const Element& e : structure_->elements())
        for (int n : e.node) lumped_mass_[n] += 0.5 * e.rigidity.rhoA * e.length;
    if (settings_.iterations == 0) {
        const bool newton = from_rest_ && (can_yield() || structure_->large());
        settings_.iterations = newton ? 30 : 1;
        if (newton) settings_.tolerance = std::max(settings_.tolerance, 1e-6);
    }
    sweep_.take_up(state_);
    if (with_fracture())
        for (std::size_t i = 0; i < elements; ++i) heed_fracture(int(i));
    if (!state_.offset_mass.empty()) hung_built_ = state_.rotation;
    for (std::size_t i = 0; i < elements; ++i) {
        if (state_.hinge[i]) flowing_.push_back(int(i));
    }
    find_acceleration();
    for (Loaded& l : loaded_) l.before = l.now;
    if (!explicit_steps()) begin_operator();  // not before: the first acceleration needs room too
    if (settings_.rest) let_rest();
    if (!explicit_steps() && !with_contact() && !with_fracture()) mass_.reset();  // nothing can vanish at once
}

void Dynamics::begin_operator() {
    effective_ = std::make_unique<EffectiveStiffness>(*structure_, pool_, 1 - settings_.alpha(),
                                                      settings_.beta * settings_.dt * settings_.dt,
                                                      settings_.geometric && structure_->large(),
                                                      settings_.solver.direct           ? Keeping::direct
                                                      : settings_.narrow && !from_rest_ ? Keeping::narrow
                                                                                        : Keeping::iterative);
    effective_->set_held(state_.held);
    if (structure_->large()) sweep_.watch_turning(settings_.turn);
    for (int e = 0; e < int(state_.broken.size()); ++e)
        if (!state_.broken[e]) wants_rebuild(e);
    for (std::size_t i = 0; i < state_.offset_mass.size(); ++i) renew_hung_operator(i);
    if (in_contact()) renew_couplings(state_.rotation);
}

std::vector<StageTime> Dynamics::stage_times() const {
    std::vector<StageTime> times;
    for (const Stage& s : stages_) times.push_back({s.name, s.seconds});
    return times;
}

std::vector<Effect> Dynamics::effects() const {
    std::vector<Effect> list = effects_of(*structure_, true, settings_.geometric);
    char how[160];
    std::snprintf(how, sizeof how,
                  explicit_steps()      ? "explicit steps of %.3g us, lumped masses"
                  : settings_.automatic ? "Newmark's method, steps of %.3g us, eight times that where nothing happens"
                                        : "Newmark's method, steps of %.3g us",
                  1e6 * shortest());
    std::string because = how + std::string(structure_->cubic() ? ", cubic mass" : "");
    if (controlled())
        std::snprintf(how, sizeof how, ", halved where one would lose more than its share of %.2g %% of the energy",
                      100 * settings_.step_control),
            because += how;
    if (settings_.alpha() != 0)
        std::snprintf(how, sizeof how, ", of the highest frequencies %.3g is left after a step",
                      settings_.rho_infinity),
            because += how;
    list.front().because = because;
    for (Effect& e : list)
        if (explicit_steps() && e.active && e.name == "geometric stiffness")
            e.active = false, e.because = "explicit steps form no stiffness; the forces have it";
    for (Effect& e : list)
        for (const Stage& s : stages_)
            if (e.name == s.effect) e.seconds += s.seconds;
    return list;
}

}  // namespace hinge
