// Linear static solution of a model as declared: loads and gravity in full, without contact and without yield.
#pragma once

#include <memory>
#include <vector>

#include "run/statics.h"

namespace hinge {

struct LinearSolution {
    std::unique_ptr<Statics> run;  ///< null where there is none
    std::vector<char> solved;      ///< of each node: true if solved; bodies that supports do not hold do not move
};
/// Solves a model. `held`: six bits a node, fixed in addition to the supports; empty for none.
LinearSolution solve_linearly(const Model& model, std::vector<std::uint8_t> held = {});

/// Euler's load of a pinned member about its weaker axis, pi^2 E I_min / L^2 between its nodes, N.
double euler_load(const beam::Rigidity& r, double length);

}  // namespace hinge
