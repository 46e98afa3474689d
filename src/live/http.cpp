#include "live/http.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>

namespace hinge::live {
namespace {

const char* name_of(int status) {
    switch (status) {
        case 200: return "OK";
        case 204: return "No Content";
        case 400: return "Bad Request";
        case 403: return "Forbidden";
        case 404: return "Not Found";
        case 405: return "Method Not Allowed";
        case 431: return "Request Header Fields Too Large";
        case 503: return "Service Unavailable";
        case 505: return "HTTP Version Not Supported";
        default: return "Error";
    }
}

std::string lower(std::string text) {
    for (char& c : text) c = char(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
    return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

/// 127.0.0.1 or localhost, with or without a port: also another one, where a tunnel leads here. A page from elsewhere
/// whose name was made to lead here has another name.
bool is_loopback(const std::string& host) {
    const auto colon = host.find(':');
    const std::string name = lower(host.substr(0, colon)), port = colon == host.npos ? "0" : host.substr(colon + 1);
    return (name == "127.0.0.1" || name == "localhost") && !port.empty() && port.size() <= 5 &&
           std::all_of(port.begin(), port.end(), [](unsigned char c) { return std::isdigit(c); });
}

void read_query(const std::string& text, Request& request) {
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t to = std::min(text.find('&', from), text.size()), equals = text.find('=', from);
        if (equals < to) request.query[text.substr(from, equals - from)] = text.substr(equals + 1, to - equals - 1);
        from = to + 1;
    }
}

/// "GET /path?query HTTP/1.1"
int read_first(const std::string& line, Request& request) {
    const auto first = line.find(' '), last = line.rfind(' ');
    if (first == std::string::npos || last <= first + 1) return 400;
    const std::string method = line.substr(0, first), target = line.substr(first + 1, last - first - 1),
                      protocol = line.substr(last + 1);
    const auto printable = [](unsigned char c) { return c > ' ' && c < 127; };
    if (!std::all_of(target.begin(), target.end(), printable) || target[0] != '/') return 400;
    if (!std::all_of(method.begin(), method.end(), [](unsigned char c) { return std::isupper(c); })) return 400;
    if (protocol.rfind("HTTP/", 0) != 0) return 400;
    if (protocol != "HTTP/1.1" && protocol != "HTTP/1.0") return 505;
    if (method != "GET") return 405;
    const auto question = std::min(target.find('?'), target.size());
    request.path = target.substr(0, question);
    if (question < target.size()) read_query(target.substr(question + 1), request);
    return 200;
}

}  // namespace

long Request::number(const std::string& name, long otherwise) const {
    const auto found = query.find(name);
    if (found == query.end() || found->second.empty()) return otherwise;
    char* end = nullptr;
    const long value = std::strtol(found->second.c_str(), &end, 10);
    return *end ? otherwise : value;
}

int read_head(const std::string& head, Request& request) {
    const auto end = head.find("\r\n");
    if (const int status = read_first(head.substr(0, end), request); status != 200) return status;
    int hosts = 0;
    bool from_elsewhere = false;
    for (std::size_t from = end + 2; from < head.size();) {
        const std::size_t to = head.find("\r\n", from), colon = head.find(':', from);
        if (colon >= to || colon == from) return 400;
        const std::string name = lower(head.substr(from, colon - from)),
                          value = trimmed(head.substr(colon + 1, to - colon - 1));
        if (name.find_first_of(" \t") != std::string::npos) return 400;
        if (name == "host" && (++hosts > 1 || !is_loopback(value))) return hosts > 1 ? 400 : 403;
        if (name == "sec-fetch-site" && value != "same-origin" && value != "none") from_elsewhere = true;
        from = to + 2;
    }
    if (hosts == 0) return 400;
    return from_elsewhere && request.path != "/" ? 403 : 200;  // a link may lead to the page
}

std::string heading_of(const Answer& answer) {
    std::string text = "HTTP/1.1 " + std::to_string(answer.status) + " " + name_of(answer.status) + "\r\n";
    if (answer.status == 405) text += "Allow: GET\r\n";
    if (answer.body) text += std::string("Content-Type: ") + answer.type + "\r\n";
    if (answer.status != 204)
        text += "Content-Length: " + std::to_string(answer.body ? answer.body->size() : 0) + "\r\n";
    return text +
           "Cache-Control: no-store\r\nX-Content-Type-Options: nosniff\r\nX-Frame-Options: DENY\r\n"
           "Cross-Origin-Resource-Policy: same-origin\r\nReferrer-Policy: no-referrer\r\nConnection: close\r\n\r\n";
}

Answer refusal(int status) {
    std::string text = std::to_string(status) + " " + name_of(status) + "\n";
    return {status, "text/plain; charset=utf-8", std::make_shared<const std::string>(std::move(text))};
}

}  // namespace hinge::live
