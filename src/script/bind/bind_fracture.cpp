// model:fracture: limits, or a rule of the script that checks sections.
#include <algorithm>
#include <cmath>

#include "effects/fracture.h"
#include "record/probe.h"
#include "script/bind/model_methods.h"

namespace hinge::script {
namespace {

constexpr int field_count = int(SectionField::step) + 1;

/// What a rule is handed: the same object at every call, full while the rule runs.
///
/// To Lua a section is an empty table. Its metatable's __index is a table of those fields that the rule was seen to
/// read: they are put there before it is called, three times as fast as a call for each. That table's own __index has
/// all the others.
struct SectionViewBox {
    static constexpr const char* lua_name = "hinge.section_view";
    std::weak_ptr<Model> model;
    std::vector<std::string> keep;
    const SectionView* now = nullptr;
    std::vector<SectionField> read = {};  ///< what the rule reads, none twice
};
/// The field that the key at 2 names, -1 for none. Upvalue 1: numbers of the fields by name.
int field_at(lua_State* L) {
    lua_pushvalue(L, 2);
    const int field = lua_rawget(L, lua_upvalueindex(1)) == LUA_TNUMBER ? int(lua_tointeger(L, -1)) : -1;
    lua_pop(L, 1);
    return field;
}

[[noreturn]] void no_field(lua_State* L, const char* what, std::vector<std::string> others) {
    const std::string key = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : show(L, 2);
    others.insert(others.end(), section_field_names.begin(), section_field_names.end());
    throw InputError(std::string(what) + " has no field '" + key + "'" + did_you_mean(key, others));
}

/// The box of a section's metatable. Upvalue 2: its userdata, which a finalizer at the very end may find collected.
SectionViewBox& box_of_view(lua_State* L) {
    if (auto* box = find<SectionViewBox>(L, lua_upvalueindex(2))) return *box;
    throw InputError("section: its rule is gone");
}

SectionViewBox& view_in_use(lua_State* L) {
    auto& box = box_of_view(L);
    if (!box.now)
        throw InputError("section: read after its rule has returned; take the numbers you need while the rule runs");
    return box;
}

double* kept_at(lua_State* L, const SectionViewBox& box) {
    if (lua_type(L, 2) != LUA_TSTRING) return nullptr;
    const auto at = std::find(box.keep.begin(), box.keep.end(), lua_tostring(L, 2));
    return at == box.keep.end() ? nullptr : box.now->kept + (at - box.keep.begin());
}

void push_field(lua_State* L, const SectionView& v, SectionField field) {
    switch (field) {
        case SectionField::plastic: return lua_pushboolean(L, v.plastic);
        case SectionField::node: return v.node < 0 ? lua_pushnil(L) : lua_pushinteger(L, v.node + 1);
        case SectionField::member:
        case SectionField::element:
        case SectionField::end:
        case SectionField::step: return lua_pushinteger(L, lua_Integer(value_of(v, field)));
        default: return lua_pushnumber(L, value_of(v, field));
    }
}

int view_get(lua_State* L) {
    auto& box = view_in_use(L);
    const SectionView& v = *box.now;
    if (const int field = field_at(L); field >= 0) {
        if (std::find(box.read.begin(), box.read.end(), SectionField(field)) == box.read.end())
            box.read.push_back(SectionField(field));
        return push_field(L, v, SectionField(field)), 1;
    }
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

int view_set(lua_State* L) {
    const auto& box = view_in_use(L);
    double* kept = kept_at(L, box);
    const std::string key = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : show(L, 2);
    if (!kept)
        throw InputError(
            "section: field '" + key +
            "' cannot be set; name what the rule keeps of each section: model:fracture{ rule =, keep = { '" + key +
            "' } }");
    if (lua_type(L, 3) != LUA_TNUMBER || !std::isfinite(lua_tonumber(L, 3)))
        throw InputError("section: field '" + key + "' is set to " + show(L, 3) +
                         "; what a rule keeps must be finite numbers");
    *kept = lua_tonumber(L, 3);
    return 0;
}

int view_text(lua_State* L) {
    const auto& box = box_of_view(L);
    if (!box.now) return lua_pushliteral(L, "section of a rule that has returned"), 1;
    lua_pushfstring(L, "end %d of element %d, member %d", box.now->end, box.now->element + 1, box.now->member + 1);
    return 1;
}

/// Pushes the table of the fields' numbers by name.
void push_field_numbers(lua_State* L) {
    lua_createtable(L, 0, field_count);
    for (int i = 0; i < field_count; ++i) lua_pushinteger(L, i), lua_setfield(L, -2, section_field_names[i].c_str());
}

/// Pushes a section and the table of its fields that are put there (SectionViewBox). Upvalues of all its functions:
/// numbers of the fields by name, the box.
SectionViewBox* push_section(lua_State* L, const std::shared_ptr<Model>& model, const std::vector<std::string>& keep) {
    luaL_newmetatable(L, SectionViewBox::lua_name);
    lua_pushcclosure(L, collect<SectionViewBox>, 0);
    lua_setfield(L, -2, "__gc");
    lua_pop(L, 1);
    push_field_numbers(L);
    const int numbers = lua_gettop(L), userdata = numbers + 1, section = numbers + 2, meta = numbers + 3,
              fields = numbers + 4, others = numbers + 5;
    auto* box = push<SectionViewBox>(L, model, keep);
    for (int i = section; i <= others; ++i) lua_createtable(L, 0, i == fields ? field_count : 0);
    const auto set = [&](int table, const char* event, lua_CFunction f) {
        lua_pushvalue(L, numbers), lua_pushvalue(L, userdata);
        lua_pushcclosure(L, f, 2);
        lua_setfield(L, table, event);
    };
    set(meta, "__newindex", guarded<view_set>);
    set(meta, "__tostring", guarded<view_text>);
    lua_pushboolean(L, 0), lua_setfield(L, meta, "__metatable");
    lua_pushvalue(L, fields), lua_setfield(L, meta, "__index");
    set(others, "__index", guarded<view_get>);
    lua_setmetatable(L, fields);
    lua_rotate(L, meta, 1);  // the fields below the metatable
    lua_setmetatable(L, section);
    lua_rotate(L, numbers, 2);
    lua_pop(L, 2);
    return box;
}

/// Sections on their way through a rule.
struct Asking {
    const std::vector<SectionView>& sections;
    std::size_t& at;
    SectionViewBox& box;
};

/// Calls the rule with one section after the other until it returns something other than false or nil, which is left on
/// top. Stack: the rule, the section, its fields, the Asking; then the names of the fields it reads. It is Lua's:
/// nothing here may have a destructor.
int ask_each(lua_State* L) {
    const Asking& a = *static_cast<const Asking*>(lua_touserdata(L, 4));
    luaL_checkstack(L, field_count + 4, nullptr);
    for (int names = 0; a.at < a.sections.size(); ++a.at) {
        const SectionView& section = a.sections[a.at];
        a.box.now = &section;
        for (int i = 0; i < int(a.box.read.size()); ++i) {
            if (i == names) ::lua_pushstring(L, section_field_names[int(a.box.read[i])].c_str()), ++names;
            lua_pushvalue(L, 5 + i);
            push_field(L, section, a.box.read[i]);
            lua_rawset(L, 3);
        }
        lua_pushvalue(L, 1), lua_pushvalue(L, 2);
        lua_call(L, 1, 1);
        if (lua_toboolean(L, -1)) return 1;
        lua_pop(L, 1);
    }
    return 0;
}

/// Takes all values out of a table, without asking for memory.
void empty(lua_State* L, const LuaValue& table) {
    table.push(L);
    lua_pushnil(L);
    while (lua_next(L, -2)) {
        lua_pop(L, 1);
        lua_pushvalue(L, -1), lua_pushnil(L);
        lua_rawset(L, -4);
    }
    lua_pop(L, 1);
}

FractureHook read_rule(lua_State* L, int index, const std::shared_ptr<Model>& model,
                       const std::vector<std::string>& keep) {
    const LuaFunction f(L, index, *model);
    SectionViewBox* box = push_section(L, model, keep);
    const LuaValue section(L, -2, *model), fields(L, -1, *model);
    lua_pop(L, 2);
    FractureHook hook;
    hook.ask = [f, section, fields, box](const std::vector<SectionView>& sections, std::size_t& at) {
        lua_State* running = f.running();
        struct Shown {
            lua_State* L;
            const LuaValue& fields;
            SectionViewBox& box;
            const SectionView* outer = box.now;  // the rule itself may step another run that has it
            ~Shown() { empty(L, fields), box.now = outer; }
        } shown{running, fields, *box};
        Asking asking{sections, at, *box};
        lua_pushcfunction(running, ask_each);
        f.push(running), section.push(running), fields.push(running);
        lua_pushlightuserdata(running, &asking);
        call_hook(running, f, 4, 1);
        const std::string wrong = lua_isnil(running, -1) || lua_isboolean(running, -1) ? "" : show(running, -1);
        lua_pop(running, 1);
        if (!wrong.empty())
            throw HookError(f.place() + ": model:fracture: the rule returned " + wrong +
                            "; it must return true where the section breaks, false or nil where it holds");
    };
    return hook;
}

std::vector<std::string> read_keep(Options& o) {
    std::vector<std::string> keep;
    lua_State* L = o.L();
    const int type = o.push_field("keep");
    if (type != LUA_TNIL && type != LUA_TTABLE)
        o.complain("keep", show(L, -1), "must be a list of names, such as { 'damage' }");
    const lua_Integer n = type == LUA_TTABLE ? list_length(L, -1, "model:fracture: field 'keep'") : 0;
    for (lua_Integer i = 1; i <= n; ++i) {
        lua_rawgeti(L, -1, i);
        const std::string name = lua_type(L, -1) == LUA_TSTRING ? lua_tostring(L, -1) : "";
        if (name.empty())
            o.complain("keep", show(L, -1) + " as item " + std::to_string(i),
                       "must be a list of names, such as { 'damage' }");
        if (name == "group" ||
            std::find(section_field_names.begin(), section_field_names.end(), name) != section_field_names.end())
            o.complain("keep", "'" + name + "'", "is a field that every section has; choose another name");
        if (std::find(keep.begin(), keep.end(), name) != keep.end())
            o.complain("keep", "'" + name + "' twice", "give each name once");
        keep.push_back(name);
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
    return keep;
}

/// How the limits are compared with an element: options that mean nothing where no limit is given.
void read_comparison(Options& o, FractureRule& rule) {
    rule.tension_only = o.flag("tension_only", false);
    rule.plastic_only = o.flag("plastic_only", false);
    rule.strain_measure = o.word("strain_measure", {"element", "section"}, "element") == "section"
                              ? FractureRule::StrainMeasure::section
                              : FractureRule::StrainMeasure::element;
    for (const char* field : {"strain_measure", "plastic_only"})
        if (rule.none() && o.has(field))
            o.complain(field, "given",
                       "belongs to limits; give hinge_rotation_x, hinge_rotation_y, elongation, curvature_x, "
                       "curvature_y, axial_strain or shear_strain");
}

}  // namespace

int fracture_rule(lua_State* L) {
    auto& m = self<ModelBox>(L, "model:fracture").value;
    FractureRule rule;
    rule.asked_at = where(L);
    if (lua_isfunction(L, 2)) {
        rule.hook = read_rule(L, 2, m, {});
    } else {
        if (!lua_istable(L, 2))
            throw InputError("model:fracture: takes a table of limits or a function, got " + show(L, 2));
        Options o(L, 2, "model:fracture");
        o.expect({"hinge_rotation_x", "hinge_rotation_y", "elongation", "curvature_x", "curvature_y", "axial_strain",
                  "shear_strain", "tension_only", "strain_measure", "plastic_only", "rule", "where", "keep", "group"});
        const auto take = [&](const char* field, const char* unit, double& limit) {
            if (const auto v = o.maybe_number(field, unit, Range::positive)) limit = *v;
        };
        take("curvature_x", "1/m", rule.curvature_x);
        take("curvature_y", "1/m", rule.curvature_y);
        take("axial_strain", "", rule.axial_strain);
        take("shear_strain", "", rule.shear_strain);
        take("hinge_rotation_x", "rad", rule.hinge_rotation_x);
        take("hinge_rotation_y", "rad", rule.hinge_rotation_y);
        take("elongation", "m", rule.elongation);
        read_comparison(o, rule);
        rule.keep = read_keep(o);
        const int type = o.push_field("rule");
        if (type == LUA_TFUNCTION) rule.hook = read_rule(L, -1, m, rule.keep);
        else if (type != LUA_TNIL)
            o.complain("rule", show(L, -1), "must be a function of a section that returns true where it breaks");
        lua_pop(L, 1);
        const std::string where = o.word("where", {"plastic", "yielded", "all"}, "plastic");
        rule.where = where == "all"       ? FractureRule::Where::all
                     : where == "yielded" ? FractureRule::Where::yielded
                                          : FractureRule::Where::plastic;
        for (const char* field : {"where", "keep"})
            if (!rule.hook && o.has(field))
                o.complain(field, "given", "belongs to a rule of the script; give rule = a function");
        if (o.push_field("group") != LUA_TNIL) rule.group = group_argument(L, -1, "model:fracture: field 'group'", *m);
        lua_pop(L, 1);
        if (!rule.hook && rule.none())
            throw InputError(
                "model:fracture: no limit is given; give hinge_rotation_x, hinge_rotation_y (rad), elongation (m), "
                "curvature_x, curvature_y (1/m), axial_strain, shear_strain, or a function");
    }
    add_fracture(*m, std::move(rule));
    m->ask(fracture_effect, where(L));
    return 0;
}

}  // namespace hinge::script
