#include "beam/potential_law.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace hinge::beam {
namespace {

constexpr double enough = 1e-12;       ///< of the trial forces: what a section's equilibrium may be off
constexpr double still_enough = 1e-9;  ///< where rounding leaves no more
constexpr double g_rounds = 1e-4;      ///< of the trial forces missed: there the fall of G is near its rounding
constexpr double falls = 0.95;         ///< then what is missed must fall to this part
constexpr int most_steps = 100, most_sweeps = 200, most_rounds = 200;
constexpr double leaves = 0.05;  ///< of its flow at first: an end whose flow shrinks to that may not flow
constexpr int quick_steps = 10, quick_tries = 3;  ///< of both ends together, before each is looked for in turn
constexpr double least_damping = 1e-13;           ///< of the elastic stiffness: N may flow at either end
constexpr double at_the_start = 1e-9;  ///< lambda over that of the flow found: a flow that begins (flowing_on)
constexpr double stiff = 1e6;          ///< over the elastic stiffness: the second derivatives of D where flow begins

using Rows = Eigen::Matrix<double, 4, 6>;

using Mat8 = Eigen::Matrix<double, 8, 8>;
using Vec8 = Eigen::Matrix<double, 8, 1>;

/// x of A x = b, by A = L D L^T without a choice of pivots, in place. False: A is not positive definite.
bool solve_positive(Mat8& A, Vec8& b) {
    for (int j = 0; j < 8; ++j) {
        if (!(A(j, j) > 0)) return false;
        const double inverse = 1 / A(j, j);
        for (int i = j + 1; i < 8; ++i) {
            const double l = A(i, j) * inverse;
            for (int k = i; k < 8; ++k) A(k, i) -= l * A(k, j);
            b[i] -= l * b[j];
        }
    }
    for (int j = 7; j >= 0; --j) {
        double sum = b[j];
        for (int i = j + 1; i < 8; ++i) sum -= A(i, j) * b[i];
        b[j] = sum / A(j, j);
    }
    return true;
}

/// The screen of a section whose material weakens it before any flow.
YieldSurface screen_with(YieldSurface screen, const SectionMaterial& material) {
    double factor = 1;
    for (const auto& m : material.laws) factor *= m->initial();
    if (factor < 1)
        for (double* w : {&screen.x, &screen.y, &screen.n, &screen.z}) *w /= factor * factor;
    return screen;
}

}  // namespace

/// What a section has flowed in the step.
struct PotentialLaw::SoFar {
    double strain = 0;  ///< growth of its mean plastic strain
    Vec4 e = Vec4::Zero();
};

/// The factor that follows the rotation, from round to round. A round that takes the factor s leads to a rotation whose
/// factor is F(s). A falling strength: F(s) rises, and the next round takes F(s); so s comes down to the first s that
/// is F(s). A rising one: F(s) falls, and s may jump to and fro; then it is looked for between the two.
class PotentialLaw::FactorSearch {
public:
    double next(double s, double F) {
        const double off = F - s, ratio = rounds_ > 0 && last_off_ != 0 ? off / last_off_ : 0;
        (off > 0 ? low_ : high_) = s;
        double out = F;
        if (low_ < high_ && std::isfinite(low_) && std::isfinite(high_)) {
            if (rounds_ > 0 && off != last_off_) out = s - off * (s - last_) / (off - last_off_);
            if (!(out > low_ && out < high_)) out = 0.5 * (low_ + high_);
        } else if (rounds_ > 6 && rounds_ % 4 == 0 && ratio > 0 && ratio < 0.95) {
            out = s + off / (1 - ratio);  // where rounds that shrink alike come to
        }
        // the other end changes what F is
        if (++rounds_ % 12 == 0 || high_ - low_ < 1e-12) low_ = -INFINITY, high_ = INFINITY;
        last_ = s, last_off_ = off;
        return out;
    }

private:
    double low_ = -INFINITY, high_ = INFINITY, last_ = 0, last_off_ = 0;
    int rounds_ = 0;
};

/// A section that can flow, and how far it has.
struct PotentialLaw::End {
    double n1, n2;                ///< of the section's moments, from those at the element's ends
    Vec4 per;                     ///< 1 over the strength
    Vec4 fixed;                   ///< normalised fixed-end part, less the back resultants at the start
    Vec4 k;                       ///< stiffness against its own flow
    Vec4 hardens = Vec4::Zero();  ///< what e adds to the back resultants
    MaterialLaw::Turned turned;   ///< factor that follows the rotation, at the end of the round before
    const double* history = nullptr;
    double dt = 0;
    Vec4 e = Vec4::Zero();

    End() = default;
    End(double r, const Vec4& per_strength, const Stiffness& of)
        : n1(-(1 - r) / 2), n2((1 + r) / 2), per(per_strength), fixed(Vec4::Zero()) {
        k << n1 * n1 * of.x11 + 2 * n1 * n2 * of.x12 + n2 * n2 * of.x22,
            n1 * n1 * of.y11 + 2 * n1 * n2 * of.y12 + n2 * n2 * of.y22, of.axial, of.twist;
        k = k.cwiseProduct(per.cwiseProduct(per));
        for (int c = 0; c < 4; ++c)
            if (per[c] == 0) k[c] = 1;
    }
    /// `so_far`: of the round before.
    End(double r, const Vec4& per_strength, const Stiffness& of, const SectionConditions& at, int section,
        const PotentialLaw& law, const SoFar& so_far)
        : End(r, per_strength, of) {
        fixed = per.cwiseProduct(resultants(at.fixed_end->at(r), r));
        set_history(at, section, law, so_far);
    }
    void set_history(const SectionConditions& at, int section, const PotentialLaw& law, const SoFar& so_far) {
        dt = at.dt, history = at.history_of(section, law.history_size_);
        const double strain = so_far.strain;
        turned = law.turned(history, so_far.e, strain * law.material_.zone.energy);
        Vec4 back = Vec4::Zero();
        const double* own = history;
        for (const auto& m : law.material_.laws) {
            m->add_back(law.material_.zone, own, strain, back, hardens);
            if (own) own += m->history_size();
        }
        fixed -= back;
    }
    bool flows() const { return !e.isZero(0); }
    /// Normalised resultants, with the fixed-end part and less the back resultants at the start, of the element forces.
    Vec4 carries(const Vec6& p) const {
        return per.cwiseProduct(Vec4(n1 * p[0] + n2 * p[1], n1 * p[2] + n2 * p[3], p[4], p[5])) + fixed;
    }
    Vec6 plastic() const {
        const Vec4 s = per.cwiseProduct(e);
        return (Vec6() << n1 * s[0], n2 * s[0], n1 * s[1], n2 * s[1], s[2], s[3]).finished();
    }
    Rows rows() const {
        Rows B = Rows::Zero();
        B(0, 0) = n1 * per[0], B(0, 1) = n2 * per[0], B(1, 2) = n1 * per[1], B(1, 3) = n2 * per[1];
        B(2, 4) = per[2], B(3, 5) = per[3];
        return B;
    }
};

/// Work of a plastic deformation e and its derivatives: D alone, or with what hardening and rate make of it.
struct PotentialLaw::Work {
    double value = 0, initial = 0;  ///< J; initial: D(e)
    Vec4 q = Vec4::Zero();
    Mat4 curvature = Mat4::Zero();
    void scale(double t) { value *= t, initial *= t, curvature /= t; }
};

PotentialLaw::PotentialLaw(const YieldSurface& screen, const Vec4& strength, SectionMaterial material,
                           bool remembers_flow)
    : SectionLaw(screen_with(screen, material)),
      per_strength_(strength.cwiseInverse()),
      material_(std::move(material)) {
    material_.zone.per_strength = per_strength_;
    for (const auto& m : material_.laws) {
        history_size_ += m->history_size();
        moves_surface_ |= m->moves_surface();
        back_follows_strain_ |= m->back_follows_strain();
        follows_rotation_ |= m->follows_rotation();
    }
    flow_at_ = remembers_flow ? history_size_ : -1;
    if (remembers_flow) history_size_ += 4;
}

std::string PotentialLaw::words() const {
    std::string text = name();
    for (const auto& m : material_.laws) text += ", " + m->words();
    return text;
}

/// The product of the factors of all material laws. `history`: null for a section that has not flowed.
MaterialLaw::Factor PotentialLaw::factor_at(const double* history, double strain, double dt) const {
    MaterialLaw::Factor f;
    for (const auto& m : material_.laws) {
        const MaterialLaw::Factor own = m->factor(history, strain, dt);
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
PotentialLaw::Work PotentialLaw::work_at(const Vec4& e) const {
    Work w;
    w.value = w.initial = potential(e, w.q, w.curvature);
    return w;
}

/// The mean of the factor while the mean plastic strain grows by `strain`: that of the work (`of_work`), for which the
/// rate is that of the whole step, or that of Phi.
double PotentialLaw::mean_factor(const double* history, double strain, double dt, bool of_work) const {
    double start = 1, end = 1, rate = 1;  // the factors of hardening are linear in the strain of a step
    MaterialLaw::Integrals more;
    for (const auto& m : material_.laws) {
        if (m->follows_rate()) {
            rate *= m->factor(history, strain, dt).value;
            more = m->integrals(strain, dt);
        } else {
            start *= m->factor(history, 0, dt).value, end *= m->factor(history, strain, dt).value;
        }
        if (history) history += m->history_size();
    }
    const double mean = 0.5 * (start + end);
    if (of_work || !(strain > 0)) return rate * mean;
    return mean + (start * more.zeroth + (end - start) / strain * more.first) / strain;
}

/// Phi(D) + e.C e / 2 in the place of D.
void PotentialLaw::harden(const End& end, const Vec4& e, Work& w) const {
    if (material_.laws.empty()) return;
    const double energy = material_.zone.energy, D = w.initial, turned = end.turned.factor;
    const MaterialLaw::Factor own = factor_at(end.history, D / energy, end.dt),
                              f = {turned * own.value, turned * own.slope};
    const Vec4 Ce = end.hardens.cwiseProduct(e);
    w.curvature = f.value * w.curvature + f.slope / energy * w.q * w.q.transpose();
    w.curvature.diagonal() += end.hardens;
    w.q = f.value * w.q + Ce;
    w.value = turned * D * mean_factor(end.history, D / energy, end.dt, false) + 0.5 * e.dot(Ce);
}

/// The least along the ray of e: trial.e = t e.(k + C) e + (factor at t D) D. False: it is at t = 0.
bool PotentialLaw::along_ray(const End& end, const Vec4& trial, Vec4& e, Work& w) const {
    const double stiffness = e.dot((end.k + end.hardens).cwiseProduct(e)), force = trial.dot(e), D = w.initial;
    double t = (force - D) / stiffness;
    if (!material_.laws.empty()) {
        const auto left = [&](double x, double* slope = nullptr) {
            const MaterialLaw::Factor f = factor_at(end.history, x * D / material_.zone.energy, end.dt);
            if (slope) *slope = -stiffness - end.turned.factor * f.slope * D * D / material_.zone.energy;
            return force - x * stiffness - end.turned.factor * f.value * D;
        };
        if (!(left(0) > 0)) return false;
        double low = 0, high = force / stiffness;  // it is above 0 at low, and not above at high
        t = t > 0 && t < high ? t : 0.5 * high;
        for (int i = 0; i < most_steps && high - low > 1e-15 * high; ++i) {
            double slope;
            const double off = left(t, &slope);
            (off > 0 ? low : high) = t;
            const double next = t - off / slope;
            if (std::abs(off) <= 1e-14 * force) break;
            t = next > low && next < high ? next : 0.5 * (low + high);
        }
    }
    if (!(t > 0)) return false;
    e *= t, w.scale(t);
    return true;
}

/// Whether q, less the back resultants, is outside of the yield surface at the start of the step (outside).
bool PotentialLaw::beyond(const End& end, const Vec4& q, Vec4& direction) const {
    if (material_.laws.empty()) return outside(q, direction);
    return outside(q / (end.turned.factor * factor_at(end.history, 0, end.dt).value), direction);
}

/// The least of e.k e / 2 - trial.e + work(e); `e`: where the search starts, 0 if nothing is known. False: not found.
bool PotentialLaw::one_end(const End& end, const Vec4& trial, Vec4& e) const {
    if (!e.isZero(0) && descend(end, trial, e) == Search::found) return true;
    e = direction(trial);
    if (descend(end, trial, e) == Search::found) return true;
    if (!beyond(end, trial, e)) return e.setZero(), true;
    if (!e.allFinite()) return e.setZero(), false;
    const Search search = descend(end, trial, e);
    if (search == Search::not_below) e.setZero();  // on the surface, but for rounding
    if (search != Search::lost) return true;
    e = trial;
    return descend(end, trial, e) == Search::found;
}

/// Down from e. not_below: no flow along e has less than none.
PotentialLaw::Search PotentialLaw::descend(const End& end, const Vec4& trial, Vec4& e) const {
    const Vec4& k = end.k;
    Work at = work_at(e);
    if (!along_ray(end, trial, e, at)) return Search::not_below;
    harden(end, e, at);
    const double size = 1 + trial.norm();
    double G = 0.5 * e.dot(k.cwiseProduct(e)) - trial.dot(e) + at.value, damping = 0;
    for (int i = 0; i < most_steps; ++i) {
        const Vec4 off = trial - k.cwiseProduct(e) - at.q;
        const double missed = off.norm();
        if (missed <= enough * size) return Search::found;
        bool fell = false;
        for (int tries = 0; tries < 40 && !fell; ++tries) {
            Mat4 H = at.curvature;
            H.diagonal() += (1 + damping) * k;
            Vec4 next = e + H.llt().solve(off);
            if (!next.allFinite() || next.isZero(0)) break;
            Work there = work_at(next);
            along_ray(end, trial, next, there);
            harden(end, next, there);
            const double G_next = 0.5 * next.dot(k.cwiseProduct(next)) - trial.dot(next) + there.value,
                         left = (trial - k.cwiseProduct(next) - there.q).norm();
            if (G_next < G || (missed < g_rounds * size && left < falls * missed)) {
                fell = true, e = next, at = there, G = G_next;
                damping = damping < 1e-3 ? 0 : 0.1 * damping;
            } else {
                damping = damping == 0 ? 1e-2 : 8 * damping;
            }
        }
        if (!fell) return missed <= still_enough * size ? Search::found : Search::lost;
    }
    return Search::lost;
}

/// The flow of both ends together, by Newton's method.
class PotentialLaw::Together {
public:
    Together(const PotentialLaw& law, const Vec6& trial, const Stiffness& k, End (&ends)[2])
        : law_(law), trial_(trial), k_(k), ends_(ends) {
        const Mat6 stiffness = k.matrix();
        const Rows rows[2] = {ends[0].rows(), ends[1].rows()};
        for (int i : {0, 1}) {
            const Rows forces = rows[i] * stiffness;
            for (int j : {0, 1}) K_.block<4, 4>(4 * i, 4 * j) = forces * rows[j].transpose();
        }
        size_ = 1 + ends[0].carries(trial).norm() + ends[1].carries(trial).norm();
    }

    /// An end whose flow shrinks so far that it may not flow at all, where descend ended for that; else -1.
    int leaving() const { return leaving_; }
    double size() const { return size_; }
    double missed() const { return missed_; }
    /// From the flow of both ends, neither of them 0, to where G falls no more, or for so many steps. True: it is
    /// found.
    bool descend(int steps = most_steps, int most_tries = 12) {
        look();
        leaving_ = -1;
        const double first[2] = {ends_[0].e.norm(), ends_[1].e.norm()};
        double damping = least_damping;
        for (int step = 0; step < steps && !found(); ++step) {
            const Vec4 before[2] = {ends_[0].e, ends_[1].e};
            const double G = G_, missed = missed_;
            Mat8 H = K_;
            for (int i : {0, 1}) H.block<4, 4>(4 * i, 4 * i) += bend_[i];
            const Vec8 down = off_;
            bool fell = false;
            for (int tries = 0; tries < most_tries && !fell; ++tries) {
                Vec8 way;
                for (;; damping *= 30) {
                    Mat8 damped = H;
                    damped.diagonal() += damping * K_.diagonal();
                    if (way = down, solve_positive(damped, way)) break;
                    if (!(damping < 1e6)) return false;
                }
                for (int i : {0, 1}) ends_[i].e = before[i] + way.segment<4>(4 * i);
                if (way.allFinite() && ends_[0].flows() && ends_[1].flows()) {
                    look();
                    fell = G_ < G || (missed < g_rounds * size_ && missed_ < falls * missed);
                }
                damping = fell ? std::max(least_damping, 0.01 * damping) : std::max(1e-2, 8 * damping);
            }
            for (int i : {0, 1})
                if (fell && ends_[i].e.norm() < leaves * first[i]) return leaving_ = i, found();
            if (fell) continue;
            for (int i : {0, 1}) ends_[i].e = before[i];
            look();
            break;
        }
        return found();
    }

private:
    bool found() const { return missed_ <= enough * size_; }
    void look() {
        const Vec6 plastic = ends_[0].plastic() + ends_[1].plastic(), relieved = k_.times(plastic),
                   p = trial_ - relieved;
        G_ = 0.5 * plastic.dot(relieved) - trial_.dot(plastic);
        for (int i : {0, 1}) {
            Work w = law_.work_at(ends_[i].e);
            law_.harden(ends_[i], ends_[i].e, w);
            bend_[i] = w.curvature;
            G_ += w.value - ends_[i].fixed.dot(ends_[i].e);
            off_.segment<4>(4 * i) = ends_[i].carries(p) - w.q;
        }
        missed_ = off_.norm();
    }

    const PotentialLaw& law_;
    const Vec6& trial_;
    const Stiffness& k_;
    End (&ends_)[2];
    Mat8 K_;
    Vec8 off_;
    Mat4 bend_[2];
    double size_, G_ = 0, missed_ = 0;
    int leaving_ = -1;
};

/// Both ends, from what one of them does by itself and a guess of the other: together, else each in turn as well.
bool PotentialLaw::both_ends(const Vec6& trial, const Stiffness& k, End (&ends)[2]) const {
    Together both(*this, trial, k, ends);
    const Vec4 start[2] = {ends[0].e, ends[1].e};
    if (ends[0].flows() && ends[1].flows()) {
        if (both.descend(quick_steps, quick_tries)) return true;
        if (both.leaving() >= 0 && alone(trial, k, ends, 1 - both.leaving())) return true;
        for (int i : {0, 1}) ends[i].e = start[i];
    }
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
        for (int i : {1, 0}) {
            End& end = ends[i];
            if (!one_end(end, end.carries(trial - k.times(ends[1 - i].plastic())), end.e)) return false;
        }
        if (ends[0].flows() && ends[1].flows()) {
            if (both.descend()) return true;
            if (both.leaving() >= 0) {
                const Vec4 guess[2] = {ends[0].e, ends[1].e};
                if (alone(trial, k, ends, 1 - both.leaving())) return true;
                for (int i : {0, 1}) ends[i].e = guess[i];
            }
            if (sweep > 20 && both.missed() <= still_enough * both.size()) return true;
            continue;
        }
        if (!ends[0].flows() && !ends[1].flows()) return true;
        const int i = ends[0].flows() ? 0 : 1;
        const Vec6 p = trial - k.times(ends[i].plastic());
        Work w = work_at(ends[i].e);
        harden(ends[i], ends[i].e, w);
        Vec4 direction;
        if ((ends[i].carries(p) - w.q).norm() <= enough * both.size() &&
            !beyond(ends[1 - i], ends[1 - i].carries(p), direction))
            return true;
    }
    return false;
}

/// Whether end i flows alone: then with its flow.
bool PotentialLaw::alone(const Vec6& trial, const Stiffness& k, End (&ends)[2], int i) const {
    Vec4 direction;
    ends[1 - i].e.setZero();
    return one_end(ends[i], ends[i].carries(trial), ends[i].e) &&
           !beyond(ends[1 - i], ends[1 - i].carries(trial - k.times(ends[i].plastic())), direction);
}

/// Whether an end that carries q flows, from what it did before: then with a guess of its flow.
bool PotentialLaw::starts(End& end, const Vec4& q) const {
    if (end.flows() && on_ray(end, q)) return true;
    if (!beyond(end, q, end.e)) return false;
    if (!end.e.allFinite() || !on_ray(end, q)) end.e.setZero();
    return true;
}

/// Moves e along its ray to where an end that carries q comes to. False: there is no flow along it.
bool PotentialLaw::on_ray(End& end, const Vec4& q) const {
    Work w = work_at(end.e);
    return along_ray(end, q, end.e, w);
}

/// The flow of the n ends together, from that of `before`. False: not found.
bool PotentialLaw::find_ends(const Vec6& trial, const Stiffness& k, End (&ends)[2], int n,
                             const ElementFlow* before) const {
    Vec4 trials[2];
    for (int i = 0; i < n; ++i) {
        trials[i] = ends[i].carries(trial);
        if (!trials[i].allFinite()) return false;
    }
    const auto start = [&](int i) {
        if (before && before->lambda[i] > 0) ends[i].e = normalised_flow(*before, i);
        else if (flow_at_ >= 0 && ends[i].history) ends[i].e = Eigen::Map<const Vec4>(ends[i].history + flow_at_);
    };
    const int first = n == 2 && trials[1].norm() > trials[0].norm() ? 1 : 0;
    start(first);
    if (n == 2) start(1 - first);
    if (n == 2 && ends[0].flows() && ends[1].flows()) {  // as before, most likely
        const Vec4 guess[2] = {ends[0].e, ends[1].e};
        if (on_ray(ends[first], trials[first]) &&
            on_ray(ends[1 - first], ends[1 - first].carries(trial - k.times(ends[first].plastic()))) &&
            Together(*this, trial, k, ends).descend(quick_steps, quick_tries))
            return true;
        for (int i : {0, 1}) ends[i].e = guess[i];
    }
    const Vec4 guess = ends[1 - first].e;
    if (n == 2) ends[1 - first].e.setZero();
    if (!one_end(ends[first], trials[first], ends[first].e)) return false;
    if (n < 2) return true;
    End& other = ends[1 - first];
    other.e = guess;
    if (starts(other, other.carries(trial - k.times(ends[first].plastic())))) return both_ends(trial, k, ends);
    other.e.setZero();
    return true;
}

Vec4 PotentialLaw::normalised_flow(const ElementFlow& flow, int section) const {
    Vec4 e = flow.section[section].cwiseQuotient(per_strength_);
    for (int c = 0; c < 4; ++c)
        if (per_strength_[c] == 0) e[c] = 0;
    return e;
}

/// What a section has flowed in the step, where its material needs that.
PotentialLaw::SoFar PotentialLaw::so_far(const ElementFlow& flow, int section) const {
    if (material_.laws.empty() || !(flow.lambda[section] > 0)) return {};
    return {mean_strain(flow, section), normalised_flow(flow, section)};
}

/// Growth of the mean plastic strain of a section in the step.
double PotentialLaw::mean_strain(const ElementFlow& flow, int section) const {
    if (material_.laws.empty() || !(flow.lambda[section] > 0)) return 0;
    Vec4 q;
    Mat4 curvature;
    return potential(normalised_flow(flow, section), q, curvature) / material_.zone.energy;
}

/// Where back resultants follow the mean plastic strain, or the strength follows the rotation, those of the round
/// before are taken, until they change no more: a round leaves about H / E of the change before.
ElementFlow PotentialLaw::find(const Vec6& trial, const Stiffness& k, const double* sections, int n,
                               const SectionConditions& at, const ElementFlow* before) const {
    const bool rounds = back_follows_strain_ || follows_rotation_;
    SoFar so_far[2];
    FactorSearch search[2];
    double factor[2] = {0, 0};  // of the rounds after the first
    ElementFlow last;
    for (int round = 0; round < most_rounds; ++round) {
        ElementFlow out;
        out.p = trial;
        End ends[2];
        for (int i = 0; i < n; ++i) {
            ends[i] = End(sections[i], per_strength_, k, at, i, *this, so_far[i]);
            if (round > 0 && follows_rotation_) ends[i].turned.factor = factor[i];
        }
        out.converged = find_ends(trial, k, ends, n, round == 0 ? before : &last);
        bool same = true;
        for (int i = 0; i < n; ++i) {
            const SoFar now = add_flow(ends[i], i, at.dt, out);
            if (!rounds) continue;
            const double elastic = (1 + ends[i].carries(trial).norm()) / (ends[i].k[2] * material_.zone.energy),
                         taken = ends[i].turned.factor,
                         found = turned(ends[i].history, now.e, now.strain * material_.zone.energy).factor;
            same = same &&
                   (!back_follows_strain_ || std::abs(now.strain - so_far[i].strain) <= 10 * enough * elastic) &&
                   std::abs(found - taken) <= 10 * enough;
            factor[i] = search[i].next(taken, found);
            so_far[i] = now;
        }
        if (out.flows()) out.p = trial - k.times(out.plastic);
        if (!out.converged || same) return out;
        last = out;
    }
    last.converged = false;
    return last;
}

/// Adds what an end has flowed to the flow of its element.
PotentialLaw::SoFar PotentialLaw::add_flow(const End& end, int section, double dt, ElementFlow& out) const {
    if (!end.flows()) return {};
    Work w = work_at(end.e);
    harden(end, end.e, w);
    out.plastic += end.plastic();
    out.lambda[section] = 0.5 * w.initial;
    out.section[section] = per_strength_.cwiseProduct(end.e);
    if (material_.laws.empty()) return {0, end.e};
    const double D = w.initial, strain = D / material_.zone.energy, beyond = w.value - w.q.dot(end.e);
    out.potential += beyond;
    out.path_work += beyond + D * (turned(end.history, end.e, D).mean * mean_factor(end.history, strain, dt, true) -
                                   end.turned.factor * mean_factor(end.history, strain, dt, false));
    return {strain, end.e};
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
    const double strain = mean_strain(flow, section);
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

/// Normalised resultants against a yield surface that neither moves nor grows.
Vec4 PotentialLaw::relative(const Vec4& q, const double* history, double dt) const {
    Vec4 of = q.cwiseProduct(per_strength_);
    if (material_.laws.empty()) return of;
    Vec4 back = Vec4::Zero(), hardens = Vec4::Zero();
    const double* own = history;
    for (const auto& m : material_.laws) {
        m->add_back(material_.zone, own, 0, back, hardens);
        if (own) own += m->history_size();
    }
    return (of - back) / (factor_at(history, 0, dt).value * turned(history, Vec4::Zero(), 0).factor);
}

double PotentialLaw::yield_function(const Vec4& q, const double* history) const {
    return shape_function(relative(q, history, 0));
}

bool PotentialLaw::surely_elastic(const Vec6& p, const double* sections, int n, const SectionConditions& at) const {
    for (int i = 0; i < n; ++i) {
        const Vec4 q = resultants(p + at.fixed_end->at(sections[i]), sections[i]);
        if (!surely_inside(relative(q, at.history_of(i, history_size_), at.dt))) return false;
    }
    return true;
}

/// The second derivatives of the work at the flow of a section, an end without its e. False: it does not flow.
bool PotentialLaw::curvature_of(const ElementFlow& flow, int section, const End& end, Mat4& out) const {
    if (!(flow.lambda[section] > 0)) return false;
    const Vec4 e = normalised_flow(flow, section);
    Work w = work_at(e);
    const double largest = w.curvature.cwiseAbs().maxCoeff();
    if (flow.lambda[section] < at_the_start * 0.5 * w.initial && largest > 0)
        w.curvature *= std::max(1.0, stiff * end.k.maxCoeff() / largest);
    const Vec4 surface = w.q;
    const double slope = end.turned.slope * factor_at(end.history, w.initial / material_.zone.energy, end.dt).value;
    harden(end, e, w);
    out = w.curvature;
    if (follows_rotation_) out += slope * surface * surface.transpose();
    return true;
}

namespace {

/// K - K B^T (B K B^T + D'')^-1 B K: the tangent where the n sections of B flow. Where N may flow at either of two
/// ends, the matrix in the middle is singular, and what is left of it is damped.
template <int n, int size>
Eigen::Matrix<double, size, size> reduced(const Eigen::Matrix<double, size, size>& K,
                                          const Eigen::Matrix<double, 16, size>& rows, const Mat4 (&bend)[4]) {
    constexpr int height = 4 * n;
    const Eigen::Matrix<double, height, size> BK = rows.template topRows<height>() * K;
    Eigen::Matrix<double, height, height> H = BK * rows.template topRows<height>().transpose();
    for (int i = 0; i < n; ++i) H.template block<4, 4>(4 * i, 4 * i) += bend[i];
    for (int i = 0; i < height; ++i) {
        if (H(i, i) == 0) H(i, i) = 1;  // of infinite strength
        else H(i, i) *= 1 + least_damping;
    }
    return K - BK.transpose() * H.ldlt().solve(BK);
}

template <int size>
Eigen::Matrix<double, size, size> reduced(int n, const Eigen::Matrix<double, size, size>& K,
                                          const Eigen::Matrix<double, 16, size>& rows, const Mat4 (&bend)[4]) {
    switch (n) {
        case 0: return K;
        case 1: return reduced<1>(K, rows, bend);
        case 2: return reduced<2>(K, rows, bend);
        case 3: return reduced<3>(K, rows, bend);
        default: return reduced<4>(K, rows, bend);
    }
}

}  // namespace

Mat6 PotentialLaw::tangent(const ElementFlow& flow, const Stiffness& k, const double* sections, int n,
                           const SectionConditions& at) const {
    const Mat6 K = k.matrix();
    Eigen::Matrix<double, 16, 6> B;
    Mat4 bend[4];
    int count = 0;
    for (int i = 0; i < n; ++i) {
        End end(sections[i], per_strength_, k);
        end.set_history(at, i, *this, so_far(flow, i));
        if (!curvature_of(flow, i, end, bend[count])) continue;
        B.middleRows<4>(4 * count++) = end.rows();
    }
    return reduced<6>(count, K, B, bend);
}

Mat12 PotentialLaw::pair_tangent(const Mat12& elastic, const ElementFlow* const (&flow)[2],
                                 const SectionConditions* at) const {
    Eigen::Matrix<double, 16, 12> B;
    Mat4 bend[4];
    int count = 0;
    for (int i : {0, 1})
        for (int s = 0; flow[i] && s < 2; ++s) {
            End end(s == 0 ? -1 : 1, per_strength_, {});
            const Rows own = end.rows();
            const Mat6 K = elastic.block<6, 6>(6 * i, 6 * i);
            end.k = (own * K * own.transpose()).diagonal();
            end.set_history(at[i], s, *this, so_far(*flow[i], s));
            if (!curvature_of(*flow[i], s, end, bend[count])) continue;
            B.middleRows<4>(4 * count).setZero();
            B.block<4, 6>(4 * count++, 6 * i) = own;
        }
    return reduced<12>(count, elastic, B, bend);
}

}  // namespace hinge::beam
