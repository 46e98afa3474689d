// Connectors: their declaration, and their state in a run.
#pragma once

#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/types.h"
#include "effects/connector_yield.h"

namespace hinge {

inline constexpr const char* connectors_effect = "connectors";

/// Variables of a law of the script, kept from step to step, by name.
using LawState = std::map<std::string, double>;

/// Force (N, N m) at a deformation (m, rad), its rate, and dt (s) since the state was kept. It may change the state.
using ConnectorLaw = std::function<double(double deformation, double rate, double dt, LawState& state)>;

/// Springs, dashpots, curves and laws between node a and node b, along and about three axes: x y z rx ry rz. The
/// deformation is how far b is from where it would be if a carried it on a rigid arm, in axes that rotate with a.
struct Connector {
    int a = -1, b = -1;             ///< a: -1 for the ground, where b is declared; its axes stay as they are
    Mat3 axes = Mat3::Identity();   ///< columns x y z
    Vec6 stiffness = Vec6::Zero();  ///< N/m, N m/rad
    Vec6 damping = Vec6::Zero();    ///< N s/m, N m s/rad
    Vec6 capacity = Vec6::Constant(std::numeric_limits<double>::infinity());  ///< N, N m
    std::vector<std::pair<double, double>> curve[6];                          ///< of deformation and force, rising
    ConnectorLaw law[6];
    ConnectorLimits yield;     ///< of the springs of `stiffness`
    ConnectorLimits ultimate;  ///< of their plastic deformation

    bool has_law() const {
        return std::any_of(std::begin(law), std::end(law), [](const ConnectorLaw& l) { return bool(l); });
    }
    bool is_linear() const {
        return std::none_of(std::begin(curve), std::end(curve), [](const auto& points) { return !points.empty(); }) &&
               !has_law() && !yield.any();
    }
    template <class Self, class A>
    static void fields(Self& s, A& archive) {
        archive(s.a, s.b, s.axes, s.stiffness, s.damping, s.capacity, s.curve, s.yield, s.ultimate);
        for (const auto& law : s.law) archive(bool(law));
    }
};

/// A connector where the last step that was kept ended.
struct ConnectorNow {
    bool broken = false;
    double broken_at = 0;             ///< s
    Vec6 deformation = Vec6::Zero();  ///< m, rad
    Vec6 plastic = Vec6::Zero();      ///< the part of it that yielding springs keep
    Vec6 force = Vec6::Zero();        ///< of all together: N, N m; what broke it, where it is broken
    Vec6 of_dashpots = Vec6::Zero();  ///< the part of it that dissipates
    Vec6 of_laws = Vec6::Zero();      ///< and that of the script's laws
    Vec6 viscous = Vec6::Zero();      ///< of damping by stiffness, not in `force`
    Vec6 largest = Vec6::Zero();      ///< sizes of `force`, the most so far; read by results alone
    LawState law[6];

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.broken, s.broken_at, s.deformation, s.plastic, s.force, s.of_dashpots, s.of_laws, s.viscous, s.largest,
          s.law);
    }
};

struct ConnectorsNow {
    static constexpr bool in_state_hash = false;  ///< the hash of a state is that of its arrays
    std::vector<ConnectorNow> list;
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.list);
    }
};

/// " broke: ...", in a direction: -1 where its node is gone, 6 for x and y together.
inline std::string how_it_broke(const Connector& is, const ConnectorNow& c, int direction) {
    static const char* name[] = {"x", "y", "z", "rx", "ry", "rz", "x and y"};
    if (direction < 0) return " broke: its node has lost its last member";
    const bool turns = direction >= 3 && direction < 6;
    char how[80];
    if (direction < 6 && std::abs(c.force[direction]) >= is.capacity[direction])
        std::snprintf(how, sizeof how, " broke: %.4g %s in %s", std::abs(c.force[direction]), turns ? "N m" : "N",
                      name[direction]);
    else
        std::snprintf(how, sizeof how, " broke: plastic deformation of %.4g %s in %s",
                      direction == 6 ? c.plastic.head<2>().norm() : std::abs(c.plastic[direction]), turns ? "rad" : "m",
                      name[direction]);
    return how;
}

}  // namespace hinge
