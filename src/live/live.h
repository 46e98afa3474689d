// hinge run --live: the page of hinge report for a run in progress. The server's thread receives the page's requests,
// the run's thread takes a snapshot between two steps, and the server's thread encodes it.
#pragma once

#include <mutex>
#include <vector>

#include "live/server.h"
#include "output/picture.h"
#include "record/events.h"
#include "record/run_observer.h"

namespace hinge::live {

/// Rows of a history, thinned out evenly to a limited number, and the last row.
class Rows {
public:
    explicit Rows(const std::string& heading = "");
    void add(const std::string& row);       ///< of CSV
    void end_with(const std::string& row);  ///< sets the last row until another is added
    Json columns;
    std::string json() const;  ///< a list of them

private:
    std::vector<std::string> kept_;
    std::string last_;
    std::size_t seen_ = 0, every_ = 1;
};

class Live : public RunObserver {
public:
    explicit Live(int port);
    ~Live() override;

    const std::string& id() const { return id_; }  ///< differs from that of other programs at the same port
    int shown() const { return shown_; }           ///< number of the run that is shown, 0 before any
    void show(std::string page);                   ///< the page that is served
    std::string address() const;

    void begun(const RunRecord& run, const std::string& history) override;
    void row(const RunRecord& run, const std::string& row) override;
    void stepped(const Context& context, const RunRecord& run, bool over,
                 std::chrono::steady_clock::time_point now) override;
    void forked() override { server_->leave_to_parent(); }

    /// Tells open pages that the program ends, in a second at most; what: fields of the last state.
    void end(const Json& what);

private:
    using Clock = std::chrono::steady_clock;

    /// State of the run shown, for answers to pages.
    struct State {
        long version = 0;
        Json fields = {{"program", "running"}};  ///< all but what follows
        std::shared_ptr<const output::Snapshot> snapshot;
        int run = 0;  ///< its number
        Rows rows;
    };
    struct Page {
        Clock::time_point asked;
        bool knows_end = false;
    };

    std::optional<Answer> answer(const Request& request);
    Answer state_for(const Request& request, const State& state);
    void take_shot(const Context& context, const RunRecord& run);
    void change_to(const RunRecord& run);
    bool anybody_left();  ///< true if an open page does not know of the end

    const std::string id_;
    // of the run's thread
    std::map<int, Rows> rows_;
    int shown_ = 0;  ///< number of the run
    bool shown_over_ = true;
    std::size_t events_taken_ = 0;
    Clock::time_point shown_stepped_ = {}, next_shot_ = {};
    // of both
    std::atomic<bool> wanted_ = false;
    std::mutex mutex_;
    std::shared_ptr<const State> state_ = std::make_shared<const State>();
    Json event_columns_;
    std::vector<std::string> events_;  ///< of the run shown, each a JSON array
    bool over_ = false;
    std::map<std::string, Page> pages_;
    std::shared_ptr<const std::string> page_;
    // of the server's thread
    struct {
        long version = -1;
        bool with_model = false;
        std::string text;
    } packed_;  ///< for the next page that asks for the same

    std::unique_ptr<Server> server_;  ///< last: its thread ends first
};

}  // namespace hinge::live
