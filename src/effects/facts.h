// Facts that effects have of a run, for advice: an effect that has them implements the class, and EffectList::facts
// finds it.
#pragma once

#include <string>
#include <vector>

namespace hinge {

/// How often the functions of fracture rules were called, by rule.
class RuleCalls {
public:
    virtual ~RuleCalls() = default;
    virtual const std::vector<long>& calls() const = 0;
};

/// Joints, by their number in the order of declaration.
class JointBreaks {
public:
    virtual ~JointBreaks() = default;
    /// The first break at which another joint was close to its own, and how many there were.
    struct Close {
        long times = 0;
        std::size_t broke = 0, other = 0;
        double part = 0;  ///< of its capacity that the other one had
        double time = 0;  ///< s
        template <class Self, class A>
        static void fields(Self& s, A& a) {
            a(s.times, s.broke, s.other, s.part, s.time);
        }
    };
    virtual const Close& close_break() const = 0;
    /// Those that are beyond their capacity.
    virtual std::vector<std::size_t> beyond_capacity() const = 0;
    virtual std::string name_of(std::size_t joint) const = 0;     ///< "the joint at end a of member 3"
    virtual std::string reached_by(std::size_t joint) const = 0;  ///< what of it has reached its capacity
    virtual int member_of(std::size_t joint) const = 0;           ///< -1: between nodes
};

/// Elements whose damping by beta took their whole rate of deformation, the plastic one with it.
class WholeRates {
public:
    virtual ~WholeRates() = default;
    struct Counts {
        int elements = 0;      ///< with more than a few such steps
        int first = -1;        ///< of those
        double most_part = 0;  ///< of the steps in which one flowed
    };
    virtual Counts whole_rates() const = 0;
};

}  // namespace hinge
