// What a script plots: curves, bands and bars, from lists of numbers.
#include <algorithm>
#include <cmath>
#include <map>

#include "core/text.h"
#include "output/plot.h"
#include "script/record/probe_list.h"
#include "script/lua/picture_module.h"
#include "script/record/recording.h"

namespace hinge::script {
namespace {

using output::Panel;
using output::Plot;
using output::Rgb8;
using output::Series;
using output::SeriesStyle;

/// Colours by name; the eight of the series are among them.
const std::map<std::string, Rgb8>& colour_names() {
    static const std::map<std::string, Rgb8> names = {
        {"blue", {0, 114, 178}},     {"red", {213, 94, 0}},      {"green", {0, 158, 115}},
        {"purple", {204, 121, 167}}, {"orange", {230, 159, 0}},  {"sky", {86, 180, 233}},
        {"black", {0, 0, 0}},        {"yellow", {240, 228, 66}}, {"grey", {110, 116, 124}}};
    return names;
}

std::optional<Rgb8> hex_colour(const std::string& text) {
    if (text.size() != 7 || text[0] != '#' || text.find_first_not_of("0123456789abcdefABCDEF", 1) != std::string::npos)
        return {};
    const unsigned long all = std::stoul(text.substr(1), nullptr, 16);
    return Rgb8{std::uint8_t(all >> 16), std::uint8_t(all >> 8 & 255), std::uint8_t(all & 255)};
}

/// Field 'colour': a name, "#rrggbb" or { r, g, b } from 0 to 1.
std::optional<Rgb8> read_colour(Options& o) {
    lua_State* L = o.L();
    const int type = o.push_field("colour");
    const std::string shown = show(L, -1);
    std::optional<Rgb8> colour;
    std::string hint;
    if (type == LUA_TSTRING) {
        const std::string text = lua_tostring(L, -1);
        const auto found = colour_names().find(text);
        colour = found != colour_names().end() ? found->second : hex_colour(text);
        std::vector<std::string> names;
        for (const auto& [name, rgb] : colour_names()) names.push_back(name);
        hint = did_you_mean(text, names);
    } else if (type == LUA_TTABLE && lua_rawlen(L, -1) == 3) {
        colour.emplace();
        for (int i = 0; i < 3 && colour; ++i) {
            const bool is_number = lua_rawgeti(L, -1, i + 1) == LUA_TNUMBER;
            const double v = is_number ? lua_tonumber(L, -1) : -1;
            lua_pop(L, 1);
            if (v >= 0 && v <= 1) (*colour)[i] = std::uint8_t(std::lround(255 * v));
            else colour.reset();
        }
    }
    lua_pop(L, 1);
    if (type != LUA_TNIL && !colour)
        o.complain("colour", shown,
                   "must be black, blue, green, grey, orange, purple, red, sky or yellow, '#rrggbb', or three numbers "
                   "{ red, green, blue } from 0 to 1" +
                       hint);
    return colour;
}

/// The list of numbers in field `name`; anything else in it leaves a gap.
std::vector<double> read_values(Options& o, const char* name) {
    lua_State* L = o.L();
    std::vector<double> values;
    if (o.push_field(name) != LUA_TTABLE) o.complain(name, show(L, -1), "must be a list of numbers");
    fill_probe_list(L, -1);
    for (lua_Integer i = 1, n = lua_rawlen(L, -1); i <= n; ++i) {
        values.push_back(lua_rawgeti(L, -1, i) == LUA_TNUMBER ? lua_tonumber(L, -1) : std::nan(""));
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
    return values;
}

/// The list of texts in field `name`; numbers become texts, anything else is empty. Empty where the field is absent.
std::vector<std::string> read_texts(Options& o, const char* name) {
    lua_State* L = o.L();
    std::vector<std::string> texts;
    const int type = o.push_field(name);
    if (type != LUA_TTABLE && type != LUA_TNIL) o.complain(name, show(L, -1), "must be a list of texts");
    fill_probe_list(L, -1);
    for (lua_Integer i = 1, n = type == LUA_TTABLE ? lua_rawlen(L, -1) : 0; i <= n; ++i) {
        const int item = lua_rawgeti(L, -1, i);
        texts.push_back(item == LUA_TSTRING ? lua_tostring(L, -1) : item == LUA_TNUMBER ? show(L, -1) : std::string());
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
    return texts;
}

/// Whether field `name` is a list that begins with a text: categories.
bool has_names(Options& o, const char* name) {
    lua_State* L = o.L();
    const bool is_table = o.push_field(name) == LUA_TTABLE;
    const bool names = is_table && lua_rawgeti(L, -1, 1) == LUA_TSTRING;
    lua_pop(L, is_table ? 2 : 1);
    return names;
}

/// The categories of an axis, and whether its series hold such names in place of numbers; none: no series says so yet.
struct Names {
    std::vector<std::string>& categories;
    std::optional<bool> used{};
};

/// x or y of a series: numbers, or names of categories, which get their numbers in the order in which they come.
std::vector<double> read_places(Options& o, const char* name, Names& names) {
    const bool named = has_names(o, name);
    std::vector<double> places = read_values(o, name);
    if (places.empty()) return places;
    if (names.used && *names.used != named)
        o.complain(name, named ? "names" : "numbers",
                   std::string("must hold ") + (named ? "numbers" : "names") +
                       " as in the series before: an axis has one or the other");
    names.used = named;
    if (!named) return places;
    places.clear();
    for (const std::string& text : read_texts(o, name)) {
        const auto at = std::find(names.categories.begin(), names.categories.end(), text) - names.categories.begin();
        if (at == std::ptrdiff_t(names.categories.size())) names.categories.push_back(text);
        places.push_back(double(at + 1));
    }
    return places;
}

void must_be_as_many(Options& o, const char* name, std::size_t n, std::size_t as) {
    if (n != as)
        o.complain(name, count_text(long(n), std::string(name) == "labels" ? "text" : "number"),
                   "must hold as many as x, " + std::to_string(as));
}

SeriesStyle read_style(Options& o) {
    const std::vector<std::string> names = {"line", "points", "line and points", "band", "bars"};
    const bool between = o.has("low") || o.has("high");
    const std::string style = o.word("style", names, between ? "band" : "line");
    const auto at = std::find(names.begin(), names.end(), style) - names.begin();
    if (between && style != "band") o.complain("style", "'" + style + "'", "must be 'band', which has low and high");
    return SeriesStyle(at);
}

Series read_series(lua_State* L, int index, const std::string& what, Names& x_names, Names& y_names) {
    Options o(L, index, what);
    o.expect({"name", "x", "y", "low", "high", "style", "dashed", "colour", "labels", "faint"});
    Series s;
    s.name = o.text("name").value_or("");
    s.style = read_style(o);
    s.x = read_places(o, "x", x_names);
    if (s.style == SeriesStyle::band) {
        if (o.has("y")) o.complain("y", "there", "must be left out: a band has low and high");
        s.y = read_values(o, "low");
        s.high = read_values(o, "high");
        must_be_as_many(o, "low", s.y.size(), s.x.size());
        must_be_as_many(o, "high", s.high.size(), s.x.size());
    } else {
        s.y = read_places(o, "y", y_names);
        must_be_as_many(o, "y", s.y.size(), s.x.size());
    }
    s.dashed = o.flag("dashed", false);
    s.faint = o.flag("faint", false);
    s.colour = read_colour(o);
    s.labels = read_texts(o, "labels");
    if (s.labels.size() > s.x.size()) must_be_as_many(o, "labels", s.labels.size(), s.x.size());
    return s;
}

/// Field `name`: { low, high } of an axis.
std::optional<std::array<double, 2>> read_range(Options& o, const char* name, bool log) {
    lua_State* L = o.L();
    const int type = o.push_field(name);
    const std::string shown = show(L, -1);
    std::optional<std::array<double, 2>> range;
    if (type == LUA_TTABLE && lua_rawlen(L, -1) == 2) {
        range.emplace();
        for (int i = 0; i < 2; ++i) {
            (*range)[i] = lua_rawgeti(L, -1, i + 1) == LUA_TNUMBER ? lua_tonumber(L, -1) : std::nan("");
            lua_pop(L, 1);
        }
    }
    lua_pop(L, 1);
    if (type == LUA_TNIL) return {};
    const bool good = range && std::isfinite((*range)[0]) && std::isfinite((*range)[1]) && (*range)[0] < (*range)[1];
    if (!good || (log && (*range)[0] <= 0))
        o.complain(name, range ? "{" + show((*range)[0]) + ", " + show((*range)[1]) + "}" : shown,
                   std::string("must be { low, high }, two numbers with low below high") +
                       (log ? ", above 0 on a logarithmic axis" : ""));
    return range;
}

output::ReferenceLine read_line(lua_State* L, int index, const std::string& what) {
    Options o(L, index, what);
    o.expect({"x", "y", "name", "dashed", "colour"});
    output::ReferenceLine line;
    const auto x = o.maybe_number("x", "", Range::any), y = o.maybe_number("y", "", Range::any);
    const std::string one = "; a line has one of them: x if it is upright, y if it is level";
    if (x && y) o.complain("y", show(*y), "must be left out beside x" + one);
    if (!x && !y) o.complain("x", "missing", "give it or y" + one);
    line.upright = x.has_value();
    line.at = x ? *x : *y;
    line.name = o.text("name").value_or("");
    line.dashed = o.flag("dashed", true);
    line.colour = read_colour(o);
    return line;
}

/// Calls `read(index, number)` for each item of the list in field `name`; the count.
template <class Read>
lua_Integer each_item(Options& o, const char* name, bool may_be_absent, const char* allowed, Read read) {
    lua_State* L = o.L();
    const int type = o.push_field(name);
    if (type != LUA_TTABLE && !(may_be_absent && type == LUA_TNIL)) o.complain(name, show(L, -1), allowed);
    fill_probe_list(L, -1);
    const lua_Integer n = type == LUA_TTABLE ? lua_Integer(lua_rawlen(L, -1)) : 0;
    for (lua_Integer i = 1; i <= n; ++i) {
        lua_rawgeti(L, -1, i);
        read(lua_gettop(L), std::to_string(i));
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
    return n;
}

/// Categories are all the places of an axis, or none.
void check_categories(Options& o, const Panel& panel) {
    if (!panel.x_categories.empty() && !panel.y_categories.empty())
        o.complain("series", "names along x and y", "must have numbers along one of the two axes");
    for (const char axis : {'x', 'y'}) {
        const auto& categories = axis == 'x' ? panel.x_categories : panel.y_categories;
        if (categories.empty()) continue;
        if (axis == 'x' ? panel.log_x || panel.x_range : panel.log_y || panel.y_range)
            o.complain(std::string(axis == 'x' ? "x" : "y") + "_range or log_" + axis, "given",
                       std::string("must be left out where ") + axis + " holds names");
    }
}

Panel read_panel(Options& o, const std::string& what) {
    Panel panel;
    panel.x_label = o.text("x_label").value_or("");
    panel.y_label = o.text("y_label").value_or("");
    panel.log_x = o.flag("log_x", false);
    panel.log_y = o.flag("log_y", false);
    panel.x_range = read_range(o, "x_range", panel.log_x);
    panel.y_range = read_range(o, "y_range", panel.log_y);
    lua_State* L = o.L();
    const auto item = [&](const char* kind, const std::string& number) {
        return what + (what.ends_with(':') ? " " : ", ") + kind + " " + number;
    };
    Names x_names{panel.x_categories}, y_names{panel.y_categories};
    each_item(o, "series", false, "must be a list of { name =, x =, y = }", [&](int at, const std::string& number) {
        panel.series.push_back(read_series(L, at, item("series", number), x_names, y_names));
    });
    each_item(o, "lines", true, "must be a list of { x = } and { y = }", [&](int at, const std::string& number) {
        panel.lines.push_back(read_line(L, at, item("line", number)));
    });
    check_categories(o, panel);
    return panel;
}

const std::vector<std::string>& panel_fields() {
    static const std::vector<std::string> names = {"title",  "x_label", "y_label", "log_x",  "log_y",
                                                   "series", "lines",   "x_range", "y_range"};
    return names;
}

/// With share_x there is one scale below a column, which must hold for all of its panels.
void check_shared_axes(Options& o, const output::Plot& plot, int columns) {
    const auto range_text = [](const std::array<double, 2>& r) { return "{" + show(r[0]) + ", " + show(r[1]) + "}"; };
    for (std::size_t i = 0; i < plot.panels.size() && plot.share_x; ++i)
        for (std::size_t k = i % std::size_t(columns); k < i; k += std::size_t(columns)) {
            const Panel &panel = plot.panels[i], &above = plot.panels[k];
            const std::string which = "panel " + std::to_string(i + 1) + " has ",
                              other = "as panel " + std::to_string(k + 1) + " in its column, which has ";
            const auto differ = [&](const std::string& own, const std::string& theirs) {
                o.complain("share_x", "true and " + which + own, "must have the same " + other + theirs);
            };
            if (panel.x_range && above.x_range && *panel.x_range != *above.x_range)
                differ("x_range " + range_text(*panel.x_range), "x_range " + range_text(*above.x_range));
            const auto kind = [](const Panel& p) -> std::string {
                return p.x_categories.empty() ? p.log_x ? "a logarithmic x axis" : "a linear x axis" : "names along x";
            };
            const auto is_empty = [](const Panel& p) {
                return std::ranges::all_of(p.series, [](const Series& one) { return one.x.empty(); });
            };
            if (is_empty(panel) || is_empty(above)) continue;
            if (kind(panel) != kind(above)) differ(kind(panel), kind(above));
            if (panel.x_categories != above.x_categories) differ("other names along x", "its own");
        }
}

struct Sheet {
    Plot plot;
    int width, height;
};

Sheet read_plot(lua_State* L, int index, const std::string& function) {
    Options o(L, index, function);
    std::vector<std::string> fields = {"title", "width", "height"};
    const bool several = o.has("panels");
    if (several) fields.insert(fields.end(), {"panels", "columns", "share_x"});
    else fields = panel_fields(), fields.insert(fields.end(), {"width", "height"});
    o.expect(fields);
    Sheet sheet;
    sheet.plot.title = o.text("title").value_or("");
    sheet.plot.columns = o.integer("columns", 1, 1);
    sheet.plot.share_x = o.flag("share_x", false);
    if (several)
        each_item(o, "panels", false, "must be a list of { series =, ... }", [&](int at, const std::string& number) {
            Options own(L, at, function + ": panel " + number);
            own.expect(panel_fields());
            Panel panel = read_panel(own, own.function());
            panel.title = own.text("title").value_or("");
            sheet.plot.panels.push_back(std::move(panel));
        });
    else sheet.plot.panels.push_back(read_panel(o, function + ":"));
    const int n = int(sheet.plot.panels.size()), columns = std::min(sheet.plot.columns, std::max(n, 1)),
              rows = (n + columns - 1) / std::max(columns, 1);
    check_shared_axes(o, sheet.plot, std::max(columns, 1));
    if (n == 0) o.complain("panels", "{}", "must hold at least one { series =, ... }");
    sheet.width = o.integer("width", 1, columns == 1 ? 1200 : std::min(800 * columns, 8192));
    sheet.height = o.integer("height", 1, rows > 1 ? std::min(160 + 420 * rows, 8192) : columns > 1 ? 600 : 900);
    return sheet;
}

/// core.write_plot(plot, path, function): curves into a PNG or SVG; `function`: who is named in messages.
int write_plot(lua_State* L) {
    if (lua_type(L, 2) != LUA_TSTRING) throw InputError("write_plot: the path is " + show(L, 2) + "; give a string");
    const std::string function = lua_type(L, 3) == LUA_TSTRING ? lua_tostring(L, 3) : "plot";
    const Sheet sheet = read_plot(L, 1, function);
    const std::string path = lua_tostring(L, 2);
    prepare_folder(*context(L), path);
    char error[512] = "";
    must_work(picture_function<hinge_plot>(*context(L), "hinge_plot")(path.c_str(), sheet.plot, sheet.width,
                                                                      sheet.height, error, sizeof error),
              error);
    return 0;
}

/// core.sandboxed(): whether the script is not trusted.
int sandboxed(lua_State* L) { return lua_pushboolean(L, context(L)->mode.sandbox), 1; }

}  // namespace

void open_plots(lua_State* L, int module) {
    static const luaL_Reg functions[] = {{"write_plot", guarded<write_plot>},
                                         {"run_history", guarded<run_history>},
                                         {"sandboxed", guarded<sandboxed>},
                                         {nullptr, nullptr}};
    lua_pushvalue(L, module);
    luaL_setfuncs(L, functions, 0);
    lua_pop(L, 1);
}

}  // namespace hinge::script
