// The declared model: nodes, supports, members, loads and rules of a script. The structure of a run is computed from it
// (structure.h).
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/types.h"
#include "model/declarations.h"
#include "model/history.h"
#include "section/section.h"

namespace hinge {

enum class Formulation : std::uint8_t { conventional, asi, asi_gauss };
enum class Displacement : std::uint8_t { small, large };  ///< the paper's TLF and ULF

/// The elements' mass: the paper's linear one, or that of the cubic shape which two elements of asi-gauss stand for.
enum class MassShape : std::uint8_t { linear, cubic };

/// Second-order (P-delta) effect in large displacement: of the chord of an element alone, or also of the bending of a
/// pair between its ends (beam/beam_column.h).
enum class PDelta : std::uint8_t { chord, member };

/// Distribution of the members' weight: along them, like a load of the same size, or at the nodes of their elements.
enum class Weight : std::uint8_t { nodes, members };

/// Which integration points move to a plastic hinge. `plastic`: that of the plastic strain alone, so that the elastic
/// stiffness stays exact. `elastic_and_plastic`: both, as the paper prints it.
enum class Shift : std::uint8_t { plastic, elastic_and_plastic };

/// A declared node.
struct NodeData {
    Vec3 position;
    std::uint8_t fixed = 0;  ///< bits 0..5: ux uy uz rx ry rz
};

/// Reason for the number of elements of a member: given by the script, or chosen by a run for elements = "auto"
/// (undecided: not yet; see run/element_count.h).
enum class ElementsBy : std::uint8_t { script, undecided, neither, compression, yield, no_solution };

/// Which axial forces a member carries: both signs, tension alone (cables, slender braces) or compression alone (props,
/// bearings).
enum class Carries : std::uint8_t { both, tension, compression };
/// "both", "tension" or "compression"
const char* carries_word(Carries carries);

/// A declared member.
struct MemberData {
    int node[2];
    std::shared_ptr<const Section> section;
    std::shared_ptr<const Material> material;
    Vec3 up;
    int elements;
    std::vector<int> groups;  ///< the first one colours it
    /// Strength of its ends over their plastic rotation (section/laws/backbone.cpp); null: constant.
    std::shared_ptr<const beam::MaterialLaw> backbone = nullptr;
    std::shared_ptr<const beam::MaterialLaw> law =
        nullptr;  ///< of the script, for all its sections (section/laws/own_law.cpp)
    ElementsBy elements_by = ElementsBy::script;
    double elements_part = 0;      ///< ratio that decided: compression over Euler's load, moment over the plastic one
    bool elements_capped = false;  ///< more would have been needed
    Carries carries = Carries::both;
    double line_mass = 0;  ///< kg/m, mean over its length: what it carries beside its own mass (effects/line_mass.h)
    /// Bit i: end i is joined to its node by a joint (effects/joints.h), so that it has a node of its own.
    std::uint8_t joints = 0;
    bool is_moved = false;  ///< by offsets of its ends, beside which `up` is checked
    bool has_joint(int end) const { return joints >> end & 1; }
    /// What the nodes inside stand off the line between its ends, m: half a sine wave with `bow` in the middle, and
    /// `inner`, one for each, or empty. The two elements of a pair are in line, since the pair's bending
    /// (beam_column.h) is that of a straight bar: the node in the middle of a pair stands halfway between its ends.
    Vec3 bow = Vec3::Zero();
    std::vector<Vec3> inner = {};
    double mass_per_length() const;  ///< kg/m, with line_mass
    bool is_straight() const { return inner.empty() && bow.isZero(0); }
    Vec3 offset(int after) const;  ///< of the node after so many elements
};

/// Initial velocity of nodes as a rigid body: `linear` of the mean of their positions, m/s, and `angular` about it,
/// rad/s.
struct GivenVelocity {
    std::vector<int> nodes;
    Vec3 linear, angular;
    int group = -1;             ///< whose nodes these are; -1: of a node or a member
    std::string asked_at = {};  ///< the script's line
};

/// Initial velocities that nodes were given.
class GivenVelocities {
public:
    /// Index in given_velocities of the last velocity of each node; -1: none.
    const std::vector<int>& velocity_given() const { return velocity_given_; }
    /// True if both ends of a member were given a velocity: its inner nodes then have interpolated velocities. If only
    /// one end has a velocity, that node moves alone.
    bool moves_as_a_whole(const MemberData& member) const {
        return velocity_given_[member.node[0]] >= 0 && velocity_given_[member.node[1]] >= 0;
    }
    const std::vector<GivenVelocity>& given_velocities() const { return given_velocities_; }
    const std::vector<Vec6>& velocities() const { return velocities_; }

protected:
    std::vector<Vec6> velocities_;
    std::vector<int> velocity_given_;
    std::vector<GivenVelocity> given_velocities_;
};

/// Options of a model.
struct ModelOptions {
    Formulation formulation = Formulation::asi_gauss;
    Displacement displacement = Displacement::large;
    Shift shift = Shift::plastic;
    MassShape mass = MassShape::linear;
    PDelta p_delta = PDelta::member;
    Weight weight = Weight::members;
    Interaction interaction = Interaction::exact;  ///< of sections that do not say theirs and have an outline
    bool plasticity = true;
    int elements_per_member = 2;
    bool automatic_elements = false;  ///< elements_per_member = "auto"
    double elements_accuracy = 0.01;  ///< of the members whose elements = "auto"
};

/// Raises InputError unless all three numbers are finite: "force is {..} N; ...".
void must_be_finite(const Vec3& v, const char* what, const char* unit);

/// The declared model. Functions that add return the index of the new object; for wrong input they raise InputError and
/// change nothing.
class Model : public LoadCases, public GivenVelocities {
public:
    explicit Model(ModelOptions options);

    int add_node(const Vec3& position);
    void fix(int node, std::uint8_t mask);
    int add_member(MemberData member);
    /// Throws InputError where add_member would.
    void check_member(const MemberData& member) const;
    void set_member_groups(int member, std::vector<int> groups);
    void add_line_mass(int member, double per_length);  ///< kg/m, mean over its length
    /// Imperfections: moves the declared place of a node, m, and adds to what the nodes inside a member stand off its
    /// line.
    void displace(int node, const Vec3& by);
    void add_bow(int member, const Vec3& bow);
    void add_offsets(int member, const std::vector<Vec3>& inner);
    bool has_undecided_elements() const;
    void set_elements(int member, int elements, ElementsBy by, double part, bool capped);
    /// Takes the numbers of elements that a copy of this model, or of a part of it, has chosen.
    void take_elements(const Model& decided);
    void set_velocity(int node, const Vec3& linear, const Vec3& angular);
    void set_velocities(GivenVelocity given);
    /// A member joins groups: its nodes get the velocities that were given to these, unless later ones were given to
    /// them. refuse_velocities: throws InputError where that would move the mean position about which others rotate.
    void join_velocities(int member);
    void refuse_velocities(const MemberData& member) const;
    void set_options(const ModelOptions& options);
    int group(const std::string& name);             ///< finds or adds it
    int find_group(const std::string& name) const;  ///< -1 when there is none

    const ModelOptions& options() const { return options_; }
    const std::vector<NodeData>& nodes() const { return nodes_; }
    const std::vector<MemberData>& members() const { return members_; }
    const std::vector<std::string>& groups() const { return groups_; }
    std::vector<int> nodes_of_group(int group) const;

private:
    ModelOptions options_;
    std::vector<NodeData> nodes_;
    std::vector<MemberData> members_;
    std::vector<std::string> groups_;
};

}  // namespace hinge
