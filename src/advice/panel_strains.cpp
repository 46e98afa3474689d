// Panels that bend by their layers, whose own strains (panel/response.h) were not found in a step.
#include "advice/adviser.h"
#include "core/text.h"
#include "effects/panels.h"

namespace hinge {
namespace {

/// Of a panel's membrane forces: what its own strains may leave without a word.
constexpr double most_left = 1e-3;

class PanelStrains : public Adviser {
public:
    explicit PanelStrains(const Workspace& w) : w_(w) {}
    void list_findings(const Run&, std::vector<Warning>& list) const override {
        const PanelsNow* now = panels_now(w_.state);
        if (!now || !(now->left > most_left)) return;
        list.push_back({Warning::Kind::energy,
                        "the strains of panel " + std::to_string(now->left_in + 1) +
                            ", which bends by its layers, were found to " + number_text(100 * now->left, 2) +
                            " % of its membrane forces only, in the worst step; the energy error has what that changed",
                        "a shorter dt, or more steps of statics, may find them",
                        w_.structure.model().asked_at(panels_effect)});
    }

private:
    const Workspace& w_;
};

}  // namespace

std::unique_ptr<Adviser> advise_of_panel_strains(const Run& run, WarningLog&) {
    for (const Panel& p : run.structure().model().declared<Panel>(panels_effect))
        if (p.sheet->bends_by_layers) return std::make_unique<PanelStrains>(run.workspace());
    return nullptr;
}

}  // namespace hinge
