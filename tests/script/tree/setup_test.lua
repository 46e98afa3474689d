-- scripts/demo.sh, test.sh, package.sh and setup.sh with a made-up machine: what they install, with which rights, and
-- what they say when they cannot. Nothing is installed: dpkg-query, apt-get, rpm, dnf, id, sudo, cmake, ctest and cpack
-- are stand-ins that write down how they were called.
--
-- Run: lua5.4 tests/script/tree/setup_test.lua
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "setup"
local case, ended = checks.case, checks.ended
local quote, expect, equal = support.quote, checks.expect, checks.equal

local folder = support.temporary_folder()
local root, bin, log = folder .. "/a house", folder .. "/bin", folder .. "/log"
support.run(("mkdir -p %s/scripts %s && cp %s/scripts/*.sh %s/scripts && cp -r %s/.ci %s")
  :format(quote(root), bin, quote(support.root), quote(root), quote(support.root), quote(root)))
for _, tool in ipairs { "bash", "dirname", "grep", "env", "mkdir", "nproc", "flock", "cat", "rm", "chmod" } do
  support.run(("ln -s $(command -v %s) %s/%s"):format(tool, bin, tool))
end

-- What the build folder holds after cmake.
local configures = (": >%s/build/build.ninja; "
  .. "printf '%%s\\n' %s CMAKE_BUILD_TYPE:STRING=Release >%s/build/CMakeCache.txt")
  :format(quote(root), quote("CMAKE_HOME_DIRECTORY:INTERNAL=" .. root), quote(root))

-- The same, with a program that ends with this status.
local function builds(status)
  local program = ("#!/usr/bin/env bash\necho \"hinge $*\" >>%s\nexit %d\n"):format(log, status)
  return ("%s; printf %%s %s >%s/build/hinge; chmod +x %s/build/hinge"):format(configures, quote(program), quote(root),
    quote(root))
end

-- The machine: its system, who calls, which packages it has, whether there is sudo, and what the tools return. The
-- script ends with this status and words. Returns what it printed and how the tools were called.
local function machine(wanted, words, m)
  support.run(("rm -rf %s %s/build*; cd %s && rm -f sudo dpkg-query apt-get rpm dnf"):format(log, quote(root), bin))
  support.write(folder .. "/os-release", ("ID=%s\n"):format(m.system or "debian"))
  local function tool(name, body)
    support.write(bin .. "/" .. name, "#!/usr/bin/env bash\n" .. body .. "\n")
    support.run(("chmod +x %s/%s"):format(bin, name))
  end
  local function noted(name, body) tool(name, ('echo "%s $*" >>%s\n%s'):format(name, log, body or "")) end
  if m.system == "fedora" then
    tool("rpm", ([[case " %s " in *" ${*: -1} "*) ;; *) exit 1 ;; esac]]):format((m.packages:gsub("%s+", " "))))
    noted("dnf", m.dnf)
  elseif m.packages ~= false then
    local list = {}
    for name in (m.packages or ""):gmatch "%S+" do list[#list + 1] = "echo installed " .. name end
    tool("dpkg-query", table.concat(list, "\n") .. "\nexit 1")
    noted("apt-get", m.apt)
  end
  tool("id", "echo " .. (m.user or 0))
  if m.sudo then noted("sudo", '"$@"') end
  noted("cmake", m.cmake or configures)
  noted("ctest", m.ctest)
  noted("cpack", m.cpack)
  local command = m.ci and "/.ci/run" or "/scripts/" .. (m.command or "test") .. ".sh"
  local printed = ended(wanted, words, support.run(("cd / && os_release=%s/os-release PATH=%s %s %s")
    :format(folder, bin, quote(root .. command), m.arguments or "")))
  return printed, support.read(log) or ""
end

local setup = support.read(support.root .. "scripts/setup.sh") or ""
local function list(name) return assert(setup:match("\n" .. name .. "=%((.-)%)"), name) end
local of_program, of_fedora = list "debian", list "fedora"
local all = of_program .. " " .. list "debian_tests"
case("setup installs what is missing, by root or sudo, and names what fails", function()
  local page = support.read(support.root .. "lua/guide/install.md") or ""
  for name in (all .. " " .. of_fedora):gmatch "%S+" do
    expect(page:find("`" .. name .. "`", 1, true), "lua/guide/install.md does not say why %s is needed", name)
  end

  local _, calls = machine(0, "", { packages = all })
  expect(not calls:find "apt%-get"
    and calls:find "cmake %-%-fresh.*cmake %-%-build.*ctest %-%-test%-dir .*/a house/build ", "calls: %s", calls)
  expect(calls:find "%-DCMAKE_BUILD_TYPE=Release", "a release build: %s", calls)

  _, calls = machine(0, "hinge: installing xvfb catch2\n", { packages = all:gsub("catch2", ""):gsub("xvfb", "") })
  expect(select(2, calls:gsub("apt%-get [^\n]*update", "")) == 1
    and calls:find "apt%-get [^\n]*install %-y %-%-no%-install%-recommends xvfb catch2\n", "calls: %s", calls)

  _, calls = machine(0, { "hinge: installing g++ cmake ", " with sudo\n" }, { packages = "", user = 1000, sudo = true })
  expect(calls:find "sudo env DEBIAN_FRONTEND=noninteractive apt%-get", "calls: %s", calls)

  _, calls = machine(1, "hinge: missing: xvfb; to install them, run this as root or install sudo\n",
    { packages = all:gsub("xvfb", ""), user = 1000 })
  equal(calls, "", "nothing was tried")

  machine(1, "hinge: this is neither Debian, Ubuntu nor Fedora", { packages = false })
  _, calls = machine(1, "hinge: apt-get update failed", { packages = "", apt = "exit 100" }) -- no network
  expect(not calls:find "cmake", "calls: %s", calls)
  _, calls = machine(1, "hinge: cmake failed", { packages = all, cmake = "exit 1" })
  expect(not calls:find "ctest", "calls: %s", calls)
end)

case("Ubuntu and Fedora get their own packages", function()
  local _, calls = machine(0, "hinge: installing file\n",
    { system = "ubuntu", packages = of_program:gsub("file", ""), command = "demo", cmake = builds(0) })
  expect(not calls:find "catch2" and calls:find "cmake %-%-fresh [^\n]*%-DHINGE_TESTS=OFF", "Ubuntu: %s", calls)
  _, calls = machine(1, "hinge: the tests are held to the tools of Debian 12",
    { system = "ubuntu", packages = of_program })
  equal(calls, "", "tests on Ubuntu")
  _, calls = machine(0, "hinge: installing vtk-devel with sudo\n", { system = "fedora",
    packages = of_fedora:gsub("vtk%-devel", ""), command = "demo", user = 1000, sudo = true, cmake = builds(0) })
  expect(calls:find "dnf install %-y %-%-setopt=install_weak_deps=False vtk%-devel\n"
    and calls:find "cmake %-%-fresh [^\n]*%-DHINGE_TESTS=OFF", "Fedora: %s", calls)
  machine(1, "hinge: dnf could not install gcc-c++ ",
    { system = "fedora", packages = "", command = "demo", dnf = "exit 1" })
end)

case("setup.sh alone installs, and prints what it would for a system", function()
  local _, calls = machine(0, "", { packages = all:gsub("file", ""), command = "setup" })
  expect(calls:find "install %-y %-%-no%-install%-recommends file\n" and not calls:find "cmake", "calls: %s", calls)
  local by_apt = "apt%-get [^\n]*update\n[^\n]*apt%-get [^\n]*install %-y [^\n]*"
  for system, m in pairs { debian = { all, by_apt }, ubuntu = { of_program, by_apt },
    fedora = { of_fedora, "^dnf install %-y [^\n]*" } } do
    for _, arguments in ipairs { "--print", "--print " .. system } do
      local printed, called = machine(0, "", { system = arguments == "--print" and system or "debian", packages = "",
        command = "setup", arguments = arguments })
      equal(called, "", arguments .. " does nothing")
      local packages = m[1]:gsub("%s+", " "):gsub("%p", "%%%0")
      expect(printed:find(m[2] .. packages .. "\ncmake %-S %. %-B build [^\n]*\ncmake %-%-build build\n$"),
        "%s on %s: %s", arguments, system, printed)
      equal(printed:find("-DHINGE_TESTS=OFF", 1, true) ~= nil, system ~= "debian", system .. ": without the tests")
    end
  end
  local printed = machine(0, "", { packages = "", command = "setup", arguments = "--print fedora", user = 1000 })
  expect(printed:find "^sudo dnf ", "as a user: %s", printed)
  machine(1, "hinge: no system 'plan9': debian, ubuntu or fedora\n",
    { packages = "", command = "setup", arguments = "--print plan9" })
  machine(1, "hinge: setup.sh takes nothing, or --print ",
    { packages = "", command = "setup", arguments = "--install" })
end)

case("package.sh builds for any processor in a folder of its own", function()
  local in_package = configures:gsub("/build/", "/build-package/")
  local printed, calls = machine(0, "", { packages = of_program, command = "package", cmake = in_package,
    cpack = (": >%s/build-package/hinge_1_any.deb"):format(quote(root)) })
  expect(not calls:find "apt%-get", "package.sh needs no tools of the tests: %s", calls)
  expect(calls:find "cmake %-%-fresh [^\n]*/build%-package [^\n]*%-DHINGE_NATIVE=OFF %-DHINGE_TESTS=OFF\n"
    and calls:find "cpack %-%-config [^\n]*/build%-package/CPackConfig.cmake ", "package.sh: %s", calls)
  equal(printed, ("sudo apt-get install '%s/build-package/hinge_1_any.deb'\n"):format(root), "what to type next")

  calls = select(2, machine(1, "hinge: a Debian package is made on Debian or Ubuntu",
    { system = "fedora", packages = of_fedora, command = "package" }))
  equal(calls, "", "package.sh on Fedora")
end)

case("the container is built by package.sh from files that are there", function()
  local container = support.read(support.root .. "scripts/Containerfile") or ""
  expect(container:find "\nRUN scripts/package%.sh\n", "the container is built by another script")
  for names in container:gmatch "\nCOPY ([^-][^\n]*) %S+\n" do
    for name in names:gmatch "%S+" do
      expect(support.is_there(support.root .. name), "the Containerfile copies %s, which is not there", name)
    end
  end
  expect(container:find "\nCOPY [^\n]*LICENSE", "the Containerfile does not copy LICENSE, which is installed")
end)

case("a folder that cannot be written to is named, and ctest's status and arguments go through", function()
  support.run(("rm -rf %s/build; : > %s/build"):format(quote(root), quote(root)))
  ended(1, { "hinge: cannot write to ", "/a house/build; copy the repository " },
    support.run(("PATH=%s %s"):format(bin, quote(root .. "/scripts/demo.sh"))))
  local _, calls = machine(8, "", { packages = all, ctest = "exit 8", arguments = "-R 'a b'" })
  expect(calls:find "ctest [^\n]* %-R a b\n", "arguments go to ctest: %s", calls)
end)

case(".ci/run builds for this processor and for plain x86-64 and tests both", function()
  local _, calls = machine(8, "", { packages = all, ci = true, ctest = "exit 8", arguments = "-R guide",
    cmake = configures .. ("; echo \"ccache in $CCACHE_BASEDIR\" >>%s"):format(log) })
  local first, second = calls:match "(cmake %-%-fresh [^\n]*)\n.*(cmake %-%-fresh [^\n]*)\n"
  expect(first and first:find("/a house/build -G", 1, true) and not first:find "HINGE_", "for this processor: %s",
    calls)
  expect(second and second:find "/a house/build%-plain [^\n]*%-DHINGE_NATIVE=OFF %-DHINGE_TEST_PREFIX=plain_",
    "for plain x86-64: %s", calls)
  equal(select(2, calls:gsub("\nccache in " .. root .. "\n", "")), 4,
    "calls of cmake in which the builds share a cache")
  expect(select(2, calls:gsub("ctest ", "")) == 1 and calls:find "ctest %-%-test%-dir [^\n]*/both [^\n]* %-R guide\n$",
    "one ctest, at the end: %s", calls)
  equal(support.read(root .. "/build-plain/both/CTestTestfile.cmake"),
    ('subdirs("%s/build")\nsubdirs("%s/build-plain")\n'):format(root, root), "what ctest tests")
end)

case("demo.sh builds no tests and hands its arguments to the program", function()
  local _, calls = machine(3, "", { packages = all, command = "demo", arguments = "--case II", cmake = builds(3) })
  expect(calls:find "cmake %-%-build [^\n]* %-%-target hinge_program hinge_output hinge_module\n"
    and calls:find "hinge run [^\n]*/ten_storey_impact%.lua %-%-case II\n", "calls: %s", calls)
  os.remove(log)
  support.run(("PATH=%s %s"):format(bin, quote(root .. "/scripts/demo.sh")))
  expect(not (support.read(log) or "fresh"):find "fresh", "configured twice: %s", support.read(log))
end)

case("demo.sh leaves the tests out, and test.sh adds them to the same build", function()
  local _, calls = machine(0, "hinge: installing xvfb\n",
    { packages = of_program:gsub("xvfb", ""), command = "demo", cmake = builds(0) })
  expect(calls:find "cmake %-%-fresh [^\n]*%-DHINGE_TESTS=OFF\n", "the first build: %s", calls)

  -- test.sh where demo.sh built: cmake is told once more, and nothing is built from the start
  local cache = quote(root .. "/build/CMakeCache.txt")
  local with_tests = ("PATH=%s os_release=%s/os-release %s"):format(bin, folder, quote(root .. "/scripts/test.sh"))
  support.run(("mkdir -p %s && %s; echo HINGE_TESTS:BOOL=OFF >>%s"):format(quote(root .. "/build"), configures, cache))
  os.remove(log)
  support.run(with_tests)
  calls = support.read(log) or ""
  expect(calls:find "cmake %-S [^\n]*/build %-DHINGE_TESTS=ON\n" and not calls:find "%-%-fresh", "calls: %s", calls)
  support.run(("%s; echo HINGE_TESTS:BOOL=ON >>%s"):format(configures, cache))
  os.remove(log)
  support.run(with_tests)
  calls = support.read(log) or ""
  expect(calls:find "cmake %-%-build" and not calls:find "HINGE_TESTS", "a build with tests: %s", calls)
end)

checks.done()
