// Stills as VTP, and the collection that lets ParaView play them.
#pragma once

#include <string>
#include <string_view>

#include "output/picture.h"

namespace hinge::output {

std::string encode_snapshot(const Snapshot& snapshot);

/// `name` is the file's, for messages.
Snapshot decode_snapshot(const std::string& bytes, const std::string& name);

std::string encode_collection(int n, const double* times, const char* const* files);

}  // namespace hinge::output
