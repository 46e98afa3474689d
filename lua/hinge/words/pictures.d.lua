---@meta
-- Pictures, plots and frames without a job ----------------------------------------------------------------------------

---@class hinge
local hinge = {}

---hinge.frame, hinge.animate, hinge.picture, hinge.strip, hinge.plot and hinge.note do the same as job:frame,
---job:animate, job:picture, job:strip, job:plot and job:note. They are for scripts of plain statements and for any Lua
---5.4. The output folder is that of `hinge run`, else the folder where Lua was started.
---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }
---for step in swing:steps() do
---  if step.index % 50 == 0 then hinge.frame(swing) end
---end
---```
---@param run hinge.run
function hinge.frame(run) end

---See job:animate.
---```lua
---hinge.animate(model:static():finish():modes { n = 1 }[1], { frames = 8 })
---```
---@param mode hinge.mode
---@param options? { frames?: integer, amplitude?: number }
function hinge.animate(mode, options) end

---```lua
---hinge.picture(run, { title = "under 1 kN", width = 800, height = 600 }, "cantilever.png")
---hinge.picture(run, { scale = 50, ghost = true, supports = true, loads = true, show = "Mx", view = "front",
---  labels = true }) -- picture.png
---```
---@param run hinge.run see job:picture
---@param view? hinge.view
---@param filename? string plain name ending in .png; default picture.png, then picture-2.png and so on
function hinge.picture(run, view, filename) end

---```lua
---hinge.strip({ { run, { title = "all" } }, { run, { groups = { "arm" } } } }, 2, "side_by_side.png")
---```
---@param snapshots { [1]: hinge.run|hinge.snapshot, [2]?: hinge.view }[] see job:strip
---@param columns integer snapshots in a row
---@param filename string plain name ending in .png
function hinge.strip(snapshots, columns, filename) end

---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }
---local sag = swing:probe { node = tip, "uz" }
---swing:finish()
---hinge.plot(swing, "swing.png") -- its energies and the sag over time
---hinge.plot(swing, { "kinetic", "elastic", sag, title = "swing" }, "swing.svg")
---hinge.plot({ series = { { x = sag.time, y = sag.value } }, x_label = "s", y_label = "m" }, "sag.png")
---```
---@overload fun(what: hinge.plot|hinge.panels|hinge.run|string, filename: string)
---@param what hinge.plot|hinge.panels|hinge.run|string see job:plot
---@param choice? hinge.history only with a run or its folder: what of it
---@param filename string plain name ending in .png, .svg or .pdf
function hinge.plot(what, choice, filename) end

---```lua
---hinge.note(("the tip is at z = %.4f m"):format(select(3, tip:position())))
---```
---@param text string it is printed, and kept in summary.json
function hinge.note(text) end
