-- Slabs of a frame: plates between its members, by model:floor. Their rules, the part of a model that they are
-- (import.build) and the lines of a script (import.write). Rows:
--
-- frame.sheets   { name =, and what model:panel takes, with the name of a material }
-- frame.slabs    { name =, sheet =, corners = { { x, y, z }, ... } (m), members = (names: those along its edges and
--                inside of it), load = (Pa by case, downwards), weight = (N/m^2: what of it is in the self weight) }
--
-- `elements` of those members are as many as the slab has panels along them.
local check = require "hinge.library.check"
local optional = require "hinge.import.ties".optional
local vectors = require "hinge.library.vectors"

local slabs = {}

local text, down = { "string" }, { 0, 0, -1 }
slabs.rules = {
  sheets = { name = text, thickness = optional "number", material = optional "string", hardening = optional "number",
    ultimate_strain = optional "number", concrete = optional "table", reinforcement = optional "table",
    deck = optional "table", along = optional("numbers", { count = 3 }), mass = optional "number",
    bending = { "bending", optional = true, words = "a table, \"layers\" or false",
      good = function(v) return v == false or v == "layers" or type(v) == "table" end } },
  slabs = { name = text, sheet = text, corners = { "table" }, members = { "table" }, load = optional "table",
    weight = optional("number", { unit = "N/m^2", at_least = 0 }) },
}

--- Checks that what the rows name is there. known(where, what, name, by_name): fails for a name that is not.
function slabs.check(where, parts, known)
  local sheets, cases = {}, {}
  for _, row in ipairs(parts.sheets) do sheets[row.name] = row end
  for _, case in ipairs(parts.cases) do cases[case.name] = case end
  for i, row in ipairs(parts.sheets) do
    if row.material then known(("%s: frame.sheets[%d]"):format(where, i), "material", row.material, parts.material) end
  end
  for i, row in ipairs(parts.slabs) do
    local here = ("%s: frame.slabs[%d]"):format(where, i)
    known(here, "sheet", row.sheet, sheets)
    for _, name in ipairs(row.members) do known(here, "member", name, parts.member) end
    for k, corner in ipairs(row.corners) do
      check.value(here, ("corners[%d]"):format(k), corner, { "numbers", count = 3, unit = "m" })
    end
    for _, name in ipairs(check.keys(row.load or {})) do
      known(here, "load case", name, cases)
      check.value(here, "load." .. name, row.load[name], { "number", unit = "Pa" })
      if cases[name].history then
        check.fail("%s: case '%s' has a history, and loads of slabs have none", here, name)
      end
    end
    row.load = check.copy(row.load)
  end
end

--- Why gravity g on the mass of a slab is not the weight of the file; nil: it is.
function slabs.not_by_gravity(parts, g)
  local sheets = {}
  for _, row in ipairs(parts.sheets) do sheets[row.name] = row end
  for _, row in ipairs(parts.slabs) do
    local mass = sheets[row.sheet].mass
    if row.weight and mass and math.abs(row.weight - mass * g) > 1e-3 * math.max(row.weight, mass * g) then
      return ("slab '%s' weighs %.6g N/m^2, and its mass times gravity is %.6g N/m^2"):format(row.name, row.weight,
        mass * g)
    end
  end
end

--- Makes the self weight of slabs loads of a case.
function slabs.weight_as_loads(parts, case)
  for _, row in ipairs(parts.slabs) do
    if row.weight and row.weight > 0 then
      row.load = row.load or {}
      row.load[case.name] = (row.load[case.name] or 0) + case.self_weight * row.weight
    end
  end
end

-- The fields of a sheet as model:panel takes them.
local function panel_of(sheet, materials)
  local panel = check.copy(sheet)
  panel.name, panel.material = nil, sheet.material and materials[sheet.material]
  return panel
end

--- Adds them to a model, whose cases are there.
function slabs.build(model, full, members, materials)
  local sheets = {}
  for _, row in ipairs(full.sheets) do sheets[row.name] = panel_of(row, materials) end
  for _, row in ipairs(full.slabs) do
    local list = {}
    for i, name in ipairs(row.members) do list[i] = members[name] end
    model:floor { corners = row.corners, members = list, load = row.load and next(row.load) and row.load, direction =
      down, slab = sheets[row.sheet] }
  end
end

local function sheet_text(w, row)
  local fields = check.copy(row)
  fields.name, fields.material = nil, nil
  local rest = w.literal(fields)
  if not row.material then return rest end
  return ("{ material = materials[%s]%s"):format(w.quote(row.material), rest == "{  }" and " }" or "," .. rest:sub(2))
end

--- Writes them. w: { line = function(text), literal =, quote = }.
function slabs.write(w, full)
  if #full.slabs == 0 then return end
  w.line "-- What slabs are made of, as model:panel takes it: m, Pa, m^2/m, N m, kg/m^2"
  w.line "local sheets = {"
  for _, row in ipairs(full.sheets) do w.line(("  [%s] = %s,"):format(w.quote(row.name), sheet_text(w, row))) end
  w.line "}\n"
  w.line "-- Slabs: sheet; corners, m; members along its edges and inside of it; load, Pa by case"
  w.line "for _, s in ipairs {"
  for _, row in ipairs(full.slabs) do
    local load = row.load and next(row.load) and ", load = " .. w.literal(row.load) or ""
    w.line(("  { %s, %s, %s%s },"):format(w.quote(row.sheet), w.literal(row.corners), w.literal(row.members), load))
  end
  w.line "} do"
  w.line "  local around = {}"
  w.line "  for i, name in ipairs(s[3]) do around[i] = members[name] end"
  w.line "  model:floor { corners = s[2], members = around, load = s.load, slab = sheets[s[1]] }"
  w.line "end\n"
end

--- Area (m^2), mass (kg) and number of the slabs of a frame.
function slabs.sum(frame)
  local sheets, area, mass = {}, 0, 0
  for _, row in ipairs(frame.sheets or {}) do sheets[row.name] = row end
  for _, row in ipairs(frame.slabs or {}) do
    local own = vectors.area(row.corners)
    area, mass = area + own, mass + own * (sheets[row.sheet].mass or 0)
  end
  return area, mass, #(frame.slabs or {})
end

return slabs
