// run:checkpoint and run:resume, and the field `checkpoint` of model:dynamic.
#include "script/bind/bind_checkpoint.h"

#include "core/doing.h"
#include "record/recording.h"
#include "record/run_checkpoint.h"
#include "script/lua/interrupts.h"
#include "script/lua/kept_values.h"
#include "script/bind/modules.h"

namespace hinge::script {
namespace {

/// A table of the script that a checkpoint keeps.
class KeptTable : public KeptValues {
public:
    KeptTable(lua_State* L, int index, const Model& model) : table_(L, index, model), context_(context(L)) {}

    std::string pack() override {
        lua_State* L = context_->running;
        table_.push(L);
        std::string bytes = pack_table(L, -1, "model:dynamic, checkpoint: keep");
        lua_pop(L, 1);
        return bytes;
    }
    void check(const std::string& bytes) const override { check_packed_table(bytes); }
    void unpack(const std::string& bytes) override {
        lua_State* L = context_->running;
        table_.push(L);
        unpack_table(L, -1, bytes);
        lua_pop(L, 1);
    }

private:
    LuaValue table_;
    std::shared_ptr<ScriptContext> context_;
};

std::string path_argument(lua_State* L, const std::string& function) {
    if (lua_type(L, 2) != LUA_TSTRING || lua_rawlen(L, 2) == 0)
        throw InputError(function + ": the file is " + show(L, 2) + "; give its name, such as 'case1.checkpoint'");
    return lua_tostring(L, 2);
}

void must_be_dynamic(const RunRecord& r, const std::string& function) {
    if (r.run->is_static())
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
    c->running = L;
    if (!c->mode.planning) write_checkpoint(*c, *r, checkpoint_path(*c, name));
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
    c->running = L;
    if (!c->mode.planning) read_checkpoint(*c, *r, checkpoint_path(*c, name));
    lua_settop(L, 1);
    return 1;
}

}  // namespace

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
            plan.keep = std::make_shared<KeptTable>(L, -1, model), pack_table(L, -1, own.function() + ": keep");
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

void mind_interrupts(lua_State* L, ScriptContext& c, RunRecord& r) {
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
        if (r.checkpoint) write_checkpoint(c, r, r.checkpoint->file);  // first, and with the rows in it
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

void open_checkpoint(lua_State* L, int module) {
    static const luaL_Reg methods[] = {{"checkpoint", guarded<takes<"run:checkpoint", 2, checkpoint>>},
                                       {"resume", guarded<takes<"run:resume", 2, resume>>},
                                       {nullptr, nullptr}};
    add_methods(L, RunBox::lua_name, methods);
    lua_pushcfunction(L, (guarded<takes<"hinge.resume", 2, resume>>));
    lua_setfield(L, module, "resume");
}

}  // namespace hinge::script
