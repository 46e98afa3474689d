// The bends about the nodes of panels (panel/bend.h), and where they are at a pose.
#pragma once

#include <vector>

#include "effects/panels.h"
#include "panel/bend.h"

namespace hinge {

/// Those of the panels for which bends(panel) is true; each has the indices of its panels in the model.
template <class Bends, class Poisson>
std::vector<panel::Bend> bends_of(const Structure& structure, const std::vector<Panel>& declared, Bends bends,
                                  Poisson poisson) {
    std::vector<panel::Corners> corners;
    std::vector<int> which;
    for (std::size_t i = 0; i < declared.size(); ++i) {
        const Panel& p = declared[i];
        if (!bends(p)) continue;
        corners.push_back({p.nodes, shape_of_panel(structure.model(), p).area, poisson(p)});
        which.push_back(int(i));
    }
    std::vector<panel::Bend> list = panel::bends_of(corners, structure.position());
    for (panel::Bend& b : list)
        for (int& p : b.panels) p = which[std::size_t(p)];
    return list;
}

/// Where a bend is.
struct PlacedBend {
    std::vector<Vec3> places, moved;  ///< of its nodes, from the first one's place at the start
    panel::Bent bent;

    void find(const panel::Bend& bend, const Structure& structure, const Pose& pose) {
        const bool large = structure.large();
        const Vec3 origin = structure.position()[bend.nodes[0]], by = pose.displacement[bend.nodes[0]];
        places.clear(), moved.clear();
        for (const int n : bend.nodes) {
            const Vec3 start = structure.position()[n] - origin, on = pose.displacement[n] - by;
            places.push_back(large ? Vec3(start + on) : start);
            moved.push_back(large ? places.back() : on);
        }
        bent = panel::bent(bend, places, moved, large);
    }
    panel::Gradient gradient(const panel::Bend& bend, const Structure& structure) const {
        return panel::gradient(bend, bent, places, structure.large());
    }
    /// `moment`: work per change of its three derivatives, N m^2.
    void add_forces(const panel::Bend& bend, const Structure& structure, const Vec3& moment,
                    std::vector<Vec6>& resisting) const {
        forces.assign(bend.nodes.size(), Vec3::Zero());
        panel::add_forces(bend, bent, places, structure.large(), moment, forces);
        for (std::size_t j = 0; j < bend.nodes.size(); ++j) resisting[bend.nodes[j]].head<3>() += forces[j];
    }

private:
    mutable std::vector<Vec3> forces;
};

}  // namespace hinge
