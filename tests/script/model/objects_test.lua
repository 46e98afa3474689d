-- What nodes, members, groups, loads and runs tell: text, identity, lists, the state one by one and in arrays; that
-- they are refused by another model, where there is nothing to read, and when they are gone.
--
-- Run: lua5.4 tests/script/model/objects_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local hinge = require "hinge"
local support = require "support"
local scenes = require "scenes"
local checks = support.checks "objects"
local case = checks.case

local bar = scenes.square
local function text(value, wanted)
  checks.expect(support.says(tostring(value), wanted), "text: %s, wanted %s", tostring(value), wanted)
end
local function line_of(mark)
  local n = 0
  for line in io.lines(debug.getinfo(1, "S").source:sub(2)) do
    n = n + 1
    if line:find(mark .. "$") then return n end
  end
end

-- Rows of a wrong call and words of its message.
local function refused(rows)
  for _, row in ipairs(rows) do checks.refused({ table.unpack(row, 2) }, row[1]) end
end

-- A portal: two posts of one group and a beam of two, held at the feet, pushed at the left corner.
local function portal()
  local model, n, m = scenes.portal { column = { group = "posts" },
    beam = { group = { "beams", "all" }, elements = 4 } }
  model:fix(n[2], "y,rx")
  return model, n, m, model:load { node = n[2], force = { 100, 0, 0 }, moment = { 0, 5, 0 } }
end

-- Text and identity ---------------------------------------------------------------------------------------------------

local model, n, m, push = portal()
case("handles have texts and compare by identity", function()
  text(model, "model: 4 nodes, 3 members")
  text(n[1], "node 1 at {0, 0, 0} m, fixed: all")
  text(n[2], "node 2 at {0, 0, 3} m, fixed: y,rx")
  text(n[3], "node 3 at {4, 0, 3} m")
  text(m[2], "member 2 (beams), nodes 2-3")
  text(model:group "posts", "group 'posts', 2 members")
  text(model:group "all", "group 'all', 1 member")
  text(push, "load on node 2: force {100, 0, 0} N, moment {0, 5, 0} N m")
  text(model:load { node = n[3], moment = { 1, 0, 0 }, history = { { 0, 1 } } },
    "load on node 3: moment {1, 0, 0} N m, times its history")
  text(model:static { steps = 1 }, "static run: running at step 0 of 1, t = 0 s")

  checks.expect(m[1].a == n[1] and m[1].b == n[2] and m[1].a ~= m[1].b, "nodes of a member are the model's nodes")
  checks.expect(model:group "posts" == model:groups()[1] and model:members()[2] == m[2] and model:loads()[1] == push,
    "handles out of lists are the same")
  checks.expect(({ [n[3]] = "corner" })[m[2].b] == "corner", "a handle is the same key wherever it comes from")
  checks.expect(portal() ~= model and select(2, portal())[1] ~= n[1], "equal models are not the same")
  checks.expect(m[1].section == bar and m[2].material == scenes.steel and m[1].material == m[3].material,
    "section and material of a member")
  local function index_of_new() return model:nodes()[4].index end
  local address = setmetatable({}, { __mode = "k" })
  address[model:group "posts"] = true
  collectgarbage()
  collectgarbage()
  checks.expect(next(address) == nil and index_of_new() == 4 and #model:group "posts" == 2,
    "handles come anew when nobody holds one")
end)

-- Lists and fields ----------------------------------------------------------------------------------------------------

case("lists and fields give what was declared", function()
  local function listed(list, of_groups)
    local t = {}
    for i, handle in ipairs(list) do t[i] = of_groups and handle.name or handle.index end
    return table.concat(t, " ")
  end
  for what, row in pairs {
    ["model:nodes"] = { model:nodes(), "1 2 3 4" }, ["model:members"] = { model:members(), "1 2 3" },
    ["model:groups"] = { model:groups(), "posts beams all" },
    ["group:members"] = { model:group "posts":members(), "1 3" },
    ["group:nodes"] = { model:group "beams":nodes(), "2 3" },
    ["member:nodes"] = { m[3]:nodes(), "4 3" }, ["member:groups"] = { m[2]:groups(), "beams all" },
  } do
    checks.equal(listed(row[1], what:find "groups"), row[2], what)
  end
  checks.expect(n[1].fixed == "all" and n[2].fixed == "y,rx" and n[3].fixed == nil, "what is fixed")
  checks.expect(m[2].elements == 4 and m[2].up[3] == 1 and m[1].up[1] == 1 and m[1].length == 3, "fields of a member")
  checks.expect(#model:group "posts" == 2 and model:group "posts".size == 2 and model:group "posts".length == 6,
    "size of a group")
  checks.expect(push.node == n[2] and push.force[1] == 100 and push.moment[2] == 5, "fields of a load")
end)

-- The state -----------------------------------------------------------------------------------------------------------

local function packed(...) return table.concat({ ... }, " ") end
local first = model:static { steps = 1 }:finish()
local second = model:static { steps = 2 }
case("members and nodes read their state from the last run or the one given", function()
  second:step()
  for _, name in ipairs { "displacement", "velocity", "acceleration", "reaction", "position" } do
    for i, node in ipairs(n) do
      checks.equal(packed(node[name](node, first)), packed(first[name](first, node)),
        ("node:%s of node %d"):format(name, i))
      checks.equal(packed(node[name](node)), packed(second[name](second, node)),
        ("node:%s of node %d in the latest run"):format(name, i))
    end
  end
  checks.expect(packed(n[2]:displacement(first)) ~= packed(n[2]:displacement()), "the latest run is another")
  checks.expect(select(3, n[1]:reaction(first)) ~= 0
    and math.abs(n[1]:reaction(first) + n[4]:reaction(first) + 100) < 1e-4, "reactions bear the load")
  for i, member in ipairs(m) do
    local a, b = member:forces(first)
    local a2, b2 = first:forces(member)
    for _, q in ipairs { "N", "Mx", "My", "Mz", "Qx", "Qy", "f_y" } do
      checks.expect(a[q] == a2[q] and b[q] == b2[q], "member:forces %s", q)
      checks.equal(first:read(q .. "_a")[i], a[q], ("run:read %s_a of member %d"):format(q, i))
      checks.equal(first:read(q .. "_b")[i], b[q], ("run:read %s_b of member %d"):format(q, i))
    end
    checks.equal(packed(member:state(first)), packed(first:state(member)), "member:state")
  end
  checks.expect(math.abs(first:read("My_a")[1]) + math.abs(first:read("Mx_a")[1]) > 1, "there are moments")

  local names = { displacement = { "ux", "uy", "uz", "rx", "ry", "rz" },
    velocity = { "vx", "vy", "vz", "vrx", "vry", "vrz" }, position = { "node_x", "node_y", "node_z" },
    acceleration = { "ax", "ay", "az", "arx", "ary", "arz" },
    reaction = { "reaction_fx", "reaction_fy", "reaction_fz", "reaction_mx", "reaction_my", "reaction_mz" } }
  local moving = model:dynamic { dt = 1e-4, duration = 1e-2 }:finish()
  for name, components in pairs(names) do
    for c, quantity in ipairs(components) do
      local all, of_beam = moving:read(quantity), moving:read(quantity, "beams")
      checks.expect(#all == 4 and #of_beam == 2, "length of run:read %s", quantity)
      for i = 1, 4 do
        checks.equal(all[i], (select(c, n[i][name](n[i]))), ("run:read %s of node %d"):format(quantity, i))
      end
      checks.expect(of_beam[1] == all[2] and of_beam[2] == all[3], "run:read %s of a group", quantity)
    end
  end
  checks.equal(table.concat(moving:read("node", model:group "posts"), " "), "1.0 2.0 3.0 4.0", "nodes of a group")
  checks.equal(table.concat(moving:read("member", "posts"), " "), "1.0 3.0", "members of a group")
  checks.expect(moving:read "vx"[2] ~= 0 and moving:read "ax"[3] ~= 0, "it moves")
end)

-- What is refused ----------------------------------------------------------------------------------------------------

case("handles of another model are refused by every call that takes one", function()
  local mine, nodes, members, load = portal()
  local run, counts = mine:static { steps = 1 }, mine:counts()
  local group, foreign = model:group "posts", " of another model; use one of this model"
  local of_group, of_node = "group 'posts'" .. foreign, "node 2" .. foreign
  refused {
    { function() mine:fix { n[2] } end, "model:fix: item 1 is " .. of_node },
    { function() mine:member { nodes[1], nodes[3], section = bar, material = scenes.steel,
      group = { "posts", group } } end, "model:member: field 'group' is " .. of_group },
    { function() mine:velocity(group, { 1, 0, 0 }) end, "model:velocity: target is " .. of_group },
    { function() mine:fracture { curvature_x = 1, group = group } end, "field 'group' is " .. of_group },
    { function() mine:contact { groups = { group } } end, "model:contact: field 'groups', item 1 is " .. of_group },
    { function() mine:group(group) end, "model:group: name is " .. of_group },
    { function() mine:static { fixed_group = group } end, "model:static: field 'fixed_group' is " .. of_group },
    { function() mine:static { control = { node = n[2], "uz", to = 1 } } end, "control: field 'node' is " .. of_node },
    { function() run:probe { node = n[2], "ux" } end, "run:probe: field 'node' is " .. of_node },
    { function() run:count { state = "broken", group = group } end, "run:count: field 'group' is " .. of_group },
    { function() run:read("N", group) end, "run:read: group is " .. of_group },
    { function() run:state(m[1]) end, "run:state: member is member 1" .. foreign },
    { function() nodes[2]:displacement(first) end, "node:displacement: run is the run made at ", foreign },
    { function() members[1]:forces(first) end, "member:forces: run is the run made at ", foreign },
  }
  for what, count in pairs(mine:counts()) do checks.equal(count, counts[what], "afterwards: " .. what) end
  checks.equal(mine:static { steps = 1 }:finish().hash, run:finish().hash, "the model afterwards")
  checks.equal(mine:loads()[1], load, "its load")
end)

case("handles are refused where there is nothing to read", function()
  local mine, nodes, members = portal()
  refused {
    { function() nodes[2]:displacement() end, "node:displacement: no run has been made of this model yet",
      "make one with model:static{} or model:dynamic{}" },
    { function() nodes[1]:reaction() end, "node:reaction: no run has been made of this model yet" },
    { function() members[1]:state() end, "member:state: no run has been made of this model yet" },
    { function() nodes[2]:displacment() end, "no field or method 'displacment' (did you mean 'displacement'?)" },
    { function() mine:group "posts":member() end, "group has no field or method 'member' (did you mean 'members'?)" },
    { function() return mine:loads()[1].forces end, "load has no field or method 'forces' (did you mean 'force'?)" },
  }
  local run = mine:static { steps = 1 }
  local node = mine:node { 5, 5, 5 }
  local member = mine:member { nodes[3], node, section = bar, material = scenes.steel }
  refused {
    { function() nodes[2]:velocity(3) end, "node:velocity: run is 3; must be one that model:static{} or" },
    { function() run:velocity(node) end, "run:velocity: node is node 5, declared after this run was made" },
    { function() node:position() end, "node:position: this is node 5, declared after this run was made" },
    { function() member:forces() end, "member:forces: this is member 4, declared after this run was made" },
    { function() members[1].state() end, "member:state: called on nil; write object:method(...) on a hinge.member" },
    { function() run:read "Nx_a" end, "run:read: quantity is 'Nx_a'", "did you mean 'N_a'?" },
    { function() run:read("ux", "poss") end, "run:read: group: no group 'poss' (did you mean 'posts'?)" },
  }
end)

-- What is gone --------------------------------------------------------------------------------------------------------

case("handles of what is gone are refused", function()
  local loads = #model:loads()
  push:remove() -- removed here
  checks.equal(#model:loads(), loads - 1, "loads after one was removed")
  local gone = "the load on node 2, which was removed at ...objects_test.lua:" .. line_of "%-%- removed here"
  text(push, gone)
  local what, place = gone:match "^(.*)%.%.%.(.*)$"
  refused {
    { function() push:remove() end, "load:remove: this is " .. what, place },
    { function() return push.force end, "load.force: this is " .. what, place },
  }
  model:load { node = n[3], moment = { 1, 0, 0 } }
  local without = model:static { steps = 1 }:finish()
  checks.expect((without:displacement(n[2])) ~= (first:displacement(n[2])),
    "a run made after it was removed is without it")
  -- a run under way when it was removed
  checks.refused({ "run:step: load:remove at ", place .. " came after this run was made at ", "declare it before" },
    second.finish, second)
end)

case("handles of a model that was closed are refused, with the line that closed it", function()
  local closed, nodes, members, load = portal()
  local group, early = closed:group "posts", closed:static {}
  local run = closed:dynamic { dt = 1e-5, duration = 1e-4 }
  local probe, steps = run:probe { node = nodes[2], "uz" }, run:steps()
  closed:close() -- closed here
  local other, since = hinge.model(), "that was closed at "
  for _, row in ipairs {
    { function() closed:node { 0, 0, 0 } end, "model:node: this is a model " },
    { function() closed:close() end, "model:close: this is a model " },
    { function() return nodes[2].x end, "node.x: this is node 2 of a model " },
    { function() nodes[2]:displacement() end, "node:displacement: this is node 2 of a model " },
    { function() members[1]:forces() end, "member:forces: this is member 1 of a model " },
    { function() group:members() end, "group:members: this is group 'posts' of a model " },
    { function() return #group end, "#group: this is group 'posts' of a model " },
    { function() load:remove() end, "load:remove: this is the load on node 2 of a model " },
    { function() return run.time end, "run.time: this is the run made at " },
    { function() early:finish() end, "run:finish: this is the run made at " },
    { function() steps() end, "run:steps: the run is the run made at " },
    { function() other:fix(nodes[2]) end, "model:fix: node is node 2 of a model " },
    { function() other:dynamic { dt = 1, duration = 1, from = early } end, "field 'from' is the run made at " },
  } do
    checks.refused({ row[2], since, "objects_test.lua:" .. line_of "%-%- closed here" }, row[1])
  end
  for what, handle in pairs { ["a model "] = closed, ["the run made at ... of a model "] = run,
    ["node 2 of a model "] = nodes[2], ["member 1 of a model "] = members[1],
    ["group 'posts' of a model "] = group, ["the load on node 2 of a model "] = load } do
    text(handle, what .. since .. "...objects_test.lua:" .. line_of "%-%- closed here")
  end
  checks.equal(#probe.value, 1, "values of a probe, after its model was closed")
end)

case("a member that breaks, and its tip that goes with it, read as they are", function()
  local breaking, elastic = hinge.model(), scenes.elastic
  local wall, tip = breaking:node { 0, 0, 0 }, breaking:node { 1, 0, 0 }
  breaking:fix(wall)
  local member = breaking:member { wall, tip, section = bar, material = elastic }
  local other = breaking:member { wall, breaking:node { 0, 1, 0 }, section = bar, material = elastic }
  breaking:fracture(function(s) return s.member == 1 and s.time > 2e-4 and s.element == 2 and s["end"] == 2 end)
  breaking:load { node = tip, force = { 0, 0, -2e4 } }
  local run = breaking:dynamic { dt = 1e-5, duration = 5e-4 }
  local broke
  for _ in run:steps() do
    local state, _, time, element = member:state()
    if state == "broken" then
      broke = broke or run.time
      checks.expect(time == broke and element == 2, "broken at %s, told %s, element %s", broke, time, element)
    else
      checks.expect(time == nil and element == nil, "no time of breaking before it breaks")
    end
  end
  checks.expect(broke and broke > 1e-4 and broke < 3e-4, "it breaks: %s", broke)
  text(member, ("member 1, nodes 1-2, broken at t = %.10g s"):format(broke or 0))
  text(other, "member 2, nodes 1-3")
  text(tip, ("node 2 at {1, 0, 0} m, left by its last member at t = %.10g s"):format(broke or 0))
  local _, b = member:forces()
  checks.expect(b.N == 0 and b.Mx == 0 and b.f_y == 0, "the broken end bears nothing")
  for _, load in ipairs(breaking:loads()) do load:remove() end
  local later = breaking:dynamic { dt = 1e-5, duration = 1e-4, from = run }
  local state, _, time, element = member:state(later:finish())
  checks.expect(state == "broken" and time == nil and element == 2, "broken before the run began")
  text(member, "member 1, nodes 1-2, broken before the latest run")
end)

case("a model that is closed is freed at once", function()
  -- though its handles are held and nothing is collected
  local function resident() return tonumber(support.read "/proc/self/statm":match "%d+ (%d+)") * 4 end
  local kept, before = {}, nil
  collectgarbage "stop"
  for i = 1, 30 do
    local closed = hinge.model { elements_per_member = 4000 }
    local a, b = closed:node { 0, 0, 0 }, closed:node { 1, 0, 0 }
    closed:fix(a)
    closed:member { a, b, section = bar, material = scenes.steel }
    kept[#kept + 1] = { closed, a, b, closed:dynamic { dt = "auto", duration = 1 } }
    closed:close()
    if i == 10 then before = resident() end
  end
  collectgarbage "restart"
  checks.expect(resident() - before < 40e3, "20 closed models of 10 MB keep %d kB", resident() - before)
  text(kept[1][4], "the run made at ... of a model that was closed at ...")
end)

case("a fracture rule reads which joint its section is at", function()
  -- inside a member there is none
  local ruled, _, members = portal()
  local at = {}
  ruled:fracture { where = "all", group = "posts", rule = function(section)
    if section.member == members[1].index then at[#at + 1] = tostring(section.node) end
  end }
  ruled:dynamic { dt = 1e-5, duration = 1e-5 }:finish()
  table.sort(at)
  checks.equal(table.concat(at, " "), "1 2 nil nil", "the joints of a post's sections")
end)

checks.done()
