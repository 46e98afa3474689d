// Whole files, read and written at one go; a file is either the old one or the new one, never half of it.
#pragma once

#include <string>
#include <string_view>

namespace hinge::output {

/// Writes beside the file, syncs, renames. Throws OutsideError saying what happened and what to do.
void write_whole_file(const std::string& path, std::string_view bytes);

std::string read_whole_file(const std::string& path);

}  // namespace hinge::output
