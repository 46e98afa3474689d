#include "script/bind/section_shapes.h"

#include <map>

#include "script/lua/options.h"
#include "section/shapes.h"

namespace hinge::script {
namespace {

/// The dimensions in the table of a call, m.
class Sizes {
public:
    explicit Sizes(Options& from) : from_(from) {}
    double operator()(const char* field) { return from_.number(field, "m", Range::positive); }
    double or_0(const char* field) { return from_.number(field, "m", Range::not_negative, 0); }
    std::optional<double> maybe(const char* field) { return from_.maybe_number(field, "m", Range::not_negative); }

private:
    Options& from_;
};

using Maker = Shape (*)(Sizes& size, const std::string& what);

HSizes read_h(Sizes& of) { return {of("depth"), of("width"), of("web"), of("flange"), of.or_0("r")}; }

/// Walls of one thickness: errors name the field that was given.
Shape make_box(Sizes& of, const std::string& what) {
    const auto thickness = of.maybe("thickness");
    const double web = thickness ? *thickness : of("web"), flange = thickness ? *thickness : of("flange");
    try {
        return box_shape({of("width"), of("depth"), web, flange, of.or_0("r"), of.maybe("r_inner")}, what);
    } catch (const FieldError& e) {
        const bool of_wall = e.field == "web" || e.field == "flange";
        if (thickness && of_wall) throw FieldError(what, "thickness", e.why);
        throw;
    }
}

const std::map<std::string, Maker>& makers() {
    static const std::map<std::string, Maker> all = {
        {"solid",
         [](Sizes& of, const std::string&) {
             return solid_shape({of("width"), of("depth")});
         }},
        {"box", make_box},
        {"h", [](Sizes& of, const std::string& what) { return h_shape(read_h(of), what); }},
        {"tapered", [](Sizes& of, const std::string& what) { return tapered_h_shape(read_h(of), what); }},
        {"channel",
         [](Sizes& of, const std::string& what) {
             return channel_shape({of("depth"), of("width"), of("web"), of("flange"), of.or_0("r"), of.or_0("r_toe"),
                                   of.or_0("slope"), of.maybe("flange_at")},
                                  what);
         }},
        {"angle",
         [](Sizes& of, const std::string& what) {
             return angle_shape({of("depth"), of("width"), of("thickness"), of.or_0("r"), of.or_0("r_toe")}, what);
         }},
        {"double angle",
         [](Sizes& of, const std::string& what) {
             return double_angle_shape({of("depth"), of("width"), of("thickness"), of.or_0("gap")}, what);
         }},
        {"tee",
         [](Sizes& of, const std::string& what) {
             return tee_shape({of("depth"), of("width"), of("web"), of("flange"), of.or_0("r")}, what);
         }},
        {"pipe", [](Sizes& of, const std::string& what) { return pipe_shape(of("diameter"), of("thickness"), what); }},
        {"round", [](Sizes& of, const std::string&) { return round_shape(of("diameter")); }},
    };
    return all;
}

/// Sets fields of the table on top of the stack, those that are not 0.
void set_numbers(lua_State* L, std::initializer_list<std::pair<const char*, double>> fields) {
    for (const auto& [name, value] : fields) {
        if (value == 0) continue;
        lua_pushnumber(L, value);
        lua_setfield(L, -2, name);
    }
}

void push_part(lua_State* L, const beam::Outline::Polygon& part) {
    lua_newtable(L);
    lua_createtable(L, int(part.corners.size()), 0);
    for (std::size_t i = 0; i < part.corners.size(); ++i) {
        push_array(L, part.corners[i].data(), 2);
        lua_rawseti(L, -2, lua_Integer(i) + 1);
    }
    lua_setfield(L, -2, "corners");
    if (!part.hole) return;
    lua_pushboolean(L, true);
    lua_setfield(L, -2, "hole");
}

void push_part(lua_State* L, const beam::Outline::Circle& part) {
    lua_newtable(L);
    set_numbers(L, {{"diameter", 2 * part.radius}});
    if (!part.hole) return;
    lua_pushboolean(L, true);
    lua_setfield(L, -2, "hole");
}

void push_outline(lua_State* L, const beam::Outline& outline) {
    lua_newtable(L);
    lua_Integer count = 0;
    for (const auto& part : outline.polygons) push_part(L, part), lua_rawseti(L, -2, ++count);
    for (const auto& part : outline.circles) push_part(L, part), lua_rawseti(L, -2, ++count);
}

void push_walls(lua_State* L, const Section& s) {
    lua_newtable(L);
    for (const int axis : {0, 1}) {
        lua_newtable(L);
        lua_Integer count = 0;
        for (const Section::Wall& w : s.walls[axis]) {
            const double sides[] = {w.x0, w.x1, w.y0, w.y1};
            push_array(L, sides, 4);
            lua_rawseti(L, -2, ++count);
        }
        lua_setfield(L, -2, axis == 0 ? "x" : "y");
    }
}

}  // namespace

int push_shape(lua_State* L) {
    const char *kind = lua_tostring(L, 1), *what = lua_tostring(L, 3);
    const auto maker = makers().find(kind ? kind : "");
    if (maker == makers().end() || !what) throw InputError("shape: takes a kind, a table of sizes and a name");
    Options o(L, 2, what);
    Sizes sizes(o);
    const Shape made = maker->second(sizes, o.function());
    const Section& s = made.section;
    lua_newtable(L);
    lua_pushstring(L, s.kind.c_str());
    lua_setfield(L, -2, "kind");
    set_numbers(L, {{"area", s.area},
                    {"Ix", s.Ix},
                    {"Iy", s.Iy},
                    {"J", s.J},
                    {"shear_area_x", s.shear_area_x},
                    {"shear_area_y", s.shear_area_y}});
    lua_newtable(L);
    set_numbers(L, {{"A", s.plastic_area}, {"Zx", s.Zx}, {"Zy", s.Zy}, {"Zz", s.Zz}});
    lua_setfield(L, -2, "plastic");
    lua_newtable(L);
    set_numbers(L, {{"width", s.width}, {"depth", s.depth}, {"web", s.web}, {"flange", s.flange}});
    lua_setfield(L, -2, "size");
    push_outline(L, made.outline);
    lua_setfield(L, -2, "outline");
    if (!s.walls[0].empty() || !s.walls[1].empty()) {
        push_walls(L, s);
        lua_setfield(L, -2, "shear_walls");
    }
    return 1;
}

}  // namespace hinge::script
