// Dynamics, the stages that change who touches whom (eqs 17-19).
#include <algorithm>
#include <cmath>

#include "state/bodies.h"
#include "run/dynamics.h"

namespace hinge {

/// Eqs 17-19: who comes into contact over this step.
void Dynamics::contact() {
    if (bars_changed_) list_bars();
    place_contact(state_.displacement);
    std::vector<Vec6>& foreseen = nodal_;  // free until stresses are recovered
    for (std::size_t i = 0; i < foreseen.size(); ++i)
        foreseen[i] = state_.velocity[i] + (0.5 * settings_.dt) * state_.acceleration[i];
    contact::PairRule rule_of;
    const std::vector<ContactRule>& rules = structure_->model().contact();
    if (rules.size() > 1 || rules[0].between || rules[0].pairs)
        rule_of = [this](int a, int b) { return contact_rule(a, b); };
    std::optional<contact::Contact> before;
    if (pace_.length > pace_.own) before = state_.contact;
    const int bound = state_.contact->detect(bars_, bars_changed_, {contact_position_, state_.rotation, foreseen},
                                             settings_.dt, state_.time, rule_of);
    if (before && !state_.contact->idle()) {  // too long a step to touch in
        state_.contact = std::move(before);
        take_steps_of(pace_.own);
        loads();
        return contact();
    }
    bars_changed_ = false;
    wake_bodies();
    if (bound > 0 || (!state_.contact->idle() && ++contact_age_ % 20 == 0)) renew_couplings(state_.rotation);
}

/// Where the step has ended: who is released, and what the step got wrong about touches that began or ended in it.
void Dynamics::part() {
    contact::Contact& contact = *state_.contact;
    if (contact.idle()) return;
    const double time = state_.time + settings_.dt;
    place_contact(trial_.displacement);
    std::vector<Vec6>& impulse = nodal_;
    for (Vec6& n : impulse) n.setZero();
    contact.add_internal_forces(contact_position_, trial_.rotation, impulse);

    std::vector<contact::Released> parted;
    const double released = contact.release(time, &parted);
    for (Vec6& n : impulse) n.setZero();
    const contact::Contact::Settled settled =
        contact.settle(time, settings_.dt, contact_position_, trial_.rotation, impulse);
    state_.accumulated.contact_released += released + settled.heat;
    if (settled.missed) add_missed(impulse, settled.work);
    for (const contact::Released& tie : parted)
        if (tie.springs_back) state_.accumulated.contact_released -= give_back(tie);
    if (!parted.empty()) {
        restart_ = true;
        renew_couplings(trial_.rotation);
    }
}

/// The impulses that the step missed (touch.h), scaled so that they do the work that was missed: near 1.
void Dynamics::add_missed(const std::vector<Vec6>& impulse, double work) {
    const Kick k = kick(impulse);
    const double root = k.linear * k.linear + 4 * k.square * work;
    double x = 1;
    if (root >= 0 && k.square > 0) {
        const double far = -0.5 * (k.linear + std::copysign(std::sqrt(root), k.linear)) / k.square,
                     near = far != 0 ? -work / k.square / far : 1;
        const double exact = std::abs(far - 1) < std::abs(near - 1) ? far : near;
        if (std::abs(exact - 1) < 0.5) x = exact;
    }
    state_.accumulated.work += x * k.by_supports;
    for (std::size_t i = 0; i < change_.size(); ++i) trial_.velocity[i] += x * change_[i];
}

/// What a tie still held when it was released springs back at once, along its own forces and so that the two bars part.
/// They are in balance, so momentum is kept; so is the energy.
double Dynamics::give_back(const contact::Released& tie) {
    std::vector<Vec6>& impulse = nodal_;
    for (Vec6& n : impulse) n.setZero();
    const auto arm = [&](int i) { return Vec3(trial_.rotation[tie.end[i].node] * tie.end[i].arm); };
    for (int i = 0; i < 4; ++i) {
        impulse[tie.end[i].node].head<3>() -= tie.force[i];
        impulse[tie.end[i].node].tail<3>() -= arm(i).cross(tie.force[i]);
    }
    const Kick k = kick(impulse);
    if (!(k.square > 0) || !(tie.energy > 0)) return 0;
    double opening = 0;
    for (int i = 0; i < 4; ++i) {
        const Vec6& v = change_[tie.end[i].node];
        opening += tie.opening[i].dot(v.head<3>() + v.tail<3>().cross(arm(i)));
    }
    // While forces act, Newmark's method with beta > 1/4 keeps (beta - 1/4) dt^2/2 a.M a of the energy to itself. The
    // force goes, and so does its part of that: M a+ = M a- + f.
    double power = 2 * k.square;
    for (std::size_t i = 0; i < impulse.size(); ++i) power -= 2 * impulse[i].dot(trial_.acceleration[i]);
    const double held_back = -0.5 * (settings_.beta - 0.5 * settings_.gamma()) * settings_.dt * settings_.dt * power;
    const double energy = std::max(0.0, tie.energy + held_back);
    const double root = std::sqrt(k.linear * k.linear + 4 * k.square * energy);
    const double x = (-k.linear + std::copysign(root, opening)) / (2 * k.square);
    state_.accumulated.work += x * k.by_supports;
    for (std::size_t i = 0; i < change_.size(); ++i) trial_.velocity[i] += x * change_[i];
    return tie.energy;
}

void Dynamics::place_contact(const std::vector<Vec3>& displacement) {
    contact_position_.resize(displacement.size());
    for (std::size_t i = 0; i < displacement.size(); ++i)
        contact_position_[i] = structure_->position()[i] + displacement[i];
}

/// By which of contact's rules two elements meet; the script's own rule is asked once for each pair of members.
int Dynamics::contact_rule(int element_a, int element_b) {
    const int a = structure_->elements()[element_a].member, b = structure_->elements()[element_b].member;
    const int declared = structure_->model().contact_rule(a, b);
    if (declared < 0) return -1;
    const ContactRule& rule = structure_->model().contact()[declared];
    if (!rule.pairs) return state_.contact->rule(rule.settings);
    const auto known = pair_rules_.find({a, b});
    const std::optional<contact::ContactSettings>& own =
        known != pair_rules_.end() ? known->second : pair_rules_[{a, b}] = rule.pairs(a, b);
    return own ? state_.contact->rule(*own) : -1;
}

/// What began and ended in the step: marked, and told to the script.
void Dynamics::note_contacts() {
    for (const contact::ContactEvent& event : state_.contact->events()) {
        const int a = structure_->elements()[event.element[0]].member,
                  b = structure_->elements()[event.element[1]].member;
        const int declared = structure_->model().contact_rule(a, b);
        if (declared < 0) continue;
        const ContactRule& rule = structure_->model().contact()[declared];
        if (const auto& tell = event.bound ? rule.on_touch : rule.on_release) tell(event, a, b);
    }
    for (const contact::ContactEvent& event : state_.contact->events())
        for (int e : event.element) state_.touched[e] = 1;
    state_.contact->clear_events();
}

/// Tangents of what is bound or touches where contact_position_ and `rotation` have the nodes.
void Dynamics::renew_couplings(const std::vector<Quat>& rotation) {
    if (!effective_) return;
    std::vector<Coupling> couplings;
    state_.contact->add_stiffness(contact_position_, rotation, [&](int a, int b, const Mat12& K) {
        couplings.push_back({a, b, K});
    });
    effective_->set_couplings(std::move(couplings));
}

void Dynamics::list_bars() {
    bars_.clear();
    const Bodies bodies = find_bodies(*structure_, state_);
    for (std::size_t i = 0; i < structure_->elements().size(); ++i) {
        const Element& e = structure_->elements()[i];
        if (!e.touches) continue;
        contact::Bar bar;
        bar.element = int(i);
        bar.radius = e.radius;
        bar.stiffness = e.rigidity.EA;
        bar.body = bodies.of_node[e.node[state_.broken[i] == 1 ? 1 : 0]];
        if (state_.broken[i]) {
            const int carrier = e.node[state_.broken[i] == 2 ? 0 : 1];
            bar.node[0] = bar.node[1] = carrier;
            bar.arm = state_.offset_arm[i];
        } else {
            for (int end : {0, 1}) bar.node[end] = e.node[end];
        }
        bars_.push_back(bar);
    }
}

}  // namespace hinge
