// Members that end at nodes which follow others, condensed between the two nodes that they join: an input of conjugate
// gradients.
//
// An end with a joint is a node of one element that moves with a node of the script, its leader, and turns against it
// by springs. All nodes of such a member but its two outer ones are condensed exactly, as inner nodes are in
// condensed.h:
//
//   S = A_ss - A_sf A_ff^-1 A_fs,   x_f = A_ff^-1 (r_f - A_fs x_s),
//
// f: the degrees of freedom within, s: those of the two outer nodes. So a spring that is a thousand times as stiff as
// the member, as for an axis without rotation, costs no iteration. Members at a floor that moves as one are condensed
// likewise: then only their outer nodes are joined to the floor's.
#pragma once

#include <utility>
#include <vector>

#include "algebra/element_matrices.h"
#include "algebra/reduction.h"
#include "core/thread_pool.h"

namespace hinge {

class TiedMembers {
    using ReducedBy = Reduction::ReducedBy;

public:
    TiedMembers(const Structure& structure, ThreadPool& pool) : structure_(structure), pool_(pool) {}

    /// Finds the members that are condensed. `springs`: the blocks of effects between two nodes. Returns whether they
    /// are others than before.
    bool find(const Reduction& reduction, const std::vector<Coupling>& springs, const ElementMatrices& parts);
    bool none() const { return members_.empty(); }
    bool takes_out_node(int node) const { return !members_.empty() && member_of_[node] >= 0; }
    bool takes_out_element(int element) const { return !members_.empty() && element_out_[element]; }
    /// Whether the block between these two nodes is within a member.
    bool takes_in(const Coupling& spring) const { return takes_out_node(spring.a) || takes_out_node(spring.b); }
    const std::vector<char>& nodes_out() const { return node_out_; }
    const std::vector<char>& elements_out() const { return element_out_; }

    /// Condenses those members again of which a node is `dirty` or a spring or a
    /// tie has changed. Calls changed(node) for the
    /// outer nodes of each.
    template <class F>
    void renew(const std::vector<ReducedBy>& reduced_by, const Blocks& given, const ElementMatrices& parts,
               const std::vector<char>& dirty, F changed) {
        for (const int i : condense(reduced_by, given, parts, dirty))
            for (const int node : members_[i].side)
                if (node >= 0) changed(node);
    }
    /// Adds S - A of the outer nodes to the blocks.
    void add_to(Blocks& blocks) const;

    /// Takes the right side of the nodes within to the outer ones.
    void reduce(std::vector<Vec6>& right);
    /// Sets the solution within, where that of all other nodes is known and what follows leaders is set.
    void solve_back(std::vector<Vec6>& x) const;
    /// An element of the member between these two nodes; -1: there is none.
    int element_between(int a, int b) const;

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.pairs_, s.ties_, s.empty_, s.used_);
        if constexpr (A::reading) s.restored_ = true;
    }

private:
    static constexpr int most_nodes = 9, most_free = 6 * most_nodes;  ///< a member of eight elements
    using Columns = Eigen::Matrix<double, Eigen::Dynamic, 12>;
    using FreePart = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_free, 1>;
    using Whole = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_free + 12, most_free + 12>;
    using OfRight = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_free + 12, 1>;

    /// An end that follows its leader.
    struct Follower {
        int node, place;           ///< of the node within the member
        int side;                  ///< of the leader
        int dependent;             ///< its place in the list of those that depend on others
        std::vector<int> springs;  ///< between the two: places in the list of blocks
        int used;                  ///< its place in used_
    };
    struct Member {
        std::vector<int> nodes;  ///< within, in order
        std::vector<int> elements;
        int side[2] = {-1, -1};
        std::vector<Follower> followers;
        bool had_blocks = false;  ///< of its nodes, from effects
        int free_count = 0;
        std::vector<signed char> at;  ///< of each degree of freedom within: its place in f; -1: held or tied
        Columns to_sides;             ///< A_ff^-1 A_fs
        Eigen::MatrixXd by_right;     ///< A_ff^-1 above -A_sf A_ff^-1
        Mat12 S;                      ///< S - A of the outer nodes
        OfRight of_right;             ///< by_right r_f of the solution under way
        Vec12 to_outer;               ///< what the outer nodes get of r_f and of what follows them
    };
    /// What a member was condensed with.
    struct Used {
        Mat12 spring = Mat12::Zero();
        Mat6 tie = Mat6::Zero();
        template <class Self, class A>
        static void fields(Self& s, A& a) {
            a(s.spring, s.tie);
        }
    };

    bool follows(const Reduction& reduction, int node) const;
    bool walk(Member& m, int node, int element, const Reduction& reduction, const ElementMatrices& parts) const;
    std::vector<Member> list(const Reduction& reduction, const std::vector<Coupling>& springs,
                             const ElementMatrices& parts) const;
    std::vector<int> condense(const std::vector<ReducedBy>& reduced_by, const Blocks& given,
                              const ElementMatrices& parts, const std::vector<char>& dirty);
    void condense(Member& m, const std::vector<int>& blocks, const Blocks& given, const ElementMatrices& parts) const;
    static void eliminate(Member& m, const Whole& A, const ElementMatrices& parts);
    static Mat6 tie_of(const Follower& f, const Member& m, const std::vector<ReducedBy>& reduced_by);

    const Structure& structure_;
    ThreadPool& pool_;
    std::vector<Member> members_;
    std::vector<int> member_of_;  ///< of each node: the member that it is within, -1
    std::vector<char> node_out_, element_out_;
    std::vector<std::pair<int, int>> pairs_;  ///< of the springs, when members were found last
    std::vector<std::pair<int, int>> ties_;   ///< node and leader, likewise
    std::vector<char> empty_;                 ///< of each element, likewise
    std::vector<Used> used_;                  ///< of each follower
    bool renew_all_ = true, restored_ = false;
};

}  // namespace hinge
