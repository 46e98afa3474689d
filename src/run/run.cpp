#include "run/run.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/rotation.h"
#include "beam/pair_bow.h"
#include "effects/effect_list.h"
#include "run/effect_forces.h"
#include "run/settings.h"
#include "state/hinges.h"
#include "state/lone_elements.h"

namespace hinge {

const char* name(Verdict v) {
    switch (v) {
        case Verdict::running: return "running";
        case Verdict::completed: return "completed";
        case Verdict::stopped: return "stopped";
        default: return "failed";
    }
}

namespace {

/// A function of the script is called by one thread.
int threads_of(const Structure& structure, int asked) {
    if (structure.laws_call_script()) return 1;
    return asked == DynamicSettings::by_elements ? threads_for(structure.elements().size()) : asked;
}

}  // namespace

Run::Run(std::shared_ptr<const Structure> structure, State start, RunKind kind, int threads, bool inertia)
    : structure_(std::move(structure)),
      state_(with_lone_elements(*structure_, std::move(start))),
      pool_(threads_of(*structure_, threads), threads == DynamicSettings::by_elements),
      assembly_(*structure_, pool_, inertia),
      w_({*structure_, state_, pool_, assembly_, reaction_, kind}),
      effects_(new EffectList(w_, *this)),
      accounts_(accounts_of(*effects_)),
      at_start_(state_.accumulated),
      first_step_(state_.step) {
    const std::size_t nodes = structure_->position().size();
    begin_constraints();
    initial_ = 0 - energy_of(state_).error;  // all that is stored: nothing has come in, or gone, yet
    w_.external.assign(nodes, Vec6::Zero());
    w_.resisting.assign(nodes, Vec6::Zero());
    for (const auto& load : effects_->loads) load->add_steady_loads(w_.external);
    w_.steady = w_.external;
    for (std::size_t i = 0; i < nodes; ++i)
        if (state_.held[i]) w_.supported.push_back(int(i));
}

Run::~Run() = default;

/// Constraints are kept from where the run begins. Nodes at rest that depend on others begin with their velocity.
void Run::begin_constraints() {
    if (effects_->constrainers.empty()) return;
    constraints_ = std::make_unique<Constraints>(w_, *effects_);
    w_.constraints = constraints_.get();
    constraints_->begin();
}

Energy Run::energy_of(const State& state) const {
    Accounts sums;
    for (const auto& [name, sum] : state.accumulated) sums[name] = sum - at_start_[name];
    for (const auto& e : effects_->all) e->add_energy(state, sums);
    Energy energy = balance(accounts_, initial_, sums);
    // positions round where they are read, and once a step where they are added to
    energy.rounding =
        std::numeric_limits<double>::epsilon() * double(4 + state.step - first_step_) * sums[energy_scale];
    return energy;
}

Blocks Run::added_stiffness(Yielded yielded, double loads) const {
    Blocks blocks(0, true, yielded);
    for (const InRole<Force>& of : effects_->forces) {
        if (!of->has_blocks()) continue;
        Blocks own(0, true, yielded);
        of->add_blocks(state_, own);
        const double factor = dynamic_cast<const Load*>(of.effect) ? loads : 1;
        for (const Coupling& c : own.pairs) blocks.pairs.push_back({c.a, c.b, factor * c.K});
        for (const Blocks::Node& n : own.nodes) blocks.nodes.push_back({n.node, factor * n.K});
    }
    return blocks;
}

/// Loads along members turn the ends of their elements in the iteration of statics alone: those in the axes of space
/// have a potential. Those in the members' axes have blocks.
bool Run::has_unsymmetric_loads() const {
    const auto is_one = [](const InRole<Load>& of) {
        const auto* force = dynamic_cast<const Force*>(of.effect);
        return of->is_unsymmetric() && (!of->follows_nodes() || (force && force->has_blocks()));
    };
    return structure_->large() && std::any_of(effects_->loads.begin(), effects_->loads.end(), is_one);
}

Blocks Run::added_damping() const {
    Blocks blocks(1, false);
    for (const auto& force : effects_->forces)
        if (force->has_blocks()) force->add_blocks(state_, blocks);
    return blocks;
}

void Run::change_steady_load(int node, const Vec3& force) {
    w_.external[node].head<3>() += force;
    w_.steady[node].head<3>() += force;
}

void Run::reached(const std::vector<Reached>& elements) {
    for (const auto& keeper : effects_->rest_keepers) keeper->reached(elements);
}

void Run::keep_from_rest(const Bodies& bodies, std::vector<char>& rests) {
    for (const auto& e : effects_->all) e->keep_from_rest(bodies, rests);
}

void Run::hold_up(const Bodies& bodies, std::vector<char>& held_up) {
    for (const auto& e : effects_->all) e->hold_up(bodies, held_up);
}

void Run::lie_together(const Bodies& bodies, BodyPairs& pairs) {
    for (const auto& e : effects_->all) e->lie_together(bodies, pairs);
}

void Run::rest_changed() {
    for (const auto& e : effects_->all) e->rest_changed();
}

std::vector<beam::BowPoint> Run::points_on_pair(int first, int plane, const Pose& at, double factor) {
    std::vector<beam::BowPoint> points;
    for (const auto& source : effects_->section_forces) source->add_points(first, plane, at, factor, points);
    return points;
}

void Run::note_activation(const std::string& effect, bool awake, const std::string& why) {
    if (activations_.size() < 1000) activations_.push_back({state_.time, effect, awake, why});
}

void Run::stop() {
    if (verdict_ == Verdict::running) verdict_ = Verdict::stopped;
}

void Run::fail(RunFailure why) {
    verdict_ = Verdict::failed;
    failure_ = std::move(why);
}

std::string Run::reason() const {
    switch (verdict_) {
        case Verdict::failed: return text_of_cause(failure_.what) + text_of_rest(failure_, *structure_, false);
        case Verdict::stopped: return "stopped by the script";
        case Verdict::completed: return reason_at_end();
        default: return {};
    }
}

std::string Run::brief_reason() const {
    if (verdict_ != Verdict::failed) return reason();
    return text_of_cause(failure_.what) + text_of_rest(failure_, *structure_, true);
}

void Run::call_watches(const Step& step) {
    for (const auto& watch : watches_) watch->after_commit(*this, step);
}

void Run::save_watches(Writer& to) const {
    to(long(watches_.size()));
    for (const auto& watch : watches_) watch->save(to);
}

void Run::restore_watches(Reader& from) {
    long count = 0;
    from(count);
    from.must(count == long(watches_.size()));
    for (const auto& watch : watches_) watch->restore(from);
    for (const auto& watch : watches_) from.must(watch->fits(*this));
}

void Run::watch_as(const Run& before) {
    for (std::size_t i = 0; watches_.size() == before.watches_.size() && i < watches_.size(); ++i) {
        if (!watches_[i]->goes_on()) continue;
        std::string bytes;
        Writer to(bytes);
        before.watches_[i]->save(to);
        Reader from(bytes);
        watches_[i]->restore(from);
    }
}

void Run::end_step() {
    for (const auto& watch : watches_) watch->after_step(*this);
    if (verdict_ == Verdict::running) return;
    for (const auto& watch : watches_) watch->finish(*this);
}

Vec6 Run::displacement(int node) const {
    Vec6 d;
    d.head<3>() = state_.displacement[node];
    if (structure_->large()) {
        d.tail<3>() = rotation_vector(state_.rotation[node]);
    } else {
        d.tail<3>() = state_.small_rotation[node];
    }
    return d;
}

Vec6 Run::reaction(int node) const {
    const auto at = reaction_.find(node);
    return at == reaction_.end() ? Vec6(Vec6::Zero()) : at->second;
}

SectionForces Run::section_forces(int element, double side) const {
    if (state_.broken[element]) return {};
    const Element& e = structure_->elements()[element];
    const Vec6& p = state_.force[element];
    // N, Mx, My, Mz, then Qx and Qy: the slopes of the moments (eqs 8a-b)
    SectionForces forces{p[4], beam::moment_at(p[0], p[1], side), beam::moment_at(p[2], p[3], side),
                         p[5], -(p[2] + p[3]) / e.length,         (p[0] + p[1]) / e.length};
    for (const auto& source : effects_->section_forces) source->add_section_forces(element, side, forces);
    return forces;
}

Eigen::Vector2d Run::compression(int element) const {
    const Element& e = structure_->elements()[element];
    if (!structure_->p_delta() || !e.forms_pairs || state_.broken[element] || state_.broken[e.partner])
        return Eigen::Vector2d::Zero();
    const double P = -0.5 * (section_forces(element, -1).N + section_forces(element, 1).N),
                 E = heat_of(state_.heat, element).stiffness;
    const beam::PairKind<double> kind = pair_kind_of(e);
    const auto along = [&](int plane) {  // beyond pair_most, too
        const double p = kind.c[plane] * P / E;
        return p / (1 - std::min(kind.shear[plane].flexible * p, 0.5));
    };
    return {along(0), along(1)};
}

std::vector<ShownLoad> Run::shown_loads() const {
    std::vector<ShownLoad> loads;
    for (const auto& load : effects_->loads) load->show_loads(loads);
    return loads;
}

double Run::yield_value(int element, double r) const {
    if (state_.broken[element]) return 0;
    beam::FixedEnd fixed;
    for (int end : {0, 1}) {
        SectionForces there;
        for (const auto& source : effects_->section_forces)
            source->add_section_forces(element, end == 0 ? -1 : 1, there);
        fixed.add(end, there.Mx, there.My, there.N, there.Mz);
    }
    const double of_history = structure_->conventional() ? 0 : r;  // conventional elements have one, of their middle
    return yield_function_at(*structure_, state_, element, of_history,
                             beam::resultants(state_.force[element] + fixed.at(r), r));
}

double Run::yield_value(int element) const {
    if (structure_->conventional()) return yield_value(element, 0);
    return std::max(yield_value(element, -1), yield_value(element, 1));
}

Run::Counts Run::count_members(int group) const {
    Counts counts;
    const auto& elements = structure_->elements();
    for (std::size_t i = 0; i < elements.size();) {
        const int member = elements[i].member;
        bool broken = false, yielded = false, touched = false;
        const std::size_t first = i;
        for (; i < elements.size() && elements[i].member == member; ++i) {
            broken |= state_.broken[i] != 0;
            yielded |= state_.yielded[i] != 0;
            touched |= state_.touched[i] != 0;
        }
        if (group >= 0 && !structure_->in_group(int(first), group)) continue;
        counts.touched += touched;
        ++(broken ? counts.broken : yielded ? counts.yielded : counts.elastic);
    }
    return counts;
}

}  // namespace hinge
