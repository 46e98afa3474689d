// Numbers of a script that look as if they were in another unit, or along another axis.
#include "advice/implausible_values.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/text.h"
#include "effects/declared.h"
#include "effects/fracture.h"
#include "effects/fracture_rule.h"
#include "effects/gravity.h"
#include "effects/moving_supports.h"
#include "effects/panels.h"
#include "effects/settlement.h"
#include "model/structure.h"

namespace hinge {
namespace {

constexpr double degrees = 180 / 3.14159265358979323846;  ///< of a radian
constexpr double most_rotation = 0.5;                     ///< rad, of a support that settles: 29 degrees
constexpr double part_of_size = 0.1;                      ///< of the structure: a settlement beyond it
constexpr double most_strain = 1;                         ///< of a limit of fracture: 100 %
constexpr double most_hinge = 1.5;                        ///< rad, of a limit of hinges: 86 degrees
constexpr double most_curvature = 1000;                   ///< 1/m: a bar of 1 mm is wound to a circle of that radius
constexpr double most_speed = 300;                        ///< m/s; airliners fly at 250
constexpr double most_bars = 0.2;                         ///< m^2/m, of a panel's reinforcement or deck
constexpr double least_size = 3;                          ///< m, as thick as a panel of any width may be
constexpr double least_modulus = 1e6;                     ///< Pa, of a panel: softer than rubber
constexpr double most_spin = 100;                         ///< rad/s: 16 turns a second

std::string axis_name(int c) { return std::string(1, "xyz"[c % 3]); }

/// Diagonal of the box around the nodes, m.
double size_of(const Model& model) {
    if (model.nodes().empty()) return 0;
    Vec3 low = model.nodes()[0].position, high = low;
    for (const NodeData& n : model.nodes()) low = low.cwiseMin(n.position), high = high.cwiseMax(n.position);
    return (high - low).norm();
}

void settlements(const Model& model, std::vector<Warning>& list) {
    const double most = part_of_size * size_of(model);
    const auto& all = model.declared<Settlement>(settlement_effect);
    const auto is_large = [&](const Settlement& s) {
        return std::abs(s.by) > (s.component < 3 ? most : most_rotation);
    };
    const auto first = std::find_if(all.begin(), all.end(), is_large);
    if (first == all.end()) return;
    const std::string what = "model:settle moves node " + std::to_string(first->node + 1) + " by " +
                             (first->component < 3 ? axis_name(first->component) : "r" + axis_name(first->component)) +
                             " = " + digits(first->by);
    if (first->component < 3)
        list.push_back({Warning::Kind::value, what + " m, more than a tenth of the structure's size",
                        "is it in mm? settlements are in m", model.asked_at(settlement_effect)});
    else
        list.push_back({Warning::Kind::value, what + " rad, which is " + digits(first->by * degrees, 3) + " degrees",
                        "is it in degrees? rotations are in rad", model.asked_at(settlement_effect)});
    list.back().more = int(std::count_if(all.begin(), all.end(), is_large)) - 1;
}

void fracture_limits(const Model& model, std::vector<Warning>& list) {
    for (const FractureRule& rule : model.declared<FractureRule>(fracture_effect)) {
        const auto tell = [&](const char* field, double value, double most, const char* unit, const std::string& means,
                              const char* advice) {
            if (!(value > most && std::isfinite(value))) return;
            list.push_back({Warning::Kind::value,
                            std::string("model:fracture has ") + field + " = " + digits(value) + unit + means, advice,
                            rule.asked_at});
        };
        const auto strain = [&](const char* field, double value) {
            tell(field, value, most_strain, "", ", which is " + digits(100 * value) + " %: nothing breaks by it",
                 "is it in per cent? strains have no unit: 20 % is 0.2");
        };
        strain("axial_strain", rule.axial_strain);
        strain("shear_strain", rule.shear_strain);
        for (const auto& [field, value] : {std::pair{"hinge_rotation_x", rule.hinge_rotation_x},
                                           std::pair{"hinge_rotation_y", rule.hinge_rotation_y}})
            tell(field, value, most_hinge, " rad", ", which is " + digits(value * degrees, 3) + " degrees",
                 "is it in degrees? rotations are in rad");
        for (const auto& [field, value] :
             {std::pair{"curvature_x", rule.curvature_x}, std::pair{"curvature_y", rule.curvature_y}})
            tell(field, value, most_curvature, " 1/m", ": a radius of less than 1 mm",
                 "curvatures are in 1/m: 0.0004 1/mm is 0.4 1/m");
        const double size = size_of(model);
        tell("elongation", rule.elongation, size, " m", ", more than the structure's size",
             "is it in mm? elongations are in m");
    }
}

void speeds(const Model& model, std::vector<Warning>& list) {
    const auto& all = model.given_velocities();
    const auto is_large = [](const GivenVelocity& v) { return v.linear.norm() > most_speed; };
    const auto first = std::find_if(all.begin(), all.end(), is_large);
    if (first == all.end() || first->nodes.empty()) return;
    const double speed = first->linear.norm();
    list.push_back(
        {Warning::Kind::value,
         "model:velocity gives " + digits(speed) + " m/s to node " + std::to_string(first->nodes[0] + 1) +
             (first->nodes.size() > 1 ? " and others" : "") + ", which is " + digits(3.6 * speed) + " km/h",
         "is it in km/h? velocities are in m/s: " + digits(speed) + " km/h are " + digits(speed / 3.6, 4) + " m/s",
         first->asked_at});
    list.back().more = int(std::count_if(all.begin(), all.end(), is_large)) - 1;
}

/// Rates of rotation in degrees or turns a minute.
void spins(const Model& model, std::vector<Warning>& list) {
    const auto& all = model.given_velocities();
    const auto is_large = [](const GivenVelocity& v) { return v.angular.norm() > most_spin; };
    const auto first = std::find_if(all.begin(), all.end(), is_large);
    if (first == all.end() || first->nodes.empty()) return;
    const double spin = first->angular.norm();
    list.push_back({Warning::Kind::value,
                    "model:velocity turns node " + std::to_string(first->nodes[0] + 1) +
                        (first->nodes.size() > 1 ? " and others" : "") + " at " + digits(spin) + " rad/s, which is " +
                        digits(spin * degrees / 360, 3) + " turns a second",
                    "is it in degrees per second, or in turns per minute? rates of rotation are in rad/s",
                    first->asked_at});
    list.back().more = int(std::count_if(all.begin(), all.end(), is_large)) - 1;
}

/// Supports that move by more than the structure is large, by points of a history.
void motions(const Model& model, std::vector<Warning>& list) {
    const double most = size_of(model);
    for (const SupportMotion& m : model.declared<SupportMotion>(moving_supports_effect)) {
        double largest = 0;
        const History::Points* points = m.displacement.points();
        for (std::size_t i = 0; points && i < points->size(); ++i)
            largest = std::max(largest, std::abs((*points)[i].second));
        if (m.component >= 3) {
            if (!(largest > 2 * std::numbers::pi)) continue;
            list.push_back({Warning::Kind::value,
                            "model:move rotates node " + std::to_string(m.node + 1) + " by up to " + digits(largest) +
                                " rad about " + axis_name(m.component - 3) + ", more than a whole turn",
                            "is it in degrees? rotations are in rad",
                            model.asked_at("motion of node " + std::to_string(m.node))});
            return;
        }
        if (!(largest > most)) continue;
        list.push_back({Warning::Kind::value,
                        "model:move moves node " + std::to_string(m.node + 1) + " by up to " + digits(largest) +
                            " m along " + axis_name(m.component) + ", more than the structure's size, " +
                            digits(most, 3) + " m",
                        "is it in mm? motions are in m", model.asked_at("motion of node " + std::to_string(m.node))});
        return;
    }
}

/// Panels as thick as they are wide, with more steel than anybody lays, or softer than rubber.
void panels(const Model& model, std::vector<Warning>& list) {
    const std::string line = model.asked_at(panels_effect);
    for (const Panel& panel : model.declared<Panel>(panels_effect)) {
        const double width = std::sqrt(shape_of_panel(model, panel).area);
        const std::string name = "panel " + std::to_string(&panel - model.declared<Panel>(panels_effect).data() + 1);
        for (const panel::Layer& l : panel.sheet->layers) {
            const bool bars = l.kind == panel::LayerKind::bars;
            if (l.thickness > (bars ? most_bars : std::max(width, least_size))) {
                list.push_back({Warning::Kind::value,
                                name + (bars ? " has bars of " : " is ") + digits(l.thickness) +
                                    (bars ? " m^2/m" : " m thick, and " + digits(width, 3) + " m wide"),
                                bars ? "is it in mm^2/m? areas are in m^2/m: 393 mm^2/m are 393e-6"
                                     : "is it in mm? thicknesses are in m",
                                line});
                return;
            }
            if (l.E < least_modulus) {
                list.push_back({Warning::Kind::value, name + " has E = " + digits(l.E) + " Pa",
                                "is it in MPa or GPa? stresses are in Pa", line});
                return;
            }
        }
    }
}

/// Two supports or more that lie at the lowest z, with a member that rises along z from each, and gravity across z.
void gravity_across(const Model& model, std::vector<Warning>& list) {
    const std::optional<Vec3> g = declared_gravity(model);
    if (!g || g->isZero(0) || std::abs(g->z()) > 0.1 * g->norm()) return;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const NodeData& n : model.nodes()) low = std::min(low, n.position.z()), high = std::max(high, n.position.z());
    const double close = 1e-3 * (high - low);
    std::vector<char> rises(model.nodes().size(), 0);
    for (const MemberData& m : model.members())
        for (int end : {0, 1}) {
            const Vec3 along = model.nodes()[m.node[1 - end]].position - model.nodes()[m.node[end]].position;
            if (along.z() > 0.99 * along.norm()) rises[m.node[end]] = 1;
        }
    int supports = 0;
    for (std::size_t n = 0; n < model.nodes().size(); ++n) {
        if ((model.nodes()[n].fixed & 7) == 0) continue;
        if (!rises[n] || model.nodes()[n].position.z() > low + close) return;
        ++supports;
    }
    if (supports < 2) return;
    Eigen::Index axis = 0;
    g->cwiseAbs().maxCoeff(&axis);
    list.push_back({Warning::Kind::value,
                    "gravity acts along " + axis_name(int(axis)) + ", and the structure stands along z: all " +
                        std::to_string(supports) + " supports are at its lowest z, and a member rises from each",
                    "z is up: model:gravity { 0, 0, -9.80665 }", model.asked_at(gravity_effect)});
}

}  // namespace

std::vector<Warning> implausible_values(const Structure& structure) {
    const Model& model = structure.model();
    std::vector<Warning> list;
    settlements(model, list);
    fracture_limits(model, list);
    speeds(model, list);
    spins(model, list);
    motions(model, list);
    panels(model, list);
    gravity_across(model, list);
    return list;
}

}  // namespace hinge
