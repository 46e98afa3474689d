#include "model/model.h"

#include <algorithm>
#include <cmath>

#include "core/errors.h"
#include "core/text.h"

namespace hinge {
namespace {

void must_be_finite(const Vec3& v, const char* what, const char* unit) {
    if (!v.allFinite())
        throw InputError(std::string(what) + " is " + vector_text(v) + " " + unit + "; all three must be finite");
}

bool is_function(const FractureRule& r) { return r.hook || r.batch; }

/// Of two rules for the same members the later one holds. Refuses one that would so take the place of another without a
/// word: limits that of a function, and a group's that of a group within it.
void refuse_replacing(const Model& model, const FractureRule& rule) {
    const auto at = [](const FractureRule& r) { return r.asked_at.empty() ? "" : " of " + r.asked_at; };
    const auto name = [&](const FractureRule& r) { return "'" + model.groups()[r.group] + "'"; };
    const std::vector<FractureRule>& rules = model.fracture();
    const auto same =
        std::find_if(rules.rbegin(), rules.rend(), [&](const FractureRule& r) { return r.group == rule.group; });
    if (same != rules.rend() && is_function(*same) && !is_function(rule))
        throw InputError(std::string("model:fracture: this would replace the function") + at(*same) + " for " +
                         (rule.group < 0 ? "all members" : "the members of group " + name(rule)) +
                         "; where both are meant to hold, give the limits and the function in one call");
    if (rule.group < 0) return;  // those of groups hold beside it
    std::vector<int> members(model.groups().size(), 0), shared = members;
    for (const MemberData& m : model.members()) {
        const bool meant = std::find(m.groups.begin(), m.groups.end(), rule.group) != m.groups.end();
        for (int g : m.groups) ++members[g], shared[g] += meant;
    }
    for (const FractureRule& r : rules)
        if (r.group >= 0 && r.group != rule.group && members[r.group] > 0 && shared[r.group] == members[r.group])
            throw InputError("model:fracture: group " + name(rule) + " has all members of group " + name(r) +
                             ", so this would replace the rule" + at(r) +
                             " for all of them; declare the rule for group " + name(r) + " after this one");
}

}  // namespace

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

int Model::add_member(MemberData m) {
    check_open();
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
    must_be_finite(m.up, "up", "");
    if (m.up.cross(chord).norm() <= 1e-6 * m.up.norm() * length)
        throw InputError("up is " + vector_text(m.up) + ", parallel to the member (" + vector_text(chord) +
                         " m); it gives the direction of the section's y axis and must point across the member");
    members_.push_back(std::move(m));
    return int(members_.size()) - 1;
}

void Model::set_member_groups(int member, std::vector<int> groups) {
    check_open(), members_[member].groups = std::move(groups);
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

int Model::add_load(NodalLoad load) {
    check_open();
    must_be_finite(load.force, "force", "N");
    must_be_finite(load.moment, "moment", "N m");
    load.number = next_load_++;
    loads_.push_back(std::move(load));
    return load.number;
}

const NodalLoad* Model::find_load(int number) const {
    const auto at =
        std::lower_bound(loads_.begin(), loads_.end(), number, [](const NodalLoad& l, int n) { return l.number < n; });
    return at != loads_.end() && at->number == number ? &*at : nullptr;
}

void Model::remove_load(int number) {
    check_open();
    if (const NodalLoad* load = find_load(number)) loads_.erase(loads_.begin() + (load - loads_.data()));
}

void Model::set_gravity(const Vec3& g, int load_case) {
    check_open();
    must_be_finite(g, "gravity", "m/s^2");
    gravity_ = g;
    gravity_case_ = load_case;
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

int Model::add_case(const std::string& name) {
    check_open();
    cases_.push_back(name);
    return int(cases_.size()) - 1;
}

int Model::find_case(const std::string& name) const {
    const auto at = std::find(cases_.begin(), cases_.end(), name);
    return at == cases_.end() ? -1 : int(at - cases_.begin());
}

void Model::add_combination(LoadCombination combination) {
    check_open(), combinations_.push_back(std::move(combination));
}

const LoadCombination* Model::find_combination(const std::string& name) const {
    const auto at =
        std::find_if(combinations_.begin(), combinations_.end(), [&](const auto& c) { return c.name == name; });
    return at == combinations_.end() ? nullptr : &*at;
}

void NodalLoad::times(double factor) {
    force *= factor, moment *= factor;
    for (auto* rule : {&force_rule, &moment_rule})
        if (*rule) *rule = [factor, rule = *rule](double t) { return Vec3(factor * rule(t)); };
}

void Model::choose(const LoadChoice& choice) {
    if (cases_.empty() && !choice.is_static) return;
    const Model* from = cases_.empty() ? nullptr : choice.from;
    const auto acted = [&](double held, double whole) { return held + choice.reached * (whole - held); };
    ChosenLoads chosen{choice, std::vector<double>(cases_.size(), 0.0)};
    const bool holds = choice.is_static && from;
    if (holds) {
        for (std::size_t i = 0; i < from->case_factors_.size(); ++i)
            chosen.held[i] = acted(from->holds_loads() ? from->held_factors_[i] : 0, from->case_factors_[i]);
        chosen.held_permanent = acted(from->held_permanent_, 1);
    }
    set_aside_ = choose_loads(loads_, holds ? &from->loads_ : nullptr, chosen);
    for (auto& [effect, what] : declared_) {
        const auto before = holds ? from->declared_.find(effect) : declared_.end();
        set_aside_ += what->choose(holds && before != from->declared_.end() ? before->second.get() : nullptr, chosen);
    }
    if (cases_.empty()) return;
    case_factors_ = choice.factor;
    if (holds) {
        held_factors_ = chosen.held;
        held_permanent_ = chosen.held_permanent;
        if (from->gravity_)
            held_gravity_ = from->held_gravity_ + choice.reached * (*from->gravity_ - from->held_gravity_);
    }
    if (!gravity_ || gravity_case_ < 0) return;
    const double factor = choice.factor[gravity_case_];
    if (factor == 0 && held_gravity_.isZero(0)) gravity_.reset();
    else if (factor != 1) *gravity_ *= factor;
}

void Model::add_fracture(FractureRule rule) {
    check_open();
    if (options_.mass == MassShape::cubic)
        throw InputError(
            "model:fracture: a model with mass = 'cubic' cannot break, for half a pair of elements has no shape of its "
            "own; declare it with mass = 'linear'");
    refuse_replacing(*this, rule);
    fracture_.push_back(std::move(rule));
}

void Model::add_contact(ContactRule rule) { check_open(), contact_.push_back(std::move(rule)); }
void Model::add_motion(SupportMotion motion) {
    fix(motion.node, 1 << motion.component), motions_.push_back(std::move(motion));
}

void Model::undeclare(const std::string& effect) { check_open(), declared_.erase(effect); }
void Model::set_options(const ModelOptions& options) { check_open(), options_ = options; }
void Model::remove_gravity() { check_open(), gravity_.reset(), held_gravity_.setZero(); }
void Model::remove_fracture() { check_open(), fracture_.clear(); }
void Model::set_contact(std::vector<ContactRule> rules) { check_open(), contact_ = std::move(rules); }

void Model::check_open() const {
    if (locked_)
        throw InputError(
            "the model cannot be changed while a run of it is inside a step; change it between steps, or before the "
            "run is made");
}

namespace {

bool in_any(const MemberData& member, const std::vector<int>& groups) {
    return std::any_of(groups.begin(), groups.end(), [&](int g) {
        return std::find(member.groups.begin(), member.groups.end(), g) != member.groups.end();
    });
}

}  // namespace

int Model::contact_rule(int a, int b) const {
    const MemberData &first = members_[a], &second = members_[b];
    int general = -1;
    for (int i = int(contact_.size()) - 1; i >= 0; --i) {
        const std::vector<int>& groups = contact_[i].groups;
        if (groups.empty()) {
            general = std::max(general, i);
            continue;
        }
        const auto across = [&](const MemberData& p, const MemberData& q) {
            return in_any(p, {groups[0]}) && in_any(q, {groups[1]});
        };
        if (contact_[i].between ? across(first, second) || across(second, first)
                                : in_any(first, groups) && in_any(second, groups))
            return i;
    }
    return general;
}

bool Model::can_collide(int member) const {
    return std::any_of(contact_.begin(), contact_.end(),
                       [&](const ContactRule& r) { return r.groups.empty() || in_any(members_[member], r.groups); });
}

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
