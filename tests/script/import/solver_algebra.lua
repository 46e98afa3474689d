-- Dense algebra of the small solver beside this file: constraints by elimination, Cholesky.
local algebra = {}

function algebra.vector(n)
  local v = {}
  for i = 1, n do v[i] = 0 end
  return v
end

function algebra.zeros(n)
  local m = {}
  for i = 1, n do m[i] = algebra.vector(n) end
  return m
end

function algebra.copy(v) return table.move(v, 1, #v, 1, {}) end

function algebra.dot(a, b)
  local sum = 0
  for i, x in ipairs(a) do sum = sum + x * b[i] end
  return sum
end

function algebra.times(A, x)
  local y = {}
  for i, row in ipairs(A) do y[i] = algebra.dot(row, x) end
  return y
end

function algebra.transposed_times(A, x)
  local y = algebra.vector(#A[1])
  for i, row in ipairs(A) do
    for j, a in ipairs(row) do y[j] = y[j] + a * x[i] end
  end
  return y
end

function algebra.add_outer(A, x, y, factor)
  for i, a in ipairs(x) do
    if a ~= 0 then
      for j, b in ipairs(y) do A[i][j] = A[i][j] + factor * a * b end
    end
  end
end

--- T^t A T of square matrices.
function algebra.congruent(T, A)
  local n = #A
  local B = algebra.zeros(n)
  for i = 1, n do
    for j = 1, n do
      if A[i][j] ~= 0 then algebra.add_outer(B, T[i], T[j], A[i][j]) end
    end
  end
  return B
end

-- Constraints ---------------------------------------------------------------------------------------------------------

--- Solves equations between n degrees of freedom, sum of row[i] u[i] = 0, for some of them by the others. Rows that
--- agree with others are no matter. Returns { of = what each is: list of { free number, factor }, count =, n = }.
function algebra.eliminate(rows, n)
  local pivots = {} -- row by the degree of freedom that it gives
  local function subtract(row, other, factor)
    for i, value in pairs(other) do row[i] = (row[i] or 0) - factor * value end
  end
  for _, given in ipairs(rows) do
    local row = {}
    for i, value in pairs(given) do row[i] = value end
    for i, value in pairs(given) do
      if pivots[i] then subtract(row, pivots[i], value) end
    end
    local at
    for i, value in pairs(row) do
      local size, largest = math.abs(value), at and math.abs(row[at]) or -1
      if size > largest or size == largest and i < at then at = i end
    end
    if at and math.abs(row[at]) > 1e-9 then
      local pivot = row[at]
      for i, value in pairs(row) do row[i] = value / pivot end
      for _, other in pairs(pivots) do
        if other[at] then subtract(other, row, other[at]) end
      end
      for i = 1, n do
        if row[i] and math.abs(row[i]) < 1e-14 then row[i] = nil end
      end
      pivots[at] = row
    end
  end
  local free, count = {}, 0
  for i = 1, n do
    if not pivots[i] then
      count = count + 1
      free[i] = count
    end
  end
  local reduced = { of = {}, count = count, n = n }
  for i = 1, n do
    reduced.of[i] = free[i] and { { free[i], 1 } } or {}
    for k, value in pairs(pivots[i] or {}) do
      if k ~= i and value ~= 0 then table.insert(reduced.of[i], { free[k], -value }) end
    end
  end
  return reduced
end

-- Symmetric matrices over the free degrees of freedom -----------------------------------------------------------------

local Matrix = {}
Matrix.__index = Matrix

function algebra.reduced_matrix(reduced)
  return setmetatable({ reduced = reduced, rows = algebra.zeros(reduced.count) }, Matrix)
end

--- Adds a matrix over some of all degrees of freedom; false among them is the ground.
function Matrix:add(freedoms, k)
  local of = self.reduced.of
  for i, a in ipairs(freedoms) do
    for j, b in ipairs(freedoms) do
      if a and b and k[i][j] ~= 0 then
        for _, p in ipairs(of[a]) do
          local row = self.rows[p[1]]
          for _, q in ipairs(of[b]) do row[q[1]] = row[q[1]] + p[2] * k[i][j] * q[2] end
        end
      end
    end
  end
end

--- The lower factor of a positive matrix, by rows from their first number that is not zero. A row without any number,
--- which nothing holds and nothing moves, gets 1.
local function cholesky(A)
  local L = {}
  for i, row in ipairs(A) do
    local first = 1
    while first < i and row[first] == 0 do first = first + 1 end
    local l = { first = first }
    L[i] = l
    for j = first, i do
      local sum, other = row[j], L[j]
      for k = first > other.first and first or other.first, j - 1 do sum = sum - l[k] * other[k] end
      if j < i then
        l[j] = sum / other[j]
      else
        if row[i] == 0 then sum = 1
        elseif not (sum > 1e-12 * row[i]) then error("a mechanism: no stiffness left in an equation", 0) end
        l[i] = math.sqrt(sum)
      end
    end
  end
  return L
end

local function forward(L, b)
  local y = {}
  for i, l in ipairs(L) do
    local sum = b[i]
    for k = l.first, i - 1 do sum = sum - l[k] * y[k] end
    y[i] = sum / l[i]
  end
  return y
end

local function backward(L, b)
  local x = algebra.copy(b)
  for i = #L, 1, -1 do
    local l = L[i]
    x[i] = x[i] / l[i]
    for k = l.first, i - 1 do x[k] = x[k] - l[k] * x[i] end
  end
  return x
end

--- All degrees of freedom under the forces F.
function Matrix:solve(F)
  local of, b = self.reduced.of, algebra.vector(self.reduced.count)
  for i = 1, self.reduced.n do
    for _, p in ipairs(of[i]) do b[p[1]] = b[p[1]] + p[2] * F[i] end
  end
  for i = 1, #b do
    if self.rows[i][i] == 0 and b[i] ~= 0 then error("a load on what nothing holds", 0) end
  end
  local L = cholesky(self.rows)
  local x = backward(L, forward(L, b))
  local u = {}
  for i = 1, self.reduced.n do
    u[i] = 0
    for _, p in ipairs(of[i]) do u[i] = u[i] + p[2] * x[p[1]] end
  end
  return u
end

return algebra
