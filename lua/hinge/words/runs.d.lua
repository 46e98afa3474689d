---@meta
-- Runs ----------------------------------------------------------------------------------------------------------------

---@class hinge
local hinge = {}

---Continues a run from a checkpoint. It is the same as run:resume(file).
---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }
---swing:step()
---swing:checkpoint "swing.checkpoint"
---local again = model:dynamic { dt = 1e-4, duration = 0.01 }
---hinge.resume(again, "swing.checkpoint"):finish()
---```
---@param run hinge.run
---@param file string
---@return hinge.run
function hinge.resume(run, file) end

---@class hinge.run
---@field kind "static"|"dynamic"
---@field model hinge.model of which the run was made
---@field time number s
---@field factor number in statics: the load factor reached
---@field index integer number of steps done
---@field planned_steps integer
---a run is as good as the run that it goes on from: it is "failed" at its end if that one failed, or ended at a limit
---load or before the load factor of its arc length, unless allow_failed = true
---@field verdict "running"|"completed"|"stopped"|"failed"
---why the run failed, with the node or element that caused it, or with the run before it that failed. For statics
---with the verdict "completed": a limit load or branching point on the way, with unstable = "continue" whether the
---state at the end is stable, and whether arc length stopped short of its load factor. Under plain Lua, a failed run
---is reported on stderr when the script has ended, unless the script has read verdict, reason or failure. The text is
---for people and may change from version to version; a script decides by failure
---@field reason string
---@field failure? hinge.run_failure why the run failed, as values; nil where it has not
---what the model cannot show, or what the run may have missed, each once. That the run goes on from one that failed. A
---member of two elements that is compressed beyond Euler's load between clamped ends (dynamics; in statics that is an
---instability). Moments of loads along such a member that are more than 5 % too small for its compression (p_delta =
---"member"): beyond 0.6 of that load, and with weight = "nodes" also below. Four elements show both. A free body that
---spins so fast for the steps of Newmark's method that its angle is lost: integrator = "energy-momentum" keeps it. A
---step of static load that moves the structure more than 30 times as far as the same load did at first. Dynamics checks
---this every 100 steps, or 20 times in a short run, and at the end. A perfect structure that can buckle while only
---rounding starts it (a straight column, a symmetric arch or truss): dynamics of up to 500 nodes looks for that up to
---40 times in a run, from 5 % of Euler's load in a member or 1 % of the size in displacement on. Members that passed
---through each other without a contact rule for them, in statics with large displacement whatever the rules (not those
---that share a node or overlapped at the start). Bodies that fell below the lowest support, and columns that fell over
---to below their own, where no ground is for them. An elastic stress that no material bears where no yield stress is
---declared: a strain of 1 % from E = 50 GPa, 3 % from 5 GPa, 30 % from 0.5 GPa; members stretched to more than 1.6
---times their length. Members of less than eight elements that were struck between their joints and yielded.
---`hinge run` prints the warnings; they are in summary.json
---@field warnings string[]
---@field energy hinge.energy
---@field dt number s, of the next step; nil in statics
---@field limit? boolean in statics: true if the run has ended at a limit load, see to_limit; nil in dynamics
---@field instability? hinge.instability in statics: where the structure became unstable; nil where it did not
---@field worst_energy_error number J, the largest absolute value of energy.energy_error so far
---energy.energy_error as a part of the largest energy, at the last row of history.csv. The largest energy is the
---largest value that any account of the energy balance has had so far. An account counts only up to what the other side
---of the balance explains (what is held or dissipated: up to the initial energy, the work supplied and what gravity and
---connectors gave), so that energy from an error does not count. energy_tolerance of model:dynamic limits the same
---error.
---If the balance did not close, this is the error when that was seen, not that of the earlier state to which the run
---went back
---@field energy_error number
---the same of the state that the run has now; differs from energy_error only after the balance did not close
---@field energy_error_of_state number
---pairs of elements; bound: ties made or contacts begun; released: those ended
---@field contacts { bound: integer, released: integer }
---@field stages { name: string, seconds: number }[] wall time of the steps by stage
---@field effects hinge.effect[] all effects of hinge, used in the step or not
---@field wall_seconds number
---@field fastest { speed: number, node: string, time: number } the fastest node so far, m/s and s; nil in statics
---@field hash string checksum of the whole state, to the bit
---@field counts hinge.work_counts
---@field probes hinge.probe[] all probes up to now
---@field loads table<string, number> the load cases of the model by name, with their factors in this run
---effects that became active or inactive during the run; the first thousand
---@field state_changes { time: number, effect: string, awake: boolean, why: string }[]
local run = {}

---@class hinge.effect
---@field name string
---@field active boolean true: the effect is part of the step
---@field because string why it is active, or why not
---@field seconds number wall time of the effect
---@field asked_at string line of the script that declares the effect; "" if none does

---A word of the list at hinge.run_failure
---@alias hinge.failure_cause string

---Why a run failed. A field that says nothing of the cause is nil. summary.json has the cause of the verdict as
---"cause", also "not_written" where a file could not be written. The causes: "load_not_finite": a load on `node` is
---not a finite number; "force_not_finite": nor are the forces of `element`, or at `node`; "forces_unbounded": the
---forces at `node` grow without bound. "element_folded": an end of `element` has folded back against the element.
---"flow_not_found": its plastic flow has no solution within a step. "not_factorised", "not_positive_definite",
---"solution_not_finite", "solver_not_converged", "mass_not_solved": the linear equations of a step have no solution.
---"not_positive_definite" has the `node` and, where one is known, the `element`; `value`: the compression in it, N.
---"solver_not_converged": after `count` iterations. "newton_not_converged": after `count` iterations; `value`: the
---last correction as a part of the first. "rotation_too_large": step control; `node` would rotate by `value` in a
---step, `limit` is allowed, rad. "energy_lost_in_step", "energy_not_finite": step control; `value` would be lost,
---`limit` is allowed, as parts of the largest energy. "energy_error": the energy balance does not close; its error is
---`value`, `limit` the energy_tolerance. "energy_error_grown": it has grown by `value` since the check at step
---`count`, `limit` is allowed; all as parts of the largest energy. "no_equilibrium": statics; none is found beyond
---load factor `value`; `limit`: the part of the step that was tried last. "unstable": statics under load control,
---between load factors `value` and `limit`; `node` and `component` give way, see run.instability. "from_failed_run":
---the run that this one goes on from did not reach its end
---@class hinge.run_failure
---@field cause hinge.failure_cause
---@field text string run.reason without advice and without what was seen beside the failure
---@field step? integer step that was tried, or at which the energy balance was checked
---@field time? number s, at its end
---@field node? string its name, as in run.instability
---@field element? string its name, with that of its member and group
---@field member? hinge.member the member of the element
---@field component? hinge.component direction in which the node gives way
---@field value? number see the cause; nil for 0
---@field limit? number what is allowed, see there; nil for 0
---@field count? integer see there
---what had failed before that, and was seen at the same time: an energy balance that no longer closed
---@field before? hinge.run_failure

---A limit point or a branching point that a static run has passed. Beyond it the tangent stiffness has more negative
---eigenvalues than at the start of the run. Under constant load the structure would not stay there.
---@class hinge.instability
---@field factor number load factor of the last equilibrium before it
---@field beyond number load factor of the first equilibrium after it
---@field count integer number of motions that have lost their resistance, the most so far
---with the largest part in the first such motion; rotations count times the mean length of an element
---@field node string
---@field component hinge.component its direction: ux uy uz rx ry rz
---the cause: "compression" of members that bend, or "bending", as of a beam that turns over sideways; nil: neither of
---them
---@field by? "compression"|"bending"
---@field member? hinge.member the member with the largest part in this; nil: none
---@field members hinge.member[] this member and others with at least half its part, at most three

---Counts of the work that a run has done.
---@class hinge.work_counts
---@field element_updates integer elements whose forces were recovered
---@field element_builds integer elements whose stiffness was built
---@field solves integer systems solved
---@field cg_iterations integer
---@field factorisations integer
---@field pair_tests integer pairs of members that were checked for contact
---@field pair_lists integer lists of near pairs that were made
---@field rejected_steps integer steps that step control has undone; in statics tries that were halved
---@field substeps integer in statics equilibria found: a step that was halved has several; in dynamics steps

---The energy balance, J: eq 20, and the terms that eq 20 leaves out.
---@class hinge.energy
---kinetic energy at the start, and all that is stored then: in the elements, contacts, connectors, joints, ground
---@field initial number
---@field kinetic number
---@field gravity number potential energy, of each body from where it was at the start
---@field elastic number
---@field plastic number dissipated in hinges
---@field fracture number released by fracture: fracture_elastic + fracture_kinetic
---@field fracture_elastic number strain energy of broken elements
---@field fracture_kinetic number kinetic energy lost when broken elements become rigid offset masses
---@field contact number contact_stored + contact_released
---@field contact_stored number stored in contacts now
---@field contact_released number lost when ties are released, or heat of friction
---@field damping? number dissipated by Rayleigh damping, where model:damping is declared
---@field connectors number connector_stored + connector_dissipated; these three only if the model has connectors
---@field connector_stored number stored in springs and curves now
---@field connector_dissipated number dissipated by dashpots and laws, and lost when connectors break
---@field joints number joint_stored + joint_dissipated; these three only if members' ends have joints
---@field joint_stored number stored in the springs of joints now
---@field joint_dissipated number plastic work of joints, and what was lost when they broke
---@field ground number ground_stored + ground_dissipated; these three only if the model has a ground
---@field ground_stored number stored now where members press on the ground
---@field ground_dissipated number lost to the ground's damping, friction and restitution
---heat and prestress: energy taken out; below 0 they have done work. Only with model:heat or model:prestress
---@field heat number
---@field numerical number dissipated by the integrator (rho_infinity)
---@field work number work of the loads
---@field energy_error number the energy error: initial + work - all other accounts (without their parts)
---@field remainder number the same, by its other name in summary.json

---Does the steps one by one: `for step in run:steps() do ... end`. The table is the same one at every step, with new
---values.
---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }
---for step in swing:steps() do
---  local _, _, uz = tip:displacement(swing)
---  if step.index % 20 == 0 then print(step.time, uz) end
---end
---```
---@return fun(): { index: integer, time: number, factor: number }?
function run:steps() end

---Does one step. The run uses the model as it was when the run was made. If the model was changed after that, the call
---is an error; so are run:steps and run:finish.
---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }
---while swing:step() do
---  if select(3, swing:displacement(tip)) < -1e-3 then swing:stop() end
---end
---```
---@return boolean done false if no step is left
function run:step() end

---Does all steps to the end.
---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }:finish()
---print(swing.verdict, swing.time)
---```
---@return hinge.run
function run:finish() end

---Writes a checkpoint into a file: the state of the run, its probes, history.csv and list of frames. With it the run
---can continue with the same bits. The file is first written under another name and then renamed, so it is always
---complete: the old one or the new one. The call changes nothing in the run. Call it between steps or in run:on_step;
---for dynamic runs only. The variables of the script are not saved, nor are those that its functions use. The table
---given as `keep` is saved, and so are the numbers that a fracture rule keeps for each section.
---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }
---for step in swing:steps() do
---  if step.index % 50 == 0 then swing:checkpoint "swing.checkpoint" end
---end
---```
---@param file string a name without a folder is in the output folder
---@return hinge.run
function run:checkpoint(file) end

---Continues the run from a checkpoint. Call it before the first step. The checkpoint must be of the same run: the same
---model, settings and probes; the number of threads may differ. A damaged checkpoint, one of another run (the message
---names the difference) or one of another version of hinge is an error. The run is then unchanged.
---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }
---swing:step()
---swing:checkpoint "swing.checkpoint"
---local again = model:dynamic { dt = 1e-4, duration = 0.01 }:resume "swing.checkpoint"
---print(again.index) -- 1
---```
---@param file string
---@return hinge.run
function run:resume(file) end

---Ends the run here. Its verdict is then "stopped". A run that has already ended does not change.
---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }
---for step in swing:steps() do
---  if step.time > 5e-3 then swing:stop() end
---end
---```
function run:stop() end

---Sets a function that is called with the run after each step, also for steps of run:finish. The function may read the
---run and stop it, but may not step it.
---```lua
---local lowest = 0
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }
---swing:on_step(function(now) lowest = math.min(lowest, select(3, now:displacement(tip))) end)
---swing:finish()
---```
---@param callback fun(run: hinge.run)
---@return hinge.run
function run:on_step(callback) end
