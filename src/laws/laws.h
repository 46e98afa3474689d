// The laws of sections that there are.
#pragma once

#include <memory>

#include "beam/plastic_domain.h"
#include "beam/section_law.h"

namespace hinge::beam {

/// Eq 14 without hardening. `strength`: fully plastic resultants of the section.
std::unique_ptr<const SectionLaw> paper_law(const YieldSurface& strength);

/// The exact interaction of N, Mx and My. `strength`: Mx0, My0 (N m), N0 (N), Mz0 (N m); Mz0 may be infinite.
std::unique_ptr<const SectionLaw> exact_law(std::shared_ptr<const PlasticDomain> domain, const Vec4& strength);

}  // namespace hinge::beam
