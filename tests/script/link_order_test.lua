-- The files that are compiled with fused products (fused_files in CMakeLists.txt) share no function with other files.
-- Otherwise the linker would keep one of two copies, and the last bits would depend on the order of the files.
-- In all other files a product and a sum stay two operations, whatever the compiler takes together. Otherwise the last
-- bits would depend on which functions it takes into which.
--
-- Run: lua5.4 tests/script/link_order_test.lua NM OBJDUMP BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "?.lua;" .. package.path
local support = require "support"
local checks = support.checks "link_order"
local case, quote = checks.case, support.quote

--- The names of functions that the linker merges between files, which `file` defines; how many other ones it defines.
local function merged_functions(file)
  local status, printed, complaint = support.run(("%s --defined-only --demangle %s"):format(quote(arg[1]), quote(file)))
  checks.equal(status, 0, "nm: " .. complaint)
  local merged, others = {}, 0
  for kind, name in printed:gmatch "%x+ (%a) ([^\n]+)" do
    if kind == "W" then merged[#merged + 1] = name elseif kind == "T" then others = others + 1 end
  end
  return merged, others
end

case("of the fused files, other files can reach only what is theirs alone", function()
  local merged, others = merged_functions(arg[3] .. "/hinge_engine_fused.o")
  checks.expect(others > 10, "only %d functions: is this the object of the fused files?", others)
  for _, name in ipairs(merged) do
    -- its own, or of the standard library for a type of its own: a build that is not optimised has these apart
    checks.expect(name:find "hinge::Condensed<%a+>::", "%s can take the place of another file's copy", name)
  end
end)

-- gcc 12 makes them of a sum and a difference that stand side by side, also with -ffp-contract=off, but not with
-- -fno-tree-slp-vectorize. Without that option each of these files has some, on a processor with fused products.
case("no file but those has fused sums and differences", function()
  for _, file in ipairs { "model/structure", "effects/fracture", "state/hinges", "effects/point_mass" } do
    local object = ("%s/CMakeFiles/hinge_engine.dir/src/%s.cpp.o"):format(arg[3], file)
    local status, printed, complaint = support.run(("%s -d %s"):format(quote(arg[2]), quote(object)))
    checks.equal(status, 0, "objdump: " .. complaint)
    checks.expect(#printed > 10000, "%s: nothing to look at", file)
    local found = printed:match "vfm%a-addsub%w+" or printed:match "vfm%a-subadd%w+"
    checks.expect(not found, "%s has %s", file, tostring(found))
  end
end)

checks.done()
