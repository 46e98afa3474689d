// Large models: their size, time and memory, before hours of work or the end of the memory. Texts are "" where there is
// nothing to be said.
#pragma once

#include <string>

#include "model/structure.h"

namespace hinge {

/// At 100,000 declared members, and at each doubling.
std::string members_notice(std::size_t members);

/// The members, elements and nodes of a large model, before it is built.
std::string size_notice(const Model& model);

/// The time and memory of a run. Throws InputError if the factors of a static run will not fit into the free memory.
std::string static_notice(const Structure& structure, int steps);
std::string dynamic_notice(const Structure& structure);

}  // namespace hinge
