// The energy balance over a run, kept for plots.
#include "record/recording.h"
#include "run/energy_monitor.h"

namespace hinge {

namespace {

/// What stands in a row: time, load factor, the accounts with their parts, energy error.
std::vector<std::string> columns_of(const Run& run) {
    std::vector<std::string> names = {"time", "factor"};
    for (const AccountInfo& account : run.accounts()) names.emplace_back(account.name);
    names.emplace_back("energy_error");
    return names;
}

void append_row(std::vector<double>& values, const Run& run, const Energy& e, const LostBalance* lost = nullptr) {
    values.push_back(lost ? lost->time : run.state().time);
    values.push_back(lost ? lost->factor : run.state().factor);
    for (const AccountInfo& account : run.accounts()) values.push_back(e[account.name]);
    values.push_back(e.error);
}

}  // namespace

void keep_row(RunRecord& r, const Energy& energy, const LostBalance* lost) {
    KeptRows& kept = r.kept_rows;
    if (r.every == 0 || (kept.seen++ % kept.stride != 0 && !lost)) return;
    append_row(kept.values, *r.run, energy, lost);
    const std::size_t n = columns_of(*r.run).size(), rows = kept.values.size() / n;
    if (rows < std::size_t(KeptRows::most)) return;
    std::vector<double> half;
    for (std::size_t i = 0; i < rows; i += 2)
        half.insert(half.end(), kept.values.begin() + long(i * n), kept.values.begin() + long(i * n + n));
    kept.values = std::move(half);
    kept.stride *= 2;
}

RunHistory history_of(const RunRecord& r) {
    RunHistory history{columns_of(*r.run), {}, r.kept_rows.values};
    const std::size_t n = history.columns.size();
    std::vector<double>& values = history.values;
    const bool is_new = values.size() < n || values[values.size() - n] != r.run->state().time ||
                        values[values.size() - n + 1] != r.run->state().factor;
    if (is_new && r.every > 0 && !r.mid_step && r.started && !r.run->lost())
        append_row(values, *r.run, r.run->energy());
    for (const AccountInfo& account : r.run->accounts())
        if (!account.part_of.empty()) history.parts.emplace_back(account.name);
    return history;
}

}  // namespace hinge
