// A run: a structure taken from step to step, whoever asks for the steps. Statics and dynamics are two kinds of it.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "algebra/node_blocks.h"
#include "effects/host.h"
#include "effects/reports.h"
#include "effects/workspace.h"
#include "run/constraints.h"
#include "run/failure_text.h"
#include "run/notice.h"
#include "run/run_report.h"
#include "run/watch.h"

namespace hinge {

struct EffectList;

enum class Verdict { running, completed, stopped, failed };
const char* name(Verdict v);

/// One stage of a step, in the order the step does it, with the seconds spent in it.
struct StageTime {
    const char* name;
    double seconds = 0;
};

class Run : public RunReport, protected Host {
public:
    Run(std::shared_ptr<const Structure> structure, State start, RunKind kind, int threads, bool inertia);
    ~Run() override;

    /// One step. False when there is none left (see verdict); the state is then that of the last good step.
    virtual bool advance() = 0;
    virtual long planned_steps() const = 0;
    virtual std::vector<StageTime> stage_times() const = 0;
    virtual std::vector<PlanLine> effects() const = 0;

    void stop();  ///< the script has seen enough
    Verdict verdict() const { return verdict_; }
    /// In words: why it failed, or what is to be said of its end; "" for nothing. Nothing reads that back. What may
    /// help is reason_with_advice (advice/adviser.h).
    std::string reason() const;
    /// The same of a run that failed or reached a limit load, no more than where the structure gives way.
    std::string brief_reason() const;
    /// Null for a run that has not failed.
    const RunFailure* failure() const { return verdict_ == Verdict::failed ? &failure_ : nullptr; }
    const State& state() const { return state_; }
    const Structure& structure() const { return *structure_; }
    std::shared_ptr<const Structure> share_structure() const { return structure_; }
    Energy energy() const { return energy_of(state_); }
    /// What effects add to the stiffness of the elements where the state is; joints that have yielded with that of
    /// unloading, so that it does not follow the rounding of a moment that is at its strength. `loads`: factor on the
    /// part of loads that turn with their members.
    Blocks added_stiffness(Yielded yielded = Yielded::unloads, double loads = 1) const;
    /// Whether a load acts whose derivative by the displacements is unsymmetric: a moment, a load that turns with its
    /// member.
    bool has_unsymmetric_loads() const;
    /// Damping that effects have there, in blocks of one node or two, N s/m; in dynamics that of point masses, too.
    Blocks added_damping() const;
    /// Constraints between degrees of freedom; null where there are none.
    const Constraints* constraints() const { return constraints_.get(); }
    /// The accounts of the energy balance, in the order in which they are shown.
    const AccountList& accounts() const { return accounts_; }
    /// Effects that woke, or went to sleep because they had nothing to do; the first thousand.
    struct Activation {
        double time;
        std::string effect;
        bool awake;
        std::string why;
        template <class Self, class A>
        static void fields(Self& s, A& a) {
            a(s.time, s.effect, s.awake, s.why);
        }
    };
    const std::vector<Activation>& activations() const { return activations_; }
    /// What it has seen that its results do not show.
    const std::vector<Notice>& notices() const { return notices_; }
    /// Before the first step: calls the watch from then on.
    void attach(std::unique_ptr<Watch> watch) { watches_.push_back(std::move(watch)); }
    const std::vector<std::unique_ptr<Watch>>& watches() const { return watches_; }
    /// What its stages and effects work on.
    const Workspace& workspace() const { return w_; }
    const EffectList& effect_list() const { return *effects_; }
    long breaks() const { return breaks_; }  ///< elements that broke in this run
    /// What broke in the step done last, with its cause.
    virtual std::span<const Break> broken_last() const { return {}; }
    long steps_done() const { return state_.step - first_step_; }
    long element_updates() const { return assembly_.updates(); }

    Vec6 displacement(int node) const;  ///< ux uy uz (m), rotation vector rx ry rz (rad)
    Vec6 reaction(int node) const;      ///< forces (N) and moments (N m) that the supports exert on the node
    /// At an end of an element, side -1 or 1; zero in a broken one. Loads between its nodes are in them.
    SectionForces section_forces(int element, double side) const;
    /// P l^2 / EI of an element about x and about y, P positive in compression, where the axial force acts on the bow
    /// of its pair (p_delta = "member"); else 0. Sets the course of moments between its ends (BarBending).
    Eigen::Vector2d compression(int element) const;
    /// Loads that act where the state is.
    std::vector<ShownLoad> shown_loads() const;
    double yield_value(int element) const;            ///< f_y of eq 14, the larger of its sections; 0 when broken
    double yield_value(int element, double r) const;  ///< at r: -1 node 1, 1 node 2, 0 between

    struct Counts {
        long yielded = 0, broken = 0, elastic = 0, touched = 0;
    };
    /// Members of the group (-1: all): broken if one of its elements is, else yielded if one has ever been fully
    /// plastic, else elastic; touched, whatever else it is, if one has been in contact.
    Counts count_members(int group) const;

protected:
    void fail(RunFailure why);
    /// The sentence of a cause.
    virtual std::string text_of_cause(const Failure& failure) const { return text_of(failure, *structure_); }
    /// What is to be said of a run that has completed; "" for nothing.
    virtual std::string reason_at_end() const { return {}; }
    void note(const Notice& notice) { notices_.push_back(notice); }
    void call_watches(const Step& step);  ///< after a commit
    void end_step();                      ///< calls the watches where advance() ends
    void save_watches(Writer& to) const;
    void restore_watches(Reader& from);
    void watch_as(const Run& before);  ///< watches that go on where this run goes on as another
    void begin_constraints();
    Energy energy_of(const State& state) const;

    // Host: what a static run has no use for does nothing.
    void stiffness_changed(int) override {}
    void blocks_changed(const Pose&) override {}
    void set_offset_mass(int, const Mat6&) override {}
    void accelerations_anew() override {}
    void constraints_changed() override {}
    void mass_changed(int) override {}
    ImpulseResponse respond(const std::vector<Vec6>&) override { return {}; }
    void change_steady_load(int node, const Vec3& force) override;
    void reached(const std::vector<Reached>& elements) override;
    void note_activation(const std::string& effect, bool awake, const std::string& why) override;
    void keep_from_rest(const Bodies& bodies, std::vector<char>& rests) override;
    void hold_up(const Bodies& bodies, std::vector<char>& held_up) override;
    void lie_together(const Bodies& bodies, BodyPairs& pairs) override;
    void rest_changed() override;
    std::vector<beam::BowPoint> points_on_pair(int first, int plane, const Pose& at, double factor) override;
    void count_break() override { ++breaks_; }
    bool has_effective_stiffness() const override { return true; }

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.state_, s.initial_, s.at_start_, s.reaction_, s.verdict_, s.failure_, s.activations_, s.first_step_,
          s.breaks_, s.notices_);
    }

    std::shared_ptr<const Structure> structure_;
    State state_;
    std::unordered_map<int, Vec6> reaction_;  ///< of nodes with a degree of freedom that is held
    ThreadPool pool_;
    ElementAssembly assembly_;
    Workspace w_;
    std::unique_ptr<const EffectList> effects_;
    std::unique_ptr<Constraints> constraints_;  ///< null where there are none
    AccountList accounts_;
    double initial_ = 0;  ///< J, kinetic energy and all that is stored, at the start
    Accounts at_start_;   ///< what had been added up before this run
    Verdict verdict_ = Verdict::running;
    std::vector<Activation> activations_;
    std::vector<Notice> notices_;
    std::vector<std::unique_ptr<Watch>> watches_;
    RunFailure failure_;  ///< of statics also what ended it at a limit load
    long first_step_, breaks_ = 0;
};

}  // namespace hinge
