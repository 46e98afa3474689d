#include "section/potential_law.h"

#include <cmath>

#include "section/potential_parts.h"

namespace hinge::beam {
namespace {

constexpr int most_rounds = 200;

/// The screen of a section whose material weakens it before any flow.
YieldSurface screen_with(YieldSurface screen, const SectionMaterial& material) {
    double factor = 1;
    for (const auto& m : material.laws) factor *= m->initial();
    if (factor < 1)
        for (double* w : {&screen.x, &screen.y, &screen.n, &screen.z}) *w /= factor * factor;
    return screen;
}

}  // namespace

PotentialLaw::PotentialLaw(const YieldSurface& screen, const Vec4& strength, SectionMaterial material,
                           bool remembers_flow, int own_variables)
    : SectionLaw(screen_with(screen, material)),
      per_strength_(strength.cwiseInverse()),
      material_(std::move(material)) {
    material_.zone.per_strength = per_strength_;
    for (const auto& m : material_.laws) {
        history_size_ += m->history_size();
        moves_surface_ |= m->moves_surface();
        back_follows_strain_ |= m->back_follows_strain();
        back_follows_flow_ |= m->back_follows_flow();
        follows_rotation_ |= m->follows_rotation();
        wears_stiffness_ |= m->wears_stiffness();
    }
    flow_at_ = remembers_flow ? history_size_ : -1;
    if (remembers_flow) history_size_ += 4;
    own_at_ = own_variables > 0 ? history_size_ : -1;
    history_size_ += own_variables;
}

std::string PotentialLaw::words() const {
    std::string text = name();
    for (const auto& m : material_.laws) text += ", " + m->words();
    return text;
}

/// The product of the factors of all material laws. `history`: null for a section that has not flowed.
MaterialLaw::Factor PotentialLaw::factor_at(const double* history, double strain, const Moment& at) const {
    MaterialLaw::Factor f;
    for (const auto& m : material_.laws) {
        const MaterialLaw::Factor own = m->factor(history, strain, at);
        f = {f.value * own.value, f.slope * own.value + f.value * own.slope};
        if (history) history += m->history_size();
    }
    return f;
}

void PotentialLaw::start(bool end_of_member, double* history) const {
    for (const auto& m : material_.laws) {
        m->start(end_of_member, history);
        history += m->history_size();
    }
}

/// The factor that follows the rotation, after a step with e that did `work` at the initial strength.
MaterialLaw::Turned PotentialLaw::turned(const double* history, const Vec4& e, double work) const {
    MaterialLaw::Turned out;
    if (!follows_rotation_) return out;
    for (const auto& m : material_.laws) {
        if (m->follows_rotation()) {
            const MaterialLaw::Turned own = m->turned(material_.zone, history, e, work);
            out = {out.factor * own.factor, out.slope * own.factor + out.factor * own.slope, out.mean * own.mean};
        }
        if (history) history += m->history_size();
    }
    return out;
}

/// D(e): all the work, without hardening.
PotentialLaw::Work PotentialLaw::work_at(const Vec4& e, const double* own) const {
    Work w;
    w.value = w.initial = potential(e, own, w.q, w.curvature);
    return w;
}

/// The mean of the factor while the mean plastic strain grows by `strain`: that of the work (`of_work`), for which the
/// rate is that of the whole step, or that of Phi.
double PotentialLaw::mean_factor(const double* history, double strain, const Moment& at, bool of_work) const {
    double mean = 1, rate = 1;
    MaterialLaw::Integrals more;
    const double* own = history;
    for (const auto& m : material_.laws) {
        if (m->follows_rate()) rate *= m->factor(own, strain, at).value, more = m->integrals(strain, at.dt);
        else mean *= m->mean_factor(own, strain, at);
        if (own) own += m->history_size();
    }
    if (of_work || more.zeroth == 0) return rate * mean;
    double start = 1, end = 1;  // beside a rate the other factors are linear in the strain
    for (const auto& m : material_.laws) {
        if (!m->follows_rate()) start *= m->factor(history, 0, at).value, end *= m->factor(history, strain, at).value;
        if (history) history += m->history_size();
    }
    return mean + (start * more.zeroth + (end - start) / strain * more.first) / strain;
}

/// Phi(D) + e.C e / 2 in the place of D.
void PotentialLaw::harden(const End& end, const Vec4& e, Work& w) const {
    if (material_.laws.empty()) return;
    const double energy = material_.zone.energy, D = w.initial, turned = end.turned.factor;
    const MaterialLaw::Factor own = factor_at(end.history, D / energy, end.moment),
                              f = {turned * own.value, turned * own.slope};
    const Vec4 Ce = end.hardens.cwiseProduct(e);
    w.curvature = f.value * w.curvature + f.slope / energy * w.q * w.q.transpose();
    w.curvature.diagonal() += end.hardens;
    w.q = f.value * w.q + Ce;
    w.value = turned * D * mean_factor(end.history, D / energy, end.moment, false) + 0.5 * e.dot(Ce);
}

Vec4 PotentialLaw::normalised_flow(const ElementFlow& flow, int section) const {
    Vec4 e = flow.section[section].cwiseQuotient(per_strength_);
    for (int c = 0; c < 4; ++c)
        if (per_strength_[c] == 0) e[c] = 0;
    return e;
}

/// What a section has flowed in the step, where its material needs that.
PotentialLaw::SoFar PotentialLaw::so_far(const ElementFlow& flow, int section, const double* history) const {
    if (material_.laws.empty() || !(flow.lambda[section] > 0)) return {};
    return {mean_strain(flow, section, history), normalised_flow(flow, section)};
}

/// Growth of the mean plastic strain of a section in the step.
double PotentialLaw::mean_strain(const ElementFlow& flow, int section, const double* history) const {
    if (material_.laws.empty() || !(flow.lambda[section] > 0)) return 0;
    Vec4 q;
    Mat4 curvature;
    return potential(normalised_flow(flow, section), own(history), q, curvature) / material_.zone.energy;
}

/// Whether the back resultants that a round went by are those of the flow that it found.
bool PotentialLaw::back_is_found(const End& end, const SectionConditions& at, int section, const SoFar& now,
                                 const Vec6& trial) const {
    End again = end;
    again.fixed = Vec4::Zero(), again.hardens = Vec4::Zero();
    again.set_history(at, section, *this, now);
    const Vec4 moved = again.hardens.cwiseProduct(now.e) - again.fixed;
    const Vec4 by_loads = end.per.cwiseProduct(resultants(at.fixed_end->at(end.at()), end.at())),
               went_by = end.hardens.cwiseProduct(now.e) - (end.fixed - by_loads);
    return (moved - went_by).norm() <= flow_tolerance * (1 + end.carries(trial).norm());
}

/// One round: with what the round before has found, which `held` has; `settled`: null, or set to whether this round has
/// found the same, and then `held` is of the next round.
ElementFlow PotentialLaw::find_round(const Vec6& trial, const Stiffness& k, const double* sections, int n,
                                     const SectionConditions& at, const ElementFlow* before, HeldRound& held,
                                     bool* settled) const {
    const double close = back_follows_flow_ ? flow_tolerance : 10 * flow_tolerance;  // of factors
    ElementFlow out;
    out.p = trial;
    End ends[2];
    for (int i = 0; i < n; ++i) {
        const HeldRound::Section& of = held.of[i];
        ends[i] = End(sections[i], per_strength_, k, at, i, *this, {of.strain, of.e});
        if (!held.first && follows_rotation_) ends[i].turned.factor = of.factor;
    }
    out.converged = find_ends(trial, k, ends, n, before);
    out.looks = ends[0].looks + ends[1].looks;
    bool same = true;
    for (int i = 0; i < n; ++i) {
        const SoFar now = add_flow(ends[i], i, out);
        if (!settled || !in_rounds()) continue;
        HeldRound::Section& of = held.of[i];
        const double elastic = (1 + ends[i].carries(trial).norm()) / (ends[i].k[2] * material_.zone.energy),
                     taken = ends[i].turned.factor,
                     found = turned(ends[i].history, now.e, now.strain * material_.zone.energy).factor;
        same = same && (!back_follows_strain_ || std::abs(now.strain - of.strain) <= 10 * flow_tolerance * elastic) &&
               (!back_follows_flow_ || back_is_found(ends[i], at, i, now, trial)) && std::abs(found - taken) <= close;
        of.factor = of.search.next(taken, found);
        of.strain = now.strain, of.e = now.e;
    }
    if (settled) *settled = same, held.first = false;
    if (out.flows()) out.p = trial - k.times(out.plastic);
    return out;
}

/// Where back resultants follow the mean plastic strain, or the strength follows the rotation, those of the round
/// before are taken, until they change no more: a round leaves about H / E of the change before.
ElementFlow PotentialLaw::find(const Vec6& trial, const Stiffness& k, const double* sections, int n,
                               const SectionConditions& at, const ElementFlow* before) const {
    HeldRound held;
    if (at.held) return held = *at.held, find_round(trial, k, sections, n, at, before, held, nullptr);
    ElementFlow last;
    for (int round = 0; round < most_rounds; ++round) {
        bool settled = false;
        ElementFlow out = find_round(trial, k, sections, n, at, round == 0 ? before : &last, held, &settled);
        out.looks += last.looks;
        if (!out.converged || settled) return out;
        last = out;
    }
    last.converged = false;
    return last;
}

bool PotentialLaw::next_round(const ElementFlow& flow, const SectionConditions& at, double tolerance,
                              HeldRound& held) const {
    const auto differ = [&](double a, double b) { return !(std::abs(a - b) <= tolerance * std::abs(a)); };
    bool same = true;
    for (int i : {0, 1}) {
        HeldRound::Section& of = held.of[i];
        const double* history = at.history_of(i, history_size_);
        const SoFar now = so_far(flow, i, history);
        const double energy = material_.zone.energy, found = turned(history, now.e, now.strain * energy).factor,
                     taken = held.first ? turned(history, Vec4::Zero(), 0).factor : of.factor;
        if (differ(found, taken) || (back_follows_strain_ && differ(now.strain, of.strain)) ||
            (back_follows_flow_ && !((now.e - of.e).norm() <= tolerance * now.e.norm())))
            same = false;
        of.factor = of.search.next(taken, found);
        of.strain = now.strain, of.e = now.e;
    }
    held.first = false;
    return same;
}

/// Adds what an end has flowed to the flow of its element.
PotentialLaw::SoFar PotentialLaw::add_flow(const End& end, int section, ElementFlow& out) const {
    if (!end.flows()) return {};
    Work w = end.e == end.known_at ? end.known : work_at(end.e, end.own);
    harden(end, end.e, w);
    out.plastic += end.plastic();
    out.lambda[section] = 0.5 * w.initial;
    out.section[section] = per_strength_.cwiseProduct(end.e);
    if (end.own) out.path_work += more_on_the_way(end.e, end.own, w.initial);
    if (material_.laws.empty()) return {0, end.e};
    const double D = w.initial, strain = D / material_.zone.energy, beyond = w.value - w.q.dot(end.e);
    out.potential += beyond;
    out.path_work +=
        beyond + D * (turned(end.history, end.e, D).mean * mean_factor(end.history, strain, end.moment, true) -
                      end.turned.factor * mean_factor(end.history, strain, end.moment, false));
    if (back_follows_strain_) out.path_work += more_by_back(end.history, strain, end.e);
    return {strain, end.e};
}

double PotentialLaw::more_by_back(const double* history, double strain, const Vec4& e) const {
    double work = 0;
    for (const auto& m : material_.laws) {
        work += m->more_by_back(material_.zone, history, strain, e);
        if (history) history += m->history_size();
    }
    return work;
}

ElementFlow PotentialLaw::return_alone(const Vec6& trial, const Stiffness& k, const SectionConditions& at,
                                       const ElementFlow& before) const {
    constexpr double ends[2] = {-1, 1};
    return find(trial, k, ends, 2, at, &before);
}

ReturnMapResult PotentialLaw::return_to_surface(const Vec6& trial, const Stiffness& k, const double* sections, int n,
                                                const SectionConditions& at) const {
    ReturnMapResult out;
    static_cast<ElementFlow&>(out) = find(trial, k, sections, n, at, nullptr);
    out.dissipation = out.p.dot(out.plastic) + work_of(*at.fixed_end, out, sections, n, at) + out.path_work;
    return out;
}

double PotentialLaw::work_of(const FixedEnd& part, const ElementFlow& flow, const double* sections, int n,
                             const SectionConditions&) const {
    double work = 0;
    for (int i = 0; i < n; ++i)
        if (flow.lambda[i] > 0) work += resultants(part.at(sections[i]), sections[i]).dot(flow.section[i]);
    return work;
}

void PotentialLaw::commit(const ElementFlow& flow, int section, double dt, double* history) const {
    if (!(flow.lambda[section] > 0)) {  // the other end alone flows
        if (flow_at_ >= 0) std::fill_n(history + flow_at_, 4, 0.0);
        return;
    }
    const Vec4 e = normalised_flow(flow, section);
    const double strain = mean_strain(flow, section, history);
    for (const auto& m : material_.laws) {
        m->commit(material_.zone, e, strain, dt, history);
        history += m->history_size();
    }
    if (flow_at_ >= 0) std::copy_n(e.data(), 4, history);
}

double PotentialLaw::stored(const double* history) const {
    double sum = 0;
    for (const auto& m : material_.laws) {
        sum += m->stored(material_.zone, history);
        history += m->history_size();
    }
    return sum;
}

double PotentialLaw::softness(const double* history, const ElementFlow* flow, int section) const {
    double sum = 0;
    const Vec4 e = flow && flow->lambda[section] > 0 ? normalised_flow(*flow, section) : Vec4(Vec4::Zero());
    for (const auto& m : material_.laws) {
        sum += m->softness(material_.zone, history, e);
        history += m->history_size();
    }
    return sum;
}

/// Normalised resultants against a yield surface that neither moves nor grows.
Vec4 PotentialLaw::relative(const Vec4& q, const double* history, const Moment& at) const {
    Vec4 of = q.cwiseProduct(per_strength_);
    if (material_.laws.empty()) return of;
    Vec4 back = Vec4::Zero(), hardens = Vec4::Zero();
    const double* own = history;
    for (const auto& m : material_.laws) {
        m->add_back(material_.zone, own, 0, Vec4::Zero(), back, hardens);
        if (own) own += m->history_size();
    }
    return (of - back) / (factor_at(history, 0, at).value * turned(history, Vec4::Zero(), 0).factor);
}

double PotentialLaw::yield_function(const Vec4& q, const double* history, double temperature) const {
    return shape_function(relative(q, history, {0, temperature}), own(history));
}

bool PotentialLaw::surely_elastic(const Vec6& p, const double* sections, int n, const SectionConditions& at) const {
    for (int i = 0; i < n; ++i) {
        const Vec4 q = resultants(p + at.fixed_end->at(sections[i]), sections[i]);
        const double* history = at.history_of(i, history_size_);
        if (!surely_inside(relative(q, history, {at.dt, at.temperature}), own(history))) return false;
    }
    return true;
}

}  // namespace hinge::beam
