#include "algebra/reduction.h"

#include <algorithm>
#include <numeric>

#include "core/errors.h"

namespace hinge {
namespace {

const char* const component_names[] = {"ux", "uy", "uz", "rx", "ry", "rz"};

/// Names of all that moves a component of a dependent node.
std::string needed_supports(const Reduction::Dependent& d, int component) {
    std::string names;
    for (int c = 0; c < 6; ++c)
        if (!d.parts.empty() && d.parts[0].factors(component, c) != 0)
            names += (names.empty() ? "" : ", ") + std::string(component_names[c]);
    return names;
}

}  // namespace

Reduction::Reduction(const Structure& structure, const std::vector<std::uint8_t>& held,
                     const std::vector<LinearConstraint>& constraints)
    : structure_(&structure), which_(structure.position().size(), -1) {
    for (const LinearConstraint& c : constraints) {
        int& at = which_[c.dependent.node];
        if (at < 0) at = int(dependents_.size()), dependents_.push_back({c.dependent.node, 0, {}, c.declared_by});
        Dependent& d = dependents_[at];
        if (d.tied >> c.dependent.component & 1)
            throw InputError(c.declared_by + (": " + std::string(component_names[c.dependent.component])) + " of " +
                             structure.node_name(d.node) + " already depends on another node");
        d.tied |= std::uint8_t(1 << c.dependent.component);
    }
    for (const LinearConstraint& c : constraints)
        for (const LinearConstraint::Term& term : c.terms)
            if (tied(term.of.node) >> term.of.component & 1)
                throw InputError(c.declared_by + (": " + structure.node_name(c.dependent.node)) + " depends on " +
                                 structure.node_name(term.of.node) +
                                 ", which depends on another node itself; let both depend on that one");
    renew(constraints);
    refuse_held(held);
    find_groups();
}

void Reduction::refuse_held(const std::vector<std::uint8_t>& held) const {
    for (const Dependent& d : dependents_)
        for (int c = 0; c < 6; ++c)
            if (d.tied & held[d.node] & (1 << c))
                throw InputError(d.declared_by + (": " + std::string(component_names[c])) + " of " +
                                 structure_->node_name(d.node) + " depends on " +
                                 structure_->node_name(d.parts[0].node) +
                                 " and is held by a support, while that node is free to move it: hold " +
                                 needed_supports(d, c) + " of that node as well, or let it depend on this one");
}

void Reduction::renew(const std::vector<LinearConstraint>& constraints) {
    for (Dependent& d : dependents_) d.parts.clear();
    for (const LinearConstraint& c : constraints) {
        std::vector<Part>& parts = dependents_[which_[c.dependent.node]].parts;
        for (const LinearConstraint::Term& term : c.terms) {
            auto part = std::find_if(parts.begin(), parts.end(), [&](const Part& p) { return p.node == term.of.node; });
            if (part == parts.end()) part = parts.insert(part, {term.of.node, Mat6::Zero()});
            part->factors(c.dependent.component, term.of.component) += term.factor;
        }
    }
}

void Reduction::find_groups() {
    std::vector<int> first(which_.size());  // of the nodes that are joined with each, the lowest known
    std::iota(first.begin(), first.end(), 0);
    const auto lowest = [&](int node) {
        while (first[node] != node) node = first[node];
        return node;
    };
    joins_.assign(which_.size(), 0);
    for (const Dependent& d : dependents_)
        for (const Part& p : d.parts) {
            joins_[d.node] = joins_[p.node] = 1;
            const int a = lowest(d.node), b = lowest(p.node);
            first[std::max(a, b)] = std::min(a, b);
        }
    std::vector<int> group(which_.size(), -1);
    for (int node = 0; node < int(which_.size()); ++node) {
        if (!joins_[node]) continue;
        int& at = group[lowest(node)];
        if (at < 0) at = int(groups_.size()), groups_.emplace_back();
        groups_[at].push_back(node);
    }
}

void Reduction::reduce(std::vector<Vec6>& f) const {
    for (const Dependent& d : dependents_) {
        for (const Part& p : d.parts) f[p.node] += p.factors.transpose() * f[d.node];
        for (int c = 0; c < 6; ++c)
            if (d.tied >> c & 1) f[d.node][c] = 0;
    }
}

void Reduction::expand(std::vector<Vec6>& u) const {
    for (const Dependent& d : dependents_) {
        Vec6 sum = Vec6::Zero();
        for (const Part& p : d.parts) sum += p.factors * u[p.node];
        for (int c = 0; c < 6; ++c)
            if (d.tied >> c & 1) u[d.node][c] = sum[c];
    }
}

/// Free components that determine the node's motion: its own free components, and those on which the others depend.
Reduction::Parts Reduction::parts_of(int node) const {
    Parts parts{{node, Mat6::Identity()}};
    if (!depends(node)) return parts;
    const Dependent& d = dependents_[which_[node]];
    for (int c = 0; c < 6; ++c)
        if (d.tied >> c & 1) parts[0].factors(c, c) = 0;
    parts.insert(parts.end(), d.parts.begin(), d.parts.end());
    return parts;
}

}  // namespace hinge
