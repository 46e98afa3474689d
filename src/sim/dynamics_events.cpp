// Dynamics, the stages that change who is connected to whom: what touches (eqs 17-19) and what breaks (eq 16).
#include <algorithm>
#include <cmath>
#include <limits>

#include "beam/fracture.h"
#include "sim/bodies.h"
#include "sim/dynamics.h"
#include "sim/hinges.h"

namespace hinge {

/// Eqs 17-19: who comes into contact over this step.
void Dynamics::contact() {
    if (bars_changed_) list_bars();
    place_contact(state_.displacement);
    std::vector<Vec6>& foreseen = nodal_;  // free until stresses are recovered
    for (std::size_t i = 0; i < foreseen.size(); ++i) foreseen[i] = state_.velocity[i] + (0.5 * settings_.dt) * state_.acceleration[i];
    std::optional<contact::Contact> before;
    if (pace_.length > 1) before = state_.contact;
    const int bound = state_.contact->detect(bars_, bars_changed_, {contact_position_, state_.rotation, foreseen}, settings_.dt, state_.time);
    if (before && !state_.contact->idle()) {  // too long a step to touch in
        state_.contact = std::move(before);
        take_steps_of(1);
        loads();
        return contact();
    }
    bars_changed_ = false;
    note_contacts();
    wake_bodies();
    if (bound > 0 || (!state_.contact->idle() && ++contact_age_ % 20 == 0)) renew_couplings(state_.rotation);
}

/// Where the step has ended: who is let go, and what the step got wrong about touches that began or ended in it.
void Dynamics::part() {
    contact::Contact& contact = *state_.contact;
    if (contact.idle()) return;
    const double time = state_.time + settings_.dt;
    place_contact(trial_.displacement);
    std::vector<Vec6>& impulse = nodal_;
    for (Vec6& n : impulse) n.setZero();
    contact.add_internal_forces(contact_position_, trial_.rotation, impulse);

    std::vector<contact::LetGo> parted;
    const double let_go = contact.release(time, &parted);
    for (Vec6& n : impulse) n.setZero();
    const contact::Contact::Settled settled = contact.settle(time, settings_.dt, contact_position_, trial_.rotation, impulse);
    state_.booked.contact_released += let_go + settled.heat;
    if (settled.missed) add_missed(impulse, settled.work);
    if (contact.settings().hold_until_parting)
        for (const contact::LetGo& bond : parted) state_.booked.contact_released -= give_back(bond);
    note_contacts();
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
        const double far = -0.5 * (k.linear + std::copysign(std::sqrt(root), k.linear)) / k.square, near = far != 0 ? -work / k.square / far : 1;
        const double exact = std::abs(far - 1) < std::abs(near - 1) ? far : near;
        if (std::abs(exact - 1) < 0.5) x = exact;
    }
    for (std::size_t i = 0; i < change_.size(); ++i) trial_.velocity[i] += x * change_[i];
}

/// What a bond still held when it was let go springs back at once, along its own forces and so that the two bars part. They
/// are in balance, so momentum is kept; so is the energy.
double Dynamics::give_back(const contact::LetGo& bond) {
    std::vector<Vec6>& impulse = nodal_;
    for (Vec6& n : impulse) n.setZero();
    const auto arm = [&](int i) { return Vec3(trial_.rotation[bond.end[i].node] * bond.end[i].arm); };
    for (int i = 0; i < 4; ++i) {
        impulse[bond.end[i].node].head<3>() -= bond.force[i];
        impulse[bond.end[i].node].tail<3>() -= arm(i).cross(bond.force[i]);
    }
    const Kick k = kick(impulse);
    if (!(k.square > 0) || !(bond.energy > 0)) return 0;
    double opening = 0;
    for (int i = 0; i < 4; ++i) {
        const Vec6& v = change_[bond.end[i].node];
        opening += bond.opening[i].dot(v.head<3>() + v.tail<3>().cross(arm(i)));
    }
    // While forces act, Newmark's method with beta > 1/4 keeps (beta - 1/4) dt^2/2 a.M a of the energy to itself. The force goes,
    // and so does its part of that: M a+ = M a- + f.
    double power = 2 * k.square;
    for (std::size_t i = 0; i < impulse.size(); ++i) power -= 2 * impulse[i].dot(trial_.acceleration[i]);
    const double held_back = -0.5 * (settings_.beta - 0.25) * settings_.dt * settings_.dt * power;
    const double energy = std::max(0.0, bond.energy + held_back);
    const double root = std::sqrt(k.linear * k.linear + 4 * k.square * energy);
    const double x = (-k.linear + std::copysign(root, opening)) / (2 * k.square);
    for (std::size_t i = 0; i < change_.size(); ++i) trial_.velocity[i] += x * change_[i];
    return bond.energy;
}

void Dynamics::place_contact(const std::vector<Vec3>& displacement) {
    contact_position_.resize(displacement.size());
    for (std::size_t i = 0; i < displacement.size(); ++i) contact_position_[i] = structure_->position()[i] + displacement[i];
}

void Dynamics::note_contacts() {
    for (const contact::ContactEvent& event : state_.contact->events())
        for (int e : event.element) state_.touched[e] = 1;
    state_.contact->clear_events();
}

/// Tangents of what is bound or touches where contact_position_ and `rotation` have the nodes.
void Dynamics::renew_couplings(const std::vector<Quat>& rotation) {
    if (!operator_) return;
    std::vector<Coupling> couplings;
    state_.contact->add_stiffness(contact_position_, rotation, [&](int a, int b, const Mat12& K) { couplings.push_back({a, b, K}); });
    operator_->set_couplings(std::move(couplings));
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
            bar.arm = state_.stub[i];
        } else {
            for (int end : {0, 1}) bar.node[end] = e.node[end];
        }
        bars_.push_back(bar);
    }
}

/// Whether the element could meet eq 16 without flowing on: its plastic strains and the most that it can strain elastically reach
/// the limit. (Elastic curvature is a mean of the two end moments over EI, and neither is above the fully plastic one.)
void Dynamics::heed_fracture(int index) {
    const Element& e = structure_->elements()[index];
    if (e.fracture < 0 || in_candidates_[index] || state_.broken[index]) return;
    const FractureRule& rule = structure_->model().fracture()[e.fracture];
    const auto elastic = [](double w, double rigidity) { return w > 0 ? (1 + 1e-6) / (std::sqrt(w) * rigidity) : std::numeric_limits<double>::infinity(); };
    const beam::FractureStrains plastic = beam::fracture_strains(state_.plastic[index], e.length);
    if (e.yield.elastic() || rule.curvature_x <= std::abs(plastic.curvature_x) + elastic(e.yield.x, e.rigidity.EIx) ||
        rule.curvature_y <= std::abs(plastic.curvature_y) + elastic(e.yield.y, e.rigidity.EIy) ||
        rule.axial_strain <= std::abs(plastic.axial) + elastic(e.yield.n, e.rigidity.EA)) {
        in_candidates_[index] = 1;
        fracture_candidates_.push_back(index);
    }
}

/// Eq 16, element by element, where it can be met: those that flow, and those that could break without.
void Dynamics::fracture() {
    to_break_.clear();
    std::vector<int>& look = looked_at_;
    look.assign(fracture_candidates_.begin(), fracture_candidates_.end());
    for (const Yielding& y : yielding_) look.push_back(y.element);
    std::sort(look.begin(), look.end());
    look.erase(std::unique(look.begin(), look.end()), look.end());
    std::size_t next = 0;
    for (int e : look) {
        while (next < yielding_.size() && yielding_[next].element < e) ++next;
        const beam::Flow* flow = next < yielding_.size() && yielding_[next].element == e ? &yielding_[next].flow : nullptr;
        int end = 0;
        if (!state_.broken[e] && structure_->elements()[e].fracture >= 0 && breaks(e, flow, end)) to_break_.push_back({e, end});
    }
}

bool Dynamics::breaks(int index, const beam::Flow* flow, int& end) const {
    const Element& e = structure_->elements()[index];
    const FractureRule& rule = structure_->model().fracture()[e.fracture];
    const beam::Stiffness k = stiffness_now(*structure_, state_, index);
    const Vec6& p = force_[index];
    Vec6 d = k.solve(p) + state_.plastic[index];
    if (flow) d += flow->plastic;
    const beam::FractureStrains strains = beam::fracture_strains(d, e.length);
    const double f1 = beam::yield_function(p, -1, e.yield), f2 = beam::yield_function(p, 1, e.yield);
    const double m1 = p[0] * p[0] + p[2] * p[2], m2 = p[1] * p[1] + p[3] * p[3];
    // where it breaks: at the section that flows, else at the one nearer to it
    if (flow && !structure_->conventional() && flow->lambda[0] != flow->lambda[1]) end = flow->lambda[0] > flow->lambda[1] ? 1 : 2;
    else end = f1 > f2 || (f1 == f2 && m1 > m2) ? 1 : 2;
    if (!rule.hook) return beam::reached(strains, rule.curvature_x, rule.curvature_y, rule.axial_strain, rule.tension_only);
    // a script's rule is asked where it can matter: sections that flow, or the ends of an element that cannot
    for (int side : {end, 3 - end}) {
        const bool flows = flow && (structure_->conventional() ? side == end : flow->lambda[side - 1] > 0);
        if (!flows && !e.yield.elastic()) continue;
        SectionView view;
        view.time = state_.time + settings_.dt;
        view.step = double(state_.step + 1);
        view.member = e.member;
        view.element = index;
        view.end = side;
        view.curvature_x = strains.curvature_x;
        view.curvature_y = strains.curvature_y;
        view.axial_strain = strains.axial;
        view.twist = strains.twist;
        const double r = side == 1 ? -1 : 1;
        view.Mx = beam::moment_at(p[0], p[1], r);
        view.My = beam::moment_at(p[2], p[3], r);
        view.N = p[4];
        view.Mz = p[5];
        view.f_y = side == 1 ? f1 : f2;
        view.plastic_work = state_.plastic_work[index] + (flow ? flow->dissipation : 0);
        view.plastic = flows;
        if (rule.hook(view)) return end = side, true;
    }
    return false;
}

}  // namespace hinge
