-- What cmake --install puts into a prefix is whole: another CMake project (scripts/host) builds against it and runs its
-- own fracture rule, plain Lua finds the module, the program runs, and all of it after the prefix was moved.
--
-- Run: lua5.4 tests/script/tree/install_test.lua BUILD_FOLDER [CMAKE]
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "install"
local case, ended = checks.case, checks.ended
local quote, run, expect, equal = support.quote, support.run, checks.expect, checks.equal

local folder = support.temporary_folder()
local prefix, cmake = folder .. "/a prefix", quote(arg[2] or "cmake")
local clean = "env -u LUA_PATH -u LUA_CPATH "
case("cmake --install puts a whole library into a prefix", function()
  ended(0, "", run(("%s --install %s --prefix %s/first"):format(cmake, quote(arg[1]), folder)))
  assert(os.rename(folder .. "/first", prefix)) -- nothing in it may know where it was installed
end)

-- A project of somebody else's ----------------------------------------------------------------------------------------

case("a project of somebody else's builds against the installed library, on the same processor alone", function()
  local host = quote(folder .. "/host")
  ended(0, "", run(("%s -S %s -B %s -D CMAKE_PREFIX_PATH=%s && %s --build %s"):format(cmake,
    quote(support.root .. "scripts/host"), host, quote(prefix), cmake, host)))
  local cache = support.read(folder .. "/host/CMakeCache.txt") or ""
  expect(cache:find("hinge_DIR:PATH=" .. prefix, 1, true), "the host found another hinge: %s",
    cache:match "hinge_DIR[^\n]*")
  local printed = ended(0, "", run(("%s %s/host %s %s/recorded"):format(clean, host, quote(prefix), quote(folder))))
  local summary = support.read(folder .. "/recorded/summary.json") or ""
  expect(summary:find '"verdict": "stopped"' and summary:find '"fracture": 304'
    and support.read(folder .. "/recorded/history.csv"),
    "the host's record: %s", summary)
  local first, second = printed:match "^C%+%+: (1 of 1 members broken [^\n]*)\nLua: ([^\n]*)\n$"
  expect(first and first == second, "C++ and Lua break the same at the same time: %s", printed)
  ended(1, { "host: ", "module 'hinge' not found" },
    run(("env -u LUA_PATH LUA_CPATH=nowhere %s/host %s/nowhere"):format(host, folder)))

  -- Types are laid out as in the engine, or the compiler says so.
  support.write(folder .. "/other.cpp", '#include "run/dynamics.h"\n')
  local eigen = cache:match "Eigen3_DIR:PATH=([^\n]*)/share/eigen3/cmake" or "/usr"
  local compile = "c++ -std=c++20 -fsyntax-only -D HINGE_ALIGNMENT=8 -I %s/include/hinge -I %s/include/eigen3 "
    .. "%s/other.cpp"
  ended(1, "hinge was built for another processor", run(compile:format(quote(prefix), eigen, folder)))
end)

-- The module and the program ------------------------------------------------------------------------------------------

-- Each says where its library lies: in the prefix, not in the folder it was built from.
local asks = [[
local hinge = require "hinge"
local model = hinge.model()
model:member { model:node { 0, 0, 0 }, model:node { 1, 0, 0 }, section = hinge.section.solid { width = 1, depth = 1 },
  material = hinge.material { E = 1, density = 1 } }
print(model:counts().elements, package.searchpath("hinge", package.path))
]]
case("the module and the program say where their library lies", function()
  support.write(folder .. "/asks.lua", asks)
  local wanted = "2\t" .. prefix .. "/share/hinge/lua/hinge/init.lua\n"
  for what, command in pairs {
    module = ("env LUA_CPATH=%s lua5.4 asks.lua"):format(quote(prefix .. "/lib/lua/5.4/?.so")),
    ["one-liner"] = ([[env LUA_CPATH=%s lua5.4 -e 'require "hinge"' asks.lua]])
      :format(quote(prefix .. "/lib/lua/5.4/?.so")),
    program = ("%s/bin/hinge run asks.lua --out program | grep -v '^written'"):format(quote(prefix)),
    ["program by its name"] = ("PATH=%s/bin:$PATH hinge run asks.lua --out name | grep -v '^written'")
      :format(quote(prefix)),
    ["program by a link to a link"] = ("ln -s %s/bin/hinge one && ln -s one 'two hinges' && "
      .. "./two\\ hinges run asks.lua --out link | grep -v '^written'"):format(quote(prefix)),
    ["program from elsewhere"] = ("here=$PWD && cd %s/share && ../bin/hinge run $here/asks.lua --out $here/elsewhere "
      .. "| grep -v '^written'"):format(quote(prefix)),
  } do
    equal(ended(0, "", run(("cd %s && %s"):format(folder, command))), wanted, "library of the installed " .. what)
  end
end)

-- What the program reads of the library: the reference, and the project that hinge new writes.
local installed = quote(prefix .. "/bin/hinge")
case("the program reads the library of its own prefix", function()
  ended(0, "Adds a joint",
    run(("cd %s && %s reference model:node && %s new made"):format(folder, installed, installed)))
  expect(support.is_there(folder .. "/made/main.lua"), "no project was made")
  local told = support.read(folder .. "/made/.luarc.json") or ""
  expect(told:find(prefix .. "/share/hinge/lua/hinge/hinge.d.lua", 1, true), "editors are told of another place: %s",
    told)
end)

case("pictures are drawn after the install where they were built", function()
  if support.is_there(arg[1] .. "/libhinge_output.so") then
    support.write(folder .. "/frame.lua", support.frame_script())
    equal(run(("cd %s && %s/bin/hinge run frame.lua --out frame"):format(folder, quote(prefix))), 0,
      "a script with a frame")
    expect(support.is_there(folder .. "/frame/frames/frame_00001.vtp"),
      "no frame: the installed program does not find its pictures")
    -- the module, in the folder of Fedora's Lua, too
    run(("mkdir -p %s/lib64/lua/5.4 && cp %s/lib/lua/5.4/hinge.so %s/lib64/lua/5.4")
      :format(quote(prefix), quote(prefix), quote(prefix)))
    support.write(folder .. "/picture.lua", support.frame_script "plain")
    for _, place in ipairs { "lib", "lib64" } do
      local said = select(3, run(("mkdir -p %s/in_%s && cd %s/in_%s && LUA_CPATH=%s lua5.4 ../picture.lua")
        :format(folder, place, folder, place, quote(prefix .. "/" .. place .. "/lua/5.4/?.so"))))
      expect(run(("find %s/in_%s | grep -q 'vtp$'"):format(folder, place)) == 0,
        "no frame: the module in %s does not find its pictures: %s", place, said)
    end
    local _, about = run(("PATH=%s/bin:$PATH hinge --version"):format(quote(prefix)))
    expect(about:find(", " .. prefix .. "/lib/hinge/libhinge_output.so", 1, true), "pictures of another hinge: %s",
      about)
  end
end)

case("completion of the shells is installed as the program writes it", function()
  for shell, to in pairs { bash = "bash-completion/completions/hinge", fish =
    "fish/vendor_completions.d/hinge.fish" } do
    local _, written = run(("%s/bin/hinge completion %s"):format(quote(prefix), shell))
    expect(#written > 500 and support.read(prefix .. "/share/" .. to) == written, "the installed completion of %s",
      shell)
  end
  for from, to in pairs {
    ["lua/guide/install.md"] = "doc/hinge/guide/install.md",
    ["src/CHANGES.md"] = "doc/hinge/CHANGES.md",
    ["src/hinge.1"] = "man/man1/hinge.1",
    ["scripts/01_first_cantilever.lua"] = "doc/hinge/examples/01_first_cantilever.lua",
  } do
    checks.same_files(prefix .. "/share/" .. to, support.root .. from, "the installed " .. to)
  end
end)

case("a library laid out by LuaRocks takes the engine alone from the build", function()
  run(("mkdir -p %s/rock/lib/lua/5.4 %s/rock/share/lua && cp %s/lib/lua/5.4/hinge.so %s/rock/lib/lua/5.4 && "
    .. "cp -r %s/share/hinge/lua %s/rock/share/lua/5.4")
    :format(folder, folder, quote(prefix), folder, quote(prefix), folder))
  local printed = ended(0, "", run(("cd %s && "
    .. "env LUA_PATH=%s/rock/share/lua/5.4/?.lua';'%s/rock/share/lua/5.4/?/init.lua "
    .. "LUA_CPATH=%s/rock/lib/lua/5.4/?.so lua5.4 asks.lua"):format(folder, folder, folder, folder)))
  equal(printed, "2\t" .. folder .. "/rock/share/lua/5.4/hinge/init.lua\n", "library of the rock")
  local spec = setmetatable({}, { __index = _G })
  assert(loadfile(support.root .. "lua/hinge-scm-1.rockspec", "t", spec))()
  expect(spec.package == "hinge" and spec.build.type == "cmake", "the rockspec is of %s", spec.package)
end)

checks.done()
