// The structure of a run: nodes and elements, computed once from the declared model and constant during the run.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "beam/element_mass.h"
#include "beam/timoshenko.h"
#include "section/section_law.h"
#include "model/model.h"

namespace hinge {

/// A finite element of a member.
struct Element {
    int node[2];
    int member;
    int partner;    ///< the other element of its pair, -1 if it has none
    double length;  ///< m
    Vec3 chord;     ///< from node 1 to node 2 at the start, m
    double s;       ///< normal position of the integration point
    // shared by equal elements; stored in the structure
    const Quat& axes;  ///< local axes at the start (columns x y z)
    const beam::Rigidity& rigidity;
    const beam::Stiffness& stiffness;  ///< k(s)
    const beam::Inertia& inertia;      ///< entries of the mass matrix in local axes
    const beam::Inertia& lone;         ///< lumped, without its partner: what is left of them (state/lone_elements.h)
    const beam::YieldSurface& yield;   ///< fully plastic resultants
    const beam::SectionLaw* law;       ///< null: no section can yield
    double radius;                     ///< half the smaller side of the section, m
    bool forms_pairs;                  ///< SectionLaw::forms_pairs
    double mass() const { return beam::element_mass(rigidity, length); }
};

/// Kind of mass matrix. at_nodes: consistent, but the rotary inertia of the sections belongs to the nodes and rotates
/// with them.
enum class MassKind : std::uint8_t { consistent, lumped, at_nodes };

/// Axes x, y, z of a member's section where it runs along `span`, as a rotation from the global axes.
Quat axes_of(const MemberData& member, const Vec3& span);

/// Nodes and elements of a run. Nodes 0..declared-1 are the script's. Then come the ends of members that have a joint,
/// in the place of their node; the rest lie inside members, unless the script has named them (inner_nodes.h).
class Structure {
public:
    Structure(const Structure&) = delete;  // elements refer to it
    explicit Structure(std::shared_ptr<const Model> model, MassKind mass = MassKind::consistent);

    const Model& model() const { return *model_; }
    const std::shared_ptr<const Model>& share_model() const { return model_; }
    const std::vector<Vec3>& position() const { return position_; }    ///< m, at the start
    const std::vector<std::uint8_t>& fixed() const { return fixed_; }  ///< six bits a node
    /// Those, and the rotations of nodes that panels alone join.
    const std::vector<std::uint8_t>& held() const { return held_; }
    const std::vector<Element>& elements() const { return elements_; }
    /// Initial velocity of each node, m/s and rad/s: as declared; inside members interpolated if both ends were given
    /// one, else zero.
    std::vector<Vec6> initial_velocity() const;
    /// Whether there is neither an element nor a panel.
    bool is_empty() const { return elements_.empty() && in_panels_.empty(); }
    /// Elements at a node, in rising order.
    std::span<const int> elements_at(int node) const {
        return {&elements_of_nodes_[first_element_[node]],
                std::size_t(first_element_[node + 1] - first_element_[node])};
    }
    /// Whether nothing joins a node: no element, no panel, and no end of a member by a joint. A support that is fixed
    /// in all directions counts as such with joints too: nothing moves it.
    bool is_alone(int node) const { return elements_at(node).empty() && !hangs_on_joints(node) && !has_panels(node); }
    /// Whether a node of the script has joints alone, and can move: the ends of all its members are released.
    bool hangs_on_joints(int node) const { return node < int(on_joints_.size()) && on_joints_[node] != 0; }
    /// Whether panels join a node, and whether nothing else does: such a node has no rotation of its own.
    bool has_panels(int node) const { return node < int(in_panels_.size()) && in_panels_[node] != 0; }
    bool has_panels_alone(int node) const { return has_panels(node) && elements_at(node).empty(); }
    int free_dofs() const;
    bool can_yield() const { return can_yield_; }
    /// True if the law of a section calls functions of the script.
    bool laws_call_script() const { return laws_call_script_; }
    /// True if hinges may lose stiffness in unloading (SectionLaw::wears_stiffness).
    bool wears_stiffness() const { return wears_stiffness_; }
    /// Mass of an element for the kind of mass matrix, in local axes.
    const beam::Inertia& inertia(int element) const { return elements_[element].inertia; }
    bool lumped() const { return mass_ == MassKind::lumped; }
    bool at_nodes() const { return mass_ == MassKind::at_nodes; }
    bool cubic() const { return !lumped() && model_->options().mass == MassShape::cubic; }
    /// True if the bending of pairs depends on their axial force (beam/beam_column.h).
    bool p_delta() const {
        const ModelOptions& o = model_->options();
        return o.p_delta == PDelta::member && o.formulation == Formulation::asi_gauss && large() &&
               o.shift == Shift::plastic;
    }
    bool large() const { return model_->options().displacement == Displacement::large; }
    bool conventional() const { return model_->options().formulation == Formulation::conventional; }
    /// The node of a member's end (0, 1): the script's, or its own where it has a joint.
    int end_node(int member, int end) const;
    /// The node of a member between its elements, after so many of them: 1 to elements - 1.
    int inner_node(int member, int after) const;
    /// The script's node that a node belongs to: itself, that to which a joint joins it; -1 inside members.
    int declared_node(int node) const;
    /// Number of ends with a joint: their nodes follow the script's.
    int joints() const { return int(joined_.size()); }
    /// Where the history variables of an element's sections begin in State::history, and how many there are of all.
    std::size_t history_at(int element) const { return history_at_[element]; }
    std::size_t history_size() const { return history_at_.empty() ? 0 : history_at_.back(); }
    bool in_group(int element, int group) const;
    std::string node_name(int node) const;        ///< "node 12 at {8, 0, 4} m"
    std::string element_name(int element) const;  ///< "element 2 of member 31 (columns), nodes 4-9"

private:
    std::shared_ptr<const Model> model_;
    MassKind mass_;
    std::vector<Vec3> position_;
    std::vector<std::uint8_t> fixed_, held_;
    std::vector<Element> elements_;
    struct Kind {
        Quat axes;
        beam::Rigidity rigidity;
        beam::Stiffness stiffness;
        beam::Inertia inertia, lone;
        beam::YieldSurface yield;
        std::unique_ptr<const beam::SectionLaw> law;
    };
    struct KindKey;
    using KindMap = std::map<KindKey, const Kind*>;
    void add_joints();
    void add_panels();
    int add_inner_node(int index, int after);
    void add_member(int index, KindMap& alike);
    const Kind& kind_of(const MemberData& member, const Quat& rotation, double length, double s, int middle,
                        double part, KindMap& alike);
    void place_histories();
    beam::Inertia inertia_of(const beam::Rigidity& rigidity, double length, int middle, double part) const;
    std::deque<Kind> kinds_;
    std::vector<std::size_t> history_at_;       ///< of each element, and the size of all; empty where no law has any
    std::map<std::pair<int, int>, int> named_;  ///< nodes inside members that the script has named
    struct JoinedEnd {
        int member, end;
        auto operator<=>(const JoinedEnd&) const = default;
    };
    std::vector<JoinedEnd> joined_;                       ///< rising
    std::vector<char> in_panels_;                         ///< of each declared node; empty without panels
    std::vector<char> on_joints_;                         ///< of each declared node; empty where none hangs on joints
    std::vector<int> first_element_, elements_of_nodes_;  // elements of each node
    bool can_yield_ = false, laws_call_script_ = false, wears_stiffness_ = false;
};

/// The elements of a member: the first, and one past the last.
std::pair<int, int> elements_of(const Structure& structure, int member);

}  // namespace hinge
