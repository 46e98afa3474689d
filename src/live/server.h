// A small HTTP server on the loopback address: one thread, which neither a slow nor a broken client holds up.
#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <thread>

namespace hinge::live {

/// GET path?query
struct Request {
    std::string path;
    std::map<std::string, std::string> query;

    /// A whole number in the query, `otherwise` where there is none.
    long number(const std::string& name, long otherwise) const;
};

struct Answer {
    int status = 200;
    const char* type = "text/plain; charset=utf-8";
    std::shared_ptr<const std::string> body;
};

/// Called on the server's thread. Nothing: not yet; the request waits until wake(), and gets 204 after some seconds.
using Handler = std::function<std::optional<Answer>(const Request&)>;

class Server {
public:
    /// Listens on 127.0.0.1; port 0: one that is free. Throws OutsideError.
    Server(int port, Handler handler);
    /// Sends what is on its way, for some tenths of a second at most, and ends the thread.
    ~Server();
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    int port() const { return port_; }
    void wake();                              ///< requests that wait are asked again
    int waiting() const { return waiting_; }  ///< requests that wait, since the last wake()
    /// In a process that was forked: it has no such thread, and nothing to do with the server.
    void leave_to_parent();

private:
    int listener_ = -1, alarm_ = -1, port_ = 0;
    std::atomic<bool> ending_ = false;
    std::atomic<int> waiting_ = 0;
    Handler handler_;
    std::thread thread_;
};

}  // namespace hinge::live
