#include "algebra/free_unknowns.h"

namespace hinge {

FreeUnknowns::FreeUnknowns(const std::vector<std::uint8_t>& free, const std::vector<LinearConstraint>& constraints)
    : place_(6 * free.size(), -1) {
    for (std::size_t n = 0; n < free.size(); ++n)
        for (int c = 0; c < 6; ++c)
            if (free[n] >> c & 1) place_[6 * n + std::size_t(c)] = rows_++;
    const auto at = [&](const DegreeOfFreedom& of) { return place_[std::size_t(6 * of.node + of.component)]; };
    std::vector<char> depends(std::size_t(rows_), 0);
    for (const LinearConstraint& c : constraints)
        if (at(c.dependent) >= 0) depends[std::size_t(at(c.dependent))] = 1;
    std::vector<int> column(std::size_t(rows_), -1);
    int left = 0;
    Triplets entries;
    for (int i = 0; i < rows_; ++i)
        if (!depends[std::size_t(i)]) column[std::size_t(i)] = left++, entries.emplace_back(i, left - 1, 1.0);
    for (const LinearConstraint& c : constraints)
        for (const LinearConstraint::Term& term : c.terms)
            if (at(c.dependent) >= 0 && at(term.of) >= 0 && column[std::size_t(at(term.of))] >= 0)
                entries.emplace_back(at(c.dependent), column[std::size_t(at(term.of))], term.factor);
    T_.resize(rows_, left);
    T_.setFromTriplets(entries.begin(), entries.end());
}

void FreeUnknowns::add_between(Triplets& to, int a, int b, const Mat6& block) const {
    Mat12 both = Mat12::Zero();
    both.topRightCorner<6, 6>() = block;
    both.bottomLeftCorner<6, 6>() = block.transpose();
    add(to, a, b, both);
}

SparseMatrix FreeUnknowns::whole(const Triplets& of) const {
    SparseMatrix lower(rows_, rows_);
    lower.setFromTriplets(of.begin(), of.end());
    return lower.selfadjointView<Eigen::Lower>();
}

SparseMatrix FreeUnknowns::reduced(const Triplets& of) const {
    const SparseMatrix product = T_.transpose() * whole(of) * T_;
    return product.triangularView<Eigen::Lower>();
}

SparseMatrix FreeUnknowns::reduced_unsymmetric(const Triplets& of) const {
    SparseMatrix all(rows_, rows_);
    all.setFromTriplets(of.begin(), of.end());
    return T_.transpose() * all * T_;
}

std::vector<Vec6> FreeUnknowns::at_nodes(const Eigen::VectorXd& x) const {
    const Eigen::VectorXd all = T_ * x;
    std::vector<Vec6> nodes(place_.size() / 6, Vec6::Zero());
    for (std::size_t i = 0; i < place_.size(); ++i)
        if (place_[i] >= 0) nodes[i / 6][Eigen::Index(i % 6)] = all[place_[i]];
    return nodes;
}

Eigen::VectorXd FreeUnknowns::of_nodes(const std::vector<Vec6>& motion) const {
    Eigen::VectorXd all = Eigen::VectorXd::Zero(rows_);
    for (std::size_t i = 0; i < place_.size(); ++i)
        if (place_[i] >= 0) all[place_[i]] = motion[i / 6][Eigen::Index(i % 6)];
    return all;
}

}  // namespace hinge
