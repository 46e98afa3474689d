// Elimination of degrees of freedom that depend on others: u = T q, with q those that are left.
//
// With F - R at the nodes and a matrix A of all degrees of freedom (K in statics, M + beta dt^2 K in Newmark's method,
// M for accelerations) the equation that is solved is
//
//   T^T A T q = T^T (F - R)
//
// and the nodes move by T q. The forces of the constraints, A u - (F - R), do no work in any motion T q. Vectors and
// matrices keep their size: a degree of freedom that depends on others is treated as one that is held.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/linear_constraint.h"
#include "model/structure.h"

namespace hinge {

class Reduction {
public:
    /// `held`: six bits a node. Throws InputError where a degree of freedom is held or depends on others twice, and
    /// where one on which others depend depends on others itself.
    Reduction(const Structure& structure, const std::vector<std::uint8_t>& held,
              const std::vector<LinearConstraint>& constraints);
    /// Throws InputError where one of these (six bits a node) depends on others.
    void refuse_held(const std::vector<std::uint8_t>& held) const;
    /// Takes new factors. The constraints tie the same degrees of freedom to the same nodes as before.
    void renew(const std::vector<LinearConstraint>& constraints);

    /// Factors that have changed by less than this (rad, or that part of a lever) may stay as they were in the matrix
    /// of conjugate gradients. With 1e-3 the moments in a free body with a rigid link are off by 2e-5.
    static constexpr double same_factors = 1e-5;

    /// The part of a node's motion that follows from another node's: factors * u(node).
    struct Part {
        int node;
        Mat6 factors;  ///< rows of the dependent components
        template <class Self, class A>
        static void fields(Self& s, A& a) {
            a(s.node, s.factors);
        }
    };
    struct Dependent {
        int node;
        std::uint8_t tied;  ///< six bits: the components that depend on others
        std::vector<Part> parts;
        const char* declared_by;
    };
    /// The same, as a matrix was reduced with it.
    struct ReducedBy {
        int node = 0;
        std::uint8_t tied = 0;
        std::vector<Part> parts;
        template <class Self, class A>
        static void fields(Self& s, A& a) {
            a(s.node, s.tied, s.parts);
        }
    };
    const std::vector<Dependent>& dependents() const { return dependents_; }
    /// The components of a node that depend on others, six bits.
    std::uint8_t tied(int node) const { return which_[node] < 0 ? 0 : dependents_[which_[node]].tied; }
    bool depends(int node) const { return which_[node] >= 0; }
    /// Its place in the list of those that depend on others; -1: it does not.
    int place_of(int node) const { return which_[node]; }
    /// Whether a constraint has the node, as one that depends or as one on which others depend.
    bool joins(int node) const { return joins_[node]; }
    /// Nodes that constraints join, rising: dependent ones and those on which they depend.
    const std::vector<std::vector<int>>& groups() const { return groups_; }

    /// T^T f in place: the forces of dependent components go to the nodes on which they depend.
    void reduce(std::vector<Vec6>& f) const;
    /// T u in place: sets the dependent components.
    void expand(std::vector<Vec6>& u) const;

    /// T^T A T of the block of A at two nodes, less that part of it which stays where it is: calls add(p, q, block).
    template <class F>
    void spread(int a, int b, const Mat6& block, F add) const {
        if (!depends(a) && !depends(b)) return;
        const Parts of_a = parts_of(a), of_b = parts_of(b);
        for (const Part& p : of_a)
            for (const Part& q : of_b)
                if (p.node != a || q.node != b) add(p.node, q.node, Mat6(p.factors.transpose() * block * q.factors));
    }

private:
    using Parts = std::vector<Part>;
    Parts parts_of(int node) const;
    void find_groups();

    const Structure* structure_;
    std::vector<int> which_;  ///< of each node: its place in dependents_, -1
    std::vector<Dependent> dependents_;
    std::vector<std::vector<int>> groups_;
    std::vector<char> joins_;  ///< of each node
};

}  // namespace hinge
