// Panels: plates in their plane between the nodes of members and nodes of their own (panel/membrane.h), of layers that
// yield, crush and tear (panel/sheet.h).
//
// A panel joins its nodes by forces along its surface, and has no stiffness across it or against the rotation of its
// nodes. What it weighs is at its nodes, as point masses, and stays there when it tears: momentum is what it was. A
// layer tears as a whole where the strain of one of its points reaches the ultimate one; its energy is dissipated.
#include "effects/panels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/text.h"
#include "effects/all_effects.h"
#include "effects/damping.h"
#include "effects/kinds.h"
#include "effects/panel_curvature.h"
#include "effects/translation_blocks.h"
#include "panel/response.h"

namespace hinge {
namespace {

using panel::all_layers;
using panel::Layer;
using panel::Mat5;
using panel::Placed;
using panel::Resultants;
using panel::Shape;
using Evaluated = panel::PanelResponse;

const std::vector<Panel>& panels_of(const Model& model) { return model.declared<Panel>(panels_effect); }

class Panels : public Effect, public Force, public BreakListener, public StepLimiter {
public:
    Panels(Workspace& w, Host& host) : Effect(panels_effect, w, host, {.mean_forces = true}) {
        std::size_t size = 0;
        for (const Panel& p : declared()) {
            add(p);
            history_at_.push_back(size);
            size += std::size_t(panel::history_size(*p.sheet, shape_.back()));
            for (const Layer& l : p.sheet->layers) {
                traits_.forces_vanish |= std::isfinite(l.ultimate);
                traits_.cracks |= l.kind == panel::LayerKind::concrete;
            }
        }
        history_at_.push_back(size);
        traits_.stiffens = w.structure.large();
        curvature_.emplace(w, declared(), shape_);
        curvature_->join(blocks_);
        blocks_.joined();
        curvature_->find_places(blocks_);
        for (const Panel& p : declared()) place_.push_back(blocks_.places(p.nodes));
        next_.resize(size);
        begin(size);
        curvature_->begin();
    }

    // ---- what acts ------------------------------------------------------------------------------------------------
    void add_forces(double, std::vector<Vec6>& resisting) override {
        PanelsNow& n = now();
        ends_.resize(shape_.size());
        curvature_->place(w_.trial);
        for (std::size_t i = 0; i < shape_.size(); ++i) {
            if (!takes_part(i)) continue;
            const Placed at = place(i, w_.trial);
            const Evaluated& e = ends_[i] = evaluate(i, at, n, false);
            if (curvature_->has(i)) curvature_->add_moments(i, e.moment);
            n.on_trial[i] = !w_.kind.dynamic && e.tears == all_layers;
            Vec3 force[4] = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
            panel::add_forces(shape_[i], at, e.resultants, force);
            for (int k = 0; k < shape_[i].nodes; ++k) resisting[declared()[i].nodes[k]].head<3>() += force[k];
        }
        curvature_->add_forces(resisting);
    }
    bool has_blocks() const override { return any_whole(); }
    bool blocks_follow() const override {
        return any_awake() &&
               (w_.structure.large() || !std::all_of(declared().begin(), declared().end(),
                                                     [](const Panel& p) { return p.sheet->is_elastic(); }));
    }
    bool blocks_may_lag() const override { return true; }
    void add_blocks(const Pose& at, Blocks& blocks) const override {
        add_stiffness(
            at, blocks,
            [&](std::size_t i, const Placed& placed, Resultants& r, panel::Mat17* bending) {
                const Evaluated e = evaluate(i, placed, now(), true, bending);
                if (w_.kind.geometric) r = e.resultants;
                return e.tangent;
            },
            [this](int node) { return !w_.rests(node); });
    }
    double scale_of_rounding(const Pose& at) const override {
        double sum = 0;
        for (std::size_t i = 0; i < shape_.size(); ++i) {
            const int node = declared()[i].nodes[0];
            const Vec3 where = w_.structure.position()[node] + at.displacement[node];
            sum += declared()[i].sheet->elastic().membrane.trace() * (shape_[i].area + where.squaredNorm());
        }
        return sum;
    }
    void add_stiffest(Blocks& most) const override {
        add_stiffness(
            w_.state, most,
            [&](std::size_t i, const Placed&, Resultants&, panel::Mat17* bending) -> Mat5 {
                const panel::SectionTangent elastic = declared()[i].sheet->elastic();
                if (!bending) return generalised(shape_[i], elastic.membrane);
                *bending = panel::stiffest(shape_[i], elastic);
                return Mat5::Zero();
            },
            [](int) { return true; });
    }

    // ---- a step ---------------------------------------------------------------------------------------------------
    void accumulate_energy(const Step&, Accounts& sums) const override {
        double dissipated = 0;
        ends_.resize(shape_.size());
        curvature_->place(w_.trial);
        for (std::size_t i = 0; i < shape_.size(); ++i) {
            if (!takes_part(i)) continue;
            if (!w_.kind.explicit_steps)  // else nothing has moved since the forces were found
                ends_[i] = evaluate(i, place(i, w_.trial), now(), false);
            dissipated += ends_[i].dissipated;
        }
        sums["panel_dissipated"] += dissipated;
    }
    void before_commit(const Step& step) override {
        PanelsNow& n = now();
        bool any = false;
        for (std::size_t i = 0; i < shape_.size(); ++i) {
            if (!takes_part(i)) continue;
            const Evaluated& e = ends_[i];
            std::copy(&next_[history_at_[i]], &next_[history_at_[i]] + (history_at_[i + 1] - history_at_[i]),
                      &n.history[history_at_[i]]);
            n.force[i] = e.resultants.mean / shape_[i].area;
            n.stored[i] = e.stored;
            n.used[i] = std::max(n.used[i], e.used);
            if (e.left > n.left) n.left = e.left, n.left_in = int(i);
            if (e.tears) tear(i, e.tears, e, w_.kind.dynamic ? step.end() : w_.factor), any = true;
        }
        curvature_->keep();
        if (any) curvature_->end_of_torn(), changed(w_.trial);
    }
    /// A node that panels alone join from now on does not rotate: nothing resists that, and nothing has inertia there.
    void broke(const Break& b) override {
        for (const int node : w_.structure.elements()[b.element].node) {
            const auto& at = w_.structure.elements_at(node);
            State& s = w_.state;
            if (!w_.structure.has_panels(node) || s.gone[node] || s.offset_mass.empty() ||
                s.offset_mass[node].inertia.trace() > 0 ||
                std::any_of(at.begin(), at.end(), [&](int e) { return s.broken[e] == 0; }))
                continue;
            s.held[node] |= 8 | 16 | 32;
            s.velocity[node].tail<3>().setZero();
            s.acceleration[node].tail<3>().setZero();
        }
    }
    /// A node that has lost its last member, and has no mass, holds nothing any more.
    void all_broke() override {
        bool any = false;
        curvature_->place(w_.state);
        for (std::size_t i = 0; i < shape_.size(); ++i) {
            if (is_torn(now(), declared()[i], i)) continue;
            const auto& nodes = declared()[i].nodes;
            if (std::none_of(nodes.begin(), nodes.end(), [&](int n) { return w_.state.gone[n] != 0; })) continue;
            tear(i, all_layers, evaluate(i, place(i, w_.state), now(), false), w_.state.time), any = true;
        }
        if (any) curvature_->end_of_torn(), changed(w_.state);
    }
    bool allows_long_step() const override { return !any_awake(); }

    // ---- energy and checkpoint ------------------------------------------------------------------------------------
    void add_energy(const State& state, Accounts& sums) const override {
        double stored = 0;
        for (const double each : panels_now(state)->stored) stored += each;
        sums["panel_stored"] += stored;
    }
    bool restored(std::span<const State* const> states) override {
        return std::all_of(states.begin(), states.end(), [&](const State* s) {
            const PanelsNow* there = panels_now(*s);
            return there && there->history.size() == next_.size() && there->torn.size() == shape_.size() &&
                   there->on_trial.size() == shape_.size() && curvature_->fits(*s);
        });
    }

private:
    const std::vector<Panel>& declared() const { return declared_; }
    const std::vector<Panel>& declared_ = panels_of(w_.structure.model());
    PanelsNow& now() const { return *w_.state.data.find<PanelsNow>(panels_effect); }

    void add(const Panel& p) {
        const auto& X = w_.structure.position();
        std::array<Vec3, 4> places;
        for (std::size_t k = 0; k < p.nodes.size(); ++k) places[k] = X[p.nodes[k]];
        shape_.push_back(panel::shape_of({places.data(), p.nodes.size()}, p.along, p.sheet->poisson()));
        blocks_.join(p.nodes);
    }

    /// The state's part, where the run begins: panels that were declared since an earlier run are whole, and their mass
    /// is at their nodes.
    void begin(std::size_t history) {
        PanelsNow* n = w_.state.data.find<PanelsNow>(panels_effect);
        if (!n) n = &w_.state.data.set(panels_effect, PanelsNow{});
        const std::size_t before = n->torn.size();
        n->history.resize(history, 0);
        n->torn.resize(shape_.size(), 0);
        n->torn_at.resize(shape_.size(), std::numeric_limits<double>::quiet_NaN());
        n->force.resize(shape_.size(), Vec3::Zero());
        n->used.resize(shape_.size(), 0), n->stored.resize(shape_.size(), 0);
        n->on_trial.assign(shape_.size(), 0);
        for (std::size_t i = before; i < shape_.size(); ++i) {
            if (declared()[i].sheet->mass == 0) continue;
            if (w_.state.offset_mass.empty()) w_.state.offset_mass.assign(w_.state.displacement.size(), {});
            for (int k = 0; k < shape_[i].nodes; ++k)
                w_.state.offset_mass[declared()[i].nodes[k]].mass += declared()[i].sheet->mass * shape_[i].share[k];
        }
    }

    bool any_whole() const {
        const PanelsNow& n = now();
        for (std::size_t i = 0; i < shape_.size(); ++i)
            if (!is_torn(n, declared()[i], i)) return true;
        return false;
    }

    /// Whether it is whole and not at rest.
    bool takes_part(std::size_t i) const {
        return !w_.rests(declared()[i].nodes[0]) && !is_torn(now(), declared()[i], i);
    }
    bool any_awake() const {
        for (std::size_t i = 0; i < shape_.size(); ++i)
            if (takes_part(i)) return true;
        return false;
    }

    Placed place(std::size_t i, const Pose& at) const {
        const Panel& p = declared()[i];
        std::array<Vec3, 4> moved;
        for (std::size_t k = 0; k < p.nodes.size(); ++k) moved[k] = at.displacement[p.nodes[k]];
        return panel::place(shape_[i], {moved.data(), p.nodes.size()}, w_.structure.large());
    }

    /// d(resultants)/d(strain, p) of one stiffness at all points.
    static Mat5 generalised(const Shape& s, const Mat3& D) {
        Mat5 sum = Mat5::Zero();
        for (int k = 0; k < s.points; ++k) panel::add_point(s.point[k], D, sum);
        return sum;
    }
    /// Whether a layer is left that holds the panel together, where `layers` tear: concrete alone does not.
    bool any_holds(std::size_t i, std::uint8_t layers) const {
        const auto& all = declared()[i].sheet->layers;
        for (std::size_t l = 0; l < all.size(); ++l)
            if (all[l].kind != panel::LayerKind::concrete && !((layers | now().torn[i]) >> l & 1)) return true;
        return false;
    }
    /// Statics: a layer that tears in the step holds nothing at its end, which is in equilibrium without it. The
    /// curvature is the one that was placed last.
    Evaluated evaluate(std::size_t i, const Placed& at, const PanelsNow& from, bool with_tangent,
                       panel::Mat17* tangent = nullptr) const {
        panel::Bending bending;
        panel::Curvatures curved;
        std::uint8_t gone = from.torn[i];
        if (curvature_->has(i)) curved = curvature_->at(i), bending = {&curved, &curvature_->own_strains(i), tangent};
        // writes what its layers keep into next_
        const auto answer = [&] {
            return panel::respond(*declared()[i].sheet, shape_[i], at, gone, with_tangent, bending,
                                  &from.history[history_at_[i]], &next_[history_at_[i]]);
        };
        Evaluated e = answer();
        if (!e.tears) return e;
        if (!any_holds(i, e.tears)) e.tears = all_layers;
        if (w_.kind.dynamic) return e;
        gone |= e.tears;
        const Evaluated left = answer();
        e.resultants = left.resultants, e.tangent = left.tangent, e.moment = left.moment;
        return e;
    }

    /// Sums the stiffness of all panels in blocks of one node and of two. of(i, placed, resultants): its
    /// tangent; counts(node): whether those of the node count.
    template <class F, class Of>
    void add_stiffness(const Pose& pose, Blocks& blocks, F of, Of counts) const {
        blocks_.begin();
        curvature_->place(pose);
        for (std::size_t i = 0; i < shape_.size(); ++i) {
            if (!counts(declared()[i].nodes[0]) || is_torn(now(), declared()[i], i)) continue;
            const Placed at = place(i, pose);
            Resultants r;
            panel::Mat17 bending;
            const bool bends = curvature_->has(i);
            const Mat5 D = of(i, at, r, bends ? &bending : nullptr);
            if (bends) curvature_->add_stiffness(i, shape_[i], at, bending, blocks_);
            const auto& nodes = declared()[i].nodes;
            panel::for_each_stiffness(shape_[i], at, r, D, [&](int a, int b, const Mat3& K) {
                const int place = place_[i][std::size_t(int(nodes.size()) * a + b)];
                if (a == b) blocks_.add_own(place, K);
                else blocks_.add(place, K, nodes[a] < nodes[b]);
            });
        }
        blocks_.list(blocks, counts);
    }

    void tear(std::size_t i, std::uint8_t layers, const Evaluated& at, double when) {
        PanelsNow& n = now();
        const Panel& p = declared()[i];
        for (std::size_t l = 0; l < p.sheet->layers.size(); ++l) {
            if (!(layers >> l & 1) || n.torn[i] >> l & 1) continue;
            n.torn[i] |= std::uint8_t(1u << l);
            n.stored[i] -= at.stored_in[l];
            w_.state.accumulated["panel_dissipated"] += at.stored_in[l];
        }
        if (!is_torn(n, p, i)) return;
        n.stored[i] = 0, n.torn_at[i] = when, n.force[i].setZero();
        host_.note_activation(panels_effect, false, "panel " + std::to_string(i + 1) + " has torn");
    }
    void changed(const Pose& at) {
        host_.accelerations_anew();
        host_.blocks_changed(at);
    }

    std::vector<Shape> shape_;
    std::vector<std::vector<int>> place_;  ///< of each: those of its nodes in the blocks
    std::vector<std::size_t> history_at_;  ///< of each panel, and of all
    mutable TranslationBlocks blocks_;     ///< a sum that is listed at once
    mutable std::optional<PanelCurvature> curvature_;
    mutable std::vector<double> next_;     ///< PanelsNow::history where stresses were found last
    mutable std::vector<Evaluated> ends_;  ///< where the step has ended
};

void linear_panels(Model& model) {
    if (panels_of(model).empty()) return;
    std::shared_ptr<const panel::Sheet> from, to;  // many panels have the same
    for (Panel& p : model.change_declared<Panel>(panels_effect)) {
        if (p.sheet != from) from = p.sheet, to = std::make_shared<panel::Sheet>(from->linear());
        p.sheet = to;
    }
}

std::vector<PlanLine> panels_plan(const Structure& s, const RunKind&) {
    const std::size_t n = panels_of(s.model()).size();
    return {{panels_effect, n > 0, n == 0 ? "not declared" : std::to_string(n) + " by model:panel",
             s.model().asked_at(panels_effect)}};
}

}  // namespace

panel::Shape shape_of_panel(const Model& model, const Panel& p) {
    std::array<Vec3, 4> places;
    for (std::size_t k = 0; k < p.nodes.size(); ++k) places[k] = model.nodes()[p.nodes[k]].position;
    return panel::shape_of({places.data(), p.nodes.size()}, p.along, p.sheet->poisson());
}

double alpha_of_panels(const Structure& structure) {
    double alpha = 0;
    for (const Damping& d : structure.model().declared<Damping>(damping_effect))
        if (d.group < 0) alpha = d.alpha;
    for (std::size_t n = 0; n < structure.model().nodes().size(); ++n)
        if (structure.has_panels_alone(int(n))) return alpha;
    return 0;
}

const PanelsNow* panels_now(const State& state) { return state.data.find<PanelsNow>(panels_effect); }

EffectKind panels_kind() {
    return {
        .name = panels_effect,
        .accounts = {{"panels", 73, "stored in panels now, and dissipated by them", {}, false, true},
                     {"panel_stored", 74, "stored now in panels by their strain", "panels"},
                     {"panel_dissipated", 75, "by plastic strain of panels, and released where they tear", "panels"}},
        .plan = panels_plan,
        .make = [](Workspace& w, Host& host) -> std::unique_ptr<Effect> {
            if (panels_of(w.structure.model()).empty()) {
                w.state.data.erase(panels_effect);
                return nullptr;
            }
            return std::make_unique<Panels>(w, host);
        },
        .leave_out = leave_out_declared<panels_effect>,
        .linear = linear_panels,
        .declarer = {
            .masses =
                [](const Model& model) {
                    std::vector<AddedMass> list;
                    for (const Panel& p : panels_of(model)) {
                        if (p.sheet->mass == 0) continue;
                        const Shape s = shape_of_panel(model, p);
                        for (int k = 0; k < s.nodes; ++k)
                            list.push_back({p.nodes[k], {}}), list.back().mass.mass = p.sheet->mass * s.share[k];
                    }
                    return list;
                },
            .links =
                [](const Model& model) {
                    std::vector<NodeLink> list;
                    for (const Panel& p : panels_of(model))
                        for (std::size_t k = 0; k < p.nodes.size(); ++k)
                            list.push_back({p.nodes[k], p.nodes[(k + 1) % p.nodes.size()]});
                    return list;
                }}};
}

}  // namespace hinge
