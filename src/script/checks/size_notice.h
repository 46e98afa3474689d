// Large models: how large, how long and how much memory, said before hours of work or the end of the memory.
#pragma once

#include "run/statics.h"
#include "script/lua/objects.h"

namespace hinge::script {

/// While a script declares them: a line at 100,000 members, and at each doubling.
void tell_members(const Context& c, std::size_t members);

/// The members, elements and nodes of a large model, before it is built.
void tell_size(Context& c, const Model& model);

/// What a run of it will take. Throws InputError where the factors of a static run will not fit into the memory that
/// is left.
void weigh_static(Context& c, const Structure& structure, int steps);
void weigh_dynamic(Context& c, const Structure& structure);

}  // namespace hinge::script
