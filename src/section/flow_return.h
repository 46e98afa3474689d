// Return mapping and tangents of elements and pairs whose sections are a FlowProblem.
#pragma once

#include "section/flow_problem.h"
#include "section/section_law.h"

namespace hinge::beam {

/// The flow of an element, from that of `before` or, where it is null, from what the law remembers. Where the strength
/// follows the flow it is found in rounds; with SectionConditions::held in one. Arguments: SectionLaw.
ElementFlow find_flow(const FlowProblem& problem, const Vec6& trial, const Stiffness& k, const double* sections, int n,
                      const SectionConditions& at, const ElementFlow* before);

/// SectionLaw::next_round.
bool next_round(const FlowProblem& problem, const ElementFlow& flow, const SectionConditions& at, double tolerance,
                HeldRound& held);

/// SectionLaw::return_together.
bool return_together(const FlowProblem& problem, const PairElastic& pair, const SectionConditions* at, double tolerance,
                     ElementFlow (&flow)[2]);

/// SectionLaw::tangent.
Mat6 tangent_of_element(const FlowProblem& problem, const ElementFlow& flow, const Stiffness& k, const double* sections,
                        int n, const SectionConditions& at);

/// SectionLaw::pair_tangent.
Mat12 tangent_of_pair(const FlowProblem& problem, const Mat12& elastic, const ElementFlow* const (&flow)[2],
                      const SectionConditions* at);

}  // namespace hinge::beam
