// Lines typed at a terminal: editing, a history that outlives the session, and completion of names. By libedit.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace hinge {

class Terminal {
public:
    /// What the last word of a line, up to the cursor, may become.
    using Complete = std::function<std::vector<std::string>(const std::string& line)>;

    explicit Terminal(Complete complete);

    /// One line; nothing at the end of the input. A line given up with Ctrl-C is `given_up`.
    std::optional<std::string> read(const char* ask);
    bool given_up() const { return given_up_; }

private:
    std::string history_;  ///< its file; empty where there is no place for one
    bool given_up_ = false;
};

}  // namespace hinge
