// model:rigid_link and model:diaphragm: nodes that move as one rigid body, in space or in a plane.
#include <algorithm>

#include "effects/diaphragm.h"
#include "effects/rigid_link.h"
#include "script/bind/model_methods.h"

namespace hinge::script {
namespace {

std::string name_of_node(int node) { return "node " + std::to_string(node + 1); }

/// The nodes that follow another one, and those that others follow, as declared so far.
struct Joined {
    struct Pair {
        int first, follower;
        bool by_link;
    };
    std::vector<Pair> pairs;
    explicit Joined(const Model& m) {
        for (const RigidLink& link : m.declared<RigidLink>(rigid_link_effect))
            pairs.push_back({link.from, link.to, true});
        for (const Diaphragm& d : m.declared<Diaphragm>(diaphragm_effect))
            for (std::size_t i = 1; i < d.nodes.size(); ++i) pairs.push_back({d.nodes[0], d.nodes[i], false});
    }
    static std::string call(bool by_link) { return by_link ? "a rigid link" : "a diaphragm"; }

    /// `first`: others follow it, by a link or by a diaphragm. Several links may begin at one node.
    void refuse_first(const std::string& what, int first, bool by_link) const {
        for (const Pair& p : pairs) {
            if (p.follower == first)
                throw InputError(what + ": " + name_of_node(first) + " follows " + name_of_node(p.first) + " by " +
                                 call(p.by_link) + " already, so that no node can follow it; let both follow " +
                                 name_of_node(p.first));
            if (p.first == first && !(by_link && p.by_link))
                throw InputError(what + ": " + name_of_node(first) + " is the first node of " + call(p.by_link) +
                                 " already; a node leads rigid links, or one diaphragm");
        }
    }
    void refuse_follower(const std::string& what, int first, int follower) const {
        if (first == follower)
            throw InputError(what + ": both nodes are " + name_of_node(first) + "; it joins two nodes");
        for (const Pair& p : pairs) {
            if (p.follower == follower)
                throw InputError(what + ": " + name_of_node(follower) + " follows " + name_of_node(p.first) + " by " +
                                 call(p.by_link) + " already; a node follows one other node");
            if (p.first == follower)
                throw InputError(what + ": " + name_of_node(p.follower) + " follows " + name_of_node(follower) +
                                 " by " + call(p.by_link) +
                                 " already, so that it cannot follow another node; begin at " + name_of_node(follower));
        }
    }
};

int node_field(Options& o, const char* call, const char* field, const Model* model) {
    lua_State* L = o.L();
    o.push_field(field);
    const int node = node_argument(L, -1, std::string(call) + ": field '" + field + "'", model).index;
    lua_pop(L, 1);
    return node;
}

}  // namespace

/// model:rigid_link { from = node, to = node, dofs = "all" | "xyz" }
int add_rigid_link(lua_State* L) {
    constexpr const char* call = "model:rigid_link";
    auto& m = self<ModelBox>(L, call).value;
    Options o(L, 2, call);
    o.expect({"from", "to", "dofs"});
    RigidLink link;
    link.from = node_field(o, call, "from", m.get());
    link.to = node_field(o, call, "to", m.get());
    link.tied = o.word("dofs", {"all", "xyz"}, "all") == "all" ? 63 : 7;
    const Joined joined(*m);
    joined.refuse_follower(call, link.from, link.to);
    joined.refuse_first(call, link.from, true);
    m->declare(rigid_link_effect, link);
    m->ask(rigid_link_effect, where(L));
    return 0;
}

/// model:diaphragm { nodes = { ... }, normal = "x" | "y" | "z", master = node }
int add_diaphragm(lua_State* L) {
    constexpr const char* call = "model:diaphragm";
    auto& m = self<ModelBox>(L, call).value;
    Options o(L, 2, call);
    o.expect({"nodes", "normal", "master"});
    Diaphragm d;
    d.normal = o.word("normal", {"x", "y", "z"}, "z")[0] - 'x';
    if (o.push_field("nodes") != LUA_TTABLE) o.complain("nodes", show(L, -1), "must be a list of at least two nodes");
    std::string what = call;  // in parts: gcc 12 takes the sum for an overflow
    what += ": field 'nodes'";
    for (lua_Integer i = 1, n = list_length(L, lua_gettop(L), what); i <= n; ++i) {
        lua_rawgeti(L, -1, i);
        const int node = node_argument(L, -1, what + ", item " + std::to_string(i), m.get()).index;
        if (std::find(d.nodes.begin(), d.nodes.end(), node) != d.nodes.end())
            throw InputError(what + ": " + name_of_node(node) + " is listed twice");
        d.nodes.push_back(node);
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
    if (o.has("master")) {
        const int master = node_field(o, call, "master", m.get());
        const auto at = std::find(d.nodes.begin(), d.nodes.end(), master);
        if (at == d.nodes.end()) o.complain("master", name_of_node(master), "must be one of 'nodes'");
        std::rotate(d.nodes.begin(), at, at + 1);
    }
    if (d.nodes.size() < 2)
        o.complain("nodes", "a list of " + std::to_string(d.nodes.size()), "must have two at least");
    const Joined joined(*m);
    joined.refuse_first(call, d.nodes[0], false);
    for (std::size_t i = 1; i < d.nodes.size(); ++i) joined.refuse_follower(call, d.nodes[0], d.nodes[i]);
    m->declare(diaphragm_effect, std::move(d));
    m->ask(diaphragm_effect, where(L));
    return 0;
}

}  // namespace hinge::script
