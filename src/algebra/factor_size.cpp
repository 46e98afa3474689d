#include "algebra/factor_size.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

namespace hinge {

FactorSize factor_size(int nodes, const std::vector<std::pair<int, int>>& pairs) {
    using Pattern = Eigen::SparseMatrix<float, Eigen::ColMajor, int>;
    std::vector<Eigen::Triplet<float>> entries;
    entries.reserve(2 * pairs.size() + std::size_t(nodes));
    for (int n = 0; n < nodes; ++n) entries.emplace_back(n, n, 1.0F);
    for (const auto& [a, b] : pairs) entries.emplace_back(a, b, 1.0F), entries.emplace_back(b, a, 1.0F);
    Pattern A(nodes, nodes);
    A.setFromTriplets(entries.begin(), entries.end());
    entries = {};
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> inverse;
    Eigen::AMDOrdering<int>()(A, inverse);
    const auto& old_of = inverse.indices();
    std::vector<int> new_of(static_cast<std::size_t>(nodes));
    for (int i = 0; i < nodes; ++i) new_of[std::size_t(old_of[i])] = i;

    // Row k of the factor has the columns on the paths of the elimination tree that lead from its entries to k.
    std::vector<int> parent(std::size_t(nodes), -1), seen(std::size_t(nodes), -1);
    std::vector<double> below(std::size_t(nodes), 0);  // blocks below the diagonal, of each column
    for (int k = 0; k < nodes; ++k) {
        seen[std::size_t(k)] = k;
        for (Pattern::InnerIterator it(A, old_of[k]); it; ++it)
            for (int i = new_of[std::size_t(it.row())]; i < k && seen[std::size_t(i)] != k;
                 i = parent[std::size_t(i)]) {
                if (parent[std::size_t(i)] < 0) parent[std::size_t(i)] = k;
                below[std::size_t(i)] += 1;
                seen[std::size_t(i)] = k;
            }
    }
    FactorSize size;
    for (const double blocks : below)
        for (int c = 0; c < 6; ++c) {
            const double column = 6 * blocks + 5 - c;
            size.bytes += column * (sizeof(double) + sizeof(int));
            size.operations += column * column;
        }
    return size;
}

}  // namespace hinge
