-- What happens to an element that breaks, and to its mass? The paper's section 2.3, figures 4 and 5.
--
-- Run     hinge run scripts/paper/fracture_figures.lua                (quick=true: stops soon after the fracture)
-- Shows   a portal of three bars in free flight and rotation. After 5 ms the left element of the beam breaks at
--         midspan. The pictures show it as a rigid bar that ends in a virtual node. All its mass goes to the node to
--         which it is still attached
-- Expect                                    before       after
--         node 2                            9.8125 kg    14.7188 kg
--         node 6 (middle of the beam)       9.8125 kg    4.9063 kg
--         virtual node                      -            0 kg
--         mass                              58.875 kg    58.875 kg
--         momentum                          392.5        392.5 kg m/s
--         angular momentum                  441.685      441.685 kg m2/s
--         Fracture releases 1 mJ of kinetic energy and 29 mJ of strain energy
--         fig4_before.png, fig4_after.png, fig4.png: elements, rigid bar and virtual node; fig5.png: mass on the nodes
--
-- The paper's figures are sketches without numbers. The portal, its motion and the time of fracture are
-- *reconstructed*; they are parameters. In free flight no support takes a part of the momentum and energy that must be
-- kept.
local hinge = require "hinge"
local paper = require "hinge.paper"

local gap = { x = 0 / 0, z = 0 / 0, mass = 0 / 0 } -- not a number: a gap in the curve

local function size(v) return math.sqrt(v[1] ^ 2 + v[2] ^ 2 + v[3] ^ 2) end

local function measure(run)
  local pieces, momentum, energy = paper.pieces(run), run:momentum(), run.energy
  return {
    time = run.time, nodes = pieces.nodes, bars = pieces.bars, mass = momentum.mass, linear = size(momentum.linear),
    angular = size(momentum.angular), kinetic = energy.kinetic, elastic = energy.elastic,
  }
end

-- Figure 4: the pieces seen along y.
local function draw_pieces(job, pieces, legend, title, filename)
  local function series(name, style, dashed)
    return { name = legend and name or "", x = {}, y = {}, style = style, dashed = dashed }
  end
  local whole, rigid = series("element", "line"), series("fractured: rigid bar", "line", true)
  local nodes, virtual = series("node", "points"), series("virtual node", "points")
  local function add(to, point) to.x[#to.x + 1], to.y[#to.y + 1] = point.x, point.z end
  for _, bar in ipairs(pieces.bars) do
    local drawn, a, b = bar.rigid and rigid or whole, pieces.nodes[bar.a], pieces.nodes[bar.b]
    for t = 0, 1, 0.125 do -- seen by the legend
      add(drawn, { x = a.x + t * (b.x - a.x), z = a.z + t * (b.z - a.z) })
    end
    add(drawn, gap)
  end
  for _, node in ipairs(pieces.nodes) do
    if not node.gone then add(node.virtual and virtual or nodes, node) end
  end
  job:plot({ title = title, x_label = "x, m", y_label = "z, m", width = 1100, height = 1050,
    series = { whole, rigid, nodes, virtual } }, filename)
end

-- Figure 5: a stem as high as the mass on each node, before and after side by side.
local function draw_masses(job, before, after)
  local function stems(name, nodes, aside)
    local s = { name = name, x = {}, y = {} }
    for i, node in ipairs(nodes) do
      for _, mass in ipairs { 0, node.mass, gap.mass } do s.x[#s.x + 1], s.y[#s.y + 1] = i + aside, mass end
    end
    return s
  end
  job:plot({ title = "Fig. 5, mass on the nodes", x_label = "node", y_label = "mass, kg",
    series = { stems("before", before.nodes, -0.06), stems("after", after.nodes, 0.06) } }, "fig5.png")
end

local function show(before, after)
  local rows = {}
  for i, node in ipairs(after.nodes) do
    local was = before.nodes[i]
    rows[i] = { i .. (node.virtual and " (virtual)" or ""), was and ("%.4f"):format(was.mass) or "-",
      ("%.4f"):format(node.mass) }
  end
  paper.table(("Fig. 5: mass on the nodes, kg; element 3 breaks at %.2f ms"):format(1e3 * after.time),
    { "node", "before", "after" }, rows)
  rows = {}
  local lines = {
    { "mass", "mass, kg" }, { "linear", "momentum, kg m/s" }, { "angular", "angular momentum, kg m2/s" },
    { "kinetic", "kinetic energy, J" }, { "elastic", "strain energy, J" },
  }
  for i, line in ipairs(lines) do
    local a, b = before[line[1]], after[line[1]]
    rows[i] = { line[2], ("%.6f"):format(a), ("%.6f"):format(b), ("%.1e"):format(b - a) }
  end
  paper.table("What is kept, and what is released", { "", "before", "after", "change" }, rows)
end

return hinge.scenario {
  parameters = {
    side = 1, thickness = 0.05,                           -- m, *reconstructed*
    E = 206e9, nu = 0.3, density = 7850,                  -- Pa, kg/m^3, *reconstructed*
    speed = 5, spin = 10,                                 -- m/s along x, rad/s about y, *reconstructed*
    breaks = 5e-3,                                        -- s, *reconstructed*
    dt = 1e-5, duration = 0.06, quick = false,
  },

  run = function(p, job)
    local model = hinge.model { p_delta = "chord", interaction = "paper" } -- as in the paper
    local steel = hinge.material { E = p.E, nu = p.nu, density = p.density }
    local bar = hinge.section.solid { width = p.thickness, depth = p.thickness }
    local corners, members = {}, {}
    for i, place in ipairs { { 0, 0 }, { 0, 1 }, { 1, 1 }, { 1, 0 } } do
      corners[i] = model:node { p.side * place[1], 0, p.side * place[2] }
    end
    for i = 1, 3 do
      members[i] = model:member { corners[i], corners[i + 1], section = bar, material = steel, group = "portal" }
    end
    model:velocity("portal", { p.speed, 0, 0 }, { 0, p.spin, 0 })
    -- the beam's left element, at its right end: the middle of the beam
    model:fracture(function(s) return s.time > p.breaks and s.element == 3 and s["end"] == 2 end)

    local run = model:dynamic { dt = p.dt, duration = p.quick and 1.2 * p.breaks or p.duration }
    local before, after = measure(run), nil
    for _ in run:steps() do
      if not after then
        local now = measure(run)
        if run:state(members[2]) == "broken" then after = now else before = now end
      end
    end

    if not after then
      job:verdict("failed", run.verdict == "failed" and run.reason or "the element did not break")
      return {}
    end
    show(before, after)
    draw_pieces(job, before, false, "Fig. 4, before the fracture", "fig4_before.png")
    draw_pieces(job, measure(run), true, ("Fig. 4, %.0f ms after the fracture"):format(1e3 * (run.time - after.time)),
      "fig4_after.png")
    draw_masses(job, before, after)
    job:picture(run, { title = "Fig. 4, the fractured element as a rigid bar", from = { 0, -1, 0.15 } }, "fig4.png")
    return { before = before, after = after }
  end,
}
