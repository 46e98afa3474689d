// Panels in a run: their state, and how the panels of a model are read.
#pragma once

#include <vector>

#include "model/panel.h"
#include "panel/membrane.h"
#include "state/state.h"

namespace hinge {

class Structure;

/// Panels where the last step that was kept ended.
struct PanelsNow {
    std::vector<double> history;     ///< of each layer at each point of each panel
    std::vector<std::uint8_t> torn;  ///< a bit for each layer of a panel
    std::vector<double> torn_at;     ///< s, in statics the load factor, at which the last of its layers tore; NaN
    std::vector<Vec3> force;         ///< mean membrane forces in the sheet's axes, [n11, n22, n12], N/m
    std::vector<double> used;        ///< largest part of its ultimate strain that a layer has reached
    std::vector<double> stored;      ///< J
    std::vector<char> on_trial;      ///< statics: 1 where all layers tear at the place that is tried
    double left = 0;                 ///< largest PanelResponse::left of a step that was kept
    int left_in = 0;                 ///< the panel that had it
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.history, s.torn, s.torn_at, s.force, s.used, s.stored, s.on_trial, s.left, s.left_in);
    }
};

/// The shape of a declared panel where the nodes are declared.
panel::Shape shape_of_panel(const Model& model, const Panel& panel);

/// Those of a run; null without panels.
const PanelsNow* panels_now(const State& state);
inline bool is_torn(const PanelsNow& now, const Panel& panel, std::size_t i) {
    return now.torn[i] == (1u << panel.sheet->layers.size()) - 1;
}

/// alpha of model:damping of the masses on nodes that panels alone join, 1/s: that of the last declaration for the
/// whole model.
double alpha_of_panels(const Structure& structure);

}  // namespace hinge
