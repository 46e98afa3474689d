#include "live/live.h"

#include <algorithm>
#include <cctype>
#include <random>

#include "record/chain.h"
#include "record/frame_pack.h"
#include "record/element_events.h"
#include "record/recording.h"
#include "record/snapshot.h"
#include "record/summary.h"

namespace hinge::live {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t most_rows = 800, most_events = 20000, most_histories = 4, most_pages = 64;
constexpr auto between_shots = 250ms,  ///< four frames a second
    until_another = 500ms,             ///< a run that stands still so long makes room for another
    seen_lately = 1500ms;              ///< a page that has asked since is still open
constexpr double shots_share = 0.05;   ///< of the time at most, where a shot takes long

std::string text_of(const Json& j) { return j.dump(-1, ' ', false, Json::error_handler_t::replace); }

/// A row of CSV as JSON: what is not a number there is null.
std::string row_json(const std::string& row) {
    std::string text = "[";
    for (std::size_t from = 0; from < row.size() && row[from] != '\n';) {
        const std::size_t to = std::min(row.find_first_of(",\n", from), row.size());
        const std::string field = row.substr(from, to - from);
        const bool is_number = !field.empty() && field.find_first_of("nN") == std::string::npos;
        text += (text.size() > 1 ? "," : "") + (is_number ? field : std::string("null"));
        from = to < row.size() && row[to] == ',' ? to + 1 : row.size();
    }
    return text + "]";
}

std::string random_id() {
    std::random_device random;
    char text[24];
    std::snprintf(text, sizeof text, "%08x%08x", unsigned(random()), unsigned(random()));
    return text;
}

std::shared_ptr<const std::string> shared(std::string text) {
    return std::make_shared<const std::string>(std::move(text));
}

}  // namespace

// ---- rows -----------------------------------------------------------------------------------------------------------

Rows::Rows(const std::string& heading) : columns(Json::array()) {
    for (std::size_t from = 0; from < heading.size();) {
        const std::size_t to = std::min(heading.find(',', from), heading.size());
        columns.push_back(heading.substr(from, to - from));
        from = to + 1;
    }
}

void Rows::add(const std::string& row) {
    if (seen_++ % every_ != 0) return void(last_ = row);
    kept_.push_back(row), last_.clear();
    if (kept_.size() < most_rows) return;
    std::size_t n = 0;
    for (std::size_t i = 0; i < kept_.size(); i += 2) kept_[n++] = std::move(kept_[i]);
    kept_.resize(n);
    every_ *= 2;
}

void Rows::end_with(const std::string& row) {
    if (kept_.empty() || kept_.back() != row) last_ = row;
}

std::string Rows::json() const {
    std::string text = "[";
    for (const std::string& row : kept_) text += (text.size() > 1 ? "," : "") + row_json(row);
    if (!last_.empty()) text += (text.size() > 1 ? "," : "") + row_json(last_);
    return text + "]";
}

// ---- the run's thread -----------------------------------------------------------------------------------------------

Live::Live(int port) : id_(random_id()), page_(shared("")) {
    server_ = std::make_unique<Server>(port, [this](const Request& request) { return answer(request); });
}

Live::~Live() = default;

void Live::show(std::string page) {
    const std::scoped_lock lock(mutex_);
    page_ = shared(std::move(page));
}

std::string Live::address() const { return "http://127.0.0.1:" + std::to_string(server_->port()) + "/"; }

void Live::begun(const RunRecord& run, const std::string& history) try {
    const auto end = std::min(history.find('\n'), history.size());
    Rows& rows = rows_[run.number] = Rows(history.substr(0, end));
    for (std::size_t from = end + 1; from < history.size();) {
        const std::size_t to = std::min(history.find('\n', from), history.size());
        rows.add(history.substr(from, to - from));
        from = to + 1;
    }
    if (rows_.size() > most_histories)
        rows_.erase(rows_.begin()->first == shown_ && !shown_over_ ? std::next(rows_.begin()) : rows_.begin());
} catch (...) {}  // no memory to look on is no reason to end a run

void Live::row(const RunRecord& run, const std::string& row) try {
    if (const auto found = rows_.find(run.number); found != rows_.end()) found->second.add(row);
} catch (...) {}

void Live::change_to(const RunRecord& run) {
    shown_ = run.number;
    events_taken_ = 0;
    const std::scoped_lock lock(mutex_);
    events_.clear();
    event_columns_ = event_columns(*run.run);
}

void Live::stepped(const Context& context, const RunRecord& run, bool over, Clock::time_point now) try {
    if (run.number != shown_) {
        if (!shown_over_ && now - shown_stepped_ < until_another) return;
        change_to(run);
        next_shot_ = std::min(next_shot_, now + between_shots);
    }
    shown_stepped_ = now, shown_over_ = over;
    if (over ? !wanted_ && server_->waiting() == 0 : !wanted_ || now < next_shot_) return;
    take_shot(context, run);
    const auto took = Clock::now() - now;
    next_shot_ =
        now + std::max<Clock::duration>(between_shots, std::chrono::duration_cast<Clock::duration>(took / shots_share));
} catch (...) {}

void Live::take_shot(const Context& c, const RunRecord& run) {
    State s;
    s.run = run.number;
    s.snapshot = std::make_shared<const output::Snapshot>(make_snapshot(*run.run));
    Json summary = {{"verdict", name(verdict_of(run))}};
    if (const std::string reason = reason_of(run); !reason.empty()) summary["reason"] = reason;
    if (const Json owner = Json::parse(c.output.owner, nullptr, false); owner.is_object())
        for (const char* field : {"script", "case", "parameters"})
            if (owner.contains(field)) summary[field] = owner[field];
    summary["hinge"] = HINGE_VERSION;
    describe_run(summary, run);
    if (!c.messages.warned.empty()) summary["warnings"] = c.messages.warned;
    s.fields = {{"program", "running"},
                {"run", run.number},
                {"runs", c.runs.begun},
                {"made_at", run.asked_at},
                {"planned", run.run->planned_steps()},
                {"summary", std::move(summary)}};
    if (Rows& rows = rows_[run.number]; true) {
        const std::string row = history_row(run, run.run->energy());
        if (run.every == 0) rows.add(row);
        s.rows = rows;
        s.rows.end_with(row);
    }
    std::vector<std::string> more;
    const std::size_t all = std::min(run.happenings.size(), most_events);
    for (std::size_t i = events_taken_; i < all; ++i)
        more.push_back(text_of(Json(event_fields(*run.run, run.happenings[i]))));
    s.fields["events_left_out"] = run.happenings.size() - all;
    {
        const std::scoped_lock lock(mutex_);
        s.version = state_->version + 1;
        state_ = std::make_shared<const State>(std::move(s));
        events_.insert(events_.end(), more.begin(), more.end());
        events_taken_ = all;
    }
    wanted_ = false;
    server_->wake();
}

bool Live::anybody_left() {
    const std::scoped_lock lock(mutex_);
    const auto now = Clock::now();
    return server_->waiting() > 0 || std::any_of(pages_.begin(), pages_.end(), [&](const auto& p) {
               return !p.second.knows_end && now - p.second.asked < seen_lately;
           });
}

void Live::end(const Json& what) try {
    {
        const std::scoped_lock lock(mutex_);
        State last = *state_;
        for (const auto& [name, value] : what.items()) last.fields[name] = value;
        last.fields["program"] = "ended";
        ++last.version;
        state_ = std::make_shared<const State>(std::move(last));
        over_ = true;
    }
    server_->wake();
    const auto until = Clock::now() + seen_lately;
    while (Clock::now() < until && anybody_left()) std::this_thread::sleep_for(10ms);
} catch (...) {}

// ---- the server's thread --------------------------------------------------------------------------------------------

std::optional<Answer> Live::answer(const Request& request) {
    std::shared_ptr<const State> state;
    {
        const std::scoped_lock lock(mutex_);
        if (request.path == "/") return Answer{200, "text/html; charset=utf-8", page_};
        if (request.path != "/state")
            return Answer{404, "text/plain; charset=utf-8", shared("404: there are / and /state\n")};
        const auto named = request.query.find("page");
        if (named != request.query.end() && (pages_.size() < most_pages || pages_.count(named->second)))
            pages_[named->second] = {Clock::now(), over_};
        state = state_;
    }
    if (const auto program = request.query.find("program"); program != request.query.end() && program->second != id_)
        return Answer{200, "application/json", shared("{\"program\":\"another\"}")};
    if (state->version > request.number("after", -1)) return state_for(request, *state);
    if (request.number("quiet", 0) == 0) wanted_ = true;
    return std::nullopt;
}

/// With what the page has not yet: its run, its events so far.
Answer Live::state_for(const Request& request, const State& state) {
    const bool knows_run = request.number("run", 0) == state.run;
    if (packed_.version != state.version || packed_.with_model == knows_run) {
        Json j = state.fields;
        j["version"] = state.version;
        if (state.snapshot) j["frame"] = packed_frames({state.snapshot.get()}, Packing::quick, !knows_run);
        packed_ = {state.version, !knows_run, text_of(j)};
        packed_.text.pop_back();
        if (state.snapshot)
            packed_.text +=
                ",\"history\":{\"columns\":" + text_of(state.rows.columns) + ",\"rows\":" + state.rows.json() + "}";
    }
    std::string text = packed_.text;
    if (state.snapshot) {
        const std::scoped_lock lock(mutex_);
        const long from = knows_run ? std::clamp(request.number("events", 0), 0L, long(events_.size())) : 0;
        text +=
            ",\"events\":{\"columns\":" + text_of(event_columns_) + ",\"from\":" + std::to_string(from) + ",\"rows\":[";
        for (std::size_t i = std::size_t(from); i < events_.size(); ++i)
            text += (i > std::size_t(from) ? "," : "") + events_[i];
        text += "]}";
    }
    return {200, "application/json", shared(text + "}")};
}

}  // namespace hinge::live
