// The law of a section: which forces it can carry, and how it flows when it carries all that it can.
//
// An element asks its section's law, and knows none by name. The laws are in src/section/laws, one file each.
#pragma once

#include <string>

#include "section/held_round.h"
#include "section/yield.h"

namespace hinge::beam {

inline constexpr double room_temperature = 20;  ///< degrees Celsius: of what is not heated

/// What the sections of an element have besides its forces.
struct SectionConditions {
    const FixedEnd* fixed_end = &no_fixed_end;
    /// History variables of the sections at the start of the step, one section after the other
    /// (SectionLaw::history_size of each). Null: the law has none.
    const double* history = nullptr;
    double dt = 0;                          ///< length of the step, s; 0: no time passes, as in statics
    double temperature = room_temperature;  ///< degrees Celsius
    const HeldRound* held = nullptr;        ///< of a law in rounds: the return is this round alone

    SectionConditions() = default;
    SectionConditions(const FixedEnd& loads, const double* start = nullptr, double step = 0)
        : fixed_end(&loads), history(start), dt(step) {}
    const double* history_of(int section, int size) const { return history ? history + section * size : nullptr; }
};
inline const SectionConditions no_conditions[2];

/// The elastic side of a pair whose return to the yield surface is looked for (pair_return.h).
class PairElastic {
public:
    /// Forces p of both elements where these parts of their deformation are plastic, and the pair's stiffness K there.
    virtual void at(const Vec6 (&plastic)[2], Vec6 (&p)[2], Mat12& K) const = 0;

protected:
    ~PairElastic() = default;
};

/// Law of the sections of an element, or of both elements of a pair. It is const: elements of the same section and
/// material share it.
class SectionLaw {
public:
    /// `screen`: a surface inside of the yield surface. Forces within it never flow; the assembly asks that first, for
    /// eight elements at once. See also moves_surface.
    explicit SectionLaw(const YieldSurface& screen) : screen_(screen) {}
    SectionLaw(const SectionLaw&) = delete;
    virtual ~SectionLaw() = default;

    virtual const char* name() const = 0;
    /// What the plan says of it, with what the material adds.
    virtual std::string words() const { return name(); }
    /// True if neither hardening nor rate changes its strength.
    virtual bool keeps_strength() const { return true; }
    const YieldSurface& screen() const { return screen_; }
    /// True if it calls functions of the script (MaterialLaw::calls_script).
    virtual bool calls_script() const { return false; }
    /// True of a law that is eq 14 whatever the section's shape: it may be unsafe beside an axial force.
    virtual bool ignores_shape() const { return false; }

    /// Number of history variables of one section: numbers that change as it flows. They are 0 at first,
    /// or as `start` sets them.
    virtual int history_size() const { return 0; }
    /// Sets them before the first step, other than to 0. `end_of_member`: the section is at an end of its member.
    virtual void start(bool end_of_member, double* history) const { (void)end_of_member, (void)history; }
    /// True if the yield surface of a section that has flowed may lie inside of the screen in part: it is then asked in
    /// each step.
    virtual bool moves_surface() const { return false; }
    /// True if shear forces weaken its sections. The parts of their strength that walls along x and along y have lost
    /// by them are history variables of a section, set at the end of a step.
    virtual bool takes_shear() const { return false; }
    virtual void set_shear(double along_x, double along_y, double* history) const {
        (void)along_x, (void)along_y, (void)history;
    }
    virtual double lost_by_shear(bool along_y, const double* history) const { return (void)along_y, (void)history, 0; }

    /// Adds the flow of a step to the history variables of section `section` of n.
    virtual void commit(const ElementFlow& flow, int section, double dt, double* history) const {
        (void)flow, (void)section, (void)dt, (void)history;
    }
    /// Energy that hardening has stored in a section, J: part of its plastic work. `history`: of that section.
    virtual double stored(const double* history) const { return (void)history, 0; }

    /// True if hinges may lose part of their stiffness in unloading.
    virtual bool wears_stiffness() const { return false; }
    /// How much softer in unloading than new the end of its member is (MaterialLaw::softness): after the step with
    /// `flow`, or with null at the start of it. `history`: of section `section`.
    virtual double softness(const double* history, const ElementFlow* flow, int section) const {
        return (void)history, (void)flow, (void)section, 0;
    }

    /// Yield function f_y of a section's Mx, My (N m), N (N) and Mz (N m): 1 on the surface. Its root is the
    /// utilisation: it grows as the forces do, where all of them grow alike. `history`: of the section, or null.
    virtual double yield_function(const Vec4& q, const double* history = nullptr,
                                  double temperature = room_temperature) const = 0;
    /// The same at section r (-1: node 1, 0: middle, +1: node 2), for element forces with the fixed-end parts in them.
    double yield_function(const Vec6& p, double r, const double* history = nullptr) const {
        return yield_function(resultants(p, r), history);
    }

    /// True only if no section flows under these forces; asked beyond the screen, and cheaper than the return. False
    /// says nothing.
    virtual bool surely_elastic(const Vec6& p, const double* sections, int n, const SectionConditions& at) const {
        return (void)p, (void)sections, (void)n, (void)at, false;
    }

    /// Return mapping of an element, implicit, with associated flow: the point within the yield surfaces of its
    /// sections nearest to `trial` in the energy norm.
    ///   trial     forces if the step were elastic
    ///   k         the element's elastic stiffness
    ///   sections  positions r that can yield, n of them
    /// The flow is evaluated for p plus the fixed-end forces; ReturnMapResult::p excludes them.
    virtual ReturnMapResult return_to_surface(const Vec6& trial, const Stiffness& k, const double* sections, int n,
                                              const SectionConditions& at) const = 0;

    /// The same for an element whose two ends can yield, as a round of the return of a pair (pair_return.h) needs it:
    /// `before` is the round before, from which the search may start.
    virtual ElementFlow return_alone(const Vec6& trial, const Stiffness& k, const SectionConditions& at,
                                     const ElementFlow& before) const = 0;

    /// True of a law whose return is looked for in rounds, each of which holds constant what follows the flow.
    virtual bool in_rounds() const { return false; }
    /// After a round of a pair, of one element of it: what the next round holds. True: it is the same, but for
    /// `tolerance`.
    virtual bool next_round(const ElementFlow& flow, const SectionConditions& at, double tolerance,
                            HeldRound& held) const {
        return (void)flow, (void)at, (void)tolerance, (void)held, true;
    }

    /// The flow of all four ends of a pair together, from `flow`, that of a round; where that is none, from what the
    /// law remembers of the step before. A law need not know it.
    ///   at         of both elements
    ///   tolerance  that of the pair's return
    /// False: it is not found so, and `flow` is as it was; rounds go on from there.
    virtual bool return_together(const PairElastic& pair, const SectionConditions* at, double tolerance,
                                 ElementFlow (&flow)[2]) const {
        return (void)pair, (void)at, (void)tolerance, (void)flow, false;
    }

    /// Work of fixed-end forces on the plastic flow, J; `part`: those of `at` or a part of them.
    virtual double work_of(const FixedEnd& part, const ElementFlow& flow, const double* sections, int n,
                           const SectionConditions& at) const = 0;

    /// Consistent tangent dp/dd of return_to_surface.
    virtual Mat6 tangent(const ElementFlow& flow, const Stiffness& k, const double* sections, int n,
                         const SectionConditions& at) const = 0;

    /// Consistent tangent of a pair, 12 x 12. `elastic`: its tangent without flow; `flow`: null for an element that
    /// does not flow; `at`: of both.
    virtual Mat12 pair_tangent(const Mat12& elastic, const ElementFlow* const (&flow)[2],
                               const SectionConditions* at) const = 0;

    /// Part of an element's plastic elongation that is slack (ElementFlow::slack), m. `history`: of its first section.
    virtual double slack(const double* history) const { return (void)history, 0; }
    /// False: the elements of such members do not form pairs whose bending depends on N (beam_column.h); the return of
    /// a pair and its tangent are never asked for.
    virtual bool forms_pairs() const { return true; }

private:
    YieldSurface screen_;
};

}  // namespace hinge::beam
