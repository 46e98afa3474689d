// hinge new: a folder with a small project to start from.
#pragma once

#include <string>

namespace hinge {

/// Writes the files of lua/hinge/program/template into a new folder, prints the next steps, and returns the exit
/// status.
int new_project(const std::string& folder);

}  // namespace hinge
