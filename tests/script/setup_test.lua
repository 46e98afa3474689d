-- scripts/demo.sh and scripts/test.sh with a made-up machine: what they install, with which rights, and what they say
-- when they cannot. Nothing is installed: dpkg-query, apt-get, id, sudo, cmake and ctest are stand-ins that write down
-- how they were called.
--
-- Run: lua5.4 tests/script/setup_test.lua
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "?.lua;" .. package.path
local support = require "support"
local checks = support.checks "setup"
local quote, expect, equal = support.quote, checks.expect, checks.equal

local folder = support.temporary_folder()
local root, bin, log = folder .. "/a house", folder .. "/bin", folder .. "/log"
support.run(("mkdir -p %s/scripts %s && cp %s/scripts/*.sh %s/scripts")
  :format(quote(root), bin, quote(support.root), quote(root)))
for _, tool in ipairs { "bash", "dirname", "grep", "env", "mkdir", "nproc", "flock", "cat", "rm", "chmod" } do
  support.run(("ln -s $(command -v %s) %s/%s"):format(tool, bin, tool))
end

-- What the build folder holds after cmake.
local configures = (": >%s/build/build.ninja; "
  .. "printf '%%s\\n' %s CMAKE_BUILD_TYPE:STRING=Release >%s/build/CMakeCache.txt")
  :format(quote(root), quote("CMAKE_HOME_DIRECTORY:INTERNAL=" .. root), quote(root))

-- The machine: who calls, which packages it has, whether there is sudo, and what the tools return.
local function machine(m)
  support.run(("rm -rf %s %s/build %s/sudo %s/dpkg-query"):format(log, quote(root), bin, bin))
  local function tool(name, body)
    support.write(bin .. "/" .. name, "#!/usr/bin/env bash\n" .. body .. "\n")
    support.run(("chmod +x %s/%s"):format(bin, name))
  end
  local function noted(name, body) tool(name, ('echo "%s $*" >>%s\n%s'):format(name, log, body or "")) end
  if m.packages ~= false then
    local list = {}
    for name in (m.packages or ""):gmatch "%S+" do list[#list + 1] = "echo installed " .. name end
    tool("dpkg-query", table.concat(list, "\n") .. "\nexit 1")
  end
  tool("id", "echo " .. (m.user or 0))
  noted("apt-get", m.apt)
  if m.sudo then noted("sudo", '"$@"') end
  noted("cmake", m.cmake or configures)
  noted("ctest", m.ctest)
  local command = m.command or "test"
  local status, printed, complaint = support.run(("cd / && PATH=%s %s %s")
    :format(bin, quote(root .. "/scripts/" .. command .. ".sh"), m.arguments or ""))
  return status, printed, complaint, support.read(log) or ""
end

local all = (support.read(support.root .. "scripts/setup.sh") or ""):match "packages=%((.-)%)"
local readme = support.read(support.root .. "README.md") or ""
for name in all:gmatch "%S+" do
  expect(readme:find("`" .. name .. "`", 1, true), "README.md does not say why %s is needed", name)
end

local printed
local status, _, complaint, calls = machine { packages = all }
equal(status, 0, "everything installed: " .. complaint)
expect(not calls:find "apt%-get"
  and calls:find "cmake %-%-fresh.*cmake %-%-build.*ctest %-%-test%-dir .*/a house/build ", "calls: %s", calls)
expect(calls:find "%-DCMAKE_BUILD_TYPE=Release", "a release build: %s", calls)

status, printed, _, calls = machine { packages = all:gsub("catch2", ""):gsub("xvfb", "") }
equal(status, 0, "two packages missing, as root")
expect(printed:find "hinge: installing catch2 xvfb\n", "it says so: %s", printed)
expect(select(2, calls:gsub("apt%-get [^\n]*update", "")) == 1
  and calls:find "apt%-get [^\n]*install %-y %-%-no%-install%-recommends catch2 xvfb\n", "calls: %s", calls)

status, printed, _, calls = machine { packages = "", user = 1000, sudo = true }
equal(status, 0, "all missing, with sudo")
expect(printed:find "hinge: installing g%+%+ cmake .* with sudo\n"
  and calls:find "sudo env DEBIAN_FRONTEND=noninteractive apt%-get", "%s%s", printed, calls)

status, _, complaint, calls = machine { packages = all:gsub("xvfb", ""), user = 1000 }
equal(status, 1, "missing, neither root nor sudo")
equal(complaint, "hinge: missing: xvfb; to install them, run this as root or install sudo\n", "one line")
equal(calls, "", "nothing was tried")

status, _, complaint = machine { packages = false }
expect(status == 1 and complaint:find "^hinge: this is not Debian[^\n]*\n$", "no dpkg: %s", complaint)
status, _, complaint, calls = machine { packages = "", apt = "exit 100" }
expect(status == 1 and complaint:find "hinge: apt%-get update failed" and not calls:find "cmake",
  "no network: %s", complaint)
status, _, complaint, calls = machine { packages = all, cmake = "exit 1" }
expect(status == 1 and complaint:find "hinge: cmake failed" and not calls:find "ctest", "cmake fails: %s", complaint)

support.run(("rm -rf %s/build; : > %s/build"):format(quote(root), quote(root)))
status, _, complaint = support.run(("PATH=%s %s"):format(bin, quote(root .. "/scripts/demo.sh")))
expect(status == 1 and complaint:find "^hinge: cannot write to .*/a house/build; copy the repository [^\n]*\n$",
  "no room to build: %s", complaint)

status, _, _, calls = machine { packages = all, ctest = "exit 8", arguments = "-R 'a b'" }
equal(status, 8, "ctest's status")
expect(calls:find "ctest [^\n]* %-R a b\n", "arguments go to ctest: %s", calls)

-- demo.sh builds no tests and hands its arguments to the program; a second call does not configure again.
local program = ("#!/usr/bin/env bash\necho \"hinge $*\" >>%s\nexit 3\n"):format(log)
local builds = ("%s; printf %%s %s >%s/build/hinge; chmod +x %s/build/hinge")
  :format(configures, quote(program), quote(root), quote(root))
status, _, complaint, calls = machine { packages = all, command = "demo", arguments = "--case II", cmake = builds }
equal(status, 3, "the program's status: " .. complaint)
expect(calls:find "cmake %-%-build [^\n]* %-%-target hinge_program hinge_output hinge_module\n"
  and calls:find "hinge run [^\n]*/ten_storey_impact%.lua %-%-case II\n", "calls: %s", calls)
os.remove(log)
support.run(("PATH=%s %s"):format(bin, quote(root .. "/scripts/demo.sh")))
expect(not (support.read(log) or "fresh"):find "fresh", "configured twice: %s", support.read(log))
checks.done()
