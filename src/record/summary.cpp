#include "record/summary.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "effects/declared.h"
#include "run/element_count.h"
#include "record/element_events.h"
#include "record/joint_ratings.h"
#include "record/recording.h"
#include "record/told_warnings.h"
#include "run/dynamics.h"
#include "run/statics.h"
#include "core/text.h"
#include "core/files.h"
#include "record/chain.h"
#include "advice/check.h"
#include "record/folders.h"

namespace hinge {
namespace {

Json energy_json(const Run& run) {
    const Energy e = run.energy();
    Json j = {{"initial", e.initial}};
    for (const AccountInfo& account : run.accounts()) j[std::string(account.name)] = e[account.name];
    j["energy_error"] = j["remainder"] = e.error;  // two names: programs that read summary.json know the second
    return j;
}

constexpr std::size_t most_joints = 20;  // in the summary; hinges.csv has all

Json joint_json(const Structure& s, const JointRating& j) {
    Json row = {{"joint", j.connector ? connector_name(s, j.joint) : joint_name(s, j.joint)},
                {"axis", joint_rating_names[j.which]},
                {"node", s.node_name(j.node)},
                {j.is_force() ? "force" : "moment", j.force},
                {j.is_force() ? "largest_force" : "largest_moment", j.largest_force},
                {"broken", j.broken}};
    if (!j.is_force()) row["largest_rotation"] = j.largest, row["yielded"] = j.record->yielded;
    if (std::isfinite(j.strength)) row["strength"] = j.strength;
    if (std::isfinite(j.capacity)) row["capacity"] = j.capacity;
    if (const double ratio = j.of_own_limit(); ratio > 0) row["ratio"] = ratio;
    return row;
}

/// Joints: how many have yielded, broken or are beyond a limit of their own, and those that have come furthest: by
/// their own limit, then by rotation. Or connectors, of which only a force at which they break counts.
Json joints_json(const Run& run, bool connectors) {
    std::vector<JointRating> list = joint_ratings(run);
    std::erase_if(list, [connectors](const JointRating& j) { return j.connector != connectors; });
    std::set<int> all, yielded, broken, beyond;
    for (const JointRating& j : list) {
        all.insert(j.joint);
        if (j.record && j.record->yielded) yielded.insert(j.joint);
        if (j.broken) broken.insert(j.joint);
        if (j.failed || j.of_own_limit() > 1) beyond.insert(j.joint);
    }
    std::stable_sort(list.begin(), list.end(), [](const JointRating& a, const JointRating& b) {
        return a.of_own_limit() != b.of_own_limit() ? a.of_own_limit() > b.of_own_limit() : a.largest > b.largest;
    });
    if (list.size() > most_joints) list.resize(most_joints);
    Json j = {{"count", all.size()}};
    if (!connectors) j["yielded"] = yielded.size();
    j["broken"] = broken.size(), j["beyond_own_limit"] = beyond.size(), j["largest"] = Json::array();
    for (const JointRating& r : list) j["largest"].push_back(joint_json(run.structure(), r));
    return j;
}

/// Of all members and added masses, kg.
double mass_of(const Structure& s) {
    double mass = 0;
    for (const Element& e : s.elements()) mass += e.mass();
    for (const AddedMass& m : added_masses(s.model())) mass += m.mass.mass;
    return mass;
}

Json instability_json(const Structure& s, const Instability& i) {
    Json j = {{"factor", i.factor}, {"beyond", i.beyond}, {"count", i.count}};
    if (i.node >= 0) {
        j["node"] = s.node_name(i.node);
        j["component"] = component_name(i.component);
    }
    if (!i.members.empty()) j["by"] = i.by_compression ? "compression" : "bending";
    j["members"] = Json::array();
    for (int member : i.members) j["members"].push_back(member + 1);
    return j;
}

}  // namespace

Json probes_json(const RunRecord& r) {
    Json list = Json::array();
    for (const auto& p : r.probes) {
        list.push_back({{"name", p->name},
                        {"node", p->node + 1},
                        {"quantity", node_quantities()[std::size_t(6 * int(p->quantity) + p->component)]},
                        {"unit", unit_of(*p)}});
        if (p->relative_to >= 0) list.back()["relative_to"] = p->relative_to + 1;
        if (p->height > 0) list.back()["quantity"] = p->component == 0 ? "drift_x" : "drift_y";
        if (p->height > 0) list.back()["height"] = p->height;
    }
    return list;
}

std::vector<PlanLine> effects_of(const RunRecord& record) {
    std::vector<PlanLine> list = record.run->effects();
    const std::string rows = record.every > 1 ? "a row of history.csv every " + std::to_string(record.every) + " steps"
                                              : "a row of history.csv at every step";
    list.push_back({"recording", record.every > 0, record.every > 0 ? rows : "record = false", ""});
    return list;
}

void describe_run(Json& j, const RunRecord& r) {
    const Run& run = *r.run;
    const Structure& s = run.structure();
    j["kind"] = run.kind();
    j["model"] = {{"members", s.model().members().size()},
                  {"elements", s.elements().size()},
                  {"nodes", s.position().size()},
                  {"free_dofs", s.free_dofs()},
                  {"mass", mass_of(s)}};
    for (const ElementGroup& g : element_groups(s.model()))
        j["model"]["automatic_elements"].push_back(
            {{"elements", g.elements}, {"members", g.members}, {"because", g.because}});
    j["steps"] = run.steps_done();
    j["time"] = run.state().time;
    j["factor"] = run.state().factor;
    j["wall_seconds"] = r.wall;
    if (r.resumed_at > 0) j["resumed_at"] = r.resumed_at;
    j["effects"] = Json::array();
    for (const PlanLine& e : effects_of(r)) {
        j["effects"].push_back(
            {{"name", e.name}, {"active", e.active}, {"because", e.because}, {"seconds", e.seconds}});
        if (!e.asked_at.empty()) j["effects"].back()["asked_at"] = e.asked_at;
    }
    j["state_changes"] = Json::array();
    for (const Run::Activation& w : run.activations())
        j["state_changes"].push_back({{"time", w.time}, {"effect", w.effect}, {"awake", w.awake}, {"why", w.why}});
    j["stages"] = Json::array();
    for (const StageTime& t : run.stage_times()) j["stages"].push_back({{"name", t.name}, {"seconds", t.seconds}});
    j["damage"] = damage_by_group(run);
    if (Json joints = joints_json(run, false); joints["count"] != 0) j["joints"] = std::move(joints);
    if (Json connectors = joints_json(run, true); connectors["count"] != 0) j["connectors"] = std::move(connectors);
    j["probes"] = probes_json(r);
    j["energy"] = energy_json(run);
    j["energy_error"] =
        std::isfinite(r.last_energy_share) ? Json(r.last_energy_share) : Json(number_text(r.last_energy_share, 10));
    if (r.state_energy_share != r.last_energy_share) j["energy_error_of_state"] = r.state_energy_share;
    j["worst_energy_error"] = r.worst_energy_error;
    if (const auto shortest = run.shortest_controlled())
        j["step_control"] = {{"rejected_steps", run.rejected()}, {"shortest_dt", *shortest}};
    if (const Fastest* fastest = run.fastest_node())
        j["fastest_node"] = {{"speed", fastest->speed}, {"node", s.node_name(fastest->node)}, {"time", fastest->time}};
    if (!run.is_static()) return;
    j["limit"] = run.limit();
    if (const Instability* i = run.instability()) j["instability"] = instability_json(s, *i);
}

namespace {

constexpr int most_failed = 10;  ///< lines about runs that failed before the last one

/// That of the last run, or of the one before it that failed without the script having asked for its verdict.
Outcome outcome_of_runs(const Context& c) {
    if (!c.runs.last) return {};
    const RunRecord& r = *c.runs.last;
    const bool running = r.run->verdict() == Verdict::running;
    Outcome out{running ? "stopped" : name(verdict_of(r)),
                running ? "the script stopped before the last step" : reason_of(r), cause_of(r)};
    if (is_weak(r)) out = {"failed", reason_of(r), "from_failed_run"};
    if (r.run->failure()) out.cause = cause_of(r);
    if (const std::string other = unasked_failure(c); out.verdict != "failed" && !other.empty())
        out = {"failed", other, unasked_cause(c)};
    return out;
}

/// A script some of whose files could not be written has failed.
void count_lost_files(const Context& c, Outcome& out) {
    const auto& lost = c.output.lost;
    if (lost.empty()) return;
    const std::string missing =
        lost.front() + (lost.size() > 1 ? "; and " + std::to_string(lost.size() - 1) + " more" : "");
    out = {"failed", (out.verdict == "failed" ? out.reason + "; " : "") + "not all was written: " + missing,
           out.cause.empty() ? "not_written" : out.cause};
}

/// Lists the runs that failed before the last one, whose failure is the verdict and is told by itself.
void list_failed_runs(const Context& c, Json& j) {
    int told = 0;
    for (const auto& [number, text, cause] : c.runs.failed) {
        if (c.runs.last && number == c.runs.last->number) continue;
        j["failed_runs"].push_back(text);
        if (++told <= most_failed) std::fprintf(stderr, "hinge: %s\n", text.c_str());
    }
    if (told > most_failed)
        std::fprintf(stderr, "hinge: %d more runs failed; summary.json names them all\n", told - most_failed);
}

/// Warns of a script that made runs and never stepped one.
void warn_of_idle_runs(const Context& c, Json& j) {
    const int idle = c.runs.made - c.runs.begun;
    if (idle <= 0 || c.runs.begun > 0) return;
    const std::string text = count_text(idle, "run") + " made, and none has taken a step";
    j["warnings"].push_back(text);
    if (c.messages.warns)
        std::fprintf(stderr, "warning: %s; call run:finish(), or step: for step in run:steps() do ... end\n",
                     text.c_str());
}

}  // namespace

Outcome write_summary(Context& c, const OwnSummary& own) {
    Json j;
    if (c.runs.last) tell_findings(c, *c.runs.last);
    Outcome out = outcome_of_runs(c);
    if (!own.whole.is_null()) out = {own.whole.value("verdict", out.verdict), own.whole.value("reason", ""), ""};
    count_lost_files(c, out);
    if (!c.output.lost.empty()) j["lost"] = c.output.lost;
    j["verdict"] = out.verdict;
    if (!out.reason.empty()) j["reason"] = out.reason;
    if (out.verdict == "failed" && !out.cause.empty()) j["cause"] = out.cause;
    j.update(own.head);
    j["hinge"] = HINGE_VERSION;
    if (const auto& r = c.runs.last) {
        describe_run(j, *r);
        j["state_hash"] = hex_text(hash(r->run->state()));
    }
    j["results"] = own.results.is_null() ? Json::object() : own.results;
    if (!own.notes.is_null() && !own.notes.empty()) j["notes"] = own.notes;
    if (!c.messages.warned.empty()) j["warnings"] = c.messages.warned;
    list_failed_runs(c, j);
    warn_of_idle_runs(c, j);
    if (!c.output.folder.empty()) {
        take_folder(c);
        if (c.runs.last) leave_happenings(c, *c.runs.last);
        write_whole(c.output.folder + "/summary.json", whole_text(j));
    }
    write_event(c, "summary", {{"folder", c.output.folder}, {"summary", j}});
    return out;
}

void write_summary(Context& c) { write_summary(c, OwnSummary()); }

}  // namespace hinge
