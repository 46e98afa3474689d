// Natural modes of a run where its state is, and load factors at which a structure buckles.
#pragma once

#include <vector>

#include "run/run.h"

namespace hinge {

struct NaturalMode {
    double omega_squared;     ///< 1/s^2; negative where the state is unstable
    std::vector<Vec6> shape;  ///< of each node, of modal mass 1 kg: m and rad
    Vec3 participation;       ///< shape . M r for a unit displacement r of the whole along x, y, z, kg
};
struct NaturalModes {
    std::vector<NaturalMode> list;  ///< rising
    Vec3 mass;                      ///< r . M r of the whole, supports included, along x, y and z, kg
};

/// The lowest `count` modes of small vibrations about the state: with the forces that the elements carry, elastic where
/// they have yielded, without what has broken, with the stiffness, masses and constraints of effects. `yielded`: what
/// joints at their strength resist with. Bodies that nothing holds have modes of frequency 0. Fewer where there are
/// fewer degrees of freedom.
///
/// Loads that make the stiffness unsymmetric (moments, loads that turn with their member) count where they change a
/// square of a frequency by a thousandth. Throws InputError where a node that moves has no mass, where such a stiffness
/// has too many unknowns, and where it has modes that flutter: their squares are complex. Throws std::runtime_error
/// where no modes are found.
NaturalModes natural_modes(const Run& run, int count, Yielded yielded = Yielded::unloads);

/// Number of modes whose square of a frequency is negative, that of rigid bodies aside, by one factorisation. Throws
/// InputError where a node that moves has no mass, std::runtime_error where the stiffness is singular.
int unstable_modes(const Run& run);

struct BucklingMode {
    double factor;            ///< on the internal forces of the run
    std::vector<Vec6> shape;  ///< of each node; its largest displacement is 1 m
};

/// The lowest `count` factors up to `most` by which the internal forces of the run's state are to be multiplied for the
/// structure, in its declared place, to buckle: where its tangent stiffness with these forces becomes singular. With
/// p_delta = "member" by the exact stability functions, without a linearisation. What a pair of elements between
/// clamped ends cannot show (pair_compression.h) ends the list: `hidden` is that factor, infinite where there is none.
struct BucklingModes {
    std::vector<BucklingMode> list;
    double hidden;
};
BucklingModes buckling_modes(const Run& run, int count, double most, Yielded yielded = Yielded::unloads);

}  // namespace hinge
