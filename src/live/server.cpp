#include "live/server.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <vector>

#include "core/errors.h"
#include "live/http.h"

namespace hinge::live {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr std::size_t most_clients = 16;
constexpr auto for_goodbye = milliseconds(1000), at_end = milliseconds(300), without_files = milliseconds(500);

/// A connection with one request, and the stage that the request has reached.
struct Client {
    enum class Stage { reading, waiting, writing, leaving } stage = Stage::reading;
    int fd;
    Clock::time_point until;              ///< it is given up
    std::string head = {}, heading = {};  ///< of the request; of the answer
    Request request = {};
    std::shared_ptr<const std::string> body = {};
    std::size_t sent = 0;  ///< of heading and body
};

/// The connections, and the loop of the server's thread.
class Work {
public:
    Work(int listener, int alarm, const std::atomic<bool>& ending, std::atomic<int>& waiting, const Handler& handler,
         const Limits& limits)
        : listener_(listener), alarm_(alarm), ending_(ending), waiting_(waiting), handler_(handler), limits_(limits) {}
    ~Work() {
        for (Client& c : clients_) ::close(c.fd);
    }

    void run() {
        std::optional<Clock::time_point> end;
        for (;;) {
            const auto now = Clock::now();
            if (ending_ && !end) end = now + at_end;
            if (end && (now > *end || !anything_to_send())) return;
            wait_and_serve(now, end.has_value());
        }
    }

private:
    bool anything_to_send() const {
        return std::any_of(clients_.begin(), clients_.end(),
                           [](const Client& c) { return c.stage == Client::Stage::writing; });
    }

    /// Waits until something happens, and does what is due.
    void wait_and_serve(Clock::time_point now, bool is_end) {
        std::vector<pollfd> watched = {{alarm_, POLLIN, 0}};
        const bool listens = !is_end && now >= deaf_until_;
        if (listens) watched.push_back({listener_, POLLIN, 0});
        const std::size_t before = watched.size();
        auto first = now + milliseconds(is_end ? 20 : 60000);
        if (!is_end && !listens) first = deaf_until_;
        for (const Client& c : clients_) {
            watched.push_back({c.fd, short(c.stage == Client::Stage::writing ? POLLOUT : POLLIN), 0});
            first = std::min(first, c.until);
        }
        const auto pause = std::chrono::duration_cast<milliseconds>(first - now).count() + 1;
        if (::poll(watched.data(), nfds_t(watched.size()), int(std::max<long>(0, pause))) < 0) return;
        for (std::size_t i = 0; i < clients_.size(); ++i)
            if (watched[before + i].revents) serve(clients_[i]);
        if (watched[0].revents) tell_news();
        now = Clock::now();
        for (Client& c : clients_)
            if (now >= c.until) give_up(c);
        std::erase_if(clients_, [](const Client& c) { return c.fd < 0; });
        waiting_ = int(std::count_if(clients_.begin(), clients_.end(),
                                     [](const Client& c) { return c.stage == Client::Stage::waiting; }));
        if (listens && watched[1].revents) take_in(now);  // one at a time: meanwhile others may have gone
    }

    void take_in(Clock::time_point now) {
        const int fd = ::accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
        if (fd < 0) {
            if (errno == EMFILE || errno == ENFILE || errno == ENOMEM || errno == ENOBUFS)
                deaf_until_ = now + without_files;  // poll would report the same client again and again
            return;
        }
        if (clients_.size() < most_clients) return void(clients_.push_back({.fd = fd, .until = now + limits_.request}));
        const std::string busy = heading_of({503, "text/plain", nullptr});
        if (::send(fd, busy.data(), busy.size(), MSG_NOSIGNAL) < 0) {}  // it is turned away, with or without a word
        ::close(fd);
    }

    void serve(Client& c) {
        switch (c.stage) {
            case Client::Stage::reading: return read(c);
            case Client::Stage::writing: return write(c);
            case Client::Stage::waiting:
            case Client::Stage::leaving: return ignore(c);
        }
    }

    void read(Client& c) {
        char some[4096];
        const ssize_t n = ::recv(c.fd, some, sizeof some, 0);
        if (n < 0 && (errno == EAGAIN || errno == EINTR)) return;
        if (n <= 0) return drop(c);
        c.head.append(some, std::size_t(n));
        const auto end = c.head.find("\r\n\r\n");
        if (end == std::string::npos && c.head.size() <= longest_head) return;
        const int status = end == std::string::npos ? 431 : read_head(c.head.substr(0, end + 2), c.request);
        if (status != 200) return answer(c, refusal(status));
        ask(c, true);
    }

    /// Asks for the answer; `first`: it may wait.
    void ask(Client& c, bool first) {
        if (auto given = handler_(c.request)) return answer(c, *given);
        if (!first) return;
        c.stage = Client::Stage::waiting;
        c.until = Clock::now() + limits_.news;
    }

    void answer(Client& c, const Answer& given) {
        c.heading = heading_of(given);
        c.body = given.body;
        c.stage = Client::Stage::writing;
        c.until = Clock::now() + limits_.progress;
        write(c);
    }

    void write(Client& c) {
        const std::size_t body = c.body ? c.body->size() : 0, all = c.heading.size() + body;
        while (c.sent < all) {
            const bool in_heading = c.sent < c.heading.size();
            const char* from = in_heading ? c.heading.data() + c.sent : c.body->data() + (c.sent - c.heading.size());
            const std::size_t n = in_heading ? c.heading.size() - c.sent : all - c.sent;
            const ssize_t went = ::send(c.fd, from, n, MSG_NOSIGNAL | (in_heading && body ? MSG_MORE : 0));
            if (went < 0 && errno == EINTR) continue;
            if (went < 0 && errno == EAGAIN) return;
            if (went <= 0) return drop(c);
            c.sent += std::size_t(went);
            c.until = Clock::now() + limits_.progress;
        }
        c.body = nullptr;
        ::shutdown(c.fd, SHUT_WR);  // and not close: that would take back the answer where the client has said more
        c.stage = Client::Stage::leaving;
        c.until = Clock::now() + for_goodbye;
    }

    /// Reads further bytes of a client after its request, and its end.
    void ignore(Client& c) {
        char some[4096];
        const ssize_t n = ::recv(c.fd, some, sizeof some, 0);
        if (n == 0 || (n < 0 && errno != EAGAIN && errno != EINTR)) drop(c);
    }

    void tell_news() {
        std::uint64_t count;
        if (::read(alarm_, &count, sizeof count) < 0) return;
        for (Client& c : clients_)
            if (c.stage == Client::Stage::waiting) ask(c, false);
    }

    void give_up(Client& c) {
        if (c.stage == Client::Stage::waiting) answer(c, {204, "text/plain", nullptr});
        else if (c.fd >= 0) drop(c);
    }

    static void drop(Client& c) {
        ::close(c.fd);
        c.fd = -1;
        c.until = Clock::time_point::max();
        c.stage = Client::Stage::leaving;
    }

    const int listener_, alarm_;
    const std::atomic<bool>& ending_;
    std::atomic<int>& waiting_;
    const Handler& handler_;
    const Limits& limits_;
    Clock::time_point deaf_until_ = {};
    std::vector<Client> clients_;
};

[[noreturn]] void cannot_listen(int port, int error) {
    const std::string where = port > 0 ? " at port " + std::to_string(port) : "";
    const char* advice = error == EADDRINUSE ? "; another program has that port: give another one, or --live alone"
                         : error == EACCES   ? "; give a port from 1024 on, or --live alone"
                                             : "";
    throw OutsideError("--live: cannot listen on 127.0.0.1" + where + ": " + std::strerror(error) + advice);
}

int loopback_listener(int& port) {
    const int fd = ::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (fd < 0) cannot_listen(port, errno);
    sockaddr_in address = {};
    address.sin_family = AF_INET;
    address.sin_port = htons(std::uint16_t(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const int again = 1;  // also while connections of a program before are being forgotten
    ::setsockopt(fd, SOL_SOCKET, SO_REUSEADDR, &again, sizeof again);
    socklen_t size = sizeof address;
    auto* general = reinterpret_cast<sockaddr*>(&address);
    if (::bind(fd, general, size) != 0 || ::listen(fd, 64) != 0 || ::getsockname(fd, general, &size) != 0) {
        const int error = errno;
        ::close(fd);
        cannot_listen(port, error);
    }
    port = ntohs(address.sin_port);
    return fd;
}

}  // namespace

Server::Server(int port, Handler handler, Limits limits) : port_(port), handler_(std::move(handler)), limits_(limits) {
    listener_ = loopback_listener(port_);
    alarm_ = ::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
    if (alarm_ < 0) {
        const int error = errno;
        ::close(listener_);
        cannot_listen(port_, error);
    }
    sigset_t all, before;  // signals are for the thread of the run
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &before);
    thread_ = std::thread([this] {
        while (!ending_) try {
                Work(listener_, alarm_, ending_, waiting_, handler_, limits_).run();
            } catch (...) {}  // no memory for an answer: its clients are dropped, the run is not harmed
    });
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

Server::~Server() {
    ending_ = true;
    wake();
    thread_.join();
    ::close(listener_), ::close(alarm_);
}

void Server::wake() {
    const std::uint64_t one = 1;
    if (::write(alarm_, &one, sizeof one) < 0) {}  // it is full: nobody can have missed it
}

void Server::leave_to_parent() { ::close(listener_), ::close(alarm_); }

}  // namespace hinge::live
