// The command line of the program: its verbs, and the values of their options.
#pragma once

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

struct CommandLine {
    Request request;
    std::vector<std::string> verbs;  ///< names of all verbs
    bool named = false;              ///< it begins with a verb or an option, not with a script
    std::string unknown_verb;        ///< of `hinge help VERB`, where there is no such verb; else ""
    std::string completion;          ///< the shell script of `hinge completion SHELL`
    std::optional<int> status;       ///< the program ends with this status: after --help, or with an error
};

/// Reads the words after the program's name. Prints help and errors of options itself, and sets `status` then.
CommandLine read_command_line(std::vector<std::string> words);

}  // namespace hinge
