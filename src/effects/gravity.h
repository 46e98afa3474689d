// Gravity, as a script declares it.
#pragma once

#include "model/model.h"

namespace hinge {

inline constexpr const char* gravity_effect = "gravity";

/// The acceleration of free fall. A model has one at most.
struct DeclaredGravity {
    Vec3 acceleration = Vec3::Zero();  ///< m/s^2
    int load_case = -1;
    Vec3 held = Vec3::Zero();  ///< statics: the part that acts in full from the start (Model::choose), m/s^2

    /// Scales it for a run (Declaration::choose), or removes it where its load case does not act.
    static int choose(std::vector<DeclaredGravity>& list, const std::vector<DeclaredGravity>* before,
                      const ChosenLoads& chosen);
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.acceleration);
    }
};

/// Declares gravity, in the place of any that was declared before.
void set_gravity(Model& model, const Vec3& acceleration, int load_case = -1);
/// Null where a model has none.
inline const DeclaredGravity* gravity_of(const Model& model) {
    const auto& list = model.declared<DeclaredGravity>(gravity_effect);
    return list.empty() ? nullptr : &list.back();
}

}  // namespace hinge
