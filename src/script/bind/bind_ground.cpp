// model:ground: rigid half spaces that members fall on.
#include "effects/ground.h"

#include "script/bind/model_methods.h"

namespace hinge::script {

int declare_ground(lua_State* L) {
    auto& m = self<ModelBox>(L, "model:ground").value;
    Options o(L, 2, "model:ground", true);
    o.expect({"point", "normal", "friction", "stiffness", "restitution", "layer_stiffness", "layer_damping", "group"});
    GroundPlane plane;
    plane.point = o.triple("point", "m").value_or(plane.point);
    if (const auto normal = o.triple("normal", "")) {
        const double largest = normal->cwiseAbs().maxCoeff();
        if (largest == 0)
            o.complain("normal", "{0, 0, 0}", "must have a length: it points out of the ground, such as {0, 0, 1}");
        plane.normal = (*normal / largest).normalized();
    }
    plane.friction = o.number("friction", "", Range::not_negative, plane.friction);
    plane.stiffness = o.number("stiffness", "N/m", Range::positive, plane.stiffness);
    plane.restitution = o.maybe_number("restitution", "", Range::not_negative);
    if (plane.restitution && *plane.restitution > 1)
        o.complain("restitution", show(*plane.restitution),
                   "must be between 0 and 1: the part of the normal velocity that a point comes back with");
    plane.layer_stiffness = o.number("layer_stiffness", "N/m^3", Range::positive, plane.layer_stiffness);
    plane.layer_damping = o.number("layer_damping", "N s/m^3", Range::not_negative, plane.layer_damping);
    for (const char* field : {"layer_stiffness", "layer_damping"})
        if (!plane.is_layer() && o.has(field))
            o.complain(field, "given", "belongs to a layer; 'stiffness' and 'restitution' ask for points on springs");
    if (o.push_field("group") != LUA_TNIL) plane.group = group_argument(L, -1, "model:ground: field 'group'", *m);
    lua_pop(L, 1);
    for (const GroundPlane& p : m->declared<GroundPlane>(ground_effect))
        if (p.normal == plane.normal && p.point == plane.point && p.group == plane.group)
            throw InputError(
                "model:ground: this plane is declared already, for the same members; a second one would "
                "press on them once more");
    m->declare(ground_effect, plane);
    m->ask("rigid ground", where(L));
    return 0;
}

}  // namespace hinge::script
