// Likely mistakes in loads: far too large, members that may buckle under them, histories without effect.
#pragma once

#include <vector>

#include "run/linear_solution.h"
#include "advice/advised_run.h"

namespace hinge {

/// Loads that would strain a section beyond any real structure, or bend it to many times its plastic moment.
std::vector<Warning> huge_loads(const AdvisedRun& of, const LinearSolution& solution);

/// Members whose compression is beyond half of Euler's load, equal ones in one warning, the worst first.
std::vector<Warning> near_euler(const AdvisedRun& of, const LinearSolution& solution);

/// The member whose axial force makes eq 14 most unsafe (unsafe_strength.h), with the others counted. Beside the
/// forces found, as they act before anything yields.
std::vector<Warning> unsafe_eq14(const AdvisedRun& of, const LinearSolution& solution);

/// Slender members that are heated, whose strength is that at 2 % strain and whose material has no curve up to it.
std::vector<Warning> heated_without_curve(const Structure& structure);

/// Point loads of some size between the ends of an element that may yield: hinges form at the ends of elements alone.
std::vector<Warning> loads_beside_hinges(const Structure& structure);

/// Dynamic run: histories given as points that are over before it begins (of loads and motions that `before`, the model
/// of the run that it goes on from, did not have; null where there is none), that change little in its time, or that
/// act for less than two steps.
std::vector<Warning> idle_histories(const Model& model, const Model* before, double begin, double duration, double dt);

/// Dynamic run: loads that are many times the weight of the model's mass. They have no inertia of their own.
std::vector<Warning> massless_loads(const Structure& structure, const std::string& line);

/// Loads along gravity beside point masses of about the same weight: floors that may count twice.
std::vector<Warning> floors_twice(const Structure& structure);

/// Dynamic run that continues `before`: gravity that did not act there, and so acts at once.
std::vector<Warning> late_gravity(const Structure& structure, const AdvisedRun& before, const std::string& line);

/// Dynamic run, the first with contact: members of different bodies that overlap where it begins, the deepest with the
/// others counted.
std::vector<Warning> overlapping_bars(const Structure& structure, const State& start);

/// Line with the forces along gravity by source, N; "" without gravity.
std::string weight_by_source(const Structure& structure);

/// Dynamic run: velocities of single nodes whose kinetic energy is mostly that of the elements beside them, so that it
/// depends on how short these are. `before` as in idle_histories.
std::vector<Warning> lone_velocities(const Structure& structure, const State& start, const Model* before,
                                     const std::string& line);

/// Dynamic run: bodies that no support holds, directly or through connectors, and that alpha of model:damping damps.
std::vector<Warning> damped_free_bodies(const Structure& structure, const State& start);

/// Load cases that a run uses and that are empty.
std::vector<Warning> empty_cases(const Model& declared, int gravity_case, const LoadChoice& choice,
                                 const std::string& line);

}  // namespace hinge
