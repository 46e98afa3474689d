// hinge.joint, the fields `ends` and `release` of model:member, member:joint, and model:joint.
#include "script/bind/bind_joints.h"
#include "model/member_ends.h"

#include <cmath>

#include "core/text.h"
#include "script/bind/model_methods.h"
#include "script/bind/modules.h"
#include "script/bind/run_box.h"

namespace hinge::script {
namespace {

constexpr const char* axis_fields[] = {"Mx", "My", "Mz"};
constexpr const char* end_fields[] = {"a", "b"};

struct JointBox {
    static constexpr const char* lua_name = "hinge.joint";
    std::shared_ptr<const JointProperties> value;
};

struct NodeJointBox {
    static constexpr const char* lua_name = "hinge.node_joint";
    std::shared_ptr<ScriptModel> model;
    int index;  ///< among all joints of the model
};

/// Field `points`: rotation (rad) and moment (N m) of a curve from { 0, 0 } on.
std::vector<std::pair<double, double>> read_curve(Options& o) {
    lua_State* L = o.L();
    std::vector<std::pair<double, double>> curve;
    const std::string what = o.function() + ": field 'points'";
    double slope = std::numeric_limits<double>::infinity();
    for (lua_Integer i = 1, n = list_length(L, -1, what); i <= n; ++i) {
        double pair[2] = {std::nan(""), std::nan("")};
        lua_rawgeti(L, -1, i);
        for (int c = 0; lua_istable(L, -1) && c < 2; ++c) {
            lua_rawgeti(L, -1, c + 1);
            if (lua_type(L, -1) == LUA_TNUMBER) pair[c] = lua_tonumber(L, -1);
            lua_pop(L, 1);
        }
        lua_pop(L, 1);
        const auto refuse = [&](const std::string& need) {
            throw InputError(what + "[" + std::to_string(i) + "]: " + need);
        };
        if (!std::isfinite(pair[0]) || !std::isfinite(pair[1])) refuse("must be { rotation (rad), moment (N m) }");
        const auto last = curve.empty() ? std::pair(0.0, 0.0) : curve.back();
        if (!(pair[0] > last.first))
            refuse("the rotation is " + show(pair[0]) + " rad; it must be more than that before, " + show(last.first) +
                   " rad (the curve begins at { 0, 0 } by itself)");
        const double next = (pair[1] - last.second) / (pair[0] - last.first);
        if (!(next >= 0 && (next > 0 || !curve.empty()) && next <= slope * (1 + 1e-9)))
            refuse("the moment rises by " + show(next) +
                   " N m/rad from the point before; a joint's curve rises, and each part is less steep than the one "
                   "before (a joint that loses its strength breaks: 'capacity')");
        slope = next;
        curve.push_back({pair[0], pair[1]});
    }
    if (curve.empty()) o.complain("points", "empty", "give at least one point { rotation (rad), moment (N m) }");
    return curve;
}

JointAxis read_axis(Options& o, const char* field) {
    lua_State* L = o.L();
    JointAxis axis;
    const int type = o.push_field(field);
    const std::string word = type == LUA_TSTRING ? lua_tostring(L, -1) : "";
    if (word == "free") axis.stiffness = 0;
    else if (type == LUA_TTABLE) {
        Options of(L, lua_gettop(L), o.function() + ": field '" + field + "'");
        of.expect({"stiffness", "strength", "points", "capacity"});
        if (of.push_field("points") != LUA_TNIL) {
            axis.curve = read_curve(of);
            axis.stiffness = axis.curve[0].second / axis.curve[0].first;
            for (const char* other : {"stiffness", "strength"})
                if (of.has(other)) of.complain(other, "given beside points", "give the one or the other");
        }
        lua_pop(L, 1);
        if (axis.curve.empty()) {
            axis.stiffness = of.number("stiffness", "N m/rad", Range::positive);
            if (const auto strength = of.maybe_number("strength", "N m", Range::positive))
                axis.curve = {{*strength / axis.stiffness, *strength}};
        }
        axis.capacity = of.number("capacity", "rad", Range::positive, JointAxis::infinite);
    } else if (type != LUA_TNIL && word != "rigid") {
        o.complain(field, show(L, -1),
                   "must be 'free', 'rigid' (the default), or { stiffness = N m/rad, strength = N m } or "
                   "{ points = { { rad, N m }, ... } }, with the rotation 'capacity' (rad) at which it breaks");
    }
    lua_pop(L, 1);
    return axis;
}

int define_joint(lua_State* L) {
    Options o(L, 1, "hinge.joint");
    o.expect({"Mx", "My", "Mz", "tension", "shear", "interaction"});
    JointProperties is;
    bool rigid = true;
    for (int k = 0; k < 3; ++k) {
        is.axis[k] = read_axis(o, axis_fields[k]);
        rigid = rigid && !std::isfinite(is.axis[k].stiffness);
    }
    is.tension = o.number("tension", "N", Range::positive, JointAxis::infinite);
    is.shear = o.number("shear", "N", Range::positive, JointAxis::infinite);
    if (rigid && !is.can_break())
        throw InputError(
            "hinge.joint: it is rigid and never breaks, like a member's end without a joint; give 'Mx', 'My' or 'Mz' "
            "(such as Mx = 'free'), 'tension' or 'shear' (N)");
    is.tension_weakens = o.word("interaction", {"none", "linear"}, "none") == "linear";
    if (is.tension_weakens && !std::isfinite(is.tension))
        o.complain("interaction", "'linear'", "needs 'tension', N: the force that leaves no moment");
    if (is.tension_weakens && is.axis[0].curve.empty() && is.axis[1].curve.empty())
        o.complain("interaction", "'linear'", "needs a strength of 'Mx' or 'My', from which tension takes");
    push<JointBox>(L, std::make_shared<const JointProperties>(is));
    return 1;
}

std::string axis_text(const JointAxis& axis) {
    if (axis.is_free()) return "free";
    if (!std::isfinite(axis.stiffness)) return "rigid";
    std::string text = show(axis.stiffness) + " N m/rad";
    if (!axis.curve.empty()) text += " up to " + show(axis.curve.back().second) + " N m";
    return text;
}
int joint_text(lua_State* L) {
    const JointProperties& is = *self<JointBox>(L, "tostring").value;
    std::string text = "joint:";
    for (int k = 0; k < 3; ++k) text += std::string(k ? ", " : " ") + axis_fields[k] + " " + axis_text(is.axis[k]);
    lua_pushstring(L, (text + (is.can_break() ? "; it can break" : "")).c_str());
    return 1;
}
int joint_fields(lua_State* L) {
    const std::string key = key_argument(L);
    self<JointBox>(L, "joint." + key);
    refuse_field(L, "joint", key);
}

/// The end's field of `field`, on the stack: { a = , b = }.
template <class F>
void each_end(Options& o, const char* field, const std::string& holds, F read) {
    lua_State* L = o.L();
    const int type = o.push_field(field);
    if (type == LUA_TTABLE) {
        Options of(L, lua_gettop(L), o.function() + ": field '" + field + "'");
        of.expect({"a", "b"});
        for (int end : {0, 1}) {
            if (of.push_field(end_fields[end]) != LUA_TNIL) read(end, of);
            lua_pop(L, 1);
        }
    } else if (type != LUA_TNIL) {
        o.complain(field, show(L, -1), "must be { a = " + holds + ", b = " + holds + " }, or one of the two");
    }
    lua_pop(L, 1);
}

JointProperties read_release(Options& o, int end) {
    lua_State* L = o.L();
    JointProperties is;
    const auto release = [&](int index) {
        const std::string word = lua_type(L, index) == LUA_TSTRING ? lua_tostring(L, index) : "";
        for (int k = 0; k < 3; ++k)
            if (word == axis_fields[k]) return void(is.axis[k].stiffness = 0);
        o.complain(end_fields[end], show(L, index),
                   "must be 'Mx', 'My' or 'Mz' (moments about the axes of the section; Mz is torsion), or a list of "
                   "them");
    };
    if (!lua_istable(L, -1)) return release(-1), is;
    const lua_Integer n = list_length(L, -1, o.function());
    for (lua_Integer i = 1; i <= n; ++i) {
        lua_rawgeti(L, -1, i);
        release(-1);
        lua_pop(L, 1);
    }
    if (n == 0) o.complain(end_fields[end], "empty", "must be 'Mx', 'My' or 'Mz', or a list of them");
    return is;
}

}  // namespace

std::array<std::optional<JointProperties>, 2> read_joints(Options& o) {
    std::array<std::optional<JointProperties>, 2> joints;
    each_end(o, "ends", "joint", [&](int end, Options& of) {
        const auto* box = find<JointBox>(of.L(), -1);
        if (!box) of.complain(end_fields[end], show(of.L(), -1), "must be a joint made by hinge.joint{ ... }");
        joints[end] = *box->value;
    });
    each_end(o, "release", "{ 'Mx', 'My' }", [&](int end, Options& of) {
        if (joints[end])
            of.complain(end_fields[end], "given beside a joint in 'ends'", "write the release into the joint");
        joints[end] = read_release(of, end);
    });
    if (joints[0] && joints[1] && joints[0]->axis[2].is_free() && joints[1]->axis[2].is_free())
        throw InputError(o.function() +
                         ": torsion (Mz) is free at both ends, so that nothing keeps the member from turning about "
                         "its own axis; leave it rigid at one of them");
    return joints;
}

void declare_joints(lua_State* L, Model& m, int member, const std::array<std::optional<JointProperties>, 2>& joints) {
    for (int end : {0, 1}) {
        if (!joints[end]) continue;
        m.declare(joints_effect, Joint{member, end, *joints[end]});
        m.ask(joints_effect, where(L));
    }
}

std::array<std::optional<Vec3>, 2> read_offsets(Options& o) {
    std::array<std::optional<Vec3>, 2> offsets;
    each_end(o, "offset", "{x, y, z}", [&](int end, Options& of) {
        const Vec3 by =
            read_triple(of.L(), lua_gettop(of.L()), of.function() + ": field '" + end_fields[end] + "'", "m");
        if (!by.isZero(0)) offsets[end] = by;
    });
    return offsets;
}

void declare_offsets(lua_State* L, Model& m, int member, const std::array<std::optional<Vec3>, 2>& offsets) {
    for (int end : {0, 1}) {
        if (!offsets[end]) continue;
        m.declare(member_offsets, MemberOffset{member, end, *offsets[end]});
        m.ask(joints_effect, where(L));
    }
}

void push_offsets_of(lua_State* L, const Model& m, int member) {
    lua_pushnil(L);
    for (int end : {0, 1}) {
        const Vec3 by = offset_of(m, member, end);
        if (by.isZero(0)) continue;
        if (lua_isnil(L, -1)) lua_pop(L, 1), lua_createtable(L, 0, 2);
        lua_createtable(L, 3, 0);
        for (int c = 0; c < 3; ++c) lua_pushnumber(L, by[c]), lua_rawseti(L, -2, c + 1);
        lua_setfield(L, -2, end_fields[end]);
    }
}

void push_joints_of(lua_State* L, const Model& m, int member) {
    lua_pushnil(L);
    for (const Joint& j : m.declared<Joint>(joints_effect)) {
        if (j.member != member) continue;
        if (lua_isnil(L, -1)) lua_pop(L, 1), lua_createtable(L, 0, 2);
        push<JointBox>(L, std::make_shared<const JointProperties>(j.is));
        lua_setfield(L, -2, end_fields[j.end]);
    }
}

namespace {

void push_joint_now(lua_State* L, const JointState& j, bool of_member) {
    const auto number = [L](const char* name, double x) { lua_pushnumber(L, x), lua_setfield(L, -2, name); };
    lua_createtable(L, 0, 9);
    for (int k = 0; k < 3; ++k) {
        number(axis_fields[k], j.broken ? 0 : j.moment[k]);
        number(std::array{"rotation_x", "rotation_y", "rotation_z"}[std::size_t(k)], j.rotation[k]);
    }
    if (of_member) {
        number("tension", j.broken ? 0 : j.tension);
        number("shear", j.broken ? 0 : j.shear);
    }
    if (j.broken) number("broken", j.broken_at);
    else lua_pushboolean(L, 0), lua_setfield(L, -2, "broken");
}

}  // namespace

void push_joint(lua_State* L, const Run& run, int member, int end) {
    const auto& declared = run.structure().model().declared<Joint>(joints_effect);
    const auto* all = run.state().data.find<JointStates>(joints_effect);
    for (std::size_t i = 0; all && i < declared.size(); ++i)
        if (declared[i].member == member && declared[i].end == end) return push_joint_now(L, all->list[i], true);
    lua_pushnil(L);
}

// ---- joints between nodes -------------------------------------------------------------------------------------------

namespace {

std::string name_of(const NodeJointBox& box) {
    const Joint& j = box.model->declared<Joint>(joints_effect)[box.index];
    return "the joint between nodes " + std::to_string(j.from + 1) + " and " + std::to_string(j.to + 1);
}

int state_of_node_joint(lua_State* L) {
    const auto& box = self<NodeJointBox>(L, "node_joint:state");
    const auto record = run_to_read(L, "node_joint:state", *box.model);
    const auto* all = record->run->state().data.find<JointStates>(joints_effect);
    if (!all || box.index >= int(all->list.size()))
        throw InputError("node_joint:state: the run made at " + record->asked_at + " does without " + name_of(box) +
                         ": it was made before the joint was declared");
    push_joint_now(L, all->list[box.index], false);
    return 1;
}
int fields_of_node_joint(lua_State* L) {
    if (push_method(L)) return 1;
    const std::string key = key_argument(L);
    self<NodeJointBox>(L, "node_joint." + key);
    refuse_field(L, "node_joint", key);
}
int text_of_node_joint(lua_State* L) {
    const auto& box = self_or_gone<NodeJointBox>(L, "tostring");
    lua_pushstring(L, (name_of(box) + gone(box)).c_str());
    return 1;
}

/// A node stays at one other node, and no further one at it.
void refuse_chain(const Model& m, int from, int to) {
    const auto name = [](int node) { return "node " + std::to_string(node + 1); };
    for (const Joint& j : m.declared<Joint>(joints_effect)) {
        if (!j.is_between_nodes()) continue;
        const std::string there = "model:joint: a joint joins " + name(j.to) + " to " + name(j.from) + " already";
        if (j.to == to) throw InputError(there + "; a node is joined to one other node");
        if (j.to == from) throw InputError(there + "; join " + name(to) + " to " + name(j.from) + " as well");
        if (j.from == to) throw InputError(there + "; join " + name(j.to) + " to " + name(from) + " as well");
    }
}

}  // namespace

int add_joint(lua_State* L) {
    auto& m = self<ModelBox>(L, "model:joint").value;
    Options o(L, 2, "model:joint");
    o.expect({"joint", "axes"}, 2);
    Joint j{-1, 0, {}};
    int* nodes[2] = {&j.from, &j.to};
    for (int i : {0, 1}) {
        o.push_item(i + 1);
        *nodes[i] = node_argument(L, -1, "model:joint: node " + std::to_string(i + 1), m.get()).index;
        lua_pop(L, 1);
    }
    if (j.from == j.to)
        throw InputError("model:joint: both nodes are node " + std::to_string(j.to + 1) + "; it joins two nodes");
    const Vec3 apart = m->nodes()[j.to].position - m->nodes()[j.from].position;
    if (!(apart.norm() <= 1e-9 * (1 + m->nodes()[j.to].position.norm())))
        throw InputError("model:joint: the nodes are " + show(apart.norm()) +
                         " m apart; a joint has no length: declare both at one place, or join them by model:rigid_link "
                         "or model:connector");
    refuse_chain(*m, j.from, j.to);
    o.push_field("joint");
    const auto* box = find<JointBox>(L, -1);
    if (!box) o.complain("joint", show(L, -1), "must be a joint made by hinge.joint{ ... }");
    j.is = *box->value;
    lua_pop(L, 1);
    if (std::isfinite(j.is.tension) || std::isfinite(j.is.shear))
        o.complain("joint", "one with 'tension' or 'shear'",
                   "of a joint between nodes only moments count: give it rotations at which it breaks, 'capacity'");
    j.axes = o.axes("axes");
    m->declare(joints_effect, j);
    m->ask(joints_effect, where(L));
    const bool there = luaL_getmetatable(L, NodeJointBox::lua_name) != LUA_TNIL;
    lua_pop(L, 1);
    if (!there) {
        static const luaL_Reg methods[] = {{"state", guarded<takes<"node_joint:state", 2, state_of_node_joint>>},
                                           {nullptr, nullptr}};
        make_metatable(L, NodeJointBox::lua_name, methods, guarded<fields_of_node_joint>, collect<NodeJointBox>,
                       guarded<text_of_node_joint>, nullptr);
    }
    push<NodeJointBox>(L, m, int(m->declared<Joint>(joints_effect).size()) - 1);
    hold_registry(L, *m);
    return 1;
}

void open_joints(lua_State* L, int module) {
    static const luaL_Reg none[] = {{nullptr, nullptr}};
    make_metatable(L, JointBox::lua_name, none, guarded<joint_fields>, collect<JointBox>, guarded<joint_text>, nullptr);
    lua_pushcfunction(L, (guarded<takes<"hinge.joint", 1, define_joint>>));
    lua_setfield(L, module, "joint");
}

}  // namespace hinge::script
