// model:panel: plates in their plane between nodes, and what has become of one in a run.
#include "effects/panels.h"

#include <numbers>
#include <utility>

#include "section/material_law.h"
#include "script/bind/model_methods.h"
#include "script/bind/run_box.h"
#include "script/bind/value_box.h"

namespace hinge::script {

struct PanelBox {
    static constexpr const char* lua_name = "hinge.panel";
    std::shared_ptr<ScriptModel> model;
    int index;
};
std::string name_of(const PanelBox& p) { return "panel " + std::to_string(p.index + 1); }

namespace {

using panel::Layer;
using panel::LayerKind;
using panel::Sheet;

constexpr double modulus_of_bars = 200e9, density_of_steel = 7850, density_of_concrete = 2500;  // Pa, kg/m^3

const Vec3 along_x = {1, 0, 0}, along_y = {0, 1, 0};  ///< directions of bars (panel::Layer)

/// What bars of steel have in common.
Layer read_bars(Options& o) {
    Layer bars;
    bars.kind = LayerKind::bars;
    bars.E = o.number("E", "Pa", Range::positive, modulus_of_bars);
    bars.strength = o.maybe_number("yield_stress", "Pa", Range::positive).value_or(bars.strength);
    bars.hardening = o.number("hardening", "Pa", Range::not_negative, 0);
    bars.ultimate = o.maybe_number("ultimate_strain", "", Range::positive).value_or(bars.ultimate);
    if (std::isfinite(bars.strength) && bars.ultimate < bars.strength / bars.E)
        o.complain("ultimate_strain", show(bars.ultimate),
                   "is below the strain at which they yield, " + show(bars.strength / bars.E));
    if (bars.hardening > 0 && !std::isfinite(bars.strength))
        o.complain("hardening", show(bars.hardening), "needs yield_stress (Pa)");
    return bars;
}

/// Of a layer's middle above that of the panel, m.
void read_height(Options& in, Layer& layer) { layer.levels[0].z = in.number("z", "m", Range::any, 0); }

void read_solid(Options& o, Sheet& sheet, double& mass) {
    const auto thickness = o.maybe_number("thickness", "m", Range::positive);
    lua_State* L = o.L();
    o.push_field("material");
    const auto* material = find<MaterialBox>(L, -1);
    if (!material && !lua_isnil(L, -1))
        o.complain("material", show(L, -1), "must be one made by hinge.material{ ... } or hinge.material.steel 'S355'");
    lua_pop(L, 1);
    if (!thickness != !material)
        o.complain(thickness ? "material" : "thickness", "missing",
                   thickness ? "give the plate's material beside its thickness" : "give the plate's thickness, m");
    for (const char* field : {"hardening", "ultimate_strain"})
        if (!material && o.has(field)) o.complain(field, "given without a plate", "give 'thickness' and 'material'");
    if (!material) return;
    const Material& m = *material->value;
    if (!m.laws.empty())
        o.complain("material", std::string("one with ") + m.laws[0]->name(),
                   "a plate takes E, G, density and yield_stress of it; give 'hardening' (Pa) to the panel");
    Layer plate;
    plate.thickness = *thickness, plate.E = m.E, plate.poisson = m.E / (2 * m.G) - 1;
    if (!(plate.poisson > -1 && plate.poisson < 0.5))
        o.complain("material", "one with E = " + show(m.E) + " Pa and G = " + show(m.G) + " Pa",
                   "has no Poisson's ratio between -1 and 0.5, E / (2 G) - 1, which a plate needs");
    plate.strength = m.yield_stress;
    plate.hardening = o.number("hardening", "Pa", Range::not_negative, 0);
    plate.ultimate = o.maybe_number("ultimate_strain", "", Range::positive).value_or(plate.ultimate);
    if (!std::isfinite(plate.strength) && (plate.hardening > 0 || std::isfinite(plate.ultimate)))
        o.complain(plate.hardening > 0 ? "hardening" : "ultimate_strain", "given",
                   "needs a material with yield_stress (Pa): it is a plastic strain");
    mass += plate.thickness * m.density;
    sheet.layers.push_back(plate);
}

void read_concrete(Options& o, Sheet& sheet, double& mass) {
    o.read_table("concrete", "{ thickness = 0.12, strength = 30e6, E = 33e9 }", [&](Options& in) {
        in.expect({"thickness", "strength", "E", "density", "z"});
        Layer layer;
        layer.kind = LayerKind::concrete;
        layer.thickness = in.number("thickness", "m", Range::positive);
        layer.E = in.number("E", "Pa", Range::positive);
        layer.strength = in.maybe_number("strength", "Pa", Range::positive).value_or(layer.strength);
        mass += layer.thickness * in.number("density", "kg/m^3", Range::not_negative, density_of_concrete);
        read_height(in, layer);
        sheet.layers.push_back(layer);
    });
}

void read_mesh(Options& in, Sheet& sheet) {
    in.expect({"x", "y", "z", "E", "yield_stress", "hardening", "ultimate_strain"});
    Layer bars = read_bars(in);
    const double x = in.number("x", "m^2/m", Range::not_negative, 0);
    const double y = in.number("y", "m^2/m", Range::not_negative, 0);
    if (x == 0 && y == 0) in.complain("x", "missing", "give the area of the bars per width, m^2/m, as x, y or both");
    read_height(in, bars);
    for (const auto& [area, direction] : {std::pair(x, along_x), std::pair(y, along_y)}) {
        if (area == 0) continue;
        bars.thickness = area, bars.direction = direction;
        sheet.layers.push_back(bars);
    }
}

/// Bars, then the ribs of a deck; returns whether there is a deck, whose layer is then the last one.
bool read_steel_in_it(Options& o, Sheet& sheet, double& mass) {
    constexpr const char* example = "{ x = 393e-6, y = 393e-6, yield_stress = 500e6 }";
    lua_State* L = o.L();
    const int type = o.push_field("reinforcement");
    const bool list = type == LUA_TTABLE && lua_rawlen(L, -1) > 0;
    const lua_Integer meshes = list ? list_length(L, lua_gettop(L), o.function() + ": field 'reinforcement'") : 0;
    if (meshes == 0) o.read_table("reinforcement", example, [&](Options& in) { read_mesh(in, sheet); });
    for (lua_Integer i = 1; i <= meshes; ++i) {
        const std::string which = "reinforcement[" + std::to_string(i) + "]";
        if (lua_rawgeti(L, -1, i) != LUA_TTABLE)
            o.complain(which.c_str(), show(L, -1), std::string("must be a table such as ") + example);
        Options in(L, lua_gettop(L), o.function() + ": field '" + which + "'");
        read_mesh(in, sheet);
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
    return o.read_table("deck", "{ area = 1.2e-3, yield_stress = 320e6 }", [&](Options& in) {
        in.expect({"area", "along", "z", "E", "yield_stress", "hardening", "ultimate_strain"});
        Layer ribs = read_bars(in);
        ribs.thickness = in.number("area", "m^2/m", Range::positive);
        ribs.direction = in.word("along", {"x", "y"}, "x") == "x" ? along_x : along_y;
        read_height(in, ribs);
        mass += ribs.thickness * density_of_steel;
        sheet.layers.push_back(ribs);
    });
}

/// Divides a layer into levels through its thickness, at the points of Gauss: while elastic they bend exactly as it
/// does.
void divide(Layer& layer, int count) {
    const double middle = layer.levels[0].z;
    layer.levels.clear();
    for (int i = 0; i < count; ++i) {
        double x = std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5)), slope = 0;
        for (int round = 0; round < 20; ++round) {  // a root of Legendre's polynomial
            double before = 1, now = x;
            for (int n = 2; n <= count; ++n)
                before = std::exchange(now, ((2 * n - 1) * x * now - (n - 1) * before) / n);
            slope = count * (x * now - before) / (x * x - 1);
            x -= now / slope;
        }
        layer.levels.push_back({middle + 0.5 * layer.thickness * x, 1 / ((1 - x * x) * slope * slope)});
    }
}

constexpr int levels = 6;  ///< of concrete and of plates that bend by their layers

/// The ribs of a deck may hang below the concrete; bars lie in it.
void bend_by_layers(Options& o, Sheet& sheet, bool deck) {
    bool off = false;
    sheet.bends_by_layers = true;
    double low = std::numeric_limits<double>::infinity(), high = -low;  // of concrete and plates, m
    for (Layer& l : sheet.layers) {
        if (l.kind == LayerKind::bars) {
            off |= l.levels[0].z != 0;
            continue;
        }
        low = std::min(low, l.levels[0].z - 0.5 * l.thickness),
        high = std::max(high, l.levels[0].z + 0.5 * l.thickness);
        divide(l, levels);
    }
    if (!(low < high) && !off)
        o.complain("bending", "\"layers\"", "needs a plate, concrete, or bars at heights 'z' (m) that differ from 0");
    for (std::size_t i = 0; i + deck < sheet.layers.size(); ++i)
        if (const double z = sheet.layers[i].levels[0].z;
            sheet.layers[i].kind == LayerKind::bars && low < high && (z < low || z > high))
            o.complain("z", show(z),
                       "m: bars lie outside of the concrete or plate, from " + show(low) + " to " + show(high) + " m");
}

/// Of a solid plate it follows from the plate, unless it is given or false.
void read_bending(Options& o, Sheet& sheet, bool deck) {
    lua_State* L = o.L();
    const int type = o.push_field("bending");
    const bool none = type == LUA_TBOOLEAN && !lua_toboolean(L, -1);
    const bool layers = type == LUA_TSTRING && std::string(lua_tostring(L, -1)) == "layers";
    lua_pop(L, 1);
    if (layers) return bend_by_layers(o, sheet, deck);
    if (type == LUA_TSTRING)
        o.complain("bending", "another word", "must be \"layers\", false, or a table with 'stiffness' (N m)");
    for (const Layer& l : sheet.layers)
        if (l.levels[0].z != 0)
            o.complain("bending", none ? "false" : "not \"layers\"",
                       "a layer has a height 'z', which acts where the panel bends by its layers: give bending = "
                       "\"layers\"");
    if (none) return;
    panel::BendingLaw& law = sheet.bending;
    const bool given = o.read_table("bending", "{ stiffness = 1e6, sagging = 20e3, hogging = 30e3 }", [&](Options& in) {
        in.expect({"stiffness", "poisson", "sagging", "hogging"});
        law.stiffness = in.number("stiffness", "N m", Range::positive);
        law.poisson = in.number("poisson", "", Range::not_negative, 0);
        if (!(law.poisson < 0.5)) in.complain("poisson", show(law.poisson), "must be below 0.5");
        law.sagging = in.maybe_number("sagging", "N m/m", Range::positive).value_or(law.sagging);
        law.hogging = in.maybe_number("hogging", "N m/m", Range::positive).value_or(law.hogging);
    });
    if (given) return;
    for (const Layer& plate : sheet.layers) {
        if (plate.kind != LayerKind::solid) continue;
        const double t = plate.thickness;
        law.stiffness = plate.E * t * t * t / (12 * (1 - plate.poisson * plate.poisson)), law.poisson = plate.poisson;
        law.sagging = law.hogging = plate.strength * t * t / 4;
    }
}

std::shared_ptr<const Sheet> read_sheet(Options& o) {
    auto sheet = std::make_shared<Sheet>();
    double mass = 0;
    read_solid(o, *sheet, mass);
    read_concrete(o, *sheet, mass);
    const bool deck = read_steel_in_it(o, *sheet, mass);
    if (sheet->layers.empty())
        throw InputError(o.function() +
                         ": it is made of nothing; give 'thickness' (m) and 'material', 'concrete', 'reinforcement' or "
                         "'deck'");
    if (sheet->layers.size() > panel::most_layers)
        throw InputError(o.function() + ": it is made of " + std::to_string(sheet->layers.size()) +
                         " layers; a panel has " + std::to_string(panel::most_layers) +
                         " at most, with x and y of a mesh as one each");
    read_bending(o, *sheet, deck);
    sheet->mass = o.number("mass", "kg/m^2", Range::not_negative, mass);
    return sheet;
}

constexpr double flat = 0.05;  ///< of its size, by which a corner may be off the plane

double off_plane(const Model& m, const Panel& p, const panel::Shape& shape) {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const int n : p.nodes) {
        const double at = shape.axes.col(2).dot(m.nodes()[n].position);
        least = std::min(least, at), most = std::max(most, at);
    }
    return most - least;
}

/// The panel in a run.
struct AskedPanel {
    std::shared_ptr<ScriptRun> record;
    const PanelsNow* now;
    std::size_t index;
};
AskedPanel asked(lua_State* L, const char* method) {
    const std::string function = std::string("panel:") + method;
    const auto& p = self<PanelBox>(L, function);
    AskedPanel a{run_to_read(L, function, *p.model), nullptr, std::size_t(p.index)};
    a.now = panels_now(a.record->run->state());
    if (!a.now || a.index >= a.now->torn.size())
        throw InputError(function + ": the run made at " + a.record->asked_at + " does without " + name_of(p) +
                         ": it was made before the panel was declared, or leaves panels out");
    return a;
}

int force(lua_State* L) {
    const AskedPanel a = asked(L, "force");
    for (int k = 0; k < 3; ++k) lua_pushnumber(L, a.now->force[a.index][k]);
    return 3;
}
int torn(lua_State* L) {
    const AskedPanel a = asked(L, "torn");
    if (const double at = a.now->torn_at[a.index]; std::isnan(at)) lua_pushboolean(L, 0);
    else lua_pushnumber(L, at);
    return 1;
}
int used(lua_State* L) {
    const AskedPanel a = asked(L, "used");
    lua_pushnumber(L, a.now->used[a.index]);
    return 1;
}

int fields_of_panel(lua_State* L) {
    if (push_method(L)) return 1;
    const std::string key = key_argument(L);
    const auto& p = self<PanelBox>(L, "panel." + key);
    const Panel& data = p.model->declared<Panel>(panels_effect)[std::size_t(p.index)];
    if (key == "index") lua_pushinteger(L, p.index + 1);
    else if (key == "area") lua_pushnumber(L, shape_of_panel(*p.model, data).area);
    else if (key == "mass") lua_pushnumber(L, data.sheet->mass * shape_of_panel(*p.model, data).area);
    else if (key == "shares") {
        const panel::Shape shape = shape_of_panel(*p.model, data);
        lua_createtable(L, int(data.nodes.size()), 0);
        for (std::size_t i = 0; i < data.nodes.size(); ++i)
            lua_pushnumber(L, shape.share[i]), lua_rawseti(L, -2, lua_Integer(i) + 1);
    } else if (key == "nodes") {
        lua_createtable(L, int(data.nodes.size()), 0);
        for (std::size_t i = 0; i < data.nodes.size(); ++i) {
            push_handle<NodeBox>(L, p.model, data.nodes[i]);
            lua_rawseti(L, -2, lua_Integer(i) + 1);
        }
    } else refuse_field(L, "panel", key);
    return 1;
}
int text_of_panel(lua_State* L) {
    const auto& p = self_or_gone<PanelBox>(L, "tostring");
    lua_pushstring(L, (name_of(p) + gone(p)).c_str());
    return 1;
}

void make_panel_metatable(lua_State* L) {
    const bool there = luaL_getmetatable(L, PanelBox::lua_name) != LUA_TNIL;
    lua_pop(L, 1);
    if (there) return;
    static const luaL_Reg methods[] = {{"force", guarded<takes<"panel:force", 2, force>>},
                                       {"torn", guarded<takes<"panel:torn", 2, torn>>},
                                       {"used", guarded<takes<"panel:used", 2, used>>},
                                       {nullptr, nullptr}};
    make_metatable(L, PanelBox::lua_name, methods, guarded<fields_of_panel>, collect<PanelBox>, guarded<text_of_panel>,
                   nullptr);
    name_fields(L, PanelBox::lua_name, {"index", "area", "mass", "nodes", "shares"});
}

}  // namespace

int add_panel(lua_State* L) {
    auto& m = self<ModelBox>(L, "model:panel").value;
    Options o(L, 2, "model:panel");
    const int corners = int(lua_rawlen(L, 2));
    o.expect({"thickness", "material", "hardening", "ultimate_strain", "concrete", "reinforcement", "deck", "bending",
              "along", "mass"},
             corners);
    if (corners != 3 && corners != 4)
        throw InputError("model:panel: " + std::to_string(corners) + (corners == 1 ? " node is" : " nodes are") +
                         " given; give three or four, in their order");
    Panel p;
    for (int i = 1; i <= corners; ++i) {
        o.push_item(i);
        const int node = node_argument(L, -1, "model:panel: node " + std::to_string(i), m.get()).index;
        lua_pop(L, 1);
        if (std::find(p.nodes.begin(), p.nodes.end(), node) != p.nodes.end())
            throw InputError("model:panel: node " + std::to_string(node + 1) + " is given twice");
        p.nodes.push_back(node);
    }
    p.sheet = read_sheet(o);
    p.along = o.triple("along", "").value_or(Vec3::Zero());
    const PanelPlace its(p.nodes, int(m->declared<Panel>(panels_effect).size()));
    const auto& places = m->declared<PanelPlace>(panel_places);
    if (const auto at = std::lower_bound(places.begin(), places.end(), its); at != places.end() && !(its < *at))
        throw InputError("model:panel: there is a panel between these nodes already (panel " +
                         std::to_string(at->panel + 1) + "); give one panel all its layers");
    const panel::Shape shape = shape_of_panel(*m, p);
    if (o.has("along") && !(p.along.head<3>().cross(shape.axes.col(2)).norm() > 1e-6 * p.along.norm()))
        o.complain("along", "across the panel", "must be a direction that lies in it, or nearly so");
    if (!(shape.area > 0))
        throw InputError(
            "model:panel: its nodes enclose no area, or one of its corners points inward; give them in their order "
            "around it, each corner pointing outward");
    if (corners == 3 && (p.sheet->bends_by_layers || (o.has("bending") && p.sheet->bending.stiffness > 0)))
        o.complain("bending", "given to a triangle", "triangles do not bend; leave it out, or give four nodes");
    if (const double off = off_plane(*m, p, shape); off > flat * std::sqrt(shape.area))
        throw InputError("model:panel: its nodes stand " + show(off) +
                         " m off a plane; a panel is flat to a twentieth of its size: give two triangles");
    auto& list = m->change_declared<PanelPlace>(panel_places);
    list.insert(std::lower_bound(list.begin(), list.end(), its), its);
    m->declare(panels_effect, std::move(p));
    m->ask(panels_effect, where(L));
    make_panel_metatable(L);
    push<PanelBox>(L, m, int(m->declared<Panel>(panels_effect).size()) - 1);
    hold_registry(L, *m);
    return 1;
}

}  // namespace hinge::script
