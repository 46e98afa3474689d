// History of each joint: first yield, largest rotations, moments and forces, dissipated energy.
#pragma once

#include <algorithm>
#include <vector>

namespace hinge {

/// The name under which the state keeps JointRecords.
inline constexpr const char* joint_records = "joint_records";

/// The larger of `so_far` and the size of `value`; a value that is no number is kept, so that no limit lets it pass.
inline void keep_largest(double& so_far, double value) {
    const double size = value < 0 ? -value : value;
    if (!(size <= so_far)) so_far = size;
}

/// A joint up to the last step that was kept.
struct JointRecord {
    /// About one axis. It yields where the elastic part of its curve ends.
    struct Axis {
        double largest = 0;    ///< rad, of either sign
        double moment = 0;     ///< N m, likewise
        double work = 0;       ///< J, dissipated
        bool yielded = false;  ///< ever
        bool statics = false;  ///< it first yielded in statics
        int runs_ago = 0;      ///< 0: in this run; 1: in the one that this run goes on from, ...
        double first = 0;      ///< when: s; in statics the load factor

        template <class Self, class A>
        static void fields(Self& s, A& a) {
            a(s.largest, s.moment, s.work, s.yielded, s.statics, s.runs_ago, s.first);
        }
    };
    Axis axis[3];
    double bent = 0;                ///< rad, about x and y together, of those that are springs
    double tension = 0, shear = 0;  ///< N

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.axis, s.bent, s.tension, s.shear);
    }
};

/// Of all joints, as they are declared.
struct JointRecords {
    static constexpr bool in_state_hash = false;  ///< they change nothing
    std::vector<JointRecord> list;

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.list);
    }
    /// Called where a run goes on from another one.
    void one_run_later() {
        for (JointRecord& record : list)
            for (JointRecord::Axis& axis : record.axis) ++axis.runs_ago;
    }
};

}  // namespace hinge
