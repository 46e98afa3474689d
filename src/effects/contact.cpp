// Contact of elements (eqs 17 to 19, or by surfaces): detection, tie and contact forces, and the impulses of contacts
// that begin or end within a step. src/contact has the geometry and the laws.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "effects/contact.h"
#include "effects/kinds.h"

namespace hinge {
namespace {

using contact::Contact;

bool laws_call_functions(const Model& model) {
    const auto& rules = contact_rules(model);
    return std::any_of(rules.begin(), rules.end(),
                       [](const ContactRule& r) { return r.pairs || r.on_contact || r.on_release; });
}

/// Steps between renewals of the ties' tangent where nothing began: they rotate slowly, by some mrad a step. Of 125
/// runs of tests/hard (contacts and breaking, 1 to 8 times a scene's step) 116 or 117 keep their bounds with 1 to 40
/// steps, 114 with 80 and 113 if it is never renewed. The first 0.06 s of Case I renew it 352 times with 20 steps, 4746
/// with 1, and take as many iterations within 2 %.
constexpr long steps_of_tangent = 20;

class ContactEffect : public Effect,
                      public Force,
                      public ContactLaw,
                      public Breaker,
                      public BreakListener,
                      public StepLimiter,
                      public Sleeper {
public:
    ContactEffect(Workspace& w, Host& host)
        : Effect(contact_effect, w, host, {.forces_vanish = true}), rules_(contact_rules(w.structure.model())) {
        traits_.calls_script = laws_call_functions(w.structure.model());
        if (!w.state.data.find<Contact>(contact_effect)) {
            std::vector<contact::ContactSettings> rules;
            for (const ContactRule& rule : rules_) rules.push_back(rule.settings);
            w.state.data.set(contact_effect, Contact(std::move(rules)));
        }
        for (const MemberData& m : w.structure.model().members()) collides_.push_back(can_collide(rules_, m));
        member_length_.assign(collides_.size(), 0.0);
        for (const Element& e : w.structure.elements()) member_length_[e.member] += e.length;
        now().release_step();  // it may come from a run in the middle of a step
    }

    bool detect_contacts(const Step& step) override {
        if (!bars_changed_ && passes(step)) return true;
        if (bars_changed_) list_bars();
        place(w_.state.displacement);
        foreseen_.resize(w_.state.velocity.size());
        for (std::size_t i = 0; i < foreseen_.size(); ++i)
            foreseen_[i] = w_.state.velocity[i] + (0.5 * step.dt) * w_.state.acceleration[i];
        contact::PairRule rule_of;
        if (rules_.size() > 1 || rules_[0].between || rules_[0].pairs)
            rule_of = [this](int a, int b) { return rule_between(a, b); };
        std::optional<Contact> before;
        if (step.longer) before = now();
        const int bound = now().detect(bars_, bars_changed_, {position_, w_.state.rotation, foreseen_}, step.dt,
                                       w_.state.time, rule_of);
        if (before && !now().idle()) {  // too long a step to meet in
            now() = std::move(*before);
            return false;
        }
        bars_changed_ = false;
        if (!w_.resting.empty() && !now().idle()) {
            std::vector<Reached> reached;
            const auto list = [&](const auto& pairs) {
                for (const auto& pair : pairs)
                    for (int e : pair.element) reached.push_back({e, "reached"});
            };
            list(now().surface_contacts()), list(now().ties());
            host_.reached(reached);
        }
        if (bound > 0 || (!now().idle() && ++age_ % steps_of_tangent == 0)) host_.blocks_changed(w_.state);
        return true;
    }

    void add_forces(double, std::vector<Vec6>& resisting) override {
        if (now().idle()) return;
        place(w_.trial.displacement);
        now().add_internal_forces(position_, w_.trial.rotation, resisting);
    }
    void add_blocks(const Pose& at, Blocks& blocks) const override {
        place(at.displacement);
        now().add_stiffness(position_, at.rotation, [&](int a, int b, const Mat12& K) { blocks.stiffness(a, b, K); });
    }
    bool has_blocks() const override { return !now().idle(); }
    bool blocks_follow() const override { return !now().surface_contacts().empty(); }

    bool has_converged() override {
        if (now().idle() || now().surface_contacts().empty()) return true;
        place(w_.trial.displacement);
        return !now().unsettled(position_, w_.trial.rotation);
    }

    /// Releases ties, and adds the impulses of contacts that began or ended in the step.
    void end(const Step& step) override {
        if (now().idle()) return;
        const double time = step.end();
        place(w_.trial.displacement);
        impulse_.assign(w_.trial.velocity.size(), Vec6::Zero());
        now().add_internal_forces(position_, w_.trial.rotation, impulse_);

        std::vector<contact::Released> parted;
        const double released = now().release(time, &parted);
        for (Vec6& n : impulse_) n.setZero();
        const Contact::StepResult ended = now().end_step(time, step.dt, position_, w_.trial.rotation, impulse_);
        w_.state.accumulated["contact_released"] += released + ended.heat;
        if (ended.missed) add_missed(ended.work);
        for (const contact::Released& tie : parted)
            if (tie.springs_back) w_.state.accumulated["contact_released"] -= spring_back(step, tie);
        if (!parted.empty()) {
            host_.accelerations_anew();
            host_.blocks_changed(w_.trial);
        }
    }

    /// Calls the script's functions for contacts that began or ended in the step, and marks their elements.
    const char* stage_name() const override { return "events"; }
    void find_breaks(Step&) override {
        for (const contact::ContactEvent& event : now().events()) {
            const int a = member(event.element[0]), b = member(event.element[1]);
            const int rule = rule_for(a, b);
            if (rule < 0) continue;
            if (const auto& tell = event.bound ? rules_[rule].on_contact : rules_[rule].on_release) tell(event, a, b);
        }
        for (const contact::ContactEvent& event : now().events())
            for (int e : event.element) w_.state.touched[e] = 1;
        for (const contact::SurfaceContact& contact : now().surface_contacts())
            if (contact.penetration_before > 0)
                for (int e : contact.element) w_.state.touched[e] = 1;
        now().clear_events();
    }

    void broke(const Break& b) override {
        w_.state.accumulated["contact_released"] += now().drop(b.element);
        bars_changed_ = true;
    }
    void all_broke() override {
        list_bars();
        place(w_.state.displacement);
        now().follow_broken(bars_, position_, w_.state.rotation);
        host_.blocks_changed(w_.state);
    }

    void save_step() override {
        now().save_step();
        bars_changed_before_ = bars_changed_, age_before_ = age_;
    }
    void roll_back() override {
        bars_changed_ = bars_changed_before_, age_ = age_before_;
        now().roll_back();
        host_.blocks_changed(w_.state);
    }
    void release_step() override { now().release_step(); }

    void keep_from_rest(const Bodies& bodies, std::vector<char>& rests) const override {
        const auto keep = [&](const auto& pairs) {
            for (const auto& pair : pairs)
                for (int e : pair.element) rests[bodies.of_node[w_.structure.elements()[e].node[0]]] = 0;
        };
        keep(now().surface_contacts()), keep(now().ties());
    }
    bool allows_long_step() const override { return now().idle(); }
    bool busy() const override { return now().nearest().element[0] >= 0 || !now().idle(); }
    std::string why_awake() const override {
        const contact::Nearest& nearest = now().nearest();
        if (nearest.element[0] < 0) return "members bound or touching";
        char text[64];
        std::snprintf(text, sizeof text, "2 bodies within %.2g m: ", std::max(0.0, nearest.distance));
        return text + w_.structure.element_name(nearest.element[0]) + " and " +
               w_.structure.element_name(nearest.element[1]);
    }

    void add_energy(const State& state, Accounts& sums) const override {
        const Contact* there = state.data.find<Contact>(contact_effect);
        if (!there || there->idle()) return;
        std::vector<Vec3> x(w_.structure.position());
        for (std::size_t i = 0; i < x.size(); ++i) x[i] += state.displacement[i];
        Contact copy = *there;
        std::vector<Vec6> unused(x.size(), Vec6::Zero());
        copy.add_internal_forces(x, state.rotation, unused);
        sums["contact_stored"] += copy.stored_energy();
    }

    void save(Writer& to) const override { to(bars_changed_, age_, pair_rules_); }
    void restore(Reader& from) override { from(bars_changed_, age_, pair_rules_); }
    bool restored(std::span<const State* const> states) override {
        list_bars();
        for (const State* s : states)
            if (!s->data.find<Contact>(contact_effect)
                     ->makes_sense(int(s->displacement.size()), int(s->broken.size()), int(bars_.size())))
                return false;
        return true;
    }

private:
    Contact& now() const { return *w_.state.data.find<Contact>(contact_effect); }
    int member(int element) const { return w_.structure.elements()[element].member; }
    int rule_for(int member_a, int member_b) const {
        const auto& members = w_.structure.model().members();
        return contact_rule(rules_, members[member_a], members[member_b]);
    }

    /// Whether nothing can come near in the step: found without a copy of where the nodes are and how they move.
    bool passes(const Step& step) {
        return now().passes(
            [this](int n) { return Vec3(w_.structure.position()[n] + w_.state.displacement[n]); },
            [&](int n) { return Vec6(w_.state.velocity[n] + (0.5 * step.dt) * w_.state.acceleration[n]); },
            [this](int n) { return !w_.rests(n); }, step.dt, w_.state.time);
    }

    void place(const std::vector<Vec3>& displacement) const {
        position_.resize(displacement.size());
        for (std::size_t i = 0; i < displacement.size(); ++i)
            position_[i] = w_.structure.position()[i] + displacement[i];
    }

    /// The contact rule of two elements. The script's own rule is called once for each pair of members.
    int rule_between(int element_a, int element_b) {
        const int a = member(element_a), b = member(element_b);
        const int place = rule_for(a, b);
        if (place < 0) return -1;
        const ContactRule& rule = rules_[place];
        if (!rule.pairs) return now().rule(rule.settings);
        const auto known = pair_rules_.find({a, b});
        const std::optional<contact::ContactSettings>& own =
            known != pair_rules_.end() ? known->second : pair_rules_[{a, b}] = rule.pairs(a, b);
        return own ? now().rule(*own) : -1;
    }

    void list_bars() {
        bars_.clear();
        const Bodies bodies = find_bodies(w_.structure, w_.state);
        for (std::size_t i = 0; i < w_.structure.elements().size(); ++i) {
            const Element& e = w_.structure.elements()[i];
            if (!collides_[e.member]) continue;
            contact::Bar bar;
            bar.element = int(i);
            bar.radius = e.radius;
            bar.stiffness = e.rigidity.EA;
            bar.body = bodies.of_node[e.node[w_.state.broken[i] == 1 ? 1 : 0]];
            if (w_.state.broken[i]) {
                const int carrier = e.node[w_.state.broken[i] == 2 ? 0 : 1];
                bar.node[0] = bar.node[1] = carrier;
                bar.arm = w_.state.offset_arm[i];
            } else {
                for (int end : {0, 1}) bar.node[end] = e.node[end];
            }
            for (int end : {0, 1}) bar.joint[end] = w_.structure.declared_node(bar.node[end]);
            bar.length = member_length_[e.member];
            bars_.push_back(bar);
        }
        number_chains();
    }

    /// The elements of a member follow each other; a chain ends where one does not begin in the node of the one before.
    void number_chains() {
        for (std::size_t i = 0; i < bars_.size(); ++i) {
            contact::Bar& bar = bars_[i];
            bar.chain = bar.element;
            if (i == 0) continue;
            const contact::Bar& last = bars_[i - 1];
            if (member(last.element) == member(bar.element) && last.node[1] == bar.node[0]) bar.chain = last.chain;
        }
    }

    /// The impulses that the step missed (surface_contact.h), scaled so that they do the work that was missed: near 1.
    void add_missed(double work) {
        const ImpulseResponse k = host_.respond(impulse_);
        add_to_trial(w_, k.factor_for(work), k);
    }

    /// The energy of a released tie springs back at once, along its own forces and so that the two bars part.
    /// They are in balance, so momentum is kept; so is the energy.
    double spring_back(const Step& step, const contact::Released& tie) {
        for (Vec6& n : impulse_) n.setZero();
        const auto arm = [&](int i) { return Vec3(w_.trial.rotation[tie.end[i].node] * tie.end[i].arm); };
        for (int i = 0; i < 4; ++i) {
            impulse_[tie.end[i].node].head<3>() -= tie.force[i];
            impulse_[tie.end[i].node].tail<3>() -= arm(i).cross(tie.force[i]);
        }
        const ImpulseResponse k = host_.respond(impulse_);
        if (!(k.square > 0) || !(tie.energy > 0)) return 0;
        double opening = 0;
        for (int i = 0; i < 4; ++i) {
            const Vec6& v = k.change[tie.end[i].node];
            opening += tie.opening[i].dot(v.head<3>() + v.tail<3>().cross(arm(i)));
        }
        // the force goes, and so does its part of what the method holds back: M a+ = M a- + f
        double power = 2 * k.square;
        for (std::size_t i = 0; i < impulse_.size(); ++i) power -= 2 * impulse_[i].dot(w_.trial.acceleration[i]);
        const double energy = std::max(0.0, tie.energy - w_.scheme.held_back(power, step.dt));
        const double root = std::sqrt(k.linear * k.linear + 4 * k.square * energy);
        add_to_trial(w_, (-k.linear + std::copysign(root, opening)) / (2 * k.square), k);
        return tie.energy;
    }

    const std::vector<ContactRule>& rules_;
    std::vector<char> collides_;         ///< of each member
    std::vector<double> member_length_;  ///< m
    std::vector<contact::Bar> bars_;
    bool bars_changed_ = true, bars_changed_before_ = true;
    long age_ = 0, age_before_ = 0;       ///< steps with contact
    mutable std::vector<Vec3> position_;  ///< m, where the nodes were last placed
    std::vector<Vec6> foreseen_;          ///< mean velocities over the coming step
    std::vector<Vec6> impulse_;           ///< N s, N m s
    std::map<std::pair<int, int>, std::optional<contact::ContactSettings>>
        pair_rules_;  ///< what the script's rule said of two members
};

std::vector<PlanLine> contact_plan(const Structure& s, const RunKind&) {
    const bool contact = !contact_rules(s.model()).empty();
    return {{contact_effect, contact, contact ? "model:contact" : "not declared", s.model().asked_at(contact_effect)}};
}

std::vector<PlanLine> friction_plan(const Structure& s, const RunKind&) {
    const auto& rules = contact_rules(s.model());
    const bool friction = std::any_of(rules.begin(), rules.end(), [](const ContactRule& r) {
        return r.settings.rule == contact::ContactRuleKind::surface && r.settings.friction > 0;
    });
    return {{"friction", friction,
             friction         ? "model:contact with friction"
             : !rules.empty() ? "no friction given to model:contact"
                              : "no contact",
             friction ? s.model().asked_at(contact_effect) : ""}};
}

void leave_out_friction(Model& model) {
    for (ContactRule& rule : model.change_declared<ContactRule>(contact_effect)) {
        rule.settings.friction = 0;
        if (!rule.pairs) continue;
        rule.pairs = [pairs = rule.pairs](int a, int b) {
            auto settings = pairs(a, b);
            if (settings) settings->friction = 0;
            return settings;
        };
    }
}

/// A touch is as stiff as its softer element, which takes a node's frequency up by the root of 3/2; gap elements are
/// four springs of half an element's length each, which take it up three times (Case I of the ten-storey impact holds
/// its energy to 0.1 % at 0.22 of the limit, to 0.35 % at 0.37, and not at all at 0.7).
double part_of_stable_step(const Model& model) {
    double part = 1;
    for (const ContactRule& rule : contact_rules(model))
        part = std::min(part, rule.settings.rule == contact::ContactRuleKind::gap ? 0.2 : 0.35);
    return part;
}

bool in_any(const MemberData& member, const std::vector<int>& groups) {
    return std::any_of(groups.begin(), groups.end(), [&](int g) {
        return std::find(member.groups.begin(), member.groups.end(), g) != member.groups.end();
    });
}

}  // namespace

int contact_rule(const std::vector<ContactRule>& rules, const MemberData& a, const MemberData& b) {
    int general = -1;
    for (int i = int(rules.size()) - 1; i >= 0; --i) {
        const std::vector<int>& groups = rules[i].groups;
        if (groups.empty()) {
            general = std::max(general, i);
            continue;
        }
        const auto across = [&](const MemberData& p, const MemberData& q) {
            return in_any(p, {groups[0]}) && in_any(q, {groups[1]});
        };
        if (rules[i].between ? across(a, b) || across(b, a) : in_any(a, groups) && in_any(b, groups)) return i;
    }
    return general;
}

bool can_collide(const std::vector<ContactRule>& rules, const MemberData& member) {
    return std::any_of(rules.begin(), rules.end(),
                       [&](const ContactRule& r) { return r.groups.empty() || in_any(member, r.groups); });
}

EffectKind contact_kind() {
    return {.name = contact_effect,
            .accounts = {{"contact", 60, "stored in contacts now, released with ties, and heat of friction", {}, true},
                         {"contact_stored", 61, "stored in contacts now", "contact", true},
                         {"contact_released", 62, "released with ties, and heat of friction", "contact", true}},
            .plan = contact_plan,
            .make = [](Workspace& w, Host& host) -> std::unique_ptr<Effect> {
                if (!built::contact || contact_rules(w.structure.model()).empty()) {
                    w.state.data.erase(contact_effect);
                    return nullptr;
                }
                return std::make_unique<ContactEffect>(w, host);
            },
            .dynamic_only = true,
            .leave_out = leave_out_declared<contact_effect>,
            .declarer = {.functions = [](const Model& model) -> std::vector<ScriptFunctions> {
                if (!laws_call_functions(model)) return {};
                return {{1, "a function in model:contact", true, model.asked_at(contact_effect)}};
            }},
            .part_of_stable_step = part_of_stable_step};
}

EffectKind friction_kind() {
    return {.name = "friction", .plan = friction_plan, .dynamic_only = true, .leave_out = leave_out_friction};
}

}  // namespace hinge
