// Rigid-body modes of K x = v M x, told from slow vibrations by their strain energy beside the rounding of K.
#pragma once

#include <functional>
#include <string>

#include "algebra/eigenpairs.h"
#include "state/state.h"

namespace hinge {

/// Sets the values of rigid-body modes to 0: modes whose strain energy x . K x is no more than the rounding of the
/// terms that it is a sum of, |x| . |K| |x|. These terms are the energies of unit strains of the elements that the mode
/// moves: a part far away that is stiffer does not count. Values of `found` above 1e-11 are left as they are (K and M
/// have traces near 1). `a`: the shift with which they were found, K + a M is positive definite.
///
/// `bends`: text such as "member 3" of what a motion strains most, empty for a rigid motion. A mode that bends
/// something and whose energy is below the rounding all the same has a frequency that nobody knows: throws
/// std::runtime_error.
void tell_rigid_modes(const SparseMatrix& K, const SparseMatrix& M, double a, Eigenpairs& found,
                      const std::function<std::string(const Eigen::VectorXd&)>& bends);

/// The member that a motion of the nodes strains most, "" where it strains none: a rigid motion, to a hundred
/// thousandth of itself.
std::string strained_member(const Structure& s, const State& state, const std::vector<Vec6>& motion);

}  // namespace hinge
