// Large models: prints size, time and memory before hours of work or the end of the memory.
#pragma once

#include "run/statics.h"
#include "record/context.h"
#include "record/run_record.h"

namespace hinge {

/// Prints a line at 100,000 declared members, and at each doubling.
void tell_members(const Context& c, std::size_t members);

/// Prints the members, elements and nodes of a large model, before it is built.
void tell_size(Context& c, const Model& model);

/// Prints the time and memory of a run. Throws InputError if the factors of a static run will not fit into the free
/// memory.
void weigh_static(Context& c, const Structure& structure, int steps);
void weigh_dynamic(Context& c, const Structure& structure);

}  // namespace hinge
