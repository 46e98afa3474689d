// Virtual X server (Xvfb) for machines without a display.
#include "output/xvfb.h"

#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <condition_variable>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "core/errors.h"
#include "core/programs.h"

namespace hinge::output {
namespace {

constexpr int start_timeout_ms = 30000;
constexpr int displayfd = 3;
constexpr int first_inherited = displayfd + 1;

/// Shared with the keeper thread, which may outlive everything else.
struct Server {
    std::mutex guard;
    std::condition_variable launched;
    pid_t owner = 0;  ///< the process that started it: a fork must neither use nor kill it
    pid_t pid = 0;    ///< 0: has ended
    bool tried = false;
    std::string display;
};

std::shared_ptr<Server> current;  // guarded by the module's one lock

struct Pipes {
    int number[2] = {-1, -1};  ///< Xvfb writes the display's number into [1]
    int null = -1, log = -1;

    Pipes() {
        if (::pipe2(number, O_CLOEXEC) != 0) number[0] = number[1] = -1;
        null = ::open("/dev/null", O_RDWR | O_CLOEXEC);
        log = ::memfd_create("xvfb-log", MFD_CLOEXEC);
    }
    ~Pipes() {
        for (const int fd : {number[0], number[1], null, log})
            if (fd >= 0) ::close(fd);
    }
    bool complete() const { return number[0] >= 0 && null >= 0 && log >= 0; }
};

/// Between fork and exec: only calls that are safe after a fork in a threaded process.
[[noreturn]] void become(const char* program, char* const* words, const Pipes& pipes, pid_t parent) {
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (::getppid() != parent) ::_exit(127);
    // Ctrl-C and a job's stop signal belong to the run, which may still want to draw what it has.
    ::setsid();
    sigset_t none;
    ::sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
    // Copies above the targets first, so that no dup2 overwrites one that is still to be used.
    const int number = ::fcntl(pipes.number[1], F_DUPFD, 16);
    const int null = ::fcntl(pipes.null, F_DUPFD, 16);
    const int log = ::fcntl(pipes.log, F_DUPFD, 16);
    ::dup2(null, 0);
    ::dup2(null, 1);
    ::dup2(log, 2);
    ::dup2(number, displayfd);
    ::close_range(first_inherited, ~0U, 0);
    ::execv(program, words);
    ::_exit(127);
}

/// Starts Xvfb and waits for its end. A thread of its own because the kernel ends the child when the *thread* that
/// started it ends, which for a caller's worker thread may be long before the process does.
void keep(const std::shared_ptr<Server>& server, const Pipes& pipes, const std::string& program) {
    std::vector<std::string> text = {"Xvfb",      "-displayfd", std::to_string(displayfd),
                                     "-screen",   "0",          "1600x1200x24",
                                     "-nolisten", "tcp",        "-noreset"};
    std::vector<char*> words;
    for (std::string& word : text) words.push_back(word.data());
    words.push_back(nullptr);
    const pid_t parent = ::getpid();
    const pid_t pid = ::fork();
    if (pid == 0) become(program.c_str(), words.data(), pipes, parent);
    {
        const std::lock_guard lock(server->guard);
        server->pid = pid > 0 ? pid : 0;
        server->tried = true;
    }
    server->launched.notify_all();  // `pipes` and `program` may be gone from here on
    if (pid < 0) return;
    siginfo_t how;
    while (::waitid(P_PID, static_cast<id_t>(pid), &how, WEXITED | WNOWAIT) != 0 && errno == EINTR) {}
    // Reaped under the lock, so that nobody signals a process id that is no longer ours.
    const std::lock_guard lock(server->guard);
    ::waitpid(pid, nullptr, WNOHANG);
    server->pid = 0;
}

/// A thread started meanwhile takes no signals meant for the program's own threads.
class BlockedSignals {
public:
    BlockedSignals() {
        sigset_t all;
        ::sigfillset(&all);
        ::pthread_sigmask(SIG_SETMASK, &all, &before_);
    }
    ~BlockedSignals() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    BlockedSignals(const BlockedSignals&) = delete;
    BlockedSignals& operator=(const BlockedSignals&) = delete;

private:
    sigset_t before_;
};

void launch(const std::shared_ptr<Server>& server, const Pipes& pipes, const std::string& program) {
    {
        const BlockedSignals blocked;
        std::thread([server, &pipes, &program] { keep(server, pipes, program); }).detach();
    }
    std::unique_lock lock(server->guard);
    server->launched.wait(lock, [&] { return server->tried; });
}

void stop(Server& server) {
    const std::lock_guard lock(server.guard);
    if (server.owner == ::getpid() && server.pid > 0) ::kill(server.pid, SIGTERM);
}

void stop_current() {
    if (current) stop(*current);
}

std::string read_number(int fd) {
    std::string number;
    pollfd ready{fd, POLLIN, 0};
    while (number.find('\n') == std::string::npos) {
        const int n = ::poll(&ready, 1, start_timeout_ms);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return {};
        char text[32];
        const ssize_t size = ::read(fd, text, sizeof text);
        if (size <= 0) return {};
        number.append(text, static_cast<std::size_t>(size));
    }
    return number.substr(0, number.find('\n'));
}

std::string last_words(int log) {
    std::string text(4096, '\0');
    const off_t end = ::lseek(log, 0, SEEK_END);
    const off_t from = std::max<off_t>(0, end - static_cast<off_t>(text.size()));
    const ssize_t n = ::pread(log, text.data(), text.size(), from);
    text.resize(n > 0 ? static_cast<std::size_t>(n) : 0);
    while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
    const auto line = text.rfind('\n');
    return line == std::string::npos ? text : text.substr(line + 1);
}

}  // namespace

std::string virtual_display() {
    if (current && current->owner == ::getpid()) {
        const std::lock_guard lock(current->guard);
        if (current->pid > 0) return current->display;
    }
    const std::string program = find_program("Xvfb");
    if (program.empty())
        throw OutsideError(
            "pictures need a display, and neither DISPLAY nor Xvfb is at hand; "
            "get one with: apt-get install xvfb");
    Pipes pipes;
    if (!pipes.complete())
        throw OutsideError("cannot start Xvfb for pictures: no file descriptors left; raise the limit (ulimit -n)");
    static const int at_exit = std::atexit(stop_current);
    (void)at_exit;

    const auto server = std::make_shared<Server>();
    server->owner = ::getpid();
    launch(server, pipes, program);
    ::close(pipes.number[1]);  // so that reading ends if Xvfb does
    pipes.number[1] = -1;
    const std::string number = read_number(pipes.number[0]);
    if (number.empty()) {
        stop(*server);
        const std::string words = last_words(pipes.log);
        throw OutsideError("cannot start Xvfb for pictures" + (words.empty() ? "" : " (" + words + ")") + "; run '" +
                           program + " :99' to see why, or set DISPLAY to a display that works");
    }
    {
        const std::lock_guard lock(server->guard);
        server->display = ":" + number;
    }
    current = server;
    return server->display;
}

}  // namespace hinge::output
