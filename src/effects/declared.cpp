#include "effects/declared.h"

#include <algorithm>

#include "effects/all_effects.h"

namespace hinge {
namespace {

template <class T>
std::vector<T> of_all(const Model& model, std::vector<T> (*Declarer::*what)(const Model&)) {
    std::vector<T> list;
    for (const EffectKind& kind : all_effects())
        if (const auto ask = kind.declarer.*what)
            for (T& each : ask(model)) list.push_back(std::move(each));
    return list;
}

}  // namespace

std::vector<DeclaredLoad> declared_loads(const Model& model) { return of_all(model, &Declarer::loads); }
std::vector<int> declared_cases(const Model& model) { return of_all(model, &Declarer::cases); }
std::vector<AddedMass> added_masses(const Model& model) { return of_all(model, &Declarer::masses); }
std::vector<NodeLink> node_links(const Model& model) { return of_all(model, &Declarer::links); }
std::vector<DeclaredPlane> declared_planes(const Model& model) { return of_all(model, &Declarer::planes); }

std::optional<Vec3> declared_gravity(const Model& model) {
    for (const EffectKind& kind : all_effects())
        if (const auto ask = kind.declarer.gravity)
            if (auto g = ask(model)) return g;
    return {};
}

std::vector<ScriptFunctions> script_functions(const Model& model) {
    std::vector<ScriptFunctions> list = of_all(model, &Declarer::functions);
    std::stable_sort(list.begin(), list.end(),
                     [](const ScriptFunctions& a, const ScriptFunctions& b) { return a.place < b.place; });
    return list;
}

}  // namespace hinge
