-- Scenes for tests/hard/within.lua: those of random_scenes.lua, as scenarios of a user who asks for an accuracy. They
-- are small, have time steps that a user would write, and return two to four numbers.
--
-- A sixth of the scenes has semi-rigid joints, a tenth hardening or strain rate, a quarter another interaction. Limits
-- of fracture are hinge rotations and elongation, which converge with the elements; one in five has what was drawn,
-- most of which goes with the length of the elements.
local hinge = require "hinge"
local core = require "hinge.core"
local random = require "random_scenes"
local support = require "support"
local vectors = require "hinge.library.vectors"
local within_scenes = {}

local most_elements = 48  -- of two a member: larger structures are left out of the population
local updates = 2500      -- elements times steps of the script's own run, about
local few, many = 50, 300 -- steps of a run
-- Differences that do not matter: 0.05 mm, 10 J.
local least = { peak_mm = 0.05, end_mm = 0.05, plastic_kJ = 0.01, kinetic_kJ = 0.01 }
local longer = 4          -- times as many where something flies, so that it hits and bounces
local others_from = 216   -- from this seed on, scripts begin with two or four elements a member, before that with two

local flies = { ["struck frame"] = true, fall = true, bin = true }

-- The largest of 1, 2, 5 times a power of 10 that is not above x.
local function round(x)
  local power = 10.0 ^ math.floor(math.log(x, 10) + 1e-9)
  return (x >= 5 * power and 5 or x >= 2 * power and 2 or 1) * power
end

-- Joints of a stiffness and a strength between those of a nominal pin and of a rigid end.
local function joints_of(d)
  if not d.chance(0.17) then return nil end
  local stiffness, strength, which = d.log(1, 30), d.number(0.4, 1.2), d.pick { "a", "b", "both" }
  return function(a, b, o)
    if not (math.abs(a.z - b.z) < 1e-6) then return nil end -- beams have them
    local length = vectors.length(vectors.minus(vectors.of_node(b), vectors.of_node(a)))
    local s, fy = o.section, o.material.yield_stress
    local joint = hinge.joint { My = "rigid", Mx = { stiffness = stiffness * o.material.E * s.Ix / length,
      strength = fy and fy < math.huge and fy > 0 and strength * fy * s.Zx or nil } }
    return { a = which ~= "b" and joint or nil, b = which ~= "a" and joint or nil }
  end
end

-- The library with materials that yield at a part of the stress for which the loads were drawn, so that more scenes
-- yield, and that may harden or depend on the rate.
local function laws_of(d, words)
  local part = d.pick { 1, 0.6, 0.4, 0.25 }
  local what = d.weighted { { 90, false }, { 4, "hardening" }, { 3, "mixed" }, { 3, "rate" } }
  words[1] = ("%g of the yield stress"):format(part)
  if what then words[2] = "material with " .. (what == "mixed" and "mixed hardening" or what) end
  local tangent = d.log(5e8, 5e9)
  return setmetatable({ material = function(o)
    local all = {}
    for k, v in pairs(o) do all[k] = v end
    if o.yield_stress then
      all.yield_stress = part * o.yield_stress
      if what == "rate" then all.rate = { D = 40.4, q = 5 }
      elseif what then all.hardening = { tangent = tangent, kinematic = what == "mixed" and 0.5 or 1 } end
    end
    return hinge.material(all)
  end }, { __index = hinge })
end

-- Options of the run: a step that a user would write, and so many of them that the scene stays small. One in eight
-- leaves the step to hinge, a sixth takes explicit steps.
local function plan_of(seed, class, keep)
  return function(s)
    local d = random.draws(seed, 4)
    local setting = d.weighted { { 70, "dt" }, { 13, "auto" }, { 17, "explicit" } }
    local each = updates / support.largest_of(10, s.elements)
    local steps = math.floor(support.largest_of(few, support.smallest_of(many, each)))
    local options = {}
    local step
    if flies[class] then steps = longer * steps end
    if setting == "dt" then
      -- nothing flies farther in a step than 8 mm
      if flies[class] or s.speed > 1 and class ~= "pressed column" then
        step = round(math.min(5e-4, d.log(3e-3, 8e-3) / s.speed))
      else step = d.pick(class == "pressed column" and { 5e-5, 1e-4, 2e-4 } or { 5e-4, 1e-3, 2e-3, 5e-3 }) end
      options.dt = step
    else
      options.dt, steps = "auto", 3 * steps
      step = s.wave / (setting == "explicit" and 2 or s.contact and 12 or 4)
      if setting == "explicit" then options.integrator = "explicit" end
    end
    options.duration = steps * step
    keep.s, keep.words = s, ("%s, dt %s for %.3g s"):format(setting, options.dt, options.duration)
    return options
  end
end

local function displacement(node, run)
  local x, y, z = node:displacement(run)
  return math.sqrt(x * x + y * y + z * z)
end

-- The numbers that a scene returns, and what has to be watched for them: peak and last displacement of a node, in mm,
-- plastic work and kinetic energy in kJ, members that broke.
local function answers_of(seed, s, run)
  local d = random.draws(seed, 5)
  local nodes = #s.joints > 0 and s.joints or {}
  local candidates = {}
  for _, node in ipairs(nodes) do
    if not node.fixed or node.fixed == "y,rx,rz" then candidates[#candidates + 1] = node end
  end
  local node = #candidates > 0 and d.pick(candidates) or s.members[#s.members].b
  local peak = 0
  run:on_step(function(r) peak = support.largest_of(peak, displacement(node, r)) end)
  return function()
    return { peak_mm = 1e3 * peak, plastic_kJ = run.energy.plastic / 1e3, end_mm = 1e3 * displacement(node, run),
      broken_members = #core.facts(run).broken, kinetic_kJ = run.energy.kinetic / 1e3 }
  end
end

-- The answers that count: peak and plastic work always, the others in a part of the scenes.
local function wanted_of(seed, breaks)
  local d = random.draws(seed, 6)
  local wanted = { peak_mm = least.peak_mm, plastic_kJ = least.plastic_kJ }
  local wants_end, wants_kinetic = d.chance(0.4), d.chance(0.5)
  if wants_end then wanted.end_mm = least.end_mm end
  if breaks then wanted[1] = "broken_members" elseif wants_kinetic then wanted.kinetic_kJ = least.kinetic_kJ end
  return wanted
end

local function has_fracture(words)
  for _, word in ipairs(words) do
    if word:find "^fracture" then return true end
  end
  return false
end

--- The scene of a seed: seed, class, words (complete after a run), scenario; nil where its structure is too large or
-- cannot be made.
function within_scenes.scene(seed)
  local scene = random.scene(seed)
  local d = random.draws(seed, 3)
  local laws = {}
  local library = laws_of(d, laws)
  local interaction = d.weighted { { 75, false }, { 15, "paper" }, { 10, "exact with shear" } } or nil
  local keep = {}
  local ends = joints_of(d)
  local each = seed < others_from and 2 or random.draws(seed, 8).pick { 2, 4 }
  local changed = { elements_per_member = each, interaction = interaction, ends = ends,
    plan = plan_of(seed, scene.class, keep) }
  if not d.chance(0.2) then changed.fracture = "hinges" end
  local function run()
    for i = #scene.words, 1, -1 do scene.words[i] = nil end
    local model, options = scene.make(library, changed)
    local s = keep.s
    for _, word in ipairs(laws) do scene.words[#scene.words + 1] = word end
    if interaction then scene.words[#scene.words + 1] = "interaction " .. interaction end
    if ends then scene.words[#scene.words + 1] = "joints" end
    scene.words[#scene.words + 1] = keep.words
    local r = model:dynamic(options)
    local result = answers_of(seed, s, r)
    r:finish()
    return result()
  end
  local ok = pcall(function()
    -- What it is made of is known once it has been made; a run that is only planned costs nothing.
    scene.make(library, changed)
  end)
  if not ok or not keep.s or 2 * keep.s.elements > each * most_elements then return nil end
  local wanted = wanted_of(seed, has_fracture(scene.words))
  return { seed = seed, class = scene.class, words = scene.words, least = least,
    scenario = hinge.scenario { run = run, answers = wanted } }
end

return within_scenes
