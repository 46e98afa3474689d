// What a material adds to the yield surface of its sections: hardening, effect of the strain rate. One file each in
// src/section/laws; a section may have several.
#pragma once

#include <string>

#include "core/archive.h"
#include "core/types.h"

namespace hinge::beam {

/// Sizes of a section and of the part of its element that yields with it: half of the element, or all of it where the
/// middle alone can yield.
///
/// Resultants are normalised by the fully plastic ones, and plastic deformations e (rotations about x and y,
/// elongation, twist) times these: J. Of a section that dissipates s (J, at its initial strength), s / energy is the
/// mean plastic strain in that part of the element.
struct PlasticZone {
    double energy = 0;  ///< N0 times its length, J: plastic work at a mean plastic strain of 1
    /// Normalised back resultants per e and per plastic modulus H of the material, 1/(J Pa): all fibres yield, and
    /// their back stress is H times their plastic strain, or H/3 times in shear.
    Vec4 per_modulus = Vec4::Zero();
    /// Plastic deformation per e: 1 over the fully plastic resultants; 0 where that is infinite. FlowProblem sets it.
    Vec4 per_strength = Vec4::Zero();
};

class MaterialLaw {
public:
    virtual ~MaterialLaw() = default;
    virtual const char* name() const = 0;
    /// With its numbers, for the plan.
    virtual std::string words() const = 0;
    /// Writes all its numbers, so that equal laws write the same.
    virtual void save(Writer& to) const = 0;

    /// True if it calls functions of the script: one thread alone may ask it.
    virtual bool calls_script() const { return false; }
    /// Number of its history variables in a section.
    virtual int history_size() const { return 0; }
    /// Sets them before the first step. `end_of_member`: the section is at an end of its member.
    virtual void start(bool end_of_member, double* history) const { (void)end_of_member, (void)history; }
    /// SectionLaw::moves_surface.
    virtual bool moves_surface() const { return false; }

    struct Factor {
        double value = 1, slope = 0;
    };
    /// A step of length dt (s), and the temperature where it ends, degrees Celsius.
    struct Moment {
        double dt, temperature;
    };
    /// Factor on the strength of a section at the end of a step in which its mean plastic strain grows by `strain`, and
    /// its slope over `strain`.
    virtual Factor factor(const double* history, double strain, const Moment& at) const {
        return (void)history, (void)strain, (void)at, Factor{};
    }
    /// The mean of the factor while the mean plastic strain grows so far. Default: that of a factor that is linear in
    /// it. A section has one law at most whose factor is not.
    virtual double mean_factor(const double* history, double strain, const Moment& at) const {
        return 0.5 * (factor(history, 0, at).value + factor(history, strain, at).value);
    }
    /// True if the factor goes with the rate of the step, not with the strain that is reached. A section has one such
    /// law at most, and then all others have linear factors.
    virtual bool follows_rate() const { return false; }
    struct Integrals {
        double zeroth = 0, first = 0;
    };
    /// Of such a law: the integral of factor - 1, and that of the strain times it, over the strain from 0 to `strain`.
    virtual Integrals integrals(double strain, double dt) const { return (void)strain, (void)dt, Integrals{}; }
    /// Factor on the strength of a section that has not flowed.
    virtual double initial() const { return 1; }
    struct Turned {
        double factor = 1, slope = 0;  ///< at the end of the step; its change with the step's work, 1/J
    };
    /// Of a law whose factor follows the plastic rotation: after a step with plastic deformation e, which does `work`
    /// at the initial strength, J. It may fall. It is looked for in rounds, and is constant in each.
    virtual Turned turned(const PlasticZone& zone, const double* history, const Vec4& e, double work) const {
        return (void)zone, (void)history, (void)e, (void)work, Turned{};
    }
    /// The mean of that factor over the work of the step.
    virtual double mean_turned(const PlasticZone& zone, const double* history, const Vec4& e, double work) const {
        return (void)zone, (void)history, (void)e, (void)work, 1;
    }
    virtual bool follows_rotation() const { return false; }

    /// Adds the back resultants at the end of a step: back + modulus times e. `strain`: growth of the mean plastic
    /// strain, of those that ask for it (back_follows_strain).
    /// `e`: plastic deformation of the step, of those that ask for it (back_follows_flow).
    virtual void add_back(const PlasticZone& zone, const double* history, double strain, const Vec4& e, Vec4& back,
                          Vec4& modulus) const {
        (void)zone, (void)history, (void)strain, (void)e, (void)back, (void)modulus;
    }
    virtual bool back_follows_strain() const { return false; }
    /// The work of the back resultants on the way of a step, less that of their last values and of modulus times e half
    /// of the way, J: 0 where they are linear in e.
    virtual double more_by_back(const PlasticZone& zone, const double* history, double strain, const Vec4& e) const {
        return (void)zone, (void)history, (void)strain, (void)e, 0;
    }
    virtual bool back_follows_flow() const { return false; }
    /// Adds a step's plastic deformation e to the history variables.
    virtual void commit(const PlasticZone& zone, const Vec4& e, double strain, double dt, double* history) const {
        (void)zone, (void)e, (void)strain, (void)dt, (void)history;
    }
    /// True if hinges may lose part of their stiffness in unloading.
    virtual bool wears_stiffness() const { return false; }
    /// How much softer than new an end of its member is in unloading, after a step with plastic deformation e: 1 less
    /// than the ratio of both stiffnesses, 0 or more. It does not fall.
    virtual double softness(const PlasticZone& zone, const double* history, const Vec4& e) const {
        return (void)zone, (void)history, (void)e, 0;
    }
    /// Stored energy, J.
    virtual double stored(const PlasticZone& zone, const double* history) const { return (void)zone, (void)history, 0; }
};

}  // namespace hinge::beam
