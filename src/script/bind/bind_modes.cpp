// run:modes and run:buckling: shapes in which a structure vibrates and buckles.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "effects/panels.h"
#include "core/text.h"
#include "run/eigenmodes.h"
#include "run/statics.h"
#include "script/bind/mode_box.h"
#include "record/told_warnings.h"
#include "record/snapshot.h"
#include "script/bind/modules.h"
#include "script/bind/snapshot_box.h"

namespace hinge::script {
namespace {

int read_count(Options& o) { return o.integer("n", 1, 6); }

/// joints = "unload" or "slide": what those at their strength resist with.
Yielded read_yielded(Options& o) {
    return o.word("joints", {"unload", "slide"}, "unload") == "slide" ? Yielded::goes_on : Yielded::unloads;
}

void push_numbers(lua_State* L, const Vec3& v) {
    lua_createtable(L, 0, 3);
    for (int c = 0; c < 3; ++c) lua_pushnumber(L, v[c]), lua_setfield(L, -2, std::array{"x", "y", "z"}[std::size_t(c)]);
}

int modes(lua_State* L) {
    const auto record = self<RunBox>(L, "run:modes").value;
    Options o(L, 2, "run:modes", true);
    o.expect({"n", "joints"});
    const int count = read_count(o);
    const Yielded yielded = read_yielded(o);
    NaturalModes found;
    try {
        found = natural_modes(*record->run, count, yielded);
    } catch (const InputError& e) { throw InputError(std::string("run:modes: ") + e.what()); }
    lua_createtable(L, int(found.list.size()), 0);
    for (std::size_t i = 0; i < found.list.size(); ++i) {
        NaturalMode& mode = found.list[i];
        ModeBox box{record, std::move(mode.shape), {}, mode.omega_squared, mode.participation, Vec3::Zero()};
        for (int c = 0; c < 3; ++c)
            if (found.mass[c] > 0) box.share[c] = mode.participation[c] * mode.participation[c] / found.mass[c];
        push<ModeBox>(L, std::move(box));
        lua_rawseti(L, -2, lua_Integer(i) + 1);
    }
    return 1;
}

/// The load factor that a static run has come to: its internal forces are those of this part of the declared loads. 1
/// where they are not, since the run began with loads of the run before. Warns where a run has ended before its end.
double part_of_loads(lua_State* L, const ScriptRun& record) {
    const Run& run = *record.run;
    if (!run.is_static()) return 1;
    const double factor = run.state().factor;
    const bool held = run.structure().model().holds_loads();
    if (factor != 1 && (run.verdict() == Verdict::failed || run.limit()))
        tell(*context(L),
             {Warning::Kind::stability,
              "run:buckling: the run ended at load factor " + number_text(factor) +
                  (held ? ", and its factors are on the internal forces there, in which the loads of the run before are"
                        : ", and its factors on the declared loads follow from the internal forces there"),
              "what yields or bends before the end is in these forces; give it a part of the loads that it can carry",
              record.asked_at});
    return held || factor == 0 ? 1 : factor;
}

int buckling(lua_State* L) {
    const auto record = self<RunBox>(L, "run:buckling").value;
    Options o(L, 2, "run:buckling", true);
    o.expect({"n", "most", "joints"});
    const int count = o.integer("n", 1, 1);
    const double most = o.number("most", "", Range::positive, 1e9);
    const Yielded yielded = read_yielded(o);
    if (panels_now(record->run->state()))
        throw InputError(
            "run:buckling: the model has panels, whose forces it does not take; model:static{ to_limit = true } finds "
            "where they buckle");
    if (record->run->structure().model().options().displacement != Displacement::large)
        throw InputError(
            "run:buckling: the model has displacement = 'small', in which nothing buckles; make it with "
            "hinge.model { displacement = 'large' }, the default");
    bool carries = false;
    for (const Vec6& p : record->run->state().force) carries = carries || !p.isZero(0);
    if (!carries)
        throw InputError(
            "run:buckling: the members of this run carry nothing; run it first: the factors are on its "
            "internal forces");
    const double part = part_of_loads(L, *record);
    BucklingModes found;
    try {
        found = buckling_modes(*record->run, count, most / std::abs(part), yielded);
    } catch (const InputError& e) { throw InputError(std::string("run:buckling: ") + e.what()); }
    lua_createtable(L, int(found.list.size()), 0);
    for (std::size_t i = 0; i < found.list.size(); ++i) {
        push<ModeBox>(L, ModeBox{record, found.list[i].shape, part * found.list[i].factor});
        lua_rawseti(L, -2, lua_Integer(i) + 1);
    }
    if (std::isfinite(found.hidden)) lua_pushnumber(L, part * found.hidden);
    else lua_pushnil(L);
    return 2;
}

/// mode:displacement(node)
int displacement(lua_State* L) {
    const auto& mode = self<ModeBox>(L, "mode:displacement");
    const int node = node_argument(L, 2, "mode:displacement: node", mode.record->model.get()).index;
    for (int c = 0; c < 6; ++c)
        lua_pushnumber(L, node < int(mode.shape.size()) ? mode.shape[std::size_t(node)][c] : std::nan(""));
    return 6;
}

/// s; of a buckling mode, and of one whose state does not vibrate, 1.
double period_of(const ModeBox& mode) {
    return mode.factor || !(mode.omega_squared > 0) ? 1 : 2 * std::numbers::pi / std::sqrt(mode.omega_squared);
}

/// mode:snapshot(amplitude?, time?): the state with the shape on top, its largest displacement `amplitude`, m; at a
/// time of a vibration.
int snapshot(lua_State* L) {
    const auto& mode = self<ModeBox>(L, "mode:snapshot");
    output::Snapshot s = make_snapshot(*mode.record->run);
    double largest = 0, low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Vec6& v : mode.shape) largest = std::max(largest, v.head<3>().norm());
    for (const auto& p : s.points)
        for (const double x : p) low = std::min(low, x), high = std::max(high, x);
    double amplitude = 0.05 * (high - low);
    if (!lua_isnoneornil(L, 2)) {
        amplitude = lua_type(L, 2) == LUA_TNUMBER ? lua_tonumber(L, 2) : std::nan("");
        if (!std::isfinite(amplitude))
            throw InputError("mode:snapshot: amplitude is " + show(L, 2) + "; must be a number, m");
    }
    double by = largest > 0 ? amplitude / largest : 0;
    if (!lua_isnoneornil(L, 3)) {
        const double time = lua_type(L, 3) == LUA_TNUMBER ? lua_tonumber(L, 3) : std::nan("");
        if (!std::isfinite(time)) throw InputError("mode:snapshot: time is " + show(L, 3) + "; must be a number, s");
        by *= std::sin(2 * std::numbers::pi * time / period_of(mode));
        s.time = time, s.factor.reset();
    }
    for (std::size_t n = 0; n < mode.shape.size() && n < s.points.size(); ++n)
        for (std::size_t c = 0; c < 3; ++c) {
            const double moved = by * mode.shape[n][Eigen::Index(c)];
            s.points[n][c] += moved, s.displacement[n][c] += moved;
            s.rotation[n][c] += by * mode.shape[n][Eigen::Index(c) + 3];
        }
    push<SnapshotBox>(L, std::move(s), mode.record->run->share_structure(), mode.record->model);
    return 1;
}

constexpr const char* natural_fields[] = {"frequency", "period", "omega_squared", "participation", "mass", "share"};

/// A natural mode has no factor, and a buckling mode that alone.
int mode_fields(lua_State* L) {
    if (push_method(L)) return 1;
    const std::string key = key_argument(L);
    const auto& mode = self<ModeBox>(L, "mode." + key);
    const double omega = mode.omega_squared > 0 ? std::sqrt(mode.omega_squared) : 0;
    const bool of_buckling = key == "factor";
    if (of_buckling != mode.factor.has_value() &&
        (of_buckling || std::ranges::find(natural_fields, key) != std::end(natural_fields)))
        lua_pushnil(L);
    else if (of_buckling) lua_pushnumber(L, *mode.factor);
    else if (key == "frequency") lua_pushnumber(L, omega / (2 * std::numbers::pi));
    else if (key == "period") lua_pushnumber(L, 2 * std::numbers::pi / omega);
    else if (key == "omega_squared") lua_pushnumber(L, mode.omega_squared);
    else if (key == "participation") push_numbers(L, mode.participation);
    else if (key == "mass") push_numbers(L, mode.participation.cwiseAbs2());
    else if (key == "share") push_numbers(L, mode.share);
    else refuse_field(L, "mode", key);
    return 1;
}
int mode_text(lua_State* L) {
    const auto& mode = self<ModeBox>(L, "tostring");
    const std::string text =
        mode.factor ? "buckling mode at factor " + script::show(*mode.factor)
                    : "natural mode of " +
                          script::show(std::sqrt(std::max(0.0, mode.omega_squared)) / (2 * std::numbers::pi)) + " Hz";
    lua_pushstring(L, text.c_str());
    return 1;
}

}  // namespace

void open_modes(lua_State* L) {
    static const luaL_Reg of_mode[] = {{"displacement", guarded<takes<"mode:displacement", 2, displacement>>},
                                       {"snapshot", guarded<takes<"mode:snapshot", 3, snapshot>>},
                                       {nullptr, nullptr}};
    make_metatable(L, ModeBox::lua_name, of_mode, guarded<mode_fields>, collect<ModeBox>, guarded<mode_text>, nullptr);
    name_fields(L, ModeBox::lua_name,
                {"frequency", "period", "omega_squared", "participation", "mass", "share", "factor"});
    static const luaL_Reg of_run[] = {{"modes", guarded<takes<"run:modes", 2, modes>>},
                                      {"buckling", guarded<takes<"run:buckling", 2, buckling>>},
                                      {nullptr, nullptr}};
    add_methods(L, RunBox::lua_name, of_run);
}

}  // namespace hinge::script
