#include "effects/panel_curvature.h"

#include <algorithm>

namespace hinge {

using panel::Bend;
using panel::Gradient;

PanelCurvature::PanelCurvature(Workspace& w, const std::vector<Panel>& declared,
                               const std::vector<panel::Shape>& shapes)
    : w_(w), declared_(declared) {
    bends_ = bends_of(
        w.structure, declared, [](const Panel& p) { return p.sheet->bends_by_layers; },
        [](const Panel& p) { return p.sheet->poisson(); });
    if (std::none_of(declared.begin(), declared.end(), [](const Panel& p) { return p.sheet->bends_by_layers; })) return;
    of_.resize(declared.size());
    for (std::size_t i = 0; i < declared.size(); ++i) {
        if (!declared[i].sheet->bends_by_layers) continue;
        of_[i].nodes = declared[i].nodes;
        of_[i].own = panel::own_strains_of(*declared[i].sheet, shapes[i]);
    }
    for (std::size_t b = 0; b < bends_.size(); ++b)
        for (const int p : bends_[b].panels) add_corner(int(b), p, shapes[std::size_t(p)].axes);
    placed_.resize(bends_.size());
}

void PanelCurvature::add_corner(int bend, int panel, const Mat3& sheet) {
    const Bend& b = bends_[std::size_t(bend)];
    const auto& own = declared_[std::size_t(panel)].nodes;
    OfPanel& of = of_[std::size_t(panel)];
    Corner& corner = of.corner[std::find(own.begin(), own.end(), b.nodes[0]) - own.begin()];
    corner.bend = bend;
    // [k11, k22, 2 k12] in the sheet's axes, from that in the frame of the bend
    const Eigen::Matrix2d R = sheet.leftCols<2>().transpose() * b.frame.leftCols<2>();
    Mat3 turn;
    turn << R(0, 0) * R(0, 0), R(0, 1) * R(0, 1), R(0, 0) * R(0, 1),  //
        R(1, 0) * R(1, 0), R(1, 1) * R(1, 1), R(1, 0) * R(1, 1),      //
        2 * R(0, 0) * R(1, 0), 2 * R(0, 1) * R(1, 1), R(0, 0) * R(1, 1) + R(0, 1) * R(1, 0);
    corner.to_sheet = (sheet.col(2).dot(b.frame.col(2)) < 0 ? -turn : turn) * b.to_frame;
    for (const int n : b.nodes) {
        const auto at = std::find(of.nodes.begin(), of.nodes.end(), n);
        corner.node.push_back(int(at - of.nodes.begin()));
        if (at == of.nodes.end()) of.nodes.push_back(n);
    }
}

void PanelCurvature::begin() {
    if (bends_.empty()) w_.state.data.erase(name);
    if (bends_.empty() || (w_.state.data.find<CurvatureNow>(name) && fits(w_.state))) return;
    w_.state.data.set(name, CurvatureNow{});
    now().ended.resize(bends_.size(), 0), now().kept.resize(bends_.size(), Vec3::Zero());
    place(w_.state);
    keep();
    end_of_torn();
}

void PanelCurvature::join(TranslationBlocks& blocks) const {
    for (const OfPanel& of : of_) blocks.join(of.nodes);
}
void PanelCurvature::find_places(const TranslationBlocks& blocks) {
    for (OfPanel& of : of_) of.place = blocks.places(of.nodes);
}

void PanelCurvature::place(const Pose& pose) {
    for (std::size_t i = 0; i < bends_.size(); ++i) {
        if (rests(i)) continue;
        Placed& at = placed_[i];
        at.find(bends_[i], w_.structure, pose);
        at.moment.setZero();
        at.acts = !now().ended[i];
        at.derivative = at.acts ? at.bent.derivative : now().kept[i];
    }
}

panel::Curvatures PanelCurvature::at(std::size_t panel) const {
    panel::Curvatures k{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
    for (std::size_t c = 0; c < 4; ++c)
        if (const Corner& corner = of_[panel].corner[c]; corner.bend >= 0)
            k[c] = corner.to_sheet * placed_[std::size_t(corner.bend)].derivative;
    return k;
}

void PanelCurvature::add_moments(std::size_t panel, const std::array<Vec3, 4>& moment) {
    for (std::size_t c = 0; c < 4; ++c)
        if (const Corner& corner = of_[panel].corner[c]; corner.bend >= 0)
            placed_[std::size_t(corner.bend)].moment += corner.to_sheet.transpose() * moment[c];
}

void PanelCurvature::add_forces(std::vector<Vec6>& resisting) {
    for (std::size_t i = 0; i < bends_.size(); ++i) {
        const Placed& at = placed_[i];
        if (at.acts && !rests(i)) at.add_forces(bends_[i], w_.structure, at.moment, resisting);
    }
}

void PanelCurvature::add_stiffness(std::size_t panel, const panel::Shape& shape, const panel::Placed& at,
                                   const panel::Mat17& bending, TranslationBlocks& blocks) const {
    const OfPanel& of = of_[panel];
    const int n = int(of.nodes.size());
    using Wide = Eigen::Matrix<double, 17, Eigen::Dynamic>;
    Wide W = Wide::Zero(17, 3 * n);  // of mean strain, p and curvatures, by the places of the nodes
    for (int k = 0; k < shape.nodes; ++k) W.block<5, 3>(0, 3 * k) = panel::strain_gradient(shape, at, k);
    for (int c = 0; c < 4; ++c) {
        const Corner& corner = of.corner[c];
        if (corner.bend < 0 || !placed_[std::size_t(corner.bend)].acts) continue;
        const Placed& bent = placed_[std::size_t(corner.bend)];
        const Gradient G = corner.to_sheet * bent.gradient(bends_[std::size_t(corner.bend)], w_.structure);
        for (std::size_t j = 0; j < corner.node.size(); ++j)
            W.block<3, 3>(5 + 3 * c, 3 * corner.node[j]) += G.block<3, 3>(0, 3 * int(j));
    }
    const Wide HW = bending * W;
    for (int j = 0; j < n; ++j)
        for (int k = 0; k < n; ++k) {
            if (of.nodes[std::size_t(j)] > of.nodes[std::size_t(k)]) continue;
            const Mat3 K = W.middleCols<3>(3 * j).transpose() * HW.middleCols<3>(3 * k);
            const int place = of.place[std::size_t(n * j + k)];
            if (j == k) blocks.add_own(place, K);
            else blocks.add(place, K, true);
        }
}

void PanelCurvature::keep() {
    for (std::size_t i = 0; i < bends_.size(); ++i)
        if (placed_[i].acts && !rests(i)) now().kept[i] = placed_[i].derivative;
}
void PanelCurvature::end_of_torn() {
    const PanelsNow* panels = bends_.empty() ? nullptr : panels_now(w_.state);
    for (std::size_t i = 0; i < bends_.size(); ++i)
        for (const int p : bends_[i].panels)
            if (is_torn(*panels, declared_[std::size_t(p)], std::size_t(p))) now().ended[i] = 1;
}
bool PanelCurvature::fits(const State& state) const {
    if (bends_.empty()) return true;
    const auto* there = state.data.find<CurvatureNow>(name);
    return there && there->ended.size() == bends_.size() && there->kept.size() == bends_.size();
}

}  // namespace hinge
