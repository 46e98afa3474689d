-- Compares numbers on a page of the guide with computed ones. Blocks of Lua on a page have `claim` and `shown`.
--
-- claim("1.221 mm of bending and 0.035 mm of shear", 1e3 * bending, 1e3 * shear)
--   This piece is on the page, outside HTML comments; line breaks count as blanks. Its numbers are the values after it,
--   in their order, to half a unit of the last digit that each has on the page. A value that is a text is printed by
--   hinge and rounded itself: to one unit where it has a point.
-- local sway = shown "largest sway (%S+) mm"
--   The numbers that a pattern captures in what the page's console blocks print.

-- The numbers of a piece of text: { value =, unit = of the last digit }. Digits in a word or after one are no number.
local function numbers(piece)
  local list, at = {}, 1
  piece = piece:gsub("−", "-"):gsub("(%d),(%d%d%d)", "%1%2"):gsub("(%d),(%d%d%d)", "%1%2") -- 1,240,000
  while true do
    local from, to = piece:find("%d+%.?%d*", at)
    if not from then return list end
    local digits, before = piece:sub(from, to):gsub("%.$", ""), piece:sub(1, from - 1)
    local exponent = piece:match("^e[+-]?%d+", to + 1) or ""
    at = to + #exponent + 1
    local negative = before:find "^%-$" or before:find "[^%w)]%-$" -- and not 2-4
    if not before:find "[%w_.]$" then
      local value = tonumber((negative and "-" or "") .. digits .. exponent)
      local places = #(digits:match "%.(%d+)" or "") - (tonumber(exponent:sub(2)) or 0)
      list[#list + 1] = { value = value, unit = 10.0 ^ -places }
    end
  end
end

local function one_line(text) return (text:gsub("%s+", " ")) end

--- For a page's text without HTML comments, and what its console blocks hold: returns claim and shown.
return function(page, printed)
  page = one_line(page)
  local function claim(piece, ...)
    if not page:find(one_line(piece), 1, true) then error(("the page does not have '%s'"):format(piece), 2) end
    local found = numbers(piece)
    if #found ~= select("#", ...) then
      error(("'%s' has %d numbers, and %d values are given"):format(piece, #found, select("#", ...)), 2)
    end
    for i, number in ipairs(found) do
      local value = select(i, ...)
      local part = type(value) == "string" and value:find "%." and 1 or 1 / 2
      local allowed = part * number.unit + 1e-6 * math.abs(number.value) -- 1e-6: the iterations of a run end at 1e-8
      if not (math.abs(value - number.value) <= allowed) then
        error(("'%s': number %d is %s"):format(piece, i, value), 2)
      end
    end
  end
  local function shown(pattern)
    local captured = { printed:match(pattern) }
    if #captured == 0 then error(("nothing printed on the page fits '%s'"):format(pattern), 2) end
    for i, text in ipairs(captured) do captured[i] = tonumber(text) or error(("'%s' is no number"):format(text), 2) end
    return table.unpack(captured)
  end
  return claim, shown
end
