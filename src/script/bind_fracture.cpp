// model:fracture: limits, or a rule of the script's own that is shown sections, one by one or all at once.
#include <algorithm>
#include <bitset>
#include <cmath>

#include "script/objects.h"

namespace hinge::script {
namespace {

constexpr int field_count = int(SectionField::step) + 1;

/// What a rule is handed: the same object at every call, full while the rule runs.
struct SectionViewBox { static constexpr const char* lua_name = "hinge.section_view"; std::weak_ptr<Model> model; std::vector<std::string> keep; const SectionView* now; };
struct ElementListBox {
    static constexpr const char* lua_name = "hinge.element_list";
    const ElementList* now;
    std::bitset<3 * field_count> filled;   ///< arrays that hold what is now
    std::vector<double> room;
};

/// The field that the key at `index` names, -1 for none. Upvalue 1: numbers of the fields by name; 2: the metatable.
int field_at(lua_State* L, int index) {
    lua_pushvalue(L, index);
    const int field = lua_rawget(L, lua_upvalueindex(1)) == LUA_TNUMBER ? int(lua_tointeger(L, -1)) : -1;
    lua_pop(L, 1);
    return field;
}

[[noreturn]] void no_field(lua_State* L, const char* what, std::vector<std::string> others) {
    const std::string key = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : show(L, 2);
    others.insert(others.end(), section_field_names.begin(), section_field_names.end());
    throw InputError(std::string(what) + " has no field '" + key + "'" + did_you_mean(key, others));
}

SectionViewBox& view_in_use(lua_State* L) {
    auto& box = self<SectionViewBox>(L, "section");
    if (!box.now) throw InputError("section: read after its rule has returned; take the numbers you need while the rule runs");
    return box;
}

double* kept_at(lua_State* L, const SectionViewBox& box) {
    if (lua_type(L, 2) != LUA_TSTRING) return nullptr;
    const auto at = std::find(box.keep.begin(), box.keep.end(), lua_tostring(L, 2));
    return at == box.keep.end() ? nullptr : box.now->kept + (at - box.keep.begin());
}

int view_get_other(lua_State* L) {
    const auto& box = view_in_use(L);
    const SectionView& v = *box.now;
    if (const double* kept = kept_at(L, box)) return lua_pushnumber(L, *kept), 1;
    if (lua_type(L, 2) != LUA_TSTRING || std::string(lua_tostring(L, 2)) != "group") {
        std::vector<std::string> others = box.keep;
        others.push_back("group");
        no_field(L, "section", others);
    }
    const auto model = box.model.lock();
    if (!model || model->members()[v.member].groups.empty()) return lua_pushnil(L), 1;
    return lua_pushstring(L, model->groups()[model->members()[v.member].groups[0]].c_str()), 1;
}

/// Called for every number that a rule reads.
int view_get(lua_State* L) {
    if (!lua_getmetatable(L, 1) || !lua_rawequal(L, -1, lua_upvalueindex(2))) return guarded<view_get_other>(L);
    lua_settop(L, 2);
    const SectionView* v = static_cast<const SectionViewBox*>(lua_touserdata(L, 1))->now;
    const int field = v ? field_at(L, 2) : -1;
    if (field < 0) return guarded<view_get_other>(L);
    const double value = value_of(*v, SectionField(field));
    switch (SectionField(field)) {
        case SectionField::plastic: lua_pushboolean(L, v->plastic); break;
        case SectionField::node: v->node < 0 ? lua_pushnil(L) : lua_pushinteger(L, v->node + 1); break;
        case SectionField::member: case SectionField::element: case SectionField::end: case SectionField::step: lua_pushinteger(L, lua_Integer(value)); break;
        default: lua_pushnumber(L, value);
    }
    return 1;
}

int view_set(lua_State* L) {
    const auto& box = view_in_use(L);
    double* kept = kept_at(L, box);
    const std::string key = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : show(L, 2);
    if (!kept) throw InputError("section: field '" + key + "' cannot be set; name what the rule keeps of each section: model:fracture{ rule =, keep = { '" + key + "' } }");
    if (lua_type(L, 3) != LUA_TNUMBER || !std::isfinite(lua_tonumber(L, 3))) throw InputError("section: field '" + key + "' is set to " + show(L, 3) + "; what a rule keeps must be finite numbers");
    *kept = lua_tonumber(L, 3);
    return 0;
}

int view_text(lua_State* L) {
    const auto& box = self<SectionViewBox>(L, "tostring");
    if (!box.now) return lua_pushliteral(L, "section of a rule that has returned"), 1;
    lua_pushfstring(L, "end %d of element %d, member %d", box.now->end, box.now->element + 1, box.now->member + 1);
    return 1;
}

ElementListBox& list_in_use(lua_State* L) {
    auto& box = self<ElementListBox>(L, "elements");
    if (!box.now) throw InputError("elements: read after their rule has returned; take the numbers you need while the rule runs");
    return box;
}

int list_get(lua_State* L) {
    auto& box = list_in_use(L);
    const int place = field_at(L, 2);
    const std::string key = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : "";
    if (key == "count") return lua_pushinteger(L, box.now->count()), 1;
    if (key == "time") return lua_pushnumber(L, box.now->time()), 1;
    if (key == "dt") return lua_pushnumber(L, box.now->dt()), 1;
    if (key == "step") return lua_pushinteger(L, box.now->step()), 1;
    if (place < 0) no_field(L, "elements", {"count", "Mx1", "Mx2", "My1", "My2", "f_y1", "f_y2", "node1", "node2", "plastic1", "plastic2"});
    lua_getiuservalue(L, 1, 1);  // the arrays, by place
    const bool there = lua_rawgeti(L, -1, place + 1) == LUA_TTABLE;
    if (there && box.filled[place]) return 1;
    const int n = box.now->count();
    if (!there) {
        lua_pop(L, 1);
        lua_createtable(L, n, 0);
        lua_pushvalue(L, -1);
        lua_rawseti(L, -3, place + 1);
    }
    box.room.resize(n);
    box.now->read(SectionField(place % field_count), place / field_count, box.room.data());
    protect(L, 1, 1, [&](lua_State* L) {
        for (int i = 0; i < n; ++i) lua_pushnumber(L, box.room[i]), ::lua_rawseti(L, 1, i + 1);
    });
    box.filled.set(place);
    return 1;
}

int list_length(lua_State* L) { return lua_pushinteger(L, list_in_use(L).now->count()), 1; }

/// T's metatable, made once, with the fields by number for its __index; `by_end`: what differs between the ends has a name for each.
template <class T, bool by_end>
void ready_metatable(lua_State* L, lua_CFunction get, const luaL_Reg* others) {
    luaL_newmetatable(L, T::lua_name);
    const bool made = lua_getfield(L, -1, "__gc") != LUA_TNIL;  // the last of it: memory may have run out half way
    lua_pop(L, 1);
    if (!made) {
        lua_createtable(L, 0, field_count);
        for (int i = 0; i < field_count; ++i)
            if (by_end && at_ends(SectionField(i)))
                for (int end : {1, 2}) lua_pushinteger(L, end * field_count + i), lua_setfield(L, -2, (section_field_names[i] + std::to_string(end)).c_str());
            else lua_pushinteger(L, i), lua_setfield(L, -2, section_field_names[i].c_str());
        lua_pushvalue(L, -2);
        lua_pushcclosure(L, get, 2);
        lua_setfield(L, -2, "__index");
        luaL_setfuncs(L, others, 0);
    }
    lua_pop(L, 1);
}

/// Full while a rule runs.
template <class Box, class Shown>
struct Showing {
    Box& box;
    Showing(Box& box, const Shown& now) : box(box) { box.now = &now; }
    ~Showing() { box.now = nullptr; }
};

FractureHook read_rule(lua_State* L, int index, const std::shared_ptr<Model>& model, const std::vector<std::string>& keep) {
    const LuaFunction f(L, index, *model);
    static const luaL_Reg others[] = {{"__newindex", guarded<view_set>}, {"__tostring", guarded<view_text>}, {"__gc", collect<SectionViewBox>}, {nullptr, nullptr}};
    ready_metatable<SectionViewBox, false>(L, view_get, others);
    auto* box = push<SectionViewBox>(L, model, keep, nullptr);
    const LuaValue view(L, -1, *model);
    lua_pop(L, 1);
    return [f, view, box](const SectionView& section) {
        lua_State* L = f.running();
        f.push(L);
        view.push(L);
        const Showing<SectionViewBox, SectionView> showing(*box, section);
        call_hook(L, f, 1, 1);
        const int type = lua_type(L, -1);
        const bool breaks = lua_toboolean(L, -1);
        const std::string shown = type == LUA_TBOOLEAN || type == LUA_TNIL ? "" : show(L, -1);
        lua_pop(L, 1);
        if (!shown.empty()) throw HookError(f.place() + ": model:fracture: the rule returned " + shown + "; it must return true where the section breaks, false or nil where it holds");
        return breaks;
    };
}

FractureBatch read_batch(lua_State* L, int index, const std::shared_ptr<Model>& model) {
    const LuaFunction f(L, index, *model);
    static const luaL_Reg others[] = {{"__len", guarded<list_length>}, {"__gc", collect<ElementListBox>}, {nullptr, nullptr}};
    ready_metatable<ElementListBox, true>(L, guarded<list_get>, others);
    auto* box = push<ElementListBox>(L);
    lua_newtable(L);
    lua_setiuservalue(L, -2, 1);
    const LuaValue view(L, -1, *model);
    lua_pop(L, 1);
    return [f, view, box](const ElementList& elements, std::vector<int>& breaks) {
        lua_State* L = f.running();
        f.push(L);
        view.push(L);
        box->filled.reset();
        const Showing<ElementListBox, ElementList> showing(*box, elements);
        call_hook(L, f, 1, 1);
        std::string wrong = lua_istable(L, -1) || lua_isnil(L, -1) ? "" : show(L, -1);
        if (lua_istable(L, -1))
            for (lua_Integer i = 1, n = lua_rawlen(L, -1); i <= n && wrong.empty(); ++i) {
                lua_rawgeti(L, -1, i);
                int whole = 0;
                const lua_Integer place = lua_tointegerx(L, -1, &whole);
                if (!whole || place < 1 || place > elements.count()) wrong = show(L, -1) + " as item " + std::to_string(i);
                else breaks.push_back(int(place) - 1);
                lua_pop(L, 1);
            }
        lua_pop(L, 1);
        if (!wrong.empty())
            throw HookError(f.place() + ": model:fracture: the batch rule returned " + wrong + "; it must return nil, or a list of the elements that break, whole numbers from 1 to " + std::to_string(elements.count()));
    };
}

std::vector<std::string> read_keep(Options& o) {
    std::vector<std::string> keep;
    lua_State* L = o.L();
    const int type = o.push_field("keep");
    if (type != LUA_TNIL && type != LUA_TTABLE) o.complain("keep", show(L, -1), "must be a list of names, such as { 'damage' }");
    for (lua_Integer i = 1, n = type == LUA_TTABLE ? lua_rawlen(L, -1) : 0; i <= n; ++i) {
        lua_rawgeti(L, -1, i);
        const std::string name = lua_type(L, -1) == LUA_TSTRING ? lua_tostring(L, -1) : "";
        if (name.empty()) o.complain("keep", show(L, -1) + " as item " + std::to_string(i), "must be a list of names, such as { 'damage' }");
        if (name == "group" || std::find(section_field_names.begin(), section_field_names.end(), name) != section_field_names.end())
            o.complain("keep", "'" + name + "'", "is a field that every section has; choose another name");
        keep.push_back(name);
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
    return keep;
}

}  // namespace

int fracture_rule(lua_State* L) {
    auto& m = self<ModelBox>(L, "model:fracture").value;
    FractureRule rule;
    rule.asked_at = where(L);
    if (lua_isfunction(L, 2)) {
        rule.hook = read_rule(L, 2, m, {});
    } else {
        if (!lua_istable(L, 2)) throw InputError("model:fracture: takes a table of limits or a function, got " + show(L, 2));
        Options o(L, 2, "model:fracture");
        o.expect({"curvature_x", "curvature_y", "axial_strain", "tension_only", "rule", "batch", "where", "keep", "group"});
        const auto take = [&](const char* field, const char* unit, double& limit) {
            if (const auto v = o.maybe_number(field, unit, Range::positive)) limit = *v;
        };
        take("curvature_x", "1/m", rule.curvature_x);
        take("curvature_y", "1/m", rule.curvature_y);
        take("axial_strain", "", rule.axial_strain);
        rule.tension_only = o.flag("tension_only", false);
        rule.keep = read_keep(o);
        const int type = o.push_field("rule");
        if (type == LUA_TFUNCTION) rule.hook = read_rule(L, -1, m, rule.keep);
        else if (type != LUA_TNIL) o.complain("rule", show(L, -1), "must be a function of a section that returns true where it breaks");
        lua_pop(L, 1);
        const int batch = o.push_field("batch");
        if (batch == LUA_TFUNCTION) rule.batch = read_batch(L, -1, m);
        else if (batch != LUA_TNIL) o.complain("batch", show(L, -1), "must be a function of all elements that returns a list of those that break");
        lua_pop(L, 1);
        if (rule.hook && rule.batch) o.complain("batch", "given beside rule", "a rule is asked section by section or of all at once; give one of the two");
        const std::string where = o.word("where", {"plastic", "yielded", "all"}, "plastic");
        rule.where = where == "all" ? FractureRule::Where::all : where == "yielded" ? FractureRule::Where::yielded : FractureRule::Where::plastic;
        for (const char* field : {"where", "keep"})
            if (!rule.hook && o.has(field)) o.complain(field, "given", "belongs to a rule that is asked section by section; give rule = a function");
        if (o.push_field("group") != LUA_TNIL) rule.group = group_argument(L, -1, "model:fracture: field 'group'", *m);
        lua_pop(L, 1);
        if (!rule.hook && !rule.batch && !std::isfinite(rule.curvature_x) && !std::isfinite(rule.curvature_y) && !std::isfinite(rule.axial_strain))
            throw InputError("model:fracture: no limit is given; give curvature_x, curvature_y (1/m), axial_strain, or a function");
    }
    m->add_fracture(std::move(rule));
    m->ask("fracture", where(L));
    return 0;
}

}  // namespace hinge::script
