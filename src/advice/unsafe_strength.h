// When a section counts as found too strong.
#pragma once

#include <string>
#include <vector>

#include "effects/workspace.h"

namespace hinge {

/// By how much a moment may exceed what the section carries before it is told: up to that eq 14 is within the scatter
/// of yield stresses. Near N0, where both vanish, by how many parts of M0.
inline constexpr double unsafe_excess = 0.10, unsafe_moment = 0.05;
/// Parts of M0 that are no difference: of alike members the first is named on every processor.
inline constexpr double alike_moment = 1e-9;

/// Whether that is so of a moment m beside which the exact one is `exact`, both in parts of M0.
inline bool is_unsafe(double m, double exact) { return m > (1 + unsafe_excess) * exact && m > exact + unsafe_moment; }

/// "73 %"
std::string excess_text(double excess);

/// "at load factor 0.93"; in dynamics "at t = 0.25 s". `at`: of Workspace::reached.
std::string when_text(const Workspace& w, double at);

/// The members that were found too strong.
class UnsafeMembers {
public:
    void add(const Model& model, int member);
    long others() const;  ///< than one of them
    bool fits(const Model& model) const { return is_unsafe_.empty() || is_unsafe_.size() == model.members().size(); }
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.is_unsafe_);
    }

private:
    std::vector<char> is_unsafe_;  ///< empty while there is none
};

}  // namespace hinge
