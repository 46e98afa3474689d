// A run with its recorded results.
#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "advice/advised_run.h"
#include "record/probe.h"
#include "run/run.h"

namespace hinge {

/// First contact, yield or fracture of an element; first yield of a joint about an axis, a limit of its own that it has
/// reached in statics, its break, and the break of a connector.
struct ElementEvent {
    enum class What : int { contact, yield, fracture, joint_yield, joint_limit, joint_break, connector_break } what;
    double at;         ///< s; in statics the load factor
    int element, end;  ///< end 1 or 2; 0: no end, or both
    int limit;         ///< beam::Limit reached at a break; of joints and connectors JointRating::Which
    double strain,
        of;          ///< the strain that reached it, and its limit; of joints and connectors moment, rotation or force
    int joint = -1;  ///< joint or connector, in the order of declaration
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.what, s.at, s.element, s.end, s.limit, s.strain, s.of, s.joint);
    }
};

/// Rows of the energy balance for plots, with or without a history.csv: time, load factor, all accounts, energy error.
/// If they are many, every second one is removed, and so on.
struct KeptRows {
    static constexpr long most = 8192;
    long stride = 1, seen = 0;
    std::vector<double> values;  ///< row by row
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.stride, s.seen, s.values);
    }
};

/// Recorded results of a run's steps that a checkpoint contains.
struct Recorded {
    bool started = false, closed = false;
    long breaks_noted = 0;
    std::vector<double> broken_at,
        left_at;  ///< s, when an element broke, when a node lost its last; -inf: before this run; empty until one does
    double wall = 0;  ///< s in steps
    double worst_energy_error = 0, last_energy_error = 0, initial = 0;
    long row_of = -1;                                      ///< the step of the last row
    std::vector<ElementEvent> happenings;                  ///< in order
    std::vector<std::uint8_t> yielded_seen, touched_seen;  ///< of each element, as in the state
    std::vector<std::uint8_t> joints_seen;                 ///< of each joint, then of each connector: what has happened
    KeptRows kept_rows;
    long resumed_at = 0;            ///< steps, when it last went on from a checkpoint
    double largest_energy = 0;      ///< J, of the rows so far (LargestEnergy::most)
    double last_energy_share = 0;   ///< the energy error as a part of it, also of a balance that no longer closed
    double state_energy_share = 0;  ///< likewise of the last state, to which such a run went back
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.started, s.closed, s.breaks_noted, s.broken_at, s.left_at, s.wall, s.worst_energy_error,
          s.last_energy_error, s.initial, s.row_of, s.happenings, s.yielded_seen, s.touched_seen, s.joints_seen,
          s.kept_rows, s.resumed_at, s.largest_energy, s.last_energy_share, s.state_energy_share);
    }
};

/// The program's own values that a checkpoint keeps beside the run.
struct KeptValues {
    virtual ~KeptValues() = default;
    virtual std::string pack() = 0;
    /// Throws Damaged (core/archive.h) for bytes that pack() cannot have written.
    virtual void check(const std::string& bytes) const = 0;
    virtual void unpack(const std::string& bytes) = 0;
};

/// Checkpoint file of a run, and the interval between writes.
struct CheckpointPlan {
    std::string file;
    double every = 60;                 ///< s
    std::shared_ptr<KeptValues> keep;  ///< saved with it; null for none
    std::chrono::steady_clock::time_point last = std::chrono::steady_clock::now();
    bool ended = false;  ///< it holds the end of the run
};

/// A run with its recorded results.
struct RunRecord : Recorded, AdvisedRun {
    std::vector<std::shared_ptr<Probe>> probes;
    long every = 1;  ///< steps between rows of history.csv; 0: none is kept
    /// The files that grow as the run goes.
    struct Files {
        std::string history_path, events_path;  ///< history.csv and events.csv; "": the run has none
        std::string rows;                       ///< of history.csv, not yet written
        std::string past;                       ///< of history.csv, from a checkpoint
        std::size_t events_written = 0;         ///< of the happenings
    } files;
    std::string weak;           ///< the run before that did not reach its end (weak_link); "" for none
    bool weak_allowed = false;  ///< allow_failed = true
    std::string changed;        ///< the first declaration since, and its line; "" for none
    bool begun = false;         ///< its files are open
    bool stepping = false;      ///< inside a step: the program's functions may not start another
    bool mid_step = false;      ///< inside a step that was not completed
    std::optional<CheckpointPlan> checkpoint;
    int number = 0;  ///< of the program's runs that have begun, from 1
    /// Changes of state of an effect.
    struct Changes {
        int awake = 0, asleep = 0;
        double last = 0;  ///< s
    };
    /// What has been printed and written of it so far.
    struct Progress {
        std::chrono::steady_clock::time_point start, last_shown, last_write;
        std::size_t activations_seen = 0, warnings_seen = 0;
        std::map<std::string, Changes> changes;  ///< by effect: the first of each kind is printed, the others counted
        bool instability_shown = false;
    } progress;
};

}  // namespace hinge
