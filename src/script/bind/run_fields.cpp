#include "script/bind/run_fields.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "core/text.h"
#include "effects/contact.h"
#include "run/dynamics.h"
#include "run/statics.h"
#include "advice/adviser.h"
#include "record/chain.h"
#include "record/recording.h"
#include "script/bind/run_box.h"

namespace hinge::script {
namespace {

/// Sets a field of the table on top of the stack.
void put(lua_State* L, const char* name, double value) { lua_pushnumber(L, value), lua_setfield(L, -2, name); }
void put(lua_State* L, const char* name, long value) { lua_pushinteger(L, value), lua_setfield(L, -2, name); }
void put(lua_State* L, const char* name, bool value) { lua_pushboolean(L, value), lua_setfield(L, -2, name); }
void put(lua_State* L, const char* name, const std::string& value) {
    lua_pushlstring(L, value.data(), value.size()), lua_setfield(L, -2, name);
}

/// Pushes a list; `fill` sets the fields of the table of each item.
template <class List, class Fill>
void push_list(lua_State* L, const List& list, Fill fill) {
    lua_newtable(L);
    int i = 0;
    for (const auto& item : list) {
        lua_newtable(L);
        fill(item);
        lua_rawseti(L, -2, ++i);
    }
}

/// J, by account.
void push_energy(lua_State* L, const ScriptRun& r) {
    const Energy e = r.run->energy();
    lua_createtable(L, 0, int(r.run->accounts().size()) + 2);
    put(L, "initial", e.initial);
    for (const AccountInfo& account : r.run->accounts()) put(L, std::string(account.name).c_str(), e[account.name]);
    put(L, "energy_error", e.error);
    put(L, "remainder", e.error);  // as in summary.json
}

/// { name = factor } of the load cases.
void push_cases(lua_State* L, const ScriptRun& r) {
    const Model& m = r.run->structure().model();
    lua_newtable(L);
    for (std::size_t i = 0; i < m.case_factors().size(); ++i) put(L, m.cases()[i].c_str(), m.case_factors()[i]);
}

void push_verdict(lua_State* L, const ScriptRun& r) { lua_pushstring(L, name(verdict_of(r))); }

void push_reason(lua_State* L, const ScriptRun& r) {
    lua_pushstring(L, (verdict_of(r) == r.run->verdict() ? reason_with_advice(*r.run) : reason_of(r)).c_str());
}

/// Sets what a failure is about, and its numbers, in the table on top of the stack.
void put_particulars(lua_State* L, const ScriptRun& r, const Failure& f) {
    const Structure& s = r.run->structure();
    if (f.step > 0) put(L, "step", f.step);
    if (f.time > 0) put(L, "time", f.time);
    if (f.node >= 0) put(L, "node", s.node_name(f.node));
    if (f.element >= 0) {
        put(L, "element", s.element_name(f.element));
        push_handle<MemberBox>(L, r.model, s.elements()[std::size_t(f.element)].member);
        lua_setfield(L, -2, "member");
    }
    if (f.node >= 0 && f.component >= 0) put(L, "component", std::string(component_name(f.component)));
    if (f.value != 0) put(L, "value", f.value);
    if (f.limit != 0 || f.tolerance != 0) put(L, "limit", f.limit != 0 ? f.limit : f.tolerance);
    if (f.count > 0) put(L, "count", f.count);
}

/// { cause =, text =, step =, time =, node =, element =, member =, component =, value =, limit =, count =, before = };
/// nil where the run has not failed.
void push_failure(lua_State* L, const ScriptRun& r) {
    if (verdict_of(r) != Verdict::failed) return lua_pushnil(L);
    const RunFailure* own = r.run->failure();
    lua_createtable(L, 0, 12);
    put(L, "cause", cause_of(r));
    if (!own) return put(L, "text", "goes on from " + r.weak);
    put(L, "text", r.run->brief_reason());
    put_particulars(L, r, own->what);
    for (const Remark& remark : own->remarks) {
        if (remark.kind != Remark::Kind::before) continue;
        lua_createtable(L, 0, 8);
        put(L, "cause", std::string(word(remark.of.cause)));
        put(L, "text", text_of(remark.of, r.run->structure()));
        put_particulars(L, r, remark.of);
        lua_setfield(L, -2, "before");
    }
}

void push_hash(lua_State* L, const ScriptRun& r) { lua_pushstring(L, hex_text(hash(r.run->state())).c_str()); }

void push_warnings(lua_State* L, const ScriptRun& r) {
    lua_newtable(L);
    int i = 0;
    const auto add = [&](const std::string& text) { lua_pushstring(L, text.c_str()), lua_rawseti(L, -2, ++i); };
    if (!r.weak.empty()) add("goes on from " + r.weak);
    for (const auto& list : {warnings_of(*r.run), findings_of(*r.run)})
        for (const Warning& w : list) add(warning_text(w));
}

void push_contacts(lua_State* L, const ScriptRun& r) {
    const auto* contact = contact_of(r.run->state());
    lua_createtable(L, 0, 2);
    put(L, "bound", long(contact ? contact->counts().bound : 0));
    put(L, "released", long(contact ? contact->counts().released : 0));
}

void push_counts(lua_State* L, const ScriptRun& r) {
    const auto* contact = contact_of(r.run->state());
    const EffectiveStiffness::Counts c = r.run->solver_counts();
    lua_createtable(L, 0, 9);
    put(L, "element_builds", long(c.built));
    put(L, "cg_iterations", long(c.iterations));
    put(L, "solves", long(c.solves));
    put(L, "factorisations", long(c.factorisations));
    put(L, "element_updates", r.run->element_updates());
    put(L, "rejected_steps", r.run->rejected());
    put(L, "substeps", r.run->substeps());
    put(L, "pair_tests", long(contact ? contact->counts().pair_tests : 0));
    put(L, "pair_lists", long(contact ? contact->counts().list_builds : 0));
}

void push_instability(lua_State* L, const ScriptRun& r) {
    if (!r.run->instability()) return lua_pushnil(L);
    const Instability& i = *r.run->instability();
    lua_createtable(L, 0, 8);
    put(L, "factor", i.factor);
    put(L, "beyond", i.beyond);
    put(L, "count", long(i.count));
    if (i.node >= 0) {
        put(L, "node", r.run->structure().node_name(i.node));
        put(L, "component", std::string(component_name(i.component)));
    }
    if (!i.members.empty()) put(L, "by", std::string(i.by_compression ? "compression" : "bending"));
    lua_createtable(L, int(i.members.size()), 0);
    for (std::size_t k = 0; k < i.members.size(); ++k) {
        push_handle<MemberBox>(L, r.model, i.members[k]);
        lua_rawseti(L, -2, lua_Integer(k) + 1);
    }
    lua_geti(L, -1, 1), lua_setfield(L, -3, "member");
    lua_setfield(L, -2, "members");
}

/// Effects that became active or inactive during the run.
void push_state_changes(lua_State* L, const ScriptRun& r) {
    push_list(L, r.run->activations(), [L](const Run::Activation& a) {
        put(L, "time", a.time), put(L, "effect", a.effect), put(L, "awake", a.awake), put(L, "why", a.why);
    });
}

void push_fastest(lua_State* L, const ScriptRun& r) {
    const Fastest* fastest = r.run->fastest_node();
    if (!fastest) return lua_pushnil(L);
    lua_createtable(L, 0, 3);
    put(L, "speed", fastest->speed);
    put(L, "time", fastest->time);
    put(L, "node", r.run->structure().node_name(fastest->node));
}

void push_probes(lua_State* L, const ScriptRun& r) {
    lua_createtable(L, int(r.probes.size()), 0);
    for (std::size_t i = 0; i < r.probes.size(); ++i)
        push<ProbeBox>(L, r.probes[i]), lua_rawseti(L, -2, lua_Integer(i) + 1);
}

void push_effects(lua_State* L, const ScriptRun& r) {
    push_list(L, r.run->effects(), [L](const PlanLine& e) {
        put(L, "name", e.name), put(L, "active", e.active), put(L, "because", e.because);
        put(L, "seconds", e.seconds), put(L, "asked_at", e.asked_at);
    });
}

void push_stages(lua_State* L, const ScriptRun& r) {
    push_list(L, r.run->stage_times(),
              [L](const StageTime& s) { put(L, "name", std::string(s.name)), put(L, "seconds", s.seconds); });
}

struct RunField {
    const char* name;
    void (*push)(lua_State* L, const ScriptRun& r);
};

/// The binding, the names in messages and completion, and lua/hinge/words/runs.d.lua
/// (tests/script/documents/reference_test.lua) have the same fields.
constexpr RunField run_field_list[] = {
    {"kind", [](lua_State* L, const ScriptRun& r) { lua_pushstring(L, r.run->kind()); }},
    {"model",
     [](lua_State* L, const ScriptRun& r) {
         push<ModelBox>(L, r.model);
         hold_registry(L, *r.model);
     }},
    {"time", [](lua_State* L, const ScriptRun& r) { lua_pushnumber(L, r.run->state().time); }},
    {"factor", [](lua_State* L, const ScriptRun& r) { lua_pushnumber(L, r.run->state().factor); }},
    {"index", [](lua_State* L, const ScriptRun& r) { lua_pushinteger(L, r.run->steps_done()); }},
    {"planned_steps", [](lua_State* L, const ScriptRun& r) { lua_pushinteger(L, r.run->planned_steps()); }},
    {"verdict", push_verdict},
    {"reason", push_reason},
    {"failure", push_failure},
    {"energy", push_energy},
    {"worst_energy_error", [](lua_State* L, const ScriptRun& r) { lua_pushnumber(L, r.worst_energy_error); }},
    {"contacts", push_contacts},
    {"stages", push_stages},
    {"effects", push_effects},
    {"wall_seconds", [](lua_State* L, const ScriptRun& r) { lua_pushnumber(L, r.wall); }},
    {"fastest", push_fastest},
    {"dt",
     [](lua_State* L, const ScriptRun& r) {
         const Dynamics* d = r.run->dynamics();
         d ? lua_pushnumber(L, d->dt()) : lua_pushnil(L);
     }},
    {"hash", push_hash},
    {"counts", push_counts},
    {"state_changes", push_state_changes},
    {"probes", push_probes},
    {"instability", push_instability},
    {"limit", [](lua_State* L,
                 const ScriptRun& r) { r.run->is_static() ? lua_pushboolean(L, r.run->limit()) : lua_pushnil(L); }},
    {"energy_error", [](lua_State* L, const ScriptRun& r) { lua_pushnumber(L, r.last_energy_share); }},
    {"energy_error_of_state", [](lua_State* L, const ScriptRun& r) { lua_pushnumber(L, r.state_energy_share); }},
    {"loads", push_cases},
    {"warnings", push_warnings},
};

}  // namespace

int run_fields(lua_State* L) {
    if (push_method(L)) return 1;
    const std::string key = key_argument(L);
    const auto& r = *self<RunBox>(L, "run." + key).value;
    if (r.number > 0 && (key == "verdict" || key == "reason" || key == "failure"))
        context(L)->runs.asked.insert(r.number);
    const auto* field = std::ranges::find_if(run_field_list, [&](const RunField& f) { return key == f.name; });
    if (field == std::end(run_field_list)) refuse_field(L, "run", key);
    field->push(L, r);
    return 1;
}

void name_run_fields(lua_State* L) {
    std::vector<const char*> names;
    for (const RunField& f : run_field_list) names.push_back(f.name);
    name_fields(L, RunBox::lua_name, names);
}

}  // namespace hinge::script
