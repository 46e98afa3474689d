-- The small solver that imported frames are compared with (import/solver.lua) against formulas by hand.
--
-- Run: lua5.4 tests/script/import/import_solver_test.lua
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "the small solver"
local case, near = checks.case, checks.near
local solver = dofile(support.folder .. "import/solver.lua")

-- A value to eleven digits of another size: what Cholesky of these small matrices leaves.
local function same(found, wanted, what, size) near(found, wanted, 1e-11 * (size or math.abs(wanted)), what) end

local E, G, A, Iz, Iy, J, L = 210, 80, 3, 4, 2.5, 1.5, 7
local Avy, Avz = 1.1, 1.7

local function cantilever(more)
  local s = solver.new "plane"
  s:node("a", 0, 0)
  s:node("b", L, 0)
  s:fix("a", "x y rz")
  local p = { "m", "a", "b", E = E, A = A, Iz = Iz }
  for key, value in pairs(more or {}) do p[key] = value end
  s:beam(p)
  return s
end

case("a cantilever: P L^3 / 3 E I, with P L / G A_v in Timoshenko's beam; reactions", function()
  for shear = 0, 1 do
    local s = cantilever(shear == 1 and { G = G, Avy = Avy } or {})
    s:load("b", { x = 5, y = -2, rz = 3 })
    local r = s:solve()
    same(r.u.b.x, 5 * L / (E * A), "along")
    same(r.u.b.y, -2 * L ^ 3 / (3 * E * Iz) + 3 * L ^ 2 / (2 * E * Iz) - shear * 2 * L / (G * Avy), "across")
    same(r.u.b.rz, -2 * L ^ 2 / (2 * E * Iz) + 3 * L / (E * Iz), "rotation")
    same(r.reaction.a.x, -5, "reaction x")
    same(r.reaction.a.y, 2, "reaction y")
    same(r.reaction.a.rz, 2 * L - 3, "reaction rz")
  end
end)

case("a cantilever in any direction of space bends in both planes and twists", function()
  local x = { 2 / 3, -1 / 3, 2 / 3 }
  local y = { 1 / 3, 14 / 15, 2 / 15 } -- not at right angles: vecxz is in the plane of x and z
  local s = solver.new()
  s:node("a", 1, 2, 3)
  s:node("b", 1 + L * x[1], 2 + L * x[2], 3 + L * x[3])
  s:fix("a", "x y z rx ry rz")
  s:beam { "m", "a", "b", E = E, G = G, A = A, Iz = Iz, Iy = Iy, J = J, Avy = Avy, Avz = Avz, vecxz = y }
  local axes = s.elements.m.axes
  for i = 1, 3 do same(axes[1][i], x[i], "x of the beam") end
  same(axes[2][1] * y[1] + axes[2][2] * y[2] + axes[2][3] * y[3], 0, "y of the beam is across vecxz", 1)
  local f, m = { 0, 2, 3 }, { 4, 0, 0 } -- along the beam's axes
  local function space(v, i) return v[1] * axes[1][i] + v[2] * axes[2][i] + v[3] * axes[3][i] end
  s:load("b", { x = space(f, 1), y = space(f, 2), z = space(f, 3) })
  s:load("b", { rx = space(m, 1), ry = space(m, 2), rz = space(m, 3) })
  local u = s:solve().u.b
  local function along(i) return u.x * axes[i][1] + u.y * axes[i][2] + u.z * axes[i][3] end
  same(along(2), 2 * (L ^ 3 / (3 * E * Iz) + L / (G * Avy)), "along y")
  same(along(3), 3 * (L ^ 3 / (3 * E * Iy) + L / (G * Avz)), "along z")
  same(u.rx * x[1] + u.ry * x[2] + u.rz * x[3], 4 * L / (G * J), "twist")
  local about_y = u.rx * axes[2][1] + u.ry * axes[2][2] + u.rz * axes[2][3]
  same(about_y, -3 * L ^ 2 / (2 * E * Iy), "a force along z turns about -y")
end)

case("loads between the ends: uniform and point", function()
  local function clamped(load, more)
    local s = cantilever(more)
    s:fix("b", "x y rz")
    s:beam_load("m", load)
    return s:solve()
  end
  local r = clamped { q = { 0, -6, 0 } }
  same(r.reaction.a.rz, 6 * L ^ 2 / 12, "q L^2 / 12")
  same(r.reaction.a.y, 3 * L, "q L / 2")
  r = clamped { force = { 2, -6, 0 }, at = 0.25 }
  same(r.reaction.a.rz, 6 * (L / 4) * 0.75 ^ 2, "P a b^2 / L^2")
  same(r.reaction.b.x, -0.5, "P a / L")
  -- with shear: reactions of a symmetric load are those without; half the load at a quarter is not
  same(clamped({ q = { 0, -6, 0 } }, { G = G, Avy = Avy }).reaction.a.rz, 6 * L ^ 2 / 12, "q L^2 / 12 with shear")
  local s = cantilever { G = G, Avy = Avy }
  s:beam_load("m", { q = { 0, -3, 0 } })
  same(s:solve().u.b.y, -3 * L ^ 4 / (8 * E * Iz) - 3 * L ^ 2 / (2 * G * Avy), "q L^4 / 8 E I + q L^2 / 2 G A_v")
end)

case("releases and springs", function()
  local s = cantilever { release_j = "rz" }
  s:fix("b", "y rz")
  s:beam_load("m", { q = { 0, -8, 0 } })
  local r = s:solve()
  same(r.reaction.b.y, 3 * L, "3 q L / 8")
  same(r.reaction.a.rz, L ^ 2, "q L^2 / 8")
  same(r.reaction.b.rz, 0, "no moment at the release", 1)

  s = cantilever()
  s:spring { "spring", "b", nil, y = 50 }
  s:load("b", { y = 10 })
  same(s:solve().u.b.y, 10 / (50 + 3 * E * Iz / L ^ 3), "a spring to the ground")
  s = cantilever()
  s:node("c", L, 0)
  s:fix("c", "x rz")
  s:spring { "spring", "b", "c", y = 50 }
  s:load("c", { y = 10 })
  same(s:solve().u.c.y, 10 / 50 + 10 * L ^ 3 / (3 * E * Iz), "a spring between nodes")

  -- a spring along a diagonal to the ground holds a roller on it as k cos^2
  s = cantilever()
  s:spring { "spring", "b", nil, x = 50, axes = { { 0.6, 0.8, 0 }, { -0.8, 0.6, 0 }, { 0, 0, 1 } } }
  s:fix("b", "x")
  s:load("b", { y = 10 })
  same(s:solve().u.b.y, 10 / (50 * 0.64 + 3 * E * Iz / L ^ 3), "a spring along a diagonal")

  -- a rod of length 2 whose shear spring lies in its middle: the force at its end turns the other by half its length
  s = cantilever()
  s:node("c", L + 2, 0)
  s:fix("c", "rz")
  s:spring { "link", "b", "c", x = 1e9, y = 50, rz = 70, arm_i = { 1, 0, 0 }, arm_j = { -1, 0, 0 } }
  s:load("c", { y = 10 })
  local b = s:solve()
  same(b.u.c.y - b.u.b.y - b.u.b.rz, 10 / 50, "shear of the link")
end)

case("a truss: two bars at 45 degrees carry as 2 E A / L cos^2", function()
  local s = solver.new "plane"
  for name, at in pairs { a = { -1, 1 }, b = { 1, 1 }, c = { 0, 0 } } do s:node(name, at[1], at[2]) end
  for _, name in ipairs { "a", "b" } do
    s:fix(name, "x y")
    s:beam { name, name, "c", E = E, A = A }
  end
  s:load("c", { y = -6 })
  local r = s:solve()
  same(r.u.c.y, -6 / (E * A / math.sqrt(2)), "down")
  same(r.reaction.a.y, 3, "half of the load")
end)

case("links, floors and equal degrees of freedom; those that agree are no matter", function()
  -- a rigid link at a cantilever's end: the load at its arm turns it
  local s = cantilever()
  s:node("c", L + 2, 1)
  s:rigid("b", "c", "x y rz")
  s:load("c", { y = -5 })
  local r = s:solve()
  same(r.u.b.rz, -5 * (L ^ 2 / 2 + 2 * L) / (E * Iz), "rotation")
  same(r.u.c.y, r.u.b.y + 2 * r.u.b.rz, "the end of the arm")
  same(r.reaction.a.rz, 5 * (L + 2), "moment of the support")

  -- the same by an arm of the beam, and by a beam of which the arm is taken away at both ends
  s = solver.new "plane"
  s:node("a", -1, 0)
  s:node("c", L + 2, 0)
  s:fix("a", "x y rz")
  s:beam { "m", "a", "c", E = E, A = A, Iz = Iz, arm_i = { 1, 0, 0 }, arm_j = { -2, 0, 0 } }
  s:load("c", { y = -5 })
  local u = s:solve()
  same(u.u.c.y, -5 * (L ^ 3 / 3 + 2 * L ^ 2 + 4 * L) / (E * Iz), "rigid ends: P (L^3 / 3 + L^2 a + L a^2) / E I")
  same(u.reaction.a.rz, 5 * (L + 3), "moment at the node")

  -- a floor on three columns: 12 E I / h^3 each along both axes, and its turn about the middle
  s = solver.new()
  local k = 12 * E * Iz / L ^ 3
  for i, at in ipairs { { -3, 0 }, { 3, 0 }, { 0, 4 } } do
    s:node("foot" .. i, at[1], at[2], 0)
    s:node("head" .. i, at[1], at[2], L)
    s:fix("foot" .. i, "x y z rx ry rz")
    s:fix("head" .. i, "rx ry")
    s:beam { "column" .. i, "foot" .. i, "head" .. i, E = E, G = G, A = A, Iz = Iz, Iy = Iz, J = J }
    s:rigid("head1", "head" .. i, i == 1 and "" or "x y rz")
  end
  s:rigid("head2", "head3", "x y rz") -- agrees with the others
  s:load("head1", { x = 9 })
  r = s:solve()
  -- the middle of stiffness is (0, 4/3); the force at y = 0 turns the floor
  local turn = 9 * (4 / 3) / (k * (2 * (9 + 16 / 9) + 64 / 9) + 3 * G * J / L)
  same(r.u.head1.rz, turn, "turn of the floor")
  same(r.u.head1.x, 9 / (3 * k) + turn * 4 / 3, "a corner's way along the force")
  same(r.u.head3.x, r.u.head1.x - 4 * turn, "the third corner's way")

  s = cantilever()
  s:node("c", L, 0)
  s:fix("c", "rz")
  s:equal("b", "c", "x y")
  s:fix("c", "x")
  s:fix("b", "x")
  s:load("c", { y = 1 })
  same(s:solve().u.b.y, L ^ 3 / (3 * E * Iz), "equal, and both held along x")
end)

case("a mechanism and a node that nothing holds are errors", function()
  local s = cantilever { release_i = "rz", release_j = "rz" }
  s:load("b", { y = 1 })
  checks.refused("mechanism", s.solve, s)
  s = cantilever()
  s:node("c", 1, 1)
  s:load("c", { y = 1 })
  checks.refused("nothing holds", s.solve, s)
end)

checks.done()
