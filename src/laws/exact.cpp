// The exact interaction of N, Mx and My of a section's outline (beam/plastic_domain.h), with what the material adds; of
// steel or of reinforced concrete.
// Torsion takes from all of them alike: g^2 + (Mz / Mz0)^2 = 1, where g is the gauge of N, Mx and My.
#include <cmath>

#include "beam/potential_law.h"
#include "laws/laws.h"

namespace hinge::beam {
namespace {

YieldSurface screen_of(const PlasticDomain& domain, const Vec4& strength) {
    const Vec3 axis = domain.ellipsoid().cwiseProduct(strength.head<3>());
    const auto inverse_square = [](double a) { return 1 / (a * a); };
    return {inverse_square(axis[0]), inverse_square(axis[1]), inverse_square(axis[2]), inverse_square(strength[3])};
}

constexpr double rounding = 1e-12;        ///< of the gauge of forces on the surface
constexpr double gauge_tolerance = 1e-7;  ///< what forces may be outside where their gauge is not found better

class Exact : public PotentialLaw {
public:
    Exact(std::shared_ptr<const PlasticDomain> domain, const Vec4& strength, SectionMaterial material)
        : PotentialLaw(screen_of(*domain, strength), strength, std::move(material), true), domain_(std::move(domain)) {}

    const char* name() const override { return domain_->concrete() ? "concrete" : "exact"; }

protected:
    double shape_function(const Vec4& q) const override {
        const double g = domain_->gauge(q.head<3>());
        return g * g + q[3] * q[3];
    }

    bool surely_inside(const Vec4& q) const override {
        const double rest = 1 - q[3] * q[3];
        return rest > 0 && domain_->surely_inside(q.head<3>() / std::sqrt(rest));
    }

    double potential(const Vec4& e, Vec4& q, Mat4& curvature) const override {
        Vec3 point;
        Mat3 bend;
        if (e[3] == 0) {
            const double h = domain_->support(e.head<3>(), point, &bend);
            q << point, 0;
            curvature.setZero();
            curvature.topLeftCorner<3, 3>() = bend;
            curvature(3, 3) = 1 / h;
            return h;
        }
        const double h = e.head<3>().isZero(0) ? 0 : domain_->support(e.head<3>(), point, &bend),
                     D = std::sqrt(h * h + e[3] * e[3]);
        if (h == 0) point.setZero(), bend.setZero();
        q << h / D * point, e[3] / D;
        curvature.topLeftCorner<3, 3>() = (point * point.transpose() + h * bend) / D;
        curvature.topRightCorner<3, 1>().setZero();
        curvature.bottomLeftCorner<1, 3>().setZero();
        curvature(3, 3) = 1 / D;
        curvature -= q * q.transpose() / D;
        return D;
    }

    Vec4 direction(const Vec4& q) const override {
        const Vec3 normal = domain_->about_normal(q.head<3>());
        Vec4 e;
        e << normal, q[3] * normal.norm();
        return e;
    }

    bool outside(const Vec4& q, Vec4& direction) const override {
        if (surely_inside(q)) return false;
        Vec3 normal;
        double error = 0;
        const double limit = std::sqrt(std::max(0.0, (1 + rounding) * (1 + rounding) - q[3] * q[3]));
        const double untwisted = domain_->gauge(q.head<3>(), &normal, &error, limit), g = std::sqrt(untwisted * untwisted + q[3] * q[3]);
        direction << untwisted * normal, q[3];
        if (g > 1 + rounding) return true;
        if (untwisted + error <= limit) return false;
        if (g + error > 1 + gauge_tolerance) direction.setConstant(std::nan(""));
        return g + error > 1 + gauge_tolerance;
    }

private:
    std::shared_ptr<const PlasticDomain> domain_;
};

}  // namespace

std::unique_ptr<const SectionLaw> exact_law(std::shared_ptr<const PlasticDomain> domain, const Vec4& strength,
                                            SectionMaterial material) {
    return std::make_unique<Exact>(std::move(domain), strength, std::move(material));
}

}  // namespace hinge::beam
