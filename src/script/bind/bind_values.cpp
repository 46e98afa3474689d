// hinge.material and hinge.section.general: the material and section of members.
#include <cmath>

#include "section/material_law.h"
#include "section/plastic_shape.h"
#include "script/bind/material_laws.h"
#include "script/bind/section_outline.h"
#include "script/bind/section_shapes.h"
#include "script/bind/modules.h"
#include "script/bind/value_box.h"
#include "script/lua/options.h"

namespace hinge::script {
namespace {

int material(lua_State* L) {
    Options o(L, 1, "hinge.material");
    Material m;
    m.E = o.number("E", "Pa", Range::positive);
    const auto nu = o.maybe_number("nu", "", Range::any);
    if (nu && !(*nu > -1 && *nu <= 0.5))
        o.complain("nu", show(*nu), "Poisson's ratio must be above -1 and at most 0.5");
    const auto G = o.maybe_number("G", "Pa", Range::positive);
    if (nu && G) o.complain("G", show(*G) + " Pa", "is given beside nu, from which it follows; give one of the two");
    m.G = G ? *G : m.E / (2 * (1 + nu.value_or(0.3)));
    m.density = o.number("density", "kg/m^3", Range::not_negative, 0);
    if (const auto y = o.maybe_number("yield_stress", "Pa", Range::positive)) m.yield_stress = *y;
    m.laws = read_material_laws(o, m);
    o.finish();
    m.asked_at = where(L);
    push<MaterialBox>(L, std::make_shared<const Material>(m));
    return 1;
}

int material_with(lua_State* L) {
    Material m = *self<MaterialBox>(L, "material:with").value;
    Options o(L, 2, "material:with");
    o.expect({"density"});
    m.density = o.number("density", "kg/m^3", Range::not_negative);
    o.finish();
    m.asked_at = where(L);
    push<MaterialBox>(L, std::make_shared<const Material>(m));
    return 1;
}

int material_fields(lua_State* L) {
    if (push_method(L)) return 1;
    const Material& m = *self<MaterialBox>(L, "material").value;
    const std::string key = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : "";
    if (key == "E") lua_pushnumber(L, m.E);
    else if (key == "G") lua_pushnumber(L, m.G);
    else if (key == "density") lua_pushnumber(L, m.density);
    else if (key == "yield_stress") lua_pushnumber(L, m.yield_stress);
    else if (key == "laws") {
        std::string text;
        for (const auto& law : m.laws) text += (text.empty() ? "" : ", ") + law->words();
        lua_pushlstring(L, text.data(), text.size());
    } else
        throw InputError("material has no field '" + key + "'" +
                         did_you_mean(key, {"E", "G", "density", "yield_stress", "laws", "with"}));
    return 1;
}

int material_text(lua_State* L) {
    const Material& m = *self<MaterialBox>(L, "tostring").value;
    lua_pushfstring(L, "material: E %f Pa, G %f Pa, density %f kg/m^3, yield stress %s Pa", m.E, m.G, m.density,
                    show(m.yield_stress).c_str());
    return 1;
}

/// hinge.section.concrete makes its section here, and its errors about bars are found here.
const char* maker_of(lua_State* L) {
    if (!lua_istable(L, 1)) return "hinge.section.general";
    lua_getfield(L, 1, "kind");
    const bool concrete = lua_type(L, -1) == LUA_TSTRING && std::string(lua_tostring(L, -1)) == "concrete";
    lua_pop(L, 1);
    return concrete ? "hinge.section.concrete" : "hinge.section.general";
}

/// Rectangles { x0, x1, y0, y1 } of the walls along x and along y, m.
void read_walls(Options& o, Section& s) {
    lua_State* L = o.L();
    if (o.push_field("shear_walls") != LUA_TNIL) {
        Options inner(L, -1, o.function() + ", shear_walls");
        for (const int axis : {0, 1}) {
            const char* name = axis == 0 ? "x" : "y";
            if (inner.push_field(name) != LUA_TNIL) {
                const std::string what = inner.function() + ": field '" + name + "'";
                for (lua_Integer i = 1, n = list_length(L, -1, what); i <= n; ++i) {
                    const std::vector<double> at = numbers_in(L, i, 4);
                    const double x0 = at[0], x1 = at[1], y0 = at[2], y1 = at[3];
                    if (!(x0 < x1 && y0 < y1))
                        throw InputError(what + "[" + std::to_string(i) +
                                         "] must be { x0, x1, y0, y1 }, m, of a rectangle within the outline");
                    s.walls[axis].push_back({x0, x1, y0, y1});
                }
            }
            lua_pop(L, 1);
        }
        inner.finish();
    }
    lua_pop(L, 1);
}

int section(lua_State* L) {
    Options o(L, 1, maker_of(L));
    o.expect({"area",    "Ix",    "Iy",          "J",       "shear_area_x", "shear_area_y", "mass_Ix",
              "mass_Iy", "N0",    "Mx0",         "My0",     "Mz0",          "plastic",      "size",
              "kind",    "shape", "shear_walls", "outline", "interaction",  "reinforcement"});
    Section s;
    s.area = o.number("area", "m^2", Range::positive);
    s.Ix = o.number("Ix", "m^4", Range::positive);
    s.Iy = o.number("Iy", "m^4", Range::positive);
    s.J = o.number("J", "m^4", Range::positive);
    s.shear_area_x = o.number("shear_area_x", "m^2", Range::positive, s.area * 5 / 6);
    s.shear_area_y = o.number("shear_area_y", "m^2", Range::positive, s.area * 5 / 6);
    s.mass_Ix = o.number("mass_Ix", "m^4", Range::positive, 0);
    s.mass_Iy = o.number("mass_Iy", "m^4", Range::positive, 0);
    s.given.N0 = o.maybe_number("N0", "N", Range::positive);
    s.given.Mx0 = o.maybe_number("Mx0", "N m", Range::positive);
    s.given.My0 = o.maybe_number("My0", "N m", Range::positive);
    s.given.Mz0 = o.maybe_number("Mz0", "N m", Range::positive);
    if (o.push_field("plastic") != LUA_TNIL) {
        Options p(L, -1, "hinge.section.general, plastic");
        s.plastic_area = p.number("A", "m^2", Range::positive, 0);
        s.Zx = p.number("Zx", "m^3", Range::positive, 0);
        s.Zy = p.number("Zy", "m^3", Range::positive, 0);
        s.Zz = p.number("Zz", "m^3", Range::positive, 0);
        p.finish();
    }
    lua_pop(L, 1);
    if (o.push_field("size") != LUA_TNIL) {
        Options p(L, -1, "hinge.section.general, size");
        s.width = p.number("width", "m", Range::positive);
        s.depth = p.number("depth", "m", Range::positive);
        s.web = p.number("web", "m", Range::positive, 0);
        s.flange = p.number("flange", "m", Range::positive, 0);
        p.finish();
    }
    lua_pop(L, 1);
    if (const auto kind = o.text("kind")) s.kind = s.shape = *kind;
    if (const auto shape = o.text("shape")) s.shape = *shape;
    read_walls(o, s);
    s.outline = read_outline(o);
    if (!s.outline && o.has("reinforcement"))
        o.complain("reinforcement", "given", "needs the section's shape: give 'outline' as well");
    for (const char* field : {"N0", "Mx0", "My0", "plastic", "interaction"})
        if (s.outline && s.outline->concrete() && o.has(field))
            o.complain(field, "given beside reinforcement", "from which it follows; give one of the two");
    if (const std::string asked = o.word("interaction", {"", "paper", "exact", "exact with shear"}, ""); !asked.empty())
        s.interaction = interaction_of(asked);
    complete_section(s, o.function());
    o.finish();
    s.asked_at = where(L);
    push<SectionBox>(L, std::make_shared<const Section>(s));
    return 1;
}

/// section:reduced_moments(n)
int reduced_moments(lua_State* L) {
    const Section& s = *self<SectionBox>(L, "section:reduced_moments").value;
    const double n = lua_type(L, 2) == LUA_TNUMBER ? lua_tonumber(L, 2) : std::nan("");
    if (!(std::abs(n) <= 1))
        throw InputError("section:reduced_moments: N / N0 is " + show(L, 2) + "; must be a number from -1 to 1");
    const auto shape = PlasticShape::of(s);
    if (!shape) return lua_pushnil(L), 1;
    for (int axis : {0, 1}) lua_pushnumber(L, shape->moment(axis, n));
    return 2;
}

/// section:plastic_moments(N, angle)
int plastic_moments(lua_State* L) {
    const Section& s = *self<SectionBox>(L, "section:plastic_moments").value;
    const auto number = [L](int i) { return lua_type(L, i) == LUA_TNUMBER ? lua_tonumber(L, i) : std::nan(""); };
    if (!s.outline || !s.outline->concrete()) return lua_pushnil(L), 1;
    const double N = number(2), angle = lua_isnoneornil(L, 3) ? 0 : number(3);
    const auto [least, most] = s.outline->axial_range();
    const double rounding = 1e-9 * (most - least) / 2;
    if (!(N >= least - rounding && N <= most + rounding))
        throw InputError("section:plastic_moments: N is " + show(L, 2) + "; must be a number from " + show(least) +
                         " to " + show(most) + " N, tension positive");
    if (!std::isfinite(angle))
        throw InputError("section:plastic_moments: the angle is " + show(L, 3) + "; must be a number, in rad");
    const Eigen::Vector2d m = s.outline->moments(N, angle);
    for (int axis : {0, 1}) lua_pushnumber(L, m[axis]);
    return 2;
}

int section_fields(lua_State* L) {
    if (push_method(L)) return 1;
    const Section& s = *self<SectionBox>(L, "section").value;
    const std::string key = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : "";
    const std::pair<const char*, double> numbers[] = {{"area", s.area},
                                                      {"Ix", s.Ix},
                                                      {"Iy", s.Iy},
                                                      {"J", s.J},
                                                      {"shear_area_x", s.shear_area_x},
                                                      {"shear_area_y", s.shear_area_y},
                                                      {"plastic_area", s.plastic_area},
                                                      {"Zx", s.Zx},
                                                      {"Zy", s.Zy},
                                                      {"Zz", s.Zz},
                                                      {"width", s.width},
                                                      {"depth", s.depth},
                                                      {"web", s.web},
                                                      {"flange", s.flange}};
    for (const auto& [name, value] : numbers)
        if (key == name) return lua_pushnumber(L, value), 1;
    if (key == "interaction") {
        if (s.interaction == Interaction::by_model) return lua_pushnil(L), 1;
        return lua_pushstring(L, word_of(s.interaction)), 1;
    }
    const std::pair<const char*, std::optional<double>> given[] = {
        {"N0", s.given.N0}, {"Mx0", s.given.Mx0}, {"My0", s.given.My0}, {"Mz0", s.given.Mz0}};
    for (const auto& [name, value] : given)
        if (key == name) return value ? lua_pushnumber(L, *value) : lua_pushnil(L), 1;
    if (key == "kind") return lua_pushstring(L, s.kind.c_str()), 1;
    std::vector<std::string> names = {"kind", "N0", "Mx0", "My0", "Mz0", "interaction"};
    for (const auto& n : numbers) names.push_back(n.first);
    throw InputError("section has no field '" + key + "'" + did_you_mean(key, names));
}

int section_text(lua_State* L) {
    const Section& s = *self<SectionBox>(L, "tostring").value;
    char text[200];
    std::snprintf(text, sizeof text, "section (%s): area %.4g m^2, Ix %.4g, Iy %.4g, J %.4g m^4", s.kind.c_str(),
                  s.area, s.Ix, s.Iy, s.J);
    lua_pushstring(L, text);
    return 1;
}

template <class T>
int same(lua_State* L) {
    const T *a = find<T>(L, 1), *b = find<T>(L, 2);
    lua_pushboolean(L, a && b && a->value == b->value);
    return 1;
}

}  // namespace

void open_values(lua_State* L, int module) {
    static const luaL_Reg of_material[] = {{"with", guarded<takes<"material:with", 2, material_with>>},
                                           {nullptr, nullptr}};
    make_metatable(L, MaterialBox::lua_name, of_material, guarded<material_fields>, collect<MaterialBox>,
                   guarded<material_text>, same<MaterialBox>);
    static const luaL_Reg of_section[] = {
        {"reduced_moments", guarded<takes<"section:reduced_moments", 2, reduced_moments>>},
        {"plastic_moments", guarded<takes<"section:plastic_moments", 3, plastic_moments>>},
        {nullptr, nullptr}};
    make_metatable(L, SectionBox::lua_name, of_section, guarded<section_fields>, collect<SectionBox>,
                   guarded<section_text>, same<SectionBox>);
    name_fields(L, MaterialBox::lua_name, {"E", "G", "density", "yield_stress", "laws"});
    name_fields(
        L, SectionBox::lua_name,
        {"kind", "area", "Ix",  "Iy",  "J",   "shear_area_x", "shear_area_y", "plastic_area", "Zx",     "Zy",
         "Zz",   "N0",   "Mx0", "My0", "Mz0", "width",        "depth",        "web",          "flange", "interaction"});
    lua_pushcfunction(L, (guarded<takes<"hinge.material", 1, material>>));
    lua_setfield(L, module, "material");
    lua_pushcfunction(L, (guarded<takes<"hinge.section.general", 1, section>>));
    lua_setfield(L, module, "section");
    lua_pushcfunction(L, (guarded<takes<"core.shape", 3, push_shape>>));
    lua_setfield(L, module, "shape");
}

}  // namespace hinge::script
