// Frames of a run as a page takes them: small, and quick to open.
#pragma once

#include <vector>

#include "output/picture.h"
#include "script/record/events.h"

namespace hinge::script {

/// How hard zlib tries: 0, not at all, to 9.
enum class Packing : int { quick = 0, small = 6 };

/// Frames of one model; there is at least one. `with_model`: also what all of them share, such as which nodes an
/// element joins. The arrays are described in src/viewer/src/run_data.js, which reads them.
Json packed_frames(const std::vector<const output::Snapshot*>& frames, Packing packing, bool with_model = true);

/// Whether they can be frames of one model.
bool same_model(const output::Snapshot& a, const output::Snapshot& b);

}  // namespace hinge::script
