// HTTP server on the loopback address, in one thread. Slow and broken clients delay no other client and no end.
//
// Why no library: cpp-httplib 0.11, as Debian has it, is a shared library that loads OpenSSL and Brotli. The program
// then starts in 10 ms in place of 5. It has one thread per client and a timeout per read. A client that sends a byte a
// second is never dropped, a header line of 100 MB takes 100 MB, and four clients that do not read delay the program's
// end by 10 s (here 0.3 s). To mend that, we would replace its sockets, streams and threads, and keep a parser of 60
// lines.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <thread>

namespace hinge::live {

/// A GET request: path?query.
struct Request {
    std::string path;
    std::map<std::string, std::string> query;

    /// An integer of the query; `otherwise` if there is none.
    long number(const std::string& name, long otherwise) const;
};

struct Answer {
    int status = 200;
    const char* type = "text/plain; charset=utf-8";
    std::shared_ptr<const std::string> body;
};

/// Answers a request, on the server's thread. No value: the request waits until wake(), and gets 204 after
/// Limits::news.
using Handler = std::function<std::optional<Answer>(const Request&)>;

/// How long a client may take. The whole request has one limit, so that single bytes do not renew it.
struct Limits {
    std::chrono::milliseconds request{5000};   ///< from the connection to the last byte of the request
    std::chrono::milliseconds news{20000};     ///< a request that waits is answered by 204 after this time
    std::chrono::milliseconds progress{5000};  ///< between two parts of the answer that the client takes
};

class Server {
public:
    /// Listens on 127.0.0.1; port 0: one that is free. Throws OutsideError.
    Server(int port, Handler handler, Limits limits = {});
    /// Sends the answers that were begun, for some tenths of a second at most, and ends the thread.
    ~Server();
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    int port() const { return port_; }
    void wake();                              ///< calls the handler again for requests that wait
    int waiting() const { return waiting_; }  ///< requests that wait, since the last wake()
    /// Closes the sockets in a process that was forked: the server's thread is in its parent.
    void leave_to_parent();

private:
    int listener_ = -1, alarm_ = -1, port_ = 0;
    std::atomic<bool> ending_ = false;
    std::atomic<int> waiting_ = 0;
    Handler handler_;
    const Limits limits_;
    std::thread thread_;
};

}  // namespace hinge::live
