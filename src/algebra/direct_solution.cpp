// Solution by factors that are there. Compiled with fused products, unlike direct_factors.cpp (see direct_factors.h).
#include "algebra/direct_factors_eigen.h"

namespace hinge {

bool DirectFactors::solve(const double* right, double* x, int nodes) const {
    const Eigen::Map<const Eigen::VectorXd> b(right, 6 * nodes);
    Eigen::Map<Eigen::VectorXd> out(x, 6 * nodes);
    if (unsymmetric_) out = factors_->lu->solve(b);
    else out = factors_->ldlt.solve(b);
    return out.allFinite();
}

}  // namespace hinge
