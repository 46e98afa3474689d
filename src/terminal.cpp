#include "terminal.h"

#include <editline/readline.h>
#include <clocale>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace hinge {
namespace {

namespace fs = std::filesystem;

constexpr int remembered = 1000;  // lines
Terminal::Complete completer;
volatile std::sig_atomic_t stopped = 0;

/// $XDG_STATE_HOME/hinge/history, in a folder made for it; "" where there is none.
std::string history_file() {
    const char *state = std::getenv("XDG_STATE_HOME"), *home = std::getenv("HOME");
    fs::path folder;
    if (state && *state == '/') folder = state;
    else if (home && *home) folder = fs::path(home) / ".local/state";
    else return "";
    std::error_code failed;
    fs::create_directories(folder / "hinge", failed);
    return failed ? "" : folder / "hinge/history";
}

char** complete(const char* word, int, int end) {
    static std::vector<std::string> found;
    static std::size_t next;
    found = completer(std::string(rl_line_buffer, end)), next = 0;
    rl_attempted_completion_over = 1;  // no names of files where there is none of Lua
    return rl_completion_matches(
        word, [](const char*, int) { return next < found.size() ? strdup(found[next++].c_str()) : nullptr; });
}

}  // namespace

Terminal::Terminal(Complete complete_line) : history_(history_file()) {
    completer = std::move(complete_line);
    std::setlocale(LC_CTYPE, "");  // letters beyond ASCII; numbers stay as Lua writes them
    rl_readline_name = "hinge";
    rl_attempted_completion_function = complete;
    rl_completer_word_break_characters = const_cast<char*>(" \t\n\"'`@$><=;|&{}()[]+-*/,%#~^");
    rl_completion_append_character = 0;
    rl_catch_signals = 1;
    using_history();
    stifle_history(remembered);
    if (!history_.empty()) read_history(history_.c_str());
}

std::optional<std::string> Terminal::read(const char* ask) {
    stopped = 0;
    struct sigaction give_up = {}, before;
    give_up.sa_handler = [](int) { stopped = 1; };  // no SA_RESTART: the read ends
    sigaction(SIGINT, &give_up, &before);
    char* typed = readline(ask);
    sigaction(SIGINT, &before, nullptr);
    given_up_ = stopped;
    if (given_up_) std::puts("");
    if (!typed) return given_up_ ? std::optional<std::string>("") : std::nullopt;
    std::string line = typed;
    std::free(typed);
    if (line.find_first_not_of(" \t") == std::string::npos) return line;
    add_history(line.c_str());
    if (!history_.empty()) write_history(history_.c_str());
    return line;
}

}  // namespace hinge
