// Frames of a run, packed for a page: small, and quick to open.
#pragma once

#include <string>
#include <vector>

#include "output/picture.h"
#include "record/events.h"

namespace hinge {

/// Compression level of zlib: 0, none, to 9.
enum class Packing : int { quick = 0, small = 6 };

std::string base64(const std::string& bytes);

/// Packs frames of one model, at least one. `with_model`: also what all of them share, such as which nodes an element
/// joins. The arrays are described in src/viewer/src/run_data.js, which reads them.
Json packed_frames(const std::vector<const output::Snapshot*>& frames, Packing packing, bool with_model = true);

/// True if they can be frames of one model.
bool same_model(const output::Snapshot& a, const output::Snapshot& b);

}  // namespace hinge
