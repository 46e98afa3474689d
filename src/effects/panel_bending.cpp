// Bending of panels: plates across their plane, about the nodes that they share (panel/bend.h), elastic up to their
// plastic moments. The membrane forces of the same panels are an effect of their own (panels.cpp), and neither changes
// the strength of the other. Where one of its panels has torn, a node bends no more.
#include <algorithm>
#include <cmath>

#include "effects/kinds.h"
#include "effects/placed_bend.h"
#include "effects/translation_blocks.h"

namespace hinge {
namespace {

using panel::Bend;
using panel::BendingLaw;
using panel::BendingResponse;

constexpr const char* bending_effect = "bending of panels";

/// Of each bend, where the last step that was kept ended.
struct BendingNow {
    std::vector<double> history;
    std::vector<double> stored;       ///< J
    std::vector<std::uint8_t> ended;  ///< 1 where a panel has torn
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.history, s.stored, s.ended);
    }
};

bool bends(const Panel& p) { return p.sheet->bending.stiffness > 0; }

class PanelBending : public Effect, public Force, public StepLimiter {
public:
    PanelBending(Workspace& w, Host& host) : Effect(bending_effect, w, host, {.mean_forces = true}) {
        make_bends();
        next_.resize(panel::bending_history * bends_.size());
        BendingNow* n = w.state.data.find<BendingNow>(bending_effect);
        if (!n || n->stored.size() != bends_.size()) {
            n = &w.state.data.set(bending_effect, BendingNow{});
            n->history.resize(next_.size(), 0), n->stored.resize(bends_.size(), 0), n->ended.resize(bends_.size(), 0);
        }
        for (const Panel& p : declared())
            for (const panel::Layer& l : p.sheet->layers) traits_.forces_vanish |= std::isfinite(l.ultimate);
    }

    // ---- what acts ------------------------------------------------------------------------------------------------
    void add_forces(double, std::vector<Vec6>& resisting) override {
        ends_.resize(bends_.size());
        for (std::size_t i = 0; i < bends_.size(); ++i) {
            if (rests(i) || has_ended(i)) continue;
            const PlacedBend& at = place(i, w_.trial);
            ends_[i] = respond(i, at, false);
            const Vec3 m = bends_[i].area * (bends_[i].to_frame.transpose() * ends_[i].moment);
            at.add_forces(bends_[i], w_.structure, m, resisting);
        }
    }
    bool has_blocks() const override {
        return std::any_of(now().ended.begin(), now().ended.end(), [](auto ended) { return !ended; });
    }
    bool blocks_follow() const override {
        return has_blocks() &&
               (w_.structure.large() ||
                std::any_of(laws_.begin(), laws_.end(), [](const BendingLaw& l) { return !l.is_elastic(); }));
    }
    bool blocks_may_lag() const override { return true; }
    void add_blocks(const Pose& at, Blocks& blocks) const override {
        add_stiffness(
            at, blocks, [&](std::size_t i, const PlacedBend& placed) { return respond(i, placed, true).tangent; },
            [this](int node) { return !w_.rests(node); });
    }
    void add_stiffest(Blocks& most) const override {
        add_stiffness(
            w_.state, most,
            [&](std::size_t i, const PlacedBend&) {
                double before[panel::bending_history] = {}, after[panel::bending_history];
                return panel::bend(laws_[i], Vec3::Zero(), before, after).tangent;
            },
            [](int) { return true; });
    }
    double scale_of_rounding(const Pose& at) const override {
        double sum = 0;
        for (std::size_t i = 0; i < bends_.size(); ++i) {
            const int node = bends_[i].nodes[0];
            const Vec3 where = w_.structure.position()[node] + at.displacement[node];
            sum += laws_[i].stiffness * (1 + where.squaredNorm() / bends_[i].area);
        }
        return sum;
    }

    // ---- a step ---------------------------------------------------------------------------------------------------
    void accumulate_energy(const Step&, Accounts& sums) const override {
        double dissipated = 0;
        for (std::size_t i = 0; i < bends_.size(); ++i) {
            if (rests(i) || now().ended[i]) continue;
            if (has_ended(i)) {  // statics
                dissipated += now().stored[i];
                continue;
            }
            if (!w_.kind.explicit_steps)  // else nothing has moved since the forces were found
                ends_[i] = respond(i, place(i, w_.trial), false);
            dissipated += bends_[i].area * ends_[i].dissipated;
        }
        sums["panel_dissipated"] += dissipated;
    }
    void before_commit(const Step&) override {
        BendingNow& n = now();
        for (std::size_t i = 0; i < bends_.size(); ++i) {
            if (rests(i) || n.ended[i]) continue;
            if (has_ended(i)) {
                n.stored[i] = 0;
                continue;
            }
            const auto from = next_.begin() + long(panel::bending_history * i);
            std::copy(from, from + panel::bending_history, n.history.begin() + long(panel::bending_history * i));
            n.stored[i] = bends_[i].area * ends_[i].stored;
        }
    }
    /// Panels that have torn in the step take their bends with them.
    void after_commit(const Step&) override {
        const PanelsNow* panels = panels_now(w_.state);
        bool any = false;
        for (std::size_t i = 0; i < bends_.size(); ++i) {
            if (now().ended[i]) continue;
            const auto& at = bends_[i].panels;
            if (std::none_of(at.begin(), at.end(),
                             [&](int p) { return is_torn(*panels, declared()[std::size_t(p)], std::size_t(p)); }))
                continue;
            now().ended[i] = 1, any = true;
            w_.state.accumulated["panel_dissipated"] += now().stored[i];
            now().stored[i] = 0;
        }
        if (!any) return;
        host_.accelerations_anew();
        host_.blocks_changed(w_.state);
    }
    bool allows_long_step() const override {
        for (std::size_t i = 0; i < bends_.size(); ++i)
            if (!rests(i) && !now().ended[i]) return false;
        return true;
    }

    // ---- energy and checkpoint ------------------------------------------------------------------------------------
    void add_energy(const State& state, Accounts& sums) const override {
        double stored = 0;
        for (const double each : state.data.find<BendingNow>(bending_effect)->stored) stored += each;
        sums["panel_stored"] += stored;
    }
    bool restored(std::span<const State* const> states) override {
        return std::all_of(states.begin(), states.end(), [&](const State* s) {
            const auto* there = s->data.find<BendingNow>(bending_effect);
            return there && there->history.size() == next_.size() && there->ended.size() == bends_.size();
        });
    }

private:
    const std::vector<Panel>& declared() const { return declared_; }
    const std::vector<Panel>& declared_ = w_.structure.model().declared<Panel>(panels_effect);
    BendingNow& now() const { return *w_.state.data.find<BendingNow>(bending_effect); }

    /// Each has the mean of its panels' properties.
    void make_bends() {
        bends_ = bends_of(w_.structure, declared(), bends, [](const Panel& p) { return p.sheet->bending.poisson; });
        for (const Bend& b : bends_) {
            BendingLaw mean{0, 0, 0, 0};
            for (const int p : b.panels) {
                const BendingLaw& own = declared()[std::size_t(p)].sheet->bending;
                const double part = 1 / double(b.panels.size());
                mean.stiffness += part * own.stiffness, mean.poisson += part * own.poisson;
                mean.sagging += part * own.sagging, mean.hogging += part * own.hogging;
            }
            laws_.push_back(mean);
            blocks_.join(b.nodes);
        }
        blocks_.joined();
        for (const Bend& b : bends_) place_.push_back(blocks_.places(b.nodes));
    }
    /// Statics: also where one of its panels tears at the place that is tried.
    bool has_ended(std::size_t i) const {
        const PanelsNow& panels = *panels_now(w_.state);
        return now().ended[i] || std::any_of(bends_[i].panels.begin(), bends_[i].panels.end(),
                                             [&](int p) { return panels.on_trial[std::size_t(p)] != 0; });
    }

    bool rests(std::size_t i) const { return w_.rests(bends_[i].nodes[0]); }
    const PlacedBend& place(std::size_t i, const Pose& pose) const {
        placed_.find(bends_[i], w_.structure, pose);
        return placed_;
    }
    /// Writes what the bend keeps into next_.
    BendingResponse respond(std::size_t i, const PlacedBend& at, bool with_tangent) const {
        const std::size_t history = panel::bending_history * i;
        return panel::bend(laws_[i], bends_[i].to_frame * at.bent.derivative, &now().history[history], &next_[history],
                           with_tangent);
    }

    template <class F, class Of>
    void add_stiffness(const Pose& pose, Blocks& blocks, F of, Of counts) const {
        blocks_.begin();
        for (std::size_t i = 0; i < bends_.size(); ++i) {
            if (!counts(bends_[i].nodes[0]) || has_ended(i)) continue;
            const Bend& b = bends_[i];
            const PlacedBend& at = place(i, pose);
            const Mat3 D = b.area * (b.to_frame.transpose() * of(i, at) * b.to_frame);
            const panel::Gradient G = at.gradient(b, w_.structure);
            const panel::Gradient DG = D * G;
            const int n = int(b.nodes.size());
            for (int j = 0; j < n; ++j)
                for (int k = 0; k < n; ++k) {
                    if (b.nodes[j] > b.nodes[k]) continue;
                    const Mat3 K = G.block<3, 3>(0, 3 * j).transpose() * DG.block<3, 3>(0, 3 * k);
                    const int place = place_[i][std::size_t(n * j + k)];
                    if (j == k) blocks_.add_own(place, K);
                    else blocks_.add(place, K, true);
                }
        }
        blocks_.list(blocks, counts);
    }

    std::vector<Bend> bends_;
    std::vector<BendingLaw> laws_;         ///< of each
    std::vector<std::vector<int>> place_;  ///< of each: those of its nodes in the blocks
    mutable PlacedBend placed_;            ///< the one that was asked for last
    mutable TranslationBlocks blocks_;     ///< a sum that is listed at once
    mutable std::vector<double> next_;     ///< BendingNow::history where moments were found last
    mutable std::vector<BendingResponse> ends_;
};

std::vector<PlanLine> bending_plan(const Structure& s, const RunKind&) {
    const auto& panels = s.model().declared<Panel>(panels_effect);
    const auto n = std::count_if(panels.begin(), panels.end(), bends);
    if (panels.empty()) return {};
    const auto layers =
        std::count_if(panels.begin(), panels.end(), [](const Panel& p) { return p.sheet->bends_by_layers; });
    const std::string none = layers == 0 ? "no panel has it" : std::to_string(layers) + " bend by their layers";
    return {{bending_effect, n > 0, n == 0 ? none : std::to_string(n) + " panels", ""}};
}

/// Their membranes and masses stay.
void leave_out_bending(Model& model) {
    if (model.declared<Panel>(panels_effect).empty()) return;
    for (Panel& p : model.change_declared<Panel>(panels_effect)) {
        auto sheet = std::make_shared<panel::Sheet>(*p.sheet);
        sheet->bending = {};
        p.sheet = std::move(sheet);
    }
}

}  // namespace

EffectKind panel_bending_kind() {
    return {.name = bending_effect,
            .plan = bending_plan,
            .make = [](Workspace& w, Host& host) -> std::unique_ptr<Effect> {
                const auto& panels = w.structure.model().declared<Panel>(panels_effect);
                if (std::none_of(panels.begin(), panels.end(), bends)) {
                    w.state.data.erase(bending_effect);
                    return nullptr;
                }
                return std::make_unique<PanelBending>(w, host);
            },
            .leave_out = leave_out_bending};
}

}  // namespace hinge
