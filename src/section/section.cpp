#include "section/section.h"

#include <algorithm>
#include <cmath>

#include "core/errors.h"
#include "core/text.h"
#include "section/section_outline.h"
#include "section/yield.h"

namespace hinge {

Interaction interaction_of(const std::string& word) {
    return word == "exact"              ? Interaction::exact
           : word == "exact with shear" ? Interaction::exact_with_shear
                                        : Interaction::paper;
}

const char* word_of(Interaction interaction) {
    return interaction == Interaction::exact              ? "exact"
           : interaction == Interaction::exact_with_shear ? "exact with shear"
                                                          : "paper";
}

void complete_section(Section& s, const std::string& what) {
    const auto text = [](double value) { return number_text(value, 10); };
    if (s.outline) {
        const double area = s.outline->outline().area();
        if (!(std::abs(area - s.area) <= 0.02 * area))
            throw FieldError(
                what, "area",
                text(s.area) + " m^2; the outline has " + text(area) + " m^2, and the two may differ by 2 % of it");
    }
    if (s.outline && s.outline->concrete()) {
        const auto [least, most] = s.outline->axial_range();
        s.given = {std::max(-least, most), s.outline->largest_moment(0), s.outline->largest_moment(1), s.given.Mz0};
    }
    if (is_exact(s.interaction) && !s.outline)
        throw FieldError(what, "interaction",
                         std::string("'") + word_of(s.interaction) +
                             "'; needs the section's shape: give 'outline', or take hinge.section.h, box, pipe, solid "
                             "or round");
}

beam::YieldSurface yield_surface(const Section& s, const Material& m) {
    const auto inverse_square = [&](const std::optional<double>& given, double modulus, double stress) {
        const double limit = given ? *given : modulus > 0 ? modulus * stress : std::numeric_limits<double>::infinity();
        return std::isfinite(limit) ? 1 / (limit * limit) : 0.0;
    };
    const double tau = m.yield_stress / std::sqrt(3.0);
    return {inverse_square(s.given.Mx0, s.Zx, m.yield_stress), inverse_square(s.given.My0, s.Zy, m.yield_stress),
            inverse_square(s.given.N0, s.plastic_area, m.yield_stress), inverse_square(s.given.Mz0, s.Zz, tau)};
}

beam::Rigidity rigidity_of(const Section& section, const Material& material) {
    return {material.E * section.Ix,
            material.E * section.Iy,
            material.E * section.area,
            material.G * section.J,
            material.G * section.shear_area_x,
            material.G * section.shear_area_y,
            material.density * section.area,
            material.density * (section.mass_Ix > 0 ? section.mass_Ix : section.Ix),
            material.density * (section.mass_Iy > 0 ? section.mass_Iy : section.Iy)};
}

bool has_exact_law(const Section& section, const beam::YieldSurface& w) {
    return section.outline && w.x != 0 && w.y != 0 && w.n != 0;
}

}  // namespace hinge
