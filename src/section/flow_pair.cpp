// The flow of all four ends of a pair at once: Newton's method for the equilibrium of the ends that flow, with the
// stiffness of the whole pair. The strength that follows the flow, and the back resultants, are those of the flow that
// each step has. Where the stiffness is not positive with them, or the method does not converge at once, it gives up,
// and rounds of the elements by themselves go on (flow_return.cpp).
#include <cmath>

#include "core/positive.h"
#include "section/flow_end.h"
#include "section/flow_return.h"

namespace hinge::beam {
namespace {

constexpr int most_steps_of_pair = 6, most_under_rate = 12;
/// Under a rate law the strength rises steeply where flow begins: from too much flow Newton's method leads to less than
/// none, and from too little up to what is looked for.
constexpr double shrinks = 0.1;
constexpr double near_enough = 1e-3;        ///< of the force: what may be left along the ray from which it starts
constexpr double must_fall = 0.5;           ///< to what part a step must bring what is missed
constexpr double missed_over_change = 0.1;  ///< of the tolerance on the flow: what equilibrium may be off
constexpr double stiffer = 1e-13;           ///< of the elastic stiffness: N may flow at either end

/// Rows and columns of the ends that flow, four each.
template <int ends>
using EndsMatrix = Eigen::Matrix<double, 4 * ends, 4 * ends>;
template <int ends>
using EndsVector = Eigen::Matrix<double, 4 * ends, 1>;

/// B K of one end, of a matrix K of which two columns or one belong to each of its resultants.
template <class Rows, class Out>
void rows_times(const Rows& n, const Vec4& per, int first, const Mat12& K, Out&& out) {
    const auto& [n1, n2] = n;
    out.row(0) = per[0] * (n1 * K.row(first) + n2 * K.row(first + 1));
    out.row(1) = per[1] * (n1 * K.row(first + 2) + n2 * K.row(first + 3));
    out.row(2) = per[2] * K.row(first + 4);
    out.row(3) = per[3] * K.row(first + 5);
}

/// An end that flows, and where it stands among the four.
struct PairEnd {
    FlowingEnd end;
    int element = 0, section = 0;
};

template <int count>
bool solve_pair(const FlowProblem& problem, const PairElastic& pair, const SectionConditions* at,
                PairEnd* const (&flowing)[4], double tolerance, Vec6 (&p)[2]) {
    const int most_steps = problem.follows_rate ? most_under_rate : most_steps_of_pair;
    double last = INFINITY;
    for (int step = 0;; ++step) {
        Vec6 plastic[2] = {Vec6::Zero(), Vec6::Zero()};
        for (int i = 0; i < count; ++i) plastic[flowing[i]->element] += flowing[i]->end.plastic();
        Mat12 K;
        pair.at(plastic, p, K);
        EndsVector<count> off;
        Mat4 bend[count];
        double size = 1;
        for (int i = 0; i < count; ++i) {
            FlowingEnd& end = flowing[i]->end;
            WorkOfFlow w = problem.work_at(end.e, end.own);
            if (problem.in_rounds())
                end.set_history(at[flowing[i]->element], flowing[i]->section, problem,
                                {w.initial / problem.material.zone.energy, end.e});
            harden_and_turn(problem, end, end.e, w);
            const Vec4 carries = end.carries(p[flowing[i]->element]);
            off.template segment<4>(4 * i) = carries - w.q;
            bend[i] = w.curvature;
            size += carries.norm();
        }
        const double missed = off.norm();
        if (missed <= missed_over_change * tolerance * size) return true;
        if (step == most_steps || !(missed < must_fall * last)) return false;
        last = missed;
        EndsMatrix<count> H;
        for (int i = 0; i < count; ++i) {
            const FlowingEnd& of = flowing[i]->end;
            Eigen::Matrix<double, 4, 12> BK;
            rows_times(std::pair(of.n1, of.n2), of.per, 6 * flowing[i]->element, K, BK);
            for (int j = 0; j <= i; ++j) {
                const FlowingEnd& by = flowing[j]->end;
                const int first = 6 * flowing[j]->element;
                Mat4 block;
                block.col(0) = by.per[0] * (by.n1 * BK.col(first) + by.n2 * BK.col(first + 1));
                block.col(1) = by.per[1] * (by.n1 * BK.col(first + 2) + by.n2 * BK.col(first + 3));
                block.col(2) = by.per[2] * BK.col(first + 4);
                block.col(3) = by.per[3] * BK.col(first + 5);
                if (i == j) {
                    for (int c = 0; c < 4; ++c) block(c, c) = block(c, c) == 0 ? 1 : (1 + stiffer) * block(c, c);
                    block += bend[i];
                }
                H.template block<4, 4>(4 * i, 4 * j) = block;
            }
        }
        if (!solve_positive(H, off) || !off.allFinite()) return false;
        for (int i = 0; i < count; ++i) {
            Vec4& e = flowing[i]->end.e;
            const Vec4 next = e + off.template segment<4>(4 * i);
            if (next.dot(e) > 0) e = next;
            else if (problem.follows_rate) e *= shrinks, last = INFINITY;
            else return false;  // an end that turns back may not flow
        }
    }
}

/// Scales the flow of all ends to where the pair comes to along its ray: the least value of the work and of the elastic
/// energy, by its stiffness without flow. False: there is no flow along it.
bool scale_along_ray(const FlowProblem& problem, const PairElastic& pair, PairEnd* const (&flowing)[4], int count) {
    Vec6 plastic[2] = {Vec6::Zero(), Vec6::Zero()}, p[2];
    Mat12 K;
    pair.at(plastic, p, K);
    double force = 0, work[4], whole = 0;
    for (int i = 0; i < count; ++i) {
        const FlowingEnd& end = flowing[i]->end;
        plastic[flowing[i]->element] += end.plastic();
        force += end.carries(p[flowing[i]->element]).dot(end.e);
        whole += work[i] = problem.work_at(end.e, end.own).value;
    }
    Vec12 x;
    x << plastic[0], plastic[1];
    const double stiffness = x.dot(K * x);
    double by = (force - whole) / stiffness;
    if (!problem.keeps_strength())
        by = find_on_ray(force, stiffness, by, near_enough, [&](double t) {
            MaterialLaw::Factor sum{0, 0};
            for (int i = 0; i < count; ++i) {
                const MaterialLaw::Factor f = resistance_on_ray(problem, flowing[i]->end, work[i], t);
                sum.value += f.value, sum.slope += f.slope;
            }
            return sum;
        });
    if (!(by > 0) || !std::isfinite(by)) return false;
    for (int i = 0; i < count; ++i) flowing[i]->end.e *= by;
    return true;
}

}  // namespace

bool return_together(const FlowProblem& problem, const PairElastic& pair, const SectionConditions* at, double tolerance,
                     ElementFlow (&flow)[2]) {
    const bool as_before = !flow[0].flows() && !flow[1].flows();
    if (as_before && problem.flow_at < 0) return false;
    PairEnd all[4];
    PairEnd* flowing[4];
    int count = 0;
    for (int i = 0; i < 4; ++i) {
        PairEnd& of = all[i];
        of.element = i / 2, of.section = i % 2;
        of.end = FlowingEnd(of.section == 0 ? -1 : 1, Stiffness{}, at[of.element], of.section, problem, {});
        const ElementFlow& known = flow[of.element];
        if (as_before && of.end.history) of.end.e = Eigen::Map<const Vec4>(of.end.history + problem.flow_at);
        else if (known.lambda[of.section] > 0) of.end.e = problem.normalised(known.section[of.section]);
        if (of.end.flows()) flowing[count++] = &of;
    }
    if (as_before && !(count > 0 && scale_along_ray(problem, pair, flowing, count))) return false;
    Vec6 p[2];
    const bool found = count == 1   ? solve_pair<1>(problem, pair, at, flowing, tolerance, p)
                       : count == 2 ? solve_pair<2>(problem, pair, at, flowing, tolerance, p)
                       : count == 3 ? solve_pair<3>(problem, pair, at, flowing, tolerance, p)
                       : count == 4 ? solve_pair<4>(problem, pair, at, flowing, tolerance, p)
                                    : false;
    if (!found) return false;
    for (const PairEnd& of : all) {
        Vec4 direction;
        if (!of.end.flows() && is_beyond(problem, of.end, of.end.carries(p[of.element]), direction)) return false;
    }
    for (int i : {0, 1}) {
        ElementFlow out;
        out.p = p[i];
        for (const int j : {0, 1}) add_flow(problem, all[2 * i + j].end, j, out);
        flow[i] = out;
    }
    return true;
}

}  // namespace hinge::beam
