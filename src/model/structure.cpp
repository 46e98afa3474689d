#include "model/structure.h"

#include <algorithm>
#include <bit>
#include <array>
#include <cmath>
#include <compare>
#include <map>

#include "core/errors.h"
#include "section/laws/laws.h"
#include "model/inner_nodes.h"
#include "model/member_ends.h"
#include "model/panel.h"
#include "model/section_laws.h"
#include "section/section_outline.h"
#include "section/shear.h"

namespace hinge {
namespace {

/// Where the point stands while the element is elastic (fig 3): in the middle (eq 7a) or at s_g = -r_g (eqs 11a-b and
/// 12a). `inner`: +1 when the pair's middle is at node 2.
double normal_point(Formulation f, int inner) { return f == Formulation::asi_gauss ? beam::gauss_point * inner : 0; }

bool is_omitted(const std::vector<OmittedLaw>& omitted, const std::string& name) {
    return std::ranges::any_of(omitted, [&](const OmittedLaw& law) { return law.name == name; });
}

/// What its material and its backbone add to the law of a member's section. `length`: of the part of an element that
/// yields with it, m.
beam::SectionMaterial material_of(const MemberData& member, const beam::YieldSurface& w, double length,
                                  const std::vector<OmittedLaw>& omitted) {
    const Section& s = *member.section;
    const Material& m = *member.material;
    beam::MaterialLaws laws = m.laws;
    if (member.backbone) laws.push_back(member.backbone);
    if (member.law) laws.push_back(member.law);
    std::erase_if(laws, [&](const auto& law) { return is_omitted(omitted, law->name()); });
    if (laws.empty()) return {};
    beam::PlasticZone zone;
    zone.energy = (w.n > 0 ? 1 / std::sqrt(w.n) : m.yield_stress * s.area) * length;
    zone.per_modulus = Vec4(w.x * s.Ix, w.y * s.Iy, w.n * s.area, w.z * s.J / 3) / length;
    return {std::move(laws), zone};
}

/// The law of a member's section, null where it cannot yield.
std::unique_ptr<const beam::SectionLaw> law_of(const MemberData& member, const beam::YieldSurface& w,
                                               const Model& model, double length) {
    if (member.carries != Carries::both)
        return beam::one_way_law(member.carries == Carries::tension ? 1 : -1,
                                 w.n > 0 ? 1 / std::sqrt(w.n) : std::numeric_limits<double>::infinity());
    if (w.elastic()) return nullptr;
    const Section& section = *member.section;
    const ModelOptions& options = model.options();
    const auto& omitted = model.declared<OmittedLaw>(omitted_laws);
    const auto strength = [](double inverse_square) { return 1 / std::sqrt(inverse_square); };
    const double zone = options.formulation == Formulation::conventional ? length : length / 2;
    beam::SectionMaterial adds = material_of(member, w, zone, omitted);
    if (section.outline && section.outline->concrete()) {  // its strengths are its own
        const auto domain = section.outline->domain();
        Vec4 of;
        of << domain->strength(), strength(w.z);
        return beam::exact_law(domain, of, std::move(adds));
    }
    const Interaction asked = section.interaction == Interaction::by_model ? options.interaction : section.interaction;
    const bool exact = is_exact(asked) != is_omitted(omitted, is_exact(asked) ? "exact" : "eq 14");
    if (!exact || !has_exact_law(section, w)) return beam::paper_law(w, std::move(adds));
    const auto shear = asked == Interaction::exact_with_shear ? shear_carried(section) : std::nullopt;
    return beam::exact_law(section.outline->domain(), {strength(w.x), strength(w.y), strength(w.n), strength(w.z)},
                           std::move(adds), shear ? &*shear : nullptr);
}

/// Half the smaller side of a section, m; where its sides are not given, that of the square of the same area.
double contact_radius(const Section& s) {
    return 0.5 * (s.width > 0 && s.depth > 0 ? std::min(s.width, s.depth) : std::sqrt(s.area));
}

/// The elements at each node, in rising order: those of node i are list[first[i]] to list[first[i + 1] - 1].
void list_elements_of_nodes(std::size_t nodes, const std::vector<Element>& elements, std::vector<int>& first,
                            std::vector<int>& list) {
    first.assign(nodes + 1, 0);
    for (const Element& e : elements)
        for (int node : e.node) ++first[node + 1];
    for (std::size_t i = 0; i + 1 < first.size(); ++i) first[i + 1] += first[i];
    list.resize(first.back());
    std::vector<int> next(first.begin(), first.end() - 1);
    for (std::size_t i = 0; i < elements.size(); ++i)
        for (int node : elements[i].node) list[next[node]++] = int(i);
}

}  // namespace

/// What alike elements have in common.
struct Structure::KindKey {
    const Section* section;
    const Material* material;
    const beam::MaterialLaw* backbone;
    const beam::MaterialLaw* law;
    double length, s;  ///< m; normal position of the integration point
    int middle;        ///< the end (0, 1) at the middle of the pair
    double part;       ///< lumped_part
    Carries carries;
    double line_mass;
    std::array<double, 4> rotation;
    auto operator<=>(const KindKey&) const = default;
};

Quat axes_of(const MemberData& member, const Vec3& span) {
    const Vec3 z = span.normalized(), x = member.up.cross(z).normalized(), y = z.cross(x);
    Mat3 axes;
    axes << x, y, z;
    return Quat(axes).normalized();
}

Structure::Structure(std::shared_ptr<const Model> model, MassKind mass) : model_(std::move(model)), mass_(mass) {
    const Model& m = *model_;
    std::size_t inner = 0, elements = 0;
    for (const MemberData& member : m.members()) inner += member.elements - 1, elements += member.elements;
    position_.reserve(m.nodes().size() + inner);
    fixed_.reserve(m.nodes().size() + inner);
    elements_.reserve(elements);
    for (const auto& n : m.nodes()) {
        position_.push_back(n.position);
        fixed_.push_back(n.fixed);
    }
    add_joints();
    for (const InnerNode& n : m.declared<InnerNode>(inner_nodes)) named_[{n.member, n.after}] = n.node;
    KindMap alike;
    for (std::size_t index = 0; index < m.members().size(); ++index) add_member(int(index), alike);
    place_histories();
    list_elements_of_nodes(position_.size(), elements_, first_element_, elements_of_nodes_);
    add_panels();
    held_ = fixed_;
    constexpr std::uint8_t rotations = 8 | 16 | 32;
    for (std::size_t n = 0; n < in_panels_.size(); ++n)
        if (has_panels_alone(int(n)) && !hangs_on_joints(int(n))) held_[n] |= rotations;
}

/// Nodes of panels. Where nothing else joins one it does not rotate: a plate in its plane resists no rotation.
void Structure::add_panels() {
    const auto& panels = model_->declared<Panel>(panels_effect);
    if (panels.empty()) return;
    in_panels_.assign(model_->nodes().size(), 0);
    for (const Panel& panel : panels)
        for (const int node : panel.nodes) in_panels_[node] = 1;
}

/// Ends of members that have a joint, or an offset: nodes of their own.
void Structure::add_joints() {
    for (std::size_t index = 0; index < model_->members().size(); ++index)
        for (int end : {0, 1}) {
            const MemberData& member = model_->members()[index];
            if (!member.has_joint(end)) continue;
            joined_.push_back({int(index), end});
            position_.push_back(end_position(*model_, int(index), end));
            fixed_.push_back(0);
        }
    if (joined_.empty()) return;
    std::vector<char> carried(model_->nodes().size(), 0), hangs = carried;
    for (const MemberData& member : model_->members())
        for (int end : {0, 1})
            if (!member.has_joint(end)) carried[member.node[end]] = 1;
    for (const JoinedEnd& end : joined_)
        if (const int node = model_->members()[end.member].node[end.end]; !carried[node] && fixed_[node] != 63)
            hangs[node] = 1;
    if (std::find(hangs.begin(), hangs.end(), 1) != hangs.end()) on_joints_ = std::move(hangs);
}

int Structure::end_node(int member, int end) const {
    const MemberData& data = model_->members()[member];
    if (!data.has_joint(end)) return data.node[end];
    const auto at = std::lower_bound(joined_.begin(), joined_.end(), JoinedEnd{member, end});
    return int(model_->nodes().size() + (at - joined_.begin()));
}

int Structure::inner_node(int member, int after) const {
    return elements_[elements_of(*this, member).first + after - 1].node[1];
}

int Structure::declared_node(int node) const {
    const int declared = int(model_->nodes().size());
    if (node < declared) return node;
    if (node >= declared + joints()) return -1;
    const JoinedEnd& end = joined_[node - declared];
    return model_->members()[end.member].node[end.end];
}

/// The node after so many elements of a member: a new one, or the script's.
int Structure::add_inner_node(int index, int after) {
    const MemberData& member = model_->members()[index];
    const Vec3 start = position_[end_node(index, 0)], span = position_[end_node(index, 1)] - start;
    Vec3 place = start + double(after) / member.elements * span;
    if (!member.is_straight()) place += member.offset(after);
    if (const auto named = named_.find({index, after}); named != named_.end()) {
        position_[named->second] = place;
        return named->second;
    }
    position_.push_back(place);
    fixed_.push_back(0);
    return int(position_.size()) - 1;
}

void Structure::add_member(int index, KindMap& alike) {
    const MemberData& member = model_->members()[index];
    const Vec3 span = position_[end_node(index, 1)] - position_[end_node(index, 0)];
    Quat rotation = axes_of(member, span);
    double length = span.norm() / member.elements;
    Vec3 part = span / member.elements;
    const double radius = contact_radius(*member.section);
    int left = end_node(index, 0);
    for (int i = 0; i < member.elements; ++i) {
        const bool first_of_pair = i % 2 == 0;
        int right = end_node(index, 1), partner = -1;
        if (i + 1 < member.elements) { right = add_inner_node(index, i + 1); }
        if (!member.is_straight()) {
            part = position_[right] - position_[left];
            length = part.norm(), rotation = axes_of(member, part);
        }
        if (member.elements % 2 == 0) partner = int(elements_.size()) + (first_of_pair ? 1 : -1);
        const double s = normal_point(model_->options().formulation, first_of_pair ? 1 : -1);
        const int middle = partner >= 0 && first_of_pair ? 1 : 0;
        const double lump = lumped() ? beam::lumped_part(i, member.elements) : 0.5;
        const Kind& kind = kind_of(member, rotation, length, s, middle, lump, alike);
        elements_.push_back({{left, right},
                             index,
                             partner,
                             length,
                             part,
                             s,
                             kind.axes,
                             kind.rigidity,
                             kind.stiffness,
                             kind.inertia,
                             kind.lone,
                             kind.yield,
                             kind.law.get(),
                             radius,
                             !kind.law || kind.law->forms_pairs()});
        left = right;
    }
}

const Structure::Kind& Structure::kind_of(const MemberData& member, const Quat& rotation, double length, double s,
                                          int middle, double part, KindMap& alike) {
    const Section& section = *member.section;
    const Material& material = *member.material;
    const KindKey key = {&section,
                         &material,
                         member.backbone.get(),
                         member.law.get(),
                         length,
                         s,
                         middle,
                         part,
                         member.carries,
                         member.line_mass,
                         {rotation.w(), rotation.x(), rotation.y(), rotation.z()}};
    const auto [at, fresh] = alike.try_emplace(key, nullptr);
    if (!fresh) return *at->second;
    beam::Rigidity rigidity = rigidity_of(section, material);
    rigidity.rhoA += member.line_mass;
    beam::YieldSurface strength =
        model_->options().plasticity ? yield_surface(section, material) : beam::YieldSurface{};
    if (member.carries != Carries::both) strength = {0, 0, strength.n, 0};
    can_yield_ |= !strength.elastic() || member.carries != Carries::both;
    kinds_.push_back({rotation, rigidity, beam::stiffness(rigidity, length, s),
                      inertia_of(rigidity, length, middle, part), beam::lone_inertia(rigidity, length, middle),
                      strength, law_of(member, strength, *model_, length)});
    const beam::SectionLaw* law = kinds_.back().law.get();
    laws_call_script_ |= law && law->calls_script();
    wears_stiffness_ |= law && law->wears_stiffness();
    at->second = &kinds_.back();
    return kinds_.back();
}

void Structure::place_histories() {
    const auto size_of = [](const Element& e) { return e.law ? std::size_t(e.law->history_size()) : 0; };
    if (std::all_of(elements_.begin(), elements_.end(), [&](const Element& e) { return size_of(e) == 0; })) return;
    std::size_t size = 0;
    for (const Element& e : elements_) {
        history_at_.push_back(size);
        size += size_of(e) * (conventional() ? 1 : 2);
    }
    history_at_.push_back(size);
}

/// Mass of an element. `middle`: its end (0, 1) at the middle of its pair; `part`: lumped_part.
beam::Inertia Structure::inertia_of(const beam::Rigidity& rigidity, double length, int middle, double part) const {
    if (lumped()) return beam::lumped_inertia(rigidity, length, part);
    const beam::Inertia m =
        cubic() ? beam::cubic_inertia(rigidity, length, middle) : beam::linear_inertia(rigidity, length);
    return at_nodes() ? m.with_rotary_at_nodes() : m;
}

std::vector<Vec6> Structure::initial_velocity() const {
    std::vector<Vec6> v = model_->velocities();
    v.reserve(position_.size());
    for (const JoinedEnd& end : joined_) {
        Vec6 of_end = v[model_->members()[end.member].node[end.end]];
        of_end.head<3>() += Vec3(of_end.tail<3>()).cross(offset_of(*model_, end.member, end.end));
        v.push_back(of_end);
    }
    v.resize(position_.size(), Vec6::Zero());
    for (std::size_t index = 0; index < model_->members().size(); ++index) {
        const MemberData& member = model_->members()[index];
        if (!model_->moves_as_a_whole(member)) continue;
        for (int i = 1; i < member.elements; ++i) {
            const double t = double(i) / member.elements;
            const int node = inner_node(int(index), i);
            const bool given = node < int(model_->nodes().size()) && model_->velocity_given()[node] >= 0;
            if (!given) v[node] = (1 - t) * v[member.node[0]] + t * v[member.node[1]];
        }
    }
    return v;
}

int Structure::free_dofs() const {
    int n = 0;
    for (std::size_t i = 0; i < fixed_.size(); ++i)
        if (!is_alone(int(i))) n += 6 - std::popcount(held_[i]);
    return n;
}

bool Structure::in_group(int element, int group) const {
    const auto& groups = model_->members()[elements_[element].member].groups;
    return std::find(groups.begin(), groups.end(), group) != groups.end();
}

std::string Structure::node_name(int node) const {
    char text[160];
    const Vec3& x = position_[node];
    const int declared = int(model_->nodes().size());
    if (node < declared)
        std::snprintf(text, sizeof text, "node %d at {%.4g, %.4g, %.4g} m", node + 1, x.x(), x.y(), x.z());
    else if (const int at = declared_node(node); at >= 0)
        std::snprintf(text, sizeof text, "end %s of member %d at node %d",
                      joined_[node - declared].end == 0 ? "a" : "b", joined_[node - declared].member + 1, at + 1);
    else
        std::snprintf(text, sizeof text, "inner node of member %d at {%.4g, %.4g, %.4g} m",
                      elements_[elements_at(node)[0]].member + 1, x.x(), x.y(), x.z());
    return text;
}

std::string Structure::element_name(int index) const {
    const Element& e = elements_[index];
    const auto& member = model_->members()[e.member];
    int first = index;
    while (first > 0 && elements_[first - 1].member == e.member) --first;
    std::string name = "element " + std::to_string(index - first + 1) + " of member " + std::to_string(e.member + 1);
    if (!member.groups.empty()) name += " (" + model_->groups()[member.groups[0]] + ")";
    return name + ", nodes " + std::to_string(member.node[0] + 1) + "-" + std::to_string(member.node[1] + 1);
}

std::pair<int, int> elements_of(const Structure& structure, int member) {
    const auto& all = structure.elements();
    const auto first = std::ranges::lower_bound(all, member, {}, &Element::member),
               end = std::ranges::upper_bound(first, all.end(), member, {}, &Element::member);
    return {int(first - all.begin()), int(end - all.begin())};
}

}  // namespace hinge
