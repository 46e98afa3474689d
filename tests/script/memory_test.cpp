// No memory for Lua: at each allocation of a small script, from the loading of the library on, Lua is refused. Each
// time the script must end in LUA_ERRMEM, the state must work again once there is memory, and nothing may be left when
// it is closed.
//
// Run     build/tests/memory_test
#include <cstdio>
#include <cstdlib>
#include <new>
#include <string>

#include "script/lua/module.h"
#include "script/lua/objects.h"

namespace {

long objects = 0;  // alive of what C++ has made with new

void* make(std::size_t size, std::size_t alignment) {
    void* p = alignment ? std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment)
                        : std::malloc(size ? size : 1);
    if (!p) throw std::bad_alloc();
    ++objects;
    return p;
}
void drop(void* p) {
    if (p) --objects;
    std::free(p);
}

}  // namespace

void* operator new(std::size_t n) { return make(n, 0); }
void* operator new(std::size_t n, const std::nothrow_t&) noexcept {
    try {
        return make(n, 0);
    } catch (const std::bad_alloc&) { return nullptr; }
}
void* operator new(std::size_t n, std::align_val_t a) { return make(n, std::size_t(a)); }
void operator delete(void* p) noexcept { drop(p); }
void operator delete(void* p, std::size_t) noexcept { drop(p); }
void operator delete(void* p, std::align_val_t) noexcept { drop(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { drop(p); }

namespace {

constexpr long never = 1L << 60;

/// Lua's allocator with a host's quota: the requests from `refused` to `until` fail; to shrink and to free always
/// works.
struct Quota {
    long requests = 0, refused = never, until = never;
    long bytes = 0;
};

void* allocate(void* data, void* block, std::size_t old_size, std::size_t size) {
    Quota& q = *static_cast<Quota*>(data);
    if (!block) old_size = 0;
    if (size > old_size && ++q.requests >= q.refused && q.requests <= q.until) return nullptr;
    if (size == 0) return std::free(block), q.bytes -= long(old_size), nullptr;
    void* p = std::realloc(block, size);
    if (p) q.bytes += long(size) - long(old_size);
    return p;
}

const char load[] = "return require 'hinge'";
const char script[] = R"(
local hinge = ...
local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 245e6 }
local bar = hinge.section.solid { width = 0.05, depth = 0.05 }
local model = hinge.model { elements_per_member = 2 }
local foot, tip = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
model:fix(foot, "all")
local member = model:member { foot, tip, section = bar, material = steel, group = { "beam", "all" }, up = { 0, 0, 1 } }
model:gravity { 0, 0, -9.81 }
local static = model:static { steps = 2 }
static:finish()
model:load { node = tip, force = { 0, 0, -1e5 }, history = { { 0, 0 }, { 1e-4, 1 } } }
model:load { node = tip, force = { 0, 1, 0 }, history = function(t) return #("x" .. t) end }
local asked = 0
model:fracture(function() return false end)
model:fracture { rule = function(s) asked = asked + #(s.group .. s.member) return false end, group = "beam" }
model:contact {}
local run = model:dynamic { dt = 1e-4, duration = 5e-4, from = static, step_control = 0 }
local probe = run:probe { node = tip, "uz" }
for step in run:steps() do assert(step.time > 0) end
local text = tostring(run) .. tostring(model) .. tostring(tip)
    .. tostring(member) .. tostring(model:group "beam") .. run.hash
assert(#probe.value == 6 and #run:read "f_y" == 1
    and run:count { state = "elastic" } + run:count { state = "yielded" } == 1)
local sum = run.energy.kinetic + run:displacement(tip) + run:forces(member).N
    + run:momentum().mass + #run.stages + #run.activations
assert(asked > 0 and member.a == foot and run:snapshot() and sum == sum)
local other, seen = hinge.model(), 0
local a, b = other:node { 0, 0, 0 }, other:node { 1, 0, 0 }
other:fix(a)
other:member { a, b, section = bar, material = steel }
other:load { node = b, force = { 0, 0, -1e5 } }
other:fracture { batch = function(all) seen = seen + #all.Mx1 + all.count end }
other:dynamic { dt = 1e-4, duration = 5e-4 }:finish()
assert(seen > 0 and #other:members() == 1 and #model:loads() == 2 and #model:nodes() == 2)
for _, wrong in ipairs {
    function() model:node { 1 } end, function() return run.nothing end,
    function() model:fracture { curvature = 1 } end } do
  local ok, message = pcall(wrong)
  if message == "not enough memory" then error(message, 0) end
  assert(not ok and message:find ":", message)
end
)";

/// One state, in which the refused-th request of `phase` (0: loading, 1: the script) fails, and with it all that come
/// after or only the one that Lua makes when it has collected. True if it took fewer.
bool refused_at(int phase, long refused, bool for_good, bool& fine) {
    const long objects_before = objects;
    Quota quota;
    bool whole = false;
    const auto complain = [&](const char* what, const char* detail) {
        if (refused < never)
            std::printf("%s, request %ld refused: %s (%s)\n", phase ? "script" : "loading", refused, what,
                        detail ? detail : "no text");
        fine = false;
    };
    {
        lua_State* L = lua_newstate(allocate, &quota);
        luaL_openlibs(L);
        lua_pushcfunction(L, luaopen_hinge);
        lua_setglobal(L, "open");
        luaL_dostring(L, "package.preload.hinge = open");
        luaL_loadstring(L, load), lua_setglobal(L, "load_hinge");
        luaL_loadbuffer(L, script, sizeof script - 1, "=script"), lua_setglobal(L, "script");
        const auto call = [&](int which) {
            lua_settop(L, 0);
            lua_getglobal(L, which ? "script" : "load_hinge");
            if (which) lua_getglobal(L, "hinge");
            const int status = lua_pcall(L, which, 1, 0);
            if (status == LUA_OK && !which) lua_setglobal(L, "hinge");
            return status;
        };
        if (phase && call(0) != LUA_OK) complain("the library does not load", lua_tostring(L, -1));
        quota.requests = 0, quota.refused = refused, quota.until = for_good ? never : refused + 1;
        const int status = call(phase);
        quota.refused = never;
        whole = quota.requests < refused;
        const std::string said = status != LUA_OK && lua_tostring(L, -1) ? lua_tostring(L, -1) : "";
        // require makes a message of its own of a file for which there was no memory
        if (!whole && status != LUA_ERRMEM && (for_good || status != LUA_OK) &&
            !said.ends_with("\n\tnot enough memory"))
            complain("no lack of memory", said.c_str());
        if (!whole && call(0) != LUA_OK) complain("no loading afterwards", lua_tostring(L, -1));
        if (!whole && call(1) != LUA_OK) complain("no going on afterwards", lua_tostring(L, -1));
        lua_close(L);
    }
    if (quota.bytes != 0) complain("Lua keeps memory", "");
    if (objects != objects_before) complain("C++ keeps objects", std::to_string(objects - objects_before).c_str());
    return whole;
}

}  // namespace

int main() {
    bool fine = true;
    refused_at(1, never, true, fine), fine = true;  // what is made once and kept is made now
    for (int phase = 0; phase < 2; ++phase)
        for (const bool for_good : {true, false}) {
            long n = 1;
            while (!refused_at(phase, n, for_good, fine)) ++n;
            std::printf("%s: refused %s at each of %ld requests\n", phase ? "script" : "loading",
                        for_good ? "for good" : "once", n - 1);
        }
    std::puts(fine ? "memory: nothing lost" : "memory: FAILED");
    return fine ? 0 : 1;
}
