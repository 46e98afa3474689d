// Plastic hinges: the yield function of a section (eq 14), and the return of an element's forces to its yield surface.
#pragma once

#include "section/stiffness.h"

namespace hinge::beam {

/// Yield surface of a section: 1/Mx0^2, 1/My0^2, 1/N0^2, 1/Mz0^2 of its fully plastic resultants (N m and N). All zero:
/// the section never yields.
struct YieldSurface {
    double x = 0, y = 0, n = 0, z = 0;
    bool elastic() const { return x == 0 && y == 0 && n == 0 && z == 0; }
};

/// Mx, My, N and Mz at section r (-1: node 1, 0: middle, +1: node 2) of the element forces p.
inline Vec4 resultants(const Vec6& p, double r) {
    return {-p[0] * ((1 - r) / 2) + p[1] * ((1 + r) / 2), -p[2] * ((1 - r) / 2) + p[3] * ((1 + r) / 2), p[4], p[5]};
}

/// Yield function f_y of eq 14 at section r (-1: node 1, 0: middle, +1: node 2) for the element forces p.
template <class P>
inline auto yield_function(const P& p, double r, const YieldSurface& w) {
    const auto mx = -p[0] * ((1 - r) / 2) + p[1] * ((1 + r) / 2), my = -p[2] * ((1 - r) / 2) + p[3] * ((1 + r) / 2);
    return w.x * mx * mx + w.y * my * my + w.n * p[4] * p[4] + w.z * p[5] * p[5];
}

/// Fixed-end forces at an element's two ends from loads between its nodes, N and N m. The yield function is evaluated
/// for their sum with p.
struct FixedEnd {
    double moment[4] = {0, 0, 0, 0};  ///< in the order of p: -Mx at node 1, Mx at node 2, -My at node 1, My at node 2
    double N[2] = {0, 0}, Mz[2] = {0, 0};  ///< at node 1 and at node 2

    /// Fixed-end forces of section r, in the order of p.
    Vec6 at(double r) const {
        const double n1 = (1 - r) / 2, n2 = (1 + r) / 2;
        return (Vec6() << moment[0], moment[1], moment[2], moment[3], n1 * N[0] + n2 * N[1], n1 * Mz[0] + n2 * Mz[1])
            .finished();
    }
    /// Adds resultants at end 0 or 1, with the signs of the section's resultants.
    void add(int end, double Mx, double My, double N_there, double Mz_there) {
        const double side = end == 0 ? -1 : 1;
        moment[end] += side * Mx, moment[2 + end] += side * My;
        N[end] += N_there, Mz[end] += Mz_there;
    }
    FixedEnd& operator+=(const FixedEnd& other) {
        for (int i = 0; i < 4; ++i) moment[i] += other.moment[i];
        for (int i : {0, 1}) N[i] += other.N[i], Mz[i] += other.Mz[i];
        return *this;
    }
    friend FixedEnd operator-(FixedEnd a, const FixedEnd& b) {
        for (int i = 0; i < 4; ++i) a.moment[i] -= b.moment[i];
        for (int i : {0, 1}) a.N[i] -= b.N[i], a.Mz[i] -= b.Mz[i];
        return a;
    }
};
inline const FixedEnd no_fixed_end;

/// Matrix A of the yield function f_y = p^T A p, 6 x 6.
Mat6 yield_matrix(double r, const YieldSurface& w);

/// The gradient of f_y with respect to p.
Vec6 yield_gradient(const Vec6& p, double r, const YieldSurface& w);

/// Plastic flow of an element in a step.
struct ElementFlow {
    Vec6 p = Vec6::Zero();        ///< forces on the surface
    Vec6 plastic = Vec6::Zero();  ///< increment of plastic deformation, in the places of p
    /// Half the plastic work at each of the sections that can yield, J, >= 0, with that of fixed-end forces; for the
    /// surface of eq 14 this is the multiplier: d = lambda df/dp.
    double lambda[2] = {0, 0};
    bool converged = true;  ///< false: no forces keep all sections within the surface, or none was found
    /// What a law that is not eq 14 keeps of each section: its plastic rotations about x and y (rad), elongation (m)
    /// and twist (rad).
    Vec4 section[2] = {Vec4::Zero(), Vec4::Zero()};
    /// Part of the growth of the plastic elongation that takes no work, m: slack of members that carry tension alone
    /// or compression alone.
    double slack = 0;
    /// What the work on the way of the step is more than that of its last forces, J: with hardening they grow on it.
    double path_work = 0;
    /// The same of what the step minimises: with rate, which is that of the whole step, it differs.
    double potential = 0;
    int evaluations = 0;  ///< that the search for it took
    /// True if a section flows plastically.
    bool yields() const { return lambda[0] > 0 || lambda[1] > 0; }
    /// True if the plastic deformation changes, by flow or by slack.
    bool flows() const { return yields() || slack != 0; }
};

/// Result of the return mapping of an element.
struct ReturnMapResult : ElementFlow {
    double dissipation = 0;  ///< (p plus fixed-end forces) . plastic, J, >= 0
    /// Elastic deformation after the flow, m and rad; only of pairs whose bending depends on N (beam_column.h), else 0.
    Vec6 elastic = Vec6::Zero();

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.p, s.plastic, s.lambda, s.dissipation, s.elastic, s.section, s.slack);
    }
};

/// Return mapping of an element (associated flow, elastic-perfectly plastic, implicit): the point of the yield surfaces
/// nearest to `trial` in the energy norm.
///   trial     forces if the step were elastic
///   k         the element's elastic stiffness
///   sections  positions r that can yield (two ends; the middle alone for the conventional element), n of them
/// The flow is evaluated for p plus the fixed-end forces; ReturnMapResult::p excludes them.
ReturnMapResult return_to_surface(const Vec6& trial, const Stiffness& k, const YieldSurface& w, const double* sections,
                                  int n, const FixedEnd& fixed_end = no_fixed_end);

/// Work of fixed-end forces on the plastic flow at the n sections, J; `part`: `fixed_end` or a part of it.
double work_of(const FixedEnd& part, const ElementFlow& flow, const YieldSurface& w, const double* sections, int n,
               const FixedEnd& fixed_end);

/// Consistent tangent dp/dd of return_to_surface; D_p of eq 10 for infinitesimal lambda. `active`: sections that flow.
Mat6 plastic_tangent(const Vec6& p, const Stiffness& k, const YieldSurface& w, const double* sections,
                     const double* lambda, const bool* active, int n, const FixedEnd& fixed_end = no_fixed_end);

}  // namespace hinge::beam
