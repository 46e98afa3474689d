// What a script declares: nodes, supports, members, loads and rules. Nothing here moves; see structure.h for what is
// computed from it.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "contact/contact.h"
#include "core/archive.h"
#include "core/types.h"
#include "model/fracture_rule.h"
#include "model/history.h"
#include "model/load_cases.h"

namespace hinge {

/// A material; SI units. `yield_stress` infinite: never yields.
struct Material {
    double E = 0;                                                   ///< Pa
    double G = 0;                                                   ///< Pa
    double density = 0;                                             ///< kg/m^3
    double yield_stress = std::numeric_limits<double>::infinity();  ///< Pa
    std::string asked_at = {};                                      ///< the script's line, "" where none
};

/// A cross-section. x and y are its local axes, y the member's `up`; Ix bends about x (deflection along y).
struct Section {
    std::string kind = "general";
    double area = 0, Ix = 0, Iy = 0, J = 0;     ///< m^2, m^4
    double shear_area_x = 0, shear_area_y = 0;  ///< m^2
    double mass_Ix = 0, mass_Iy = 0;            ///< m^4, of the rotary inertia; 0: Ix and Iy
    double plastic_area = 0, Zx = 0, Zy = 0,
           Zz = 0;  ///< fully plastic resultant / stress: m^2, m^3 (Zz per shear yield stress)
    std::optional<double> N0, Mx0, My0, Mz0;  ///< given directly, N and N m
    double width = 0, depth = 0;              ///< m, along x and y: contact and pictures
    double web = 0, flange = 0;               ///< m, thickness of an H's: pictures
    std::string asked_at = {};                ///< the script's line, "" where none
};

enum class Formulation : std::uint8_t { conventional, asi, asi_gauss };
enum class Displacement : std::uint8_t { small, large };  ///< the paper's TLF and ULF

/// The elements' mass: the paper's linear one, or that of the cubic shape which two elements of asi-gauss stand for.
enum class MassShape : std::uint8_t { linear, cubic };

/// Where the axial force of an element acts in large displacement: on its chord alone, or also on the bending of a pair
/// between its ends (beam/beam_column.h).
enum class PDelta : std::uint8_t { chord, member };

/// Where the weight of members acts: along them, as a load of the same size does, or at the nodes of their elements.
enum class Weight : std::uint8_t { nodes, members };

/// Which integration points move to a plastic hinge. `plastic`: that of the plastic strain alone, so that the elastic
/// stiffness stays exact. `elastic_and_plastic`: both, as the paper prints it.
enum class Shift : std::uint8_t { plastic, elastic_and_plastic };

struct NodeData {
    Vec3 position;
    std::uint8_t fixed = 0;  ///< bits 0..5: ux uy uz rx ry rz
};

/// Why a member has as many elements as it has: the script says so, or its elements = "auto" and a run has decided (not
/// yet: undecided), by what script/element_count.h says.
enum class ElementsBy : std::uint8_t { script, undecided, neither, compression, yield, no_solution };

struct MemberData {
    int node[2];
    std::shared_ptr<const Section> section;
    std::shared_ptr<const Material> material;
    Vec3 up;
    int elements;
    std::vector<int> groups;  ///< the first one colours it
    ElementsBy elements_by = ElementsBy::script;
    double elements_part = 0;      ///< of what decided: compression over Euler's load, moment over the plastic one
    bool elements_capped = false;  ///< more would have been needed
};

struct NodalLoad {
    int node;
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();  ///< N, N m, in space
    History history;
    int number = 0;  ///< its own for as long as the model lives
    /// In the place of force or moment: what acts at the end of a step (time, s), given the state where it begins;
    /// dynamics only.
    std::function<Vec3(double)> force_rule = {}, moment_rule = {};
    bool follows_state() const { return force_rule || moment_rule; }
    int load_case = -1;
    bool held = false;  ///< statics: it acts in full from the start on (Model::choose)
    void times(double factor);
    void forget_history() { history = {}; }
};

/// The velocity of nodes as a rigid body: `linear` of the mean of where they are, m/s, and `angular` about it, rad/s.
struct GivenVelocity {
    std::vector<int> nodes;
    Vec3 linear, angular;
};

/// A degree of freedom of a support that is moved: its displacement (m, along x, y or z) over time, counted from where
/// the run begins.
struct SupportMotion {
    int node, component;
    History displacement;
};

/// Of several rules the last one of the groups of both members counts, else the last one for all members.
struct ContactRule {
    contact::ContactSettings settings;
    std::vector<int> groups;  ///< both members are in one of these; empty: all members
    bool between = false;     ///< one member in the first of two groups, one in the second
    std::function<std::optional<contact::ContactSettings>(int member_a, int member_b)>
        pairs;  ///< asked once a pair of members: none, or by what numbers
    std::function<void(const contact::ContactEvent&, int member_a, int member_b)> on_contact, on_release;
};

struct ModelOptions {
    Formulation formulation = Formulation::asi_gauss;
    Displacement displacement = Displacement::large;
    Shift shift = Shift::plastic;
    MassShape mass = MassShape::linear;
    PDelta p_delta = PDelta::member;
    Weight weight = Weight::members;
    bool plasticity = true;
    int elements_per_member = 2;
    bool automatic_elements = false;  ///< elements_per_member = "auto"
    double elements_accuracy = 0.01;  ///< of the members whose elements = "auto"
};

/// Effects that a model asks for and could do without, by their names in the plan, beside those that keep declarations.
inline const std::vector<std::string> optional_effects = {
    "gravity", "large displacement", "plasticity", "fracture", "contact", "friction"};

/// What a script declares of an effect that keeps its own declarations (effects/*.cpp), under the effect's name. A
/// model is copied for each run, and its declarations with it.
class Declaration {
public:
    virtual ~Declaration() = default;
    virtual std::shared_ptr<Declaration> copy() const = 0;
    virtual std::size_t count() const = 0;  ///< of things declared, for the fingerprint of a checkpoint
    /// All numbers that change bits, and of functions whether there is one, for the same.
    virtual void save(Writer& to) const = 0;
    /// Of loads: choose_loads.
    virtual int choose(const Declaration* before, const ChosenLoads& chosen) { return (void)before, (void)chosen, 0; }
};

/// A list of T. T lists its fields (core/archive.h) and holds functions only in members that it leaves out there.
template <class T>
class DeclaredList : public Declaration {
public:
    std::vector<T> list;
    std::shared_ptr<Declaration> copy() const override { return std::make_shared<DeclaredList>(*this); }
    std::size_t count() const override { return list.size(); }
    void save(Writer& to) const override { to(list); }
    int choose(const Declaration* before, const ChosenLoads& chosen) override {
        if constexpr (requires(T load) { load.times(1.0); })
            return choose_loads(list, before ? &static_cast<const DeclaredList*>(before)->list : nullptr, chosen);
        return 0;
    }
};

/// By the effect's name. A copy has its own.
struct Declarations : std::map<std::string, std::shared_ptr<Declaration>> {
    Declarations() = default;
    Declarations(const Declarations& other) : std::map<std::string, std::shared_ptr<Declaration>>() {
        for (const auto& [effect, what] : other) emplace(effect, what->copy());
    }
    Declarations(Declarations&&) = default;
    Declarations& operator=(Declarations&&) = default;
};

/// Everything declared. Functions that add return the index of what they added and raise InputError, leaving all as it
/// was.
class Model {
public:
    explicit Model(ModelOptions options);

    int add_node(const Vec3& position);
    void fix(int node, std::uint8_t mask);
    int add_member(MemberData member);
    void set_member_groups(int member, std::vector<int> groups);
    bool has_undecided_elements() const;
    void set_elements(int member, int elements, ElementsBy by, double part, bool capped);
    /// What a copy of this model, or of a part of it, has decided.
    void take_elements(const Model& decided);
    int add_load(NodalLoad load);                  ///< returns its number
    const NodalLoad* find_load(int number) const;  ///< nullptr once it is removed
    void remove_load(int number);
    void set_gravity(const Vec3& g, int load_case = -1);
    void set_velocity(int node, const Vec3& linear, const Vec3& angular);
    void set_velocities(GivenVelocity given);
    /// Of each node the place in given_velocities of the last one that it was given; -1: none.
    const std::vector<int>& velocity_given() const { return velocity_given_; }
    /// Whether both ends of a member were given a velocity: then its inner nodes have one too, in proportion. Where
    /// only one end was, that node moves alone.
    bool moves_as_a_whole(const MemberData& member) const {
        return velocity_given_[member.node[0]] >= 0 && velocity_given_[member.node[1]] >= 0;
    }
    const std::vector<GivenVelocity>& given_velocities() const { return given_velocities_; }
    int add_case(const std::string& name);
    int find_case(const std::string& name) const;  ///< -1 when there is none
    void add_combination(LoadCombination combination);
    const LoadCombination* find_combination(const std::string& name) const;
    const std::vector<std::string>& cases() const { return cases_; }
    const std::vector<LoadCombination>& combinations() const { return combinations_; }
    /// For a run's own copy: takes of the loads what the run has of them, in numbers. Without cases only what is_static
    /// asks for.
    void choose(const LoadChoice& choice);
    /// The factors of each case in a run, and of those before them that a static run holds. Empty without cases.
    const std::vector<double>& case_factors() const { return case_factors_; }
    const std::vector<double>& held_factors() const { return held_factors_; }
    /// The part of gravity that a static run holds from the start on, m/s^2.
    const Vec3& held_gravity() const { return held_gravity_; }
    bool holds_loads() const { return !held_factors_.empty(); }
    int set_aside() const { return set_aside_; }  ///< loads with a history that a static run does not take
    void add_fracture(FractureRule rule);
    void add_contact(ContactRule rule);
    void add_motion(SupportMotion motion);
    /// Appends to the list of T that is kept for an effect; T is always the same for one name. `effect` is the name of
    /// an EffectKind. Raises InputError inside a step, as all functions that declare.
    template <class T>
    void declare(const std::string& effect, T what) {
        check_open();
        auto& kept = declared_[effect];
        if (!kept) kept = std::make_shared<DeclaredList<T>>();
        static_cast<DeclaredList<T>&>(*kept).list.push_back(std::move(what));
    }
    /// What was declared of an effect; empty where nothing was.
    template <class T>
    const std::vector<T>& declared(const std::string& effect) const {
        static const std::vector<T> none;
        const auto at = declared_.find(effect);
        return at == declared_.end() ? none : static_cast<const DeclaredList<T>&>(*at->second).list;
    }
    const Declarations& declarations() const { return declared_; }
    /// While locked (a run of this model is inside a step) whatever would change it raises InputError.
    void lock(bool locked) { locked_ = locked; }
    /// Takes back what declared one of `optional_effects`, as if the script had not; other names leave all as it is.
    void leave_out(const std::string& effect);
    int group(const std::string& name);             ///< finds or makes
    int find_group(const std::string& name) const;  ///< -1 when there is none

    const ModelOptions& options() const { return options_; }
    const std::vector<NodeData>& nodes() const { return nodes_; }
    const std::vector<MemberData>& members() const { return members_; }
    const std::vector<NodalLoad>& loads() const { return loads_; }
    const std::vector<std::string>& groups() const { return groups_; }
    const std::vector<FractureRule>& fracture() const { return fracture_; }
    const std::vector<ContactRule>& contact() const { return contact_; }
    int contact_rule(int member_a, int member_b) const;  ///< by which the two meet, as their groups have it; -1: none
    bool can_collide(int member) const;
    const std::vector<SupportMotion>& motions() const { return motions_; }
    const std::optional<Vec3>& gravity() const { return gravity_; }
    /// Which line of the script asked for an effect; the first one counts. "" where none did.
    void ask(const std::string& effect, const std::string& line) { asked_.try_emplace(effect, line); }
    bool asked(const std::string& effect) const { return asked_.count(effect) > 0; }
    std::string asked_at(const std::string& effect) const { return asked(effect) ? asked_.at(effect) : ""; }
    const std::vector<Vec6>& velocities() const { return velocities_; }
    std::vector<int> nodes_of_group(int group) const;

private:
    ModelOptions options_;
    std::vector<NodeData> nodes_;
    std::vector<MemberData> members_;
    std::vector<NodalLoad> loads_;  // their numbers rise
    int next_load_ = 0;
    std::vector<std::string> groups_;
    std::vector<FractureRule> fracture_;
    std::vector<ContactRule> contact_;
    std::vector<SupportMotion> motions_;
    Declarations declared_;
    bool locked_ = false;
    void check_open() const;
    std::optional<Vec3> gravity_;
    int gravity_case_ = -1;
    std::map<std::string, std::string> asked_;
    std::vector<Vec6> velocities_;
    std::vector<int> velocity_given_;
    std::vector<GivenVelocity> given_velocities_;
    std::vector<std::string> cases_;
    std::vector<LoadCombination> combinations_;
    std::vector<double> case_factors_, held_factors_;
    Vec3 held_gravity_ = Vec3::Zero();
    double held_permanent_ = 0;  ///< of the loads without a case
    int set_aside_ = 0;
};

}  // namespace hinge
