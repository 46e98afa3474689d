#include "run/static_problem.h"

#include <algorithm>
#include <cmath>

namespace hinge {
namespace {

/// Supports of the model and of the run, and nodes inside members of which no element is left: they are debris, which
/// statics leaves where it is.
std::vector<std::uint8_t> all_supports(const Workspace& w, const std::vector<std::uint8_t>& of_run) {
    std::vector<std::uint8_t> held = w.state.held;
    for (std::size_t i = 0; i < of_run.size(); ++i) held[i] |= of_run[i];
    const Structure& s = w.structure;
    for (std::size_t n = s.model().nodes().size(); n < held.size(); ++n) {
        const auto& elements = s.elements_at(int(n));
        if (s.declared_node(int(n)) < 0 &&
            std::all_of(elements.begin(), elements.end(), [&](int e) { return w.state.broken[std::size_t(e)] != 0; }))
            held[n] = 63;
    }
    return held;
}

}  // namespace

StaticProblem::StaticProblem(Workspace& workspace, const EffectList& all_effects, StaticSettings given)
    : w(workspace), effects(all_effects), settings(std::move(given)), held(all_supports(workspace, settings.held)) {
    const auto& elements = w.structure.elements();
    double length = 0;
    for (const Element& e : elements) length += e.length;
    if (!elements.empty()) mean_length = length / double(elements.size());
    for (const Vec3& x : w.structure.position()) reach = std::max(reach, x.cwiseAbs().maxCoeff());
    for (const Element& e : elements) {
        const double stiffness = e.stiffness.axial + (e.stiffness.x22 + e.stiffness.y22) / (e.length * e.length);
        rounding = std::max(rounding, 1e-15 * reach * stiffness);
    }
    rounding *= std::sqrt(double(w.structure.position().size()));
}

Vec6 StaticProblem::without_supported(std::size_t node, Vec6 v) const {
    for (int c = 0; c < 6; ++c)
        if (held[node] >> c & 1) v[c] = 0;
    return v;
}

double dot_translations(const std::vector<Vec6>& a, const std::vector<Vec6>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].head<3>().dot(b[i].head<3>());
    return sum;
}

const char* component_name(int component) {
    static const char* const name[] = {"ux", "uy", "uz", "rx", "ry", "rz"};
    return name[component];
}

}  // namespace hinge
