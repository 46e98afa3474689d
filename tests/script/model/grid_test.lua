-- hinge.grid: names of places, columns, beams, braces, lines, defaults, copies and mirror images; the same
-- frame by hand; wrong input is refused.
--
-- Run: lua5.4 tests/script/model/grid_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local checks = support.checks "grid"
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect

local steel = hinge.material.steel "S355"
local column, beam = hinge.section.named "HEB 200", hinge.section.named "IPE 300"

local function new(options)
  local model = hinge.model(options and options.model or {})
  return hinge.grid { model = model, x = { 0, 6, 13 }, y = { 0, 5 }, z = { 0, 4, 7.5 } }, model
end

case("places have names", function()
  local grid, model = new()
  equal(table.concat(grid:lines(), " "), "A1 A2 B1 B2 C1 C2", "lines")
  local node = grid:node("B2", 1)
  near(node.x, 6, 0, "x")
  near(node.y, 5, 0, "y")
  near(node.z, 4, 0, "z")
  expect(grid:node "b2, storey 1" == node, "the whole name, in small letters")
  near(grid:node("C1, base").z, 0, 0, "the base")
  equal(grid:name(node), "B2, storey 1", "the name of a node")
  equal(grid:name(grid:node("A1", 0)), "A1, base", "the name at the base")
  equal(#model:nodes(), 18, "nodes")
  local wide = hinge.grid { model = hinge.model(), x = { count = 27, spacing = 2, from = 1 }, z = { 0, 3 } }
  near(wide:node("AB1", 1).x, 55, 1e-12, "the line after Z is AA")
end)

case("a frame by the grid is the frame by hand", function()
  local grid, model = new()
  grid:fix "all"
  grid:defaults { material = steel, up = { 0, 0, 1 } }
  grid:defaults { group = "columns", section = column, up = { 1, 0, 0 } }
  equal(#grid:columns { group = "columns" }, 12, "columns")
  equal(#grid:beams { along = "x", section = beam, group = "beams" }, 8, "beams along x")
  equal(#grid:beams { along = "y", section = beam, at = { "A", "C" } }, 4, "beams along y, on two lines")
  equal(#grid:braces { from = "A1", to = "B1", shape = "X", storeys = { 1 }, section = beam }, 2, "braces")
  model:load { node = grid:node("C2", 2), force = { 1e4, 2e4, 0 } }
  model:gravity { 0, 0, -9.81 }
  local run = model:static { steps = 1 }:finish()

  local by_hand = hinge.model {}
  local n, x, y, z = {}, { 0, 6, 13 }, { 0, 5 }, { 0, 4, 7.5 }
  local function add(a, b, section, up) by_hand:member { n[a], n[b], section = section, material = steel, up = up } end
  for k = 1, 3 do
    for i = 1, 3 do
      for j = 1, 2 do
        local here = i .. j .. k
        n[here] = by_hand:node { x[i], y[j], z[k] }
        if k == 1 then by_hand:fix(n[here], "all") else add(i .. j .. k - 1, here, column, { 1, 0, 0 }) end
        if k > 1 and i > 1 then add(i - 1 .. j .. k, here, beam, { 0, 0, 1 }) end
        if k > 1 and j == 2 and i ~= 2 then add(i .. 1 .. k, here, beam, { 0, 0, 1 }) end
      end
    end
  end
  add("111", "212", beam, { 0, 0, 1 })
  add("211", "112", beam, { 0, 0, 1 })
  by_hand:load { node = n["323"], force = { 1e4, 2e4, 0 } }
  by_hand:gravity { 0, 0, -9.81 }
  local other = by_hand:static { steps = 1 }:finish()
  for i = 1, 6 do
    local a = select(i, grid:node("C2", 2):displacement(run))
    local b = select(i, n["323"]:displacement(other))
    near(a, b, 1e-9 * math.abs(b) + 1e-15, "component " .. i)
  end
end)

case("model:defaults and model:line: as grid:defaults and grid:line, without a grid", function()
  local model = hinge.model()
  local joint = hinge.joint { Mx = "free" }
  model:defaults { material = steel, section = beam }
  model:defaults { group = "posts", section = column, elements = 4, release = { a = "Mx" } }
  local n = {}
  for i = 1, 4 do n[i] = model:node { 3 * i, 0, i % 2 } end
  local posts = model:line { n[1], n[2], n[3], group = { "posts", "all" } }
  equal(#posts, 2, "members of a line")
  equal(posts[2].b.index, 3, "its last node")
  equal(posts[1].section, column, "section of the group")
  equal(posts[1].material, steel, "material of all")
  equal(posts[1].elements, 4, "elements of the group")
  equal(tostring(posts[1].ends.a), tostring(joint), "release of the group")
  equal(#posts[1]:groups(), 2, "groups")
  local other = model:member { n[3], n[4], group = "posts", section = beam, ends = { b = joint } }
  equal(other.section, beam, "its own section goes before")
  equal(other.ends.a, nil, "its own joints go before the release of the group")
  equal(model:member({ n[1], n[4] }).section, beam, "section of all")
  model:defaults { section = column }
  checks.refused("field 'material' is missing", model.member, model, { n[2], n[4] }) -- its default was replaced
  -- a grid of the same model takes what is left out from its own defaults, then from the model's
  model:defaults { section = column, material = steel }
  local grid = hinge.grid { model = model, x = { 0, 5 }, y = { 9 }, z = { 0, 3 } }
  grid:defaults { elements = 8 }
  local made = grid:columns({})[1]
  equal(made.section, column, "section of the model's defaults")
  equal(made.elements, 8, "elements of the grid's")
  local members, groups = #model:members(), #model:groups()
  for _, wrong in ipairs {
    { function() model:line { n[1] } end, "1 node is given; it needs two or more" },
    { function() model:line { n[1], n[2], n[2], group = "new" } end, "joins node 2 to itself" },
    { function() model:line { n[1], n[2], "n" } end, "node [3] is 'n'" },
    { function() model:line { n[1], n[2], n[3], up = { 3, 0, 1 } } end, "parallel to the member" },
    { function() model:defaults { group = 3 } end, "must be a name" },
    { function() model:defaults { ends = {}, release = { a = "Mx" } } end, "given beside 'ends'" },
  } do
    checks.refused(wrong[2], wrong[1])
  end
  equal(#model:members(), members, "members after what was refused")
  equal(#model:groups(), groups, "groups after it")
end)

case("defaults of a group go before those of all, and what a call gives before both", function()
  local grid = new()
  grid:defaults { section = beam, material = steel, elements = 4 }
  grid:defaults { group = "stout", section = column }
  local a = grid:columns { at = { "A1" }, storeys = { 2 }, group = "stout" }[1]
  equal(a.section.kind, column.kind, "section of the group")
  near(a.section.area, column.area, 0, "its area")
  equal(a.elements, 4, "elements of all")
  local b = grid:columns { at = { "B1" }, storeys = { 1 }, group = "stout", section = beam, elements = 2 }[1]
  near(b.section.area, beam.area, 0, "given in the call")
  equal(b.elements, 2, "given in the call")
  equal(#grid:line { "A1, base", "A1, storey 1", grid:node("B1", 1) }, 2, "a line through three places")
end)

case("copies and mirror images share nodes that are there, and keep supports, groups and directions", function()
  local model = hinge.model()
  local grid = hinge.grid { model = model, x = { 0, 4 }, z = { 0, 3 } }
  grid:fix "xyz"
  local bay = grid:columns { section = column, material = steel, up = { 1, 0, 0 }, group = { "columns", "west" } }
  for _, m in ipairs(grid:beams { along = "x", section = beam, material = steel, up = { 0.5, 0, 1 } }) do
    bay[#bay + 1] = m
  end
  local next_bay = grid:copy { members = bay, by = { 4, 0, 0 } }
  equal(#next_bay, 3, "members of the copy")
  equal(#model:nodes(), 6, "nodes: two are shared")
  expect(next_bay[1].a == bay[2].a, "its first column stands where the second one was")
  equal(next_bay[2].a.fixed, "x,y,z", "the new foot is fixed as the old one")
  equal(table.concat({ next_bay[1]:groups()[1].name, next_bay[1]:groups()[2].name }, " "), "columns west", "groups")
  local turned = grid:copy { members = { bay[3] }, mirror = { x = 8 }, group = "mirror image" }[1]
  near(turned.a.x, 16, 0, "x of the mirror image")
  near(turned.up[1], -bay[3].up[1], 1e-12, "its direction is turned")
  equal(turned.group, "mirror image", "a group of its own")
end)

case("wrong input is refused", function()
  local grid, model = new()
  local all = { section = beam, material = steel }
  local refused = {
    { function() hinge.grid { model = model, x = { 0, 0 }, z = { 0, 3 } } end, "positions must rise" },
    { function() hinge.grid { model = model, x = { 0 }, z = { 0 } } end, "'z' needs 2 or more" },
    { function() hinge.grid { x = { 0 }, z = { 0, 1 } } end, "the model is missing" },
    { function() hinge.grid { model = model, x = 3, z = { 0, 1 } } end, "positions in m that rise" },
    { function() grid:node "B3, storey 1" end, "unknown line" },
    { function() grid:node("B2", 3) end, "the highest is 2" },
    { function() grid:node("B2", 1.5) end, "'storey' is 1.5; must be a whole number" },
    { function() grid:node("B2", -1) end, "'storey' is -1" },
    { function() grid:columns { storeys = { 0 } } end, "storeys[1]" },
    { function() grid:columns { storeys = { 1, 1.5 } } end, "storeys[2]" },
    { function() hinge.grid { model = model, x = { 0, 4, 3 }, z = { 0, 3 } } end,
      "hinge.grid: field 'x[3]' is 3 m; positions must rise, and the one before is 4 m" },
    { function() hinge.grid { model = model, x = { count = 0, spacing = 1 }, z = { 0, 3 } } end,
      "hinge.grid: field 'x': field 'count' is 0" },
    { function() grid:node "B2" end, "give a storey with it" },
    { function() grid:node "roof" end, "is no place of a grid" },
    { function() grid:columns { storeys = { 3 } } end, "storeys[1]" },
    { function() grid:columns { at = { "Z9" } } end, "unknown line" },
    { function() grid:beams { along = "z" } end, "'along'" },
    { function() grid:beams { along = "x", at = { "A" }, section = beam } end, "names no line" },
    { function() grid:line { "A1, base" } end, "two or more" },
    { function() grid:copy { members = {} } end, "give one of two" },
    { function() grid:copy { members = {}, mirror = { w = 1 } } end, "'mirror'" },
    { function() grid:columns { group = "columns", material = all.material } end, "'section' is missing" },
  }
  for _, r in ipairs(refused) do checks.refused(r[2], r[1]) end
end)

checks.done()
