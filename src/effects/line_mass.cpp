// Masses along members: the difference between their weight where they are and the even weight that gravity gives them.
//
// The inertia of a line mass is part of its member's own (MemberData::line_mass), spread evenly over it, and so is the
// weight by which gravity acts on it. A floor that spans two ways lies on its beams in triangles: its weight bends them
// by a third more than an even one. The difference sums up to zero over a member, and is a load on it.
#include "effects/line_mass.h"

#include "core/text.h"
#include "effects/gravity.h"
#include "effects/kinds.h"
#include "effects/member_loads.h"

namespace hinge {
namespace {

const std::vector<LineMass>& line_masses_of(const Model& model) { return model.declared<LineMass>(line_mass_effect); }

/// Of the members whose line masses are not even, the mean that gravity has already, kg/m; zero of all others.
std::vector<double> uneven_means(const Model& model) {
    std::vector<double> mean(model.members().size(), 0);
    std::vector<char> uneven(mean.size(), 0);
    for (const LineMass& m : line_masses_of(model)) {
        mean[m.member] += m.mean();
        if (!m.is_even()) uneven[m.member] = 1;
    }
    for (std::size_t i = 0; i < mean.size(); ++i)
        if (!uneven[i]) mean[i] = 0;
    return mean;
}

/// The difference as loads, by a gravity in m/s^2. `mean`: uneven_means.
void add_difference(const Model& model, const std::vector<double>& mean, const Vec3& g, bool held,
                    std::vector<MemberLoad>& to) {
    if (g.isZero(0)) return;
    const auto add = [&](int member, double from, double end, double first, double last) {
        MemberLoad load{member};
        load.from = from, load.to = end, load.held = held, load.number = int(to.size());
        load.force[0] = first * g, load.force[1] = last * g;
        to.push_back(std::move(load));
    };
    for (std::size_t i = 0; i < mean.size(); ++i)
        if (mean[i] != 0) add(int(i), 0, 1, -mean[i], -mean[i]);
    for (const LineMass& m : line_masses_of(model))
        if (mean[m.member] != 0) add(m.member, m.from, m.to, m.per_length[0], m.per_length[1]);
}

std::vector<PlanLine> line_mass_plan(const Structure& s, const RunKind&) {
    const Model& model = s.model();
    double mass = 0;
    long members = 0;
    for (std::size_t i = 0; i < model.members().size(); ++i)
        if (const double m = model.members()[i].line_mass; m > 0) {
            ++members;
            mass += m * (end_position(model, int(i), 1) - end_position(model, int(i), 0)).norm();
        }
    const bool on = members > 0;
    return {{line_mass_effect, on, on ? digits(mass) + " kg on " + count_text(members, "member") : "not declared",
             model.asked_at(line_mass_effect)}};
}

}  // namespace

void add_line_mass(Model& model, const LineMass& mass) {
    if (mass.mean() == 0) return;
    model.add_line_mass(mass.member, mass.mean());
    model.declare(line_mass_effect, mass);
}

EffectKind line_mass_kind() {
    return {.name = line_mass_effect,
            .plan = line_mass_plan,
            .make = [](Workspace& w, Host& host) -> std::unique_ptr<Effect> {
                const Model& model = w.structure.model();
                const DeclaredGravity* gravity = gravity_of(model);
                if (!gravity || model.options().weight != Weight::members) return nullptr;
                const std::vector<double> mean = uneven_means(model);
                std::vector<MemberLoad> loads;
                add_difference(model, mean, gravity->held, true, loads);
                add_difference(model, mean, gravity->acceleration - gravity->held, false, loads);
                if (loads.empty()) return nullptr;
                return make_weights_on_members(line_mass_effect, std::move(loads), w, host);
            }};
}

}  // namespace hinge
