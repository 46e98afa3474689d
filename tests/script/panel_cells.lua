-- Panels over cells, for tests.
local panel_cells = {}

--- Panels over n by m cells, each made with these options; place(i, j): where a node is. mixed: every second one has
--- its nodes the other way round. Returns nodes as nodes[i][j], and the panels.
function panel_cells.lay(model, n, m, place, options, mixed)
  local nodes, panels = {}, {}
  for i = 0, n do
    nodes[i] = {}
    for j = 0, m do nodes[i][j] = model:node(place(i, j)) end
  end
  for i = 0, n - 1 do
    for j = 0, m - 1 do
      local o = { nodes[i][j], nodes[i + 1][j], nodes[i + 1][j + 1], nodes[i][j + 1] }
      if mixed and (i + j) % 2 == 1 then o[2], o[4] = o[4], o[2] end
      for key, value in pairs(options) do o[key] = value end
      panels[#panels + 1] = model:panel(o)
    end
  end
  return nodes, panels
end

--- The places of n by n cells of a square.
function panel_cells.square(side, n) return function(i, j) return { side * i / n, side * j / n, 0 } end end

function panel_cells.on_edge(i, j, n) return i == 0 or j == 0 or i == n or j == n end

return panel_cells
