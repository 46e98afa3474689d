// Dynamics: Newmark's beta method, one linear solve a step (paper, eq 15).
//
// A step, in the paper's words: loads, [contact], predict, recover stresses, [yield], solve, correct, [part],
// [fracture], commit. Stages in brackets are in the list only if the scene calls for them.
//
// Eq 15 has M a' + K du = F - R_t with du = dt v + dt^2 ((1/2 - beta) a + beta a'). Here the part of du that is known
// when the step begins, dt v + dt^2 a / 2, is applied first and the stresses are recovered there, exactly; what is left
// to solve for is the change of the acceleration, (M + beta dt^2 K) da = F - R(predicted) - M a. For a linear structure
// this is eq 15 to the letter; for one that turns and yields, the force out of balance is not carried to the next step
// but met in this one. Steps longer than the fastest waves need are solved from du = 0 instead, as eq 15 is written.
//
// Beta 0 with lumped masses is the central difference method: K drops out of eq 15, and the acceleration follows node
// by node.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <unordered_map>

#include "core/built.h"
#include "algebra/mass.h"
#include "algebra/effective_stiffness.h"
#include "run/run.h"

namespace hinge {

/// What a step is solved from: the acceleration held (short steps), the displacement held (long ones), or whichever
/// suits dt against the time in which an axial wave crosses the shortest element.
enum class Predictor : std::uint8_t { by_step, acceleration, displacement };

struct DynamicSettings {
    double dt = 0;           ///< s
    double duration = 0;     ///< s
    bool automatic = false;  ///< dt is the shortest step (Dynamics::shortest_step); longer ones where nothing happens
    double beta = 0.25;      ///< Newmark's beta, 0.25..1; the paper uses 0.25 without and 0.4 with contact; 0: explicit
    /// What a step leaves of the highest frequencies' amplitude, 0..1; below 1 Newmark's method with alpha of Wood,
    /// Bossak and Zienkiewicz (Int. J. Num. Meth. Eng. 15, 1980), M ((1 - alpha) a' + alpha a) = F' - R', and beta =
    /// beta_of(rho_infinity).
    double rho_infinity = 1;
    double alpha() const { return (rho_infinity - 1) / (rho_infinity + 1); }  ///< -1..0
    double gamma() const { return 0.5 - alpha(); }
    static double beta_of(double rho_infinity) {
        const double x = rho_infinity + 1;
        return 1 / (x * x);
    }                    ///< (1 - alpha)^2 / 4
    int iterations = 0;  ///< 1: the paper's one solve; more: Newton until `tolerance`; 0: one solve, but Newton (30, to
                         ///< 1e-6) where hinges form or displacements are large, in steps too long for one
    Predictor predictor = Predictor::by_step;
    double tolerance = 1e-10;  ///< of Newton: correction of the acceleration, relative to the step's first
    bool geometric = true;     ///< initial-stress stiffness in the operator (not in the forces, which are exact)
    double turn = 0.01;        ///< rad: an element's part of the operator is rebuilt when it has turned by this much
    bool narrow = true;        ///< in steps no longer than the fastest waves need, the operator in single precision
    /// The run ends, failed, when the ledger's remainder is a larger part of the energy turned over. 0: never, the
    /// default of Shift::whole, whose ledger cannot close; with Shift::plastic a tenth.
    std::optional<double> energy_tolerance;
    /// Steps that would lose more than their share of this part of the energy turned over are taken back and halved, as
    /// are those that cannot be solved; down to dt / 1024, and back up to dt. 0: every step is kept.
    double step_control = 0;
    bool rest = true;  ///< bodies at rest are left alone until something reaches them
    int threads = 1;   ///< how many share the work of a step; the bits are the same for any number
    SolverSettings solver;
};

class Dynamics : public Run {
public:
    Dynamics(std::shared_ptr<const Structure> structure, State start, DynamicSettings settings);

    bool advance() override;
    long planned_steps() const override { return steps_done() + (pace_.whole - pace_.done) / pace_.length; }
    /// How far the axial wave comes in a step, against the shortest element; where hinges may chatter, the shear
    /// vibration's phase too.
    static double crossing(const Structure& structure, double dt);
    /// The step of an impact, s: see dynamics_pace.cpp; a whole part of the duration.
    static double shortest_step(const Structure& structure, double duration);
    const char* kind() const override { return "dynamic"; }
    std::vector<StageTime> stage_times() const override;
    std::vector<Effect> effects() const override;
    const DynamicSettings& settings() const { return settings_; }

    /// Appends all that the bits of later steps depend on, and what was counted so far. Changes nothing.
    void save(std::string& to) const;
    /// Takes back what save() made of a run of the same structure with the same settings, before this run's first step
    /// or between two; the number of threads may be another. Throws Damaged (core/archive.h) where that makes no sense;
    /// the run is then as it was.
    void restore(std::string_view saved);

    EffectiveStiffness::Counts solver_counts() const {
        return effective_ ? effective_->counts() : EffectiveStiffness::Counts{};
    }
    double shortest() const {
        return pace_.unit * double(pace_.own);
    }  ///< s: dt, with "auto" the shortest, before any is halved
    double shortest_taken() const { return pace_.unit * double(pace_.least); }  ///< s
    long rejected() const { return pace_.rejected; }                            ///< steps taken back by step control
    bool explicit_steps() const { return settings_.beta == 0; }
    /// The fastest node of the run so far: m/s, node, s.
    struct Fastest {
        double speed = 0;
        int node = -1;
        double time = 0;
        template <class Self, class A>
        static void fields(Self& s, A& a) {
            a(s.speed, s.node, s.time);
        }
    };
    const Fastest& fastest() const { return fastest_; }
    long element_updates() const { return sweep_.updates(); }
    /// Seconds that one product of this run's operator, block by block and uncondensed, with a vector takes: the
    /// yardstick of a step.
    double time_product(int repeats) const { return effective_ ? effective_->time_product(repeats) : 0; }

private:
    struct Stage {
        const char* name;
        const char* effect;
        void (Dynamics::*run)();
        double seconds = 0;
    };
    bool with_contact() const { return built::contact && state_.contact.has_value(); }
    bool in_contact() const { return with_contact() && !state_.contact->idle(); }
    bool with_fracture() const { return built::fracture && !structure_->model().fracture().empty(); }
    bool can_yield() const { return built::plasticity && structure_->can_yield(); }
    void loads();
    void contact();
    void restart();
    void predict();
    void recover();
    void yield();
    void renew_operator();
    void solve();
    void correct();
    void accelerate();
    void part();
    void fracture();
    void commit();

    void apply_loads(double t);
    void find_acceleration();
    void add_hung_inertia();
    void keep_stub_momentum(const std::vector<Vec6>& change);
    void renew_mass(const Pose& pose);
    void renew_couplings(const std::vector<Quat>& rotation);
    void place_contact(const std::vector<Vec3>& displacement);
    void note_contacts();
    int contact_rule(int element_a, int element_b);
    void foresee_supports();
    void move_supports();
    void meet_supports();
    void book_supports();
    struct Kick {
        double square = 0, linear = 0, by_supports = 0;
    };
    Kick kick(const std::vector<Vec6>& impulse);
    void add_missed(const std::vector<Vec6>& impulse, double work);
    double give_back(const contact::Released& tie);
    void list_bars();
    void begin_operator();
    void wants_rebuild(int element);
    void move_to_increment(int first, int end);
    void note_fastest();
    void take_reactions(std::vector<Vec6>& right);
    void heed_fracture(int element);
    void judge(int element, const beam::Flow* flow, bool news);
    struct Watched {
        int element;
        double x[2], y[2], axial, per_length;
        template <class Self, class A>
        static void fields(Self& s, A& a) {
            a(s.element, s.x, s.y, s.axial, s.per_length);
        }
    };
    Watched watch_strains(int element) const;
    void list_news();
    int weaker_end(int element, const beam::Flow* flow) const;
    void list_section(int element, int side, const Vec6& elastic, const Vec6& plastic, const beam::Flow* flow);
    void ask_sections();
    class Asked;
    void ask_batch(int rule);
    void take_step();
    void guard();
    double remainder_share(const Energy& energy);
    bool controlled() const { return settings_.step_control > 0; }
    void weigh();
    Energy energy_of_trial();
    bool again_shorter();
    void halve(long tried, const std::string& why);
    double work_of_loads() const;
    double work_of_supports() const;
    void leave_met();
    double dissipated() const;
    void remember();
    void take_back();
    void renew_hung_operator(std::size_t node);
    std::string name_the_culprit() const;
    void let_rest();
    void wake_bodies();
    struct Sleeper {
        const char* effect;
        bool awake = false;
        long quiet = 0;
    };
    void note_waking(std::string effect, bool awake, std::string why);
    template <class Why>
    void watch(Sleeper& sleeper, bool busy, Why why);
    void watch_effects();
    template <class Self, class A>
    static void fields(Self& s, A& a);
    void read(std::string_view saved);
    bool makes_sense() const;

    DynamicSettings settings_;
    /// whole, done, the coming step's length, its own (that of the settings, with "auto" the shortest) and the least so
    /// far are counted in units: own steps, or with step control the finest.
    struct Pace {
        double unit;
        long own, whole, done = 0, length = own, least = own;
        int calm = 0;
        double start = 0;
        int easy = 0, patience = 8;
        long rejected = 0;
    };
    Pace pace_;
    double jump_ = 0, motion_ = 0;  ///< of the last step: dt |da| / |v|; sum of m v^2
    bool over() const { return pace_.done >= pace_.whole; }
    void choose_step();
    bool loads_change() const;
    void take_steps_of(long length);
    void set_length(long length);
    std::vector<Stage> stages_;
    ThreadPool pool_;
    Sweep sweep_;
    std::unique_ptr<EffectiveStiffness> effective_;  ///< none in explicit steps
    std::unique_ptr<Mass> mass_;
    std::vector<int> held_nodes_;  ///< with a freedom that is held
    std::vector<int> mass_stale_;
    std::vector<char> in_mass_stale_;
    Pose trial_;
    std::vector<Vec3> increment_;  ///< rotation vector of the step
    Fastest fastest_;
    std::vector<Fastest> fastest_of_;  ///< of each piece of the nodes, speeds squared
    std::vector<double> lumped_mass_;  ///< kg, to judge what is rounding
    std::vector<Vec6> external_, nodal_, right_, change_, force_;
    struct Loaded {
        int node;
        Vec6 gravity, now = Vec6::Zero(), before = Vec6::Zero();
    };
    std::vector<Loaded> loaded_;  ///< nodes with loads of the script: F is the sum of gravity and what acts now
    std::map<std::size_t, Vec6> rule_loads_;  ///< of the loads that are functions of the state: what they said last
    std::vector<int> load_at_;                ///< of each of the model's loads, its place in loaded_
    std::vector<Yielding> yielding_;
    std::vector<Yielding> hinges_;  ///< of the last step, when a step is solved from du = 0
    std::vector<int> was_yielding_;
    std::vector<Mat6> tangents_;
    std::unordered_map<int, Mat6> built_;  ///< D_p in the operator, of the elements that have it there
    std::vector<int> rebuild_;
    std::vector<char> in_rebuild_;
    std::vector<contact::Bar> bars_;
    bool bars_changed_ = true, again_ = false, restart_ = false, take_up_ = false, from_rest_ = false;
    long contact_age_ = 0;
    double first_change_ = 0, last_change_ = 0, damping_ = 1;
    std::vector<Vec6> met_,
        next_met_;          ///< dissipative: the acceleration that the last step's forces met, (1 - alpha) a' + alpha a
    double numerical_ = 0;  ///< J, taken out by the step
    std::vector<Vec3> stub_rate_, next_stub_rate_,
        tried_stub_rate_;  ///< rate of change of w x S that a step's forces met: of the last one, of this one; where
                           ///< stresses were recovered
    int iteration_ = 0;
    std::string failure_;
    bool reject_ = false;        ///< failure_ is one that a shorter step may mend
    double kept_remainder_ = 0;  ///< J, of the last step that was kept
    struct Good {
        State state;
        double share;
    };
    std::optional<Good> good_;                   ///< when the ledger was last looked at and closed
    long looked_at_ = 0;                         ///< the step of that
    double turned_over_ = 0, ledger_floor_ = 0;  ///< J
    std::vector<Quat> hung_built_;               ///< orientation that a hung mass has in the operator
    std::vector<Vec3> contact_position_;
    std::vector<int> fracture_candidates_;  ///< elements that could break without flowing in the step, rising
    std::vector<char> in_candidates_;
    std::vector<int> flowing_;
    std::vector<int> resting_;  ///< of each node: the body at rest that it belongs to, -1; empty when there is none
    std::unordered_map<int, Vec6> weight_at_rest_;  ///< F of those nodes
    Sleeper contact_sleeper_{"contact"}, plasticity_sleeper_{"plasticity"};
    struct Break {
        int element, end;
    };
    std::vector<Break> to_break_;
    std::vector<SectionView> asked_;  ///< in this step, of one rule
    std::vector<Watched> watched_;    ///< elements that have flowed and have a rule of the script's, rising
    std::vector<int> news_;           ///< of those, strained in this step as never before
    struct Strained {
        double* at;
        std::array<double, 3> before;
    };
    std::vector<Strained> strained_before_;        ///< in this step
    std::vector<std::vector<int>> rule_elements_;  ///< of each fracture rule; filled when a batch asks
    std::map<std::pair<int, int>, std::optional<contact::ContactSettings>>
        pair_rules_;  ///< what the script's rule said of two members
    /// A freedom of a support that moves: where it is now and was one and two steps ago, m, and how long a step is, s;
    /// where the step takes it, m, m/s, m/s^2.
    struct Moved {
        int node, component;
        History path;
        double from = 0, now = 0, before = 0, long_before = 0, apart = 0, next = 0, speed = 0, acceleration = 0,
               force = 0, next_force = 0;
        bool begun = false;
    };
    std::vector<Moved> moved_;
    double momentum_at(const Moved& m, const std::vector<Vec6>& of, bool stubs = true) const;
    double work_on_momentum(const std::vector<Vec6>& velocity) const;
    std::unordered_map<int, Mat12> support_parts_;  ///< of the operator, whole, for the elements at moved supports
    // for a step that is taken back because a rule of the script failed
    bool has_rules_ = false;
    std::size_t kept_a_section_ = 0;  ///< numbers that rules keep of a section
    struct Kept {
        double* at;
        double before;
    };
    std::vector<Kept> kept_before_;
    struct Undo {
        Accumulated accumulated;
        Pace pace;
        bool restart, bars_changed;
        long contact_age;
        Fastest fastest;
    };
    Undo undo_{};
};

}  // namespace hinge
