// One linear static solution of what a model declares: loads and gravity in full, without contact and without yield.
#pragma once

#include <memory>
#include <vector>

#include "run/statics.h"

namespace hinge::script {

struct LinearSolution {
    std::unique_ptr<Statics> run;  ///< null where there is none
    std::vector<char> solved;      ///< of each node: whether it takes part; bodies that supports do not hold stay put
};
/// `held`: six bits a node that do not move, over and above the supports; empty for none.
LinearSolution solve_linearly(const Model& model, std::vector<std::uint8_t> held = {});

/// Euler's load of a pinned member about its weaker axis, pi^2 E I_min / L^2 between its nodes, N.
double euler_load(const beam::Rigidity& r, double length);

}  // namespace hinge::script
