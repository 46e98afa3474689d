// Likely mistakes in what acts: loads far too large, members that may buckle under them, histories that change nothing.
#pragma once

#include <vector>

#include "script/checks/linear_solution.h"
#include "script/lua/objects.h"

namespace hinge::script {

/// Loads that would strain a section as nothing does that stands, or bend it to many times its plastic moment.
std::vector<Warning> huge_loads(const RunRecord& record, const LinearSolution& solution);

/// Members whose compression is beyond half of Euler's load, those that are alike in one, the worst first.
std::vector<Warning> near_euler(const RunRecord& record, const LinearSolution& solution);

/// The member whose axial force makes eq 14 most unsafe (effects/axial_strength.h), with the others counted. Beside the
/// forces found, as they act before anything yields.
std::vector<Warning> unsafe_eq14(const RunRecord& record, const LinearSolution& solution);

/// Of a dynamic run: histories given as points that are over before it begins (of loads and motions that `before`, the
/// model of the run that it goes on from, did not have; null where there is none), that change little in its time, or
/// that act for less than two steps.
std::vector<Warning> idle_histories(const Model& model, const Model* before, double begin, double duration, double dt);

/// Of a dynamic run: loads that weigh many times what the model's mass does. They have no inertia of their own.
std::vector<Warning> massless_loads(const Structure& structure, const std::string& line);

/// Loads along gravity beside point masses of about the same weight: floors that may count twice.
std::vector<Warning> floors_twice(const Structure& structure);

/// Of a dynamic run that goes on from `before`: gravity that did not act there, and so acts at once.
std::vector<Warning> late_gravity(const Structure& structure, const RunRecord& before, const std::string& line);

/// Of a dynamic run that is the first with contact: members of different bodies that overlap where it begins, the
/// deepest with the others counted.
std::vector<Warning> overlapping_bars(const Structure& structure, const State& start);

/// A line of what pulls along gravity, by source, N; "" without gravity.
std::string weight_by_source(const Structure& structure);

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
