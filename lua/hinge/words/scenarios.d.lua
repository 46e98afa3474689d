---@meta
-- Scenarios and their jobs --------------------------------------------------------------------------------------------

---@class hinge
local hinge = {}

---Makes a scenario: parameters, cases and a function to run. A script returns it to the program. A script may also be
---plain statements. It then gets the settings key=value of the command line in a table, `...`, and its return value is
---its results. A setting that such a script does not read is an error. The error comes before the script runs if its
---text shows it (local p = ..., then p.speed), else at its end. Plain Lua does not run a scenario that a script
---returns. This is an error there, which says how to run it.
---```lua
---return hinge.scenario {
---  parameters = { force = 1000 }, -- N; hinge run SCRIPT force=2000
---  cases = { heavy = { force = 3000 } }, -- hinge run SCRIPT --case heavy
---  run = function(p, job)
---    model:load { node = tip, force = { 0, 0, -p.force } }
---    local pushed = model:static():finish()
---    job:picture(pushed, { title = "pushed" }, "pushed.png")
---    return { tip_mm = 1000 * select(3, tip:displacement(pushed)) }
---  end,
---}
---```
---@param options hinge.scenario_options
---@return hinge.scenario
function hinge.scenario(options) end

---@class hinge.scenario_options
---names and defaults (numbers, strings, booleans, lists of numbers). `key=value` changes them; a number may be a sum
---such as 440/3.6
---@field parameters? table<string, any>
---@field cases? table<string, table> named sets of changes for --case
---settings of accuracy against computing time: each is a list whose first item is the default
---@field accuracy? table<string, any[]>
---named functions for `hinge study --propose NAME`: each gets the cases that have ended and returns the parameters of
---the next, as `propose` of hinge.study
---@field proposals? table<string, fun(cases: hinge.study_case[]): table|nil>
---what a study of the scenario varies, as `vary` of hinge.study. `hinge study SCRIPT` and hinge.study take it for the
---names for which they get nothing else; with proposals it has no effect
---@field vary? table<string, any>
---names of the answers that count for `hinge run SCRIPT --within 2%`: numbers that run returns, by name ("tip_mm",
---"damage.columns"), or probes, whose histories count. Default: all numbers that run returns, but for those with
---"energy_error" in their name; where there are none, all probes. A name that there is not is an error of that command.
---{ "tip_mm", plastic_kJ = 0.1 }: an error of 0.1, in the answer's own unit and above 0, is accepted as well
---@field answers? table<integer|string, string|number>
---@field run fun(p: table, job: hinge.job): any returns the results kept in summary.json

---@class hinge.scenario

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
---@field floors? boolean the panels of model:floor, default true
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
---@field low? number[] of a band: its lower edge; of points: the lower end of an upright bar through each
---@field high? number[] of a band: its upper edge; of points: the upper end of the bar
---in the legend; default: the series is not in the legend. With x = { false }, y = { false } it stands there alone
---@field name? string
---line (default), points, both; band: filled from low to high; bars: from 0 to the values, those of several series side
---by side. Default with low and high: band
---@field style? "line"|"points"|"line and points"|"band"|"bars"
---@field dashed? boolean
---of points, by which series are told in a picture without colours; default circle
---@field mark? "circle"|"square"|"triangle"|"diamond"|"open circle"|"open square"|"open triangle"|"open diamond"
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
