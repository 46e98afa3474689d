-- A frame of hinge.import as text, a line for each row, for tests that compare all of it.
local frame_text = {}

-- A value as text: numbers with six digits, lists in brackets, fields in the order of the alphabet.
function frame_text.shown(v)
  if type(v) == "number" then return ("%.6g"):format(math.abs(v) < 1e-15 and 0 or v) end
  if type(v) ~= "table" then return tostring(v) end
  local parts, keys = {}, {}
  for i, item in ipairs(v) do parts[i] = frame_text.shown(item) end
  for key in pairs(v) do
    if type(key) == "string" then keys[#keys + 1] = key end
  end
  table.sort(keys)
  for _, key in ipairs(keys) do parts[#parts + 1] = key .. "=" .. frame_text.shown(v[key]) end
  return "{" .. table.concat(parts, " ") .. "}"
end

-- A frame as text, a line for each row; the name of a row first, its fields behind it.
function frame_text.of(frame)
  local lines = {}
  local function add(what, row, fields)
    local parts = { what, row.name }
    for name in fields:gmatch "%S+" do
      if row[name] ~= nil then parts[#parts + 1] = name .. "=" .. frame_text.shown(row[name]) end
    end
    lines[#lines + 1] = table.concat(parts, " ")
  end
  for _, n in ipairs(frame.nodes) do add("node", n, "x y z fix") end
  for _, m in ipairs(frame.materials) do add("material", m, "E G nu density unit_weight yield_stress") end
  for _, s in ipairs(frame.sections) do
    add("section", s, "named area Ix Iy J shear_area_x shear_area_y plastic size")
  end
  for _, m in ipairs(frame.members) do add("member", m, "a b section material up group release") end
  for _, c in ipairs(frame.cases) do
    add("case", c, "self_weight gravity")
    for _, l in ipairs(c.loads) do add(" ", { name = "load", node = l.node, member = l.member, force = l.force,
      moment = l.moment, q = l.q, at = l.at, axes = l.axes }, "node member force moment q at axes") end
  end
  for _, m in ipairs(frame.masses) do
    add("mass", { name = m.node, mass = m.mass, inertia = m.inertia }, "mass inertia")
  end
  return table.concat(lines, "\n")
end

--- Compares a frame with a text line by line, with `equal` of a test.
function frame_text.same(equal, frame, wanted, what)
  local a, b = {}, {}
  for line in frame_text.of(frame):gmatch "[^\n]+" do a[#a + 1] = line end
  for line in wanted:gmatch "[^\n]+" do b[#b + 1] = line end
  for i = 1, #a > #b and #a or #b do equal(a[i], b[i], ("%s, line %d"):format(what, i)) end
end

return frame_text
