// Hardening of a material: stress grows beyond yield with the plastic strain.
//
// Kinematic: the yield surface moves. Where all fibres of a section yield, the resultants of their back stress are
// linear in the section's plastic deformation, so that this is exact: H A / l in tension, H I / l in bending, H J / 3 l
// in torsion, over the length l that yields. Of Armstrong and Frederick (1966; International Journal of Plasticity 23,
// 2007): the back stress x follows dx = H de - (H / saturation) x |de|, here with the mean plastic strain of the
// section.
//
// Isotropic: the yield surface grows, by the mean plastic strain of the section. In tension that is exact. In bending
// fibres strain unequally, and the moment grows a little less than their stresses say: 7 % less for an HEB 300 about
// its strong axis, 25 % for a rectangle.
#include <cmath>

#include "core/errors.h"
#include "core/text.h"
#include "laws/laws.h"

namespace hinge::beam {
namespace {

class HardeningLaw : public MaterialLaw {
public:
    HardeningLaw(const Hardening& h, double yield_stress) : of_(h), yield_stress_(yield_stress) {}

    const char* name() const override { return "hardening"; }
    std::string words() const override {
        std::string text;
        if (of_.kinematic > 0) text += "kinematic " + number_text(of_.kinematic / 1e6) + " MPa";
        if (of_.saturation > 0) text += " up to " + number_text(of_.saturation / 1e6) + " MPa";
        if (of_.isotropic > 0)
            text += (text.empty() ? "" : ", ") + ("isotropic " + number_text(of_.isotropic / 1e6)) + " MPa";
        return "hardening (" + text + ")";
    }
    void save(Writer& to) const override { to(of_.kinematic, of_.saturation, of_.isotropic, yield_stress_); }

    /// Four back resultants, normalised, and the mean plastic strain so far.
    int history_size() const override { return 5; }
    bool moves_surface() const override { return of_.kinematic > 0; }

    Factor factor(const double* history, double strain, const Moment&) const override {
        const double slope = of_.isotropic / yield_stress_;
        return {1 + slope * ((history ? history[4] : 0) + strain), slope};
    }
    void add_back(const PlasticZone& zone, const double* history, double strain, const Vec4&, Vec4& back,
                  Vec4& modulus) const override {
        const double kept = kept_after(strain);
        if (history) back += kept * Vec4(history[0], history[1], history[2], history[3]);
        modulus += kept * of_.kinematic * zone.per_modulus;
    }
    bool back_follows_strain() const override { return of_.saturation > 0; }
    void commit(const PlasticZone& zone, const Vec4& e, double strain, double, double* history) const override {
        const double kept = kept_after(strain);
        for (int c = 0; c < 4; ++c) history[c] = kept * (history[c] + of_.kinematic * zone.per_modulus[c] * e[c]);
        history[4] += strain;
    }
    double stored(const PlasticZone& zone, const double* history) const override {
        double sum = 0;
        for (int c = 0; c < 4; ++c)
            if (zone.per_modulus[c] > 0 && of_.kinematic > 0)
                sum += 0.5 * history[c] * history[c] / (of_.kinematic * zone.per_modulus[c]);
        return sum;
    }

private:
    /// Part of the back stress that is left after this growth of the mean plastic strain.
    double kept_after(double strain) const {
        return of_.saturation > 0 ? 1 / (1 + of_.kinematic / of_.saturation * strain) : 1;
    }

    Hardening of_;
    double yield_stress_;
};

}  // namespace

std::shared_ptr<const MaterialLaw> hardening_law(const Hardening& h, double yield_stress) {
    for (const double x : {h.kinematic, h.saturation, h.isotropic})
        if (!(x >= 0 && std::isfinite(x))) throw InputError("hardening: its stresses must be 0 Pa or more, and finite");
    if (!(std::isfinite(yield_stress) && yield_stress > 0))
        throw InputError("hardening needs a material with a finite yield_stress");
    return std::make_shared<HardeningLaw>(h, yield_stress);
}

}  // namespace hinge::beam
