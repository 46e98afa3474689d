#include "script/bind/material_laws.h"

#include <cmath>

#include "section/laws/laws.h"

namespace hinge::script {
namespace {

/// read(options of the table in this field), where there is one.
template <class F>
void of_table(Options& o, const char* field, const char* fields, F read) {
    lua_State* L = o.L();
    const int type = o.push_field(field);
    if (type == LUA_TTABLE) {
        Options inner(L, lua_gettop(L), o.function() + ": field '" + field + "'");
        read(inner);
    } else if (type != LUA_TNIL) {
        o.complain(field, show(L, -1), std::string("must be a table with ") + fields);
    }
    lua_pop(L, 1);
}

beam::Hardening read_hardening(Options& h, const Material& m) {
    h.expect({"tangent", "modulus", "kinematic", "saturation"});
    const auto tangent = h.maybe_number("tangent", "Pa", Range::not_negative),
               modulus = h.maybe_number("modulus", "Pa", Range::not_negative);
    if (bool(tangent) == bool(modulus))
        h.complain("tangent", tangent ? "given beside modulus" : "missing, and so is modulus",
                   "give one of two: tangent, the slope of the stress over the strain beyond yield (Pa), or modulus, "
                   "that over the plastic strain (Pa)");
    if (tangent && *tangent >= m.E)
        h.complain("tangent", show(*tangent) + " Pa", "must be less than E, " + show(m.E) + " Pa");
    const double H = modulus ? *modulus : beam::plastic_modulus_of(*tangent, m.E);
    const double kinematic = h.number("kinematic", "", Range::not_negative, 1);
    if (kinematic > 1) h.complain("kinematic", show(kinematic), "must be a part of the hardening, from 0 to 1");
    beam::Hardening out{kinematic * H, 0, (1 - kinematic) * H};
    if (const auto saturation = h.maybe_number("saturation", "Pa", Range::positive)) {
        if (out.kinematic == 0) h.complain("saturation", show(*saturation) + " Pa", "needs kinematic hardening");
        out.saturation = *saturation;
    }
    h.finish();
    return out;
}

beam::StrainRate read_rate(Options& r) {
    r.expect({"D", "q", "C", "reference"});
    const auto get = [&](const char* field, const char* unit) { return r.maybe_number(field, unit, Range::positive); };
    const auto D = get("D", "1/s"), q = get("q", ""), C = get("C", ""), reference = get("reference", "1/s");
    if (!(D && q && !C && !reference) && !(C && reference && !D && !q))
        r.complain("rate", "incomplete, or two at once",
                   "give D (1/s) and q, of Cowper and Symonds, or C and reference (1/s), of Johnson and Cook");
    r.finish();
    return {D.value_or(0), q.value_or(0), C.value_or(0), reference.value_or(0)};
}

/// The list in field hot_curve, on top of the stack.
std::vector<beam::HotCurvePoint> read_hot_curve(Options& o) {
    lua_State* L = o.L();
    const std::string what = o.function() + ": field 'hot_curve'";
    if (!lua_istable(L, -1))
        o.complain("hot_curve", show(L, -1),
                   "must be what hinge.heat.curve() returns, or a list of points { degrees "
                   "Celsius, k_y, k_p, k_E }");
    std::vector<beam::HotCurvePoint> points;
    for (lua_Integer i = 1, n = list_length(L, -1, what); i <= n; ++i) {
        const std::vector<double> point = numbers_in(L, i, 4);
        for (const double x : point)
            if (!std::isfinite(x))
                throw InputError(what + "[" + std::to_string(i) + "] must be { degrees Celsius, k_y, k_p, k_E }");
        points.push_back({point[0], point[1], point[2], point[3]});
    }
    return points;
}

}  // namespace

std::vector<std::shared_ptr<const beam::MaterialLaw>> read_material_laws(Options& o, const Material& m) {
    std::vector<std::shared_ptr<const beam::MaterialLaw>> laws;
    const auto must_yield = [&](const char* field) {
        if (!std::isfinite(m.yield_stress)) o.complain(field, "given", "needs yield_stress (Pa) beside it");
    };
    of_table(o, "hardening", "tangent or modulus (Pa), kinematic (0 to 1), saturation (Pa)", [&](Options& h) {
        must_yield("hardening");
        const beam::Hardening hardening = read_hardening(h, m);
        if (hardening.kinematic > 0 || hardening.isotropic > 0)
            laws.push_back(beam::hardening_law(hardening, m.yield_stress));
    });
    of_table(o, "rate", "D (1/s) and q, or C and reference (1/s)", [&](Options& r) {
        must_yield("rate");
        laws.push_back(beam::strain_rate_law(read_rate(r)));
    });
    if (o.push_field("hot_curve") != LUA_TNIL) {
        must_yield("hot_curve");
        if (!laws.empty())
            o.complain("hot_curve", "given", "cannot stand beside hardening or rate; leave out one of them");
        laws.push_back(beam::hot_curve_law(read_hot_curve(o), m.E, m.yield_stress));
    }
    lua_pop(o.L(), 1);
    return laws;
}

}  // namespace hinge::script
