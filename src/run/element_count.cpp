#include "run/element_count.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "core/text.h"
#include "effects/declared.h"
#include "run/linear_solution.h"

namespace hinge {
namespace {

constexpr int most_elements = 16;
/// In the solution. With weight = "nodes" the moment at a clamped end is 37 % too small with two elements, 9 % with
/// four. That of loads on members is exact, and is looked at in eighths of the length.
constexpr int of_heavy_members = 4, of_loaded_members = 8;

/// The critical load of a pinned member of 2, 4, 8, 16 elements over Euler's, where the axial force acts on the chord;
/// measured by tests/script/model/element_count_test.lua.
constexpr double critical_load[] = {2.269, 1.102, 1.024, 1.006};

struct Count {
    int elements = 2;
    bool capped = false;
};

/// `part`: compression over Euler's load.
Count for_compression(const ModelOptions& o, double part) {
    if (o.displacement == Displacement::small) return {};
    if (o.p_delta == PDelta::member) return {part < 1 ? 2 : 4};
    Count count;
    for (const double critical : critical_load) {
        if (part * (1 - 1 / critical) <= o.elements_accuracy) return count;
        count.elements *= 2;
    }
    return {most_elements, true};
}

/// The shares of N and of the two moments in f_y (eq 14).
struct Shares {
    double axial, bending;
    Shares(const SectionForces& f, const beam::YieldSurface& w)
        : axial(w.n * f.N * f.N), bending(w.x * f.Mx * f.Mx + w.y * f.My * f.My) {}
    /// The moment over the one that yields beside N; 0 where N yields alone, which makes no hinge.
    double moment() const { return axial < 1 ? std::sqrt(bending / (1 - axial)) : 0; }
};

/// A section of a member by the linear solution, at xi of its length.
struct Cut {
    double xi;
    SectionForces forces;
};

/// The largest moment over the plastic one: with loads of its own anywhere, else between the ends.
double largest_moment(const std::vector<Cut>& sections, const beam::YieldSurface& w, bool loaded, double compression) {
    double largest = 0;
    if (loaded)
        for (const Cut& s : sections) largest = std::max(largest, Shares(s.forces, w).moment());
    // what the ends cannot carry beyond their plastic moments goes to what is between them
    Eigen::Vector2d beyond[2];
    for (int end : {0, 1}) {
        const SectionForces& f = end == 0 ? sections.front().forces : sections.back().forces;
        const double m = Shares(f, w).moment();
        beyond[end] = (m > 1 ? 1 - 1 / m : 0) * Eigen::Vector2d(f.Mx, f.My);
    }
    const double grown = compression < 1 ? 1 / (1 - compression) : 1;
    for (const Cut& s : sections) {
        if (s.xi <= 0 || s.xi >= 1) continue;
        const Eigen::Vector2d m =
            grown * (Eigen::Vector2d(s.forces.Mx, s.forces.My) - (1 - s.xi) * beyond[0] - s.xi * beyond[1]);
        SectionForces f = s.forces;
        f.Mx = m.x(), f.My = m.y();
        largest = std::max(largest, Shares(f, w).moment());
    }
    return largest;
}

}  // namespace

void decide_elements(Model& model) {
    if (!model.has_undecided_elements()) return;
    Model linear = model;
    const bool gravity = declared_gravity(model).has_value();
    std::set<int> loaded;
    for (const DeclaredLoad& load : declared_loads(model))
        if (load.member >= 0) loaded.insert(load.member);
    for (int i = 0; i < int(model.members().size()); ++i)
        if (const MemberData& m = model.members()[i]; m.elements_by == ElementsBy::undecided)
            linear.set_elements(i,
                                loaded.count(i) > 0 ? of_loaded_members
                                : gravity           ? of_heavy_members
                                                    : 2,
                                m.elements_by, 0, false);
    const LinearSolution solution = solve_linearly(linear);
    if (!solution.run) {
        for (int i = 0; i < int(model.members().size()); ++i)
            if (model.members()[i].elements_by == ElementsBy::undecided)
                model.set_elements(i, 2, ElementsBy::no_solution, 0, false);
        return;
    }

    const auto& elements = solution.run->structure().elements();
    for (int first = 0, end; first < int(elements.size()); first = end) {
        const int index = elements[first].member;
        for (end = first; end < int(elements.size()) && elements[end].member == index;) ++end;
        const MemberData& m = model.members()[index];
        if (m.elements_by != ElementsBy::undecided) continue;
        if (!solution.solved[m.node[0]]) {
            model.set_elements(index, 2, ElementsBy::no_solution, 0, false);
            continue;
        }
        const double euler = euler_load(elements[first].rigidity, elements[first].length * (end - first));
        std::vector<Cut> sections;
        double compression = 0;
        for (int i = first; i < end; ++i)
            for (const double side : {-1.0, 1.0}) {
                sections.push_back(
                    {(i - first + (side + 1) / 2) / (end - first), solution.run->section_forces(i, side)});
                compression = std::max(compression, -sections.back().forces.N / euler);
            }
        const Count count = for_compression(model.options(), compression);
        double moment = 0;
        if (model.options().plasticity) {
            const bool grows = model.options().displacement == Displacement::large;
            moment = largest_moment(sections, yield_surface(*m.section, *m.material), loaded.count(index) > 0,
                                    grows ? compression : 0);
        }
        if (count.elements > 2)
            model.set_elements(index, count.elements, ElementsBy::compression, compression, count.capped);
        else if (moment >= 1) model.set_elements(index, 4, ElementsBy::yield, moment, false);
        else model.set_elements(index, 2, ElementsBy::neither, compression, false);
    }
}

std::vector<ElementGroup> element_groups(const Model& model) {
    struct Members {
        int count = 0, worst = -1;
    };
    std::map<std::tuple<int, ElementsBy, bool>, Members> found;  // the most elements first
    for (int i = 0; i < int(model.members().size()); ++i) {
        const MemberData& m = model.members()[i];
        if (m.elements_by == ElementsBy::script) continue;
        Members& of = found[{-m.elements, m.elements_by, m.elements_capped}];
        ++of.count;
        if (of.worst < 0 || m.elements_part > model.members()[of.worst].elements_part) of.worst = i;
    }
    std::vector<ElementGroup> list;
    for (const auto& [key, of] : found) {
        const auto [elements, by, capped] = key;
        const MemberData& worst = model.members()[of.worst];
        const std::string part = number_text(worst.elements_part, 3),
                          name = "member " + std::to_string(of.worst + 1) +
                                 (worst.groups.empty() ? "" : " (" + model.groups()[worst.groups[0]] + ")");
        std::string because;
        switch (by) {
            case ElementsBy::compression:
                because = "compressed by up to " + part + " of Euler's load, " + name;
                if (capped)
                    because += "; " + std::to_string(most_elements) +
                               " is the most that \"auto\" gives, and elements_accuracy is not reached";
                break;
            case ElementsBy::yield:
                because =
                    "moments up to " + part + " times the fully plastic one under loads or between the ends, " + name;
                break;
            case ElementsBy::no_solution:
                because = "supports do not hold the body, so it has no static solution to decide by";
                break;
            case ElementsBy::undecided: because = "not decided yet"; break;
            default:
                because = model.options().displacement == Displacement::small
                              ? "no yield between the ends; compression does not bend in small displacement"
                              : "no yield between the ends, compressed by at most " + part + " of Euler's load";
        }
        list.push_back({-elements, of.count, because});
    }
    return list;
}

}  // namespace hinge
