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

/// What joints have come to.
class JointBreaks {
public:
    virtual ~JointBreaks() = default;
    /// The first break at which another joint was close to its own, and how many there were.
    struct Close {
        long times = 0;
        std::string broke, other;  ///< "the joint at end a of member 3"
        int member = -1;           ///< of the one that broke; -1: between nodes
        double part = 0;           ///< of its capacity that the other one had
        double time = 0;           ///< s
    };
    virtual Close close_breaks() const = 0;
    /// A joint that is beyond its capacity.
    struct Beyond {
        std::string joint, reached;  ///< its name; what of it has reached its capacity
        int member = -1;
    };
    virtual std::vector<Beyond> beyond_capacity() const = 0;
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
