// Reads the head of an HTTP/1.1 request and writes the head of an answer. Only GET, one request a connection.
#pragma once

#include "live/server.h"

namespace hinge::live {

inline constexpr std::size_t longest_head = 8192;  ///< bytes

/// Reads the lines of a request's head, each with its \r\n, and returns an HTTP status. 200: the request is allowed.
/// 400: malformed. 403: its Host is not this computer, or another site's page sent it. 405: not GET. 505: not HTTP/1.
int read_head(const std::string& head, Request& request);

/// Status line and header fields of an answer, with the empty line that ends them.
std::string heading_of(const Answer& answer);

/// An answer that names the status in its text.
Answer refusal(int status);

}  // namespace hinge::live
