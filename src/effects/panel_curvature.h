// The curvature of panels that bend by their layers, from the places of the nodes around each of their corners
// (panel/bend.h): what the layers of a panel get beside its strain, and where their moments go.
#pragma once

#include <cstdint>
#include <vector>

#include "effects/placed_bend.h"
#include "effects/translation_blocks.h"
#include "panel/response.h"

namespace hinge {

/// Of each bend, where the last step that was kept ended.
struct CurvatureNow {
    std::vector<std::uint8_t> ended;  ///< 1 where one of its panels has torn: it has no moment any more
    std::vector<Vec3> kept;           ///< the three derivatives of the surface, 1/m
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.ended, s.kept);
    }
};

class PanelCurvature {
public:
    /// Of the panels of the model that bend by their layers.
    PanelCurvature(Workspace& w, const std::vector<Panel>& declared, const std::vector<panel::Shape>& shapes);
    /// The state's part, where the run begins, after that of the panels.
    void begin();
    bool has(std::size_t panel) const { return !of_.empty() && !of_[panel].nodes.empty(); }
    void join(TranslationBlocks& blocks) const;
    void find_places(const TranslationBlocks& blocks);

    /// Finds the bends at a pose, before at(panel) is asked, but for those of bodies at rest. A bend that has ended
    /// keeps the curvature that it had.
    void place(const Pose& at);
    panel::Curvatures at(std::size_t panel) const;
    const panel::OwnStrains& own_strains(std::size_t panel) const { return of_[panel].own; }

    /// Moments of the points of a panel (PanelResponse::moment), summed until add_forces.
    void add_moments(std::size_t panel, const std::array<Vec3, 4>& moment);
    void add_forces(std::vector<Vec6>& resisting);

    /// Stiffness of a panel; the part that its membrane forces have is not in it.
    void add_stiffness(std::size_t panel, const panel::Shape& shape, const panel::Placed& at,
                       const panel::Mat17& bending, TranslationBlocks& blocks) const;

    void keep();         ///< where the bends are that were placed last
    void end_of_torn();  ///< those of a panel that has torn
    bool fits(const State& state) const;

private:
    struct Placed : PlacedBend {
        Vec3 derivative = Vec3::Zero();  ///< that counts
        Vec3 moment = Vec3::Zero();      ///< work per change of the derivatives, N m^2
        bool acts = true;
    };
    /// A corner of a panel: the bend about its node, and the curvature in the panel's sheet from that of the bend.
    struct Corner {
        int bend = -1;
        Mat3 to_sheet = Mat3::Zero();
        std::vector<int> node;  ///< those of the bend, by their places in OfPanel::nodes
    };
    struct OfPanel {
        std::vector<int> nodes;  ///< its own first, then those of its corners' bends; none: not by its layers
        std::vector<int> place;  ///< those of all pairs in the blocks
        panel::OwnStrains own;
        Corner corner[4];
    };
    void add_corner(int bend, int panel, const Mat3& sheet);
    bool rests(std::size_t bend) const { return w_.rests(bends_[bend].nodes[0]); }
    CurvatureNow& now() const { return *w_.state.data.find<CurvatureNow>(name); }
    static constexpr const char* name = "curvature of panels";

    Workspace& w_;
    const std::vector<Panel>& declared_;
    std::vector<panel::Bend> bends_;
    std::vector<OfPanel> of_;
    std::vector<Placed> placed_;
};

}  // namespace hinge
