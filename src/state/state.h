// State of a run, all that changes during it: dense arrays, and one list of them that drives copies, snapshots and
// hashes.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/archive.h"
#include "model/structure.h"
#include "state/energy.h"
#include "state/pose.h"

namespace hinge {

/// Mass attached rigidly to a node by broken elements (paper, fig 5). In the node's own frame.
struct OffsetMass {
    double mass = 0;              ///< kg
    Vec3 moment = Vec3::Zero();   ///< first moment about the node, kg m
    Mat3 inertia = Mat3::Zero();  ///< about the node, kg m^2
    /// Whether it is at the node itself.
    bool is_point() const { return moment.isZero(0) && inertia.isZero(0); }

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.mass, s.moment, s.inertia);
    }
};

enum HingeBits : std::uint8_t { hinge_at_1 = 1, hinge_at_2 = 2, hinge_at_middle = 4 };

/// Data that an effect keeps from step to step, in addition to the arrays. They are copied with the state, so that a
/// run may continue another, and a step be rolled back.
class EffectData {
public:
    virtual ~EffectData() = default;
    virtual std::unique_ptr<EffectData> copy() const = 0;
    virtual void save(Writer& to) const = 0;
    virtual void restore(Reader& from) = 0;
    virtual bool in_hash() const { return true; }
    /// Numbers that count in the hash of a state where not all of it does; null for none.
    virtual const std::vector<double>* in_hash_alone() const { return nullptr; }
};

/// Effect data that holds a T. T lists its fields for a checkpoint (core/archive.h).
template <class T>
class DataOf : public EffectData {
public:
    T value;
    explicit DataOf(T v) : value(std::move(v)) {}
    std::unique_ptr<EffectData> copy() const override { return std::make_unique<DataOf>(value); }
    void save(Writer& to) const override { to(value); }
    void restore(Reader& from) override { from(value); }
    bool in_hash() const override {
        if constexpr (requires { T::in_state_hash; }) return T::in_state_hash;
        return true;
    }
    const std::vector<double>* in_hash_alone() const override {
        if constexpr (requires { value.in_hash_alone(); }) return value.in_hash_alone();
        return nullptr;
    }
};

/// Data of all effects that have any, each under the effect's name.
class EffectDataList {
public:
    EffectDataList() = default;
    EffectDataList(EffectDataList&&) = default;
    EffectDataList& operator=(EffectDataList&&) = default;
    EffectDataList(const EffectDataList& other) { *this = other; }
    EffectDataList& operator=(const EffectDataList& other) {
        EffectDataList copies;
        for (const auto& [name, data] : other.list_) copies.list_.emplace_back(name, data->copy());
        std::swap(list_, copies.list_);
        return *this;
    }
    /// Null where the effect keeps nothing.
    template <class T>
    T* find(std::string_view effect) const {
        for (const auto& [name, data] : list_)
            if (name == effect) return &static_cast<DataOf<T>*>(data.get())->value;  // an effect keeps one type
        return nullptr;
    }
    template <class T>
    T& set(std::string_view effect, T value) {
        erase(effect);
        auto own = std::make_unique<DataOf<T>>(std::move(value));
        T& kept = own->value;
        list_.emplace_back(effect, std::move(own));
        return kept;
    }
    void erase(std::string_view effect) {
        std::erase_if(list_, [&](const auto& entry) { return entry.first == effect; });
    }
    auto begin() const { return list_.begin(); }
    auto end() const { return list_.end(); }

private:
    std::vector<std::pair<std::string, std::unique_ptr<EffectData>>> list_;
};

/// All that changes during a run. Its pose and its motion are those where the last step that was kept ended.
struct State : Configuration {
    // nodes
    std::vector<std::uint8_t> held;  ///< bits as in Structure::fixed; all six for a node that has lost its elements
    std::vector<OffsetMass> offset_mass;  ///< empty until something breaks, then one a node
    // elements
    std::vector<Vec6> plastic;          ///< plastic deformation, in d of timoshenko.h, but for `turned`
    std::vector<Vec6> force;            ///< p of timoshenko.h, N m and N
    std::vector<double> point;          ///< s
    std::vector<double> plastic_work;   ///< J
    std::vector<std::uint8_t> hinge;    ///< HingeBits: flowing in the last step
    std::vector<std::uint8_t> yielded;  ///< HingeBits: has ever flowed
    std::vector<std::uint8_t> touched;  ///< 1: has been in contact
    std::vector<std::int8_t> broken;    ///< 0, or the broken end: 1 or 2
    std::vector<Vec3> offset_arm;       ///< of broken elements: from the node that carries it to its free end, in that
                                        ///< node's frame, m; of lone elements (lone_elements.h): from the inner node to
                                        ///< the mass that it carries; empty until something breaks
    std::vector<std::uint8_t> gone;     ///< nodes without an element and without mass
    std::vector<double> history;        ///< history variables of the laws of sections (history_of)

    double time = 0;
    long step = 0;
    double factor = 1;     ///< load factor reached in statics
    Accounts accumulated;  ///< energy that steps have added up, J
    EffectDataList data;

    /// Calls f(name, array) for each array, in a fixed order.
    template <class Self, class F>
    static void for_each_field(Self& s, F f) {
        f("displacement", s.displacement);
        f("rotation", s.rotation);
        f("small_rotation", s.small_rotation);
        f("velocity", s.velocity);
        f("acceleration", s.acceleration);
        f("held", s.held);
        f("offset_mass", s.offset_mass);
        f("plastic", s.plastic);
        f("force", s.force);
        f("point", s.point);
        f("plastic_work", s.plastic_work);
        f("hinge", s.hinge);
        f("yielded", s.yielded);
        f("touched", s.touched);
        f("broken", s.broken);
        f("offset_arm", s.offset_arm);
        f("twist", s.twist);
        f("turned", s.turned);
        f("gone", s.gone);
        f("history", s.history);
        f("heat", s.heat);
    }
    /// For a checkpoint (core/archive.h). Which effects keep data the model says.
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        for_each_field(s, [&](const char*, auto& array) { a(array); });
        a(s.time, s.step, s.factor, s.accumulated);
        for (const auto& [name, data] : s.data) {
            if constexpr (A::reading) data->restore(a);
            else if constexpr (std::is_same_v<A, Writer>) data->save(a);
        }
    }
};

/// History variables of an element's sections, one after the other; null where no law of the structure has any.
inline const double* history_of(const Structure& structure, const State& state, int element) {
    return state.history.empty() ? nullptr : state.history.data() + structure.history_at(element);
}

/// The state at the start: declared positions and velocities, no stress.
State initial_state(const Structure& structure);

/// True if a state that was read fits the structure: each array has the right length, and no index is out of range.
bool makes_sense(const State& state, const Structure& structure);
bool is_finite(const State& state);  ///< each of its numbers

/// A hash of every array: equal states have equal hashes, whatever the machine's thread count. History variables that
/// are all zero do not count.
std::uint64_t hash(const State& state);

}  // namespace hinge
