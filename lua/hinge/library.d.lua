---@meta
-- Jobs, the model library and the report, for editors that read LuaLS annotations. Nothing in this
-- file runs. The units are those of hinge.d.lua.

-- Jobs: the second argument of a scenario's run ----------------------------------------------------------------------

---@class hinge.job output of one run of a script
---@field out string output folder
---@field case? string name of the case
---@field notes string[] the notes up to now
local job = {}

---Adds the structure as it is now to frames.pvd, for ParaView, hinge render and hinge report.
---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }
---for step in swing:steps() do
---  if step.index % 50 == 0 then job:frame(swing) end
---end
---```
---@param run hinge.run
function job:frame(run) end

---Adds one vibration of a mode to frames.pvd in the output folder: the state of its run with the shape on top, sin(2 pi
---t / period). `hinge render FOLDER --gif` makes a film of it, which goes on without a jump. A buckling mode has a
---period of 1 s. Nothing else should write frames into that folder.
---```lua
---job:animate(run:modes { n = 1 }[1], { frames = 24, amplitude = 0.2 })
---```
---@param mode hinge.mode
---@param options? { frames?: integer, amplitude?: number } default 24; m, default a twentieth of the structure's size
function job:animate(mode, options) end

---Draws the structure as it is now into a PNG in the output folder. Members have their true sections. Six colours along
---each element tell f_y, the yield function of its section's law: five for its fifths, and red where the section is
---fully plastic. Readers who are colour-blind can tell them apart. Broken elements are black, as in figure 17. A
---plastic hinge is a red dot whose area grows with its plastic rotation, up to 0.2 rad. If no picture can be drawn, the
---job notes this and the run continues.
---```lua
---job:picture(run, { title = "under 1 kN", from = { 0, -1, 0.2 }, width = 800, height = 600 }, "cantilever.png")
---job:picture(run, { view = "front", scale = "auto", ghost = true, loads = true, labels = true }, "deformed.png")
---job:picture(run, { view = "front", show = "Mx" }, "moments.png")
---```
---@param run hinge.run
---@param view? hinge.view
---@param filename? string plain name ending in .png; default picture.png, then picture-2.png and so on
function job:picture(run, view, filename) end

---@class hinge.view
---@field width? integer pixels, default 1600
---@field height? integer pixels, default 1200
---a view by name. perspective (default) is from the left, in front and above. The others have no perspective: front
---looks along y, and against z where `up` is y; iso shows the three axes equally long
---@field view? "front"|"back"|"left"|"right"|"top"|"iso"|"perspective"
---direction from the scene to the eye, with perspective, in place of a name; default { -1, -1.4, 0.55 }
---@field from? vec3
---@field up? vec3 the direction that is upwards in the picture, default { 0, 0, 1 }
---displacements are drawn so many times as large, and members bend as their nodes have rotated; default 1. "auto": the
---largest one is about a twentieth of the structure. The picture says the factor
---@field scale? number|"auto"
---what is shown of the members. f_y (default), group or none: by their colour. The others draw a diagram along them
---with the largest values of each member: N, the shear forces Qx and Qy in N, and Mx, My and the torsion Mz in N m, in
---the section's axes. Moments lie on the side in tension
---@field show? "f_y"|"group"|"none"|"N"|"Qx"|"Qy"|"Mx"|"My"|"Mz"
---N or N m; the value that a diagram draws in full size, so that several pictures have one scale; default: its largest
---@field largest? number
---@field ghost? boolean true: the shape at the start, in grey; default false
---@field supports? boolean supports of the nodes, default true
---@field ground? boolean the planes that members may fall on, default true
---dots where plastic hinges are, and joints that have yielded, default true. A list of run:hinges that was given a
---limit: the hinges and joints that have one. Their colour says whether they have rotated to half of it, to it or
---beyond, and their area goes with that, up to twice the limit
---@field hinges? boolean|hinge.hinge_list
---@field loads? boolean true: the loads that act now, with their values; default false
---@field labels? boolean|"nodes"|"members" true: the numbers of nodes and members; default false
---@field leave_out_broken? boolean as in figure 18
---@field above? number m; only parts that are wholly above this height
---@field groups? (string|hinge.group)[] only members of these groups
---m; only elements that lay in this plane at the start, up to 1 mm, such as { y = 0 } for one line of frames. Without
---view and from the picture then looks across it. A plane without any member is an error
---@field plane? { x?: number, y?: number, z?: number }
---@field title? string
---@field box? number[] m: xmin, xmax, ymin, ymax, zmin, zmax to show; it gives several pictures the same view

---Draws snapshots side by side into one PNG. All of them have the width and height of the first view (pixels, default
---1600 x 1200). The whole picture may have at most 8192 pixels a side.
---```lua
---job:strip({ { run, { title = "all" } }, { run, { groups = { "arm" } } } }, 2, "side_by_side.png")
---```
---@param snapshots { [1]: hinge.run|hinge.snapshot, [2]?: hinge.view }[]
---@param columns integer snapshots in a row
---@param filename string plain name ending in .png
function job:strip(snapshots, columns, filename) end

---Draws a plot into the output folder by the program gnuplot: PNG, SVG or PDF by the filename's ending. It needs no
---display. Beside NAME.png stand NAME.gp, gnuplot's commands, and NAME.dat, the values, so that the picture can be
---restyled for a paper. what is a
---table of curves (hinge.plot), of panels (hinge.panels), or a run. Of a run its energies and probes are drawn over
---time, those of one unit in one panel. For a static run the load factor is drawn over its probes, which is the
---load-displacement curve, and energies are drawn over the load factor. In place of a run, the folder of one that has
---ended will do: its history.csv is read, and the units of its probes in probes.json beside it. Without that file,
---which older versions did not write, only probes without a name of their own show a unit. Units on the axes have
---prefixes that suit the values. If no picture can be drawn, the job notes this and the run continues.
---```lua
---job:plot({ series = { { x = { 0, 1, 2 }, y = { 0, 3, 4 }, name = "measured", style = "points" } }, x_label = "mm",
---  y_label = "kN" }, "load.png")
---job:plot({ series = { { x = { "I", "II" }, y = { 3.1, 2.2 }, style = "bars" } }, y_label = "kN" }, "cases.svg")
---job:plot(run, "history.png")
---```
---@overload fun(self: hinge.job, what: hinge.plot|hinge.panels|hinge.run|string, filename: string)
---@param what hinge.plot|hinge.panels|hinge.run|string a run, or the folder of one that has ended
---@param choice? hinge.history only with a run or its folder: what of it; default: its energies that are not 0
---  throughout and all its probes, of a static run with probes these alone
---@param filename string plain name ending in .png, .svg or .pdf
function job:plot(what, choice, filename) end

---@class hinge.history what is plotted of a run
---@field [integer] string|hinge.probe accounts of run.energy and probes, by name or probe; default as said above
---a probe in place of the time or load factor; the others must then be probes of the same run
---@field x? string|hinge.probe
---@field title? string
---@field columns? integer panels in a row, default 1
---@field width? integer pixels, default 1200; 800 for each of several columns
---@field height? integer pixels, default 900 for one panel; 160 and 420 for each row of several

---@class hinge.plot
---@field series hinge.series[]
---@field title? string
---@field x_label? string
---@field y_label? string
---@field log_x? boolean
---@field log_y? boolean
---@field x_range? number[] { low, high } of the axis, which cut the curves; default: all that is drawn
---@field y_range? number[] { low, high }; default: all that is drawn, within x_range where that is given
---@field lines? hinge.plot_line[] level and upright lines through the whole plot
---@field width? integer pixels, default 1200
---@field height? integer pixels, default 900

---@class hinge.panels several plots in one picture
---@field panels hinge.plot[] without width and height
---@field columns? integer panels in a row, default 1; those of a column have their axes in line
---true: the panels of a column have one x axis, which stands below the lowest; an x_range that one of them has holds
---for all, and two that differ are an error; default false
---@field share_x? boolean
---@field title? string above all
---@field width? integer pixels, default 1200; 800 for each of several columns
---@field height? integer pixels, default 160 and 420 for each row; 600 for one row

---One curve, band or group of bars. It has a gap at a value that is no number, or not above 0 on a logarithmic axis.
---Eight colours follow the order of the series: blue, red, green, purple, orange, sky, black, yellow. Readers who are
---colour-blind can tell them apart (Okabe and Ito). The next eight series have them again, dashed.
---@class hinge.series
---@field x number[]|string[] texts are categories, with which each series of the plot may have a part of them
---@field y? number[]|string[] as many as x; not of a band. Texts: bars lie, and x has the numbers
---@field low? number[] of a band: its lower edge
---@field high? number[] of a band: its upper edge
---@field name? string in the legend; default: the series is not in the legend
---line (default), points, both; band: filled from low to high; bars: from 0 to the values, those of several series side
---by side. Default with low and high: band
---@field style? "line"|"points"|"line and points"|"band"|"bars"
---@field dashed? boolean
---one of the names above, grey, "#rrggbb", or { red, green, blue } from 0 to 1; default: by the order
---@field colour? string|number[]
---texts beside the points, placed so that they hide little; those of bars stand at their ends. "" for none
---@field labels? string[]
---true: drawn lighter; its labels are left out where there is no room; default false
---@field faint? boolean

---@class hinge.plot_line a level or upright line, thin and grey
---@field x? number the line is upright, there
---@field y? number the line is level, there
---@field name? string beside it
---@field dashed? boolean default true
---@field colour? string|number[] as of a series

---Prints a line and keeps it in summary.json.
---```lua
---job:note "the tip stays above the floor"
---```
---@param text string
function job:note(text) end

---Sets the verdict of a job of several runs. It is in summary.json, and sets the exit status 0 or 1. Without it the
---verdict is that of the last run, and "failed" if an earlier run failed and the script has never read how it went. If
---a picture or a frame could not be written, such as on a full disk, the job has failed in any case.
---```lua
---local lost = run:count { state = "broken" }
---if lost > 0 then job:verdict("failed", lost .. " members broke") else job:verdict "completed" end
---```
---@param verdict "completed"|"failed"
---@param reason? string why it failed
function job:verdict(verdict, reason) end

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
---beams (section 4.1)
---@field floor_weight? number
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
---lowest (lowest storey with a fracture, 0: none). Energies at the end:
---kinetic, elastic, plastic, fracture, contact, energy_error. brought: momentum of the aircraft.
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

-- require "hinge.paper" -----------------------------------------------------------------------------------------------

---Error measures and figures for the scripts of scripts/paper.
---@class paper
---@field methods string[] "conventional", "asi", "asi-gauss"
---@field drawn integer[] elements a member in the figures' legends: 1, 2, 4, 8, 16
local paper = {}

---Returns the root mean square difference of two histories, divided by the largest value of the second.
---```lua
---local paper = require "hinge.paper"
---print(paper.error({ 0, 1.1, 2 }, { 0, 1, 2 }))
---```
---@param history number[]
---@param reference number[] of the same length
---@return number
function paper.error(history, reference) end

---Returns the curve y over x at equal steps from 0 to `last`. The curve is straight between its points.
---```lua
---local paper = require "hinge.paper"
---local halves = paper.sampled({ 0, 1, 3 }, { 0, 2, 2 }, 3, 6) -- at 0, 0.5, 1 ... 3
---```
---@param x number[] rising
---@param y number[]
---@param last number
---@param count integer number of steps; the result has one value more
---@return number[]
function paper.sampled(x, y, last, count) end

---```lua
---local paper = require "hinge.paper"
---local millimetres = paper.scaled({ 0.001, 0.002 }, 1000)
---```
---@param values number[]
---@param factor number
---@return number[]
function paper.scaled(values, factor) end

---Returns the smallest number of elements from which on the error stays within a limit. If there is none, it is "> "
---and the largest number.
---```lua
---local paper = require "hinge.paper"
---print(paper.needed({ [2] = 0.08, [4] = 0.004, [8] = 0.001 }, 0.01)) -- 4
---```
---@param errors table<integer, number> by number of elements
---@param limit number
---@return integer|string
function paper.needed(errors, limit) end

---Returns an error as text for a table, in per cent. Rounding errors are 0.
---```lua
---local paper = require "hinge.paper"
---print(paper.percent(0.0123)) -- 1.23
---```
---@param error number
---@return string
function paper.percent(error) end

---Draws one picture of a figure, fig<number>_<method>.png: the curves of a method by number of elements, and the
---converged curve dashed.
---```lua
---local paper = require "hinge.paper"
---local line = { x = { 0, 1 }, y = { 0, 1 } }
---paper.figure(job, 9, "asi", { title = "load and sway", x = "m", y = "N" }, { [1] = line, [2] = line }, line)
---```
---@param job hinge.job
---@param number integer of the figure
---@param method string
---@param labels { title: string, x: string, y: string }
---@param curves table<integer, { x: number[], y: number[] }> by elements a member
---@param converged { x: number[], y: number[] }
function paper.figure(job, number, method, labels, curves, converged) end

---time in s; text: the reason without advice
---@alias paper.ended { run: string, time: number, reason: string, text: string }

---Returns the name, time and reason of a run that failed; nil for any other run.
---```lua
---local paper = require "hinge.paper"
---local ended = { paper.ended(run, "cantilever") } -- {}: it did not fail
---```
---@param run hinge.run|impact.result
---@param name string name of this run in the tables
---@return paper.ended?
function paper.ended(run, name) end

---Prints how many runs failed, and the name and reason of each. If there are any, the job notes it.
---```lua
---local paper = require "hinge.paper"
---paper.show_ended(job, { paper.ended(run, "cantilever") }, 1)
---```
---@param job hinge.job
---@param ended paper.ended[]
---@param of integer number of all runs
function paper.show_ended(job, ended, of) end

---Prints a table: rows of numbers and texts under a head. Numbers that need a format are given as text.
---```lua
---local paper = require "hinge.paper"
---paper.table("Sway", { "elements", "mm" }, { { 2, "3.11" }, { 4, "3.12" } })
---```
---@param title string
---@param head string[]
---@param rows any[][]
function paper.table(title, head, rows) end

---positions in m, mass in kg; virtual: the free end of a fractured element; gone: a node that has lost all its elements
---@alias paper.node { x: number, y: number, z: number, mass: number, virtual: boolean, gone: boolean }
---a, b: indices into nodes; rigid: fractured
---@alias paper.bar { a: integer, b: integer, member: integer, element: integer, rigid: boolean, f_y: number }

---Returns the structure as in pictures (figures 4 and 5). Fractured elements are rigid bars from the node that carries
---them to a virtual node. Each node has a mass: half of the mass of each intact element at it, and the whole mass of
---each fractured element that it carries.
---```lua
---local paper = require "hinge.paper"
---for _, node in ipairs(paper.pieces(run).nodes) do print(node.x, node.mass) end
---```
---@param run hinge.run
---@return { nodes: paper.node[], bars: paper.bar[] }
function paper.pieces(run) end

-- require "hinge.report" ----------------------------------------------------------------------------------------------

---@class report.counts
---@field members integer
---@field elastic integer
---@field yielded integer
---@field broken integer
---@field touched integer

---@alias report.damage table<string, report.counts> by group

---@class report
local report = {}

---Returns the damage of the members by group; see run:count.
---```lua
---local report = require "hinge.report"
---print(report.damage(run, { "arm" }).arm.yielded)
---```
---@param run hinge.run
---@param groups string[]
---@return report.damage
function report.damage(run, groups) end

---Prints the damage by group, the energy balance and the wall time by stage. Returns the damage.
---```lua
---local report = require "hinge.report"
---report.show(run, { "arm" })
---```
---@param run hinge.run
---@param groups string[]
---@return report.damage
function report.show(run, groups) end
