// Broken elements (figs 4 and 5): their forces are released, and each hangs on its other node as a rigid offset mass.
// It resists, rotates and has weight with that node. state/breaking.h has the mechanics of the break.
#include <algorithm>
#include <cmath>

#include "effects/all_effects.h"
#include "effects/gravity.h"
#include "effects/kinds.h"
#include "state/node_mass.h"

namespace hinge {
namespace {

/// An offset mass's inertia about its own axis is a thousandth of that across: the effective stiffness must not lag
/// behind its rotation by more than 2 mrad, the cosine of whose half this is.
constexpr double lag_cosine = 1 - 5e-7;

class BrokenMembers : public Effect, public Load, public BreakListener {
public:
    BrokenMembers(Workspace& w, Host& host) : Effect("broken members", w, host, {.mean_forces = true}) {
        if (!w.state.offset_mass.empty()) built_ = w.state.rotation;
    }

    /// m (a - g) + a x S + w x (w x S) and S x (a - g) + J a + w x J w, S and J about the node, in space. In the
    /// energy-momentum method the weight alone: momenta are the integrator's. In small displacement S and J keep their
    /// directions, and what is of second order in w, of which the linear equation of motion has nothing, is left out.
    void subtract_following_loads(std::vector<Vec6>& resisting) override {
        if (w_.state.offset_mass.empty()) return;
        if (!listed_) list_carriers();
        const Vec3 g = gravity().acceleration;
        for (const int i : points_)
            if (!w_.rests(i))
                resisting[i].head<3>() += w_.state.offset_mass[i].mass * (w_.trial.acceleration[i].head<3>() - g);
        for (const int i : carriers_) {
            const OffsetMass& h = w_.state.offset_mass[i];
            tried_rate_[i].setZero();
            if (w_.rests(i)) continue;
            const Mat3 R = w_.trial.rotation[i].toRotationMatrix();
            const Vec3 S = R * h.moment, a = w_.trial.acceleration[i].head<3>() - g,
                       alpha = w_.trial.acceleration[i].tail<3>(),
                       w = w_.kind.conserving || !w_.structure.large() ? Vec3(Vec3::Zero())
                                                                       : Vec3(w_.trial.velocity[i].tail<3>());
            const Vec3 in_body = R.transpose() * w, Jw = R * (h.inertia * in_body),
                       Ja = R * (h.inertia * (R.transpose() * alpha));
            tried_rate_[i] = alpha.cross(S) + w.cross(w.cross(S));
            resisting[i].head<3>() += h.mass * a + tried_rate_[i];
            resisting[i].tail<3>() += S.cross(a) + Ja + w.cross(Jw);
            const bool lags = w_.solved_at_once ? w_.trial.rotation[i].coeffs() != built_[i].coeffs()
                                                : w_.trial.rotation[i].coeffs().dot(built_[i].coeffs()) < lag_cosine;
            if (lags) renew(i);
        }
    }

    /// Weights at rest, where the nodes have rotated them.
    void add_static_loads(const Pose& at, std::vector<Vec6>& external) const override {
        add_weights(at, gravity().acceleration, external);
    }
    void add_held_loads(const Pose& at, std::vector<Vec6>& external) const override {
        add_weights(at, gravity().held, external);
    }
    bool follows_nodes() const override {
        const auto& masses = w_.state.offset_mass;
        return gravity_of(w_.structure.model()) &&
               std::any_of(masses.begin(), masses.end(), [](const OffsetMass& h) { return !h.moment.isZero(0); });
    }
    bool has_potential() const override { return true; }

    /// An offset mass's part of the momentum, w x S, rotates with it: over a step it changes by a little else than the
    /// trapezium rule makes of the rates in the equation of motion. The node takes the difference, so that linear
    /// momentum stays what it was. Called with the change of the acceleration since the stresses were recovered.
    void solved(const Step& step, const std::vector<Vec6>& change) override {
        const Scheme& scheme = w_.scheme;
        for (const int i : carriers_) next_rate_[i] = tried_rate_[i];
        if (w_.kind.conserving) return;
        for (const int i : carriers_) {
            const OffsetMass& h = w_.state.offset_mass[i];
            const Vec3 S = w_.state.rotation[i] * h.moment, next_S = w_.trial.rotation[i] * h.moment;
            const Vec3 built_S = host_.has_effective_stiffness() ? Vec3(built_[i] * h.moment) : next_S;
            const Vec3 weighted = tried_rate_[i] + (1 - scheme.alpha) * change[i].tail<3>().cross(built_S);
            next_rate_[i] = scheme.next_of_weighted(rate_[i], weighted);
            const Vec3 integrated = scheme.velocity_change(rate_[i], next_rate_[i], step.dt);
            double mass = h.mass;
            for (int e : w_.structure.elements_at(i))
                if (!w_.state.broken[e]) mass += mass_at(e, i);
            const Vec3 missed =
                (w_.trial.velocity[i].tail<3>().cross(next_S) - w_.state.velocity[i].tail<3>().cross(S) - integrated) /
                mass;
            for (int c = 0; c < 3; ++c)
                if (!(w_.state.held[i] >> c & 1)) w_.trial.velocity[i][c] -= missed[c];
        }
    }

    void before_commit(const Step&) override { rate_.swap(next_rate_); }

    void breaks(const Break& b, std::vector<Vec6>& impulse) override {
        listed_ = false;
        const BreakReport report = break_off(w_.structure, w_.state, b.element, b.end, impulse);
        carrier_ = report.carrier;
        host_.count_break();
        if (report.orphaned)
            for (int n : w_.structure.elements()[b.element].node)
                if (w_.state.gone[n]) w_.supported.push_back(n);
    }
    void broke(const Break& b) override {
        renew(carrier_);
        host_.mass_changed(b.element);
        const int partner = w_.structure.elements()[b.element].partner;
        if (w_.structure.lumped() && partner >= 0) host_.mass_changed(partner);
    }

    void acceleration_found() override {
        for (const int i : carriers_)
            rate_[i] = tried_rate_[i] +
                       w_.state.acceleration[i].tail<3>().cross(w_.state.rotation[i] * w_.state.offset_mass[i].moment);
    }

    void started(const std::vector<Vec6>&) override {
        for (std::size_t i = 0; i < w_.state.offset_mass.size(); ++i) renew(int(i));
    }

    void add_energy(const State& state, Accounts& sums) const override {
        sums["kinetic"] += kinetic_energy_of_offset_masses(state);
    }

    void save(Writer& to) const override { to(built_, rate_); }
    void restore(Reader& from) override { from(built_, rate_), listed_ = false; }
    bool restored(std::span<const State* const>) override {
        const std::size_t nodes = w_.structure.position().size();
        return (built_.empty() || built_.size() == nodes) && (w_.state.offset_mass.empty() || !built_.empty()) &&
               rate_.size() <= w_.state.offset_mass.size();
    }

private:
    void add_weights(const Pose& at, const Vec3& g, std::vector<Vec6>& external) const {
        for (std::size_t i = 0; i < w_.state.offset_mass.size(); ++i) {
            const OffsetMass& h = w_.state.offset_mass[i];
            if (h.mass == 0) continue;
            external[i].head<3>() += h.mass * g;
            external[i].tail<3>() += Vec3(at.rotation[i] * h.moment).cross(g);
        }
    }
    double mass_at(int element, int node) const {
        const Element& e = w_.structure.elements()[element];
        if (!w_.structure.lumped()) return 0.5 * e.mass();
        return inertia_now(w_.structure, w_.state, element).own[e.node[0] == node ? 0 : 1];
    }
    DeclaredGravity gravity() const {
        const DeclaredGravity* declared = gravity_of(w_.structure.model());
        return declared ? *declared : DeclaredGravity{};
    }

    /// Which nodes have a mass: what is loose has one for good. A mass in the node itself neither rotates nor pulls.
    void list_carriers() {
        listed_ = true;
        points_.clear(), carriers_.clear();
        for (std::size_t i = 0; i < w_.state.offset_mass.size(); ++i) {
            const OffsetMass& h = w_.state.offset_mass[i];
            if (h.mass != 0) (h.is_point() ? points_ : carriers_).push_back(int(i));
        }
        for (std::vector<Vec3>* rates : {&rate_, &next_rate_, &tried_rate_})
            rates->resize(w_.state.offset_mass.size(), Vec3::Zero());
    }

    void renew(int node) {
        if (w_.state.offset_mass[node].mass == 0) return;
        built_.resize(w_.state.offset_mass.size(), Quat::Identity());
        built_[node] = w_.state.rotation[node];
        host_.set_offset_mass(node, offset_mass_in_space(w_.state.offset_mass[node], w_.state.rotation[node]));
    }

    bool listed_ = false;
    std::vector<int> points_, carriers_;  ///< nodes with a mass in them; with one beside them, or with inertia
    std::vector<Quat> built_;             ///< orientation that an offset mass has in the effective stiffness
    /// Rate of change of w x S in a step's equation of motion: of the last step, of this one, and where stresses were
    /// recovered.
    std::vector<Vec3> rate_, next_rate_, tried_rate_;
    int carrier_ = -1;
};

}  // namespace

EffectKind broken_members_kind() {
    return {.name = "broken members", .make = [](Workspace& w, Host& host) -> std::unique_ptr<Effect> {
                if (!may_break(w.structure.model(), w.kind) && w.state.offset_mass.empty()) return nullptr;
                return std::make_unique<BrokenMembers>(w, host);
            }};
}

}  // namespace hinge
