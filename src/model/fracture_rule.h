// When members break (eq 16): limits, or a rule of the script's own, and what such a rule is shown.
#pragma once

#include <concepts>
#include <functional>
#include <string>
#include <vector>

#include "beam/fracture.h"

namespace hinge {

/// A section of an element as a rule of the script's own sees it, at the end of the step. Strains are the element's
/// (beam/fracture.h); the rotation of the hinge is the section's own.
struct SectionView {
    double time, dt;           ///< s, of the step's end; of the step
    double step;               ///< from 1
    int member, element, end;  ///< numbers from 0; end 1 or 2 of the element
    int node;                  ///< the joint that the section is at, from 0; -1 inside the member
    double curvature_x, curvature_y, axial_strain, twist;  ///< 1/m, -, 1/m: elastic and plastic
    double plastic_curvature_x, plastic_curvature_y, plastic_axial_strain, plastic_twist;  ///< what of them stays
    double curvature_rate_x, curvature_rate_y, axial_strain_rate, twist_rate;  ///< 1/(m s), 1/s, over the step
    double Mx, My, N, Mz;                                                      ///< N m, N
    double f_y;                                                                ///< eq 14
    double plastic_work;                                                       ///< J, of the element so far
    double shear_x, shear_y;                    ///< -, elastic: Q / (G A), mean over the element
    double hinge_rotation_x, hinge_rotation_y;  ///< rad, of the section's own hinge
    bool plastic;                               ///< fully plastic in this step
    double* kept = nullptr;  ///< the rule's own numbers of this section (FractureRule::keep), 0 at the start
};

/// Says which sections break. A function of a section, true where it breaks, will do.
struct FractureHook {
    /// Goes through the sections from number `at` until one breaks, and leaves `at` there: past the last one if all
    /// hold. A step's sections come in one list, since it costs less to call a script once.
    std::function<void(const std::vector<SectionView>& sections, std::size_t& at)> ask;

    FractureHook() = default;
    template <std::predicate<const SectionView&> Breaks>
    FractureHook(Breaks breaks)
        : ask([breaks](const std::vector<SectionView>& sections, std::size_t& at) mutable {
              while (at < sections.size() && !breaks(sections[at])) ++at;
          }) {}
    explicit operator bool() const { return bool(ask); }
};

/// What can be read of a section, as numbers; in the order of section_field_names.
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
    broken,
    time,
    dt,
    step
};
extern const std::vector<std::string> section_field_names;
double value_of(
    const SectionView& view,
    SectionField field);  ///< member, element and node from 1 (0: no node), plastic 1 or 0, as a script counts

/// All elements of a rule's members at once, with the sections at both ends: always the same ones in the same order.
class ElementList {
public:
    virtual ~ElementList() = default;
    virtual int count() const = 0;
    virtual double time() const = 0;
    virtual double dt() const = 0;
    virtual long step() const = 0;
    /// `count` numbers, 0 where the element is broken; `end` 1 or 2, for what the two sections have different
    /// (at_ends).
    virtual void read(SectionField field, int end, double* out) const = 0;
};
bool at_ends(SectionField field);  ///< Mx, My, f_y, hinge rotations, node, plastic
/// Fills `breaks` with the places in the list of the elements that break: at the section that flows, else at the one
/// nearer to it.
using FractureBatch = std::function<void(const ElementList&, std::vector<int>& breaks)>;

/// Eq 16, and other readings of it. The paper's 0.0004 has no unit: 0.4 1/m if it is 1/mm.
struct FractureRule : beam::FractureLimits {
    enum class StrainMeasure {
        element,
        section
    } strain_measure =
        StrainMeasure::element;  ///< element: the limits are compared with the strains of the whole element;
                                 ///< section: with those at each end, from its own hinge (section_strains)
    bool plastic_only = false;   ///< limits count only where the section is fully plastic in the step
    FractureHook hook;           ///< asked where no limit is reached
    enum class Where {
        plastic,
        yielded,
        all
    } where = Where::plastic;  ///< sections it is asked of. plastic: fully plastic in the step, or once before and the
                               ///< element strained as never before; yielded: ever fully plastic; all
    FractureBatch batch;       ///< in the place of hook, once a step
    std::vector<std::string> keep;  ///< names of the numbers it keeps of each section
    int group = -1;                 ///< -1: all members
    std::string asked_at;           ///< line of the script
};

}  // namespace hinge
