---@meta
-- Ground motion -------------------------------------------------------------------------------------------------------

---@class hinge
local hinge = {}

---Returns the displacement of the ground, m, as a function of time, s, from a record of its acceleration. The
---acceleration is linear between the values of the record, and is integrated twice exactly. The displacement is zero
---before the record starts. After its end it goes on with constant velocity. The function is for model:move.
---```lua
---local quake = hinge.ground { dt = 0.02, acceleration = { 0, 1.2, -0.8, 0.3, 0 }, scale = 0.5 } -- m/s^2
---model:move { node = wall, y = quake }
---```
---@param options { dt: number, acceleration: number[], scale?: number }
---  dt s; acceleration m/s^2, the first at t = 0; scale default 1
---@return fun(time: number): number
function hinge.ground(options) end

---Ground motion from files.
---@class hinge.records
local record = {}

---Reads one component of ground motion from a file of PEER, ESM, K-NET or KiK-net, or from columns of numbers. The
---values become m/s^2. Then they are cut (`from`, `to`), the baseline is taken off, and they are scaled, in this order.
---An error names the line of the file that is wrong: a word among the numbers, a value that is not finite, another
---unit, a number of values that differs from the header's.
---```lua
---local path = os.tmpname()
---local file = assert(io.open(path, "w"))
---file:write "# time s, acceleration g\n0.00 0\n0.02 0.1\n0.04 -0.15\n0.06 0.05\n0.08 0\n"
---file:close()
---local quake = hinge.record.read { file = path, unit = "g", peak = 2.5, baseline = "constant" } -- m/s^2
---os.remove(path)
---print(quake.name, quake.dt, quake.duration, quake.peak)
---model:move { node = wall, y = quake.displacement }
---```
---@param options hinge.record_options
---@return hinge.ground_record
function record.read(options) end

---@class hinge.record_options
---@field file string path, from the folder where the program was started
---"PEER AT2": in g, taken as 9.80665 m/s^2; the fourth line is `NPTS=  n, DT= dt SEC` or `n dt NPTS, DT`. "ESM": header
---of lines `KEY: value`, then cm/s^2. "K-NET", also for KiK-net: counts, with the factor to gal in the header; the mean
---of the file is taken off. "columns": one column of accelerations, or two of times and accelerations, with blanks,
---commas or tabs between; lines that begin with # are left out, and so are lines that begin with a letter before the
---first number. Default: found out from the text; columns if it is none of the others and `unit` is given
---@field format? "PEER AT2"|"ESM"|"K-NET"|"columns"
---unit of columns, which must have it; the other formats say theirs themselves
---@field unit? "m/s^2"|"g"|"cm/s^2"
---@field dt? number s, time step; for one column, which must have it. Two columns must have times at equal steps
---s, after the first value: where the cut begins. Default 0
---@field from? number
---s, after the first value: where the cut ends. Default: the last value
---@field to? number
---polynomial of the time that is taken off the acceleration: of degree 0, 1 or 2. Its coefficients make the velocity at
---the end 0, and with that the sum of the squares of the velocities at all values as small as it can be. The one
---coefficient of "constant" does the first alone. The velocity begins at 0, and the acceleration is straight between
---its values. Default "none"
---@field baseline? "none"|"constant"|"linear"|"quadratic"
---@field scale? number factor; default 1
---@field peak? number m/s^2, above 0: largest absolute value that the record is scaled to; in place of `scale`

---One component of ground motion, after the cut, the baseline and the factor.
---@class hinge.ground_record
---@field dt number s, time step
---@field acceleration number[] m/s^2, the first at t = 0
---displacement of the ground, m, at a time, s, as hinge.ground makes it: for model:move
---@field displacement fun(time: number): number
---@field peak number m/s^2, largest absolute value
---@field duration number s, from the first value to the last
---@field end_velocity number m/s, at the end of the record; the ground goes on with it
---@field end_displacement number m, at the end of the record
---@field name string of PEER the second line; of ESM event, station and stream; else station or file
---@field format "PEER AT2"|"ESM"|"K-NET"|"columns" what the file was read as

---Returns an elastic response spectrum: the largest responses of oscillators of one mass on ground with this
---acceleration. The acceleration is straight between its values, and the oscillators are integrated exactly (Nigam and
---Jennings 1969), with peaks between steps to 1e-5. They begin at rest. After the last value the ground is not
---accelerated, and one period of free vibration counts as well. The accelerations may be those of a run's probe, for
---what stands on a floor; the probe must be without relative_to. Periods of less than two time steps are beyond what
---the values know: the straight lines decide there.
---```lua
---local s = hinge.spectrum { dt = 0.02, acceleration = { 0, 1.2, -0.8, 0.3, 0 }, periods = { 0.1, 0.5, 1 } } -- m/s^2
---print(s.periods[2], s.displacement[2], s.acceleration[2]) -- s, m, m/s^2
---
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }
---local az = swing:probe { node = tip, "az" }
---swing:finish()
---local on_tip = hinge.spectrum { time = az.time, acceleration = az.value, damping = 0.02 }
---hinge.plot({ series = { { x = on_tip.periods, y = on_tip.acceleration } }, log_x = true, x_label = "s",
---  y_label = "m/s^2" }, "spectrum.png")
---```
---@param options hinge.spectrum_options
---@return hinge.response_spectrum
function hinge.spectrum(options) end

---@class hinge.spectrum_options
---@field acceleration number[] m/s^2, two or more
---@field dt? number s, time step; one of dt and time
---@field time? number[] s, as many as accelerations, ascending; the steps need not be equal
---s, at least 1/1000 of the longest time step. Default: 100 from 0.02 to 4 s, at equal steps of the logarithm
---@field periods? number[]
---@field damping? number part of critical damping, 0 or above and below 1; default 0.05

---Lists of as many values as periods.
---@class hinge.response_spectrum
---@field periods number[] s
---@field displacement number[] m, largest displacement against the ground
---@field velocity number[] m/s, pseudo velocity: 2 pi / period * displacement
---@field acceleration number[] m/s^2, pseudo acceleration: (2 pi / period)^2 * displacement
---@field absolute_acceleration number[] m/s^2, largest acceleration in space
---@field damping number part of critical damping
