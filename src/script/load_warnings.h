// Likely mistakes in what acts: loads far too large, members that may buckle under them, histories that change nothing.
#pragma once

#include <vector>

#include "script/linear_solution.h"
#include "script/objects.h"

namespace hinge::script {

/// Loads that would strain a section as nothing does that stands, or bend it to many times its plastic moment.
std::vector<Warning> huge_loads(const RunRecord& record, const LinearSolution& solution);

/// Members whose compression is beyond half of Euler's load, those that are alike in one, the worst first.
std::vector<Warning> near_euler(const RunRecord& record, const LinearSolution& solution);

/// Of a dynamic run: histories given as points that are over before it begins (of loads and motions that `before`, the
/// model of the run that it goes on from, did not have; null where there is none), that change little in its time, or
/// that act for less than two steps.
std::vector<Warning> idle_histories(const Model& model, const Model* before, double begin, double duration, double dt);

/// Of a dynamic run: loads that weigh many times what the model's mass does. They have no inertia of their own.
std::vector<Warning> massless_loads(const Structure& structure, const std::string& line);

/// Of a dynamic run: velocities of single nodes whose kinetic energy is mostly that of the elements beside them, so
/// that it depends on how short these are. `before` as in idle_histories.
std::vector<Warning> lone_velocities(const Structure& structure, const State& start, const Model* before,
                                     const std::string& line);

/// Of a dynamic run: bodies that no support holds, directly or through connectors, and that alpha of model:damping
/// damps.
std::vector<Warning> damped_free_bodies(const Structure& structure, const State& start);

/// Load cases that a run takes and that hold nothing.
std::vector<Warning> empty_cases(const ScriptModel& declared, const LoadChoice& choice, const std::string& line);

}  // namespace hinge::script
