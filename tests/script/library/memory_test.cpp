// No memory for Lua: at each allocation of a small script, from the loading of the library on, Lua is refused. Each
// time the script must end in LUA_ERRMEM, the state must work again once there is memory, and nothing may be left when
// it is closed. Each allocation of the script is refused in a state of its own, in turn for good and once. Those of the
// loading are refused one after another in one state: modules that are loaded stay so, and loading goes on from there.
// In the end that state must load the library and run the script.
//
// Run     build/tests/memory_test
#include <cstdio>
#include <cstdlib>
#include <new>
#include <set>
#include <string>

#include "script/bind/lua_module.h"
#include "script/lua/lua_support.h"

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
    + run:momentum().mass + #run.stages + #run.state_changes
assert(asked > 0 and member.a == foot and run:snapshot() and sum == sum)
local other, seen = hinge.model(), 0
local a, b = other:node { 0, 0, 0 }, other:node { 1, 0, 0 }
other:fix(a)
other:member { a, b, section = bar, material = steel }
other:load { node = b, force = { 0, 0, -1e5 } }
other:fracture { where = "all", rule = function(s) seen = seen + s.element end }
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

/// A state of Lua with a quota, in which the library is loaded (part 0) and the script is run (part 1).
class Scene {
public:
    Scene(const char* name, bool& fine) : name_(name), fine_(fine), objects_before_(objects) {
        L_ = lua_newstate(allocate, &quota_);
        luaL_openlibs(L_);
        lua_pushcfunction(L_, luaopen_hinge);
        lua_setglobal(L_, "open");
        luaL_dostring(L_, "package.preload.hinge = open");
        luaL_loadstring(L_, load), lua_setglobal(L_, "load_hinge");
        luaL_loadbuffer(L_, script, sizeof script - 1, "=script"), lua_setglobal(L_, "script");
    }
    ~Scene() {
        lua_close(L_);
        if (quota_.bytes != 0) complain("Lua keeps memory", "");
        if (objects != objects_before_)
            complain("C++ keeps objects", std::to_string(objects - objects_before_).c_str());
    }

    int call(int part) {
        lua_settop(L_, 0);
        lua_getglobal(L_, part ? "script" : "load_hinge");
        if (part) lua_getglobal(L_, "hinge");
        const int status = lua_pcall(L_, part, 1, 0);
        if (status == LUA_OK && !part) lua_setglobal(L_, "hinge");
        return status;
    }
    /// Calls a part, which must be in order.
    void must(int part, const char* what) {
        if (call(part) != LUA_OK) complain(what, lua_tostring(L_, -1));
    }
    /// Calls a part in which the refused-th request fails, and with it all that come after or only the one that Lua
    /// makes when it has collected. False if it took fewer.
    bool refuse(int part, long refused, bool for_good, int* status = nullptr) {
        quota_.requests = 0, quota_.refused = at_ = refused, quota_.until = for_good ? never : refused + 1;
        const int ended = call(part);
        quota_.refused = never;
        if (status) *status = ended;
        if (quota_.requests < refused) return false;
        const std::string said = ended != LUA_OK && lua_tostring(L_, -1) ? lua_tostring(L_, -1) : "";
        // require makes a message of its own of a file for which there was no memory
        if (ended != LUA_ERRMEM && (for_good || ended != LUA_OK) && !said.ends_with("\n\tnot enough memory"))
            complain("no lack of memory", said.c_str());
        return true;
    }
    /// The names of the modules that are loaded.
    std::set<std::string> modules() {
        std::set<std::string> names;
        lua_settop(L_, 0);
        luaL_getsubtable(L_, LUA_REGISTRYINDEX, LUA_LOADED_TABLE);
        for (lua_pushnil(L_); lua_next(L_, 1); lua_pop(L_, 1)) names.insert(lua_tostring(L_, -2));
        return names;
    }
    void unload(const std::string& name) {
        lua_settop(L_, 0);
        luaL_getsubtable(L_, LUA_REGISTRYINDEX, LUA_LOADED_TABLE);
        lua_pushnil(L_);
        lua_setfield(L_, 1, name.c_str());
    }

private:
    void complain(const char* what, const char* detail) {
        if (!name_) return;
        std::printf("%s, request %ld refused: %s (%s)\n", name_, at_, what, detail ? detail : "no text");
        fine_ = false;
    }

    const char* name_;  ///< null: nothing is compared
    bool& fine_;
    long objects_before_, at_ = 0;
    Quota quota_;
    lua_State* L_;
};

/// Refuses each request of the loading. Returns how many.
long refuse_loading(bool for_good, bool& fine) {
    Scene scene("loading", fine);
    std::set<std::string> before = scene.modules();
    long count = 0;
    int status = LUA_OK;
    for (long n = 1; scene.refuse(0, n, for_good, &status); ++n, ++count) {
        std::set<std::string> now = scene.modules();
        if (status != LUA_OK && now.size() > before.size()) before = std::move(now), n = 0;  // from there on
        else
            for (const std::string& name : now)
                if (!before.contains(name)) scene.unload(name);  // it found memory: back to where it began
    }
    scene.must(0, "no loading afterwards");
    scene.must(1, "no going on afterwards");
    return count;
}

/// Refuses every second request of the script: the odd ones for good, the even ones once. Returns how many there are.
long refuse_script(bool for_good, bool& fine) {
    for (long n = for_good ? 1 : 2;; n += 2) {
        Scene scene("script", fine);
        scene.must(0, "the library does not load");
        if (!scene.refuse(1, n, for_good)) return n - 2;
        scene.must(0, "no loading afterwards");
        scene.must(1, "no going on afterwards");
    }
}

}  // namespace

int main() {
    bool fine = true;
    {  // what is made once and kept is made now
        Scene scene(nullptr, fine);
        scene.call(0), scene.call(1);
    }
    for (const bool for_good : {true, false}) {
        const char* how = for_good ? "for good" : "once";
        std::printf("loading: refused %s at each of %ld requests\n", how, refuse_loading(for_good, fine));
        std::printf("script: refused %s at every second of %ld requests\n", how, refuse_script(for_good, fine));
    }
    std::puts(fine ? "memory: nothing lost" : "memory: FAILED");
    return fine ? 0 : 1;
}
