---@meta
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
