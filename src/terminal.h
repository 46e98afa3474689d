// Reads lines from a terminal with editing, a saved history and completion of names, by libedit.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace hinge {

class Terminal {
public:
    /// Returns the completions of the last word of a line, up to the cursor.
    using Complete = std::function<std::vector<std::string>(const std::string& line)>;

    explicit Terminal(Complete complete);

    /// Reads a line; no value at the end of the input. After Ctrl-C, given_up() is true.
    std::optional<std::string> read(const char* ask);
    bool given_up() const { return given_up_; }

private:
    std::string history_;  ///< its file; empty if there is no folder for one
    bool given_up_ = false;
};

}  // namespace hinge
