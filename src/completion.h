// What a shell completes after `hinge`: a script for it, made from the verbs and options that --help tells of.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace hinge {

/// The shells that there is a script for.
inline const std::vector<std::string> completed_shells = {"bash", "fish", "zsh"};

std::string completion_script(const CLI::App& app, const std::string& shell);

}  // namespace hinge
