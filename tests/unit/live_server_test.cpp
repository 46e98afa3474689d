// The server of hinge run --live: whom it answers, whom it refuses, and that nobody holds it up.
#include <catch2/catch.hpp>

#include <arpa/inet.h>

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <cstring>
#include <filesystem>
#include <thread>
#include <vector>

#include "core/errors.h"
#include "live/http.h"

using namespace hinge;
using namespace hinge::live;
using namespace std::chrono_literals;

namespace {

/// A client's end of a connection; whatever takes longer than five seconds fails.
struct Connection {
    int fd = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    bool connected;
    explicit Connection(int port, const std::string& request = "", int room = 0) {
        if (room) ::setsockopt(fd, SOL_SOCKET, SO_RCVBUF, &room, sizeof room);
        const timeval most = {5, 0};
        ::setsockopt(fd, SOL_SOCKET, SO_RCVTIMEO, &most, sizeof most);
        sockaddr_in a = {};
        a.sin_family = AF_INET, a.sin_port = htons(std::uint16_t(port)), a.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        connected = ::connect(fd, reinterpret_cast<sockaddr*>(&a), sizeof a) == 0;
        if (!request.empty()) say(request);
    }
    ~Connection() { ::close(fd); }
    void say(const std::string& text) {
        CHECK(::send(fd, text.data(), text.size(), MSG_NOSIGNAL) == ssize_t(text.size()));
    }
    /// All that comes until the other end closes; "late" at its end where it does not.
    std::string hear() {
        std::string text;
        char some[65536];
        for (;;) {
            const ssize_t n = ::recv(fd, some, sizeof some, 0);
            if (n > 0) text.append(some, std::size_t(n));
            else return n == 0 ? text : text + "late";
        }
    }
};

std::string get(int port, const std::string& path, const std::string& more = "Host: 127.0.0.1\r\n") {
    return Connection(port, "GET " + path + " HTTP/1.1\r\n" + more + "\r\n").hear();
}

/// A request of what has 40 MB.
const std::string large = "GET /large HTTP/1.1\r\nHost: localhost\r\n\r\n";

std::string status_of(const std::string& answer) { return answer.substr(0, answer.find("\r\n")); }
std::string body_of(const std::string& answer) {
    const auto end = answer.find("\r\n\r\n");
    return end == std::string::npos ? "" : answer.substr(end + 4);
}

std::shared_ptr<const std::string> text(std::string t) { return std::make_shared<const std::string>(std::move(t)); }

std::optional<Answer> plain(const Request& r) {
    if (r.path == "/") return Answer{200, "text/html", text("the page")};
    if (r.path == "/echo") return Answer{200, "text/plain", text(std::to_string(r.number("n", -7)))};
    static const auto much = text(std::string(40'000'000, 'x'));
    if (r.path == "/large") return Answer{200, "text/plain", much};
    if (r.path == "/never") return std::nullopt;
    return Answer{404, "text/plain", text("nothing")};
}

/// Five seconds at most.
template <class Test>
void wait_for(Test test) {
    for (int i = 0; i < 500 && !test(); ++i) std::this_thread::sleep_for(10ms);
}

int entries_of(const char* path) { return int(std::distance(std::filesystem::directory_iterator(path), {})); }
int threads_now() { return entries_of("/proc/self/task"); }
int files_now() { return entries_of("/proc/self/fd"); }

}  // namespace

TEST_CASE("the live server answers GET", "[live]") {
    Server server(0, plain);
    const std::string page = get(server.port(), "/");
    CHECK(status_of(page) == "HTTP/1.1 200 OK");
    CHECK(body_of(page) == "the page");
    for (const char* line : {"Content-Length: 8\r\n", "Cache-Control: no-store\r\n", "X-Frame-Options: DENY\r\n",
                             "Connection: close\r\n", "Content-Type: text/html\r\n"})
        CHECK(page.find(line) != std::string::npos);
    CHECK(body_of(get(server.port(), "/echo?a=b&n=12")) == "12");
    CHECK(body_of(get(server.port(), "/echo?n=1x")) == "-7");
    CHECK(body_of(get(server.port(), "/echo?&=&n&n=")) == "-7");
    CHECK(status_of(get(server.port(), "/../etc/passwd")) == "HTTP/1.1 404 Not Found");
    CHECK(body_of(get(server.port(), "/large")).size() == 40'000'000);
}

TEST_CASE("the live server refuses other hosts, other methods and what is no request", "[live]") {
    Server server(0, plain);
    const int port = server.port();
    const auto with = [&](const std::string& lines) { return status_of(get(port, "/", lines)); };
    for (const char* host : {"127.0.0.1", "127.0.0.1:80", "localhost:12345", "LocalHost", " 127.0.0.1 "})
        CHECK(with("Host:" + std::string(host) + "\r\n") == "HTTP/1.1 200 OK");
    for (const char* host : {"evil.example", "127.0.0.1.evil.example", "evil.example:80", "localhost:80:80", "",
                             "127.0.0.2", "localhost:", "localhost:8x", "localhost.", "0.0.0.0"})
        CHECK(with("Host: " + std::string(host) + "\r\n") == "HTTP/1.1 403 Forbidden");
    CHECK(with("") == "HTTP/1.1 400 Bad Request");
    CHECK(with("Host: localhost\r\nHost: localhost\r\n") == "HTTP/1.1 400 Bad Request");
    CHECK(with("Host: localhost\r\nno colon\r\n") == "HTTP/1.1 400 Bad Request");
    // a page of somebody else's may lead here, and ask for nothing
    const std::string elsewhere = "Host: localhost\r\nSec-Fetch-Site: cross-site\r\n";
    CHECK(with(elsewhere) == "HTTP/1.1 200 OK");
    CHECK(status_of(get(port, "/echo", elsewhere)) == "HTTP/1.1 403 Forbidden");
    CHECK(status_of(get(port, "/echo", "Host: localhost\r\nSec-Fetch-Site: same-origin\r\n")) == "HTTP/1.1 200 OK");
    const auto raw = [&](const std::string& request) { return status_of(Connection(port, request).hear()); };
    const std::string host = " HTTP/1.1\r\nHost: localhost\r\n\r\n";
    CHECK(raw("POST /" + host + "a body that nobody reads") == "HTTP/1.1 405 Method Not Allowed");
    CHECK(raw("HEAD /" + host) == "HTTP/1.1 405 Method Not Allowed");
    CHECK(raw("GET / HTTP/2.0\r\nHost: localhost\r\n\r\n") == "HTTP/1.1 505 HTTP Version Not Supported");
    for (const std::string& junk : {std::string("\r\n\r\n"), std::string("GET\r\n\r\n"), "GET  " + host.substr(1),
                                    "GET http://evil.example/" + host, std::string("\x16\x03\x01\0\xff\r\n\r\n", 9),
                                    "GET /\x01" + host, "get /" + host, std::string("GET / FTP/1.1\r\n\r\n")})
        CHECK(raw(junk) == "HTTP/1.1 400 Bad Request");
    const std::string too_large = "HTTP/1.1 431 Request Header Fields Too Large", line = "A: b\r\n";
    CHECK(raw("GET /" + std::string(20000, 'a') + host) == too_large);
    std::string lines = "GET / HTTP/1.1\r\n";  // a head of many short lines has the same limit
    while (lines.size() <= longest_head) lines += line;
    CHECK(raw(lines) == too_large);
}

TEST_CASE("a client has one limit of time for its request, and others for waiting and reading", "[live]") {
    Server server(0, plain, {.request = 200ms, .news = 200ms, .progress = 200ms});
    const auto begin = std::chrono::steady_clock::now();
    // Single bytes do not renew the limit: the server closes while the client goes on sending.
    Connection drips(server.port());
    const timeval short_wait = {0, 20000};
    ::setsockopt(drips.fd, SOL_SOCKET, SO_RCVTIMEO, &short_wait, sizeof short_wait);
    bool closed = false;
    char some;
    while (!closed && std::chrono::steady_clock::now() - begin < 4s) {
        if (::send(drips.fd, "G", 1, MSG_NOSIGNAL) < 0) closed = true;
        else if (::recv(drips.fd, &some, 1, 0) >= 0 || errno == ECONNRESET) closed = true;
    }
    CHECK(closed);
    CHECK(std::chrono::steady_clock::now() - begin >= 200ms);
    CHECK(status_of(get(server.port(), "/never")) == "HTTP/1.1 204 No Content");
    // A client that reads with pauses gets all 40 MB: they take longer than the limit, and no pause is as long.
    Connection slow(server.port(), large);
    const auto before = std::chrono::steady_clock::now();
    std::vector<char> room(2'000'000);
    std::size_t taken = 0;
    for (ssize_t n; (n = ::recv(slow.fd, room.data(), room.size(), MSG_WAITALL)) > 0; taken += std::size_t(n))
        std::this_thread::sleep_for(20ms);
    CHECK(taken > 40'000'000);
    CHECK(std::chrono::steady_clock::now() - before > 200ms);
    // A client that does not read is dropped: the rest of the answer does not come.
    Connection mute(server.port(), large, 4096);
    std::this_thread::sleep_for(600ms);
    CHECK(mute.hear().size() < 40'000'000);
}

TEST_CASE("a live server ends in less than a second while clients do not read", "[live]") {
    auto server = std::make_unique<Server>(0, plain);
    std::vector<std::unique_ptr<Connection>> mute;
    for (int i = 0; i < 4; ++i) mute.push_back(std::make_unique<Connection>(server->port(), large, 4096));
    CHECK(body_of(get(server->port(), "/")) == "the page");  // the four were served before
    const auto before = std::chrono::steady_clock::now();
    server.reset();
    CHECK(std::chrono::steady_clock::now() - before < 1s);
}

TEST_CASE("clients that never read, never ask or go away hold nobody up", "[live]") {
    const int threads = threads_now(), files = files_now();
    {
        Server server(0, plain);
        std::vector<std::unique_ptr<Connection>> others;
        for (int i = 0; i < 4; ++i) {
            others.push_back(std::make_unique<Connection>(server.port(), large, 4096));  // takes none of its 40 MB
            others.push_back(std::make_unique<Connection>(server.port()));               // says nothing
            others.push_back(std::make_unique<Connection>(server.port(), "GET /la"));    // half a request
        }
        for (int i = 0; i < 50; ++i) Connection(server.port(), large);  // asks and is gone
        const auto before = std::chrono::steady_clock::now();
        int answered = 0;
        for (int i = 0; i < 20; ++i) answered += body_of(get(server.port(), "/")) == "the page";
        CHECK(answered == 20);
        CHECK(std::chrono::steady_clock::now() - before < 3s);
        // with as many as it takes, others are turned away at once
        while (others.size() < 24) others.push_back(std::make_unique<Connection>(server.port()));
        CHECK(status_of(others.back()->hear()) == "HTTP/1.1 503 Service Unavailable");
    }
    CHECK(threads_now() == threads);
    CHECK(files_now() == files);
}

TEST_CASE("a request waits until there is something new", "[live]") {
    std::atomic<int> version = 0, asked = 0;
    Server server(0, [&](const Request& r) -> std::optional<Answer> {
        ++asked;
        if (version <= r.number("after", 0)) return std::nullopt;
        return Answer{200, "text/plain", text(std::to_string(version))};
    });
    std::vector<std::unique_ptr<Connection>> waiting;
    for (int i = 0; i < 3; ++i)
        waiting.push_back(
            std::make_unique<Connection>(server.port(), "GET /?after=0 HTTP/1.1\r\nHost: localhost\r\n\r\n"));
    wait_for([&] { return server.waiting() == 3; });
    REQUIRE(server.waiting() == 3);
    waiting.pop_back();  // one goes away
    server.wake();       // and there is nothing new
    wait_for([&] { return asked >= 5 && server.waiting() <= 2; });
    CHECK(server.waiting() == 2);
    version = 1;
    server.wake();
    for (auto& c : waiting) CHECK(body_of(c->hear()) == "1");
    CHECK(body_of(get(server.port(), "/?after=0")) == "1");
}

TEST_CASE("a live server ends while clients wait, and its port is free again", "[live]") {
    const int threads = threads_now();
    auto server = std::make_unique<Server>(0, plain);
    const int port = server->port();
    Connection waits(port, "GET /never HTTP/1.1\r\nHost: localhost\r\n\r\n");
    wait_for([&] { return server->waiting() == 1; });
    CHECK_THROWS_WITH(Server(port, plain),
                      Catch::Contains("cannot listen on 127.0.0.1 at port " + std::to_string(port) +
                                      ": Address already in use; another program has that port: give another one, or "
                                      "--live alone"));
    const auto before = std::chrono::steady_clock::now();
    server.reset();
    CHECK(std::chrono::steady_clock::now() - before < 1s);
    CHECK(threads_now() == threads);
    CHECK(waits.hear() == "");
    CHECK_FALSE(Connection(port).connected);
    Server again(port, plain);
    CHECK(body_of(get(port, "/")) == "the page");
}

TEST_CASE("a handler that finds no memory costs its client, and no more", "[live]") {
    Server server(0, [](const Request& r) -> std::optional<Answer> {
        if (r.path == "/fails") throw std::bad_alloc();
        return Answer{200, "text/plain", text("fine")};
    });
    CHECK(get(server.port(), "/fails") == "");
    CHECK(body_of(get(server.port(), "/")) == "fine");
}
