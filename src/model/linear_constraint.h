// A linear constraint between degrees of freedom: one of them, the dependent one, is a sum of others, each with a
// factor. A rigid link and a diaphragm are lists of them.
#pragma once

#include <vector>

#include "core/types.h"

namespace hinge {

struct DegreeOfFreedom {
    int node = 0, component = 0;  ///< component 0 to 5: ux uy uz rx ry rz
};

/// u(dependent) = sum of factor u(of), for small changes of the displacements where the structure is; m and rad.
struct LinearConstraint {
    struct Term {
        DegreeOfFreedom of;
        double factor;
    };
    const char* declared_by;  ///< the call that declares it, for messages
    DegreeOfFreedom dependent;
    std::vector<Term> terms;
};

}  // namespace hinge
