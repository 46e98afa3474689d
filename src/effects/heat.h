// Declarations of heat and prestress: temperatures of members, and properties of the material over temperature.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "model/history.h"
#include "model/model.h"

namespace hinge {

inline constexpr const char* heat_effect = "heat";

/// Properties of a material over temperature. Points: degrees Celsius, value; straight between two of them.
struct HeatProperties {
    using Points = std::vector<std::pair<double, double>>;
    Points stiffness;   ///< E over that of the declared material
    Points strength;    ///< yield stress over the declared one
    Points elongation;  ///< strain without stress
    /// The value at a temperature; beyond the points that of the nearest one.
    static double at(double temperature, const Points& points);
    /// Range of temperatures that all three have, degrees Celsius.
    double least() const {
        return std::max({stiffness.front().first, strength.front().first, elongation.front().first});
    }
    double most() const { return std::min({stiffness.back().first, strength.back().first, elongation.back().first}); }
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.stiffness, s.strength, s.elongation);
    }
};

/// Members that are heated. Of several declarations for one member the last one counts.
struct Heating {
    int member = -1, group = -1;  ///< one of the two; -1 and -1: all members
    double temperature = 20;      ///< degrees Celsius; statics goes there with the load factor
    History history = {};         ///< degrees Celsius over time, in its place; dynamics
    double across[2] = {0, 0};    ///< K (ElementHeat::across)
    History across_history[2];    ///< K over time, in its place; dynamics
    std::shared_ptr<const HeatProperties> properties;
    int load_case = -1;
    std::string asked_at = {};

    /// Whether it changes with time.
    bool varies() const { return history || across_history[0] || across_history[1]; }
    /// Statics: a part of the heat, as a load case has it.
    void times(double factor);
    /// Statics heats to what the load cases make of it, and a temperature over time stays as it is.
    static int choose(std::vector<Heating>& list, const std::vector<Heating>* before, const ChosenLoads& chosen);
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.member, s.group, s.temperature, s.history, s.across, s.across_history[0], s.across_history[1],
          *s.properties, s.load_case);
    }
};

/// The declaration that counts for a member, as its place in the list; -1: none.
int heating_of(const Model& model, int member);

inline constexpr const char* prestress_effect = "prestress";

/// Members that were made too short or too long. Several declarations for one member add up.
struct Prestress {
    int member = -1, group = -1;
    double strain = 0;  ///< without force the member is longer by that part of its length; below 0: shorter
    double force = 0;   ///< N, that it would have between ends that do not move; in addition to `strain`
    int load_case = -1;

    void times(double factor) { strain *= factor, force *= factor; }
    static int choose(std::vector<Prestress>& list, const std::vector<Prestress>* before, const ChosenLoads& chosen);
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.member, s.group, s.strain, s.force, s.load_case);
    }
};

}  // namespace hinge
