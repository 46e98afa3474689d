---@meta
-- Results -------------------------------------------------------------------------------------------------------------

---Tables for a report, of what runs have computed: forces of members, envelopes, utilisation by standards, storeys,
---reactions. Every call needs the model of the run, or members or groups of it.
---@class hinge.results
local results = {}

---Options that all calls of hinge.results share.
---@class hinge.results_source
---@field model? hinge.model the model of the run, which is also the default
---@field group? hinge.group_like|hinge.group_like[] members of these groups alone
---@field members? hinge.member[] these members alone
---stations along a member are at this number of equal parts; ends and extreme moments are always read; default 8
---@field parts? integer
---units of force, length and displacement in which tables are shown; default "kN, m, mm"
---@field units? string

---The smallest and largest resultants of each member now, with their places. A row has N_min, N_min_x, N_max, N_max_x,
---the same for Mx, My, Mz, Qx and Qy, and N, Mx, ... as the one of the larger size, in SI units.
---```lua
---local forces = hinge.results.members(run, { model = model })
---print(forces)
---print(forces.rows[1].Mx_min, forces.rows[1].Mx_min_x) -- N m, m
---```
---@param run hinge.run
---@param options? hinge.results_source
---@return hinge.results_table
function results.members(run, options) end

---The smallest and largest resultants of each member over the steps of a dynamic run, or over several runs, with the
---time (s), or the name, of the state in which each occurred. A run that has not ended is read after each of its steps;
---a dynamic one also at its start. A static run that has ended is read once. A dynamic run that has ended is an error:
---only its last state is left. A static state is called by its load cases, "1.35 dead + 1.5 live", or by `names`.
---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }
---local peaks = hinge.results.envelope { swing, model = model, every = 10 }
---swing:finish()
---print(peaks.rows[1].Mx_min, peaks.rows[1].Mx_min_when) -- N m, s
---print(hinge.results.envelope { run, model = model, names = { "at rest" } })
---```
---@param options hinge.envelope_options
---@return hinge.results_envelope
function results.envelope(options) end

---@class hinge.envelope_options: hinge.results_source
---@field [integer] hinge.run runs; none, if states are added by envelope:add
---@field every? integer steps between two readings of a run; default 1. The last planned step is always read
---@field names? string[] names of the runs, in their order

---A table of an envelope. `states` is the number of states read. A row has `stations`, a list of { x =, N = { smallest,
---largest }, Mx = ... } at equal parts of the member.
---@class hinge.results_envelope: hinge.results_table
---@field states integer
local envelope = {}

---Adds the state that a run has now.
---```lua
---local peaks = hinge.results.envelope { model = model }
---local push = model:static { steps = 4 }
---for step in push:steps() do peaks:add(push, ("step %d"):format(step.index)) end
---```
---@param run hinge.run
---@param name? string what the state is called; default: its time, or its loads
---@return hinge.results_envelope self
function envelope:add(run, name) end

---Draws the band between the smallest and largest values of a resultant along members, one after the other.
---```lua
---hinge.results.envelope({ run, model = model }):plot("moments.png", { quantity = "Mx", members = { beam } })
---```
---@param job? hinge.job may be left out: plot(filename, options)
---@param filename string plain name ending in .png, .svg or .pdf
---@param options? { quantity?: string, members?: hinge.member[], units?: string, title?: string } default: Mx, all
---@return hinge.results_envelope self
function envelope:plot(job, filename, options) end

---The largest utilisation of each member by a standard, over one or several runs that are read as by
---hinge.results.envelope. A utilisation is a ratio that may be at most 1. The checks are of the resultants of the run:
---after yielding, and with effects of second order in large displacement. Nothing is added to them.
---
---EN 1993-1-1:2005, classes 1 and 2: 6.2.3 to 6.2.9, 6.3.1, 6.3.2.2 where Lb is given (H and upright rectangles),
---6.3.3 with annex B. AISC 360-16, LRFD: D2(a), E3, F2, F3, F6, F7, F8, F11, G2, G4 to G6, H1.1, H3. Sections: H, box,
---pipe, rectangle, round bar, of steel. Other members, and those whose plates are too slender, have a remark "not
---checked: ..." and no utilisation. The formulas were compared with published examples. Rupture at holes, torsional
---buckling of compressed H sections and warping are not checked. An envelope in place of runs takes extremes of
---different times together.
---
---Joints have rows of their own, whatever the standard: the moment about each axis over its strength ("joint Mx"); with
---interaction = "linear" the share of tension is added ("joint Mx + tension", EN 1993-1-8, 6.2.7.1 (3)); the rotation
---over the capacity ("joint rotation x"), and the forces at which the joint or a connector breaks ("joint tension",
---"joint shear", "connector force z"). One that has broken by a limit of its own has its largest values. A joint
---without a strength about an axis has a remark.
---```lua
---local used = hinge.results.utilisation(run, { model = model, standard = "EN 1993-1-1",
---  lengths = { kx = 2, ky = 2 } })
---print(used)
---for _, row in ipairs(used.rows) do print(row.index, row.utilisation, row.check, row.remark) end
---```
---@param runs hinge.run|hinge.run[]|hinge.results_envelope
---@param options hinge.utilisation_options
---@return hinge.results_utilisation
function results.utilisation(runs, options) end

---@class hinge.utilisation_options: hinge.results_source
---@field standard "EN 1993-1-1"|"AISC 360"
---@field lengths? hinge.buckling_lengths|hinge.lengths_by_group one for all members, or by group or function
---@field every? integer as of hinge.envelope_options
---@field names? string[]
---@field gamma_M0? number EN 1993-1-1: default 1; the same holds for gamma_M1
---@field gamma_M1? number
---buckling curves "a0", "a", "b", "c" or "d" about x and y, of EN 1993-1-1; default: table 6.2. A section with fillets
---counts as rolled, without as welded; CHS, SHS and RHS as hot finished; pipes and boxes with radii of another name as
---cold formed. A welded box has curve b; with thick welds and b / tf below 30 the table has c, which is to be given
---@field curves? string|{ x?: string, y?: string }
---@field curve_LT? string of lateral torsional buckling; default: table 6.4
---factors of equivalent moments of annex B; default 1, which is on the safe side. "B.3": table B.3 where a moment is
---straight from end to end, else 1. It is for members whose ends do not sway: table B.3 has 0.9 for the others
---@field Cm? number|{ x?: number, y?: number, LT?: number }|"B.3"
---moments beside an axial force in 6.2.9: "standard" (default); "linear": 1 - N / N_pl; "exact": those of the section's
---shape, section:reduced_moments
---@field interaction? "standard"|"linear"|"exact"

---@alias hinge.lengths_by_group table<string, hinge.buckling_lengths>|fun(m: hinge.member): hinge.buckling_lengths

---Buckling lengths of a member. x: bending about the section's x axis.
---@class hinge.buckling_lengths
---@field kx? number buckling length over the member's length; default 1
---@field ky? number
---@field Lx? number m, in place of kx
---@field Ly? number m
---@field Lb? number m, between lateral supports; default: no lateral torsional buckling
---@field C1? number EN 1993-1-1: by the shape of the moments between lateral supports; default 1
---@field Cb? number AISC 360: the same

---A table of utilisations, the largest first. A row of a joint has joint (its name, as in run:hinges) and the member
---that it is at. A row has utilisation, check (the clause or equation that governs), x (m;
---nil: the member as a whole), when (s, or a name), law (the largest √f_y of the section's own law), slenderness (of
---plates, over their limit), remark, checks ({ [name] = { value =, x =, when = } }) and each check by its name.
---@class hinge.results_utilisation: hinge.results_table
---@field states integer
local used = {}

---Adds the state that a run has now.
---```lua
---local used = hinge.results.utilisation({}, { model = model, standard = "AISC 360" })
---used:add(run, "at rest")
---```
---@param run hinge.run
---@param name? string
---@return hinge.results_utilisation self
function used:add(run, name) end

---Draws the utilisations as bars, the largest above.
---```lua
---hinge.results.utilisation(run, { model = model, standard = "AISC 360" }):plot "utilisation.png"
---```
---@param job? hinge.job may be left out: plot(filename, options)
---@param filename string plain name ending in .png, .svg or .pdf
---@param options? { top?: integer, title?: string } default: 20 members
---@return hinge.results_utilisation self
function used:plot(job, filename, options) end

---Drift and shear force of each storey in x and y, with their largest values over runs that are read as by
---hinge.results.envelope. Drift is that of the column line with the largest one: the difference of the displacements of
---two nodes, one above the other, over the height. The shear force is the sum of the horizontal forces, in space, of
---all members at half the height of the storey: by what is above on what is below. A row has storey, from, to, drift_x,
---drift_x_when, drift_x_min, drift_x_max, drift_x_last, line_x (the upper node of the line), shear_x, ... and the same
---for y.
---```lua
---local frame = hinge.model()
---local low, high = frame:node { 0, 0, 0 }, frame:node { 0, 0, 3 }
---frame:fix(low)
---frame:member { low, high, section = square, material = steel }
---frame:load { node = high, force = { 100, 0, 0 } }
---local pushed = frame:static():finish()
---local floors = hinge.results.storeys(pushed, { model = frame, levels = { 0, 3 } })
---print(floors.rows[1].drift_x, floors.rows[1].shear_x) -- and 100 N
---```
---@param runs hinge.run|hinge.run[]
---@param options? hinge.storeys_options
---@return hinge.results_storeys
function results.storeys(runs, options) end

---@class hinge.storeys_options
---@field model? hinge.model
---@field levels? number[] m, heights of the base and of the floors; default: those of level members
---@field every? integer as of hinge.envelope_options
---@field names? string[]
---@field units? string

---@class hinge.results_storeys: hinge.results_table
---@field levels number[] m
---@field states integer
local floors = {}

---Adds the state that a run has now.
---```lua
---local mast = hinge.model()
---local low, high = mast:node { 0, 0, 0 }, mast:node { 0, 0, 3 }
---mast:fix(low)
---mast:member { low, high, section = square, material = steel }
---mast:load { node = high, force = { 100, 0, 0 } }
---local floors = hinge.results.storeys({}, { model = mast, levels = { 0, 3 } })
---local push = mast:static { steps = 4 }
---for step in push:steps() do floors:add(push, ("step %d"):format(step.index)) end
---```
---@param run hinge.run
---@param name? string
---@return hinge.results_storeys self
function floors:add(run, name) end

---Draws the largest drift, or shear force, of each storey over the height.
---```lua
---local mast = hinge.model()
---local low, high = mast:node { 0, 0, 0 }, mast:node { 0, 0, 3 }
---mast:fix(low)
---mast:member { low, high, section = square, material = steel }
---mast:load { node = high, force = { 100, 0, 0 } }
---hinge.results.storeys(mast:static():finish(), { model = mast, levels = { 0, 3 } }):plot "drifts.png"
---```
---@param job? hinge.job may be left out: plot(filename, options)
---@param filename string plain name ending in .png, .svg or .pdf
---@param options? { quantity?: "drift"|"shear", units?: string, title?: string } default: drift
---@return hinge.results_storeys self
function floors:plot(job, filename, options) end

---Reactions of supports, their sum, the loads that act, the weight, and what is left. Its remark says whether they are
---in balance. In dynamics the rest is what inertia and damping have. rows.sum, rows.loads and rows.rest are those rows.
---```lua
---local feet = hinge.results.base(run, { model = model })
---print(feet, feet.balanced, feet.rows.sum.Fz) -- N
---```
---@param run hinge.run
---@param options? hinge.base_options
---@return hinge.results_base
function results.base(run, options) end

---@class hinge.base_options
---@field model? hinge.model
---@field gravity? vec3 m/s^2, with the factor of its load case: for the weight; default: none
---@field about? vec3 m: moments of sums are about this point; default the origin
---@field units? string

---@class hinge.results_base: hinge.results_table
---@field balanced boolean
---@field mass number kg

---The calls of hinge.results for one model, which then need not be given.
---```lua
---local out = hinge.results.of(model)
---print(out.members(run), out.base(run))
---```
---@param model hinge.model
---@return hinge.results
function results.of(model) end

---A table of results. print shows it as text. Rows are in SI units, and stay in the order of declaration.
---@class hinge.results_table
---@field rows table[]
---@field notes string[] remarks below the table
local any_table = {}

---How a table is shown.
---@class hinge.table_view
---@field columns? string[] fields of rows, in their order; default: those that are not zero throughout
---field by which rows are sorted: the largest size first, texts by the alphabet; default: the order of rows
---@field sort? string
---@field top? integer the first rows alone
---@field units? string as of hinge.results_source

---The table as aligned text.
---```lua
---local forces = hinge.results.members(run, { model = model })
---print(forces:text { columns = { "index", "Mx_min" }, sort = "Mx", top = 10, units = "kN, m" })
---```
---@param options? hinge.table_view
---@return string
function any_table:text(options) end

---The table in Markdown.
---```lua
---print(hinge.results.members(run, { model = model }):markdown())
---```
---@param options? hinge.table_view
---@return string
function any_table:markdown(options) end

---The table as a tabular of LaTeX.
---```lua
---print(hinge.results.members(run, { model = model }):latex())
---```
---@param options? hinge.table_view
---@return string
function any_table:latex(options) end

---Writes the table as a CSV file into the output folder, with all columns. Places and times have columns of their own.
---```lua
---hinge.results.members(run, { model = model }):csv "members.csv"
---```
---@param filename string plain name ending in .csv
---@param options? hinge.table_view
---@return hinge.results_table self
function any_table:csv(filename, options) end
