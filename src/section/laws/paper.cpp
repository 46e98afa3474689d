// The law of the paper: the surface of eq 14, a function of the squares of the resultants. Without hardening its return
// is that of the paper's figures, bit for bit; with it, that of flow_problem.h.
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "section/potential_law.h"
#include "section/laws/laws.h"

namespace hinge::beam {
namespace {

constexpr double element_ends[2] = {-1, 1};

/// The multiplier at one end, where the others do not flow: the root of a convex, falling function of lambda. Newton's
/// method comes to it from the left, from any start.
///   c  what lambda takes off each resultant, relative to it;  g  the parts of f_y at lambda = 0
/// False: it is not found, and lambda is where the search ended.
bool multiplier(const double (&c)[4], const double (&g)[4], double& lambda) {
    double f = 0;
    for (int i = 0; i < 400; ++i) {  // far beyond the surface, lambda grows by half in each
        double slope = 0;
        f = -1;
        for (int j = 0; j < 4; ++j) {
            const double a = 1 / (1 + lambda * c[j]), b = g[j] * a * a;
            f += b;
            slope -= 2 * c[j] * a * b;
        }
        if (std::abs(f) <= 1e-13 || slope == 0) break;
        lambda = std::max(0.0, lambda - f / slope);
    }
    return std::abs(f) <= 1e-9;
}

/// f_y at end j of the forces p.
double f_y(const Vec6& p, int j, const YieldSurface& w, const FixedEnd& fixed) {
    const double mx = p[j] + fixed.moment[j], my = p[2 + j] + fixed.moment[2 + j], n = p[4] + fixed.N[j],
                 mz = p[5] + fixed.Mz[j];
    return w.x * mx * mx + w.y * my * my + w.n * n * n + w.z * mz * mz;
}

/// The point of one element's surface nearest to `trial` in the energy norm of `k`; `before`: where the multipliers
/// start from.
ElementFlow return_ends(const Vec6& trial, const Stiffness& k, const YieldSurface& w, const FixedEnd& fixed,
                        const ElementFlow& before) {
    ElementFlow out;
    out.p = trial;
    const double f[2] = {f_y(trial, 0, w, fixed), f_y(trial, 1, w, fixed)};
    const int j = f[1] > f[0] ? 1 : 0;
    if (!(f[j] > 1)) return out;
    const double kx = j == 0 ? k.x11 : k.x22, ky = j == 0 ? k.y11 : k.y22;
    const double c[4] = {2 * w.x * kx, 2 * w.y * ky, 2 * w.n * k.axial, 2 * w.z * k.twist};
    double r[4] = {trial[j] + fixed.moment[j], trial[2 + j] + fixed.moment[2 + j], trial[4] + fixed.N[j],
                   trial[5] + fixed.Mz[j]};
    const double g[4] = {w.x * r[0] * r[0], w.y * r[1] * r[1], w.n * r[2] * r[2], w.z * r[3] * r[3]};
    double lambda = before.lambda[1 - j] == 0 ? before.lambda[j] : 0;
    out.converged = multiplier(c, g, lambda);
    for (int i = 0; i < 4; ++i) r[i] /= 1 + lambda * c[i];
    const double rate[4] = {2 * lambda * w.x * r[0], 2 * lambda * w.y * r[1], 2 * lambda * w.n * r[2],
                            2 * lambda * w.z * r[3]};
    out.plastic[j] = rate[0], out.plastic[2 + j] = rate[1], out.plastic[4] = rate[2], out.plastic[5] = rate[3];
    out.p -= k.times(out.plastic);
    out.lambda[j] = lambda;
    if (f_y(out.p, 1 - j, w, fixed) <= 1 + 1e-13) return out;
    return return_to_surface(trial, k, w, element_ends, 2, fixed);
}

class Paper : public SectionLaw {
public:
    explicit Paper(const YieldSurface& w) : SectionLaw(w), w_(w) {}

    const char* name() const override { return "paper"; }
    bool ignores_shape() const override { return true; }
    double yield_function(const Vec4& q, const double*, double) const override {
        return w_.x * q[0] * q[0] + w_.y * q[1] * q[1] + w_.n * q[2] * q[2] + w_.z * q[3] * q[3];
    }

    ReturnMapResult return_to_surface(const Vec6& trial, const Stiffness& k, const double* sections, int n,
                                      const SectionConditions& at) const override {
        return beam::return_to_surface(trial, k, w_, sections, n, *at.fixed_end);
    }
    ElementFlow return_alone(const Vec6& trial, const Stiffness& k, const SectionConditions& at,
                             const ElementFlow& before) const override {
        return return_ends(trial, k, w_, *at.fixed_end, before);
    }
    double work_of(const FixedEnd& part, const ElementFlow& flow, const double* sections, int n,
                   const SectionConditions& at) const override {
        return beam::work_of(part, flow, w_, sections, n, *at.fixed_end);
    }
    Mat6 tangent(const ElementFlow& flow, const Stiffness& k, const double* sections, int n,
                 const SectionConditions& at) const override {
        const bool active[2] = {flow.lambda[0] > 0, flow.lambda[1] > 0};
        return plastic_tangent(flow.p, k, w_, sections, flow.lambda, active, n, *at.fixed_end);
    }

    /// Eq 10a, of the pair.
    Mat12 pair_tangent(const Mat12& elastic, const ElementFlow* const (&flow)[2],
                       const SectionConditions* at) const override {
        Mat12 F = elastic.inverse();
        Eigen::Matrix<double, 12, Eigen::Dynamic, 0, 12, 4> a(12, 0);
        for (int i : {0, 1})
            for (int s = 0; flow[i] && s < 2; ++s) {
                if (!(flow[i]->lambda[s] > 0)) continue;
                F.block<6, 6>(6 * i, 6 * i) += 2 * flow[i]->lambda[s] * yield_matrix(element_ends[s], w_);
                a.conservativeResize(12, a.cols() + 1);
                a.rightCols<1>().setZero();
                a.rightCols<1>().segment<6>(6 * i) =
                    yield_gradient(flow[i]->p + at[i].fixed_end->at(element_ends[s]), element_ends[s], w_);
            }
        Mat12 X = F.inverse();
        if (a.cols() == 0) return X;
        const Eigen::Matrix<double, 12, Eigen::Dynamic, 0, 12, 4> Xa = X * a;
        const Eigen::MatrixXd h = a.transpose() * Xa;
        return X - Xa * h.completeOrthogonalDecomposition().pseudoInverse() * Xa.transpose();
    }

private:
    YieldSurface w_;
};

/// Eq 14 in normalised resultants: a sphere, of which D(e) = |e|.
class Sphere : public PotentialLaw {
public:
    Sphere(const YieldSurface& w, SectionMaterial material)
        : PotentialLaw(w, {1 / std::sqrt(w.x), 1 / std::sqrt(w.y), 1 / std::sqrt(w.n), 1 / std::sqrt(w.z)},
                       std::move(material)),
          yields_(w.x != 0, w.y != 0, w.n != 0, w.z != 0) {}

    const char* name() const override { return "paper"; }
    bool ignores_shape() const override { return true; }

protected:
    double potential(const Vec4& e, const double*, Vec4& q, Mat4& curvature) const override {
        const double D = e.norm();
        q = e / D;
        curvature = (Mat4::Identity() - q * q.transpose()) / D;
        return D;
    }
    Vec4 direction(const Vec4& q) const override { return q.isZero(0) ? yields_ : q; }
    bool outside(const Vec4& q, const double*, Vec4& direction) const override {
        return direction = q, q.norm() > 1 + 1e-12;
    }
    double shape_function(const Vec4& q, const double*) const override { return q.squaredNorm(); }
    bool surely_inside(const Vec4& q, const double*) const override { return q.squaredNorm() <= 1; }

private:
    Vec4 yields_;  ///< 1 for the resultants that yield the section
};

}  // namespace

std::unique_ptr<const SectionLaw> paper_law(const YieldSurface& strength, SectionMaterial material) {
    if (material.laws.empty()) return std::make_unique<Paper>(strength);
    return std::make_unique<Sphere>(strength, std::move(material));
}

}  // namespace hinge::beam
