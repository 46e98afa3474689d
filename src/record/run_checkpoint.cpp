#include "record/run_checkpoint.h"

#include <algorithm>
#include <filesystem>

#include "core/archive.h"
#include "core/files.h"
#include "record/folders.h"
#include "run/checkpoint.h"
#include "run/dynamics.h"

namespace hinge {
namespace {

using Clock = std::chrono::steady_clock;

/// What lies beside the run in its checkpoint.
struct Beside {
    Recorded recorded;
    std::string history;
    std::vector<Probe> probes;
    std::vector<std::pair<double, std::string>> frames;
    std::string kept;  ///< the script's own values, "" where it keeps none
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.recorded, s.history, s.probes, s.frames, s.kept);
    }
};

std::string names_of(const auto& probes, auto name) {
    std::string text;
    for (const auto& p : probes) text += (text.empty() ? "" : ", ") + name(p);
    return text.empty() ? "none" : text;
}

/// Whether somebody may still want to go on from it.
bool is_unfinished(const std::string& file) {
    try {
        const std::string bytes = read_whole(file);
        return !hinge::open_checkpoint(bytes, file).over;
    } catch (const OutsideError&) { return true; }
}

}  // namespace

std::string place_text(const Run& run) {
    char text[64];
    std::snprintf(text, sizeof text, "step %ld, t = %.6g s", run.steps_done(), run.state().time);
    return text;
}

/// A name without a folder is in the output folder. A script that is not trusted has no other.
std::string checkpoint_path(const Context& c, const std::string& name) {
    std::string path =
        name.find('/') != std::string::npos || c.output.folder.empty() ? name : c.output.folder + "/" + name;
    prepare_folder(c, path);
    return path;
}

void write_checkpoint(const Context& c, const RunRecord& r, const std::string& path) {
    Beside beside{r,
                  (r.files.history_path.empty() ? r.files.past : read_whole(r.files.history_path)) + r.files.rows,
                  {},
                  c.output.frames,
                  ""};
    if (r.checkpoint && r.checkpoint->keep) beside.kept = r.checkpoint->keep->pack();
    for (const auto& p : r.probes) beside.probes.push_back(*p);
    std::string bytes;
    Writer{bytes}(beside);
    write_whole(path, checkpoint_of(*std::as_const(*r.run).dynamics(), std::move(bytes)));
}

void read_checkpoint(Context& c, RunRecord& r, const std::string& path) {
    const std::string bytes = read_whole(path);
    const Checkpoint checkpoint = hinge::open_checkpoint(bytes, path);
    const auto keep = r.checkpoint ? r.checkpoint->keep : nullptr;
    Beside beside;
    bool good = true;
    try {
        Reader{checkpoint.beside}(beside);
        if (keep && !beside.kept.empty()) keep->check(beside.kept);
    } catch (const Damaged&) { good = false; }
    const auto fits = [](std::size_t n, std::size_t all) { return n == 0 || n == all; };
    good = good && fits(beside.recorded.broken_at.size(), r.run->state().broken.size()) &&
           fits(beside.recorded.left_at.size(), r.run->state().gone.size()) &&
           std::all_of(beside.probes.begin(), beside.probes.end(),
                       [](const Probe& p) { return p.time.size() == p.value.size() && !p.time.empty(); });
    if (!good)
        throw OutsideError(
            "checkpoint " + path +
            " is damaged: its contents are not valid; go on from an older copy of it, or start the run anew");
    const auto same = [](const std::shared_ptr<Probe>& here, const Probe& there) {
        return here->name == there.name && here->node == there.node && here->quantity == there.quantity &&
               here->component == there.component && here->relative_to == there.relative_to &&
               here->height == there.height;
    };
    if (const auto own = fingerprint(*r.run->dynamics());
        difference(checkpoint.model, own).empty() &&
        !std::equal(r.probes.begin(), r.probes.end(), beside.probes.begin(), beside.probes.end(), same))
        throw InputError("checkpoint " + path + " is of a run with other probes (there: " +
                         names_of(beside.probes, [](const Probe& p) { return p.name; }) +
                         "; here: " + names_of(r.probes, [](const auto& p) { return p->name; }) +
                         "); ask for the same ones before the run goes on");
    hinge::resume(*r.run->dynamics(), checkpoint, path);
    if (keep && !beside.kept.empty()) keep->unpack(beside.kept);
    static_cast<Recorded&>(r) = std::move(beside.recorded);
    for (std::size_t i = 0; i < r.probes.size(); ++i) *r.probes[i] = std::move(beside.probes[i]);
    r.files.past = std::move(beside.history);
    c.output.frames = std::move(beside.frames);
    r.progress.activations_seen = r.run->activations().size();
    if (!r.closed) r.resumed_at = r.run->steps_done();
    if (c.messages.progress)
        std::fprintf(stderr, r.closed ? "%s is of a run that has ended: %s\n" : "goes on from %s: %s\n", path.c_str(),
                     place_text(*r.run).c_str());
}

void begin_checkpoints(Context& c, RunRecord& r) {
    if (r.started || !r.run->dynamics()) return;
    if (!r.checkpoint) {
        if (c.mode.resume)
            std::fprintf(stderr, "--resume: the run made at %s names no checkpoint and starts from its beginning\n",
                         r.asked_at.c_str());
        return;
    }
    const std::string& file = r.checkpoint->file;
    const bool there = std::filesystem::exists(file);
    if (there && !std::filesystem::is_regular_file(file))
        throw OutsideError("cannot write the checkpoint " + file +
                           ": something that is no file has this name, such as a folder; move it, or give the "
                           "checkpoint another name");
    if (c.mode.resume && there) return read_checkpoint(c, r, file);
    if (c.mode.resume)
        std::fprintf(stderr, "--resume: there is no %s; the run starts from its beginning\n", file.c_str());
    if (there && is_unfinished(file) && std::rename(file.c_str(), (file + ".before").c_str()) == 0 &&
        c.messages.progress)
        std::fprintf(stderr,
                     "%s is of a run that is not over, and kept as %s.before; --resume would have gone on from it\n",
                     file.c_str(), file.c_str());
    write_checkpoint(c, r, file);
}

void keep_if_due(Context& c, RunRecord& r) {
    if (!r.checkpoint || r.checkpoint->ended) return;
    const bool due = std::chrono::duration<double>(Clock::now() - r.checkpoint->last).count() >= r.checkpoint->every;
    if (!due && !r.closed) return;
    r.checkpoint->ended = r.closed;
    try {
        write_checkpoint(c, r, r.checkpoint->file);
    } catch (const OutsideError& e) {  // no reason to lose the run
        const std::string text = std::string(e.what()) + (r.closed ? "; the run is over" : "; the run goes on") +
                                 ", the checkpoint before stays as it was";
        std::fprintf(stderr, "%s\n", text.c_str());
        if (std::find(c.messages.warned.begin(), c.messages.warned.end(), text) == c.messages.warned.end())
            c.messages.warned.push_back(text);
    }
    r.checkpoint->last = Clock::now();
}

}  // namespace hinge
