// Points of members and panels that passed through a panel where no model:panel_contact holds them apart.
#include <algorithm>
#include <cmath>

#include "advice/adviser.h"
#include "core/text.h"
#include "effects/panel_points.h"

namespace hinge {
namespace {

constexpr int looks_between = 16;    ///< steps between looks at the nodes
constexpr double part_of_panel = 8;  ///< of the smallest panel's width: a motion after which places are compared

/// Finds points whose foot is within a panel at two looks, on its two sides. Not found are points of members and panels
/// that have a node in common with the panel, or next to it. In statics nothing holds them apart.
class PassedPanels : public Adviser {
public:
    explicit PassedPanels(const Workspace& w) : w_(w), points_(w.structure), last_(w.state.displacement) {}
    void after_commit(const Run&, const Step& step) override {
        if (++since_ < looks_between && w_.kind.dynamic) return;
        since_ = 0;
        double moved = 0;
        for (std::size_t n = 0; n < last_.size(); ++n)
            moved = std::max(moved, (w_.state.displacement[n] - last_[n]).squaredNorm());
        if (!(std::sqrt(moved) > points_.smallest() / part_of_panel)) return;
        look(w_.reached(step), passed_);
        last_ = w_.state.displacement;
    }
    void list_findings(const Run&, std::vector<Warning>& list) const override {
        Passed all = passed_;
        look(w_.kind.dynamic ? w_.state.time : w_.state.factor, all);
        if (!all.any) return;
        const bool statics = w_.goes_by_load_factor();
        list.push_back({Warning::Kind::contact,
                        "points passed through panels, first one through panel " + std::to_string(all.panel + 1) +
                            (statics ? " by load factor " : " by t = ") + number_text(all.when, 4) +
                            (statics ? ": contact acts in dynamics alone" : " s: the model has no contact of panels"),
                        statics ? "a slow dynamic run with model:panel_contact has them in each other's way"
                                : "declare model:panel_contact {}",
                        w_.structure.model().asked_at(panels_effect)});
    }
    void save(Writer& to) const override { to(since_, last_, passed_); }
    void restore(Reader& from) override { from(since_, last_, passed_); }
    bool fits(const Run&) const override {
        return last_.size() == w_.structure.position().size() && passed_.panel >= 0 &&
               passed_.panel < int(points_.panels().size());
    }

private:
    struct Passed {
        bool any = false;
        int panel = 0;
        double when = 0;  ///< s, or a load factor
        template <class Self, class A>
        static void fields(Self& s, A& a) {
            a(s.any, s.panel, s.when);
        }
    };
    struct Before {
        const std::vector<Vec3>& displacement;
    };

    /// Over the straight way of the nodes since the last look. The first finding is enough.
    void look(double when, Passed& found) const {
        if (found.any) return;
        const Before before{last_};
        for (const PanelTouch& t : points_.near(w_.state, &last_, 0)) {
            const contact::Foot from = points_.foot(before, t), to = points_.foot(w_.state, t);
            if (from.beyond > 0 || to.beyond > 0 || !(from.height * to.height < 0)) continue;
            found = {true, t.panel, when};
            return;
        }
    }

    const Workspace& w_;
    PanelPoints points_;
    std::vector<Vec3> last_;  ///< m, displacements where places were last compared
    int since_ = 0;           ///< steps since nodes were looked at
    Passed passed_;
};

}  // namespace

std::unique_ptr<Adviser> advise_of_passed_panels(const Run& run, WarningLog&) {
    const Model& model = run.structure().model();
    const bool held_apart =
        run.workspace().kind.dynamic && !model.declared<PanelContactRule>(panel_contact_effect).empty();
    if (model.declared<Panel>(panels_effect).empty() || held_apart || !run.structure().large()) return nullptr;
    return std::make_unique<PassedPanels>(run.workspace());
}

}  // namespace hinge
