// model:member, model:line and model:defaults: how a script adds members.
#include "script/bind/bind_members.h"

#include <algorithm>

#include "section/section_outline.h"
#include "script/bind/bind_joints.h"
#include "script/bind/material_laws.h"
#include "record/told_warnings.h"
#include "script/bind/model_methods.h"
#include "script/bind/value_box.h"
#include "script/lua/context.h"

namespace hinge::script {

Elements read_elements(Options& o, const char* field, Formulation formulation, Elements fallback) {
    const int type = o.push_field(field);
    const std::string word = type == LUA_TSTRING ? lua_tostring(o.L(), -1) : "";
    lua_pop(o.L(), 1);
    if (type == LUA_TNIL) return fallback;
    if (type != LUA_TSTRING) return {o.integer(field, 1, fallback.number), false};
    if (word != "auto")
        o.complain(field, "'" + word + "'",
                   "must be a whole number, 1 or above, or 'auto'" + did_you_mean(word, {"auto"}));
    if (formulation != Formulation::asi_gauss)
        o.complain(field, "'auto'",
                   "goes by the errors of formulation 'asi-gauss'; the others take a number, for their elements are "
                   "not exact without compression either");
    return {2, true};
}

void note_line(lua_State* L, Model& m, const char* kind, int index) {
    if (context(L)->mode.checking) m.ask(std::string(kind) + " " + std::to_string(index + 1), where(L));
}

namespace {

const std::vector<std::string> fields_of_members = {"section", "material", "up",   "group",   "elements", "backbone",
                                                    "law",     "carries",  "ends", "release", "offset"};

void read_groups(Options& o, Model& m, std::vector<int>& groups, std::vector<std::string>& named) {
    lua_State* L = o.L();
    const int type = o.push_field("group");
    const auto take = [&](int index) {
        if (find<GroupBox>(L, index))
            return groups.push_back(group_argument(L, index, o.function() + ": field 'group'", m));
        if (lua_type(L, index) != LUA_TSTRING || lua_rawlen(L, index) == 0)
            o.complain("group", show(L, index), "must be a name, or a table of names");
        named.push_back(lua_tostring(L, index));
    };
    if (type == LUA_TTABLE)
        for (lua_Integer i = 1, n = list_length(L, -1, o.function() + ": field 'group'"); i <= n; ++i) {
            lua_rawgeti(L, -1, i);
            take(-1);
            lua_pop(L, 1);
        }
    else if (type != LUA_TNIL) take(-1);
    lua_pop(L, 1);
}

/// Section and material of a member, and what follows its hinges: a backbone, or a law of the script.
void read_section(Options& o, const std::shared_ptr<ScriptModel>& m, MemberData& data) {
    lua_State* L = o.L();
    o.push_field("section");
    if (auto* s = find<SectionBox>(L, -1)) data.section = s->value;
    else
        o.complain("section", lua_isnil(L, -1) ? "missing" : show(L, -1),
                   "give hinge.section.named 'HEB 300' or the like, or one made by hinge.section.box{}, h{}, pipe{}, "
                   "solid{} or general{}");
    o.push_field("material");
    if (auto* s = find<MaterialBox>(L, -1)) data.material = s->value;
    else
        o.complain(
            "material", lua_isnil(L, -1) ? "missing" : show(L, -1),
            "give hinge.material.steel 'S355' or the like, or one made by hinge.material{ E =, density =, ... }");
    if (o.push_field("backbone") != LUA_TNIL) {
        const auto* backbone = find<BackboneBox>(L, -1);
        if (!backbone)
            o.complain("backbone", show(L, -1),
                       "give one made by hinge.backbone{ ... }; a function is given as law = function(flow, history)");
        if (m->options().formulation == Formulation::conventional)
            o.complain("backbone", "given",
                       "needs hinges at the ends of elements: hinge.model{ formulation = 'asi-gauss' } or 'asi'");
        const auto& outline = data.section->outline;
        if (!std::isfinite(data.material->yield_stress) && !(outline && outline->concrete()))
            o.complain("backbone", "given", "needs a material with yield_stress (Pa), or a section of concrete");
        data.backbone = backbone->value;
    }
    lua_pop(L, 3);
    data.law = read_own_law(o, m);
    if (data.law && !std::isfinite(data.material->yield_stress) &&
        !(data.section->outline && data.section->outline->concrete()))
        o.complain("law", "given", "needs a material with yield_stress (Pa), or a section of concrete");
}

/// A member as the script gives it. Nothing of it is in the model yet: its groups may be new ones.
struct GivenMember {
    MemberData data;
    std::vector<std::string> named;  ///< groups that are given by their names
    std::array<std::optional<JointProperties>, 2> joints;
    std::array<std::optional<Vec3>, 2> offsets;
};

/// The groups that it joins, each once.
void read_own_groups(Options& o, Model& m, GivenMember& given) {
    read_groups(o, m, given.data.groups, given.named);
    std::vector<std::string> all = given.named;
    for (const int g : given.data.groups) all.push_back(m.groups()[g]);
    std::sort(all.begin(), all.end());
    if (const auto twice = std::adjacent_find(all.begin(), all.end()); twice != all.end())
        o.complain("group", "'" + *twice + "' twice", "give each group once");
}

GivenMember read_member(Options& o, const std::shared_ptr<ScriptModel>& m, int a, int b) {
    GivenMember given;
    MemberData& data = given.data;
    data.node[0] = a, data.node[1] = b;
    read_section(o, m, data);
    given.offsets = read_offsets(o);
    const Vec3 none = Vec3::Zero(), chord = m->nodes()[b].position + given.offsets[1].value_or(none) -
                                            m->nodes()[a].position - given.offsets[0].value_or(none);
    // without `up`: the section's y axis is as near to space z as it can be; for an upright member, to space x
    data.up = o.triple("up", "").value_or(chord.head<2>().norm() > 1e-3 * chord.norm() ? Vec3(0, 0, 1) : Vec3(1, 0, 0));
    const Elements elements = read_elements(o, "elements", m->options().formulation,
                                            {m->options().elements_per_member, m->options().automatic_elements});
    data.elements = elements.number;
    if (elements.automatic) data.elements_by = ElementsBy::undecided;
    const std::string carries = o.word("carries", {"both", "tension", "compression"}, "both");
    for (const Carries c : {Carries::tension, Carries::compression})
        if (carries == carries_word(c)) data.carries = c;
    given.joints = read_joints(o);
    for (int end : {0, 1}) data.joints |= std::uint8_t(given.joints[end] || given.offsets[end] ? 1 << end : 0);
    const bool moved = data.is_moved = given.offsets[0] || given.offsets[1];
    if (moved && !(chord.norm() > 1e-9 * std::max(1.0, m->nodes()[b].position.cwiseAbs().maxCoeff())))
        o.complain("offset", "given", "brings both ends of the member to one place");
    if (moved && !(data.up.cross(chord).norm() > 1e-6 * data.up.norm() * chord.norm()))
        o.complain("up", "{" + show(data.up.x()) + ", " + show(data.up.y()) + ", " + show(data.up.z()) + "}",
                   "parallel to the line between the member's ends, which 'offset' moves; it must point across");
    read_own_groups(o, *m, given);
    try {
        m->check_member(data);
        MemberData in_groups = data;
        for (const std::string& name : given.named) in_groups.groups.push_back(m->find_group(name));
        m->refuse_velocities(in_groups);
    } catch (const InputError& e) { throw InputError(o.function() + ": " + e.what()); }
    return given;
}

/// Adds it to the model, and leaves its handle on the stack.
void add(lua_State* L, const std::shared_ptr<ScriptModel>& m, GivenMember given) {
    const bool yields = m->options().plasticity && std::isfinite(given.data.material->yield_stress);
    std::vector<int> groups = given.data.groups;
    const int index = m->add_member(std::move(given.data));
    note_line(L, *m, "member", index);
    if (yields && !m->asked("plasticity")) m->ask("plasticity", where(L));
    declare_joints(L, *m, index, given.joints);
    declare_offsets(L, *m, index, given.offsets);
    tell_members(*context(L), m->members().size());
    if (!given.named.empty()) {
        for (const std::string& name : given.named) groups.push_back(m->group(name));
        m->set_member_groups(index, groups);
    }
    join_loads(*m, index);
    m->join_velocities(index);
    push_handle<MemberBox>(L, m, index);
}

// ---- defaults -------------------------------------------------------------------------------------------------------

/// The name of the first group in the field on top of the stack, which may be a list; "" where there is none.
std::string first_group(lua_State* L, const Model& m) {
    const int top = lua_gettop(L);
    if (lua_istable(L, -1)) lua_rawgeti(L, -1, 1);
    std::string name;
    if (const auto* box = find<GroupBox>(L, -1)) name = m.groups()[box->index];
    else if (lua_type(L, -1) == LUA_TSTRING) name = lua_tostring(L, -1);
    lua_settop(L, top);
    return name;
}

/// Takes from the defaults of a group what the options on top of the stack leave out. A joint and a release of an end
/// stand for each other.
void take_defaults(lua_State* L, const Model& m, const std::string& group) {
    const int options = lua_gettop(L);
    const auto has = [&](const char* field) {
        const bool there = lua_getfield(L, options, field) != LUA_TNIL;
        lua_pop(L, 1);
        return there;
    };
    const bool joined = has("ends") || has("release");
    push_registry(L, m);
    if (lua_getfield(L, -1, "defaults") == LUA_TTABLE && lua_getfield(L, -1, group.c_str()) == LUA_TTABLE)
        for (const std::string& field : fields_of_members) {
            const bool of_ends = field == "ends" || field == "release";
            if (has(field.c_str()) || (of_ends && joined)) continue;
            lua_getfield(L, -1, field.c_str());
            lua_setfield(L, options, field.c_str());
        }
    lua_settop(L, options);
}

/// Options of the call with the model's defaults of their group, and then those of all members, in the place of the
/// given ones at index 2.
void complete(lua_State* L, const Model& m) {
    push_registry(L, m);
    const bool any = lua_getfield(L, -1, "defaults") == LUA_TTABLE;
    lua_pop(L, 2);
    if (!any) return;
    lua_newtable(L);
    for (lua_pushnil(L); lua_next(L, 2);) {
        lua_pushvalue(L, -2);
        lua_insert(L, -2);
        lua_settable(L, -4);
    }
    lua_getfield(L, -1, "group");
    const std::string group = first_group(L, m);
    lua_pop(L, 1);
    if (!group.empty()) take_defaults(L, m, group);
    take_defaults(L, m, "");
    lua_replace(L, 2);
}

int node_of(Options& o, const ScriptModel* m, int item) {
    o.push_item(item);
    const int node = node_argument(o.L(), -1, o.function() + ": node [" + std::to_string(item) + "]", m).index;
    lua_pop(o.L(), 1);
    return node;
}

}  // namespace

int add_member(lua_State* L) {
    auto& m = self<ModelBox>(L, "model:member").value;
    Options(L, 2, "model:member").expect(fields_of_members, 2);
    complete(L, *m);
    Options o(L, 2, "model:member");
    o.expect(fields_of_members, 2);
    const int a = node_of(o, m.get(), 1), b = node_of(o, m.get(), 2);
    add(L, m, read_member(o, m, a, b));
    return 1;
}

int add_line(lua_State* L) {
    auto& m = self<ModelBox>(L, "model:line").value;
    Options given(L, 2, "model:line");
    const int nodes = int(lua_rawlen(L, 2));
    given.expect(fields_of_members, nodes);
    if (nodes < 2)
        throw InputError("model:line: " + std::to_string(nodes) + (nodes == 1 ? " node is" : " nodes are") +
                         " given; it needs two or more");
    complete(L, *m);
    Options o(L, 2, "model:line");
    o.expect(fields_of_members, nodes);
    std::vector<GivenMember> list;
    for (int i = 1; i < nodes; ++i) {
        const int a = node_of(o, m.get(), i), b = node_of(o, m.get(), i + 1);
        list.push_back(read_member(o, m, a, b));
    }
    lua_createtable(L, nodes - 1, 0);
    for (std::size_t i = 0; i < list.size(); ++i) {
        add(L, m, std::move(list[i]));
        lua_rawseti(L, -2, lua_Integer(i) + 1);
    }
    return 1;
}

int set_defaults(lua_State* L) {
    auto& m = self<ModelBox>(L, "model:defaults").value;
    Options o(L, 2, "model:defaults");
    o.expect(fields_of_members);
    if (o.has("ends") && o.has("release"))
        o.complain("release", "given beside 'ends'", "write the release into the joints");
    lua_getfield(L, 2, "group");
    const std::string group = first_group(L, *m);
    if (group.empty() && !lua_isnil(L, -1)) o.complain("group", show(L, -1), "must be a name, or a table of names");
    push_registry(L, *m);
    if (lua_getfield(L, -1, "defaults") != LUA_TTABLE) {
        lua_pop(L, 1);
        lua_newtable(L);
        lua_pushvalue(L, -1);
        lua_setfield(L, -3, "defaults");
    }
    lua_newtable(L);
    for (const std::string& field : fields_of_members) {
        lua_getfield(L, 2, field.c_str());
        lua_setfield(L, -2, field.c_str());
    }
    lua_setfield(L, -2, group.c_str());
    return 0;
}

}  // namespace hinge::script
