// What heat does to an element: it lengthens and bends without force, and loses stiffness and strength. Prestress is an
// elongation without force, too.
//
// The forces of an element, and of a pair whose bending depends on N, are linear in E. So all of them are
//
//   p = stiffness . p_cold(d - heat - plastic)
//
// where heat is the deformation that the element would take without force. The yield surface shrinks by `strength`
// (section/softened_law.h).
#pragma once

#include <vector>

#include "beam/timoshenko.h"
#include "core/archive.h"

namespace hinge {

struct ElementHeat {
    double stiffness = 1;       ///< E over that of the declared material
    double strength = 1;        ///< the same of the yield stress
    double bend[2] = {0, 0};    ///< rotation of node 2 against node 1 that heat makes about x and about y, rad
    double elongation = 0;      ///< m, with that of `strain`
    double strain = 0;          ///< of prestress: without force the member is longer by that part
    double temperature = 20;    ///< degrees Celsius, of the middle of the section
    double across[2] = {0, 0};  ///< K, of the side at +y less that at -y; of that at +x less that at -x

    /// Deformation without force, in d of timoshenko.h.
    Vec6 deformation() const {
        return (Vec6() << -0.5 * bend[0], 0.5 * bend[0], -0.5 * bend[1], 0.5 * bend[1], elongation, 0).finished();
    }
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.stiffness, s.strength, s.bend, s.elongation, s.strain, s.temperature, s.across);
    }
};

/// Of all elements; empty where nothing is heated.
using ElementHeats = std::vector<ElementHeat>;

inline constexpr ElementHeat no_heat;

inline const ElementHeat& heat_of(const ElementHeats& all, int element) {
    return all.empty() ? no_heat : all[std::size_t(element)];
}

}  // namespace hinge
