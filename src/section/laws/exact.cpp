// The exact interaction of N, Mx and My of a section's outline (section/plastic_domain.h), with what the material adds;
// of steel or of reinforced concrete. Torsion takes from all of them alike: g^2 + (Mz / Mz0)^2 = 1, where g is the
// gauge of N, Mx and My.
//
// Shear forces weaken the walls that carry them (EN 1993-1-1 6.2.8), where the section is asked for that: its walls'
// yield stress is (1 - rho) fy, rho = (2 V / V0 - 1)^2 beyond V0 / 2. What V is at the end of a step is known then
// alone, so that rho is a history variable, constant in the step that follows.
#include <algorithm>
#include <cmath>

#include "section/potential_law.h"
#include "section/laws/laws.h"

namespace hinge::beam {
namespace {

YieldSurface screen_of(const PlasticDomain& domain, const Vec4& strength) {
    const Vec3 axis = domain.ellipsoid().cwiseProduct(strength.head<3>());
    const auto inverse_square = [](double a) { return 1 / (a * a); };
    return {inverse_square(axis[0]), inverse_square(axis[1]), inverse_square(axis[2]), inverse_square(strength[3])};
}

constexpr double rounding = 1e-11;        ///< of the gauge of forces on the surface, at the corner of N alone too
constexpr double gauge_tolerance = 1e-7;  ///< what forces may be outside where their gauge is not found better

class Exact : public PotentialLaw {
public:
    Exact(std::shared_ptr<const PlasticDomain> domain, const Vec4& strength, SectionMaterial material,
          const ShearCarried* shear)
        : PotentialLaw(screen_of(*domain, strength), strength, std::move(material), true, shear ? shear_variables : 0),
          domain_(std::move(domain)),
          whole_(shear && shear->whole),
          walls_(shear ? shear->walls : PlasticDomain::Walls::Polygons{}) {}

    const char* name() const override {
        return domain_->concrete() ? "concrete" : problem().own_at >= 0 ? "exact with shear" : "exact";
    }
    bool takes_shear() const override { return problem().own_at >= 0; }
    void set_shear(double along_x, double along_y, double* history) const override {
        double* lost = history + problem().own_at;
        std::copy_n(lost, 3, lost + 3);
        if (whole_) lost[0] = lost[1] = 0, lost[2] = std::max(along_x, along_y);
        else lost[0] = along_x, lost[1] = along_y, lost[2] = 0;
    }
    double lost_by_shear(bool along_y, const double* history) const override {
        const double* lost = problem().own(history);
        return lost ? std::max(lost[along_y], lost[2]) : 0;
    }

protected:
    /// On the way of the step the forces go from the surface of the step before to that of now.
    double more_on_the_way(const Vec4& e, const double* own, double work) const override {
        if (std::equal(own, own + 3, own + 3)) return 0;
        Vec4 q;
        Mat4 curvature;
        return 0.5 * (potential(e, own + 3, q, curvature) - work);
    }
    double shape_function(const Vec4& q, const double* own) const override {
        const Left walls(walls_, own);
        const double g = domain_->gauge(q.head<3>() / walls.left, nullptr, nullptr, no_limit, walls.lost());
        return g * g + q[3] * q[3];
    }

    bool surely_inside(const Vec4& q, const double* own) const override {
        const Left walls(walls_, own);
        const double rest = 1 - q[3] * q[3];
        return rest > 0 && domain_->surely_inside(q.head<3>() / (walls.left * std::sqrt(rest)), nullptr, walls.lost());
    }

    double potential(const Vec4& e, const double* own, Vec4& q, Mat4& curvature) const override {
        const Left walls(walls_, own);
        Vec3 point;
        Mat3 bend;
        double h = 0;
        if (e.head<3>().isZero(0)) point.setZero(), bend.setZero();
        else h = walls.left * domain_->support(e.head<3>(), point, &bend, walls.lost());
        if (walls.left < 1) point *= walls.left, bend *= walls.left;
        if (e[3] == 0) {
            q << point, 0;
            curvature.setZero();
            curvature.topLeftCorner<3, 3>() = bend;
            curvature(3, 3) = 1 / h;
            return h;
        }
        const double D = std::sqrt(h * h + e[3] * e[3]);
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

    bool outside(const Vec4& q, const double* own, Vec4& direction) const override {
        if (surely_inside(q, own)) return false;
        const Left walls(walls_, own);
        Vec3 normal;
        double error = 0;
        const double limit = std::sqrt(std::max(0.0, (1 + rounding) * (1 + rounding) - q[3] * q[3]));
        const double untwisted = domain_->gauge(q.head<3>() / walls.left, &normal, &error, limit, walls.lost()),
                     g = std::sqrt(untwisted * untwisted + q[3] * q[3]);
        direction << untwisted / walls.left * normal, q[3];
        if (g > 1 + rounding) return true;
        if (untwisted + error <= limit) return false;
        if (g + error > 1 + gauge_tolerance) direction.setConstant(std::nan(""));
        return g + error > 1 + gauge_tolerance;
    }

private:
    /// History: the parts of their strength that walls along x and along y have lost, and that all of the section has;
    /// the same of the step before.
    static constexpr int shear_variables = 6;
    static constexpr double no_limit = std::numeric_limits<double>::infinity();
    struct Left {
        Left(const PlasticDomain::Walls& walls, const double* own) : of{&walls, {own ? own[0] : 0, own ? own[1] : 0}} {
            if (own) left = 1 - own[2];
        }
        const PlasticDomain::Lost* lost() const { return of.part[0] > 0 || of.part[1] > 0 ? &of : nullptr; }
        PlasticDomain::Lost of;
        double left = 1;  ///< of all of the section
    };

    std::shared_ptr<const PlasticDomain> domain_;
    bool whole_;  ///< shear weakens all of the section, not its walls alone
    PlasticDomain::Walls walls_;
};

}  // namespace

std::unique_ptr<const SectionLaw> exact_law(std::shared_ptr<const PlasticDomain> domain, const Vec4& strength,
                                            SectionMaterial material, const ShearCarried* shear) {
    return std::make_unique<Exact>(std::move(domain), strength, std::move(material), shear);
}

}  // namespace hinge::beam
