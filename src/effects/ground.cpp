// The ground that members fall on: rigid half spaces. Each plane presses by one of two laws: points on springs
// (ground_points.cpp) where it has a stiffness or a restitution, else a layer with springs and dashpots per area
// (ground_layer.cpp). Nodes of panels have a law of their own (ground_panels.cpp). All have Coulomb's friction
// (contact/ground_friction.h).
#include "effects/ground.h"

#include <algorithm>

#include "core/rotation.h"
#include "effects/ground_law.h"
#include "effects/kinds.h"
#include "model/panel.h"

namespace hinge {

/// Part of the half depth: ends that begin further than this below the plane are no part of what stands on it.
constexpr double buried = 0.01;

void GroundLaw::add_force(const GroundEnd& end, const GroundPlane& plane, const Vec3& arm, const Vec3& push,
                          const Vec3& slip, std::vector<Vec6>& resisting) const {
    const Vec3 drag = end.stiffness * slip;
    Vec6& r = resisting[end.node];
    r.head<3>() += push + drag;
    r.tail<3>() += arm.cross(push) + surface(end, plane, arm).cross(drag);
}

void GroundLaw::add_slope_of_friction(const GroundEnd& end, const GroundPlane& plane, const Vec3& arm, Mat6& K) const {
    const Vec3& n = plane.normal;
    for (const Vec3& along : {Vec3(n.unitOrthogonal()), Vec3(n.cross(n.unitOrthogonal()))}) {
        const Vec6 row = row_of(along, surface(end, plane, arm));
        K += end.stiffness * row * row.transpose();
    }
}

Vec3 GroundLaw::moved_along(const GroundEnd& end, const GroundPlane& plane, Vec3 moved, const Quat& from,
                            const Quat& to) const {
    if (large_) moved -= rotation_vector(to * from.conjugate()).cross(end.radius * plane.normal);
    return moved - moved.dot(plane.normal) * plane.normal;
}

bool GroundLaw::touches_within(const GroundEnd& end, const GroundPlane& plane, const Step& step) const {
    if (end.left_out || is_held(end.node) || w_.rests(end.node)) return false;
    const Vec6 foreseen = w_.state.velocity[end.node] + (0.5 * step.dt) * w_.state.acceleration[end.node];
    const Vec3 arm = arm_of(end, w_.state);
    const double closing = -row_of(plane.normal, arm).dot(foreseen) * step.dt;
    return overlap_of(end, plane, place_of(end, w_.state, arm)) + closing > 0;
}

double GroundLaw::begin_at(GroundEnd& end, const GroundPlane& plane) const {
    const double inside = overlap_of(end, plane, place_of(end, w_.state, arm_of(end, w_.state)));
    end.left_out = end.arm.isZero(0) && inside > (1 + buried) * end.radius;
    end.level = std::max(0.0, inside);
    return inside;
}

namespace {

class Ground : public Effect,
               public Force,
               public ContactLaw,
               public BreakListener,
               public StepLimiter,
               public Sleeper {
public:
    Ground(Workspace& w, Host& host) : Effect(ground_effect, w, host, {.forces_vanish = true}) {
        const auto& planes = w.structure.model().declared<GroundPlane>(ground_effect);
        const auto is_layer = [](const GroundPlane& p) { return p.is_layer(); };
        if (!std::all_of(planes.begin(), planes.end(), is_layer)) laws_.push_back(ground_points(w, host));
        if (std::any_of(planes.begin(), planes.end(), is_layer)) laws_.push_back(ground_layer(w));
        if (!w.structure.model().declared<Panel>(panels_effect).empty()) laws_.push_back(ground_panels(w, host));
        planes_ = int(planes.size());
        if (fits(w.state)) return;
        GroundData data;
        data.planes = planes_, data.nodes = nodes();
        for (const auto& law : laws_) law->list(data);
        w.state.data.set(ground_effect, std::move(data));
    }

    void begin(const Step& step) override {
        each([&](GroundLaw& law) { law.begin(step); });
    }
    void add_forces(double, std::vector<Vec6>& resisting) override {
        each([&](GroundLaw& law) { law.add_forces(resisting); });
    }
    void add_blocks(const Pose&, Blocks& blocks) const override {
        each([&](const GroundLaw& law) { law.add_blocks(blocks); });
    }
    bool has_blocks() const override {
        return any([](const GroundLaw& law) { return law.pressed.now > 0 || law.pressed.before > 0; });
    }
    bool blocks_follow() const override { return has_blocks(); }
    void add_stiffest(Blocks& most) const override {
        each([&](const GroundLaw& law) { law.add_stiffest(most); });
    }

    /// Long steps end before something touches.
    bool detect_contacts(const Step& step) override {
        return !step.longer || !any([&](const GroundLaw& law) { return law.touches_within(step); });
    }
    bool has_converged() override {
        return !any([](const GroundLaw& law) { return !law.has_converged(); });
    }
    void solved(const Step&, const std::vector<Vec6>&) override {
        each([](GroundLaw& law) { law.solved(); });
    }
    void end(const Step& step) override {
        each([&](GroundLaw& law) { law.end(step); });
    }
    void accumulate_energy(const Step&, Accounts& sums) const override {
        each([&](const GroundLaw& law) { sums["ground_dissipated"] += law.lost(); });
    }
    void before_commit(const Step&) override {
        each([](GroundLaw& law) { law.before_commit(); });
    }
    void roll_back() override {
        each([](GroundLaw& law) { law.roll_back(); });
    }
    void acceleration_found() override {
        each([](GroundLaw& law) { law.acceleration_found(); });
    }
    void broke(const Break& b) override {
        each([&](GroundLaw& law) { w_.state.accumulated["ground_dissipated"] += law.broke(b); });
    }

    void keep_from_rest(const Bodies& bodies, std::vector<char>& rests) const override {
        each([&](const GroundLaw& law) { law.keep_from_rest(bodies, rests); });
    }
    void hold_up(const Bodies& bodies, std::vector<char>& held_up) const override {
        each([&](const GroundLaw& law) { law.hold_up(bodies, held_up); });
    }
    void rest_changed() override {
        each([](GroundLaw& law) { law.rest_changed(); });
    }
    bool allows_long_step() const override {
        return !busy() && !any([](const GroundLaw& law) { return law.waits(); });
    }
    bool busy() const override {
        return any([](const GroundLaw& law) { return law.pressed.now > 0; });
    }
    std::string why_awake() const override {
        for (const auto& law : laws_)
            if (law->pressed.now > 0) return law->name_of_first() + " on the ground";
        return "";
    }

    void add_energy(const State& state, Accounts& sums) const override {
        each([&](const GroundLaw& law) { sums["ground_stored"] += law.stored(state); });
    }
    void save(Writer& to) const override {
        each([&](const GroundLaw& law) { to(law.pressed); });
    }
    void restore(Reader& from) override {
        each([&](GroundLaw& law) { from(law.pressed), law.restored(); });
    }
    bool restored(std::span<const State* const> states) override {
        return std::all_of(states.begin(), states.end(), [this](const State* s) { return fits(*s); }) &&
               !any([](const GroundLaw& law) { return law.pressed.now < 0 || law.pressed.before < 0; });
    }

private:
    template <class F>
    void each(F f) const {
        for (const auto& law : laws_) f(*law);
    }
    template <class F>
    bool any(F f) const {
        return std::any_of(laws_.begin(), laws_.end(), [&](const auto& law) { return f(*law); });
    }
    int nodes() const { return int(w_.structure.position().size()); }
    /// Whether the state has data of the ground for these planes and nodes.
    bool fits(const State& state) const {
        const GroundData* data = state.data.find<GroundData>(ground_effect);
        if (!data || data->planes != planes_ || data->nodes != nodes()) return false;
        const auto within = [](int i, int n) { return i >= 0 && i < n; };
        const int elements = int(w_.structure.elements().size());
        for (const GroundPoint& p : data->points)
            if (!within(p.plane, planes_) || !within(p.end.node, nodes()) || !within(p.element + 1, elements + 1))
                return false;
        for (const GroundPanelPoint& p : data->panels)
            if (!within(p.plane, planes_) || !within(p.end.node, nodes())) return false;
        for (const GroundStrip& s : data->strips)
            if (!within(s.plane, planes_) || !within(s.element, elements) || !within(s.end[0].node, nodes()) ||
                !within(s.end[1].node, nodes()))
                return false;
        return true;
    }

    std::vector<std::unique_ptr<GroundLaw>> laws_;
    int planes_ = 0;
};

std::vector<PlanLine> ground_plan(const Structure& s, const RunKind&) {
    const std::size_t n = s.model().declared<GroundPlane>(ground_effect).size();
    const std::string because = n == 0   ? "not declared"
                                : n == 1 ? "model:ground"
                                         : "model:ground, " + std::to_string(n) + " planes";
    return {{ground_effect, n > 0, because, n > 0 ? s.model().asked_at("rigid ground") : ""}};
}

}  // namespace

EffectKind ground_kind() {
    return {.name = ground_effect,
            .accounts = {{"ground", 75, "stored where members press on the ground, and lost there"},
                         {"ground_stored", 76, "stored now where members press on the ground", "ground"},
                         {"ground_dissipated", 77,
                          "lost to the ground's damping, to friction and restitution on it, and as bodies come to rest",
                          "ground"}},
            .plan = ground_plan,
            .make = [](Workspace& w, Host& host) -> std::unique_ptr<Effect> {
                if (w.structure.model().declared<GroundPlane>(ground_effect).empty()) {
                    w.state.data.erase(ground_effect);
                    return nullptr;
                }
                return std::make_unique<Ground>(w, host);
            },
            .leave_out = leave_out_declared<ground_effect>,
            .declarer = {.planes = [](const Model& model) {
                std::vector<DeclaredPlane> list;
                for (const GroundPlane& p : model.declared<GroundPlane>(ground_effect))
                    list.push_back({p.point, p.normal});
                return list;
            }}};
}

}  // namespace hinge
