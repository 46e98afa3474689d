// HTTP/1.1 as far as a page on the loopback address needs it: what a request asks for, what stands above an answer.
#pragma once

#include "live/server.h"

namespace hinge::live {

inline constexpr std::size_t longest_head = 8192;  ///< bytes

/// Reads a request's lines, each with its \r\n. 200, or the status that refuses it: 400 it is none; 403 it comes from a
/// page of somebody else's, or was not sent to this computer by name; 405 it is no GET; 505 another protocol.
int read_head(const std::string& head, Request& request);

/// Status line and fields, with the empty line after them.
std::string heading_of(const Answer& answer);

Answer refusal(int status);

}  // namespace hinge::live
