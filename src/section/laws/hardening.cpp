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
#include "section/laws/laws.h"

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
        const Step s = step(strain);
        if (history) back += s.kept * Vec4(history[0], history[1], history[2], history[3]);
        modulus += s.mean * of_.kinematic * zone.per_modulus;
    }
    bool back_follows_strain() const override { return of_.saturation > 0; }
    double more_by_back(const PlasticZone& zone, const double* history, double strain, const Vec4& e) const override {
        if (!(of_.saturation > 0)) return 0;
        const Step s = step(strain);
        const double began = s.mean - s.kept, grew = s.mean_of_mean - 0.5 * s.mean;
        double work = 0;
        for (int c = 0; c < 4; ++c)
            work += ((history ? began * history[c] : 0) + grew * of_.kinematic * zone.per_modulus[c] * e[c]) * e[c];
        return work;
    }
    void commit(const PlasticZone& zone, const Vec4& e, double strain, double, double* history) const override {
        const Step s = step(strain);
        for (int c = 0; c < 4; ++c)
            history[c] = s.kept * history[c] + s.mean * of_.kinematic * zone.per_modulus[c] * e[c];
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
    /// Of the back stress, with t = a s of the step: exp(-t), (1 - exp(-t)) / t and (t - 1 + exp(-t)) / t^2.
    struct Step {
        double kept = 1, mean = 1, mean_of_mean = 0.5;
    };
    Step step(double strain) const {
        const double t = of_.saturation > 0 ? of_.kinematic / of_.saturation * strain : 0;
        if (!(t > 0)) return {};
        const double mean = -std::expm1(-t) / t;
        // the difference cancels where t is small: its series, exact to 1e-13 there
        const double of_mean = t > 3e-3 ? (1 - mean) / t : 0.5 - t * (1.0 / 6 - t * (1.0 / 24 - t / 120));
        return {std::exp(-t), mean, of_mean};
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
