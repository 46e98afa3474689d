// hinge.model, and how a script adds nodes, supports, members, loads and velocities to it.
#include <algorithm>

#include "section/section_outline.h"
#include "effects/gravity.h"
#include "script/bind/bind_members.h"
#include "script/bind/model_methods.h"
#include "script/bind/modules.h"

namespace hinge::script {

namespace {

std::uint8_t parse_degrees_of_freedom(const std::string& what, const std::string& text) {
    if (text == "all") return 63;
    std::uint8_t mask = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        const int shift = c == 'r' ? 3 : 0;
        if (c == ' ' || c == ',') continue;
        if ((c == 'r' || c == 'u') && i + 1 < text.size()) ++i;
        const char axis = text[i];
        if (axis < 'x' || axis > 'z')
            throw InputError(
                what + " is '" + text +
                "'; give \"all\", or letters of \"xyz\" for displacements and \"rx\", \"ry\", \"rz\" for rotations");
        const std::uint8_t bit = std::uint8_t(1 << (shift + axis - 'x'));
        if (mask & bit)
            throw InputError(what + " is '" + text + "': '" + (shift ? "r" : "") + axis +
                             "' is there twice; rotations are \"rx\", \"ry\" and \"rz\"");
        mask |= bit;
    }
    if (!mask) throw InputError(what + " is empty; give \"all\", \"xyz\" or the like");
    return mask;
}

int model(lua_State* L) {
    Options o(L, 1, "hinge.model", true);
    ModelOptions m;
    const std::string formulation = o.word("formulation", {"conventional", "asi", "asi-gauss"}, "asi-gauss");
    m.formulation = formulation == "conventional" ? Formulation::conventional
                    : formulation == "asi"        ? Formulation::asi
                                                  : Formulation::asi_gauss;
    m.displacement =
        o.word("displacement", {"small", "large"}, "large") == "small" ? Displacement::small : Displacement::large;
    m.shift = o.word("shift", {"plastic", "elastic_and_plastic"}, "plastic") == "plastic" ? Shift::plastic
                                                                                          : Shift::elastic_and_plastic;
    m.mass = o.word("mass", {"linear", "cubic"}, "linear") == "cubic" ? MassShape::cubic : MassShape::linear;
    if (m.mass == MassShape::cubic && m.formulation != Formulation::asi_gauss)
        o.complain("mass", "'cubic'",
                   "belongs to formulation 'asi-gauss', whose pairs of elements have the stiffness of a cubic; '" +
                       formulation + "' takes 'linear'");
    const bool bends =
        m.formulation == Formulation::asi_gauss && m.displacement == Displacement::large && m.shift == Shift::plastic;
    m.p_delta =
        o.word("p_delta", {"chord", "member"}, bends ? "member" : "chord") == "member" ? PDelta::member : PDelta::chord;
    if (m.p_delta == PDelta::member && !bends)
        o.complain(
            "p_delta", "'member'",
            "needs formulation 'asi-gauss', displacement 'large' and shift 'plastic'; without them it is 'chord'");
    m.weight = o.word("weight", {"members", "nodes"}, "members") == "nodes" ? Weight::nodes : Weight::members;
    if (m.shift == Shift::elastic_and_plastic && m.formulation == Formulation::conventional)
        o.complain("shift", "'elastic_and_plastic'",
                   "has no meaning with formulation 'conventional', whose points stay in the middle; leave it out");
    m.plasticity = o.flag("plasticity", true);
    m.interaction = interaction_of(o.word("interaction", {"paper", "exact", "exact with shear"}, "exact"));
    const Elements elements = read_elements(o, "elements_per_member", m.formulation, {2, false});
    m.elements_per_member = elements.number, m.automatic_elements = elements.automatic;
    m.elements_accuracy = o.number("elements_accuracy", "", Range::positive, m.elements_accuracy);
    if (m.elements_accuracy >= 1)
        o.complain("elements_accuracy", show(m.elements_accuracy),
                   "must be below 1: the error that elements = 'auto' may leave, such as 0.01");
    if (m.formulation == Formulation::asi_gauss && m.elements_per_member % 2)
        o.complain("elements_per_member", std::to_string(m.elements_per_member),
                   "formulation 'asi-gauss' places its points in pairs of elements and needs an even number (2, 4, "
                   "...); 'asi' and 'conventional' take any");
    o.finish();
    auto model = std::make_shared<ScriptModel>(m);
    model->ask("model", where(L));
    push<ModelBox>(L, model);
    hold_registry(L, *model);
    return 1;
}

int add_node(lua_State* L) {
    auto& m = self<ModelBox>(L, "model:node").value;
    const int index = m->add_node(read_triple(L, 2, "model:node: position", "m"));
    note_line(L, *m, "node", index);
    push_handle<NodeBox>(L, m, index);
    return 1;
}

int fix(lua_State* L) {
    auto& m = self<ModelBox>(L, "model:fix").value;
    if (lua_type(L, 3) != LUA_TSTRING && !lua_isnoneornil(L, 3))
        throw InputError("model:fix: what to fix is " + show(L, 3) + "; give a string such as \"all\" or \"xyz\"");
    const std::uint8_t mask =
        parse_degrees_of_freedom("model:fix: what to fix", lua_isnoneornil(L, 3) ? "all" : lua_tostring(L, 3));
    if (lua_istable(L, 2)) {
        std::vector<int> nodes;
        for (lua_Integer i = 1, n = list_length(L, 2, "model:fix: the list of nodes"); i <= n; ++i) {
            lua_rawgeti(L, 2, i);
            nodes.push_back(node_argument(L, -1, "model:fix: item " + std::to_string(i), m.get()).index);
            lua_pop(L, 1);
        }
        if (nodes.empty()) throw InputError("model:fix: the list of nodes is empty; give a node, or a list of them");
        for (int n : nodes) m->fix(n, mask), note_line(L, *m, "support", n);
    } else {
        const int node = node_argument(L, 2, "model:fix: node", m.get()).index;
        m->fix(node, mask);
        note_line(L, *m, "support", node);
    }
    return 0;
}

std::string show_target(lua_State* L) {
    if (auto* n = find<NodeBox>(L, 2)) return name_of(*n);
    if (auto* m = find<MemberBox>(L, 2)) return name_of(*m);
    if (auto* g = find<GroupBox>(L, 2)) return name_of(*g);
    return "group " + show(L, 2);
}

int velocity(lua_State* L) {
    auto& m = self<ModelBox>(L, "model:velocity").value;
    std::vector<int> nodes;
    int group = -1;
    if (find<NodeBox>(L, 2)) {
        nodes = {node_argument(L, 2, "model:velocity: target", m.get()).index};
    } else if (find<MemberBox>(L, 2)) {
        const MemberData& member = m->members()[member_argument(L, 2, "model:velocity: target", m.get()).index];
        nodes = {member.node[0], member.node[1]};
    } else if (find<GroupBox>(L, 2) || lua_type(L, 2) == LUA_TSTRING) {
        group = group_argument(L, 2, "model:velocity: target", *m);
        nodes = m->nodes_of_group(group);
    } else {
        throw InputError("model:velocity: target is " + show(L, 2) +
                         "; must be a node, a member, a group or the name of one");
    }
    const Vec3 v = read_triple(L, 3, "model:velocity: velocity", "m/s");
    const Vec3 w =
        lua_isnoneornil(L, 4) ? Vec3(Vec3::Zero()) : read_triple(L, 4, "model:velocity: angular velocity", "rad/s");
    Vec6 given;
    given << v, w;
    std::uint8_t fixed = 63;  // at all of them
    for (int n : nodes) fixed &= m->nodes()[n].fixed;
    bool moves = given.isZero(0) || (nodes.size() > 1 && !w.isZero(0));
    for (int c = 0; c < 6; ++c) moves = moves || (given[c] != 0 && !(fixed >> c & 1));
    if (!moves)
        throw InputError(
            "model:velocity: target is " + show_target(L) +
            ", which supports hold in all directions of this velocity; a node that does not move has none");
    m->set_velocities({std::move(nodes), v, w, group, where(L)});
    return 0;
}

int group(lua_State* L) {
    auto& m = self<ModelBox>(L, "model:group").value;
    push_group(L, m, group_argument(L, 2, "model:group: name", *m));
    return 1;
}

int counts(lua_State* L) {
    auto& m = self<ModelBox>(L, "model:counts").value;
    const Structure structure(m);
    lua_createtable(L, 0, 4);
    const auto set = [&](const char* name, lua_Integer v) { lua_pushinteger(L, v), lua_setfield(L, -2, name); };
    set("members", lua_Integer(m->members().size()));
    set("elements", lua_Integer(structure.elements().size()));
    set("nodes", lua_Integer(structure.position().size()));
    set("free_dofs", structure.free_dofs());
    return 1;
}

}  // namespace

int set_gravity(lua_State* L) {
    auto& m = self<ModelBox>(L, "model:gravity").value;
    const Vec3 g = read_triple(L, 2, "model:gravity: acceleration", "m/s^2");
    const int load_case = lua_isnoneornil(L, 3) ? -1 : case_argument(L, 3, "model:gravity: case", *m);
    const auto belongs = [&](int i) { return i < 0 ? std::string("no load case") : "case '" + m->cases()[i] + "'"; };
    if (m->gravity_case && *m->gravity_case != load_case)
        throw InputError("model:gravity: gravity belongs to " + belongs(*m->gravity_case) + " already, not to " +
                         belongs(load_case) + "; a model has one gravity, so give what acts beside it as loads");
    hinge::set_gravity(*m, g, load_case);
    m->gravity_case = load_case;
    m->ask(gravity_effect, where(L));
    return 0;
}

void open_model(lua_State* L, int module) {
    static const luaL_Reg methods[] = {{"node", guarded<declares<"model:node", 2, add_node>>},
                                       {"fix", guarded<declares<"model:fix", 3, fix>>},
                                       {"gravity", guarded<declares<"model:gravity", 3, set_gravity>>},
                                       {"velocity", guarded<declares<"model:velocity", 4, velocity>>},
                                       {"group", guarded<takes<"model:group", 2, group>>},
                                       {"counts", guarded<takes<"model:counts", 1, counts>>},
// NOLINTBEGIN(bugprone-macro-parentheses): names, not expressions
#define HINGE_MODEL_METHOD(name, function) {#name, guarded<declares<"model:" #name, 2, function>>},
#define HINGE_MODEL_RUN(name, function) {#name, guarded<takes<"model:" #name, 2, function>>},
#include "script/bind/model_methods.inc"
#undef HINGE_MODEL_METHOD
#undef HINGE_MODEL_RUN
                                       // NOLINTEND(bugprone-macro-parentheses)
                                       {nullptr, nullptr}};
    add_methods(L, ModelBox::lua_name, methods);
    lua_pushcfunction(L, (guarded<takes<"hinge.model", 1, model>>));
    lua_setfield(L, module, "model");
}

}  // namespace hinge::script
