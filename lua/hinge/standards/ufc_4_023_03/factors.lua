-- The factors of UFC 4-023-03 and of GSA's guidelines of 2016, for steel. The numbers are those of digitised tables of
-- both documents; the originals were not at hand. Not confirmed beyond that: that a column goes within a tenth of the
-- vertical period.
local factors = {}

factors.force = 2.0 -- Omega_LF
factors.irregular = 2 -- largest DCR with which linear statics may be used for an irregular structure
factors.most_storeys = 10 -- GSA: linear statics up to this height
factors.force_controlled = 0.5 -- P / P_CL of a column, above which its actions are controlled by force

--- Omega_N: r is the smallest ratio of allowed plastic rotation to rotation at yield.
function factors.nonlinear(r) return 1.08 + 0.76 / (r + 0.83) end

--- Omega_LD: m is the smallest m-factor.
function factors.linear(m) return 0.9 * m + 1.1 end

return factors
