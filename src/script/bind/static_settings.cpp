#include "script/bind/static_settings.h"

#include <algorithm>
#include <cmath>

#include "script/bind/mode_box.h"

namespace hinge::script {
namespace {

/// What leads the way of a static run; `goes_on`: from another run.
void read_control(lua_State* L, Options& o, const std::shared_ptr<ScriptModel>& m, bool goes_on, StaticSettings& s) {
    const char* allowed = "must be 'load', 'arc', { 'arc', to = } or { node =, \"ux\", to = }";
    const int type = o.push_field("control");
    if (type == LUA_TSTRING) {
        const std::string word = lua_tostring(L, -1);
        if (word == "arc") s.control = Control::arc;
        else if (word != "load") o.complain("control", "'" + word + "'", allowed + did_you_mean(word, {"load", "arc"}));
    } else if (type == LUA_TTABLE) {
        Options c(L, -1, "model:static, control");
        c.push_item(1);
        const std::string component = lua_type(L, -1) == LUA_TSTRING ? lua_tostring(L, -1) : "";
        if (component == "arc") {
            s.control = Control::arc;
            s.target = c.number("to", "", Range::any);
            if (s.target == 0) c.complain("to", "0", "must differ from 0, the load factor where the run begins");
            c.finish(1);
            return lua_pop(L, 2);
        }
        s.control = Control::displacement;
        c.push_field("node");
        s.node = node_argument(L, -1, "model:static, control: field 'node'", m.get()).index;
        static const std::vector<std::string> names = {"ux", "uy", "uz", "rx", "ry", "rz"};
        const auto at = std::find(names.begin(), names.end(), component);
        if (at == names.end())
            throw InputError("model:static, control: component is " + show(L, -2) +
                             "; must be one of 'ux', 'uy', 'uz', 'rx', 'ry', 'rz'" + did_you_mean(component, names));
        lua_pop(L, 2);
        s.component = int(at - names.begin());
        s.target = c.number("to", s.component < 3 ? "m" : "rad", Range::any);
        if (s.target == 0 && !goes_on) c.complain("to", "0", "must differ from 0");
        c.finish(1);
        if (m->nodes()[s.node].fixed >> s.component & 1)
            throw InputError("model:static, control: '" + component + "' of node " + std::to_string(s.node + 1) +
                             " is fixed by a support and cannot be driven");
    } else if (type != LUA_TNIL) {
        o.complain("control", show(L, -1), allowed);
    }
    lua_pop(L, 1);
}

/// The shape along which the run sets off; `nodes`: of the structure.
void read_branch(lua_State* L, Options& o, std::size_t nodes, StaticSettings& s) {
    if (o.push_field("branch") != LUA_TNIL) {
        const auto* mode = find<ModeBox>(L, -1);
        if (!mode) o.complain("branch", show(L, -1), "must be a shape of run:buckling or run:modes");
        if (s.control != Control::displacement)
            o.complain("branch", "given", "goes with control = { node =, \"ux\", to = }, which holds the branch");
        if (mode->shape.size() != nodes)
            o.complain("branch", "a shape of " + std::to_string(mode->shape.size()) + " nodes",
                       "must be of this structure, which has " + std::to_string(nodes));
        double largest = 0;
        for (const Vec6& v : mode->shape)
            largest = std::max(largest, (s.component < 3 ? v.head<3>() : v.tail<3>()).cwiseAbs().maxCoeff());
        if (!(std::abs(mode->shape[s.node][s.component]) > 1e-3 * largest))
            o.complain("branch", "a shape that does not move what 'control' drives",
                       "drive a displacement that is large in the shape");
        s.branch = mode->shape;
    }
    lua_pop(L, 1);
}

/// The nodes of the elements of a group that the run holds.
void read_held(lua_State* L, Options& o, const Model& m, const Structure& structure, StaticSettings& s) {
    if (o.push_field("fixed_group") != LUA_TNIL) {
        s.held.assign(structure.position().size(), 0);
        const int g = group_argument(L, -1, "model:static: field 'fixed_group'", m);
        for (std::size_t e = 0; e < structure.elements().size(); ++e)
            if (structure.in_group(int(e), g))
                for (int n : structure.elements()[e].node) s.held[n] = 63;
    }
    lua_pop(L, 1);
}

}  // namespace

StaticSettings read_static_settings(Options& o, const std::shared_ptr<ScriptModel>& m, const Structure& structure,
                                    bool goes_on) {
    lua_State* L = o.L();
    StaticSettings s;
    s.steps = o.integer("steps", 1, 10);
    s.iterations = o.integer("iterations", 2, s.iterations);
    s.tolerance = o.number("tolerance", "", Range::positive, s.tolerance);
    read_control(L, o, m, goes_on, s);
    read_branch(L, o, structure.position().size(), s);
    s.past_unstable = o.word("unstable", {"fail", "continue"}, "fail") == "continue";
    s.to_limit = o.flag("to_limit", false);
    if (s.control != Control::load)
        for (const char* field : {"unstable", "to_limit"})
            if (o.has(field))
                throw InputError(std::string("model:static: field '") + field +
                                 "' has no meaning with control by displacement or arc length, which goes on past a "
                                 "limit load; leave it out");
    if (s.past_unstable && s.to_limit)
        throw InputError(
            "model:static: to_limit = true ends where the structure becomes unstable, unstable = 'continue' goes on; "
            "leave one out");
    read_held(L, o, *m, structure, s);
    return s;
}

}  // namespace hinge::script
