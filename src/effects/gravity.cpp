// Gravity: the weight of elements and of rigid offset masses, and their potential energy (eq 20b).
#include "effects/kinds.h"

namespace hinge {
namespace {

class Gravity : public Effect {
public:
    Gravity(Workspace& w, Host& host) : Effect("gravity", w, host), g_(*w.structure.model().gravity()) {
        at_start_ = potential(w.state);
    }

    /// Offset masses resist with their weight themselves (broken_members.cpp), since it rotates with them.
    void add_steady_loads(std::vector<Vec6>& external) const override {
        for_each_weight(w_.structure, w_.state, [&](int node, double mass) { external[node].head<3>() += mass * g_; });
    }
    void add_held_loads(const Places&, std::vector<Vec6>& external) const override {
        const Vec3& g = w_.structure.model().held_gravity();
        for_each_weight(w_.structure, w_.state, [&](int node, double mass) { external[node].head<3>() += mass * g; });
    }
    bool has_potential() const override { return true; }
    bool takes_mean_forces() const override { return true; }

    void broke(const Break& b) override {
        const Element& e = w_.structure.elements()[b.element];
        const beam::Inertia m = w_.structure.inertia(b.element);
        for (int end : {0, 1}) host_.change_steady_load(e.node[end], -(m.weight(end) * g_));
    }

    /// Zero where the run starts.
    void add_energy(const State& state, Accounts& sums) const override {
        sums["gravity"] += potential(state) - at_start_;
    }

    void save(Writer& to) const override { to(at_start_); }
    void restore(Reader& from) override { from(at_start_); }

private:
    double potential(const State& state) const {
        const Structure& s = w_.structure;
        Vec3 moment = Vec3::Zero();  // of mass about the origin
        for_each_weight(
            s, state, [&](int node, double mass) { moment += mass * (s.position()[node] + state.displacement[node]); });
        for (std::size_t i = 0; i < state.offset_mass.size(); ++i)
            if (state.offset_mass[i].mass > 0)
                moment += state.offset_mass[i].mass * (s.position()[i] + state.displacement[i]) +
                          state.rotation[i] * state.offset_mass[i].moment;
        return -moment.dot(g_);  // eq 20b
    }

    Vec3 g_;           ///< m/s^2
    double at_start_;  ///< J
};

std::vector<PlanLine> plan(const Structure& s, const RunKind&) {
    const bool on = s.model().gravity().has_value();
    return {{"gravity", on, on ? "model:gravity" : "not declared", s.model().asked_at("gravity")}};
}

}  // namespace

EffectKind gravity_kind() {
    return {"gravity",
            {{"gravity", 20, "potential energy, zero at the start of the run", {}, true}},
            plan,
            [](Workspace& w, Host& host) -> std::unique_ptr<Effect> {
                if (!w.structure.model().gravity()) return nullptr;
                return std::make_unique<Gravity>(w, host);
            }};
}

}  // namespace hinge
