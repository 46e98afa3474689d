// run:checkpoint and run:resume, and the automatic checkpoints of the program.
#include "script/files/run_checkpoint.h"

#include <algorithm>
#include <filesystem>

#include "core/archive.h"
#include "core/doing.h"
#include "core/files.h"
#include "script/lua/interrupts.h"
#include "script/lua/kept_values.h"
#include "run/checkpoint.h"
#include "run/dynamics.h"

namespace hinge::script {
namespace {

using Clock = std::chrono::steady_clock;

std::string place_text(const Run& run) {
    char text[64];
    std::snprintf(text, sizeof text, "step %ld, t = %.6g s", run.steps_done(), run.state().time);
    return text;
}

/// A name without a folder is in the output folder. A script that is not trusted has no other.
std::string checkpoint_path(const Context& c, const std::string& name) {
    std::string path =
        name.find('/') != std::string::npos || c.output.folder.empty() ? name : c.output.folder + "/" + name;
    prepare_folder(c, path);
    return path;
}

// ---- the file -------------------------------------------------------------------------------------------------------

/// What lies beside the run in its checkpoint.
struct Beside {
    Recorded recorded;
    std::string history;
    std::vector<Probe> probes;
    std::vector<std::pair<double, std::string>> frames;
    std::string kept;  ///< the script's own values, "" where it keeps none
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.recorded, s.history, s.probes, s.frames, s.kept);
    }
};

void write_checkpoint(lua_State* L, const Context& c, const RunRecord& r, const std::string& path) {
    const auto* run = dynamic_cast<const Dynamics*>(r.run.get());
    Beside beside{r,
                  (r.files.history_path.empty() ? r.files.past : read_whole(r.files.history_path)) + r.files.rows,
                  {},
                  c.output.frames,
                  ""};
    if (r.checkpoint && r.checkpoint->keep) {
        r.checkpoint->keep->push(L);
        beside.kept = pack_table(L, -1, "model:dynamic, checkpoint: keep");
        lua_pop(L, 1);
    }
    for (const auto& p : r.probes) beside.probes.push_back(*p);
    std::string bytes;
    Writer{bytes}(beside);
    write_whole(path, checkpoint_of(*run, std::move(bytes)));
}

std::string names_of(const auto& probes, auto name) {
    std::string text;
    for (const auto& p : probes) text += (text.empty() ? "" : ", ") + name(p);
    return text.empty() ? "none" : text;
}

/// Either all goes on from there, or nothing has changed.
void read_checkpoint(lua_State* L, Context& c, RunRecord& r, const std::string& path) {
    const std::string bytes = read_whole(path);
    const Checkpoint checkpoint = hinge::open_checkpoint(bytes, path);
    Beside beside;
    bool good = true;
    try {
        Reader{checkpoint.beside}(beside);
        if (!beside.kept.empty()) check_packed_table(beside.kept);
    } catch (const Damaged&) { good = false; }
    const auto fits = [](std::size_t n, std::size_t all) { return n == 0 || n == all; };
    good = good && fits(beside.recorded.broken_at.size(), r.run->state().broken.size()) &&
           fits(beside.recorded.left_at.size(), r.run->state().gone.size()) &&
           std::all_of(beside.probes.begin(), beside.probes.end(),
                       [](const Probe& p) { return p.time.size() == p.value.size() && !p.time.empty(); });
    if (!good)
        throw OutsideError(
            "checkpoint " + path +
            " is damaged: its contents are not valid; go on from an older copy of it, or start the run anew");
    const auto same = [](const std::shared_ptr<Probe>& here, const Probe& there) {
        return here->name == there.name && here->node == there.node && here->quantity == there.quantity &&
               here->component == there.component && here->relative_to == there.relative_to &&
               here->height == there.height;
    };
    if (const auto own = fingerprint(dynamic_cast<Dynamics&>(*r.run));
        difference(checkpoint.model, own).empty() &&
        !std::equal(r.probes.begin(), r.probes.end(), beside.probes.begin(), beside.probes.end(), same))
        throw InputError("checkpoint " + path + " is of a run with other probes (there: " +
                         names_of(beside.probes, [](const Probe& p) { return p.name; }) +
                         "; here: " + names_of(r.probes, [](const auto& p) { return p->name; }) +
                         "); ask for the same ones before the run goes on");
    hinge::resume(dynamic_cast<Dynamics&>(*r.run), checkpoint, path);
    if (r.checkpoint && r.checkpoint->keep && !beside.kept.empty()) {
        r.checkpoint->keep->push(L);
        unpack_table(L, -1, beside.kept);
        lua_pop(L, 1);
    }
    static_cast<Recorded&>(r) = std::move(beside.recorded);
    for (std::size_t i = 0; i < r.probes.size(); ++i) *r.probes[i] = std::move(beside.probes[i]);
    r.files.past = std::move(beside.history);
    c.output.frames = std::move(beside.frames);
    r.progress.activations_seen = r.run->activations().size();
    if (!r.closed) r.resumed_at = r.run->steps_done();
    if (c.messages.progress)
        std::fprintf(stderr, r.closed ? "%s is of a run that has ended: %s\n" : "goes on from %s: %s\n", path.c_str(),
                     place_text(*r.run).c_str());
}

// ---- methods --------------------------------------------------------------------------------------------------------

std::string path_argument(lua_State* L, const std::string& function) {
    if (lua_type(L, 2) != LUA_TSTRING || lua_rawlen(L, 2) == 0)
        throw InputError(function + ": the file is " + show(L, 2) + "; give its name, such as 'case1.checkpoint'");
    return lua_tostring(L, 2);
}

void must_be_dynamic(const RunRecord& r, const std::string& function) {
    if (!dynamic_cast<const Dynamics*>(r.run.get()))
        throw InputError(function + ": the run is static; checkpoints are for dynamic runs, a static one is done anew");
}

int checkpoint(lua_State* L) {
    const auto r = self<RunBox>(L, "run:checkpoint").value;
    const std::string name = path_argument(L, "run:checkpoint");
    must_be_dynamic(*r, "run:checkpoint");
    if (r->mid_step)
        throw InputError(
            "run:checkpoint: called from a function in the middle of a step; call it between steps, or in run:on_step");
    const auto c = context(L);
    if (!c->mode.planning) write_checkpoint(L, *c, *r, checkpoint_path(*c, name));
    lua_settop(L, 1);
    return 1;
}

int resume(lua_State* L) {
    const auto r = self<RunBox>(L, "run:resume").value;
    const std::string name = path_argument(L, "run:resume");
    must_be_dynamic(*r, "run:resume");
    if (r->begun)
        throw InputError("run:resume: the run has begun (" + place_text(*r->run) + "); resume before its first step");
    const auto c = context(L);
    if (!c->mode.planning) read_checkpoint(L, *c, *r, checkpoint_path(*c, name));
    lua_settop(L, 1);
    return 1;
}

}  // namespace

namespace {

/// Whether somebody may still want to go on from it.
bool is_unfinished(const std::string& file) {
    try {
        const std::string bytes = read_whole(file);
        return !hinge::open_checkpoint(bytes, file).over;
    } catch (const OutsideError&) { return true; }
}

}  // namespace

// ---- by itself ------------------------------------------------------------------------------------------------------

std::optional<CheckpointPlan> read_checkpoint_plan(Options& o, const Model& model) {
    lua_State* L = o.L();
    const int type = o.push_field("checkpoint");
    CheckpointPlan plan;
    if (type == LUA_TSTRING) {
        plan.file = lua_tostring(L, -1);
    } else if (type == LUA_TTABLE) {
        Options own(L, -1, o.function() + ", checkpoint");
        own.expect({"file", "every", "keep"});
        plan.file = own.text("file").value_or("");
        plan.every = own.number("every", "s", Range::not_negative, plan.every);
        if (const int kind = own.push_field("keep"); kind == LUA_TTABLE)
            plan.keep.emplace(L, -1, model), pack_table(L, -1, own.function() + ": keep");
        else if (kind != LUA_TNIL)
            own.complain("keep", show(L, -1), "must be a table, whose values are kept with the run");
        lua_pop(L, 1);
    }
    const std::string shown = show(L, -1);
    lua_pop(L, 1);
    if (type == LUA_TNIL) return {};
    if (plan.file.empty())
        o.complain("checkpoint", shown, "must be a file name, or { file =, every = s, keep = table }");
    const auto c = context(L);
    if (c->mode.planning || runs_are_measured(L)) return {};
    plan.file = checkpoint_path(*c, plan.file);
    if (!c->output.folder.empty() && !c->output.checkpoints.insert(plan.file).second)
        o.complain("checkpoint", "'" + plan.file + "'",
                   "must be another file for each run of a script; an earlier run has this one");
    return plan;
}

void begin_checkpoints(lua_State* L, Context& c, RunRecord& r) {
    if (r.started || !dynamic_cast<const Dynamics*>(r.run.get())) return;
    if (!r.checkpoint) {
        if (c.mode.resume)
            std::fprintf(stderr, "--resume: the run made at %s names no checkpoint and starts from its beginning\n",
                         r.asked_at.c_str());
        return;
    }
    const std::string& file = r.checkpoint->file;
    const bool there = std::filesystem::exists(file);
    if (there && !std::filesystem::is_regular_file(file))
        throw OutsideError("cannot write the checkpoint " + file +
                           ": something that is no file has this name, such as a folder; move it, or give the "
                           "checkpoint another name");
    if (c.mode.resume && there) return read_checkpoint(L, c, r, file);
    if (c.mode.resume)
        std::fprintf(stderr, "--resume: there is no %s; the run starts from its beginning\n", file.c_str());
    if (there && is_unfinished(file) && std::rename(file.c_str(), (file + ".before").c_str()) == 0 &&
        c.messages.progress)
        std::fprintf(stderr,
                     "%s is of a run that is not over, and kept as %s.before; --resume would have gone on from it\n",
                     file.c_str(), file.c_str());
    write_checkpoint(L, c, r, file);
}

void mind_interrupts(lua_State* L, Context& c, RunRecord& r) {
    if (!c.signals.interrupted) return;
    if (!c.signals.ends_on_signals) {  // the prompt goes on, and so may the run
        asked_to_end = 0;
        c.signals.interrupted = 0;
        lua_sethook(L, nullptr, 0, 0);
        throw Interrupted("interrupted");
    }
    // the signal stays noted: a script that catches this error is not asked twice
    c.signals.exit_status = 128 + c.signals.interrupted;
    const std::string where = interrupted_by(c) + std::string(" after ") + place_text(*r.run) + "; ";
    std::string trouble;
    const Doing doing("writing the checkpoint");
    try {
        if (r.checkpoint) write_checkpoint(L, c, r, r.checkpoint->file);  // first, and with the rows in it
        write_rows(r);
    } catch (const OutsideError& e) { trouble = e.what(); }
    if (!trouble.empty()) throw Interrupted(where + trouble + "; what was written before stays as it was");
    if (!r.checkpoint)
        throw Interrupted(
            where + "the run names no checkpoint (checkpoint = 'FILE' in model:dynamic) and starts anew next time");
    c.signals.exit_status = 3;
    throw Interrupted(where + "written to " + r.checkpoint->file +
                      "; the same command with --resume goes on from there");
}

void keep_if_due(lua_State* L, Context& c, RunRecord& r) {
    if (!r.checkpoint || r.checkpoint->ended) return;
    const bool due = std::chrono::duration<double>(Clock::now() - r.checkpoint->last).count() >= r.checkpoint->every;
    if (!due && !r.closed) return;
    r.checkpoint->ended = r.closed;
    try {
        write_checkpoint(L, c, r, r.checkpoint->file);
    } catch (const OutsideError& e) {  // no reason to lose the run
        const std::string text = std::string(e.what()) + (r.closed ? "; the run is over" : "; the run goes on") +
                                 ", the checkpoint before stays as it was";
        std::fprintf(stderr, "%s\n", text.c_str());
        if (std::find(c.messages.warned.begin(), c.messages.warned.end(), text) == c.messages.warned.end())
            c.messages.warned.push_back(text);
    }
    r.checkpoint->last = Clock::now();
}

void open_checkpoint(lua_State* L, int module) {
    static const luaL_Reg methods[] = {{"checkpoint", guarded<takes<"run:checkpoint", 2, checkpoint>>},
                                       {"resume", guarded<takes<"run:resume", 2, resume>>},
                                       {nullptr, nullptr}};
    add_methods(L, RunBox::lua_name, methods);
    lua_pushcfunction(L, (guarded<takes<"hinge.resume", 2, resume>>));
    lua_setfield(L, module, "resume");
}

}  // namespace hinge::script
