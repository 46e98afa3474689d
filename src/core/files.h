// Files that are either whole or not there: written aside, flushed to the disk, then renamed.
#pragma once

#include <string>

namespace hinge {

/// Makes the folder and those above it. Throws OutsideError.
void make_folder(const std::string& path);

/// Replaces `path` by `content`. Throws OutsideError naming what happened; the old file, if any, then stays as it was.
void write_whole(const std::string& path, const std::string& content);

/// Appends and hands to the system: all of it or, with an OutsideError, nothing.
void append(const std::string& path, const std::string& content);

/// All bytes of the file. Throws OutsideError.
std::string read_whole(const std::string& path);

/// What errno says, and what to do about it.
std::string file_trouble(const std::string& doing, const std::string& path, int error);

}  // namespace hinge
