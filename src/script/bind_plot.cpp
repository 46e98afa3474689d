// What a script plots: curves, from lists of numbers.
#include <cmath>

#include "output/plot.h"
#include "script/picture_module.h"

namespace hinge::script {
namespace {

/// The list of numbers in field `name` of a curve; anything else in it leaves a gap.
std::vector<double> read_values(Options& o, const char* name) {
    lua_State* L = o.L();
    std::vector<double> values;
    if (o.push_field(name) != LUA_TTABLE) o.complain(name, show(L, -1), "must be a list of numbers");
    for (lua_Integer i = 1, n = lua_rawlen(L, -1); i <= n; ++i) {
        values.push_back(lua_rawgeti(L, -1, i) == LUA_TNUMBER ? lua_tonumber(L, -1) : std::nan(""));
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
    return values;
}

output::Series read_series(lua_State* L, int index, const std::string& what) {
    Options o(L, index, what);
    output::Series s;
    s.name = o.text("name").value_or("");
    s.x = read_values(o, "x");
    s.y = read_values(o, "y");
    if (s.x.size() != s.y.size())
        o.complain("y", std::to_string(s.y.size()) + " numbers",
                   "must hold as many as x, " + std::to_string(s.x.size()));
    s.style = o.word("style", {"line", "points"}, "line") == "points" ? output::SeriesStyle::points
                                                                      : output::SeriesStyle::line;
    s.dashed = o.flag("dashed", false);
    o.finish();
    return s;
}

/// core.write_plot(plot, path): curves into a PNG.
int write_plot(lua_State* L) {
    if (lua_type(L, 2) != LUA_TSTRING) throw InputError("write_plot: the path is " + show(L, 2) + "; give a string");
    Options o(L, 1, "plot");
    output::Plot plot;
    plot.title = o.text("title").value_or("");
    plot.x_label = o.text("x_label").value_or("");
    plot.y_label = o.text("y_label").value_or("");
    plot.log_x = o.flag("log_x", false);
    plot.log_y = o.flag("log_y", false);
    const int width = o.integer("width", 1, 1200), height = o.integer("height", 1, 900);
    if (o.push_field("series") != LUA_TTABLE)
        o.complain("series", show(L, -1), "must be a list of { name =, x =, y = }");
    for (lua_Integer i = 1, n = lua_rawlen(L, -1); i <= n; ++i) {
        lua_rawgeti(L, -1, i);
        plot.series.push_back(read_series(L, lua_gettop(L), "plot: series " + std::to_string(i)));
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
    o.finish();
    const std::string path = lua_tostring(L, 2);
    prepare_folder(*context(L), path);
    char error[512] = "";
    must_work(
        picture_function<hinge_plot>(*context(L), "hinge_plot")(path.c_str(), plot, width, height, error, sizeof error),
        error);
    return 0;
}

}  // namespace

void open_plots(lua_State* L, int module) {
    static const luaL_Reg functions[] = {{"write_plot", guarded<write_plot>}, {nullptr, nullptr}};
    lua_pushvalue(L, module);
    luaL_setfuncs(L, functions, 0);
    lua_pop(L, 1);
}

}  // namespace hinge::script
