// Forces along gravity by source; warnings of loads without mass, floors counted twice, and late gravity.
#include <cmath>
#include <optional>

#include "core/text.h"
#include "effects/declared.h"
#include "effects/line_mass.h"
#include "effects/loads.h"
#include "effects/member_loads.h"
#include "effects/point_mass.h"
#include "advice/load_warnings.h"

namespace hinge {
namespace {

/// Loads along gravity over the weight of all mass, in dynamics: beyond it, floors are loads and not mass.
constexpr double much_load = 3;

/// Loads along gravity and the weight of point masses are taken for the same floors where neither is more than this
/// many times the other: mass rounded, tributary widths that differ, live load in one of them alone.
constexpr double alike = 1.3;

/// Loads on members and loads on nodes are one floor given twice only where they are nearly equal: most models have
/// both for a reason.
constexpr double equal_loads = 1.02;

/// A density beyond this many times the usual one of the material holds something else as well, such as floors.
constexpr double heavier = 1.3;

/// Along gravity, N, of what acts without a history.
struct Weights {
    double members = 0, point_masses = 0, on_members = 0, on_nodes = 0;
    double line_masses = 0;           ///< of `members`, what they carry per length
    double in_density = 0;            ///< of `members`, what their densities hold beside the material itself
    double mass = 0, point_mass = 0;  ///< kg, of members and of points
    double loads() const { return on_members + on_nodes; }
    double all() const { return members + point_masses + loads(); }
};

/// kg/m^3 of the material that has such a modulus, Pa: steel, aluminium, concrete, timber; 0 where there is none.
double usual_density(double E) {
    if (E >= 170e9 && E <= 230e9) return 7850;
    if (E >= 60e9 && E <= 80e9) return 2700;
    if (E >= 15e9 && E <= 50e9) return 2500;
    return E >= 6e9 && E < 15e9 ? 700 : 0;
}

/// None where the model has no gravity.
std::optional<Weights> weights_of(const Structure& s) {
    const Model& model = s.model();
    const std::optional<Vec3> gravity = declared_gravity(model);
    if (!gravity || gravity->isZero(0)) return {};
    const double g = gravity->norm();
    const Vec3 down = *gravity / g;
    Weights w;
    for (const DeclaredLoad& l : declared_loads(model))
        if (l.constant) (l.member >= 0 ? w.on_members : w.on_nodes) += l.force.dot(down);
    for (const Element& e : s.elements()) {
        w.mass += e.mass();
        const Material& material = *model.members()[e.member].material;
        const double usual = usual_density(material.E);
        const double on_line = model.members()[e.member].line_mass * e.length;
        if (usual > 0 && material.density > heavier * usual)
            w.in_density += g * (1 - usual / material.density) * (e.mass() - on_line);
        w.line_masses += g * on_line;
    }
    for (const AddedMass& m : added_masses(model)) w.point_mass += m.mass.mass;
    w.members = g * w.mass, w.point_masses = g * w.point_mass;
    return w;
}

}  // namespace

std::string weight_by_source(const Structure& structure) {
    const auto w = weights_of(structure);
    if (!w) return "";
    std::string text = "  along gravity: members " + digits(w->members - w->line_masses) + " N";
    if (w->line_masses > 0) text += ", masses on members " + digits(w->line_masses) + " N";
    if (w->point_masses > 0)
        text += ", point masses " + digits(w->point_masses) + " N (" + digits(w->point_mass) + " kg)";
    if (w->on_members != 0) text += ", loads on members " + digits(w->on_members) + " N";
    if (w->on_nodes != 0) text += ", loads on nodes " + digits(w->on_nodes) + " N";
    return text + (w->all() != w->members ? ", together " + digits(w->all()) + " N\n" : "\n");
}

std::vector<Warning> massless_loads(const Structure& s, const std::string& line) {
    const auto w = weights_of(s);
    if (!w || w->loads() < much_load * (w->members + w->point_masses)) return {};
    return {{Warning::Kind::loads,
             "the loads along gravity, " + digits(w->loads(), 3) + " N, are " +
                 digits(w->loads() / (w->members + w->point_masses), 2) + " times the weight of the model's " +
                 digits(w->mass + w->point_mass, 3) +
                 " kg; loads have no inertia, so what falls under them falls faster than free",
             "give floors as mass in the place of these loads: a density that holds them, or model:mass; gravity gives "
             "mass its weight",
             line}};
}

std::vector<Warning> floors_twice(const Structure& s) {
    const auto w = weights_of(s);
    if (!w) return {};
    /// A way to give floors their weight: its sum, what it is, the call that gives it, what to leave out.
    struct Way {
        double weight;
        const char *what, *effect, *weighs = "";
    };
    const Way density{w->in_density, "densities of members beyond those of their materials", "", "which weigh "},
        members{w->on_members, "loads on members along gravity", member_loads_effect},
        nodes{w->on_nodes, "loads on nodes along gravity", loads_effect},
        loads{w->loads(), "loads along gravity", w->on_members > 0 ? member_loads_effect : loads_effect},
        points{w->point_masses, "point masses", point_mass_effect, "which weigh "},
        lines{w->line_masses, "masses on members", line_mass_effect, "which weigh "};
    const auto are_alike = [](const Way& a, const Way& b, double by) {
        return a.weight > 0 && b.weight > 0 && a.weight <= by * b.weight && b.weight <= by * a.weight;
    };
    const auto twice = [&](const Way& a, const Way& b, const char* advice) -> std::vector<Warning> {
        return {{Warning::Kind::loads,
                 std::string(a.what) + ", " + a.weighs + digits(a.weight) + " N, and " + b.what + ", " + b.weighs +
                     digits(b.weight) + " N, act together: " + digits(w->all()) + " N with the members",
                 std::string("are they the same floors? Then these count twice: ") + advice,
                 s.model().asked_at(b.effect)}};
    };
    const char *const no_loads = "leave the loads out, since gravity gives masses their weight",
                      *const one = "leave one of the two out";
    for (const Way& a : {loads, members, nodes})
        if (are_alike(a, points, alike)) return twice(a, points, no_loads);
    for (const Way& a : {members, nodes, loads})
        if (are_alike(density, a, alike)) return twice(density, a, no_loads);
    for (const Way& a : {loads, members, nodes})
        if (are_alike(a, lines, equal_loads)) return twice(a, lines, no_loads);
    for (const auto& [a, b] : {std::pair{density, points}, std::pair{density, lines}, std::pair{lines, points}})
        if (are_alike(a, b, alike)) return twice(a, b, one);
    if (are_alike(members, nodes, equal_loads)) return twice(members, nodes, one);
    return {};
}

std::vector<Warning> late_gravity(const Structure& s, const AdvisedRun& before, const std::string& line) {
    const std::optional<Vec3> now = declared_gravity(s.model());
    const Vec3 then = declared_gravity(before.run->structure().model()).value_or(Vec3::Zero());
    if (!now || now->isZero(0) || now->isApprox(then)) return {};
    const std::string run = std::string(before.run->kind()) + " run made at " + before.asked_at;
    return {{Warning::Kind::loads,
             "gravity " + vector_text(*now) + " m/s^2 acts at once in this run, and " +
                 (then.isZero(0) ? "did not act in the " + run : "was " + vector_text(then) + " m/s^2 in the " + run) +
                 ", from which it goes on",
             "weight that acts at once moves a structure about twice as far as at rest; declare model:gravity before "
             "that run",
             line}};
}

}  // namespace hinge
