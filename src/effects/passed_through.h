// Warns of members that passed through each other because no contact rule is for them.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "effects/reports.h"
#include "effects/workspace.h"

namespace hinge {

/// Finds pairs of members whose axes came nearer than half the sum of their half depths although they were apart where
/// the run began, and for which no rule of model:contact holds. In statics no rule does: there is no contact.
///
/// Not found are pairs that share a node or are joined by a link, members that overlapped from the start, and elements
/// that are broken. Nodes are looked at every few steps, in statics after each; only where one of them has moved by a
/// part of an element are bars compared, over the straight way of their nodes since the last time. It reads the state
/// and changes nothing.
class PassedThrough {
public:
    explicit PassedThrough(const Workspace& w);
    /// Whether there is a pair without a rule.
    static bool is_needed(const Structure& structure, bool dynamic);
    /// After each step.
    void add_step(double time);
    /// One warning, of the first pair, with the others counted.
    void check_run(double time, std::vector<RunWarning>& list) const;

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.since_, s.start_, s.last_, s.found_);
    }
    bool makes_sense() const;

private:
    /// Where a pair of members met.
    struct Meeting {
        double time = 0;  ///< s
        Vec3 at = Vec3::Zero();
        template <class Self, class A>
        static void fields(Self& s, A& a) {
            a(s.time, s.at);
        }
    };
    using Found = std::map<std::pair<int, int>, Meeting>;  ///< by members, the smaller index first
    struct Bar {
        int element;
        Vec3 low, high;  ///< of the box around its way, m
        double moved;    ///< m, at most
    };
    double moved_since_last() const;
    Vec3 place(int node, const std::vector<Vec3>& displacement) const;
    void list_bars(std::vector<Bar>& bars) const;
    void compare(double time, Found& found) const;
    void compare(const Bar& a, const Bar& b, double time, Found& found) const;
    bool may_meet(int member_a, int member_b) const;

    const Workspace& w_;
    double enough_ = 0;                        ///< m of motion, after which bars are compared
    double thinnest_ = 0;                      ///< m, the smallest half depth
    std::vector<std::pair<int, int>> linked_;  ///< members that a link joins, sorted
    int since_ = 0;                            ///< steps since nodes were looked at
    std::vector<Vec3> start_, last_;  ///< m, displacements where the run began, and where bars were last compared
    Found found_;
};

}  // namespace hinge
