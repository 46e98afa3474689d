-- Structures that many tests begin with. Lengths in m, forces in N.
local hinge = require "hinge"
local scenes = {}

--- Steel that yields, and the same without a yield stress; a square of 50 mm.
scenes.steel = hinge.material { E = 206e9, nu = 0.3, density = 7850, yield_stress = 235e6 }
scenes.elastic = hinge.material { E = 206e9, nu = 0.3, density = 7850 }
scenes.square = hinge.section.solid { width = 0.05, depth = 0.05 }

--- A table with the fields of others; later ones win.
function scenes.with(...)
  local all = {}
  for i = 1, select("#", ...) do
    for key, value in pairs((select(i, ...)) or {}) do all[key] = value end
  end
  return all
end

--- A cantilever along x. `options`: model = of hinge.model, member = of model:member (section, material, up, ...),
--- length (1), along (the direction, { 1, 0, 0 }), flipped (the member goes from the tip to the support), foot ("all",
--- what is fixed there, or false), head (nothing, what is fixed there), force, moment = on the tip.
--- Returns the model, its tip, the member and the support.
function scenes.cantilever(options)
  options = options or {}
  local model, length, along = hinge.model(options.model or {}), options.length or 1, options.along or { 1, 0, 0 }
  local wall = model:node { 0, 0, 0 }
  local tip = model:node { length * along[1], length * along[2], length * along[3] }
  if options.foot ~= false then model:fix(wall, options.foot or "all") end
  if options.head then model:fix(tip, options.head) end
  local member = model:member(scenes.with({ section = scenes.square, material = scenes.elastic }, options.member,
    options.flipped and { tip, wall } or { wall, tip }))
  if options.force or options.moment then
    model:load { node = tip, force = options.force, moment = options.moment }
  end
  return model, tip, member, wall
end

--- Adds a frame that stays in its plane of x and z, clamped at its feet. `options`: bays, storeys, bay, height, y (0,
--- where the plane is), column =, beam = (of model:member, without nodes and up). Returns its nodes as [axis][level],
--- from 0.
function scenes.plane_frame(model, options)
  local o, at = options, {}
  for i = 0, o.bays do
    at[i] = {}
    for k = 0, o.storeys do
      at[i][k] = model:node { o.bay * i, o.y or 0, o.height * k }
      model:fix(at[i][k], k == 0 and "all" or "y,rx,rz")
      if k > 0 then
        model:member(scenes.with(o.column, { at[i][k - 1], at[i][k], up = { 1, 0, 0 } }))
        if i > 0 then model:member(scenes.with(o.beam, { at[i - 1][k], at[i][k], up = { 0, 0, 1 } })) end
      end
    end
  end
  return at
end

--- A portal in the plane of x and z: feet 1 and 4, heads 2 and 3. `options`: model =, width (4), height (3),
--- column =, beam = (of model:member), feet ("all", what is fixed there), heads (nothing, what is fixed there).
--- Returns the model, its nodes and its members (column, beam, column; the beam from 2 to 3).
function scenes.portal(options)
  options = options or {}
  local model, width, height = hinge.model(options.model or {}), options.width or 4, options.height or 3
  local node, member = {}, {}
  for i, at in ipairs { { 0, 0 }, { 0, height }, { width, height }, { width, 0 } } do
    node[i] = model:node { at[1], 0, at[2] }
    local held = at[2] == 0 and (options.feet or "all") or at[2] ~= 0 and options.heads
    if held then model:fix(node[i], held) end
  end
  local steel = { section = scenes.square, material = scenes.steel }
  for i, ends in ipairs { { 1, 2 }, { 2, 3 }, { 4, 3 } } do
    member[i] = model:member(scenes.with(steel, { group = i == 2 and "beams" or "columns" },
      i == 2 and options.beam or options.column, { node[ends[1]], node[ends[2]] }))
  end
  return model, node, member
end

--- Calls f without what it prints; what pcall(f, ...) returns, and all runs that were made. `watch` gets each of them.
function scenes.runs_of(f, watch, ...)
  local runs, say = {}, print
  local methods = debug.getregistry()["hinge.model"].methods
  local static, dynamic = methods.static, methods.dynamic
  local function kept(make)
    return function(...)
      local run = make(...)
      runs[#runs + 1] = run
      if watch then watch(run) end
      return run
    end
  end
  methods.static, methods.dynamic, _G.print = kept(static), kept(dynamic), function() end
  local ok, result = pcall(f, ...)
  methods.static, methods.dynamic, _G.print = static, dynamic, say
  return ok, result, runs
end

return scenes
