#include "algebra/unsymmetric_pairs.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "core/doing.h"

namespace hinge {

UnsymmetricPairs lowest_of_unsymmetric(const SparseMatrix& K, const SparseMatrix& M, double a, int wanted) {
    const Eigen::Index size = K.rows();
    const Doing doing("the search for natural frequencies,", int(size), "unknowns");
    const Eigen::MatrixXd mass = Eigen::MatrixXd(M).selfadjointView<Eigen::Lower>();
    const Eigen::LLT<Eigen::MatrixXd> root(mass);
    const Eigen::MatrixXd L = root.matrixL();
    const Eigen::MatrixXd inverse = L.transpose() * (Eigen::MatrixXd(K) + a * mass).partialPivLu().solve(L);
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(inverse);
    if (solver.info() != Eigen::Success)
        throw std::runtime_error("the natural frequencies cannot be found: the QR iteration does not converge");
    // 1 / (v + a): those of the highest frequencies are rounding, of either sign
    const Eigen::VectorXcd& inverses = solver.eigenvalues();
    const double least = 1e-11 * inverses.cwiseAbs().maxCoeff();
    std::vector<Eigen::Index> order;
    for (Eigen::Index i = 0; i < size; ++i)
        if (std::abs(inverses[i]) > least) order.push_back(i);
    std::vector<std::complex<double>> values(static_cast<std::size_t>(size));
    for (const Eigen::Index i : order) values[std::size_t(i)] = 1.0 / inverses[i] - a;
    std::stable_sort(order.begin(), order.end(), [&](Eigen::Index i, Eigen::Index j) {
        return values[std::size_t(i)].real() < values[std::size_t(j)].real();
    });
    if (order.size() > std::size_t(wanted)) order.resize(std::size_t(wanted));
    UnsymmetricPairs found;
    found.vectors.resize(size, Eigen::Index(order.size()));
    for (std::size_t k = 0; k < order.size(); ++k) {
        found.values.push_back(values[std::size_t(order[k])]);
        Eigen::VectorXd x = root.matrixU().solve(Eigen::VectorXd(solver.eigenvectors().col(order[k]).real()));
        const double norm = std::sqrt(x.dot(mass * x));
        found.vectors.col(Eigen::Index(k)) = norm > 0 ? Eigen::VectorXd(x / norm) : x;
    }
    return found;
}

double change_by_unsymmetric(const SparseMatrix& K, const SparseMatrix& symmetric, const SparseMatrix& M, double a,
                             const Eigenpairs& found) {
    const SparseMatrix part = 0.5 * (K - SparseMatrix(K.transpose()));
    const Eigen::MatrixXd moved = part * found.vectors, between = found.vectors.transpose() * moved;
    const Eigen::MatrixXd M_found = M.selfadjointView<Eigen::Lower>() * found.vectors;
    const Eigen::SimplicialLDLT<SparseMatrix> factors(symmetric + a * M);
    double most = 0;
    for (std::size_t i = 0; i < found.values.size(); ++i) {
        const Eigen::Index column = Eigen::Index(i);
        // of all other modes as if their values were far above, and of those that are known by their distance
        const Eigen::VectorXd rest = moved.col(column) - M_found * between.col(column);
        double change = rest.dot(factors.solve(rest));
        for (std::size_t j = 0; j < found.values.size(); ++j)
            if (i != j)
                change +=
                    std::pow(between(Eigen::Index(j), column), 2) /
                    std::max(std::abs(found.values[j] - found.values[i]), std::abs(between(Eigen::Index(j), column)));
        most = std::max(most, change / (std::abs(found.values[i]) + 1e-300));
    }
    return most;
}

}  // namespace hinge
