-- The description of a frame: offsets of member ends, and loads over a part of a member.
--
-- Run: lua5.4 tests/script/import/import_ends_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local import = require "hinge.import"
local checks = support.checks "ends in imported frames"
local case, near, expect = checks.case, checks.near, checks.expect

local folder = support.temporary_folder() .. "/"
local options = { model = { displacement = "small" } }
local W, H = 7.32, 3.66
local dx, dz = 0.18, -0.23

-- A portal whose beam has rigid ends and hangs below its nodes.
local function portal(release)
  return {
    nodes = { { name = "1", x = 0, y = 0, z = 0, fix = "all" }, { name = "2", x = W, y = 0, z = 0, fix = "all" },
      { name = "3", x = 0, y = 0, z = H }, { name = "4", x = W, y = 0, z = H } },
    materials = { { name = "S", E = 2e11, nu = 0.3, density = 7850 } },
    sections = { { name = "column", named = "W14X145" }, { name = "beam", named = "W18X50" } },
    members = { { name = "c1", a = "1", b = "3", section = "column", material = "S", up = { 1, 0, 0 } },
      { name = "c2", a = "2", b = "4", section = "column", material = "S", up = { 1, 0, 0 } },
      { name = "beam", a = "3", b = "4", section = "beam", material = "S", release = release,
        offset = { a = { dx, 0, dz }, b = { -dx, 0, dz } } } },
    masses = {},
    cases = { { name = "wind", loads = { { node = "3", force = { 1e5, 0, 0 } } } } },
  }
end

-- The same by rigid links. dofs: of the link at the beam's first end.
local function by_hand(dofs)
  local model = hinge.model(options.model)
  local steel = hinge.material { E = 2e11, nu = 0.3, density = 7850 }
  local column, beam = hinge.section.named "W14X145", hinge.section.named "W18X50"
  local head, ends = {}, {}
  for i = 0, 1 do
    local foot = model:node { W * i, 0, 0 }
    head[i], ends[i] = model:node { W * i, 0, H }, model:node { i == 0 and dx or W - dx, 0, H + dz }
    model:fix(foot)
    model:member { foot, head[i], section = column, material = steel, up = { 1, 0, 0 } }
  end
  model:member { ends[0], ends[1], section = beam, material = steel }
  model:rigid_link { from = head[0], to = ends[0], dofs = dofs }
  model:rigid_link { from = head[1], to = ends[1] }
  if dofs then -- torsion stays
    model:connector { head[0], ends[0], axes = { x = { 0, -1, 0 }, y = { 0, 0, 1 } },
      stiffness = { rz = 1000 * 2e11 / 2.6 * beam.J / (W - 2 * dx) } }
  end
  model:load { node = head[0], force = { 1e5, 0, 0 } }
  return head[0]:displacement(model:static { steps = 1 }:finish())
end

local function sway(model, nodes)
  return (nodes["3"]:displacement(model:static { steps = 1, loads = { wind = 1 } }:finish()))
end

case("offsets of a beam: as by rigid links, also released, built and written", function()
  for name, end_ in pairs { rigid = {}, pinned = { release = { a = "rx,ry" }, dofs = "xyz" } } do
    local right = by_hand(end_.dofs)
    -- the rounding of the solution
    near(sway(import.build(portal(end_.release), options)) / right, 1, 1e-9, name .. ": sway")
    local file = folder .. name .. ".lua"
    import.write(portal(end_.release), file, options)
    near(sway(dofile(file)) / right, 1, 1e-9, name .. ": sway of the written script")
  end
end)

case("the length of a member is that between its ends", function()
  local frame = portal()
  local summary = require "hinge.import.frame".summary(frame)
  near(summary.length, 2 * H + W - 2 * dx, 1e-12, "length of all members")
end)

case("offsets and spread loads that cannot be are refused", function()
  local function refused(change, words)
    local frame = portal()
    change(frame)
    local ok, message = pcall(import.build, frame, options)
    expect(not ok and tostring(message):find(words, 1, true), "'%s' for: %s", message, words)
  end
  local function load(frame, given)
    given.member = "beam"
    frame.cases[1].loads = { given }
  end
  refused(function(f) f.members[3].offset = { c = { 0, 0, 0 } } end, "offset: unknown end 'c'")
  refused(function(f) f.members[3].offset = { a = { 0, 0 } } end, "offset.a")
  refused(function(f) f.members[3].offset = { a = { W, 0, 0 } } end, "its two ends are at one place")
  refused(function(f) load(f, { q = { a = { 0, 0 } } }) end, "q.a")
  refused(function(f) load(f, { q = { 0, 0, -1 }, from = 0.5, to = 0.5 }) end, "the load needs a length")
  refused(function(f) load(f, { force = { 0, 0, -1 }, from = 0.5 }) end, "'from' and 'to' are for 'q'")
  refused(function(f) load(f, { q = { 0, 0, -1 }, to = 1.5 }) end, "to")
end)

checks.done()
