// model:settle: displacements of supports in statics.
#include "effects/settlement.h"
#include "script/bind/model_methods.h"

namespace hinge::script {

/// model:settle { node = node or list, x, y, z = m, rx, ry, rz = rad }
int settle_supports(lua_State* L) {
    constexpr const char* call = "model:settle";
    auto& m = self<ModelBox>(L, call).value;
    Options o(L, 2, call);
    constexpr const char* components[] = {"x", "y", "z", "rx", "ry", "rz"};
    o.expect({"node", "x", "y", "z", "rx", "ry", "rz"});
    std::vector<int> nodes;
    if (o.push_field("node") == LUA_TTABLE)
        for (lua_Integer i = 1, n = list_length(L, -1, "model:settle: field 'node'"); i <= n; ++i) {
            lua_rawgeti(L, -1, i);
            nodes.push_back(
                node_argument(L, -1, "model:settle: field 'node', item " + std::to_string(i), m.get()).index);
            lua_pop(L, 1);
        }
    else nodes.push_back(node_argument(L, -1, "model:settle: field 'node'", m.get()).index);
    lua_pop(L, 1);
    if (nodes.empty()) o.complain("node", "an empty list", "must be a node, or a list of them");
    std::optional<double> by[6];
    bool any = false;
    for (int c = 0; c < 6; ++c)
        any |= (by[c] = o.maybe_number(components[c], c < 3 ? "m" : "rad", Range::any)).has_value();
    if (!any)
        throw InputError(
            "model:settle: none of 'x', 'y', 'z' (m), 'rx', 'ry', 'rz' (rad) is given; give the displacement of the "
            "support at load factor 1");
    for (const int n : nodes)
        for (const Settlement& other : m->declared<Settlement>(settlement_effect))
            if (other.node == n && by[other.component])
                throw InputError("model:settle: node " + std::to_string(n + 1) + " has a displacement '" +
                                 components[other.component] + "' already");
    for (const int n : nodes)
        for (int c = 0; c < 6; ++c)
            if (by[c]) add_settlement(*m, {n, c, *by[c]});
    m->ask(settlement_effect, where(L));
    return 0;
}

}  // namespace hinge::script
