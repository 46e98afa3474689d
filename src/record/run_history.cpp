// The energy balance over a run, kept for plots.
#include "record/recording.h"
#include "run/dynamics.h"

namespace hinge::script {

const char* unit_of(const Probe& p) {
    const bool turns = p.component >= 3;
    if (p.height > 0) return "";  // a drift
    switch (p.quantity) {
        case Probe::Quantity::velocity: return turns ? "rad/s" : "m/s";
        case Probe::Quantity::acceleration: return turns ? "rad/s^2" : "m/s^2";
        case Probe::Quantity::reaction: return turns ? "N m" : "N";
        default: return turns ? "rad" : "m";
    }
}

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

/// core.run_history(run, function): { columns = { names in order }, parts = { names of parts of accounts }, [name] = {
/// values }
/// }, the present state last; in the middle of a step the one before it. Of a run whose energy balance no longer closed
/// the last row is that of this moment.
int run_history(lua_State* L) {
    const auto r =
        run_argument(L, 1, (lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) + std::string(": ") : "") + "the run");
    const std::vector<std::string> names = columns_of(*r->run);
    std::vector<double> values = r->kept_rows.values;
    const std::size_t n = names.size();
    const bool is_new = values.size() < n || values[values.size() - n] != r->run->state().time ||
                        values[values.size() - n + 1] != r->run->state().factor;
    const auto* dynamics = dynamic_cast<const Dynamics*>(r->run.get());
    const bool lost = dynamics && dynamics->lost();
    if (is_new && r->every > 0 && !r->mid_step && r->started && !lost) append_row(values, *r->run, r->run->energy());
    lua_newtable(L);
    lua_newtable(L);
    for (std::size_t i = 0; i < n; ++i) {
        lua_pushstring(L, names[i].c_str());
        lua_rawseti(L, -2, lua_Integer(i) + 1);
    }
    lua_setfield(L, -2, "columns");
    lua_newtable(L);
    lua_Integer parts = 0;
    for (const AccountInfo& account : r->run->accounts())
        if (!account.part_of.empty()) {
            lua_pushstring(L, std::string(account.name).c_str());
            lua_rawseti(L, -2, ++parts);
        }
    lua_setfield(L, -2, "parts");
    for (std::size_t k = 0; k < n; ++k) {
        std::vector<double> column;
        for (std::size_t i = k; i < values.size(); i += n) column.push_back(values[i]);
        push_array(L, column.data(), int(column.size()));
        lua_setfield(L, -2, names[k].c_str());
    }
    return 1;
}

}  // namespace hinge::script
