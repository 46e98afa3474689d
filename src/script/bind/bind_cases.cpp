// Load cases: model:case, model:combination, and the cases of a run.
#include <algorithm>

#include "core/text.h"
#include "script/bind/model_methods.h"
#include "script/bind/modules.h"
#include "script/bind/run_box.h"

namespace hinge::script {

std::string name_of(const CaseBox& c) {
    return "load case '" + (c.index < int(c.model->cases().size()) ? c.model->cases()[c.index] : "") + "'";
}

namespace {

std::string known_names(const Model& m, const std::string& typed, bool combinations) {
    std::vector<std::string> names = m.cases();
    if (combinations)
        for (const LoadCombination& c : m.combinations()) names.push_back(c.name);
    if (names.empty()) return "; the model has no load cases, declare one with model:case \"name\"";
    std::string list;
    for (const auto& n : names) list += (list.empty() ? "'" : ", '") + n + "'";
    return did_you_mean(typed, names) + "; the model has " + list;
}

std::string name_argument(lua_State* L, const char* function) {
    if (lua_type(L, 2) != LUA_TSTRING || lua_rawlen(L, 2) == 0)
        throw InputError(std::string(function) + ": the name is " + show(L, 2) + "; must be a string, such as 'dead'");
    return lua_tostring(L, 2);
}

void must_be_new(const Model& m, const char* function, const std::string& name) {
    const char* is = m.find_case(name) >= 0 ? "load case" : m.find_combination(name) ? "combination" : nullptr;
    if (is) throw InputError(std::string(function) + ": there is a " + is + " '" + name + "' already");
}

using Factors = std::vector<std::optional<double>>;

void add_named(lua_State* L, int index, const std::string& what, const Model& m, double factor, bool combinations,
               Factors& factors) {
    const auto add = [&](int load_case, double by) { factors[load_case] = factors[load_case].value_or(0) + by; };
    if (find<CaseBox>(L, index)) return add(case_argument(L, index, what, m), factor);
    if (lua_type(L, index) != LUA_TSTRING)
        throw InputError(what + " holds " + show(L, index) + "; must be names of load cases, each with its factor");
    const std::string name = lua_tostring(L, index);
    if (const int load_case = m.find_case(name); load_case >= 0) return add(load_case, factor);
    const LoadCombination* combination = combinations ? m.find_combination(name) : nullptr;
    if (!combination) throw InputError(what + ": no load case '" + name + "'" + known_names(m, name, combinations));
    for (const auto& [load_case, by] : combination->factors) add(load_case, factor * by);
}

/// { name = factor, ... }
Factors read_factors(lua_State* L, int index, const std::string& what, const Model& m, bool combinations) {
    index = lua_absindex(L, index);
    Factors factors(m.cases().size());
    std::vector<std::pair<std::string, double>> sorted;  // so that sums do not depend on the order of a table
    lua_pushnil(L);
    while (lua_next(L, index)) {
        const bool nan = lua_type(L, -1) == LUA_TNUMBER && std::isnan(lua_tonumber(L, -1));
        const std::string shown = nan ? "not a number (nan)" : show(L, -1);
        const bool number = lua_type(L, -1) == LUA_TNUMBER && std::isfinite(lua_tonumber(L, -1));
        const double factor = lua_tonumber(L, -1);
        lua_pop(L, 1);
        if (lua_type(L, -1) == LUA_TSTRING) {
            if (!number)
                throw InputError(what + ": '" + lua_tostring(L, -1) + "' is " + shown +
                                 "; must be a finite number, its factor");
            sorted.emplace_back(lua_tostring(L, -1), factor);
            continue;
        }
        if (!number)
            throw InputError(what + ": " + show(L, -1) + " = " + shown +
                             "; write { name = factor, ... }, such as "
                             "{ dead = 1.35, live = 1.5 }");
        if (!find<CaseBox>(L, -1))
            throw InputError(what + ": item [" + show(L, -1) +
                             "] has no name; write { name = factor, ... }, such as "
                             "{ dead = 1.35, live = 1.5 }");
        sorted.emplace_back(m.cases()[case_argument(L, -1, what, m)], factor);
    }
    std::sort(sorted.begin(), sorted.end());
    for (const auto& [name, factor] : sorted) {
        lua_pushlstring(L, name.data(), name.size());
        add_named(L, -1, what, m, factor, combinations, factors);
        lua_pop(L, 1);
    }
    return factors;
}

}  // namespace

int case_argument(lua_State* L, int index, const std::string& what, const Model& model) {
    if (const auto* c = find<CaseBox>(L, index)) {
        if (const std::string since = gone(*c); !since.empty()) throw InputError(what + " is a load case" + since);
        if (c->model.get() != &model)
            throw InputError(what + " is " + name_of(*c) + " of another model; use one of this model");
        return c->index;
    }
    if (lua_type(L, index) != LUA_TSTRING)
        throw InputError(what + " is " + show(L, index) + "; must be a load case or the name of one");
    const std::string name = lua_tostring(L, index);
    const int found = model.find_case(name);
    if (found < 0) throw InputError(what + ": no load case '" + name + "'" + known_names(model, name, false));
    return found;
}

int case_of(Options& o, const Model& model) {
    const bool given = o.push_field("case") != LUA_TNIL;
    const int found = given ? case_argument(o.L(), -1, o.function() + ": field 'case'", model) : -1;
    lua_pop(o.L(), 1);
    return found;
}

LoadChoice read_choice(Options& o, const Model& m, const RunRecord* from, bool is_static) {
    lua_State* L = o.L();
    LoadChoice choice;
    choice.is_static = is_static;
    const std::size_t cases = m.cases().size();
    choice.factor.assign(cases, 0), choice.named.assign(cases, 0);
    std::vector<char> known(cases, 0);
    if (from) {
        const Model& before = from->run->structure().model();
        const bool was_static = std::string_view(from->run->kind()) == "static";
        choice.from = &before;
        if (was_static && !context(L)->mode.planning) choice.reached = from->run->state().factor;
        for (std::size_t i = 0; i < before.case_factors().size(); ++i) {
            const double held = before.holds_loads() ? before.held_factors()[i] : 0;
            choice.factor[i] = held + choice.reached * (before.case_factors()[i] - held);
            choice.named[i] = was_static && choice.factor[i] != 0;
            known[i] = 1;
        }
    }
    const int type = o.push_field("loads");
    const std::string what = o.function() + ": field 'loads'";
    if (type == LUA_TNIL) {
        std::string unknown;
        for (std::size_t i = 0; i < cases; ++i)
            if (!known[i]) unknown += (unknown.empty() ? "'" : ", '") + m.cases()[i] + "'";
        if (!unknown.empty())
            throw InputError(o.function() + ": the model has load cases, and this run does not say whether it takes " +
                             unknown + "; give loads = { " + m.cases()[0] +
                             " = 1, ... }, or the name of a combination" +
                             (from ? "; what the run before had goes on" : ""));
    } else {
        Factors factors(cases);
        if (type == LUA_TTABLE) factors = read_factors(L, -1, what, m, true);
        else if (type == LUA_TSTRING || find<CaseBox>(L, -1)) add_named(L, -1, what, m, 1, true, factors);
        else
            o.complain("loads", show(L, -1),
                       "must be { name = factor, ... }, such as { dead = 1.35, live = 1.5 }, or the name of a "
                       "combination or a load case");
        for (std::size_t i = 0; i < cases; ++i)
            if (factors[i]) choice.factor[i] = *factors[i], choice.named[i] = 1;
        if (cases == 0)
            o.complain("loads", "given", "the model has no load cases; declare one with model:case \"name\"");
    }
    lua_pop(L, 1);
    return choice;
}

int declare_case(lua_State* L) {
    auto& m = self<ModelBox>(L, "model:case").value;
    const std::string name = name_argument(L, "model:case");
    if (const int known = m->find_case(name); known >= 0) {
        push_handle<CaseBox>(L, m, known);
        return 1;
    }
    must_be_new(*m, "model:case", name);
    push_handle<CaseBox>(L, m, m->add_case(name));
    return 1;
}

int declare_combination(lua_State* L) {
    auto& m = self<ModelBox>(L, "model:combination").value;
    LoadCombination combination{name_argument(L, "model:combination"), {}};
    must_be_new(*m, "model:combination", combination.name);
    if (!lua_istable(L, 3))
        throw InputError("model:combination: the factors are " + show(L, 3) +
                         "; must be { name = factor, ... }, such as { dead = 1.35, live = 1.5 }");
    const Factors factors = read_factors(L, 3, "model:combination: '" + combination.name + "'", *m, true);
    for (std::size_t i = 0; i < factors.size(); ++i)
        if (factors[i]) combination.factors.emplace_back(int(i), *factors[i]);
    if (combination.factors.empty())
        throw InputError("model:combination: '" + combination.name + "' is empty; give { name = factor, ... }");
    m->add_combination(std::move(combination));
    return 0;
}

int model_cases(lua_State* L) {
    auto& m = self<ModelBox>(L, "model:cases").value;
    lua_createtable(L, int(m->cases().size()), 0);
    for (std::size_t i = 0; i < m->cases().size(); ++i) {
        push_handle<CaseBox>(L, m, int(i));
        lua_rawseti(L, -2, lua_Integer(i) + 1);
    }
    return 1;
}

namespace {

void push_model(lua_State* L, const std::shared_ptr<ScriptModel>& m) {
    push<ModelBox>(L, m);
    hold_registry(L, *m);
}

/// case:load(options): model:load with this case.
int case_load(lua_State* L) {
    const auto& c = self<CaseBox>(L, "case:load");
    const Options o(L, 2, "case:load");
    lua_newtable(L);
    const int copy = lua_gettop(L);
    lua_pushnil(L);
    while (lua_next(L, 2)) {
        if (lua_type(L, -2) == LUA_TSTRING && std::string_view(lua_tostring(L, -2)) == "case")
            o.complain("case", "given", "this load belongs to " + name_of(c) + " already; leave it out");
        lua_pushvalue(L, copy);
        lua_pushvalue(L, -3);
        lua_rotate(L, -3, -1);  // the copy, the key, the value
        protect(L, 3, 0, [](lua_State* inner) { lua_rawset(inner, 1), lua_settop(inner, 0); });
    }
    lua_settop(L, copy);
    lua_pushvalue(L, 1);
    lua_setfield(L, copy, "case");
    push_model(L, c.model);
    lua_pushvalue(L, copy);
    lua_replace(L, 2);
    lua_replace(L, 1);
    lua_settop(L, 2);
    return declaring(L, "case:load", add_load);
}

int case_gravity(lua_State* L) {
    const auto& c = self<CaseBox>(L, "case:gravity");
    lua_settop(L, 2);
    push_handle<CaseBox>(L, c.model, c.index);
    push_model(L, c.model);
    lua_replace(L, 1);
    return declaring(L, "case:gravity", set_gravity);
}

int case_fields(lua_State* L) {
    if (push_method(L)) return 1;
    const std::string key = key_argument(L);
    const auto& c = self<CaseBox>(L, "case." + key);
    if (key != "name") refuse_field(L, "case", key);
    lua_pushstring(L, c.model->cases()[c.index].c_str());
    return 1;
}

int case_text(lua_State* L) {
    const auto& c = self_or_gone<CaseBox>(L, "tostring");
    lua_pushstring(L, (name_of(c) + gone(c)).c_str());
    return 1;
}

}  // namespace

void open_cases(lua_State* L) {
    static const luaL_Reg of_case[] = {{"load", guarded<takes<"case:load", 2, case_load>>},
                                       {"gravity", guarded<takes<"case:gravity", 2, case_gravity>>},
                                       {nullptr, nullptr}};
    static const luaL_Reg of_model[] = {{"case", guarded<takes<"model:case", 2, declare_case>>},
                                        {"combination", guarded<takes<"model:combination", 3, declare_combination>>},
                                        {"cases", guarded<takes<"model:cases", 1, model_cases>>},
                                        {nullptr, nullptr}};
    make_metatable(L, CaseBox::lua_name, of_case, guarded<case_fields>, collect<CaseBox>, guarded<case_text>, nullptr);
    name_fields(L, CaseBox::lua_name, {"name"});
    add_methods(L, ModelBox::lua_name, of_model);
}

}  // namespace hinge::script
