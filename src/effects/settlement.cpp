// Settlements of supports in statics: in proportion to the load factor, from their position at the start of the run.
#include "effects/settlement.h"

#include "core/text.h"
#include "effects/kinds.h"

namespace hinge {
namespace {

const std::vector<Settlement>& settlements_of(const Model& model) {
    return model.declared<Settlement>(settlement_effect);
}

class SettlingSupports : public Effect, public StaticPrescriber {
public:
    SettlingSupports(Workspace& w, Host& host) : Effect(settlement_effect, w, host) {
        for (Settlement s : settlements_of(w.structure.model())) {
            s.by -= s.component < 3 ? w.state.displacement[s.node][s.component] : rotation_of(s.node)[s.component - 3];
            left_.push_back(s);
        }
    }

    void add_rates(std::vector<Vec6>& rates) const override {
        for (const Settlement& s : left_)  // a support with joints alone has no elements, and is not gone
            if (!w_.state.gone[s.node] || w_.structure.is_alone(s.node)) rates[s.node][s.component] += s.by;
    }

private:
    Vec3 rotation_of(int node) const {
        if (!w_.structure.large()) return w_.state.small_rotation[node];
        const Eigen::AngleAxisd turn(w_.state.rotation[node]);
        return turn.angle() * turn.axis();
    }

    std::vector<Settlement> left_;  ///< from where the run begins
};

std::vector<PlanLine> settlement_plan(const Structure& s, const RunKind& kind) {
    const std::size_t n = settlements_of(s.model()).size();
    const std::string why = n == 0         ? "supports do not settle"
                            : kind.dynamic ? "statics alone moves the supports"
                                           : count_text(long(n), "support displacement");
    return {{settlement_effect, n > 0 && !kind.dynamic, why, s.model().asked_at(settlement_effect)}};
}

}  // namespace

void add_settlement(Model& model, const Settlement& settlement) {
    model.fix(settlement.node, 1 << settlement.component);
    model.declare(settlement_effect, settlement);
}

EffectKind settlement_kind() {
    return {.name = settlement_effect,
            .plan = settlement_plan,
            .make = [](Workspace& w, Host& host) -> std::unique_ptr<Effect> {
                if (w.kind.dynamic || settlements_of(w.structure.model()).empty()) return nullptr;
                return std::make_unique<SettlingSupports>(w, host);
            },
            .leave_out = leave_out_declared<settlement_effect>};
}

}  // namespace hinge
