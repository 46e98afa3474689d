// Fracture rules of members (eq 16): strain limits, or a script's own rule and the section data passed to it.
#pragma once

#include <concepts>
#include <functional>
#include <string>
#include <vector>

#include "section/fracture_limits.h"

namespace hinge {

/// Data of a section of an element at the end of a step, passed to a script's own fracture rule. Strains are the
/// element's (section/fracture_limits.h); the rotation of the hinge is the section's (HingeLimits::rotation).
struct SectionView {
    double time, dt;           ///< s, of the step's end; of the step
    double step;               ///< from 1
    int member, element, end;  ///< numbers from 0; end 1 or 2 of the element
    int node;                  ///< the joint that the section is at, from 0; -1 inside the member
    struct Strains {
        double curvature_x, curvature_y;  ///< 1/m
        double axial;                     ///< -
        double twist;                     ///< 1/m
    };
    Strains strain;          ///< elastic and plastic
    Strains plastic_strain;  ///< its plastic part
    Strains strain_rate;     ///< per second, over the step
    struct Forces {
        double Mx, My, N, Mz;  ///< N m, N
    };
    Forces force;
    double f_y;                                 ///< eq 14
    double plastic_work;                        ///< J, of the element so far
    double shear_x, shear_y;                    ///< -, elastic: Q / (G A), mean over the element
    double hinge_rotation_x, hinge_rotation_y;  ///< rad, plastic, of the section's hinge
    bool plastic;                               ///< fully plastic in this step
    double* kept = nullptr;  ///< the rule's own numbers of this section (FractureRule::keep), 0 at the start
};

/// Decides which sections break. It can be made from a function of one section that returns true if it breaks.
struct FractureHook {
    /// Goes through the sections from number `at` until one breaks, and leaves `at` there: past the last one if all
    /// hold. A step's sections come in one list, since it costs less to call a script once.
    std::function<void(const std::vector<SectionView>& sections, std::size_t& at)> ask;

    FractureHook() = default;
    template <std::predicate<const SectionView&> Breaks>
    FractureHook(Breaks breaks) {
        ask = [breaks](const std::vector<SectionView>& sections, std::size_t& at) mutable {
            while (at < sections.size() && !breaks(sections[at])) ++at;
        };
    }
    explicit operator bool() const { return bool(ask); }
};

/// Quantities of a section that a rule can read, in the order of section_field_names.
enum class SectionField : int {
    curvature_x,
    curvature_y,
    axial_strain,
    twist,
    plastic_curvature_x,
    plastic_curvature_y,
    plastic_axial_strain,
    plastic_twist,
    curvature_rate_x,
    curvature_rate_y,
    axial_strain_rate,
    twist_rate,
    Mx,
    My,
    N,
    Mz,
    f_y,
    plastic_work,
    shear_x,
    shear_y,
    hinge_rotation_x,
    hinge_rotation_y,
    member,
    element,
    end,
    node,
    plastic,
    time,
    dt,
    step
};
extern const std::vector<std::string> section_field_names;
/// Value of a field as a script counts: member, element and node from 1 (0: no node), plastic 1 or 0.
double value_of(const SectionView& view, SectionField field);

/// Fracture rule of a group of members: eq 16 or a variant of it. The paper's 0.0004 has no unit: 0.4 1/m if it is
/// 1/mm.
struct FractureRule : beam::FractureLimits {
    enum class StrainMeasure {
        element,
        section
    } strain_measure =
        StrainMeasure::element;  ///< element: the limits are compared with the strains of the whole element;
                                 ///< section: with those at each end, from its own hinge (section_strains)
    bool plastic_only = false;   ///< limits count only where the section is fully plastic in the step
    FractureHook hook;           ///< called where no limit is reached
    enum class Where {
        plastic,
        yielded,
        all
    } where = Where::plastic;  ///< sections for which hook is called. plastic: fully plastic in the step, or once
                               ///< before and the element strained as never before; yielded: ever fully plastic; all
    std::vector<std::string> keep;  ///< names of the numbers it keeps of each section
    int group = -1;                 ///< -1: all members
    std::string asked_at;           ///< line of the script
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.curvature_x, s.curvature_y, s.axial_strain, s.shear_strain, s.tension_only, s.strain_measure,
          s.plastic_only, bool(s.hook), s.where, s.keep, s.group, s.hinge_rotation_x, s.hinge_rotation_y, s.elongation);
    }
};

/// What rules of the script keep from step to step.
struct FractureRuleData {
    /// Where one is asked of plastic sections: the most of |curvature_x|, |curvature_y|, |axial strain| of each
    /// element. It says what was asked, not how the structure is.
    std::vector<double> strained;
    std::vector<double> kept;  ///< FractureRule::keep, of both ends of each element
    static constexpr bool in_state_hash = false;
    const std::vector<double>* in_hash_alone() const { return &kept; }
    void resize(std::size_t of_strained, std::size_t of_kept) {
        if (strained.size() != of_strained) strained.assign(of_strained, 0);
        if (kept.size() != of_kept) kept.assign(of_kept, 0);
    }
    bool is_alike(const FractureRuleData& other) const {
        return strained.size() == other.strained.size() && kept.size() == other.kept.size();
    }

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.strained, s.kept);
    }
};

}  // namespace hinge
