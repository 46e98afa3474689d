// Command line of the program: its verbs and their options.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "script/lua/sandbox.h"

namespace hinge {

struct Request {
    std::string verb = "run", script, case_name, out, code, search, within, budget, quantity;
    std::vector<std::string> overrides, folders;
    std::map<std::string, std::string> texts;  ///< options of hinge study and hinge render, which Lua reads
    std::optional<int> live_port;              ///< of hinge run --live; 0: any
    bool sandbox = false, effects = false, resume = false, quiet = false, json = false, out_given = false;
    script::Limits limits;
};

/// Declares all verbs; the options of the command line are stored in `request`, but not the verb's name.
void declare_verbs(CLI::App& app, Request& request);

}  // namespace hinge
