// Down the convex function G of flow_problem.h, by Newton's method.
#include "section/flow_search.h"

#include <algorithm>
#include <cmath>

#include "core/positive.h"

namespace hinge::beam {
namespace {

constexpr double still_enough = 1e-9;  ///< of the trial forces: what may be missed where rounding leaves no more
/// And where no search comes nearer: beside the corner at N alone the surface bends so much, and under a rate law the
/// flow is so small, that G rounds away what its fall would be.
constexpr double last_resort = 1e-6;
constexpr double g_rounds = 1e-4;  ///< of the trial forces missed: there the fall of G is near its rounding
constexpr double falls = 0.95;     ///< then what is missed must fall to this part
/// A step from so few of the strength missed, after one that left so small a part of what it began with, and that
/// changes so small a part of the flow, misses no more than `flow_tolerance`: it is not looked at again.
constexpr double last_step = 1e-8, quick_fall = 1e-3, small_way = 1e-5;
constexpr int most_steps = 100, most_sweeps = 200;
/// Evaluations in a search for both ends that has not found them: some 5 ms. Those that find them take up to 5,000.
constexpr int most_evaluations = 10000;
constexpr double leaves = 0.05;  ///< of its flow at first: an end whose flow shrinks to that may not flow
constexpr int quick_steps = 10, quick_tries = 3;  ///< of both ends together, before each is looked for in turn
constexpr double least_damping = 1e-13;           ///< of the elastic stiffness: N may flow at either end

bool is_small(const Vec4& way, const Vec4& of) { return way.squaredNorm() <= small_way * small_way * of.squaredNorm(); }

/// True if the flow e changes its section's forces by less than they may be off. Under a rate law that is the rule near
/// the surface: flow of 1e-37 carries 1e-7 of the strength beyond it, and its direction is lost in rounding.
bool moves_nothing(const Vec4& k, const Vec4& e, double size) {
    return k.cwiseProduct(e).norm() <= flow_tolerance * size;
}

using Mat8 = Eigen::Matrix<double, 8, 8>;
using Vec8 = Eigen::Matrix<double, 8, 1>;

/// The least along the ray of e: trial.e = t e.(k + C) e + (factor at t D) D. False: it is at t = 0.
bool move_along_ray(const FlowProblem& problem, const FlowingEnd& end, const Vec4& trial, Vec4& e, WorkOfFlow& w) {
    const double stiffness = e.dot((end.k + end.hardens).cwiseProduct(e)), force = trial.dot(e), D = w.initial;
    double t = (force - D) / stiffness;
    if (!problem.keeps_strength())
        t = find_on_ray(force, stiffness, t, 1e-14, [&](double at) { return resistance_on_ray(problem, end, D, at); });
    if (!(t > 0)) return false;
    e *= t, w.scale(t);
    return true;
}

enum class Search { found, not_below, lost };

/// Down from e. not_below: no flow along e has less than none.
Search descend(const FlowProblem& problem, const FlowingEnd& end, const Vec4& trial, Vec4& e) {
    const Vec4& k = end.k;
    WorkOfFlow at = problem.work_at(e, end.own);
    if (!move_along_ray(problem, end, trial, e, at)) return Search::not_below;
    harden(problem, end, e, at);
    const double size = 1 + trial.norm();
    double G = 0.5 * e.dot(k.cwiseProduct(e)) - trial.dot(e) + at.value, damping = 0, missed_before = 0;
    for (int i = 0; i < most_steps; ++i) {
        const Vec4 off = trial - k.cwiseProduct(e) - at.q;
        const double missed = off.norm();
        if (missed <= flow_tolerance * size) {
            if (problem.keeps_strength()) end.knows(e, at);
            return Search::found;
        }
        bool fell = false;
        for (int tries = 0; tries < 40 && !fell; ++tries) {
            Mat4 H = at.curvature;
            H.diagonal() += (1 + damping) * k;
            Vec4 way = off;
            if (!solve_positive(H, way)) break;
            Vec4 next = e + way;
            if (!next.allFinite() || next.isZero(0)) break;
            if (missed <= std::min(last_step, quick_fall * missed_before) && damping == 0 && problem.keeps_strength() &&
                is_small(way, e)) {
                at.step(way);
                return end.knows(e = next, at), Search::found;
            }
            WorkOfFlow there = problem.work_at(next, end.own);
            ++end.evaluations;
            move_along_ray(problem, end, trial, next, there);
            harden(problem, end, next, there);
            const double G_next = 0.5 * next.dot(k.cwiseProduct(next)) - trial.dot(next) + there.value,
                         left = (trial - k.cwiseProduct(next) - there.q).norm();
            if (G_next < G || (missed < g_rounds * size && left < falls * missed)) {
                fell = true, e = next, at = there, G = G_next, missed_before = missed;
                damping = damping < 1e-3 ? 0 : 0.1 * damping;
            } else {
                damping = damping == 0 ? 1e-2 : 8 * damping;
            }
        }
        if (!fell) return missed <= still_enough * size ? Search::found : Search::lost;
    }
    return Search::lost;
}

/// The least of e.k e / 2 - trial.e + work(e); `e`: where the search starts, 0 if nothing is known. False: not found.
bool find_one_end(const FlowProblem& problem, const FlowingEnd& end, const Vec4& trial, Vec4& e) {
    Vec4 nearest = Vec4::Zero();
    double missed = last_resort * (1 + trial.norm());
    const auto search = [&] {
        const Search out = descend(problem, end, trial, e);
        if (out != Search::lost) return out;
        WorkOfFlow w = problem.work_at(e, end.own);
        harden(problem, end, e, w);
        const double left = (trial - end.k.cwiseProduct(e) - w.q).norm();
        if (left < missed) nearest = e, missed = left;
        return left <= missed && moves_nothing(end.k, e, 1 + trial.norm()) ? Search::found : out;
    };
    if (!e.isZero(0) && search() == Search::found) return true;
    e = problem.work.direction(trial);
    if (search() == Search::found) return true;
    if (!is_beyond(problem, end, trial, e)) return e.setZero(), true;
    if (e.allFinite()) {
        const Search out = search();
        if (out == Search::not_below) e.setZero();  // on the surface, but for rounding
        if (out != Search::lost) return true;
        e = trial;
        if (search() == Search::found) return true;
    }
    e = nearest;
    return !e.isZero(0);
}

/// The flow of both ends together, by Newton's method.
class EndsTogether {
public:
    EndsTogether(const FlowProblem& problem, const Vec6& trial, const Stiffness& k, FlowingEnd (&ends)[2])
        : problem_(problem), trial_(trial), k_(k), ends_(ends) {
        const Mat6 stiffness = k.matrix();
        const SectionRows rows[2] = {ends[0].rows(), ends[1].rows()};
        for (int i : {0, 1}) {
            const SectionRows forces = rows[i] * stiffness;
            for (int j : {0, 1}) K_.block<4, 4>(4 * i, 4 * j) = forces * rows[j].transpose();
        }
        size_ = 1 + ends[0].carries(trial).norm() + ends[1].carries(trial).norm();
    }

    /// An end whose flow shrinks so far that it may not flow at all, where descend ended for that; else -1.
    int leaving() const { return leaving_; }
    double size() const { return size_; }
    double missed() const { return missed_; }
    /// From the flow of both ends, neither of them 0, to where G falls no more. True: it is found. `quick`: for a few
    /// steps, and not beyond one in which the flow of an end turns back: it leaves, and the flows are lost.
    bool descend(bool quick = false) {
        const int steps = quick ? quick_steps : most_steps, most_tries = quick ? quick_tries : 12;
        evaluate();
        leaving_ = -1;
        const double first[2] = {ends_[0].e.norm(), ends_[1].e.norm()};
        double damping = least_damping, missed_before = 0;
        for (int step = 0; step < steps && !found(); ++step) {
            const Vec4 before[2] = {ends_[0].e, ends_[1].e};
            const double G = G_, missed = missed_;
            const bool last = missed <= std::min(last_step, quick_fall * missed_before) && damping <= least_damping &&
                              problem_.keeps_strength();
            missed_before = missed;
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
                for (int i : {0, 1})
                    if (quick && ends_[i].e.dot(before[i]) < 0) return leaving_ = i, false;
                if (last && small(way, before)) return extrapolate(way), true;
                if (way.allFinite() && ends_[0].flows() && ends_[1].flows()) {
                    evaluate();
                    fell = G_ < G || (missed < g_rounds * size_ && missed_ < falls * missed);
                }
                damping = fell ? std::max(least_damping, 0.01 * damping) : std::max(1e-2, 8 * damping);
            }
            for (int i : {0, 1})
                if (fell && ends_[i].e.norm() < leaves * first[i]) return leaving_ = i, found();
            if (fell) continue;
            for (int i : {0, 1}) ends_[i].e = before[i];
            evaluate();
            break;
        }
        return found();
    }

private:
    bool found() const { return missed_ <= flow_tolerance * size_; }
    static bool small(const Vec8& way, const Vec4 (&of)[2]) {
        return is_small(way.head<4>(), of[0]) && is_small(way.tail<4>(), of[1]);
    }
    /// The work after a small way, from what it was before.
    void extrapolate(const Vec8& way) {
        for (int i : {0, 1}) {
            WorkOfFlow there = ends_[i].known;
            there.step(way.segment<4>(4 * i));
            ends_[i].knows(ends_[i].e, there);
        }
    }
    void evaluate() {
        ++ends_[0].evaluations;
        const Vec6 plastic = ends_[0].plastic() + ends_[1].plastic(), relieved = k_.times(plastic),
                   p = trial_ - relieved;
        G_ = 0.5 * plastic.dot(relieved) - trial_.dot(plastic);
        for (int i : {0, 1}) {
            WorkOfFlow w = problem_.work_at(ends_[i].e, ends_[i].own);
            ends_[i].knows(ends_[i].e, w);
            harden(problem_, ends_[i], ends_[i].e, w);
            bend_[i] = w.curvature;
            G_ += w.value - ends_[i].fixed.dot(ends_[i].e);
            off_.segment<4>(4 * i) = ends_[i].carries(p) - w.q;
        }
        missed_ = off_.norm();
    }

    const FlowProblem& problem_;
    const Vec6& trial_;
    const Stiffness& k_;
    FlowingEnd (&ends_)[2];
    Mat8 K_;
    Vec8 off_;
    Mat4 bend_[2];
    double size_, G_ = 0, missed_ = 0;
    int leaving_ = -1;
};

/// Whether end i flows alone: then with its flow.
bool find_lone_end(const FlowProblem& problem, const Vec6& trial, const Stiffness& k, FlowingEnd (&ends)[2], int i) {
    Vec4 direction;
    ends[1 - i].e.setZero();
    return find_one_end(problem, ends[i], ends[i].carries(trial), ends[i].e) &&
           !is_beyond(problem, ends[1 - i], ends[1 - i].carries(trial - k.times(ends[i].plastic())), direction);
}

/// Both ends, from what one of them does by itself and a guess of the other: together, else each in turn as well.
bool find_both_ends(const FlowProblem& problem, const Vec6& trial, const Stiffness& k, FlowingEnd (&ends)[2]) {
    EndsTogether both(problem, trial, k, ends);
    const Vec4 start[2] = {ends[0].e, ends[1].e};
    if (ends[0].flows() && ends[1].flows()) {
        if (both.descend(true)) return true;
        if (both.leaving() >= 0 && find_lone_end(problem, trial, k, ends, 1 - both.leaving())) return true;
        for (int i : {0, 1}) ends[i].e = start[i];
    }
    for (int sweep = 0; sweep < most_sweeps && ends[0].evaluations + ends[1].evaluations < most_evaluations; ++sweep) {
        for (int i : {1, 0}) {
            FlowingEnd& end = ends[i];
            if (!find_one_end(problem, end, end.carries(trial - k.times(ends[1 - i].plastic())), end.e)) return false;
        }
        if (ends[0].flows() && ends[1].flows()) {
            if (both.descend()) return true;
            if (both.leaving() >= 0) {
                const Vec4 guess[2] = {ends[0].e, ends[1].e};
                if (find_lone_end(problem, trial, k, ends, 1 - both.leaving())) return true;
                for (int i : {0, 1}) ends[i].e = guess[i];
            }
            const bool still = sweep > 20 && both.missed() <= still_enough * both.size();
            const bool last = sweep > 40 || (moves_nothing(ends[0].k, ends[0].e, both.size()) &&
                                             moves_nothing(ends[1].k, ends[1].e, both.size()));
            if (still || (last && both.missed() <= last_resort * both.size())) return true;
            continue;
        }
        if (!ends[0].flows() && !ends[1].flows()) return true;
        const int i = ends[0].flows() ? 0 : 1;
        const Vec6 p = trial - k.times(ends[i].plastic());
        WorkOfFlow w = problem.work_at(ends[i].e, ends[i].own);
        harden(problem, ends[i], ends[i].e, w);
        Vec4 direction;
        const bool last = sweep > 20 || moves_nothing(ends[i].k, ends[i].e, both.size());
        if ((ends[i].carries(p) - w.q).norm() <= (last ? last_resort : flow_tolerance) * both.size() &&
            !is_beyond(problem, ends[1 - i], ends[1 - i].carries(p), direction))
            return true;
    }
    return false;
}

/// Moves e along its ray to where an end that carries q comes to. False: there is no flow along it.
bool move_to_load(const FlowProblem& problem, FlowingEnd& end, const Vec4& q) {
    WorkOfFlow w = problem.work_at(end.e, end.own);
    return move_along_ray(problem, end, q, end.e, w);
}

/// Whether an end that carries q flows, from what it did before: then with a guess of its flow.
bool guess_flow(const FlowProblem& problem, FlowingEnd& end, const Vec4& q) {
    if (end.flows() && move_to_load(problem, end, q)) return true;
    if (!is_beyond(problem, end, q, end.e)) return false;
    if (!end.e.allFinite() || !move_to_load(problem, end, q)) end.e.setZero();
    return true;
}

}  // namespace

bool find_flow_of_ends(const FlowProblem& problem, const Vec6& trial, const Stiffness& k, FlowingEnd (&ends)[2], int n,
                       const ElementFlow* before) {
    Vec4 trials[2];
    for (int i = 0; i < n; ++i) {
        trials[i] = ends[i].carries(trial);
        if (!trials[i].allFinite()) return false;
    }
    const auto start = [&](int i) {
        if (before && before->lambda[i] > 0) ends[i].e = problem.normalised(before->section[i]);
        else if (problem.flow_at >= 0 && ends[i].history)
            ends[i].e = Eigen::Map<const Vec4>(ends[i].history + problem.flow_at);
    };
    const int first = n == 2 && trials[1].norm() > trials[0].norm() ? 1 : 0;
    start(first);
    if (n == 2) start(1 - first);
    if (n == 2 && ends[0].flows() && ends[1].flows()) {  // as before, most likely
        const Vec4 guess[2] = {ends[0].e, ends[1].e};
        if (move_to_load(problem, ends[first], trials[first]) &&
            move_to_load(problem, ends[1 - first], ends[1 - first].carries(trial - k.times(ends[first].plastic())))) {
            EndsTogether both(problem, trial, k, ends);
            if (both.descend(true) ||
                (both.leaving() >= 0 && find_lone_end(problem, trial, k, ends, 1 - both.leaving())))
                return true;
        }
        for (int i : {0, 1}) ends[i].e = guess[i];
    }
    const Vec4 guess = ends[1 - first].e;
    if (n == 2) ends[1 - first].e.setZero();
    if (!find_one_end(problem, ends[first], trials[first], ends[first].e)) return false;
    if (n < 2) return true;
    FlowingEnd& other = ends[1 - first];
    other.e = guess;
    if (guess_flow(problem, other, other.carries(trial - k.times(ends[first].plastic()))))
        return find_both_ends(problem, trial, k, ends);
    other.e.setZero();
    return true;
}

}  // namespace hinge::beam
