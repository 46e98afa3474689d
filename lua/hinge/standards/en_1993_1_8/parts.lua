-- What joints of steel are made of: H sections, bolts and T-stubs. EN 1993-1-8:2005.
local check = require "hinge.library.check"

local parts = {}

parts.E = 210e9 -- Pa: EN 1993-1-1, 3.2.6
parts.stress = { "number", unit = "Pa", above = 0 }
parts.length = { "number", unit = "m", above = 0 }
parts.no_length = { "number", unit = "m", at_least = 0 }
parts.factor = { "number", above = 0, default = 1 }

--- A rule with other fields: parts.with(parts.length, { optional = true }).
function parts.with(rule, more)
  local new = {}
  for k, v in pairs(rule) do new[k] = v end
  for k, v in pairs(more) do new[k] = v end
  return new
end
parts.some_length = parts.with(parts.length, { optional = true })

--- Options of a field that is a table itself, checked.
function parts.options(where, o, field, rules)
  return check.options(("%s: field '%s'"):format(where, field), o[field], rules)
end

--- Refuses a distance below its limit, m; `of`: what the limit is.
function parts.no_less(where, what, value, limit, of)
  if not (value >= limit - 1e-9) then
    check.fail("%s: %s is %s m; must be %s m or more: %s", where, what, check.show(value), check.show(limit), of)
  end
end

-- Sections ------------------------------------------------------------------------------------------------------------

--- Sizes of the H in o[field], m. r: its root radius, which makes up for the area of the plates; 0: welded.
function parts.h(where, o, field)
  local s = o[field].section
  local tw, tf = s.web, s.flange
  if not (type(tw) == "number" and type(tf) == "number" and tw > 0 and tf > 0) then
    check.fail("%s: field '%s': field 'section' is %s; must be an H, as hinge.section.h{...} or "
      .. "hinge.section.named 'HEB 300' gives", where, field, check.show(s.kind))
  end
  local h, b = s.depth, s.width
  local fillets = s.area - 2 * b * tf - (h - 2 * tf) * tw
  local r = fillets > 1e-9 * s.area and math.sqrt(fillets / (4 - math.pi)) or 0
  return { name = s.kind, h = h, b = b, tw = tw, tf = tf, r = r, hw = h - 2 * tf, A = s.area, W = s.Zx,
    fy = o[field].yield_stress, fu = o[field].ultimate_stress }
end

--- sqrt(235 MPa / f_y)
function parts.epsilon(fy) return math.sqrt(235e6 / fy) end

-- Bolts ---------------------------------------------------------------------------------------------------------------

-- Table 3.1: f_yb and f_ub, MPa; alpha_v of table 3.4 where the thread is in the shear plane.
local grades = { ["4.6"] = { 240, 400, 0.6 }, ["4.8"] = { 320, 400, 0.5 }, ["5.6"] = { 300, 500, 0.6 },
  ["5.8"] = { 400, 500, 0.5 }, ["6.8"] = { 480, 600, 0.5 }, ["8.8"] = { 640, 800, 0.6 }, ["10.9"] = { 900, 1000, 0.5 } }
-- By diameter, mm: tensile stress area (ISO 898-1), mm^2; height of head (ISO 4014), nut (ISO 4032) and washer
-- (ISO 7089), mm
local sizes = { [12] = { 84.3, 7.5, 10.8, 2.5 }, [16] = { 157, 10, 14.8, 3 }, [20] = { 245, 12.5, 18, 3 },
  [22] = { 303, 14, 19.4, 3 }, [24] = { 353, 15, 21.5, 4 }, [27] = { 459, 17, 23.8, 4 }, [30] = { 561, 18.7, 25.6, 4 },
  [36] = { 817, 22.5, 31, 5 } }

parts.bolt_rules = { diameter = parts.length, grade = { "string", one_of = check.keys(grades) } }

--- A bolt: d, d0 (its hole), As, fub, fyb, tension and shear (N, in one plane), and heights of head, nut and washer.
function parts.bolt(where, b, gamma)
  local mm = math.floor(1e3 * b.diameter + 0.5)
  local size = sizes[mm]
  if not size or math.abs(1e3 * b.diameter - mm) > 1e-6 then
    check.fail("%s: field 'bolts': field 'diameter' is %s m; must be that of a bolt M12, M16, M20, M22, M24, M27, M30 "
      .. "or M36, such as 0.02", where, check.show(b.diameter))
  end
  local grade = grades[b.grade]
  local hole = mm <= 14 and 1 or mm <= 24 and 2 or 3 -- mm: normal round holes of EN 1090-2
  local As, fub = 1e-6 * size[1], 1e6 * grade[2]
  -- a shank in the shear plane: alpha_v = 0.6 with the gross area
  local alpha, area = grade[3], As
  if b.shank then alpha, area = 0.6, math.pi * b.diameter ^ 2 / 4 end
  return { d = b.diameter, d0 = b.diameter + 1e-3 * hole, As = As, fyb = 1e6 * grade[1], fub = fub,
    tension = 0.9 * fub * As / gamma, shear = alpha * fub * area / gamma,
    head = 1e-3 * size[2], nut = 1e-3 * size[3], washer = 1e-3 * size[4] }
end

-- T-stubs -------------------------------------------------------------------------------------------------------------

--- Effective lengths of a T-stub, or a sum of them, from those of its yield patterns: 6.2.4 and tables 6.4 to 6.6.
function parts.effective(circular, other)
  return { circular = circular, other = other, mode_1 = math.min(circular, other), mode_2 = other }
end

--- Resistance of a T-stub's flange in tension, table 6.2. t: { m, n, thickness, yield_stress }, lengths: of
--- parts.effective; bolts: N, of all its bolts; head: width of head or washer, m, for the alternative of mode 1.
function parts.tee(t, lengths, bolts, head, gamma)
  local m, n = t.m, t.n
  local one = 0.25 * lengths.mode_1 * t.thickness ^ 2 * t.yield_stress / gamma
  local two = 0.25 * lengths.mode_2 * t.thickness ^ 2 * t.yield_stress / gamma
  local ew = head and head / 4
  local modes = { ew and (8 * n - 2 * ew) * one / (2 * m * n - ew * (m + n)) or 4 * one / m,
    (2 * two + n * bolts) / (m + n), bolts }
  local mode = 1
  for i = 2, 3 do
    if modes[i] < modes[mode] then mode = i end
  end
  return { m = m, n = n, lengths = lengths, modes = modes, mode = mode, resistance = modes[mode] }
end

--- Effective lengths, circular and others, of a single row outside of the tension flange: table 6.6. mx: to the weld;
--- ex: to the plate's end; e: to its side; w: gauge; b: width of the plate.
function parts.outside(mx, ex, e, w, b)
  local pi = math.pi
  return math.min(2 * pi * mx, pi * mx + w, pi * mx + 2 * e),
    math.min(4 * mx + 1.25 * ex, e + 2 * mx + 0.625 * ex, b / 2, w / 2 + 2 * mx + 0.625 * ex)
end

-- Moment and rotation -------------------------------------------------------------------------------------------------

local knee = { 2 / 3, 0.75, 0.84, 0.92, 1 } -- of the resistance: where the curve has a point

--- Points of 6.3.1 (6): elastic up to 2/3 of the resistance M, and from there S / (1.5 M_Ed / M)^2.7.
function parts.curve(M, S)
  local points = {}
  for i, part in ipairs(knee) do points[i] = { part * M / S * (1.5 * part) ^ 2.7, part * M } end
  points[1][1] = knee[1] * M / S
  return points
end

return parts
