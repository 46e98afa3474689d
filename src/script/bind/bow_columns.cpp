#include "script/bind/bow_columns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "effects/declared.h"
#include "effects/joints.h"
#include "model/structure.h"

namespace hinge::script {
namespace {

/// Largest sine of the angle between members in line, and between their axes: coordinates of files have four digits.
constexpr double in_line = 1e-3;

/// The end of a member at which another one goes on.
struct Next {
    int member, end;
    bool held;  ///< across the bow: another column begins there
};

class Lines {
public:
    Lines(const Model& model, const std::vector<int>& members, int axis, const std::vector<Vec3>& place)
        : model_(model), axis_(axis), place_(place), chosen_(model.members().size(), 0), at_(model.nodes().size()) {
        for (const int i : members) chosen_[std::size_t(i)] = 1;
        for (int i = 0; i < int(model.members().size()); ++i)
            for (const int end : {0, 1}) at_[std::size_t(node(i, end))].push_back({i, end});
        linked_.assign(at_.size(), 0);
        for (const NodeLink& link : node_links(model))
            for (const int n : {link.a, link.b})
                if (n >= 0) linked_[std::size_t(n)] = 1;
        hinged_.assign(2 * chosen_.size(), 0);
        for (const Joint& j : model.declared<Joint>(joints_effect))
            if (!j.is_between_nodes() && j.is.axis[1 - axis].is_free())
                hinged_[2 * std::size_t(j.member) + std::size_t(j.end)] = 1;
    }

    int node(int member, int end) const { return model_.members()[std::size_t(member)].node[end]; }
    const Vec3& place(int member, int end) const { return place_[std::size_t(node(member, end))]; }
    Vec3 span(int member) const { return place(member, 1) - place(member, 0); }
    /// Along which the member bows, in space.
    Vec3 direction(int member) const {
        return axes_of(model_.members()[std::size_t(member)], span(member)) * Vec3::Unit(axis_);
    }
    /// What goes on beyond an end of a member.
    std::optional<Next> next(int member, int end) const {
        const int at = node(member, end);
        if (hinged(member, end)) return {};
        const Vec3 outward = (end == 1 ? 1 : -1) * span(member).normalized(), across = direction(member);
        std::optional<Next> found;
        for (const auto& [other, its_end] : at_[std::size_t(at)]) {
            if (other == member || !chosen_[std::size_t(other)] || hinged(other, its_end)) continue;
            const Vec3 on = (its_end == 0 ? 1 : -1) * span(other).normalized();
            if (on.cross(outward).norm() > in_line || direction(other).cross(across).norm() > in_line) continue;
            if (found || on.dot(outward) < 0) return {};  // two members side by side
            found = Next{other, its_end, false};
        }
        if (found) found->held = holds(at, across);
        return found;
    }

private:
    bool hinged(int member, int end) const { return hinged_[2 * std::size_t(member) + std::size_t(end)] != 0; }
    bool holds(int at, const Vec3& across) const {
        if (at_[std::size_t(at)].size() > 2 || linked_[std::size_t(at)]) return true;
        for (int c = 0; c < 3; ++c)
            if (model_.nodes()[std::size_t(at)].fixed >> c & 1 && std::abs(across[c]) > in_line) return true;
        return false;
    }

    const Model& model_;
    const int axis_;
    const std::vector<Vec3>& place_;
    std::vector<char> chosen_, linked_, hinged_;
    std::vector<std::vector<std::array<int, 2>>> at_;  ///< members and their ends at each node
};

bool lower(const Vec3& a, const Vec3& b, double size) {
    for (const int c : {2, 0, 1})
        if (std::abs(a[c] - b[c]) > 1e-6 * size) return a[c] < b[c];
    return false;
}

/// A member of a line, with the end by which one comes to it from the lower end of the line.
struct OnLine {
    int member, from;
    bool begins;  ///< a column
};

/// The whole line of a member, from its lower end.
std::vector<OnLine> line_of(const Lines& lines, int member) {
    const auto walk = [&](int start, int from) {
        std::vector<OnLine> line{{start, from, true}};
        while (const std::optional<Next> next = lines.next(line.back().member, 1 - line.back().from)) {
            if (next->member == start) break;  // a ring of members that are in line does not exist in space
            line.push_back({next->member, next->end, next->held});
        }
        return line;
    };
    const OnLine one_end = walk(member, 0).back(), other = walk(member, 1).back();
    const auto end = [&](const OnLine& e) { return lines.place(e.member, 1 - e.from); };
    const OnLine& first = lower(end(one_end), end(other), lines.span(member).norm()) ? one_end : other;
    return walk(first.member, 1 - first.from);
}

}  // namespace

std::vector<BowedColumn> bowed_columns(const Model& model, const std::vector<int>& members, int axis, bool opposite,
                                       const std::vector<Vec3>& place) {
    const Lines lines(model, members, axis, place);
    std::vector<BowedColumn> columns;
    std::vector<char> seen(model.members().size(), 0);
    for (const int i : members) {
        if (seen[std::size_t(i)]) continue;
        const std::size_t before = columns.size();
        double at = 0;
        for (const OnLine& part : line_of(lines, i)) {
            seen[std::size_t(part.member)] = 1;
            if (part.begins) {
                const Vec3 own = lines.direction(part.member);
                const bool first = columns.size() == before;
                columns.push_back({{}, 0, opposite && !first ? Vec3(-columns.back().direction) : own});
                at = 0;
            }
            BowedColumn& column = columns.back();
            const double length = lines.span(part.member).norm(), begin = at, end = at + length;
            column.parts.push_back({part.member, part.from == 0 ? begin : end, part.from == 0 ? end : begin});
            column.length = at = end;
        }
    }
    for (BowedColumn& column : columns)
        for (ColumnPart& part : column.parts) part.begin /= column.length, part.end /= column.length;
    return columns;
}

}  // namespace hinge::script
