-- hinge.picture: every field of a view changes the picture in plain Lua, and a wrong one is an error at the script's
-- line.
--
-- Run: lua5.4 tests/script/render/picture_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local scenes = require "scenes"
local checks = support.checks "picture"
local case, expect, equal = checks.case, checks.expect, checks.equal

-- A portal under its loads, with a plastic hinge, on a plane.
local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 235e6 }
local section = hinge.section.box { depth = 0.15, width = 0.15, thickness = 0.006 }
local sizes = { section = section, material = steel, up = { 1, 0, 0 } }
local model, node = scenes.portal { column = sizes, beam = scenes.with(sizes, { up = { 0, 0, 1 } }) }
model:ground { point = { 0, 0, -0.2 }, normal = { 0, 0, 1 } }
model:load { node = node[2], force = { 50e3, 0, 0 } }
model:load { group = "beams", q = { 0, 0, -8e3 } }
local run = model:static { steps = 10 }
run:finish()
case("the portal that is drawn has a plastic hinge", function()
  equal(run.verdict, "completed", "verdict")
  expect(run:count { state = "yielded" } > 0, "no hinge is there to be drawn")
end)

local folder = support.temporary_folder()
local job = require "hinge.program.job".new(folder)
local function draw(view)
  view.width, view.height = view.width or 320, view.height or 240
  job:picture(run, view, "a.png")
  equal(#job.notes, 0, tostring(job.notes[1]))
  return support.read(folder .. "/a.png")
end
case("the legend has the groups that are drawn, and no others", function()
  local function picture(posts, view)
    local own, at = scenes.portal { column = { section = section, material = steel, group = posts },
      beam = { section = section, material = steel } }
    own:load { node = at[2], force = { 1e3, 0, 0 } }
    view.show, view.width, view.height = "group", 480, 360
    job:picture(own:static { steps = 1 }:finish(), view, "b.png")
    return support.read(folder .. "/b.png")
  end
  local beams = picture("posts", { groups = { "beams" } })
  expect(beams and #beams > 2000, "a picture")
  equal(picture("pillars", { groups = { "beams" } }) == beams, true, "posts that are not drawn are not in it")
  equal(picture("posts", {}) == picture("pillars", {}), false, "and that of those that are")
end)

case("every option of a picture changes it as it should", function()
  local plain = draw {}
  expect(plain and #plain > 2000, "a picture")
  local seen = { ["nothing"] = plain }
  local function differs(what, view)
    local picture = draw(view)
    for other, bytes in pairs(seen) do expect(picture ~= bytes, "%s looks like %s", what, other) end
    seen[what] = picture
  end
  local function each(names, what, view)
    for _, name in ipairs(names) do differs(what .. " " .. name, view(name)) end
  end
  each({ "front", "back", "left", "right", "top", "iso" }, "view", function(name) return { view = name } end)
  each({ "group", "none", "N", "Qx", "Qy", "Mx", "My", "Mz" }, "show", function(name) return { show = name } end)
  each({ "nodes", "members" }, "labels", function(name) return { labels = name } end)
  each({ "ghost", "loads", "labels" }, "with", function(name) return { [name] = true } end)
  each({ "supports", "ground", "hinges" }, "without", function(name) return { [name] = false } end)
  differs("scale", { scale = 30 })
  differs("scale auto", { scale = "auto" })
  differs("a group by name", { groups = { "beams" } })
  differs("a group", { groups = { model:group "columns" } })
  differs("above", { above = 1 })
  differs("title", { title = "t" })
  differs("box", { box = { -1, 5, 0, 0, 0, 3 } })
  differs("largest", { show = "Mx", largest = 1e6 })
  differs("from", { from = { 0, -1, 0 } })
  differs("up", { up = { 0, 0, -1 } })
  differs("width", { width = 330 })
  equal(draw { view = "perspective", show = "f_y", scale = 1, ghost = false, supports = true, labels = false } == plain,
    true, "the defaults")
  equal(draw { up = { 0, 1, 0 } } == draw { up = { 0, 1, 0 }, from = { -1, 0.55, 1.4 } }, true,
    "perspective with y upwards")
  equal(draw { view = "top" } == draw { view = "top", up = { 0, 0, 2 } }, true, "a longer up")
end)

case("a picture on a plane draws one line of frames of two", function()
  -- One line of frames of two: the picture of the other one's plane is that of a model with the one line alone. Without
  -- a view it looks across the plane.
  local function lines(places)
    local made = hinge.model()
    for _, y in ipairs(places) do
      local a, b, c, d = made:node { 0, y, 0 }, made:node { 0, y, 3 }, made:node { 4, y, 3 }, made:node { 4, y, 0 }
      made:fix { a, d }
      for _, ends in ipairs { { a, b }, { b, c }, { c, d } } do
        made:load { q = { 0, 0, -1e3 * (1 + y) }, member = made:member { ends[1], ends[2], section = section,
          material = steel } }
      end
    end
    return made:static { steps = 1 }:finish()
  end
  local function line_of(of, view)
    view.width, view.height, view.show = 320, 240, view.show or "none"
    job:picture(of, view, "line.png")
    equal(#job.notes, 0, tostring(job.notes[1]))
    return support.read(folder .. "/line.png")
  end
  local both, alone = lines { 0, 5 }, lines { 0 }
  equal(line_of(both, { plane = { y = 0 } }) == line_of(alone, { view = "front" }), true, "one line of frames")
  equal(line_of(both, { plane = { y = 5 }, show = "Mx" }) == line_of(both, { plane = { y = 0 }, show = "Mx" }), false,
    "the moments of the other line, with six times the load")
  equal(line_of(both, { plane = { y = 5 }, view = "iso" }) == line_of(both, { view = "iso" }), false,
    "without one line")
  equal(line_of(both, { plane = { y = 0.0005 }, view = "right" }) == line_of(alone, { view = "right" }), true,
    "one line of frames from the right")
  equal(line_of(both, { plane = { z = 3 } }) == line_of(both, { view = "top" }), false, "a floor")
end)

case("a picture goes to the next free name where none is given", function()
  for _, name in ipairs { "picture.png", "picture-2.png" } do
    job:picture(run, { scale = 50, ghost = true, supports = true, loads = true, show = "Mx", view = "front",
      labels = true })
    expect(support.read(folder .. "/" .. name), "there is no %s", name)
  end
  job:picture(run, nil, "named.png")
  expect(support.read(folder .. "/named.png") and not support.read(folder .. "/picture-3.png"), "a picture with a name")
end)

case("wrong options of hinge.picture are refused", function()
  for text, view in pairs {
    ["field 'view' is 'frnt'; must be one of front, back, left, right, top, iso, perspective (did you mean 'front'?)"] =
      { view = "frnt" },
    ["field 'show' is 'M'; must be one of f_y, group, none, N, Qx, Qy, Mx, My, Mz (did you mean"] = { show = "M" },
    ["field 'scale' is 'big'; must be a number above 0 or 'auto'"] = { scale = "big" },
    ["field 'scale' is 0; must be a number above 0 or 'auto'"] = { scale = 0 },
    ["field 'scale' is not a number (nan); must be a number above 0 or 'auto'"] = { scale = 0 / 0 },
    ["field 'labels' is 'node'; must be true or false or 'nodes' or 'members'"] = { labels = "node" },
    ["field 'ghost' is 1; must be true or false"] = { ghost = 1 },
    ["field 'from' is given beside view = 'top'"] = { view = "top", from = { 1, 0, 0 } },
    ["field 'from' is {0, 0, 0}; must be a direction"] = { from = { 0, 0, 0 } },
    ["field 'up' is {0, 0, 0}; must be a direction"] = { up = { 0, 0, 0 } },
    ["field 'width' is 9000 pixels; must be"] = { width = 9000 },
    ["field 'height' is 63 pixels; must be"] = { height = 63 },
    ["field 'largest' is -1 N or N m; must be"] = { largest = -1 },
    ["field 'box' is a smallest y of 1 m, above the largest, 0 m; must be { xmin, xmax,"] =
      { box = { 0, 1, 1, 0, 0, 1 } },
    ["field 'plane' is y = 2 m, where no member lies; must be a plane of members: y = 0 m"] = { plane = { y = 2 } },
    ["field 'plane' is a field 'w'; must be x, y or z with a number"] = { plane = { w = 0 } },
    ["field 'plane' is a field 'x'; must be x, y or z with a number"] = { plane = { x = "0" } },
    ["field 'plane' is {}; must have x, y or z"] = { plane = {} },
    ["no group 'beam' (did you mean 'beams'?)"] = { groups = { "beam" } },
    ["unknown field 'labels_' (did you mean 'labels'?)"] = { labels_ = true },
  } do checks.refused(text, function() hinge.picture(run, view, "b.png") end) end
end)

checks.done()
