// History of each plastic hinge: first yield, rotation, dissipated energy.
#pragma once

#include <algorithm>
#include <vector>

#include "state/element_assembly.h"

namespace hinge {

/// The name under which the state keeps HingeRecords.
inline constexpr const char* hinge_records = "plasticity";

/// A section of a member that has ever been fully plastic. Where two elements of a member meet there is one section,
/// though both of them may flow in it: it is end 2 of the first of them.
struct HingeRecord {
    int element = 0, end = 0;     ///< its place: end 1 or 2 of the element; 0: the middle of a conventional one
    bool statics = false;         ///< it first yielded in statics
    int runs_ago = 0;             ///< 0: in this run; 1: in the one that this run goes on from, ...
    double first = 0;             ///< when: s; in statics the load factor
    double rotation[2] = {0, 0};  ///< rad, plastic, about x and y; positive like the curvature
    double largest = 0;           ///< rad, of both together, the most so far
    double elongation = 0;        ///< m, its part of the element's plastic elongation
    double work = 0;              ///< J, dissipated
    /// Where two elements of a member meet: what the second of them has of rotation (x, y) and elongation.
    double of_next[3] = {0, 0, 0};

    long place() const { return 3L * element + end; }

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.element, s.end, s.statics, s.runs_ago, s.first, s.rotation, s.largest, s.elongation, s.work, s.of_next);
    }
};

/// Records of all hinges, in the order of their places.
struct HingeRecords {
    static constexpr bool in_state_hash = false;  ///< they follow from the flow, and the hash has what it leads to
    std::vector<HingeRecord> list;

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.list);
    }
    bool makes_sense(int elements) const {
        const auto good = [elements](const HingeRecord& h) {
            return h.element >= 0 && h.element < elements && h.end >= 0 && h.end <= 2;
        };
        return std::all_of(list.begin(), list.end(), good) &&
               std::is_sorted(list.begin(), list.end(),
                              [](const HingeRecord& a, const HingeRecord& b) { return a.place() < b.place(); });
    }
};

/// A section's part in the flow of one element.
struct HingePart {
    int element, end;  ///< as in HingeRecord
    bool of_next;      ///< the element that flows is the second of two that meet there
    double rotation[2], share;
    double elongation;  ///< m, without slack
};
/// The part of the section at end 1 or 2 of the element that flows; 0: of a conventional element's middle.
HingePart part_of(const Structure& structure, const PlasticIncrement& flow, int end);

/// Plastic rotation about x and y (rad; positive like the curvature) and elongation (m) of a section, as far as they
/// are those of one element: at its end 1 or 2; of a conventional element at its middle, for either end.
struct HingeMotion {
    double rotation[2] = {0, 0}, elongation = 0;
    HingeMotion& operator+=(const HingeMotion& other) {
        for (int plane : {0, 1}) rotation[plane] += other.rotation[plane];
        elongation += other.elongation;
        return *this;
    }
};
HingeMotion motion_of(const Structure& structure, const HingeRecords* records, int element, int end);

/// Records plastic flow in a committed step. `at`: its end, s or load factor. Costs nothing without flow.
void record_flow(const Structure& structure, const std::vector<PlasticIncrement>& yielding, double at, bool statics,
                 HingeRecords& records);

}  // namespace hinge
