-- The files that are compiled with fused products (fused_files in CMakeLists.txt) share no function with other files.
-- Otherwise the linker would keep one of two copies, and the last bits would depend on the order of the files.
-- In all other files a product and a sum stay two operations, whatever the compiler takes together. Otherwise the last
-- bits would depend on which functions it takes into which.
--
-- Run: lua5.4 tests/script/tree/link_order_test.lua NM OBJDUMP BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
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
-- -fno-tree-slp-vectorize. Without that option many files have some, on a processor with fused products.
-- Eigen multiplies packets of complex numbers with such an instruction, wherever that stands.
local allowed = { ["hinge_engine_fused.o"] = true, ["eigenpairs.cpp.o"] = true, ["negative_modes.cpp.o"] = true,
  ["unsymmetric_pairs.cpp.o"] = true }

case("no file but those has fused sums and differences", function()
  local command = "%s -d %s/libhinge_engine.a | grep -E 'file format|vfm[a-z]*addsub|vfm[a-z]*subadd'"
  local status, printed, complaint = support.run(command:format(quote(arg[2]), quote(arg[3])))
  checks.equal(status, 0, "objdump: " .. complaint)
  local file, files = nil, 0
  for line in printed:gmatch "[^\n]+" do
    local object = line:match "^(%S+):%s+file format"
    if object then
      file, files = object, files + 1
    else
      checks.expect(allowed[file], "%s has %s", tostring(file), line:match "vfm%w+")
    end
  end
  checks.expect(files > 10, "only %d files: is this the engine's library?", files)
end)

checks.done()
