#include "model/model.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "section/material_law.h"
#include "section/section_outline.h"
#include "core/errors.h"
#include "core/text.h"
#include "section/laws/laws.h"
#include "model/structure.h"

namespace hinge {

/// Of the elastic rotation at yield: wear of the stiffness below it would make more rotation elastic than a step has.
constexpr double least_wear = 5;

void must_be_finite(const Vec3& v, const char* what, const char* unit) {
    if (!v.allFinite())
        throw InputError(std::string(what) + " is " + vector_text(v) + " " + unit + "; all three must be finite");
}

Model::Model(ModelOptions options) : options_(options) {}

int Model::add_node(const Vec3& position) {
    check_open();
    must_be_finite(position, "position", "m");
    nodes_.push_back({position, 0});
    velocities_.push_back(Vec6::Zero());
    velocity_given_.push_back(-1);
    return int(nodes_.size()) - 1;
}

void Model::fix(int node, std::uint8_t mask) { check_open(), nodes_[node].fixed |= mask; }

const char* carries_word(Carries carries) {
    return carries == Carries::both ? "both" : carries == Carries::tension ? "tension" : "compression";
}

void Model::check_member(const MemberData& m) const {
    if (m.node[0] == m.node[1])
        throw InputError("member joins node " + std::to_string(m.node[0] + 1) +
                         " to itself; its two nodes must differ");
    const Vec3 chord = nodes_[m.node[1]].position - nodes_[m.node[0]].position;
    const double length = chord.norm();
    const double scale =
        std::max(nodes_[m.node[0]].position.cwiseAbs().maxCoeff(), nodes_[m.node[1]].position.cwiseAbs().maxCoeff());
    if (!(length > 1e-9 * std::max(scale, 1e-3)))
        throw InputError("member has length " + number_text(length) + " m: nodes " + std::to_string(m.node[0] + 1) +
                         " and " + std::to_string(m.node[1] + 1) + " are both at " +
                         vector_text(nodes_[m.node[0]].position) + " m; a member needs a length above 0 m");
    if (options_.formulation == Formulation::asi_gauss && m.elements % 2 != 0)
        throw InputError(
            "elements per member is " + std::to_string(m.elements) +
            "; formulation 'asi-gauss' places its points in pairs of elements and needs an even number (2, 4, ...)");
    if (m.section->outline && m.section->outline->concrete() && std::isfinite(m.material->yield_stress))
        throw InputError(
            "member has a section of concrete, which has its own strengths, and a material with a yield "
            "stress of " +
            number_text(m.material->yield_stress) +
            " Pa; give a material without yield_stress, such as hinge.material.concrete 'C30/37'");
    must_be_finite(m.up, "up", "");
    if (!m.is_moved && m.up.cross(chord).norm() <= 1e-6 * m.up.norm() * length)
        throw InputError("up is " + vector_text(m.up) + ", parallel to the member (" + vector_text(chord) +
                         " m); it gives the direction of the section's y axis and must point across the member");
    if (m.carries != Carries::both && !m.material->laws.empty())
        throw InputError(std::string("carries is '") + carries_word(m.carries) + "', and its material has " +
                         m.material->laws[0]->name() +
                         "; a member that carries axial force of one sign yields at a constant force: give it a "
                         "material without hardening and rate");
    if (const auto* backbone = m.backbone ? beam::backbone_of(*m.backbone) : nullptr;
        backbone && !backbone->interaction.empty()) {
        const Interaction has =
            m.section->interaction == Interaction::by_model ? options_.interaction : m.section->interaction;
        if (backbone->interaction != (is_exact(has) ? "exact" : "paper"))
            throw InputError(
                "backbone is made for interaction '" + backbone->interaction + "' of N and M, and the " +
                (m.section->interaction == Interaction::by_model ? "model" : "section") + " has '" + word_of(has) +
                "'; its strengths beside an axial force would be wrong: give the same interaction to both");
    }
    if (const auto* backbone = m.backbone ? beam::backbone_of(*m.backbone) : nullptr;
        backbone && backbone->wears_stiffness) {
        const beam::YieldSurface strength = yield_surface(*m.section, *m.material);
        double at_yield = 0;  // rotation of an end in double curvature, rad
        for (const auto& [w, I] : {std::pair(strength.x, m.section->Ix), std::pair(strength.y, m.section->Iy)})
            if (w > 0)
                at_yield = std::max(
                    at_yield, backbone->points.front().strength * length / (6 * m.material->E * I * std::sqrt(w)));
        if (backbone->wear < least_wear * at_yield)
            throw InputError("backbone wears the stiffness with wear = " + number_text(backbone->wear) +
                             " rad; about its weaker axis the member's end turns by " + number_text(at_yield) +
                             " rad before it yields, and wear must be " + number_text(least_wear) +
                             " times that or more: else it would give back more work than was done on it");
    }
    if (m.carries != Carries::both && (m.backbone || m.law))
        throw InputError(std::string("carries is '") + carries_word(m.carries) + "', and a " +
                         (m.law ? "law" : "backbone") +
                         " is given; such a member has no hinges at its ends: leave one of the two out");
}

int Model::add_member(MemberData m) {
    check_open();
    check_member(m);
    members_.push_back(std::move(m));
    return int(members_.size()) - 1;
}

void Model::set_member_groups(int member, std::vector<int> groups) {
    check_open(), members_[member].groups = std::move(groups);
}

void Model::add_line_mass(int member, double per_length) { check_open(), members_[member].line_mass += per_length; }

void Model::displace(int node, const Vec3& by) { check_open(), nodes_[node].position += by; }
void Model::add_bow(int member, const Vec3& bow) { check_open(), members_[member].bow += bow; }

void Model::add_offsets(int member, const std::vector<Vec3>& inner) {
    check_open();
    std::vector<Vec3>& own = members_[member].inner;
    if (own.empty()) own.assign(inner.size(), Vec3::Zero());
    for (std::size_t i = 0; i < inner.size(); ++i) own[i] += inner[i];
}

double MemberData::mass_per_length() const { return section->area * material->density + line_mass; }

Vec3 MemberData::offset(int after) const {
    const auto on_curve = [this](int i) -> Vec3 {
        if (i == 0 || i == elements) return Vec3::Zero();
        const Vec3 wave = std::sin(std::numbers::pi * i / elements) * bow;
        return inner.empty() ? wave : wave + inner[std::size_t(i) - 1];
    };
    const bool inside_pair = elements % 2 == 0 && after % 2 == 1;
    return inside_pair ? 0.5 * (on_curve(after - 1) + on_curve(after + 1)) : on_curve(after);
}

bool Model::has_undecided_elements() const {
    return std::any_of(members_.begin(), members_.end(),
                       [](const MemberData& m) { return m.elements_by == ElementsBy::undecided; });
}

void Model::set_elements(int member, int elements, ElementsBy by, double part, bool capped) {
    MemberData& m = members_[member];
    m.elements = elements, m.elements_by = by, m.elements_part = part, m.elements_capped = capped;
}

void Model::take_elements(const Model& decided) {
    for (std::size_t i = 0; i < std::min(members_.size(), decided.members_.size()); ++i) {
        const MemberData& d = decided.members_[i];
        if (members_[i].elements_by == ElementsBy::undecided)
            set_elements(int(i), d.elements, d.elements_by, d.elements_part, d.elements_capped);
    }
}

void Model::set_velocity(int node, const Vec3& linear, const Vec3& angular) {
    set_velocities({{node}, linear, angular});
}

void Model::set_velocities(GivenVelocity given) {
    check_open();
    must_be_finite(given.linear, "velocity", "m/s");
    must_be_finite(given.angular, "angular velocity", "rad/s");
    Vec3 centre = Vec3::Zero();
    for (int n : given.nodes) centre += nodes_[n].position / double(given.nodes.size());
    for (int n : given.nodes) {
        velocities_[n] << given.linear + given.angular.cross(nodes_[n].position - centre), given.angular;
        velocity_given_[n] = int(given_velocities_.size());
    }
    given_velocities_.push_back(std::move(given));
}

void Model::refuse_velocities(const MemberData& member) const {
    for (const GivenVelocity& v : given_velocities_) {
        if (v.group < 0 || v.angular.isZero(0) ||
            std::find(member.groups.begin(), member.groups.end(), v.group) == member.groups.end())
            continue;
        for (const int n : member.node)
            if (std::find(v.nodes.begin(), v.nodes.end(), n) == v.nodes.end())
                throw InputError("group '" + groups_[v.group] + "' has an angular velocity, given at " + v.asked_at +
                                 ", about the mean position of the joints that it had there; a member that brings a "
                                 "joint would move it: add the members first, then give the velocity");
    }
}

void Model::join_velocities(int member) {
    check_open();
    const MemberData& m = members_[member];
    for (std::size_t i = 0; i < given_velocities_.size(); ++i) {
        GivenVelocity& v = given_velocities_[i];
        if (v.group < 0 || std::find(m.groups.begin(), m.groups.end(), v.group) == m.groups.end()) continue;
        for (const int n : m.node) {
            if (velocity_given_[n] >= int(i) || !v.angular.isZero(0)) continue;
            v.nodes.push_back(n);
            velocities_[n] << v.linear, v.angular;
            velocity_given_[n] = int(i);
        }
    }
}

void Model::set_options(const ModelOptions& options) { check_open(), options_ = options; }

int Model::group(const std::string& name) {
    const int found = find_group(name);
    if (found >= 0) return found;
    check_open();
    groups_.push_back(name);
    return int(groups_.size()) - 1;
}

int Model::find_group(const std::string& name) const {
    const auto at = std::find(groups_.begin(), groups_.end(), name);
    return at == groups_.end() ? -1 : int(at - groups_.begin());
}

std::vector<int> Model::nodes_of_group(int group) const {
    std::vector<int> nodes;
    for (const auto& m : members_)
        if (std::find(m.groups.begin(), m.groups.end(), group) != m.groups.end())
            nodes.insert(nodes.end(), {m.node[0], m.node[1]});
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

}  // namespace hinge
