#include "record/storeys.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "effects/declared.h"

namespace hinge {
namespace {

constexpr double level = 0.02;            // rise over run: less is a level member
constexpr double least_height = 0.5;      // m, between floors
constexpr double above_floor = 0.05;      // m: a member so little above a floor still belongs to it
constexpr std::size_t most_floors = 200;  // more is no building

/// What hangs together: the root of each node, by members and connectors.
class ConnectedNodes {
public:
    explicit ConnectedNodes(const Model& model) : root_(model.nodes().size()) {
        std::iota(root_.begin(), root_.end(), 0);
        for (const MemberData& m : model.members()) root_[std::size_t(of(m.node[0]))] = of(m.node[1]);
        for (const NodeLink& link : node_links(model))
            if (link.a >= 0) root_[std::size_t(of(link.a))] = of(link.b);
    }
    int of(int node) {
        auto& up = root_;
        while (up[std::size_t(node)] != node) node = up[std::size_t(node)] = up[std::size_t(up[std::size_t(node)])];
        return node;
    }

private:
    std::vector<int> root_;
};

}  // namespace

std::vector<int> storeys_of(const Structure& structure) {
    const Model& model = structure.model();
    std::vector<int> storey(model.members().size(), 0);
    ConnectedNodes bodies(model);
    std::vector<char> supported(model.nodes().size(), 0);
    double base = std::numeric_limits<double>::infinity();
    const auto height = [&](int node) { return model.nodes()[std::size_t(node)].position.z(); };
    const auto support = [&](int node) {
        supported[std::size_t(bodies.of(node))] = 1;
        base = std::min(base, height(node));
    };
    for (std::size_t n = 0; n < model.nodes().size(); ++n)
        if (model.nodes()[n].fixed & 4) support(int(n));  // uz
    for (const NodeLink& link : node_links(model))
        if (link.a < 0) support(link.b);
    const auto stands = [&](const MemberData& m) { return supported[std::size_t(bodies.of(m.node[0]))] != 0; };

    std::vector<double> heights, floors;
    for (const MemberData& m : model.members()) {
        const Vec3 along =
            model.nodes()[std::size_t(m.node[1])].position - model.nodes()[std::size_t(m.node[0])].position;
        if (stands(m) && std::abs(along.z()) < level * std::hypot(along.x(), along.y()))
            heights.push_back((height(m.node[0]) + height(m.node[1])) / 2);
    }
    std::sort(heights.begin(), heights.end());
    for (const double z : heights)
        if (z > (floors.empty() ? base : floors.back()) + least_height) floors.push_back(z);
    if (floors.empty() || floors.size() > most_floors) return storey;
    for (std::size_t i = 0; i < storey.size(); ++i) {
        const MemberData& m = model.members()[i];
        if (!stands(m)) continue;
        const double middle = (height(m.node[0]) + height(m.node[1])) / 2;
        const auto floor =
            std::find_if(floors.begin(), floors.end(), [&](double z) { return middle <= z + above_floor; });
        storey[i] = int(std::min(floor - floors.begin(), std::ptrdiff_t(floors.size()) - 1)) + 1;
    }
    return storey;
}

}  // namespace hinge
