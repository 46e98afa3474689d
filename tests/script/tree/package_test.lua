-- The Debian package of this build: what it depends on and holds; unpacked, the program and plain Lua run from there
-- with an empty environment and an empty home; as root it is installed, used without any variable, and removed.
-- Nothing is compiled. Where there are no tools of Debian, it says so and is skipped (status 77).
--
-- Run: lua5.4 tests/script/tree/package_test.lua BUILD_FOLDER [CPACK]
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "package"
local case = checks.case
local quote, run, expect, equal = support.quote, support.run, checks.expect, checks.equal

for _, tool in ipairs { "dpkg", "dpkg-deb", "dpkg-shlibdeps", "dpkg-architecture", "file" } do
  if run("command -v " .. tool) ~= 0 then checks.skip("there is no " .. tool) end
end
local version = (support.read(support.root .. "CMakeLists.txt") or ""):match "project%(hinge VERSION ([%d.]+)"
local pictures = support.is_there(arg[1] .. "/libhinge_output.so")
local folder = support.temporary_folder()
local place, home = folder .. "/a place", folder .. "/home"
run(("mkdir %s %s %s/made"):format(quote(place), home, folder))

local status, printed, complaint = run(("cd %s/made && %s -G DEB --config %s/CPackConfig.cmake -B %s/made")
  :format(folder, quote(arg[2] or "cpack"), quote(arg[1]), folder))
assert(status == 0, printed .. complaint)
local package_file = support.output(("ls %s/made/*.deb"):format(folder)):gsub("\n$", "")
case("the Debian package names its version, needs and files", function()
  expect(package_file:find("/hinge_" .. version .. "_%w+%.deb$"), "it made %s", package_file)

  -- What it says of itself.
  local control = support.output("dpkg-deb -f " .. package_file)
  local depends = control:match "\nDepends: ([^\n]*)" or ""
  for _, wanted in ipairs { "\nPackage: hinge\n", "\nVersion: " .. version .. "\n", "\nMaintainer: " } do
    expect(("\n" .. control .. "\n"):find(wanted, 1, true), "no %s in %s", wanted:gsub("\n", ""), control)
  end
  local libraries = { "libc6", "libstdc++6", "liblua5.4-0", "libedit2", "zlib1g", pictures and "libvtk9" or nil }
  for _, name in ipairs(libraries) do
    expect(depends:find("%f[%w]" .. name:gsub("%p", "%%%0")), "it does not depend on %s: %s", name, depends)
  end
  expect(not depends:find "%-dev%f[^%w]", "it depends on header files: %s", depends)
  for line in support.output("dpkg-deb -c " .. package_file):gmatch "[^\n]+" do
    local mode, owner = line:match "^(%S+)%s+(%S+)"
    expect(owner == "root/root" and mode:find "^[-d]rw.r%-.r%-.$", "others may not read it, or may write it: %s", line)
  end
end)

-- Unpacked ------------------------------------------------------------------------------------------------------------

assert(run(("dpkg-deb -x %s %s"):format(package_file, quote(place))) == 0, "dpkg-deb -x")
case("the unpacked package has its documents and no header files", function()
  for _, name in ipairs { "doc/hinge/copyright", "doc/hinge/CHANGES.md", "doc/hinge/guide/install.md",
    "man/man1/hinge.1",
    "doc/hinge/examples/01_first_cantilever.lua" } do
    expect(support.is_there(place .. "/usr/share/" .. name), "it does not hold %s", name)
  end
  expect(not support.is_there(place .. "/usr/include"), "it holds header files")
end)

local module = support.output(("find %s -name hinge.so"):format(quote(place))):gsub("\n$", "")
local multiarch = support.output "dpkg-architecture -q DEB_HOST_MULTIARCH":gsub("\n$", "")
case("the module lies where Lua looks for it", function()
  equal(module, place .. "/usr/lib/" .. multiarch .. "/lua/5.4/hinge.so", "where the module lies")
end)

-- In an empty environment: an example of the package gives its number, a frame is written, plain Lua finds the same
-- library, and none of it comes from the folders of the build. `usr`: where the package lies.
support.write(folder .. "/frame.lua", support.frame_script())
local asks = "local hinge = require 'hinge' local section = require 'hinge.sections' "
  .. "print(hinge.version, section ~= nil, package.searchpath('hinge', package.path))"
local function works(usr, environment, lua_environment, what)
  local clean = ("cd %s && env -i HOME=%s %s "):format(home, home, environment)
  local wanted = ("%s\ttrue\t%s/share/hinge/lua/hinge/init.lua\n"):format(version, usr)
  status, printed, complaint = run(clean .. "hinge -e " .. quote(asks .. " return 1"))
  equal(printed, wanted .. "1\n", what .. complaint)
  local example = support.is_there(usr .. "/share/doc/hinge/examples") and usr .. "/share/doc/hinge/examples/"
    or support.root .. "scripts/" -- dpkg may be told to leave pages out
  status, printed, complaint = run(clean .. "hinge run " .. quote(example .. "01_first_cantilever.lua"))
  checks.prints(printed, "tip goes down by 3.112854 mm\nwritten to out/01_first_cantilever\n",
    what .. ", an example: " .. complaint)
  status, printed, complaint = run(("cd %s && env -i %s lua5.4 -e %s"):format(home, lua_environment, quote(asks)))
  equal(printed, wanted, what .. ", plain Lua: " .. complaint)
  equal(run(("cd %s && env -i %s lua5.4 %s >plain"):format(home, lua_environment,
    quote(example .. "01_first_cantilever.lua"))), 0, what .. ", an example under plain Lua")
  checks.prints(support.read(home .. "/plain") or "", "tip goes down by 3.112854 mm\n",
    what .. ", an example under plain Lua")
  if pictures then
    status, printed, complaint = run(clean .. "hinge run ../frame.lua --out frame")
    equal(status, 0, what .. ", a frame: " .. printed .. complaint)
    expect(support.is_there(home .. "/frame/frames/frame_00001.vtp"), "%s: no frame", what)
    local _, about = run(clean .. "hinge --version")
    expect(about:find(", " .. usr .. "/lib/hinge/libhinge_output.so", 1, true), "%s: its pictures: %s", what, about)
  end
  run(("rm -rf %s && mkdir %s"):format(home, home))
end
case("the program runs in an empty environment", function()
  works(place .. "/usr", "PATH=" .. quote(place .. "/usr/bin") .. ":/usr/bin:/bin",
    "PATH=/usr/bin:/bin LUA_CPATH=" .. quote(module:gsub("hinge%.so$", "?.so")), "unpacked")
end)

-- Installed, as root --------------------------------------------------------------------------------------------------

-- One such test at a time on a machine. The lock is held as long as the pipe is open.
local function take_turns()
  local held = folder .. "/held"
  local lock = assert(io.popen(("flock -w 120 /tmp/hinge_package_test.lock sh -c 'touch %s; cat'"):format(held), "w"))
  for _ = 1, 600 do
    if support.is_there(held) then break end
    os.execute "sleep 0.2"
  end
  return lock
end

local function installed() return run "dpkg-query -W -f='${db:Status-Status}' hinge | grep -qx installed" == 0 end

local function dpkg(arguments)
  for _ = 1, 60 do
    status, printed, complaint = run("dpkg " .. arguments)
    if status == 0 or not complaint:find "lock" then break end
    os.execute "sleep 1" -- another program installs something
  end
  return status
end

local root = support.output "id -u" == "0\n"
local lock = root and take_turns()
if not root then
  print "package: not installed with dpkg -i, which takes root"
elseif installed() then
  print "package: not installed with dpkg -i, since a package hinge is installed here"
else
  case("the installed package works and is removed whole", function()
    local put, why = dpkg("-i " .. package_file), complaint
    equal(put, 0, "dpkg -i: " .. why)
    local passed, problem = pcall(works, "/usr", "PATH=/usr/bin:/bin", "PATH=/usr/bin:/bin", "installed")
    local files = support.output "dpkg -L hinge"
    equal(dpkg "-r hinge", 0, "dpkg -r: " .. complaint)
    local left = not installed()
    equal(dpkg "-P hinge", 0, "dpkg -P: " .. complaint) -- the package has no settings; it is forgotten as well
    expect(passed, "%s", problem)
    expect(files:find("/usr/bin/hinge\n", 1, true), "dpkg -L: %s", files)
    expect(left, "dpkg -r left it installed")
    for file in files:gmatch "[^\n]*hinge[^\n]*" do
      expect(not support.is_there(file), "dpkg -r left %s", file)
    end
  end)
end
if lock then lock:close() end

checks.done()
