// Writes and reads whole files. A file is written under another name, flushed to the disk, then renamed, so that it is
// never incomplete. All functions throw OutsideError with the cause and a remedy, those that write WriteError.
#pragma once

#include <string>
#include <string_view>

#include "core/errors.h"

namespace hinge {

/// A file or a folder could not be written. The message is "cannot write PATH: why".
struct WriteError : OutsideError {
    WriteError(const std::string& its_path, const std::string& its_why, const char* doing = "cannot write")
        : OutsideError(std::string(doing) + " " + its_path + ": " + its_why), path(its_path), why(its_why) {}
    std::string path, why;
};

/// Makes a folder and its parent folders.
void make_folder(const std::string& path);

/// Replaces the content of a file. If that fails, the old file remains unchanged. Removes what killed processes have
/// left of the same file.
void write_whole(const std::string& path, std::string_view content);

/// Appends to a file: all of `content` or, with an error, nothing.
void append(const std::string& path, std::string_view content);

/// Likewise, to a file that this process began: an error where somebody has removed it since.
void append_to(const std::string& path, std::string_view content);

/// Reads all bytes of a regular file.
std::string read_whole(const std::string& path);

}  // namespace hinge
