// Dynamics, the stages that change who is connected to whom: what touches (eqs 17-19) and what breaks (eq 16).
#include <algorithm>
#include <cmath>

#include "beam/fracture.h"
#include "sim/dynamics.h"
#include "sim/hinges.h"

namespace hinge {

/// Eqs 17-19: who comes into contact over this step, and who is let go.
void Dynamics::contact() {
    if (bars_changed_) list_bars();
    std::vector<Vec3>& x = contact_position_;
    std::vector<Vec6>& v = contact_velocity_;
    x.resize(trial_.displacement.size());
    v.resize(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        x[i] = structure_->position()[i] + state_.displacement[i];
        v[i] = state_.velocity[i] + (0.5 * settings_.dt) * state_.acceleration[i];
    }
    const long released = state_.contact->counts().released;
    if (!state_.contact->idle()) {  // what a bond holds is weighed where the nodes are, not where they were foreseen
        for (Vec6& n : nodal_) n.setZero();
        state_.contact->add_internal_forces(x, state_.rotation, nodal_);
    }
    state_.booked.contact_released += state_.contact->release(state_.time);
    const int bound = state_.contact->detect(bars_, bars_changed_, {x, state_.rotation, v}, settings_.dt, state_.time);
    bars_changed_ = false;
    for (const contact::ContactEvent& event : state_.contact->events())
        for (int e : event.element) state_.touched[e] = 1;
    state_.contact->clear_events();
    const bool let_go = state_.contact->counts().released != released, changed = bound > 0 || let_go;
    restart_ |= let_go;
    if (changed || (!state_.contact->idle() && ++contact_age_ % 20 == 0)) renew_couplings();
}

void Dynamics::renew_couplings() {
    std::vector<Operator::Coupling> couplings;
    for (std::size_t i = 0; i < contact_position_.size(); ++i) contact_position_[i] = structure_->position()[i] + state_.displacement[i];
    state_.contact->add_stiffness(contact_position_, state_.rotation, [&](int a, int b, const Mat12& K) { couplings.push_back({a, b, K}); });
    operator_.set_couplings(std::move(couplings));
}

void Dynamics::list_bars() {
    bars_.clear();
    for (std::size_t i = 0; i < structure_->elements().size(); ++i) {
        const Element& e = structure_->elements()[i];
        if (!e.touches) continue;
        contact::Bar bar;
        bar.element = int(i);
        bar.radius = e.radius;
        bar.stiffness = e.rigidity.EA;
        if (state_.broken[i]) {
            const int carrier = e.node[state_.broken[i] == 2 ? 0 : 1];
            bar.end[0] = {carrier, Vec3::Zero()};
            bar.end[1] = {carrier, state_.stub[i]};
        } else {
            bar.end[0] = {e.node[0], Vec3::Zero()};
            bar.end[1] = {e.node[1], Vec3::Zero()};
        }
        bars_.push_back(bar);
    }
}

/// Eq 16, element by element, where it can be met: those that have yielded, and those that can break without.
void Dynamics::fracture() {
    to_break_.clear();
    std::vector<int>& look = looked_at_;
    look.assign(fracture_candidates_.begin(), fracture_candidates_.end());
    look.insert(look.end(), ever_yielded_.begin(), ever_yielded_.end());
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
