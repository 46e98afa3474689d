-- Runs of a scene, and how their answers are compared: what the relations of relation_list.lua share.
local built = require "relation_model"
local support = require "support"
local with = require "scenes".with
local runs = { steps = 100 } -- steps: of a dynamic run

local function has(s, ...)
  for _, kind in ipairs { ... } do
    for _, part in ipairs(s.parts) do if part.kind == kind then return true end end
  end
  return false
end
local function elastic(s) return not s.yields and not has(s, "remove", "contact", "ground", "fracture") end
-- The largest of a and b; NaN counts as infinite.
local function worse(a, b) return b ~= b and math.huge or b > a and b or a end

-- Runs --------------------------------------------------------------------------------------------------------------

local function static(hinge, s, way, more)
  local b = built.make(hinge, s, way)
  return b, b.model:static(with({ steps = 4, tolerance = 1e-11, record = false }, more)):finish()
end
-- Steps of the length in which a wave crosses a member: a tenth of what a portal takes to sway.
local function dynamic_options(s)
  local shortest = math.huge
  for _, member in ipairs(s.members) do shortest = support.smallest_of(shortest, member.length) end
  local dt = (s.class == "collision" and 0.02 or 0.5) * shortest / 5100
  return { dt = dt, duration = (s.class == "collision" and 4 or 1) * runs.steps * dt, precision = "double",
    internals = { solver_tolerance = 1e-12 }, record = false, energy_tolerance = 0, step_control = s.step_control }
end
local function dynamic(hinge, s, way, more)
  local b = built.make(hinge, s, way)
  local o = with(dynamic_options(s), more)
  if o.integrator == "explicit" then o.precision, o.internals = nil, nil end
  return b, b.model:dynamic(o), o
end
local function run_of(hinge, s, way, more)
  if s.mode == "static" then return static(hinge, s, way, more) end
  local b, run = dynamic(hinge, s, way, more)
  return b, run:finish()
end

-- The largest difference of two answers over their largest values, by groups of numbers. `limit`: its tolerance.
local groups = { "u", "rotation", "force", "moment", "reaction" }
local function compare(a, c, limit)
  if a.verdict ~= c.verdict then
    return math.huge, ("%s, and %s: %s"):format(a.verdict, c.verdict, (a.reason .. c.reason):sub(1, 160))
  end
  if a.verdict ~= "completed" then return nil, "the run fails: " .. a.reason:sub(1, 160) end
  local most, what, sizes = 0, "", {}
  for _, name in ipairs(groups) do
    sizes[name] = 0
    for _, of in ipairs { a, c } do
      for _, v in ipairs(of[name]) do sizes[name] = worse(sizes[name], math.abs(v)) end
    end
  end
  -- rotations are as large as displacements over a length, moments as forces times one
  -- and what is less than a micrometre or a newton is rounding
  local u, f = worse(worse(sizes.u, sizes.rotation * a.size), 1e-6), worse(worse(sizes.force, sizes.moment / a.size), 1)
  f = worse(worse(f, sizes.reaction), a.floor)
  local size = { u = u, rotation = u / a.size, force = f, moment = f * a.size, reaction = f }
  for _, name in ipairs(groups) do
    for i, v in ipairs(a[name]) do
      local off = math.abs(v - c[name][i])
      if off ~= 0 then off = off / (size[name] * limit) end
      if not (off <= most) then
        most, what = worse(most, off), ("%s %d: %.9g and %.9g"):format(name, i, v, c[name][i])
      end
    end
  end
  return most, what
end

-- Rounding and what the iterations leave, 1e-11, grow by a structure's own sensitivity, which is some 1e3; where it
-- yields, returns end at 1e-9 as well. Events (a hinge, a contact, a break) move by a step where rounding decides.
-- Bars that have parted carry next to nothing: their forces are compared with 1e-6 of E A (`floor` of built.answer).
local function told_tolerance(s)
  if s.mode == "static" then return s.yields and 1e-5 or 1e-6 end
  return (s.yields or has(s, "contact", "ground", "remove", "fracture")) and 1e-4 or 1e-6
end
-- What the scene answers when it is told in another way. Where numbers changed by 1e-9 move it beyond the tolerance, or
-- nearly as far, the scene is chaotic, such as braces that buckle, and the relation says nothing.
local known = {} -- the scene as it is, which several relations ask
local answer_of
function answer_of(hinge, s, changes)
  if not changes then
    if known.scene ~= s then known.scene, known.answer = s, answer_of(hinge, s, {}) end
    return known.answer
  end
  local b, run = run_of(hinge, s, built.way(changes))
  local answer = built.answer(b, run)
  b.model:close()
  return answer
end
local function unless_chaotic(hinge, s, a, limit, off, what)
  if not off or off <= 1 then return off, what end
  local moved = compare(a, answer_of(hinge, s, { stiffer = 1 + 1e-9 }), limit)
  if moved and (moved > 1 or moved > 0.01 * off) then return nil, "chaotic" end
  return off, what
end

runs.zero = { 0, 0, 0 }
--- Draws of a relation, which belong to the seed and to a number.
function runs.chance(s, salt) return require("random_scenes").draws(s.seed, salt) end
runs.has, runs.elastic, runs.worse, runs.static, runs.dynamic = has, elastic, worse, static, dynamic
runs.compare, runs.answer_of, runs.unless_chaotic = compare, answer_of, unless_chaotic
runs.told_tolerance, runs.dynamic_options = told_tolerance, dynamic_options
return runs
