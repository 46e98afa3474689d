#include "run/pair_tangents.h"

#include "state/hinges.h"

namespace hinge {

PairTangents pair_tangents(const Structure& structure, const State& state, const Pose& pose, const Sweep& sweep,
                           const std::vector<Yielding>& yielding) {
    PairTangents all;
    all.of_element.assign(structure.elements().size(), Mat6::Zero());
    std::vector<const beam::Flow*> flows(structure.elements().size(), nullptr);
    for (const Yielding& y : yielding) flows[y.element] = &y.flow;
    double section[2];
    const int n = sweep.sections(section);
    for (int first = 0; first + 1 < int(structure.elements().size()); first += 2) {
        if (state.broken[first] || state.broken[first + 1]) continue;
        const Element* e[2] = {&structure.elements()[first], &structure.elements()[first + 1]};
        const beam::Stiffness k[2] = {stiffness_now(structure, state, first),
                                      stiffness_now(structure, state, first + 1)};
        const beam::YieldSurface* surface[2] = {&e[0]->yield, &e[1]->yield};
        const beam::Flow* flow[2] = {flows[first], flows[first + 1]};
        Vec6 elastic[2];
        Eigen::Matrix<double, 12, 6> to_nodes[2];
        for (int i : {0, 1}) {
            const PlacedElement place = place_element(structure, first + i, pose);
            elastic[i] = element_deformation(structure, first + i, pose, place) - state.plastic[first + i];
            if (flow[i]) elastic[i] -= flow[i]->plastic;
            to_nodes[i] = forces_at_nodes(place);
        }
        const beam::PairMatrix K = beam::pair_tangent(pair_kind_of(*e[0]), k, elastic, surface, section, n, flow);
        for (int i : {0, 1}) all.of_element[first + i] = K.block<6, 6>(6 * i, 6 * i);
        const Mat12 between = to_nodes[0] * K.block<6, 6>(0, 6) * to_nodes[1].transpose();
        const int outer[2] = {e[0]->node[0], e[1]->node[1]}, middle = e[0]->node[1];
        Mat12 block = Mat12::Zero();
        block.block<6, 6>(0, 6) = between.block<6, 6>(0, 6);
        block.block<6, 6>(6, 0) = block.block<6, 6>(0, 6).transpose();
        all.couplings.push_back({outer[0], outer[1], block});
        block.block<6, 6>(0, 6) = between.block<6, 6>(0, 0);
        block.block<6, 6>(6, 0) = block.block<6, 6>(0, 6).transpose();
        block.block<6, 6>(6, 6) = between.block<6, 6>(6, 0) + between.block<6, 6>(6, 0).transpose();
        all.couplings.push_back({outer[0], middle, block});
        block.setZero();
        block.block<6, 6>(0, 6) = between.block<6, 6>(6, 6);
        block.block<6, 6>(6, 0) = block.block<6, 6>(0, 6).transpose();
        all.couplings.push_back({middle, outer[1], block});
    }
    return all;
}

}  // namespace hinge
