// The energy ledger (eq 20 and what it leaves out): where the energy is, where it went, and what is missing.
#pragma once

#include "state/breaking.h"

namespace hinge {

/// All in J. remainder = initial + work - (kinetic + gravity + elastic + plastic + fracture + contact + numerical): the
/// numerical error.
struct Energy {
    double initial = 0;  ///< kinetic + elastic at the start of the run
    double kinetic = 0;
    double gravity = 0;  ///< potential, zero at the start of the run
    double elastic = 0;
    double plastic = 0;   ///< dissipated in hinges since the start of the run
    double fracture = 0;  ///< released by fracture: strain energy, and kinetic energy of stubs
    double contact = 0;   ///< stored in ties and touches now; released with ties, heat of friction
    double contact_stored = 0, contact_released = 0, fracture_elastic = 0, fracture_kinetic = 0;
    double numerical = 0;  ///< taken out by a dissipative integrator
    double work = 0;       ///< done by loads (not gravity)
    double remainder = 0;
};

class Ledger {
public:
    /// Takes `start` as the zero of everything that is counted from the start of the run.
    Ledger(const Structure& structure, const State& start);
    Energy balance(const State& state) const;
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.potential_at_start_, s.accumulated_at_start_, s.initial_);
    }

private:
    double potential(const State& state) const;
    void add_elements(const State& state, Energy& energy) const;
    const Structure& structure_;
    double potential_at_start_ = 0;
    Accumulated accumulated_at_start_;
    double initial_ = 0;
};

}  // namespace hinge
