// The search for the flow of a section, or of both sections of an element.
#pragma once

#include "section/flow_end.h"

namespace hinge::beam {

/// Finds the flow of the n ends of an element together, from that of `before` or, where it is null, from what the law
/// remembers: e of `ends`. False: not found.
bool find_flow_of_ends(const FlowProblem& problem, const Vec6& trial, const Stiffness& k, FlowingEnd (&ends)[2], int n,
                       const ElementFlow* before);

}  // namespace hinge::beam
