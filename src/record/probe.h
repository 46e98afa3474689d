// A quantity of a node that is recorded at every step.
#pragma once

#include <string>
#include <vector>

namespace hinge {

class Run;

/// A quantity of a node, or its difference between two nodes, recorded at every step.
struct Probe {
    int node;
    enum class Quantity { displacement, velocity, acceleration, reaction } quantity;
    int component;  ///< 0 to 2: along x, y, z; 3 to 5: about them
    std::string name;
    std::vector<double> time, value;
    int relative_to = -1;  ///< the node whose value is subtracted, -1: none
    double height = 0;     ///< m, divisor of the difference for a drift; 0: none
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.node, s.quantity, s.component, s.name, s.time, s.value, s.relative_to, s.height);
    }
};

double value_of(const Run& run, const Probe& probe);  ///< the probe's quantity now
double abscissa(const Run& run);                      ///< time, s; in statics the load factor
const char* unit_of(const Probe& probe);              ///< "m", "rad", "m/s", ..., "N m"

/// Names of nodal quantities for probes and run:read: displacement, velocity, acceleration and reaction, six each, in
/// the order of Probe::Quantity.
const std::vector<std::string>& node_quantities();

}  // namespace hinge
