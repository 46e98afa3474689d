#include "algebra/tied_members.h"

#include <Eigen/Cholesky>
#include <algorithm>

#include "model/model.h"

namespace hinge {
namespace {

/// Springs that have changed by less than this part of their largest number since a member was condensed stay
/// as they were: the next solution sees the difference in the forces. An axis without rotation has a thousand times the
/// stiffness of its member, so this is a tenth of that of the member. A column lost in a frame of 168 elements: 1e-9,
/// 1e-5, 1e-4 and 1e-3 give the same displacements to 12, 12, 11 and 9 digits, and the same energy error to 4, 4, 3, 2.
constexpr double same_spring = 1e-4;

bool is_same(const Mat12& a, const Mat12& b) {
    return !((a - b).cwiseAbs().maxCoeff() > same_spring * b.cwiseAbs().maxCoeff());
}

/// Whether an end of a member lies beside the node that it follows.
bool has_offset(const Structure& structure, int node) {
    const Element& e = structure.elements()[structure.elements_at(node)[0]];
    const MemberData& member = structure.model().members()[e.member];
    const int end = structure.end_node(e.member, 0) == node ? 0 : 1;
    return structure.position()[node] != structure.model().nodes()[member.node[end]].position;
}

int other_node(const Element& e, int node) { return e.node[0] == node ? e.node[1] : e.node[0]; }

}  // namespace

/// Whether a node is the end of a member that follows a node of the script, in one piece with the member.
bool TiedMembers::follows(const Reduction& reduction, int node) const {
    const int leader = structure_.declared_node(node);
    return reduction.depends(node) && leader >= 0 && leader != node && structure_.elements_at(node).size() == 1;
}

/// Adds a member's inner nodes and elements from `node`, of which `element` leads on, to its other end. False where it
/// has too many, or is broken.
bool TiedMembers::walk(Member& m, int node, int element, const Reduction& reduction,
                       const ElementMatrices& parts) const {
    for (;; element = structure_.elements_at(node)[structure_.elements_at(node)[0] == element ? 1 : 0]) {
        m.nodes.push_back(node), m.elements.push_back(element);
        if (parts.is_cleared(element) || int(m.nodes.size()) > most_nodes) return false;
        node = other_node(structure_.elements()[element], node);
        if (structure_.declared_node(node) >= 0 || structure_.elements_at(node).size() != 2) break;
    }
    m.side[1] = node;
    if (follows(reduction, node)) m.nodes.push_back(node), m.side[1] = structure_.declared_node(node);
    return int(m.nodes.size()) <= most_nodes;
}

/// Members that end at a node which follows others. One is condensed if nothing but its joints joins its inner nodes to
/// others, and if it has few of them.
std::vector<TiedMembers::Member> TiedMembers::list(const Reduction& reduction, const std::vector<Coupling>& springs,
                                                   const ElementMatrices& parts) const {
    std::vector<char> joined(structure_.position().size(), 0);  // by blocks other than springs of joints
    for (const Coupling& c : springs)
        for (const auto& [node, other] : {std::pair(c.a, c.b), std::pair(c.b, c.a)})
            if (structure_.declared_node(node) != other || other == node) joined[node] = 1;
    std::vector<Member> found;
    std::vector<char> taken(joined.size(), 0);
    const auto take = [&](Member& m) {
        if (m.side[0] == m.side[1]) return;
        for (const int side : m.side)
            if (structure_.declared_node(side) != side) return;
        for (std::size_t i = 0; i < m.nodes.size(); ++i) {
            const int n = m.nodes[i];
            if (joined[n] || taken[n]) return;
            if (!reduction.depends(n)) continue;
            if (!follows(reduction, n)) return;
            const int side = structure_.declared_node(n) == m.side[0] ? 0 : 1;
            if (reduction.depends(m.side[side]) && has_offset(structure_, n)) return;
            m.followers.push_back({n, int(i), side, reduction.place_of(n), {}, 0});
        }
        for (const int n : m.nodes) taken[n] = 1;
        found.push_back(std::move(m));
    };
    for (const Reduction::Dependent& d : reduction.dependents()) {
        const int leader = structure_.declared_node(d.node);
        for (const int e : structure_.elements_at(d.node)) {
            const int next = leader == d.node ? other_node(structure_.elements()[e], d.node) : d.node;
            if (taken[next] || (next != d.node && structure_.declared_node(next) >= 0)) continue;
            Member m;
            m.side[0] = leader;
            int onwards = e;
            if (next != d.node) {
                if (parts.is_cleared(e) || structure_.elements_at(next).size() != 2) continue;
                m.elements.push_back(e);
                onwards = structure_.elements_at(next)[structure_.elements_at(next)[0] == e ? 1 : 0];
            }
            if ((next != d.node || follows(reduction, next)) && walk(m, next, onwards, reduction, parts)) take(m);
        }
    }
    return found;
}

bool TiedMembers::find(const Reduction& reduction, const std::vector<Coupling>& springs, const ElementMatrices& parts) {
    std::vector<std::pair<int, int>> pairs, ties;
    for (const Coupling& c : springs) pairs.push_back({c.a, c.b});
    for (const Reduction::Dependent& d : reduction.dependents()) ties.push_back({d.node, d.tied});
    std::vector<char> empty(structure_.elements().size());
    for (std::size_t e = 0; e < empty.size(); ++e) empty[e] = parts.is_cleared(int(e));
    const bool same = pairs == pairs_ && ties == ties_ && empty == empty_;
    if (same && !restored_) return false;
    pairs_ = std::move(pairs), ties_ = std::move(ties), empty_ = std::move(empty);
    members_ = list(reduction, springs, parts);
    member_of_.assign(structure_.position().size(), -1);
    node_out_.assign(member_of_.size(), 0), element_out_.assign(structure_.elements().size(), 0);
    std::size_t ends = 0;
    for (std::size_t i = 0; i < members_.size(); ++i) {
        for (const int n : members_[i].nodes) member_of_[n] = int(i), node_out_[n] = 1;
        for (const int e : members_[i].elements) element_out_[e] = 1;
        for (Follower& f : members_[i].followers) {
            f.used = int(ends++);
            for (std::size_t c = 0; c < springs.size(); ++c)
                if (springs[c].a == f.node || springs[c].b == f.node) f.springs.push_back(int(c));
        }
    }
    if (!same || used_.size() != ends) used_.assign(ends, {});
    renew_all_ = true, restored_ = false;
    return true;
}

std::vector<int> TiedMembers::condense(const std::vector<ReducedBy>& reduced_by, const Blocks& given,
                                       const ElementMatrices& parts, const std::vector<char>& dirty) {
    std::vector<char> asked(members_.size(), renew_all_);
    renew_all_ = false;
    std::vector<std::vector<int>> blocks(members_.size());
    for (std::size_t i = 0; i < given.nodes.size(); ++i)
        if (const int member = member_of_[given.nodes[i].node]; member >= 0)
            blocks[member].push_back(int(i)), asked[member] = 1;
    for (std::size_t i = 0; i < members_.size(); ++i) {
        Member& m = members_[i];
        if (m.had_blocks != !blocks[i].empty()) asked[i] = 1;
        m.had_blocks = !blocks[i].empty();
        for (const int n : m.nodes) asked[i] |= dirty[n];
        for (const Follower& f : m.followers) {
            Used now{Mat12::Zero(), tie_of(f, m, reduced_by)}, &used = used_[f.used];
            for (const int c : f.springs) now.spring += given.pairs[c].K;
            if (now.tie != used.tie) used.tie = now.tie, asked[i] = 1;
            if (!is_same(now.spring, used.spring)) used.spring = now.spring, asked[i] = 1;
        }
    }
    std::vector<int> list;
    for (std::size_t i = 0; i < asked.size(); ++i)
        if (asked[i]) list.push_back(int(i));
    pool_.share(int(list.size()), 8, [&](int first, int end, int) {
        for (int i = first; i < end; ++i) condense(members_[list[i]], blocks[list[i]], given, parts);
    });
    return list;
}

/// A over the nodes within and the two outer ones behind them, with the ties eliminated.
void TiedMembers::condense(Member& m, const std::vector<int>& blocks, const Blocks& given,
                           const ElementMatrices& parts) const {
    const int inner = int(m.nodes.size()), n = 6 * (inner + 2);
    const auto place = [&](int node) {
        for (int i = 0; i < inner; ++i)
            if (m.nodes[i] == node) return 6 * i;
        return 6 * (inner + (node == m.side[1] ? 1 : 0));
    };
    Whole A = Whole::Zero(n, n);
    const auto add = [&](const int(&node)[2], const Mat12& K) {
        const int at[2] = {place(node[0]), place(node[1])};
        for (int i : {0, 1})
            for (int j : {0, 1}) A.block<6, 6>(at[i], at[j]) += K.block<6, 6>(6 * i, 6 * j);
    };
    const std::vector<Element>& elements = structure_.elements();
    for (const int e : m.elements) {
        add(elements[e].node, parts.whole_part(e));
        if (!parts.has_bridges() || elements[e].partner < e) continue;
        const int a = place(elements[e].node[0]), b = place(elements[e + 1].node[1]);
        const Mat6 K = parts.whole_bridge(e);
        A.block<6, 6>(a, b) += K, A.block<6, 6>(b, a) += K.transpose();
    }
    for (int i = 0; i < inner; ++i) A.block<6, 6>(6 * i, 6 * i) += parts.offset_mass(m.nodes[i]);
    for (const int b : blocks)
        A.block<6, 6>(place(given.nodes[b].node), place(given.nodes[b].node)) += given.nodes[b].K;
    for (const Follower& f : m.followers) {
        const Used& used = used_[f.used];
        if (!f.springs.empty()) {
            const Coupling& c = given.pairs[f.springs[0]];
            add({c.a, c.b}, used.spring);
        }
        const int at = 6 * f.place, side = 6 * (inner + f.side);
        for (int tied = 0; tied < 6; ++tied)
            for (int c = 0; c < 6; ++c)
                if (const double by = used.tie(tied, c); by != 0) A.col(side + c) += by * A.col(at + tied);
        for (int tied = 0; tied < 6; ++tied)
            for (int c = 0; c < 6; ++c)
                if (const double by = used.tie(tied, c); by != 0) A.row(side + c) += by * A.row(at + tied);
    }
    eliminate(m, A, parts);
}

/// The Schur complement. `A`: over the nodes within, and the two outer ones behind them.
void TiedMembers::eliminate(Member& m, const Whole& A, const ElementMatrices& parts) {
    const int inner = int(m.nodes.size());
    int free[most_free];
    m.free_count = 0;
    m.at.assign(6 * inner, -1);
    for (int i = 0; i < 6 * inner; ++i) {
        const bool is_free = !(parts.held()[m.nodes[i / 6]] >> (i % 6) & 1);
        if (is_free) m.at[i] = (signed char)m.free_count, free[m.free_count++] = i;
    }
    const int count = m.free_count;
    Eigen::MatrixXd within(count, count);
    Columns across(count, 12);
    for (int i = 0; i < count; ++i) {
        for (int j = 0; j <= i; ++j) within(i, j) = A(free[i], free[j]);
        across.row(i) = A.block<1, 12>(free[i], 6 * inner);
    }
    const Eigen::LDLT<Eigen::MatrixXd> factors(within);
    m.to_sides = factors.solve(across);
    m.by_right.resize(count + 12, count);
    m.by_right.topRows(count) = factors.solve(Eigen::MatrixXd::Identity(count, count));
    m.by_right.bottomRows(12) = -m.to_sides.transpose();
    m.S = A.bottomRightCorner<12, 12>() - across.transpose() * m.to_sides;
}

/// The part of a follower's motion that is its leader's: rows of the tied components.
Mat6 TiedMembers::tie_of(const Follower& f, const Member& m, const std::vector<ReducedBy>& reduced_by) {
    const ReducedBy& by = reduced_by[f.dependent];
    if (by.parts.size() == 1 && by.parts[0].node == m.side[f.side]) return by.parts[0].factors;
    Mat6 tie = Mat6::Zero();  // the leader follows others itself: an end without an offset has its motion
    for (int c = 0; c < 6; ++c) tie(c, c) = by.tied >> c & 1;
    return tie;
}

void TiedMembers::add_to(Blocks& blocks) const {
    for (const Member& m : members_) blocks.pairs.push_back({m.side[0], m.side[1], m.S});
}

void TiedMembers::reduce(std::vector<Vec6>& right) {
    pool_.share(int(members_.size()), 32, [&](int first, int end, int) {
        for (int i = first; i < end; ++i) {
            Member& m = members_[i];
            FreePart of_member(m.free_count);
            for (int k = 0; k < 6 * int(m.nodes.size()); ++k)
                if (m.at[k] >= 0) of_member[m.at[k]] = right[m.nodes[k / 6]][k % 6];
            m.of_right.resize(m.free_count + 12);
            m.of_right.noalias() = m.by_right * of_member;
            m.to_outer = m.of_right.tail<12>();
            for (const Follower& f : m.followers)
                m.to_outer.segment<6>(6 * f.side) += used_[f.used].tie.transpose() * right[f.node];
        }
    });
    for (const Member& m : members_) {
        for (int s : {0, 1}) right[m.side[s]] += m.to_outer.segment<6>(6 * s);
        for (const int n : m.nodes) right[n].setZero();
    }
}

void TiedMembers::solve_back(std::vector<Vec6>& x) const {
    pool_.share(int(members_.size()), 32, [&](int first, int end, int) {
        for (int i = first; i < end; ++i) {
            const Member& m = members_[i];
            Vec12 outer;
            outer << x[m.side[0]], x[m.side[1]];
            const FreePart within = m.of_right.head(m.free_count) - m.to_sides * outer;
            for (int k = 0; k < 6 * int(m.nodes.size()); ++k)
                if (m.at[k] >= 0) x[m.nodes[k / 6]][k % 6] = within[m.at[k]];
        }
    });
}

int TiedMembers::element_between(int a, int b) const {
    for (const Member& m : members_)
        if (m.side[0] == a && m.side[1] == b) return m.elements.front();
    return -1;
}

}  // namespace hinge
