#include "algebra/rigid_modes.h"

#include <Eigen/SparseCholesky>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace hinge {
namespace {

using Vector = Eigen::VectorXd;
using Factors = Eigen::SimplicialLDLT<SparseMatrix>;

/// Values beyond are no rigid motions, whatever the rounding: that of K is 1e-16 of its trace, and the iteration leaves
/// the shift times its own accuracy.
constexpr double always_told = 1e-11;

/// Rounding of x . K x as a part of |x| . |K| |x|: an entry of K is turned into the axes of space (some ten operations)
/// and added up of some ten elements.
constexpr double rounding = 100 * std::numeric_limits<double>::epsilon();

/// |x| . |K| |x|, K given by its lower half.
double sum_of_terms(const SparseMatrix& K, const Vector& x) {
    double sum = 0;
    for (Eigen::Index column = 0; column < K.outerSize(); ++column)
        for (SparseMatrix::InnerIterator at(K, column); at; ++at)
            sum += (at.row() == column ? 1 : 2) * std::abs(at.value() * x[at.row()] * x[column]);
    return sum;
}

double product(const SparseMatrix& A, const Vector& x) { return x.dot(A.selfadjointView<Eigen::Lower>() * x); }

}  // namespace

void tell_rigid_modes(const SparseMatrix& K, const SparseMatrix& M, double a, Eigenpairs& found,
                      const std::function<std::string(const Vector&)>& bends) {
    std::optional<Factors> factors;
    for (std::size_t i = 0; i < found.values.size(); ++i) {
        if (found.values[i] >= always_told) continue;
        if (!factors) factors.emplace(SparseMatrix(K + a * M));
        // the iteration has left its accuracy of stiff modes in the vector: one more step divides them by their values
        Vector x = factors->solve(M.selfadjointView<Eigen::Lower>() * found.vectors.col(Eigen::Index(i)));
        x /= std::sqrt(product(M, x));
        const double energy = product(K, x);
        if (std::abs(energy) > rounding * sum_of_terms(K, x)) {
            if (found.values[i] > -always_told) found.values[i] = energy;
            continue;
        }
        if (const std::string what = bends(x); !what.empty())
            throw std::runtime_error("the frequency of a mode that bends " + what +
                                     " is lost in the rounding of the stiffness: other parts are some 1e14 times as "
                                     "stiff; give them areas and moments of inertia that are closer to the others', or "
                                     "rigid links in their place");
        found.values[i] = 0;
    }
}

std::string strained_member(const Structure& s, const State& state, const std::vector<Vec6>& motion) {
    double worst = 0, moved = 0;
    int member = -1;
    for (std::size_t i = 0; i < s.elements().size(); ++i) {
        if (state.broken[i]) continue;
        const Element& e = s.elements()[i];
        const Vec6 &a = motion[std::size_t(e.node[0])], &b = motion[std::size_t(e.node[1])];
        const auto place = [&](int n) -> Vec3 {
            return s.position()[std::size_t(n)] + state.displacement[std::size_t(n)];
        };
        const Vec3 along = place(e.node[1]) - place(e.node[0]), turned = 0.5 * (a + b).tail<3>();
        const double strain =
            (b.head<3>() - a.head<3>() - turned.cross(along)).norm() + e.length * (b.tail<3>() - a.tail<3>()).norm();
        moved = std::max({moved, a.head<3>().norm(), b.head<3>().norm(), e.length * turned.norm()});
        if (strain > worst) worst = strain, member = e.member;
    }
    return worst > 1e-5 * moved ? "member " + std::to_string(member + 1) : "";
}

}  // namespace hinge
