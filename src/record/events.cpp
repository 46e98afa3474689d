#include "record/events.h"

namespace hinge {

void write_event(const Context& c, const char* kind, const Json& fields) {
    if (!c.messages.events) return;
    Json j = {{"event", kind}};
    j.update(fields);
    const std::string line = line_text(j) + "\n";
    std::fwrite(line.data(), 1, line.size(), c.messages.events);
    std::fflush(c.messages.events);
}

std::string whole_text(const Json& value) { return value.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

std::string line_text(const Json& value) { return value.dump(-1, ' ', false, Json::error_handler_t::replace); }

}  // namespace hinge
