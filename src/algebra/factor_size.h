// Size of the factors of a stiffness matrix, from its pattern alone.
#pragma once

#include <utility>
#include <vector>

namespace hinge {

struct FactorSize {
    double bytes = 0;       ///< of the factors
    double operations = 0;  ///< multiplications and additions of a factorisation
};

/// Size of the factors of a symmetric matrix with six unknowns a node and a block for each pair of nodes, in the order
/// of least degree that DirectFactors takes.
FactorSize factor_size(int nodes, const std::vector<std::pair<int, int>>& pairs);

}  // namespace hinge
