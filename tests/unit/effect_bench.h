// One effect, or one integrator, by itself: a structure with its state and workspace, without a run.
#pragma once

#include "effects/effect_list.h"
#include "effects/kinds.h"
#include "helpers.h"

namespace hinge::test {

/// A run that does nothing that effects ask of it.
class NoRun : public Host {
public:
    void stiffness_changed(int) override {}
    void blocks_changed(const Pose&) override {}
    void set_offset_mass(int, const Mat6&) override {}
    void accelerations_anew() override {}
    void constraints_changed() override {}
    void mass_changed(int) override {}
    ImpulseResponse respond(const std::vector<Vec6>&) override { return {}; }
    void change_steady_load(int, const Vec3&) override {}
    void reached(const std::vector<Reached>&) override {}
    void note_activation(const std::string&, bool, const std::string&) override {}
    void keep_from_rest(const Bodies&, std::vector<char>&) override {}
    void hold_up(const Bodies&, std::vector<char>&) override {}
    void lie_together(const Bodies&, BodyPairs&) override {}
    void rest_changed() override {}
    std::vector<beam::BowPoint> points_on_pair(int, int, const Pose&, double) override { return {}; }
    void count_break() override {}
    bool has_effective_stiffness() const override { return true; }
};

struct Bench {
    std::shared_ptr<const Structure> structure;
    State state;
    ThreadPool pool;
    std::unordered_map<int, Vec6> reaction;
    ElementAssembly assembly;
    Workspace w;
    NoRun run;

    explicit Bench(std::shared_ptr<const Structure> of, RunKind kind = {.dynamic = true, .dt = 1e-3})
        : structure(std::move(of)),
          state(initial_state(*structure)),
          assembly(*structure, pool, true),
          w({*structure, state, pool, assembly, reaction, kind}) {
        w.rotation_step.assign(structure->position().size(), Vec3::Zero());
        w.external = w.resisting = zero();
        for (int n = 0; n < int(state.held.size()); ++n)
            if (state.held[n]) w.supported.push_back(n);
        assembly.update_active(state);
    }
    std::vector<Vec6> zero() const { return std::vector<Vec6>(structure->position().size(), Vec6::Zero()); }
    double mass() const {
        double sum = 0;
        for (const Element& e : structure->elements()) sum += e.mass();
        return sum;
    }
};

/// An effect of a model, made for a bench.
struct EffectOnBench : Bench {
    std::unique_ptr<Effect> effect;

    EffectOnBench(const Frame& frame, const EffectKind& kind, RunKind run_kind = {.dynamic = true, .dt = 1e-3})
        : Bench(frame.build(), run_kind), effect(kind.make(w, run)) {
        REQUIRE(effect);
    }
    /// R of the effect at the trial.
    std::vector<Vec6> forces() {
        std::vector<Vec6> resisting = zero();
        dynamic_cast<Force&>(*effect).add_forces(state.time, resisting);
        return resisting;
    }
    /// An account of what the effect stores where the trial is, J.
    double stored(const char* account) {
        forces();
        State there = state;
        static_cast<Configuration&>(there) = w.trial;
        Accounts sums;
        effect->add_energy(there, sums);
        return std::as_const(sums)[account];
    }
    /// Its derivative by the displacement of a node, by central differences, N.
    Vec3 slope_of_energy(const char* account, int node, double h) {
        Vec3 slope;
        for (int c = 0; c < 3; ++c) {
            double& u = w.trial.displacement[node][c];
            const double at = u;
            u = at + h;
            const double above = stored(account);
            u = at - h;
            slope[c] = (above - stored(account)) / (2 * h);
            u = at;
        }
        return slope;
    }
};

inline Vec3 sum_of_forces(const std::vector<Vec6>& nodal) {
    Vec3 sum = Vec3::Zero();
    for (const Vec6& f : nodal) sum += f.head<3>();
    return sum;
}

}  // namespace hinge::test
