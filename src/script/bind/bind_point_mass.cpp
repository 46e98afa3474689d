// model:mass: point masses on nodes.
#include "effects/point_mass.h"

#include "script/bind/model_methods.h"

namespace hinge::script {

int add_mass(lua_State* L) {
    auto& m = self<ModelBox>(L, "model:mass").value;
    Options o(L, 2, "model:mass");
    if (o.has("member") || o.has("group")) return add_mass_on_member(L);
    o.expect({"node", "mass", "inertia", "offset", "member", "group", "per_length", "from", "to"});
    for (const char* field : {"per_length", "from", "to"})
        if (o.has(field)) o.complain(field, "given without 'member' or 'group'", "it is for a mass along a member");
    PointMass mass;
    o.push_field("node");
    mass.node = node_argument(L, -1, "model:mass: field 'node'", m.get()).index;
    mass.mass = o.number("mass", "kg", Range::positive);
    const int type = o.push_field("inertia");
    if (type == LUA_TTABLE) {
        mass.inertia = *o.triple("inertia", "kg m^2");
        for (int c = 0; c < 3; ++c)
            if (mass.inertia[c] < 0)
                throw InputError(std::string("model:mass: field 'inertia': component ") + "xyz"[c] + " is " +
                                 show(mass.inertia[c]) + " kg m^2; must be 0 kg m^2 or above");
    } else if (type == LUA_TNUMBER || type == LUA_TNIL) {
        mass.inertia.setConstant(o.number("inertia", "kg m^2", Range::not_negative, 0));
    } else {
        o.complain("inertia", show(L, -1), "must be a number or {Jx, Jy, Jz} in kg m^2");
    }
    lua_pop(L, 2);
    mass.offset = o.triple("offset", "m").value_or(Vec3::Zero());
    m->declare(point_mass_effect, mass);
    if (!m->asked(point_mass_effect)) m->ask(point_mass_effect, where(L));
    return 0;
}

}  // namespace hinge::script
