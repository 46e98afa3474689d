// Bytes from anywhere, read as a checkpoint. What is taken, a run goes on from, and its numbers stay finite or it says
// that it failed; what is refused leaves the run as it was.
//
// libFuzzer changes what real runs have saved. An input's first byte says who reads the rest: one of the runs below,
// the reader of the file (as it is, and with its checksum mended), or that of the table a script keeps. The real ones
// are written to the folder that HINGE_SEEDS names.
//
// Run     tests/sanitize.sh fuzz [seconds]
#define CATCH_CONFIG_RUNNER  // helpers.h refers to it; no test runs here
#include "helpers.h"

#include <zlib.h>

#include <cstring>
#include <fstream>
#include <lua.hpp>

#include "core/archive.h"
#include "core/errors.h"
#include "script/lua/kept_values.h"
#include "run/checkpoint.h"

using namespace hinge;
using namespace hinge::test;

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace {

void must(bool good, const char* what) {
    if (good) return;
    std::fprintf(stderr, "checkpoint_fuzzer: %s\n", what);
    std::abort();
}

std::string saved(const Dynamics& run) {
    std::string bytes;
    run.save(bytes);
    return bytes;
}

// ---- runs that have something to save of every kind
// --------------------------------------------------------------------

struct Scene {
    std::shared_ptr<const Structure> structure;
    DynamicSettings settings;
    std::string fresh = {};
    Dynamics start() const { return Dynamics(structure, initial_state(*structure), settings); }
};

Scene scene(const Frame& frame, double dt, int steps, DynamicSettings settings = {}) {
    settings.dt = dt;
    settings.duration = steps * dt;
    Scene s{
        std::make_shared<const Structure>(frame.model, settings.beta == 0 ? MassKind::lumped : MassKind::consistent),
        settings};
    s.fresh = saved(s.start());
    return s;
}

/// A bar flies into another one that yields.
Frame crash(contact::ContactRuleKind kind, bool clamped = true, double yield_stress = 245e6) {
    Frame frame;
    ContactRule rule;
    rule.settings.rule = kind;
    rule.settings.friction = 0.2;
    if (kind == contact::ContactRuleKind::gap)
        rule.pairs = [own = rule.settings](int, int) { return std::optional(own); };
    add_contact(*frame.model, rule);
    frame.material = steel(yield_stress);
    const int a1 = frame.node(-0.5, 0, 0), a2 = frame.node(0.5, 0, 0), b1 = frame.node(0.1, -0.5, 0.08),
              b2 = frame.node(0.1, 0.5, 0.08);
    if (clamped)
        for (int a : {a1, a2}) frame.model->fix(a, 63);
    frame.member(a1, a2);
    frame.member(b1, b2);
    for (int b : {b1, b2}) frame.model->set_velocity(b, {0, 0, -60}, Vec3::Zero());
    return frame;
}

Frame breaking_crash() {
    Frame frame = crash(contact::ContactRuleKind::surface);
    FractureRule limits;
    limits.curvature_x = limits.curvature_y = 0.3;
    add_fracture(*frame.model, limits);
    set_gravity(*frame.model, {0, 0, -9.80665});
    return frame;
}

/// Breaks by a rule of the script's that keeps a number of each section.
Frame fracturing_crash() {
    Frame frame = crash(contact::ContactRuleKind::gap);
    FractureRule rule;
    rule.keep = {"times"};
    rule.hook =
        FractureHook([](const SectionView& s) { return ++*s.kept > 30 && std::abs(s.strain.curvature_x) > 0.2; });
    add_fracture(*frame.model, rule);
    return frame;
}

/// A portal whose foot is moved, under a load that changes and one that is a function of the state.
Frame shaken(ModelOptions options, double speed) {
    Frame frame(options);
    frame.material = steel(245e6);
    const int foot = frame.foot(0, 0, 0), other = frame.foot(1, 0, 0), left = frame.node(0, 0, 1),
              right = frame.node(1, 0, 1);
    frame.member(foot, left);
    frame.member(left, right);
    frame.member(right, other);
    add_motion(*frame.model, {foot, 0, [speed](double t) { return speed * (1 - std::cos(200 * t)) / 200; }});
    frame.load(left, {1e3, 0, 0}, Vec3::Zero(), [](double t) { return std::min(1.0, 100 * t); });
    NodalLoad rule{.node = right};
    rule.force_rule = [](double t) { return Vec3(0, 0, -1e5 * t); };
    add_load(*frame.model, rule);
    return frame;
}

std::vector<Scene> scenes() {
    DynamicSettings explicit_steps, paper, automatic, direct;
    explicit_steps.beta = 0;
    paper.beta = 0.4;
    automatic.automatic = true;
    automatic.step_control = 1e-4;
    direct.solver.direct = true;
    direct.rho_infinity = 0.5;
    direct.beta = DynamicSettings::beta_of(0.5);
    ModelOptions cubic;
    cubic.mass = MassShape::cubic;
    return {scene(breaking_crash(), 2e-5, 1000),
            scene(breaking_crash(), 1e-5, 2000, explicit_steps),
            scene(crash(contact::ContactRuleKind::gap, true, infinite), 2e-5, 300, paper),
            scene(fracturing_crash(), 2e-5, 400),
            scene(crash(contact::ContactRuleKind::surface, false), 2e-5, 300, automatic),
            scene(shaken(cubic, 2), 2e-5, 800),
            scene(shaken(small_displacement(), 2), 2e-4, 100, direct)};
}
const std::vector<Scene>& all_scenes() {
    static const std::vector<Scene> all = scenes();
    return all;
}

// ---- who reads
// ---------------------------------------------------------------------------------------------------------

constexpr int until_a_look = 110;  ///< steps; by then the energy balance was checked (run/energy_monitor.cpp)

void go_on(const Scene& scene, std::string_view bytes) {
    Dynamics run = scene.start();
    try {
        run.restore(bytes);
    } catch (const Damaged&) { return must(saved(run) == scene.fresh, "what was refused has changed the run"); }
    scene.start().restore(saved(run));  // what was taken is taken again
    for (int step = 0; (step < 3 || (!is_finite(run.state()) && step < until_a_look)) && run.advance(); ++step) {}
    must(run.verdict() == Verdict::failed || is_finite(run.state()),
         "the run goes on with numbers that are not finite");
}

/// A file's bytes with checksum and length as they should be.
std::string mended(std::string_view bytes) {
    static const std::string good = checkpoint_of(all_scenes()[0].start());
    const std::size_t rest_at = 40;
    if (bytes.size() < rest_at) return good;
    std::string file = good.substr(0, rest_at) + std::string(bytes.substr(rest_at));
    const std::uint64_t length = file.size() - rest_at;
    std::memcpy(&file[32], &length, 8);
    const auto sum = std::uint32_t(crc32_z(0, reinterpret_cast<const Bytef*>(&file[12]), file.size() - 12));
    std::memcpy(&file[8], &sum, 4);
    return file;
}

void read_file(const std::string& bytes) {
    Dynamics run = all_scenes()[0].start();
    try {
        resume(run, open_checkpoint(bytes, "file"), "file");
    } catch (const OutsideError&) {
    } catch (const InputError&) {}
    must(run.advance() || run.verdict() != Verdict::running, "no step");
}

void read_kept(const std::string& bytes) {
    static lua_State* const L = luaL_newstate();
    lua_newtable(L);
    try {
        script::unpack_table(L, 1, bytes);
        script::pack_table(L, 1, "kept");
    } catch (const Damaged&) {
    } catch (const InputError&) {  // a key that is no number
    }
    lua_settop(L, 0);
}

// ---- where it begins
// ---------------------------------------------------------------------------------------------------

void write_seeds(const std::string& folder) {
    int count = 0;
    const auto write = [&](std::size_t reader, const std::string& bytes) {
        std::ofstream(folder + "/seed" + std::to_string(count++), std::ios::binary) << char(reader) << bytes;
    };
    for (std::size_t i = 0; i < all_scenes().size(); ++i) {
        Dynamics run = all_scenes()[i].start();
        const long apart = std::max(1L, run.planned_steps() / 10);
        write(i, saved(run));
        while (run.advance())
            if (run.steps_done() % apart == 0) write(i, saved(run));
        must(run.verdict() == Verdict::completed, (std::to_string(i) + ": " + run.reason()).c_str());
        write(i, saved(run));
        const Run::Counts counts = run.count_members(-1);
        std::printf("scene %zu: %ld steps, %ld members yielded, %ld broken, %ld touched; %zu bytes\n", i,
                    run.steps_done(), counts.yielded, counts.broken, counts.touched, saved(run).size());
    }
    write(all_scenes().size(), checkpoint_of(all_scenes()[0].start(), "beside"));
    lua_State* L = luaL_newstate();
    must(luaL_dostring(L, "return { 1, -2.5, 'text', true, { deep = { deeper = {} }, [1e9] = false } }") == LUA_OK,
         "the table");
    write(all_scenes().size() + 1, script::pack_table(L, -1, "kept"));
    lua_close(L);
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
    if (const char* folder = std::getenv("HINGE_SEEDS")) write_seeds(folder);
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const std::size_t reader = data[0], count = all_scenes().size();
    const std::string bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
    if (reader < count) go_on(all_scenes()[reader], bytes);
    if (reader == count) read_file(bytes), read_file(mended(bytes));
    if (reader == count + 1) read_kept(bytes);
    return 0;
}

namespace {

/// An entry out of a list, or one of zeros into it, where it was guessed right that eight bytes are a list's length and
/// how long its entries are: plain numbers and vectors, and the types of sim/ and contact/ as they are written.
std::size_t change_a_list(std::uint8_t* data, std::size_t size, std::size_t max_size, std::minstd_rand& dice) {
    static const std::size_t entries[] = {1, 4, 8, 17, 24, 48, 52, 56, 80, 104, 124, 292, 489, 493, 1160};
    for (int guess = 0; guess < 100; ++guess) {
        std::uint8_t *const at = data + 1 + dice() % (size - 8), *const first = at + 8;
        const std::size_t entry = entries[dice() % std::size(entries)], behind = std::size_t(data + size - first);
        const bool out = dice() % 2;
        std::uint64_t length;
        std::memcpy(&length, at, 8);
        if (length > 100 || (out ? length == 0 || behind < entry : size + entry > max_size)) continue;
        length += out ? -1 : 1;
        std::memcpy(at, &length, 8);
        std::memmove(out ? first : first + entry, out ? first + entry : first, out ? behind - entry : behind);
        if (!out) std::memset(first, 0, entry);
        return out ? size - entry : size + entry;
    }
    return size;
}

}  // namespace

/// Most changes leave all lengths as they are: behind a wrong one nothing is read.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed) {
    std::minstd_rand dice(seed);
    const unsigned way = dice() % 8;
    if (size < 20 || way == 0) return LLVMFuzzerMutate(data, size, max_size);
    if (way < 4) return change_a_list(data, size, max_size, dice);
    static const double numbers[] = {
        0, -1, 1e-300, 1e-8, 1e8, 1e300, std::numeric_limits<double>::max(), infinite, -infinite, std::nan("")};
    static const std::int64_t wholes[] = {0,
                                          1,
                                          -1,
                                          2,
                                          7,
                                          255,
                                          1L << 31,
                                          1L << 32,
                                          1L << 62,
                                          std::numeric_limits<std::int64_t>::max(),
                                          std::numeric_limits<std::int64_t>::min()};
    for (unsigned changes = 1 + dice() % 3; changes > 0; --changes) {
        std::uint8_t* const at = data + 1 + dice() % (size - 8);
        const std::size_t length = 1u << dice() % 4;
        if (length == 8 && dice() % 2) std::memcpy(at, &numbers[dice() % std::size(numbers)], 8);
        else if (dice() % 2) std::memcpy(at, &wholes[dice() % std::size(wholes)], length);
        else LLVMFuzzerMutate(at, length, length);
    }
    return size;
}
