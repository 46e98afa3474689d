// The material and the cross-section of a member: properties, shape and strength.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "section/stiffness.h"

namespace hinge {

namespace beam {
class MaterialLaw;
class SectionOutline;
struct YieldSurface;
}  // namespace beam

/// A material; SI units. `yield_stress` infinite: never yields.
struct Material {
    double E = 0;                                                   ///< Pa
    double G = 0;                                                   ///< Pa
    double density = 0;                                             ///< kg/m^3
    double yield_stress = std::numeric_limits<double>::infinity();  ///< Pa
    std::string asked_at = {};                                      ///< the script's line, "" where none
    std::vector<std::shared_ptr<const beam::MaterialLaw>> laws =
        {};  ///< hardening, effect of the strain rate (src/section/laws)
};

/// Interaction of N, Mx and My where a section yields (src/section/laws): eq 14, or that of its outline, without or
/// with what shear forces take off. by_model: as the model's option says.
enum class Interaction : std::uint8_t { by_model, paper, exact, exact_with_shear };
inline bool is_exact(Interaction i) { return i == Interaction::exact || i == Interaction::exact_with_shear; }
Interaction interaction_of(const std::string& word);  ///< "paper", "exact", "exact with shear"
const char* word_of(Interaction interaction);         ///< the same, not of by_model

/// A cross-section. x and y are its local axes, y the member's `up`; Ix bends about x (deflection along y).
struct Section {
    std::string kind = "general";               ///< a name
    std::string shape = "general";              ///< "h", "box", "pipe", "solid", "round", or something else
    double area = 0, Ix = 0, Iy = 0, J = 0;     ///< m^2, m^4
    double shear_area_x = 0, shear_area_y = 0;  ///< m^2
    double mass_Ix = 0, mass_Iy = 0;            ///< m^4, of the rotary inertia; 0: Ix and Iy
    double plastic_area = 0, Zx = 0, Zy = 0,
           Zz = 0;  ///< fully plastic resultant / stress: m^2, m^3 (Zz per shear yield stress)
    struct Strength {
        std::optional<double> N0, Mx0, My0, Mz0;  ///< N and N m
    };
    Strength given = {};          ///< fully plastic resultants that do not follow from the material and these
    double width = 0, depth = 0;  ///< m, along x and y: contact and pictures
    double web = 0, flange = 0;   ///< m, thickness of an H's: pictures
    std::shared_ptr<const beam::SectionOutline> outline = {};  ///< null: only the properties are known
    /// A wall that carries shear forces, from x0 to x1 and from y0 to y1, m from the centroid.
    struct Wall {
        double x0, x1, y0, y1;
    };
    std::vector<Wall> walls[2] = {};  ///< along x, along y, where they are known; else they follow from `shape`
    Interaction interaction = Interaction::by_model;
    std::string asked_at = {};  ///< the script's line, "" where none
};

/// Checks that the properties agree with the outline, and gives a section of concrete the strengths of its domain: the
/// larger of both signs; moments beside no axial force. Throws InputError, whose message begins with `what`.
void complete_section(Section& section, const std::string& what = "section");

/// Yield surface of a section of this material, by the fully plastic resultants: as given, else modulus times stress.
beam::YieldSurface yield_surface(const Section& section, const Material& material);

/// Elastic stiffness and mass of a section for a metre of its length.
beam::Rigidity rigidity_of(const Section& section, const Material& material);

/// True if the exact interaction of this section can be computed: its outline and three strengths are known.
bool has_exact_law(const Section& section, const beam::YieldSurface& strength);

}  // namespace hinge
