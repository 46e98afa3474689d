// A run that is recorded from C++, without Lua: its folder, its checkpoint, and a run that goes on from another.
#include <unistd.h>

#include <filesystem>

#include "core/files.h"
#include "helpers.h"
#include "record/recording.h"
#include "run/go_on.h"

using namespace hinge;
using namespace hinge::test;

namespace {

namespace fs = std::filesystem;

/// Each scene has a folder of its own: one that a process has locked may not be made anew.
fs::path new_folder() {
    static int count = 0;
    return fs::temp_directory_path() /
           ("hinge_recording_" + std::to_string(::getpid()) + "_" + std::to_string(++count));
}

/// A cantilever that a load at its tip bends until it breaks.
struct Cantilever {
    int tip = 0;
    std::shared_ptr<const Structure> structure;

    fs::path folder = new_folder();
    std::shared_ptr<Context> context = std::make_shared<Context>();

    Cantilever() {
        Frame frame;
        tip = frame.node(1, 0, 0);
        frame.member(frame.foot(0, 0, 0), tip);
        frame.load(tip, {0, 0, -1e5});
        add_fracture(*frame.model, bent_by(0.12));
        structure = frame.build();

        context->output.folder = folder.string();
    }
    ~Cantilever() { fs::remove_all(folder); }
    Cantilever(const Cantilever&) = delete;
    Cantilever& operator=(const Cantilever&) = delete;

    std::shared_ptr<RunRecord> start(double duration = 2e-3) {
        auto record = std::make_shared<RunRecord>();
        record->run = std::make_shared<Dynamics>(structure, initial_state(*structure),
                                                 DynamicSettings{.dt = 1e-5, .duration = duration});
        record->every = 10;
        record->probes.push_back(std::make_shared<Probe>(Probe{tip, Probe::Quantity::displacement, 2, "tip", {}, {}}));
        record_run(*context, record);
        return record;
    }
    std::string file(const char* name) const { return read_whole((folder / name).string()); }
    bool has(const char* name) const { return fs::exists(folder / name); }
};

}  // namespace

TEST_CASE("recording: a run without Lua leaves history, events and summary") {
    Cantilever scene;
    const auto record = scene.start();
    while (record_step(scene.context, record)) {}
    write_summary(*scene.context);
    const std::string history = scene.file("history.csv");
    CHECK(history.starts_with("time,factor,"));
    CHECK(history.substr(0, history.find('\n')).ends_with(",tip"));
    CHECK(std::count(history.begin(), history.end(), '\n') == 22);  // the heading, the start, and every tenth step
    CHECK(record->probes[0]->value.size() == 200);
    CHECK(record->probes[0]->value.back() == record->run->displacement(scene.tip)[2]);
    CHECK(scene.has("probes.json"));
    const std::string summary = scene.file("summary.json");
    CHECK(summary.find("\"verdict\": \"completed\"") != std::string::npos);
    CHECK(summary.find("\"state_hash\"") != std::string::npos);
    const long broken = record->run->count_members(-1).broken;
    CHECK(scene.has("events.csv") == !record->happenings.empty());
    CHECK((broken == 0 || scene.file("events.csv").find(",fracture,") != std::string::npos));
}

TEST_CASE("recording: goes on from its checkpoint with the same bits") {
    Cantilever scene;
    const auto whole = scene.start();
    while (record_step(scene.context, whole)) {}
    const auto first = scene.start();
    CheckpointPlan plan;
    plan.file = (scene.folder / "run.checkpoint").string(), plan.every = 0;
    first->checkpoint = plan;
    for (int i = 0; i < 77; ++i) REQUIRE(record_step(scene.context, first));
    scene.context->mode.resume = true;
    const auto second = scene.start();
    second->checkpoint = plan;
    while (record_step(scene.context, second)) {}
    CHECK(second->resumed_at == 76);
    CHECK(hash(second->run->state()) == hash(whole->run->state()));
    CHECK(second->probes[0]->value == whole->probes[0]->value);
}

TEST_CASE("recording: what a program does between steps") {
    struct Hooks : StepHooks {
        void before_step(RunRecord&) override { ++before; }
        void after_step(RunRecord& r) override {
            if (++after == 5) r.run->stop();
        }
        int before = 0, after = 0;
    } hooks;
    Cantilever scene;
    const auto record = scene.start();
    while (record_step(scene.context, record, hooks)) {}
    CHECK(hooks.after == 5);
    CHECK(hooks.before >= 5);
    CHECK(record->run->verdict() == Verdict::stopped);
    write_summary(*scene.context);
    CHECK(scene.file("summary.json").find("\"verdict\": \"stopped\"") != std::string::npos);
}

TEST_CASE("recording: a run goes on from the state of another") {
    Cantilever scene;
    const auto record = scene.start(1e-3);
    while (record_step(scene.context, record)) {}
    const Run& before = *record->run;
    REQUIRE(!refusal_to_go_on(before, *scene.structure));
    const State state = state_to_go_on(before, *scene.structure);
    CHECK(state.step == 0);
    CHECK(state.time == before.state().time);
    CHECK(state.displacement[std::size_t(scene.tip)] == before.state().displacement[std::size_t(scene.tip)]);
    Frame other;
    const int a = other.node(0, 0, 0), b = other.node(1, 0, 0), c = other.node(2, 0, 0);
    other.member(a, b), other.member(b, c);
    const Structure longer(other.model);
    const auto refusal = refusal_to_go_on(before, longer);
    REQUIRE(refusal);
    CHECK(refusal->advice.find("add nothing between the runs") != std::string::npos);
}
