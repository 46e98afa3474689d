#include "state/state.h"

#include <algorithm>
#include <cmath>

namespace hinge {

namespace {

/// What the laws of sections keep of them before the first step.
void start_histories(const Structure& structure, State& s) {
    for (std::size_t i = 0; i < structure.elements().size() && !s.history.empty(); ++i) {
        const Element& e = structure.elements()[i];
        const int size = e.law ? e.law->history_size() : 0;
        const MemberData& member = structure.model().members()[e.member];
        for (int end = 0; size > 0 && end < (structure.conventional() ? 1 : 2); ++end)
            e.law->start(structure.conventional() || e.node[end] == member.node[end],
                         &s.history[structure.history_at(int(i)) + std::size_t(end * size)]);
    }
}

}  // namespace

State initial_state(const Structure& structure) {
    const std::size_t nodes = structure.position().size(), elements = structure.elements().size();
    State s;
    s.displacement.assign(nodes, Vec3::Zero());
    s.rotation.assign(nodes, Quat::Identity());
    if (!structure.large()) s.small_rotation.assign(nodes, Vec3::Zero());
    s.velocity = structure.initial_velocity();
    s.acceleration.assign(nodes, Vec6::Zero());
    s.held = structure.held();
    s.gone.assign(nodes, 0);
    for (std::size_t i = 0; i < nodes; ++i) {
        if (structure.is_alone(int(i))) s.held[i] = 63, s.gone[i] = 1;
        for (int c = 0; c < 6; ++c)
            if (s.held[i] >> c & 1) s.velocity[i][c] = 0;
    }
    s.plastic.assign(elements, Vec6::Zero());
    s.force.assign(elements, Vec6::Zero());
    for (const Element& e : structure.elements()) s.point.push_back(e.s);
    s.plastic_work.assign(elements, 0);
    s.hinge.assign(elements, 0);
    s.yielded.assign(elements, 0);
    s.touched.assign(elements, 0);
    s.broken.assign(elements, 0);
    s.history.assign(structure.history_size(), 0);
    start_histories(structure, s);
    return s;
}

bool makes_sense(const State& s, const Structure& structure) {
    const std::size_t nodes = structure.position().size(), elements = structure.elements().size();
    const auto long_as = [](std::size_t n, const auto&... arrays) { return ((arrays.size() == n) && ...); };
    const auto none_or = [](std::size_t n, const auto& array) { return array.empty() || array.size() == n; };
    const bool whole =
        long_as(nodes, s.displacement, s.rotation, s.velocity, s.acceleration, s.held, s.gone) &&
        long_as(structure.large() ? 0 : nodes, s.small_rotation) &&
        long_as(elements, s.plastic, s.force, s.point, s.plastic_work, s.hinge, s.yielded, s.touched, s.broken) &&
        long_as(structure.history_size(), s.history) && none_or(nodes, s.offset_mass) &&
        none_or(elements, s.offset_arm) && none_or(elements, s.twist) && none_or(elements, s.turned) &&
        none_or(elements, s.heat);
    if (!whole) return false;
    for (std::size_t i = 0; i < nodes; ++i)  // no force would notice what such a node does
        if (s.gone[i]) {
            const bool moves = !s.velocity[i].isZero(0) || !s.acceleration[i].isZero(0),
                       may_move = structure.is_alone(int(i));  // a support with joints alone
            if (s.held[i] != 63 || (moves && !may_move)) return false;
        }
    const bool any_broken = std::any_of(s.broken.begin(), s.broken.end(), [](int b) { return b != 0; });
    return std::all_of(s.broken.begin(), s.broken.end(), [](int b) { return b >= 0 && b <= 2; }) &&
           std::all_of(s.held.begin(), s.held.end(), [](int bits) { return bits < 64; }) &&
           (!any_broken || (!s.offset_mass.empty() && !s.offset_arm.empty()));
}

bool is_finite(const State& s) {
    const auto finite = [](double x) { return std::isfinite(x); };
    bool good = finite(s.time) && finite(s.factor);
    for (const auto& [name, sum] : s.accumulated) good = good && finite(sum);
    State::for_each_field(s, [&](const char*, const auto& array) {
        if constexpr (sizeof(array[0]) > 1) {  // doubles or made of them; else bytes
            const auto* first = reinterpret_cast<const double*>(array.data());
            good = good && std::all_of(first, first + array.size() * sizeof(array[0]) / sizeof(double), finite);
        }
    });
    return good;
}

std::uint64_t hash(const State& state) {
    std::uint64_t h = 14695981039346656037ull;
    // sections that have not flowed are as those that cannot
    const bool flowed = std::any_of(state.history.begin(), state.history.end(), [](double v) { return v != 0; });
    const auto add = [&h](const auto& array) {
        const auto* bytes = reinterpret_cast<const unsigned char*>(array.data());
        for (std::size_t i = 0, n = array.size() * sizeof(array[0]); i < n; ++i) h = (h ^ bytes[i]) * 1099511628211ull;
    };
    State::for_each_field(state, [&](const char*, const auto& array) {
        if (static_cast<const void*>(&array) == &state.history) {
            for (const auto& [name, data] : state.data)
                if (const std::vector<double>* numbers = data->in_hash_alone()) add(*numbers);
            if (!flowed) return;
        }
        add(array);
    });
    for (const auto& [name, data] : state.data) {
        if (!data->in_hash()) continue;
        std::string bytes;
        Writer write(bytes);
        data->save(write);
        for (const unsigned char byte : bytes) h = (h ^ byte) * 1099511628211ull;
    }
    return h;
}

}  // namespace hinge
