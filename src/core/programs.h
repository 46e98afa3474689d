// Finds installed programs.
#pragma once

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace hinge {

/// Whether a program is a script for another one, as `#!/bin/sh`.
inline bool is_wrapper(const std::string& program) {
    char first[2] = {};
    std::FILE* file = std::fopen(program.c_str(), "rb");
    const bool read = file && std::fread(first, 1, 2, file) == 2;
    if (file) std::fclose(file);
    return read && first[0] == '#' && first[1] == '!';
}

/// The path of a program on PATH (/usr/bin:/bin where that is not set); "" where there is none. `itself`: scripts that
/// start another program are passed over.
inline std::string find_program(const std::string& name, bool itself = false) {
    const char* path = std::getenv("PATH");
    const std::string folders = path ? path : "/usr/bin:/bin";
    for (std::size_t at = 0; at <= folders.size();) {
        const std::size_t end = std::min(folders.find(':', at), folders.size());
        std::string candidate = folders.substr(at, end - at) + "/" + name;
        if (end > at && ::access(candidate.c_str(), X_OK) == 0 && !(itself && is_wrapper(candidate))) return candidate;
        at = end + 1;
    }
    return "";
}

}  // namespace hinge
