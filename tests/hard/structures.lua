-- Hard structures: contrasts, slenderness, spin, hinges everywhere, loads that jump, supports that go.
local parts = require "parts"

-- A free bar that rotates fifty times a second.
local function spin(model)
  parts.row(model, { 0, 0, 0 }, { 1, 0, 0 }, { group = "body" })
  model:velocity("body", { 1, 0, 0 }, { 0, 0, 314.15926535 })
end

-- Members in a row along x, the first node held, with their lengths and materials: { length, what differs from steel };
-- the velocity of the last node.
local function contrasts(list, velocity)
  return function(model)
    local x, last = 0, model:node { 0, 0, 0 }
    model:fix(last)
    for _, of in ipairs(list) do
      x = x + of[1]
      local next_one = model:node { x, 0, 0 }
      model:member { last, next_one, section = parts.square(0.05), material = parts.steel(of[2]) }
      last = next_one
    end
    model:velocity(last, velocity)
  end
end
local soft, light, both = { E = 2060 }, { density = 7.85e-3 }, { E = 2060, density = 7.85e-3 }

return {
  { "stiffness 1 to 1e8 in one row", energy_error = 1e-2, dt = 1e-5, steps = 1000,
    build = contrasts({ { 1 }, { 1, soft }, { 1 } }, { 0, 1, 0 }) },
  { "masses 1 to 1e6 in one row", energy_error = 1e-2, dt = 1e-5, steps = 1000,
    build = contrasts({ { 1, light }, { 1 }, { 1, light }, { 1 } }, { 0, 0, 3 }) },
  { "stiffness 1 to 1e8 and masses 1 to 1e6 in one row", energy_error = 1e-2, dt = 1e-5, steps = 1000,
    build = contrasts({ { 1 }, { 1, soft }, { 1, light }, { 1, both }, { 1 } }, { 0.2, 0, 1 }) },
  { "1:2000 in compression, three times Euler's load", energy_error = 2e-2, dt = 1e-3, steps = 2000,
    build = function(model)
      local side, length = 5e-3, 10
      local nodes = parts.row(model, { 0, 0, 0 }, { 0, 0, length }, { members = 8, side = side, up = { 1, 0, 0 } })
      model:fix(nodes[1])
      local euler = math.pi ^ 2 * 206e9 * side ^ 4 / 12 / (4 * length ^ 2)
      model:load { node = nodes[9], force = { 1e-3 * euler, 0, -3 * euler } }
    end },
  { "members of 1 mm beside 10 m", energy_error = 1e-2, dt = 2e-5, steps = 1000,
    build = contrasts({ { 10 }, { 0.001 }, { 10 } }, { 0, 2, 1 }) },
  { "10 000 revolutions of a free body", energy_error = 1e-2, momentum = 1e-6, dt = 1.8e-4, steps = 1111112,
    free = true, slow = true, build = spin },
  { "10 000 revolutions in 4 000 000 steps, hardly damped", energy_error = 1e-3, momentum = 1e-6, dt = 5e-5,
    steps = 4000000, free = true, slow = true, long = true,
    build = function(model)
      spin(model)
      return { rho_infinity = 0.99 }
    end },
  { "a chain of 200 members whips freely", energy_error = 1e-2, momentum = 1e-5, dt = 2e-5, steps = 5000, free = true,
    build = function(model)
      local nodes = parts.row(model, { 0, 0, 0 }, { 20, 0, 0 }, { members = 200, side = 0.01 })
      for i = 1, 20 do model:velocity(nodes[i], { 0, 20 - i, 0 }) end
    end },
  { "hinges in every section under gravity", energy_error = 2e-2, dt = 1e-4, steps = 3000,
    build = function(model)
      parts.frame(model, { storeys = 2, bays = 2, material = parts.steel { yield_stress = 1e6 } })
      model:gravity { 0.5, 0, -9.80665 }
    end },
  { "both bendings and axial force on the yield surface's tip", energy_error = 2e-2, dt = 1e-5, steps = 2000,
    build = function(model)
      local nodes = parts.row(model, { 0, 0, 0 }, { 1, 0, 0 },
        { members = 2, material = parts.steel { yield_stress = 245e6 } })
      model:fix(nodes[1])
      model:load { node = nodes[3], force = { 5.9e5, 400, 300 },
        history = function(t) return math.min(1, t / 5e-3) end }
    end },
  { "a hinge loaded and unloaded 10 000 times", energy_error = 2e-2, dt = 5e-4, steps = 200000, slow = true,
    build = function(model)
      local nodes = parts.row(model, { 0, 0, 0 }, { 1, 0, 0 }, { material = parts.steel { yield_stress = 245e6 } })
      model:fix(nodes[1])
      model:load { node = nodes[2], force = { 0, 6500, 0 },
        history = function(t) return math.sin(2 * math.pi * 100 * t) end }
    end },
  { "supports of a loaded frame are released at once", energy_error = 1e-2, dt = 2e-4, steps = 2000,
    build = function(model)
      local joints = parts.frame(model, { storeys = 2, bays = 3 })
      local prop = model:node { 4.5, 0, 0 } -- a strut, its far end held until the run begins
      model:member { joints[1][1], prop, section = parts.square(0.1), material = parts.steel(), group = "prop" }
      model:gravity { 0, 0, -9.80665 }
      return { from = model:static { steps = 2, fixed_group = "prop" }:finish() }
    end },
  { "a load that jumps every third step", energy_error = 2e-2, dt = 1e-4, steps = 1000,
    build = function(model)
      local nodes = parts.row(model, { 0, 0, 0 }, { 2, 0, 0 }, { members = 2 })
      model:fix(nodes[1])
      model:load { node = nodes[3], force = { 0, 2e4, 1e4 },
        history = function(t) return math.floor(t / 3e-4 + 0.5) % 2 == 0 and 1 or -1 end }
    end },
  { "feet that set off, stop and turn back at once", energy_error = 1e-2, dt = 1e-4, steps = 600,
    build = function(model)
      local joints = parts.frame(model, { storeys = 2, bays = 2 })
      local feet = { joints[0][0], joints[0][1], joints[0][2] }
      -- m, s: 3 m/s forth, a rest, 6 m/s back, round again
      model:move { node = feet, x = function(t)
        local part = t % 0.02
        return part < 0.01 and 3 * part or part < 0.015 and 0.03 or 0.03 - 6 * (part - 0.015)
      end }
    end },
  { "up almost along the member", energy_error = 1e-2, dt = 1e-5, steps = 500,
    build = function(model)
      local nodes = parts.row(model, { 0, 0, 0 }, { 1, 0, 0 }, { up = { 1, 1e-5, 0 } })
      model:fix(nodes[1])
      model:velocity(nodes[2], { 0, 1, 2 })
    end },
  { "up along the member", says = "up", build = function(model)
      parts.row(model, { 0, 0, 0 }, { 1, 0, 0 }, { up = { 1, 1e-13, 0 } })
    end },
  { "twisted by more than half a turn", energy_error = 1e-2, dt = 5e-6, -- by 0.15 rad a step
    steps = 4000, build = function(model)
      local nodes = parts.row(model, { 0, 0, 0 }, { 2, 0, 0 }, { members = 2 })
      model:fix(nodes[1])
      model:velocity(nodes[3], { 0, 0, 0 }, { 3e4, 0, 0 })
    end },
  { "one node and nothing else", says = "no members", dt = 1e-4, steps = 10, build = function(model)
      model:node { 0, 0, 0 }
    end },
  { "two nodes and a member in flight", energy_error = 1e-6, momentum = 1e-9, dt = 1e-4, steps = 1000, free = true,
    build = function(model)
      parts.row(model, { 0, 0, 0 }, { 1, 0, 0 }, { group = "bar" })
      model:velocity("bar", { 3, 2, 1 })
    end },
  { "fifty bodies that have nothing to do with each other", energy_error = 1e-6, momentum = 1e-9, dt = 1e-4,
    steps = 500, free = true, build = function(model)
      for i = 1, 50 do
        parts.row(model, { 0, 2 * i, 0 }, { 1, 2 * i, 0 }, { group = "bar " .. i })
        model:velocity("bar " .. i, { i, -i, 1 })
      end
    end },
  { "statics of a mechanism", names = "mechanism", static = true, build = function(model)
      local nodes = parts.row(model, { 0, 0, 0 }, { 1, 0, 0 }, {})
      model:fix(nodes[1], "xyz")
      model:load { node = nodes[2], force = { 0, 0, -1 } }
    end },
  { "statics of a body that nothing holds", names = "mechanism", static = true, build = function(model)
      local joints = parts.frame(model, { storeys = 1, bays = 1 })
      local loose = parts.row(model, { 10, 0, 0 }, { 11, 0, 0 }, {})
      model:load { node = joints[1][1], force = { 1, 0, 0 } }
      model:load { node = loose[2], force = { 0, 0, 1 } }
    end },
  { "statics without one brace", names = "mechanism", static = true, build = function(model)
      local a, b = model:node { 0, 0, 0 }, model:node { 3, 0, 0 }
      model:fix({ a, b }, "xyz")
      local top = model:node { 1.5, 0, 3 }
      for _, foot in ipairs { a, b } do
        model:member { foot, top, section = parts.square(0.05), material = parts.steel(), up = { 0, 1, 0 } }
      end
      model:load { node = top, force = { 0, 1, 0 } } -- nothing keeps the two legs in their plane
    end },
}
