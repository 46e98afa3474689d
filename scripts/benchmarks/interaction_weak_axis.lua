-- Moments about the weak axis that sections carry beside an axial force, by the exact interaction.
--
-- Run     hinge run scripts/benchmarks/interaction_weak_axis.lua
-- Shows   interaction = "exact": a cantilever with N / N0 = 0.2, 0.4, 0.6, 0.8 is pushed to its limit load
-- Expect  the moment of plastic stress blocks: the middle part of the section, of the area n A, carries N, the rest the
--         moment. Its widths are summed here in strips, with the fillets of rolled sections and the rounded
--         corners of tubes, which hinge counts, too. Each row is the N / N0 of these four with the largest error.
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "support/?.lua;" .. package.path
local blocks = require "blocks"
local hinge = require "hinge"

local corner, of_rectangle, hollow = blocks.corner, blocks.of_rectangle, blocks.hollow

-- Height of an H at the distance s from the middle.
local function of_h(h, tw, tf, r)
  return function(s)
    if s < tw / 2 then return h end
    return 2 * (tf + (s < tw / 2 + r and corner(r, tw / 2 + r - s) or 0))
  end
end

local exact = { interaction = "exact" }
local sections = {
  { "HEB 300", hinge.section.named("HEB 300", exact), { 0.0055, 0.0325, 0.15 }, of_h(0.3, 0.011, 0.019, 0.027) },
  { "IPE 300", hinge.section.named("IPE 300", exact), { 0.00355, 0.01855, 0.075 }, of_h(0.3, 0.0071, 0.0107, 0.015) },
  { "RHS 200x100x8", hinge.section.named("RHS 200x100x8", exact), { 0.034, 0.038, 0.042, 0.05 },
    hollow(of_rectangle(0.1, 0.2, 0.012), of_rectangle(0.084, 0.184, 0.008)) },
  { "solid 100x150", hinge.section.solid { width = 0.1, depth = 0.15, interaction = "exact" },
    { 0.05 }, of_rectangle(0.1, 0.15, 0) },
}

return hinge.benchmark {
  title = "N and M about the weak axis, exact", kind = "inelastic", fast = true,
  source = "closed form: plastic stress blocks, summed over strips",
  run = function(b, job) blocks.compare(b, job, "weak", sections) end,
}
