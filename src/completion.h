// Shell completion for `hinge`: makes a script from the verbs and options of --help.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace hinge {

/// The supported shells.
inline const std::vector<std::string> completed_shells = {"bash", "fish", "zsh"};

std::string completion_script(const CLI::App& app, const std::string& shell);

}  // namespace hinge
