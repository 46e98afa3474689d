// Files that are either whole or not there: written aside, flushed to the disk, then renamed. All throw OutsideError,
// which names what happened and what to do.
#pragma once

#include <string>
#include <string_view>

namespace hinge {

/// Makes the folder and those above it.
void make_folder(const std::string& path);

/// Replaces `path` by `content`; where that fails the old file, if any, stays as it was.
void write_whole(const std::string& path, std::string_view content);

/// Appends and hands to the system: all of it or, with an error, nothing.
void append(const std::string& path, std::string_view content);

/// All bytes of the file, which must be a regular one.
std::string read_whole(const std::string& path);

}  // namespace hinge
