#include "beam/pair_return.h"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace hinge::beam {
namespace {

constexpr double ends[2] = {-1, 1};
/// p up to which U counts as convex: S is 0.03 there, and 0 at 3.5.
constexpr double convex_up_to = 3.3;
constexpr int most_pair_rounds = 12;  ///< of the convex case; they end after three to five
constexpr double slow = 0.5;          ///< a round that leaves more than this of the change before it is not convergence
constexpr int most_descents = 400;    ///< of the case that is not convex
/// Rounds of a law whose strength follows its flow, each a descent; after so many a coarser tolerance will do.
constexpr int most_held = 60, many_held = 20;
constexpr double coarse_round = 1e-6;
/// Evaluations of the surface and rounds of a return in all, some 15 ms: beyond that it counts as not found, and the
/// step is halved or ends by name. Those that are found take 1 to 8,000.
constexpr int most_work = 20000;
/// Where F has fallen by less than this part of U(trial) in so many rounds, and a round changes little, its floor is
/// flat: flow that moves from one element to the other, or round a section alike in both planes, is worth no energy.
constexpr double flat_fall = 1e-5, flat_change = 1e-3;
constexpr int flat_rounds = 30;

/// The larger of p' in the two planes at axial force N.
double pressed(const PairKind<double>& k, double N) { return std::max(pressed_pair(k, 0, -N), pressed_pair(k, 1, -N)); }

/// A pair whose return is looked for.
class PairReturn : public PairElastic {
public:
    PairReturn(const ElasticPair& pair, const Vec6 (&d)[2], const SectionLaw& law, const SectionConditions* conditions,
               double tolerance)
        : pair_(pair),
          k_(pair.kind),
          of_(pair.of),
          d_(d),
          law_(law),
          conditions_{conditions[0], conditions[1]},
          tolerance_(tolerance) {}

    bool find(ReturnMapResult (&flow)[2]) {
        At now = at(no_flow_, no_flow_);
        const double trial = pressed(k_, now.N);
        bool converged = false, convex = trial <= convex_up_to;
        At end = now;
        if (convex) {
            converged = go_rounds(end);
            convex = pressed(k_, end.N) <= convex_up_to;
        }
        double snapped = 0;
        if (!convex || !converged) {
            end = now;
            converged = descend_in_rounds(end);
            snapped = lost_by_snap(now, end);
        }
        for (int i : {0, 1}) {
            ReturnMapResult& f = flow[i];
            f.p = end.p[i], f.plastic = end.of[i].plastic, f.elastic = d_[i] - f.plastic;
            for (int j : {0, 1}) f.section[j] = end.of[i].section[j];
            f.converged = converged;
            for (int j : {0, 1}) f.lambda[j] = end.of[i].lambda[j];
            f.path_work = end.of[i].path_work;
            f.dissipation = f.p.dot(f.plastic) + fixed_work(i, end.of[i]) + f.path_work;
        }
        const int flows = flow[0].flows() ? 0 : 1;
        if (flow[flows].flows()) flow[flows].dissipation += snapped;
        return converged;
    }

    void at(const Vec6 (&plastic)[2], Vec6 (&p)[2], Mat12& K) const override {
        const ElasticPair::At& there = elastic_at(plastic[0], plastic[1]);
        K = pair_.stiffness_beyond(there);
        for (int i : {0, 1}) {
            p[i] = of_[i].times(d_[i] - plastic[i]) + there.beyond.segment<6>(6 * i);
            K.block<6, 6>(6 * i, 6 * i) += of_[i].matrix();
        }
    }

private:
    struct At {
        ElementFlow of[2];
        Vec6 p[2];  ///< dU/dd at d - plastic
        double N;
    };

    At at(const ElementFlow& one, const ElementFlow& two) const {
        const ElasticPair::At& there = elastic_at(one.plastic, two.plastic);
        At a{{one, two}, {}, there.N};
        for (int i : {0, 1}) a.p[i] = of_[i].times(d_[i] - a.of[i].plastic) + there.beyond.segment<6>(6 * i);
        return a;
    }
    /// The elastic side beside these plastic deformations; the last one is kept.
    const ElasticPair::At& elastic_at(const Vec6& one, const Vec6& two) const {
        if (!known_ || known_at_[0] != one || known_at_[1] != two) {
            known_ = pair_.at(d_[0] - one, d_[1] - two);
            known_at_[0] = one, known_at_[1] = two;
        }
        return *known_;
    }
    double energy(const At& a) const {
        const Vec6 elastic[2] = {d_[0] - a.of[0].plastic, d_[1] - a.of[1].plastic};
        return pair_.energy_beyond(elastic[0], elastic[1]) + 0.5 * elastic[0].dot(of_[0].times(elastic[0])) +
               0.5 * elastic[1].dot(of_[1].times(elastic[1]));
    }
    /// D(x), less what the fixed-end parts do.
    static double dissipation(const At& a) {
        return a.of[0].p.dot(a.of[0].plastic) + a.of[1].p.dot(a.of[1].plastic) + a.of[0].potential + a.of[1].potential;
    }
    static double work(const At& a) { return a.p[0].dot(a.of[0].plastic) + a.p[1].dot(a.of[1].plastic); }
    /// What U loses beyond the work of the flow, J: 0 where the forces fall to the surface along a straight line, as
    /// they do in short steps. There the steps' own rule counts that work rightly.
    double lost_by_snap(const At& trial, const At& end) const {
        constexpr double straight = 0.25;
        const double lost = energy(trial) - energy(end) - work(end);
        double by_line = 0;
        for (int i : {0, 1}) by_line += 0.5 * (trial.p[i] - end.p[i]).dot(end.of[i].plastic);
        return lost > by_line + straight * std::abs(by_line) ? lost : 0;
    }
    double fixed_work(int i, const ElementFlow& h) const {
        return h.flows() ? law_.work_of(*conditions_[i].fixed_end, h, ends, 2, conditions_[i]) : 0;
    }

    /// What a pair's element has of the pair's bending stiffness, without its partner's part in it.
    void own_stiffness(double N, Stiffness (&out)[2]) const {
        for (int i : {0, 1}) out[i] = of_[i];
        for (int plane : {0, 1}) {
            const StabilityFunctions<double> at = stability_functions(k_, plane, N);
            const double more = k_.b[plane] * (std::max(0.1, 0.5 * (at.S + at.A)) - 1);
            for (int i : {0, 1}) add_bending(out[i], plane, more);
        }
        for (int i : {0, 1}) out[i] = in_series(out[i], pair_.springs[i]);
    }
    static void add_bending(Stiffness& k, int plane, double more) {
        (plane == 0 ? k.x11 : k.y11) += more;
        (plane == 0 ? k.x12 : k.y12) -= more;
        (plane == 0 ? k.x22 : k.y22) += more;
    }

    /// The size of a change of both plastic deformations against the elastic ones, in the energy norm of `k`.
    double size(const At& a, const At& b, const Stiffness (&k)[2]) const {
        double change = 0, whole = 0;
        for (int i : {0, 1}) {
            const Vec6 off = b.of[i].plastic - a.of[i].plastic, elastic = d_[i] - b.of[i].plastic;
            change += off.dot(k[i].times(off));
            whole += elastic.dot(k[i].times(elastic));
        }
        return std::sqrt(change / whole);
    }

    At round(const At& from, const Stiffness (&k)[2]) const {
        ElementFlow next[2];
        if (work_ > most_work) return next[0].converged = next[1].converged = false, at(next[0], next[1]);
        for (int i : {0, 1})
            next[i] = law_.return_alone(from.p[i] + k[i].times(from.of[i].plastic), k[i], conditions_[i], from.of[i]);
        work_ += 1 + next[0].evaluations + next[1].evaluations;
        return at(next[0], next[1]);
    }

    /// The convex case. False: it has not converged.
    bool go_rounds(At& now) const {
        Stiffness k[2];
        own_stiffness(now.N, k);
        double last = std::numeric_limits<double>::infinity();
        if (law_.return_together(*this, conditions_, tolerance_, now.of)) return now = at(now.of[0], now.of[1]), true;
        for (int i = 0; i < most_pair_rounds; ++i) {
            const At next = round(now, k);
            const double change = size(now, next, k);
            now = next;
            if (!now.of[0].converged || !now.of[1].converged) return false;
            if (change <= tolerance_) return true;
            if (i == 0 && law_.return_together(*this, conditions_, tolerance_, now.of))
                return now = at(now.of[0], now.of[1]), true;
            if (i > 0 && !(change < slow * last)) return false;
            last = change;
        }
        return false;
    }

    /// Stiffnesses of the two elements that no change of the pair's deformation exceeds by much: what couples N with
    /// the bending of both (N = EA/l (e + bow)) is shared out between them. `firmer`: 1, and more where that is not
    /// enough. Springs are in series with both.
    void stiffness_above(const At& a, double firmer, Stiffness (&out)[2]) const {
        double bow[2][2], together = 0, least = std::numeric_limits<double>::infinity(), flexible = 1, most[2];
        Vec6 own[2] = {d_[0] - a.of[0].plastic, d_[1] - a.of[1].plastic};
        pair_.take_off_springs(own[0], own[1]);
        const PairShapeNumbers y = shape_of(own[0], own[1]);
        for (int plane : {0, 1}) {
            const StabilityFunctions<double> at = stability_functions(k_, plane, a.N);
            const double sum = at.S1 * y.sum[plane], difference = at.A1 * y.difference[plane];
            bow[plane][0] = 0.25 * k_.length * std::abs(sum + difference);  // d(bow)/d(kappa)
            bow[plane][1] = 0.25 * k_.length * std::abs(sum - difference);
            together += bow[plane][0] + bow[plane][1];
            flexible -= 0.125 * k_.axial * k_.length * k_.c[plane] *
                        (at.S2 * y.sum[plane] * y.sum[plane] + at.A2 * y.difference[plane] * y.difference[plane]);
            most[plane] = std::max(0.1, std::max(at.S, at.A));
            least = std::min(least, k_.b[plane] * most[plane]);
        }
        const double axial = 2 * k_.axial / flexible, share = std::min(1.0, std::sqrt(axial / least) * together);
        for (int i : {0, 1}) {
            out[i] = of_[i];
            out[i].axial *= firmer * (1 + share);
            for (int plane : {0, 1}) {
                const double coupled = share > 0 ? axial * (1 + 1 / share) * bow[plane][i] * together : 0;
                add_bending(out[i], plane, k_.b[plane] * (firmer * most[plane] - 1) + firmer * coupled);
            }
            out[i] = in_series(out[i], (1 / firmer) * pair_.springs[i]);
        }
    }

    /// The case that is not convex, of any law. Where the strength follows the flow, F is a function of the flow only
    /// while that strength is held: so each descent holds it, and the next one takes what the flow has made of it.
    bool descend_in_rounds(At& now) {
        if (!law_.in_rounds()) return descend(now);
        HeldRound held[2];
        for (int i : {0, 1}) conditions_[i].held = &held[i];
        bool settled = false;
        for (int round = 0; round < most_held && !settled; ++round) {
            if (!descend(now, round > 0)) break;
            settled = true;
            for (int i : {0, 1}) {
                const double within = round < many_held ? tolerance_ : std::max(tolerance_, coarse_round);
                if (!law_.next_round(now.of[i], conditions_[i], within, held[i])) settled = false;
            }
        }
        for (int i : {0, 1}) conditions_[i].held = nullptr;
        return settled;
    }

    /// The case that is not convex: F falls from step to step. False: it has not converged. `again`: from a flow that
    /// was found with another strength, so that F is not known there.
    bool descend(At& now, bool again = false) const {
        const double U = energy(now), scale = std::max(std::abs(U), std::numeric_limits<double>::min());
        double F = again ? std::numeric_limits<double>::infinity() : U, firmer = 1, stretch = 1, fell = 0, marked = F,
               changed = 0;
        for (int i = 0; i < most_descents; ++i) {
            if (i > 0 && i % flat_rounds == 0) {
                if (marked - F <= flat_fall * scale && changed <= flat_change) return true;
                marked = F;
            }
            Stiffness k[2];
            At next;
            double change = 0, there = 0;
            for (;; firmer *= 2) {
                if (firmer > 1e12) return i > 0 && fell <= flat_fall * scale;  // rounding hides what F still falls by
                stiffness_above(now, firmer, k);
                next = round(now, k);
                if (!next.of[0].converged || !next.of[1].converged) return false;
                change = size(now, next, k);
                there = energy(next) + dissipation(next);
                if (there <= F + 1e-13 * scale) break;
            }
            if (firmer * change <= tolerance_) return now = next, true;
            if (i > 2 && i % 3 == 0) {
                const At jump = newton(now, next, k);
                const double F_jump = energy(jump) + dissipation(jump);
                if (F_jump <= there) next = jump, there = F_jump;
            }
            if (i > 2 && i % 3 == 1) {
                const At jump = farther(now, next, stretch, k);
                const double F_jump = energy(jump) + dissipation(jump);
                stretch = F_jump < there ? 4 * stretch : std::max(1.0, 0.25 * stretch);
                if (F_jump < there) next = jump, there = F_jump;
            }
            fell = F - there, changed = firmer * change;
            now = next, F = there;
            firmer = std::max(1.0, 0.7 * firmer);
        }
        return false;
    }

    /// A round from farther on in the direction of the last one: where U is nearly flat, as where flow moves from one
    /// element to the other, rounds creep.
    At farther(const At& now, const At& next, double times, const Stiffness (&k)[2]) const {
        At from = next;
        for (int i : {0, 1}) from.of[i].plastic += times * (next.of[i].plastic - now.of[i].plastic);
        return round(at(from.of[0], from.of[1]), k);
    }

    /// Newton's method for x = round(x), and a round from where it leads.
    At newton(const At& now, const At& next, const Stiffness (&k)[2]) const {
        // d(next)/d(now) = k^-1 (1 - D k^-1) (k - H);  H: stiffness of the pair, D: tangents of the elements by
        // themselves
        PairMatrix H = pair_.stiffness_beyond(d_[0] - now.of[0].plastic, d_[1] - now.of[1].plastic);
        for (int i : {0, 1}) H.block<6, 6>(6 * i, 6 * i) += of_[i].matrix() - k[i].matrix();
        PairMatrix J = PairMatrix::Identity();
        Vec12 off;
        for (int i : {0, 1}) {
            off.segment<6>(6 * i) = next.of[i].plastic - now.of[i].plastic;
            if (!next.of[i].flows()) continue;
            const Mat6 F = k[i].flexibility(), D = law_.tangent(next.of[i], k[i], ends, 2, conditions_[i]);
            J.block<6, 12>(6 * i, 0) += (F - F * D * F) * H.block<6, 12>(6 * i, 0);
        }
        const Vec12 step = J.partialPivLu().solve(off);
        At from = now;
        if (step.allFinite())
            for (int i : {0, 1}) from.of[i].plastic += step.segment<6>(6 * i);
        return round(at(from.of[0], from.of[1]), k);
    }

    const ElasticPair& pair_;
    const PairKind<double>& k_;
    const Stiffness (&of_)[2];
    const Vec6 (&d_)[2];
    const SectionLaw& law_;
    SectionConditions conditions_[2];
    mutable std::optional<ElasticPair::At> known_;  ///< elastic_at of these
    mutable Vec6 known_at_[2];
    mutable int work_ = 0;  ///< evaluations and rounds so far
    double tolerance_;
    inline static const ElementFlow no_flow_{};
};

}  // namespace

bool return_to_surface(const ElasticPair& pair, const Vec6 (&d)[2], const SectionLaw& law, ReturnMapResult (&flow)[2],
                       double tolerance, const SectionConditions* at) {
    return PairReturn(pair, d, law, at, tolerance).find(flow);
}

PairMatrix pair_tangent(const ElasticPair& pair, const Vec6 (&elastic)[2], const SectionLaw& law,
                        const ElementFlow* const (&flow)[2], const SectionConditions* at) {
    PairMatrix H = pair.stiffness_beyond(elastic[0], elastic[1]);
    for (int i : {0, 1}) H.block<6, 6>(6 * i, 6 * i) += pair.of[i].matrix();
    if (!flow[0] && !flow[1]) return H;
    return law.pair_tangent(H, flow, at);
}

}  // namespace hinge::beam
