-- Moments about the strong axis that sections carry beside an axial force, by the exact interaction.
--
-- Run     hinge run scripts/benchmarks/interaction_strong_axis.lua
-- Shows   interaction = "exact": a cantilever with N / N0 = 0.2, 0.4, 0.6, 0.8 is pushed to its limit load
-- Expect  the moment of plastic stress blocks: the middle part of the section, of the area n A, carries N, the rest the
--         moment. Its widths are summed here in strips, with the fillets of rolled sections and the rounded
--         corners of tubes, which hinge counts, too. Each row is the N / N0 of these four with the largest error.
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "support/?.lua;" .. package.path
local blocks = require "blocks"
local hinge = require "hinge"

local corner, of_rectangle, hollow = blocks.corner, blocks.of_rectangle, blocks.hollow

-- Width at the distance s from the middle: of an H, of a circle.
local function of_h(h, b, tw, tf, r)
  return function(s)
    if s > h / 2 - tf then return b end
    return tw + 2 * corner(r, s - (h / 2 - tf - r))
  end
end
local function of_circle(d) return function(s) return 2 * math.sqrt(math.max((d / 2) ^ 2 - s ^ 2, 0)) end end

local exact = { interaction = "exact" }
local sections = {
  { "HEB 300", hinge.section.named("HEB 300", exact), { 0.104, 0.131, 0.15 }, of_h(0.3, 0.3, 0.011, 0.019, 0.027) },
  { "IPE 300", hinge.section.named("IPE 300", exact), { 0.1243, 0.1393, 0.15 },
    of_h(0.3, 0.15, 0.0071, 0.0107, 0.015) },
  { "RHS 200x100x8", hinge.section.named("RHS 200x100x8", exact), { 0.084, 0.088, 0.092, 0.1 },
    hollow(of_rectangle(0.2, 0.1, 0.012), of_rectangle(0.184, 0.084, 0.008)) },
  { "pipe 200x5", hinge.section.pipe { diameter = 0.2, thickness = 0.005, interaction = "exact" },
    { 0.0945, 0.095, 0.0995, 0.1 }, hollow(of_circle(0.2), of_circle(0.19)) },
  { "solid 100x150", hinge.section.solid { width = 0.1, depth = 0.15, interaction = "exact" },
    { 0.075 }, of_rectangle(0.15, 0.1, 0) },
}

return hinge.benchmark {
  title = "N and M about the strong axis, exact", kind = "inelastic", fast = true,
  source = "closed form: plastic stress blocks, summed over strips",
  run = function(b, job) blocks.compare(b, job, "strong", sections) end,
}
