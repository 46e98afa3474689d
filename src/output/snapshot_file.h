// Snapshots as VTP files, and the collection file for an animation in ParaView.
#pragma once

#include <string>
#include <string_view>

#include "output/picture.h"

namespace hinge::output {

std::string encode_snapshot(const Snapshot& snapshot);

/// Decodes a VTP file. `name`: name of the file, for messages.
Snapshot decode_snapshot(const std::string& bytes, const std::string& name);

std::string encode_collection(int n, const double* times, const char* const* files);

}  // namespace hinge::output
