---@meta
-- require "hinge.models.ten_storey" -----------------------------------------------------------------------------------

---*reconstructed* means: not in the paper's text. The value is chosen here, because figure 16 is lost.
---@class ten_storey.options
---bay, storey, column, beam and yield stress that are not given. light (default): bays of 5.8 m, storeys of 3.5 m,
---columns box 180x180x6, beams H-200x100x5.5x8, 295 MPa; the study scripts/paper/lost_inputs.lua chose it. heavy: 8 m,
---4 m, box 400x400x22, H-400x200x8x13, 325 MPa; the aircraft cuts no column of it
---@field design? "light"|"heavy"
---@field bays? integer[] bays along x and y, default { 4, 4 }
---@field storeys? integer default 10
---@field bay? number m, *reconstructed*
---@field storey? number m, *reconstructed*
---@field column? hinge.section *reconstructed*; its y axis points along x
---@field beam? hinge.section *reconstructed*; its y axis points up
---@field material? hinge.material default E 206 GPa, nu 0.3, 7850 kg/m^3, the design's yield stress, *reconstructed*
---weight of all floors, divided by the own weight of the whole structure; default 20. It is put into the density of the
---beams (section 4.1), or into a slab
---@field floor_weight? number
---none (default): floors are weight alone, shared out evenly to all beams, as in the paper. weight: shared out by area
---to the beams around each panel (model:floor). slab: all storeys have slabs of the same mass, with as many panels
---along a beam as it has elements. They are struck where the model has model:panel_contact
---@field floor? "none"|"weight"|"slab"
---with floor = "slab": what it is made of, as in model:floor. light: 12 cm of C30/37, bars of 393 mm^2/m each way in
---its middle; heavy: 25 cm and 785 mm^2/m. E and strengths are those of EN 1992-1-1; bending is that of the cracked
---slab: E I / 4, and As f_y (t / 2 - As f_y / 2 f_c) both sagging and hogging. *reconstructed*
---@field slab? hinge.panel_options
---@field origin? vec3 m, the corner that the frame stands on, default { 0, 0, 0 }

---@class ten_storey.frame
---@field group hinge.group all members, "building"
---"storey 1" ... from the ground up. A storey is its columns and the floor above them. Other groups: "columns",
---"beams", "inner columns", "outer columns"
---@field storey_groups string[]
---the joint in column line i along x and j along y, both from 0; level 0 is the ground
---@field node fun(i: integer, j: integer, level: integer): hinge.node
---@field origin vec3
---@field size vec3 m
---@field own_mass number kg, of the steel
---@field floor_mass number kg
---@field mass number kg, both
---@field floor_load number kg/m^2
---@field beam_density number kg/m^3
---@field floor? hinge.floor with floor = "weight" or "slab"

---@class ten_storey
---@field designs table<string, ten_storey.options> "light" and "heavy"
local ten_storey = {}

---Adds a steel frame with rigid joints and fixed feet. With the defaults it has 650 members, 250 free joints and 1807
---t.
---```lua
---local ten_storey = require "hinge.models.ten_storey"
---local frame = ten_storey.add(model, { bays = { 2, 1 }, storeys = 3, origin = { 10, 0, 0 } })
---model:load { node = frame.node(0, 0, 3), force = { 1e5, 0, 0 } } -- the corner of the roof
---print(frame.mass, model:group("storey 1").size)
---```
---@param model hinge.model
---@param options? ten_storey.options
---@return ten_storey.frame
function ten_storey.add(model, options) end

-- require "hinge.models.aircraft" -------------------------------------------------------------------------------------

---@class aircraft.options
---@field size? number length and span, m, default 15 (table 1)
---@field mass? number kg, default 15000 (table 1); spread evenly over the members by their density (section 4.1)
---@field speed? number m/s along the heading; left out: see model:velocity
---m, front end of the fuselage's axis, default { -0.5, 11.6, 23.8 }: 0.5 m in front of the light ten-storey frame,
---*reconstructed*
---@field position? vec3
---@field heading? vec3 any direction but vertical, default { 1, 0, 0 }
---the section that is not given. stiff (default): box 260x260x13. slender: box 120x120x6
---@field design? "stiff"|"slender"
---@field section? hinge.section of all members, *reconstructed*
---default duralumin 2017-T4: E 70.6 GPa, nu 0.33, yield stress 275 MPa, *reconstructed*; the model replaces its density
---@field material? hinge.material
---@field shape? aircraft.shape

---Parts of the size, all *reconstructed*. A tip is the chord at the tip. A sweep is the distance of the front spar's
---tip behind its root.
---@class aircraft.shape
---@field length? number nose to last frame, default 1
---@field nose? number nose to first frame, default 0.10
---@field droop? number nose joint below the fuselage's axis, default 0.02
---@field body? number side of the square frames in the middle of the fuselage, default 0.12265
---@field span? number default 1
---@field wing_tip? number default 0.09
---@field wing_sweep? number default 0.10
---@field tail_span? number default 0.40
---@field tail_tip? number default 0.05
---@field tail_sweep? number default 0.04
---@field fin_height? number above the fuselage, default 0.16
---@field fin_tip? number default 0.05
---@field fin_sweep? number default 0.07

---@class aircraft.facts
---@field joints integer 119
---@field members integer 199
---@field length number m, of all members; 229.5 at size 15
---@field density number kg/m^3
---@field mass number kg
---@field nose hinge.node
---@field groups string[] "fuselage", "wing", "tail"

---@class aircraft
---@field designs table<string, aircraft.options> "stiff" and "slender"
local aircraft = {}

---Adds an aircraft: a space frame of 199 members.
---```lua
---local aircraft = require "hinge.models.aircraft"
---local plane, facts = aircraft.add(model, { size = 12, mass = 12000, speed = 100, position = { -20, 0, 30 } })
---print(plane.size, facts.mass)
---```
---@param model hinge.model
---@param options? aircraft.options
---@return hinge.group aircraft "aircraft", all of it
---@return aircraft.facts facts
function aircraft.add(model, options) end

-- require "hinge.models.space_frame" ----------------------------------------------------------------------------------

---@class space_frame.options
---@field side? number m, default 0.25, *reconstructed*
---@field thickness? number m, side of the solid square section, default 0.02, *reconstructed*
---@field material? hinge.material default E 206 GPa, nu 0.3, 7850 kg/m^3, yield stress 245 MPa, *reconstructed*
---for "asi" or "conventional" with this number of elements a member: smaller shear areas give the midpoint element the
---exact stiffness (MacNeal's residual bending flexibility, 1/GA + l^2/12EI). Mass and strength do not change
---@field exact_elements? integer

---@class space_frame.frame
---@field feet hinge.node[] four, fixed
---@field joints hinge.node[] the upper corners above the feet
---@field loaded hinge.node the first joint, where the paper's load acts along x
---@field section hinge.section

---@class space_frame
local space_frame = {}

---Adds the paper's cube (figure 8): four fixed columns and four beams, in the groups "columns" and "beams".
---```lua
---local space_frame = require "hinge.models.space_frame"
---local cube = hinge.model()
---local frame = space_frame.add(cube, { side = 0.25, thickness = 0.02 })
---cube:load { node = frame.loaded, force = { 1000, 0, 0 } }
---```
---@param model hinge.model
---@param options? space_frame.options
---@return space_frame.frame
function space_frame.add(model, options) end

-- require "hinge.models.ten_storey_impact" ----------------------------------------------------------------------------

---Options of the impact of the paper's section 4. Other fields are ignored, so a script can pass its parameters as they
---are.
---@class impact.options
---what is not given of height, yield_stress, building, aircraft and limits of fracture. light (default): the light
---building, the stiff aircraft, 23.8 m, hinges break at a curvature of 0.04 1/m. heavy: the heavy building, the slender
---aircraft, 30 m, elements break at 0.4 1/m
---@field design? "light"|"heavy"
---@field speed? number m/s, default 440 km/h (table 1, Case I)
---@field size? number m, default 15 (table 1)
---@field mass? number kg, default 15000 (table 1)
---@field height? number m, height of the fuselage's axis above ground, *reconstructed*
---@field offset? number m to the left of the building's middle, default 0, *reconstructed*
---@field gap? number m from nose to facade, default 0.5
---@field contact? string rule of model:contact, default "gap", the paper's gap elements
---@field contact_limits? table further options of model:contact
---@field floor? "none"|"weight"|"slab" of the building, default "none"
---where slabs are struck: options of model:panel_contact; default friction 0.5, restitution 0.3
---@field panel_contact? hinge.panel_contact_options
---@field yield_stress? number Pa, of the building, *reconstructed*
---@field building? ten_storey.options
---@field aircraft? aircraft.options
---@field fracture? fun(model: hinge.model, frame: ten_storey.frame) sets limits other than the paper's
---for simulate: a building that is unstable under its own weight. fail (default): the run ends before the impact.
---continue: the impact follows, from an equilibrium that a small motion would leave
---@field unstable? "fail"|"continue"

---The results of one run. Counts have no unit, energies and works are in J, masses in kg, speeds in m/s, and times in s
---after first contact. inner and outer mean columns. broken_, hinged_, touched_ and work_ are given with inner, outer
---and beams. Further: broken_columns, broken, hinged_columns, work_columns, work (building), worst_column (largest
---plastic work in one column), work_aircraft, broken_aircraft, missed (members of the aircraft that touch nothing),
---lowest (lowest storey with a fracture, 0: none), torn_panels. Energies at the end:
---kinetic, elastic, plastic, fracture, contact, energy_error, with slabs panels and panel_contact. brought: momentum of
---the aircraft.
---own_kinetic: its kinetic energy. given: the part of this momentum that the building has at the end. faint, felt and
---red, by storey: the time when f_y of a column has changed by 0.005, has changed by 0.05, is 1; -1: not within the
---run. pulled: columns that were in compression at rest and carry tension. times, counts, below: times, and how many
---columns are pulled then, of all and of the lower half. wave, long_wave: speed of an elastic wave along a column,
---alone and with the mass of the floors. unstable: factor, node, component and by, as in hinge.instability, of a
---building that is unstable under its own weight; else nil. verdict, reason, time, seconds: of the run. A run with the
---verdict "failed" has results up to its end, and no `given`.
---@alias impact.result table

---@class impact
---@field order string[] "I", "II", "III", "IV"
---@field cases table<string, table> table 1, as changes of Case I
---@field designs table<string, impact.options> "light" and "heavy"
local impact = {}

---Returns the numbers and texts of the load case as scenario parameters, with those of the script added.
---```lua
---local impact = require "hinge.models.ten_storey_impact"
---local parameters = impact.parameters { dt = 2e-5, duration = 0.5 }
---print(parameters.speed, parameters.mass, parameters.dt)
---```
---@param own? table
---@return table
function impact.parameters(own) end

---Returns a copy of a table with changes.
---```lua
---local impact = require "hinge.models.ten_storey_impact"
---local slow = impact.with(impact.parameters(), impact.cases.II)
---```
---@param base table
---@param changes table
---@return table
function impact.with(base, changes) end

---Adds building, aircraft, gravity, fracture and contact.
---```lua
---local impact = require "hinge.models.ten_storey_impact"
---local site = hinge.model()
---local frame, plane = impact.add(site, { speed = 90, height = 10, building = { bays = { 2, 2 }, storeys = 4 } })
---print(frame.mass, plane.mass)
---```
---@param model hinge.model
---@param options impact.options
---@return ten_storey.frame frame, hinge.group plane, aircraft.facts parts
function impact.add(model, options) end

---Returns the damage of the building, and the plastic work of the aircraft.
---```lua
---local impact = require "hinge.models.ten_storey_impact"
---local site = hinge.model()
---local frame, plane = impact.add(site, { height = 2, building = { bays = { 2, 2 }, storeys = 1 } })
---local rest = site:static { steps = 1, fixed_group = plane }:finish()
---print(impact.damage(rest, frame).broken_columns)
---```
---@param run hinge.run
---@param frame ten_storey.frame
---@return impact.result
function impact.damage(run, frame) end

---Makes one run: rest under gravity, then the impact.
---```lua
---local impact = require "hinge.models.ten_storey_impact"
---local p = impact.parameters { dt = 1e-4, duration = 2e-3, watch = 1e-3, height = 2 }
---local result = impact.simulate(impact.with(p, { building = { bays = { 2, 2 }, storeys = 1 } }))
---print(result.verdict, result.broken_columns, result.plastic)
---```
---@param p impact.options with dt, duration and watch (s between two readings of the columns)
---@param see? fun(run: hinge.run, frame: ten_storey.frame, watch: table): fun(step: table)
---  called when the run has been made; what it returns, after each step
---@return impact.result
function impact.simulate(p, see) end

---Calls one(task, job) for each task. Each task has a process of its own, and as many run at a time as there are cores.
---It is a hinge.study in the folder `runs` of the job's folder. half = 1 in `p`: all tasks in this process.
---```lua
---local impact = require "hinge.models.ten_storey_impact"
---local results = impact.side_by_side(job, { half = 1 }, { { force = 1 }, { force = 2 } }, function(task)
---  return { twice = 2 * task.force }
---end)
---```
---@param job hinge.job
---@param p table the script's parameters, which include half
---@param tasks table[]
---@param one fun(task: table, job: hinge.job): any made of numbers, strings, booleans and tables
---@return any[] results in the order of the tasks
function impact.side_by_side(job, p, tasks, one) end
