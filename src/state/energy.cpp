#include "state/energy.h"

#include "state/hinges.h"

namespace hinge {

Ledger::Ledger(const Structure& structure, const State& start)
    : structure_(structure), accumulated_at_start_(start.accumulated) {
    potential_at_start_ = potential(start);
    Energy e;
    add_elements(start, e);
    initial_ = e.kinetic + e.elastic;
}

double Ledger::potential(const State& state) const {
    if (!structure_.model().gravity()) return 0;
    const Vec3 g = *structure_.model().gravity();
    Vec3 moment = Vec3::Zero();  // of mass about the origin
    for (std::size_t i = 0; i < structure_.elements().size(); ++i) {
        if (state.broken[i]) continue;
        const Element& e = structure_.elements()[i];
        const beam::Inertia m = structure_.inertia(int(i));
        for (int end : {0, 1})
            moment += m.weight(end) * (structure_.position()[e.node[end]] + state.displacement[e.node[end]]);
    }
    for (std::size_t i = 0; i < state.offset_mass.size(); ++i)
        if (state.offset_mass[i].mass > 0)
            moment += state.offset_mass[i].mass * (structure_.position()[i] + state.displacement[i]) +
                      state.rotation[i] * state.offset_mass[i].moment;
    return -moment.dot(g);
}

/// Kinetic and strain energy, in one pass.
void Ledger::add_elements(const State& state, Energy& energy) const {
    for (std::size_t i = 0; i < structure_.elements().size(); ++i) {
        if (state.broken[i]) continue;
        const beam::Placement<double> placement = place_element(structure_, int(i), state);
        const beam::Stiffness k = stiffness_now(structure_, state, int(i));
        const Vec6 d = element_deformation(structure_, int(i), state, placement) - state.plastic[i];
        energy.elastic += 0.5 * d.dot(k.times(d));
        energy.kinetic += kinetic_energy(structure_, state, int(i), axes_of(placement));
    }
    energy.kinetic += kinetic_energy_of_offset_masses(state);
}

Energy Ledger::balance(const State& state) const {
    Energy e;
    const Accumulated &now = state.accumulated, &then = accumulated_at_start_;
    e.initial = initial_;
    add_elements(state, e);
    e.gravity = potential(state) - potential_at_start_;
    e.plastic = now.plastic - then.plastic;
    e.fracture_elastic = now.fracture_elastic - then.fracture_elastic;
    e.fracture_kinetic = now.fracture_kinetic - then.fracture_kinetic;
    e.fracture = e.fracture_elastic + e.fracture_kinetic;
    e.contact_released = now.contact_released - then.contact_released;
    if (state.contact && !state.contact->idle()) {
        std::vector<Vec3> x(structure_.position());
        for (std::size_t i = 0; i < x.size(); ++i) x[i] += state.displacement[i];
        contact::Contact ties = *state.contact;
        std::vector<Vec6> unused(x.size(), Vec6::Zero());
        ties.add_internal_forces(x, state.rotation, unused);
        e.contact_stored = ties.stored_energy();
    }
    e.contact = e.contact_stored + e.contact_released;
    e.numerical = now.numerical - then.numerical;
    e.work = now.work - then.work;
    e.remainder =
        e.initial + e.work - (e.kinetic + e.gravity + e.elastic + e.plastic + e.fracture + e.contact + e.numerical);
    return e;
}

}  // namespace hinge
