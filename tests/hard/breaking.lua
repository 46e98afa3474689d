-- Hard fractures: all at once, one a step, down to single elements, with contact bound.
local parts = require "parts"

local function falling_frame(model)
  parts.frame(model, { storeys = 3, bays = 2 })
  model:gravity { 0, 0, -9.80665 }
end

return {
  { "all columns of a storey break in one step", energy_error = 1e-2, dt = 1e-4, steps = 3000,
    build = function(model)
      falling_frame(model)
      model:fracture { group = "storey 2", where = "all", rule = function(s) return s.time > 0.01 end }
    end },
  { "every member breaks, one a step", energy_error = 1e-2, dt = 1e-4, steps = 1000,
    build = function(model)
      falling_frame(model)
      local next_one, last = 1, 0
      model:fracture { where = "all", rule = function(s)
        if s.time > last and s.member == model:members()[next_one] then
          next_one, last = next_one + 1, s.time
          return true
        end
      end }
    end },
  { "feet shake until the columns on them break", energy_error = 1e-2, dt = 2e-5, steps = 2500,
    build = function(model)
      local joints = parts.frame(model, { storeys = 2, bays = 2, material = parts.steel { yield_stress = 245e6 } })
      model:gravity { 0, 0, -9.80665 }
      model:move { node = { joints[0][0], joints[0][1], joints[0][2] },
        x = function(t) return 0.1 * math.sin(150 * t) end }
      model:fracture { curvature_x = 0.05, curvature_y = 0.05, axial_strain = 0.005 }
    end },
  { "a body in flight breaks into single elements", energy_error = 1e-2, momentum = 2e-6, dt = 1e-5, steps = 1000,
    free = true, model = { elements_per_member = 4 }, build = function(model)
      parts.row(model, { 0, 0, 0 }, { 4, 0, 0 }, { members = 4, group = "body" })
      model:velocity("body", { 10, 0, 0 }, { 0, 0, 20 })
      model:fracture { where = "all", rule = function(s) return s.time > 1e-3 end }
    end },
  { "a tie of contact holds while its member breaks", energy_error = 2e-2, momentum = 2e-3, dt = 5e-6, steps = 1000,
    free = true, build = function(model)
      parts.row(model, { -0.5, 0, 0 }, { 0.5, 0, 0 }, { members = 2, group = "struck" })
      parts.row(model, { 0, -0.5, 0.08 }, { 0, 0.5, 0.08 }, { members = 2, group = "striker" })
      model:velocity("striker", { 0, 0, -50 })
      model:contact { rule = "gap" }
      model:fracture { group = "struck", where = "all", rule = function(s) return s.time > 1e-3 end }
    end },
}
