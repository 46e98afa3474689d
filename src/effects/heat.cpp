// Heat: members lengthen, bend where one side is hotter, and lose stiffness and strength (EN 1993-1-2, 3.2 and 3.4).
//
// The temperature is given, and acts through ElementHeat. At constant deformation it changes the energy of an element:
// with the elastic energy U = k_E U_20, forces p and the deformation h without force, a step of heating supplies
//
//   -p . dh + U_20 dk_E
//
// which the account "heat" has with the other sign, by the trapezium rule.
#include "effects/heat.h"

#include <algorithm>
#include <cmath>

#include "core/errors.h"
#include "core/text.h"
#include "effects/kinds.h"
#include "state/hinges.h"

namespace hinge {
namespace {

/// Change of the stiffness, as a part of it, from which on a step is solved with another one.
constexpr double other_stiffness = 1e-3;

/// Where a run goes on from another one, what differs by no more is the same: degrees Celsius, and strain.
constexpr double same_temperature = 1e-6, same_strain = 1e-12;

const std::vector<Heating>& declared(const Model& model) { return model.declared<Heating>(heat_effect); }

template <class Declared>
bool is_of(const Model& model, const Declared& h, int member) {
    if (h.member >= 0) return h.member == member;
    const auto& groups = model.members()[member].groups;
    return h.group < 0 || std::find(groups.begin(), groups.end(), h.group) != groups.end();
}

/// Strain of a member by all declarations of prestress.
double prestrain_of(const Model& model, int member, double EA) {
    double strain = 0;
    for (const Prestress& p : model.declared<Prestress>(prestress_effect))
        if (is_of(model, p, member)) strain += p.strain - p.force / EA;
    return strain;
}

struct Temperature {
    double middle = beam::room_temperature, across[2] = {0, 0};
};

/// Heat of an element of such a section at a temperature; `properties`: null where it is not heated.
ElementHeat heat_at_temperature(const Temperature& t, const HeatProperties* known, const Section& section,
                                double length, double prestrain) {
    ElementHeat heat;
    heat.strain = prestrain;
    heat.elongation = length * prestrain;
    if (!known) return heat;
    const HeatProperties& properties = *known;
    heat.stiffness = HeatProperties::at(t.middle, properties.stiffness);
    heat.strength = HeatProperties::at(t.middle, properties.strength);
    heat.elongation += length * HeatProperties::at(t.middle, properties.elongation);
    heat.temperature = t.middle;
    const double size[2] = {section.depth, section.width};
    for (int side : {0, 1}) {
        heat.across[side] = t.across[side];
        if (t.across[side] == 0) continue;
        const double half = t.across[side] / 2, more = HeatProperties::at(t.middle + half, properties.elongation) -
                                                       HeatProperties::at(t.middle - half, properties.elongation);
        // a rotation about x turns z towards -y, so that a side at +y that lengthens is a curvature above 0 about x
        heat.bend[side] = (side == 0 ? 1 : -1) * length * more / size[side];
    }
    return heat;
}

class Heat : public Effect, public Heater {
public:
    Heat(Workspace& w, Host& host) : Effect(heat_effect, w, host) {
        const auto& list = declared(w.structure.model());
        traits_.calls_script = std::any_of(list.begin(), list.end(), [](const Heating& h) {
            const auto is_function = [](const History& of_time) { return of_time && !of_time.points(); };
            return is_function(h.history) || is_function(h.across_history[0]) || is_function(h.across_history[1]);
        });
        std::vector<int> of_member;
        for (int m = 0; m < int(w.structure.model().members().size()); ++m)
            of_member.push_back(heating_of(w.structure.model(), m));
        for (int e = 0; e < int(w.structure.elements().size()); ++e) {
            const Element& element = w.structure.elements()[e];
            const int rule = of_member[element.member];
            const double strain = prestrain_of(w.structure.model(), element.member, element.rigidity.EA);
            const bool strained = strain != 0 || (!w.state.heat.empty() && w.state.heat[e].strain != 0);
            if (rule >= 0 || strained) heated_.push_back({e, rule, strain});
        }
        const bool cold = w.state.heat.empty();
        if (cold) w.state.heat.resize(w.structure.elements().size());
        if (w.kind.dynamic) begin_at_once(cold);
        begin_ = w.state.heat;
        for (const Heated& h : heated_) built_.push_back(w.state.heat[h.element].stiffness);
        w.trial.heat = w.state.heat;
    }

    void begin(const Step& step) override {
        w_.trial.heat = w_.state.heat;
        set(w_.trial.heat, step.end());
        for (std::size_t i = 0; i < heated_.size(); ++i) {
            const int e = heated_[i].element;
            const double now = w_.trial.heat[e].stiffness;
            if (std::abs(now - built_[i]) <= other_stiffness * built_[i] || w_.state.broken[e]) continue;
            host_.stiffness_changed(e);
            built_[i] = now;
        }
    }

    /// Where a run begins, a declaration with a history has its value there and stays.
    void heat_at(double factor) override {
        const auto way = [factor](double from, double to) { return from + factor * (to - from); };
        w_.trial.heat = w_.state.heat;
        for (const Heated& h : heated_) {
            const ElementHeat& from = begin_[h.element];
            Temperature t = h.rule >= 0 ? at_time(rule(h), w_.state.time) : Temperature();
            t.middle = way(from.temperature, t.middle);
            for (int side : {0, 1}) t.across[side] = way(from.across[side], t.across[side]);
            set(w_.trial.heat, h, t, way(from.strain, h.strain));
        }
    }

    void accumulate_energy(const Step&, Accounts& sums) const override {
        double supplied = 0;
        auto flow = w_.yielding.begin();
        Vec6 first[2];  // elastic deformation of the first of a pair, where the step begins and where it ends
        for (const Heated& heated : heated_) {
            const int e = heated.element;
            if (w_.state.broken[e]) continue;
            while (flow != w_.yielding.end() && flow->element < e) ++flow;
            const ElementHeat &before = w_.state.heat[e], &after = w_.trial.heat[e];
            Vec6 d[2] = {element_deformation(w_.structure, e, w_.state) - w_.state.plastic[e],
                         element_deformation(w_.structure, e, w_.trial) - w_.state.plastic[e]};
            if (flow != w_.yielding.end() && flow->element == e) {
                d[1] -= flow->flow.plastic;
                // it is counted at the strength where the step ends, and has gone on at the mean one
                sums["plastic"] += 0.5 * (before.strength / after.strength - 1) * flow->flow.dissipation;
            }
            supplied -= 0.5 * (w_.state.force[e] + w_.force[e]).dot(after.deformation() - before.deformation());
            const beam::Stiffness k = stiffness_now(w_.structure, w_.state, e, no_heat);
            double of_declared = 0;  // the mean of U at the two ends of the step
            for (const Vec6& elastic : d) of_declared += 0.25 * elastic.dot(k.times(elastic));
            if (in_pair(w_.structure, w_.state, e) && e % 2 == 1)
                for (int i : {0, 1})
                    of_declared +=
                        0.5 * elastic_pair(w_.structure, w_.state, e - 1, no_heat).energy_beyond(first[i], d[i]);
            for (int i : {0, 1}) first[i] = d[i];
            supplied += of_declared * (after.stiffness - before.stiffness);
        }
        sums[heat_effect] -= supplied;
    }

    void keep_from_rest(const Bodies& bodies, std::vector<char>& rests) const override {
        for (const Heated& h : heated_) {
            const int body = bodies.of_node[w_.structure.elements()[h.element].node[0]];
            if (body >= 0 && !w_.state.broken[h.element]) rests[body] = 0;
        }
    }

    void save(Writer& to) const override { to(begin_, built_); }
    void restore(Reader& from) override { from(begin_, built_); }
    bool restored(std::span<const State* const>) override {
        w_.trial.heat = w_.state.heat;
        return begin_.size() == w_.structure.elements().size() && built_.size() == heated_.size() &&
               w_.state.heat.size() == begin_.size();
    }

private:
    /// A run of dynamics begins with the temperatures and strains of its model. One that goes on has them, as a rule.
    /// `cold`: nothing was heated or strained before.
    void begin_at_once(bool cold) {
        ElementHeats there = w_.state.heat;
        set(there, w_.state.time);
        const auto differs = [](double a, double b, double by) { return std::abs(a - b) > by; };
        for (const Heated& h : heated_) {
            const ElementHeat &has = w_.state.heat[h.element], &gets = there[h.element];
            bool jumps = differs(has.temperature, gets.temperature, same_temperature) ||
                         differs(has.strain, gets.strain, same_strain);
            for (int side : {0, 1}) jumps = jumps || differs(has.across[side], gets.across[side], same_temperature);
            if (jumps || cold) w_.state.heat[h.element] = gets;
            if (jumps) traits_.strains_at_start = true;
        }
    }
    struct Heated {
        int element, rule;  ///< -1: not heated
        double strain;      ///< of prestress
    };
    const Heating& rule(const Heated& h) const { return declared(w_.structure.model())[h.rule]; }

    /// The temperature of a member at a time; in statics at that of the state.
    static Temperature at_time(const Heating& h, double time) {
        Temperature at{h.history ? h.history(time) : h.temperature, {h.across[0], h.across[1]}};
        for (int side : {0, 1})
            if (h.across_history[side]) at.across[side] = h.across_history[side](time);
        const double t = at.middle, half = 0.5 * std::max(std::abs(at.across[0]), std::abs(at.across[1]));
        if (!(t - half >= h.properties->least() && t + half <= h.properties->most()))
            throw HookError(h.asked_at + ": model:heat: the temperature is " + number_text(t) +
                            " degrees Celsius at t = " + number_text(time) + " s, and the properties are known from " +
                            number_text(h.properties->least()) + " to " + number_text(h.properties->most()) +
                            (half > 0 ? ", on both sides of the section" : ""));
        return at;
    }

    void set(ElementHeats& heat, const Heated& h, const Temperature& t, double strain) const {
        const Element& e = w_.structure.elements()[h.element];
        heat[h.element] = heat_at_temperature(t, h.rule >= 0 ? rule(h).properties.get() : nullptr,
                                              *w_.structure.model().members()[e.member].section, e.length, strain);
    }
    /// In dynamics, at a time.
    void set(ElementHeats& heat, double time) const {
        for (const Heated& h : heated_) set(heat, h, h.rule >= 0 ? at_time(rule(h), time) : Temperature(), h.strain);
    }

    std::vector<Heated> heated_;  ///< rising
    ElementHeats begin_;          ///< where a run of statics begins
    std::vector<double> built_;   ///< stiffness of each heated element with which steps are solved
};

std::vector<PlanLine> heat_plan(const Structure& s, const RunKind& kind) {
    const auto& list = declared(s.model());
    std::string text = list.empty() ? "not declared" : "model:heat";
    for (const Heating& h : list) {
        text += &h == &list[0] ? "; " : ", ";
        text += h.group >= 0    ? s.model().groups()[h.group]
                : h.member >= 0 ? "member " + std::to_string(h.member + 1)
                                : "all members";
        if (!h.varies()) text += " to " + number_text(h.temperature) + " degrees Celsius";
        else text += kind.dynamic ? " over time" : " as where the run begins";
    }
    const bool strained = !s.model().declared<Prestress>(prestress_effect).empty();
    return {{heat_effect, !list.empty(), text, s.model().asked_at(heat_effect)},
            {prestress_effect, strained, strained ? "model:prestress" : "not declared",
             s.model().asked_at(prestress_effect)}};
}

}  // namespace

double HeatProperties::at(double temperature, const Points& points) {
    const auto after = std::upper_bound(points.begin(), points.end(), temperature,
                                        [](double t, const auto& point) { return t < point.first; });
    if (after == points.begin()) return points.front().second;
    if (after == points.end()) return points.back().second;
    const auto& [t1, v1] = *(after - 1);
    const auto& [t2, v2] = *after;
    return v1 + (temperature - t1) / (t2 - t1) * (v2 - v1);
}

int heating_of(const Model& model, int member) {
    const auto& list = declared(model);
    for (int i = int(list.size()) - 1; i >= 0; --i)
        if (is_of(model, list[i], member)) return i;
    return -1;
}

void Heating::times(double factor) {
    temperature = beam::room_temperature + factor * (temperature - beam::room_temperature);
    for (double& k : across) k *= factor;
}

int Prestress::choose(std::vector<Prestress>& list, const std::vector<Prestress>*, const ChosenLoads& chosen) {
    for (Prestress& p : list)
        if (p.load_case >= 0) p.times(chosen.choice.factor[p.load_case]);
    return 0;
}

int Heating::choose(std::vector<Heating>& list, const std::vector<Heating>*, const ChosenLoads& chosen) {
    for (Heating& h : list)
        if (h.load_case >= 0 && !h.varies()) h.times(chosen.choice.factor[h.load_case]);
    return 0;
}

EffectKind heat_kind() {
    return {
        .name = heat_effect,
        .accounts = {{heat_effect,
                      45,
                      "taken out by heat and prestress; negative: they have pressed, pulled or bent members",
                      {},
                      false,
                      true}},
        .plan = heat_plan,
        .make = [](Workspace& w, Host& host) -> std::unique_ptr<Effect> {
            const Model& model = w.structure.model();
            if (declared(model).empty() && model.declared<Prestress>(prestress_effect).empty() && w.state.heat.empty())
                return nullptr;
            return std::make_unique<Heat>(w, host);
        },
        .leave_out = leave_out_declared<heat_effect>,
        .declarer = {.cases = [](const Model& model) {
            std::vector<int> list;
            for (const Heating& h : declared(model)) list.push_back(h.load_case);
            for (const Prestress& p : model.declared<Prestress>(prestress_effect)) list.push_back(p.load_case);
            return list;
        }}};
}

}  // namespace hinge
