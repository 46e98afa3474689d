// What the engine's tests share: sections and materials, small models, runs to their end, and figures held against
// limits.
#pragma once

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <memory>
#include <random>
#include <vector>

#include "beam/corotation.h"
#include "effects/contact.h"
#include "effects/fracture.h"
#include "effects/gravity.h"
#include "effects/loads.h"
#include "effects/moving_supports.h"
#include "state/breaking.h"
#include "run/dynamics.h"
#include "run/statics.h"

/// CHECK(figure <= limit), naming the figure. With HINGE_FIGURES set in the environment every figure is printed beside
/// its limit.
#define CHECK_FIGURE(what, figure, limit)                  \
    do {                                                   \
        const double figure_ = (figure), limit_ = (limit); \
        hinge::test::show_figure(what, figure_, limit_);   \
        INFO(what);                                        \
        CHECK(figure_ <= limit_);                          \
    } while (false)

// A test names the fields that matter to it; the others have their defaults.
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"

namespace hinge::test {

inline constexpr double pi = 3.14159265358979323846;
inline const double infinite = std::numeric_limits<double>::infinity();

/// The largest of numbers; not a number if one of them is not, so that every limit it is held against is missed.
/// std::max(worst, x) and Eigen's maxCoeff() may drop a NaN.
inline double largest_of(double a, double b) { return std::isnan(a) || b <= a ? a : b; }
inline double smallest_of(double a, double b) { return std::isnan(a) || b >= a ? a : b; }
template <class... More>
double largest_of(double a, double b, More... more) {
    return largest_of(largest_of(a, b), more...);
}
/// The largest magnitude among a matrix's entries, in the same way.
template <class Matrix>
double largest_entry(const Eigen::MatrixBase<Matrix>& m) {
    return m.cwiseAbs().template maxCoeff<Eigen::PropagateNaN>();
}

inline void show_figure(const std::string& what, double figure, double limit) {
    if (std::getenv("HINGE_FIGURES"))
        std::printf("%-96s %10.2e of %8.1e%s\n", what.c_str(), figure, limit, figure <= limit ? "" : "  FAILS");
}

/// How far `value` is from `reference`, as a part of it.
inline double off(double value, double reference) { return std::abs(value / reference - 1); }

/// Random numbers that are the same on every machine.
struct Dice {
    std::mt19937_64 engine;
    explicit Dice(unsigned seed) : engine(seed) {}
    double operator()(double low, double high) {
        return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1p-53;
    }
    int pick(int n) { return std::min(n - 1, static_cast<int>((*this)(0, n))); }
    Vec3 vector(double size) { return {(*this)(-size, size), (*this)(-size, size), (*this)(-size, size)}; }
    Vec3 direction() {
        while (true) {
            const Vec3 v = vector(1);
            if (v.norm() > 0.1 && v.norm() < 1) return v.normalized();
        }
    }
    Quat rotation(double most = pi) { return Quat(Eigen::AngleAxisd((*this)(-most, most), direction())); }
};

/// exp(v) by Eigen, not by the engine.
inline Quat exponential(const Vec3& v) {
    return v.norm() > 0 ? Quat(Eigen::AngleAxisd(v.norm(), v.normalized())) : Quat::Identity();
}
/// The engine's own of Eigen's, and Eigen's of its.
inline beam::Quadruple<double> quad(const Quat& q) { return {q.w(), q.x(), q.y(), q.z()}; }
inline Vec3 eigen(const beam::Triple<double>& t) { return {t.x, t.y, t.z}; }

/// The derivative of f at x by central differences, a column for each of the numbers of x, whose steps are these.
template <class F, int N>
auto differences(const F& f, const Eigen::Matrix<double, N, 1>& x, const Eigen::Matrix<double, N, 1>& steps) {
    Eigen::Matrix<double, decltype(f(x))::RowsAtCompileTime, N> D;
    for (int i = 0; i < N; ++i) {
        const Eigen::Matrix<double, N, 1> by = steps[i] * Eigen::Matrix<double, N, 1>::Unit(i);
        D.col(i) = (f(x + by) - f(x - by)) / (2 * steps[i]);
    }
    return D;
}

// ---- materials and sections ---------------------------------------------------------------------------------------

inline std::shared_ptr<Material> steel(double yield_stress = infinite) {
    auto m = std::make_shared<Material>();
    m->E = 206e9;
    m->G = m->E / 2.6;
    m->density = 7850;
    m->yield_stress = yield_stress;
    return m;
}

/// Solid square of side b: J = 0.140577 b^4 and the sand heap's plastic torque, see tests/references.md, "Section S".
inline std::shared_ptr<Section> square(double b) {
    auto s = std::make_shared<Section>();
    s->area = b * b;
    s->Ix = s->Iy = std::pow(b, 4) / 12;
    s->J = 0.140577 * std::pow(b, 4);
    s->shear_area_x = s->shear_area_y = 5.0 / 6 * b * b;
    s->plastic_area = b * b;
    s->Zx = s->Zy = std::pow(b, 3) / 4;
    s->Zz = std::pow(b, 3) / 3;
    s->width = s->depth = b;
    return s;
}

/// A material of E = G = density = 1, so that a section's numbers are the rigidities themselves.
inline std::shared_ptr<Material> unit_material() {
    auto m = std::make_shared<Material>();
    m->E = m->G = m->density = 1;
    return m;
}

/// A section by its rigidities, for unit_material: EA, EIx, EIy, GJ and one GA for both directions.
inline std::shared_ptr<Section> rigidities(double EA, double EIx, double EIy, double GJ, double GA) {
    auto s = std::make_shared<Section>();
    s->area = EA;
    s->Ix = EIx;
    s->Iy = EIy;
    s->J = GJ;
    s->shear_area_x = s->shear_area_y = GA;
    s->width = s->depth = 1e-3;
    return s;
}

/// Each of these rigidities times 0.5 to 2.
inline beam::Rigidity random_rigidity(Dice& dice, beam::Rigidity c) {
    for (double* x : {&c.EIx, &c.EIy, &c.EA, &c.GJ, &c.GAx, &c.GAy}) *x *= dice(0.5, 2);
    return c;
}

// ---- models ---------------------------------------------------------------------------------------------------------

inline ModelOptions small_displacement(Formulation f = Formulation::asi_gauss) {
    return {.formulation = f, .displacement = Displacement::small};
}

/// A model under construction; members take `elements`, `section` and `material` as they stand when the member is
/// added.
struct Frame {
    std::shared_ptr<Model> model;
    std::shared_ptr<const Section> section = square(0.05);
    std::shared_ptr<const Material> material = steel();
    int elements = 2;
    std::vector<int> groups;

    explicit Frame(ModelOptions options = {}) : model(std::make_shared<Model>(options)) {}

    int node(double x, double y, double z) { return model->add_node({x, y, z}); }
    int node(const Vec3& x) { return model->add_node(x); }
    int foot(double x, double y, double z, std::uint8_t fixed = 63) {
        const int n = node(x, y, z);
        model->fix(n, fixed);
        return n;
    }
    int member(int a, int b, Vec3 up = Vec3::Zero()) {
        if (up.isZero()) {
            const Vec3 along = (model->nodes()[b].position - model->nodes()[a].position).normalized();
            up = std::abs(along.z()) < 0.9 ? Vec3::UnitZ() : Vec3::UnitX();
        }
        return model->add_member({{a, b}, section, material, up, elements, groups});
    }
    void load(int n, const Vec3& force, const Vec3& moment = Vec3::Zero(), History history = {}) {
        add_load(*model, {n, force, moment, std::move(history)});
    }
    std::shared_ptr<const Structure> build() const { return std::make_shared<Structure>(model); }
};

/// n members in a row along `points`, the ends first and last.
inline std::vector<int> chain(Frame& frame, const std::vector<Vec3>& points, const Vec3& up) {
    std::vector<int> nodes;
    for (const Vec3& p : points) nodes.push_back(frame.node(p));
    for (std::size_t i = 1; i < nodes.size(); ++i) frame.member(nodes[i - 1], nodes[i], up);
    return nodes;
}
inline std::vector<int> straight(Frame& frame, const Vec3& from, const Vec3& to, int members,
                                 const Vec3& up = Vec3::UnitZ()) {
    std::vector<Vec3> points;
    for (int i = 0; i <= members; ++i) points.push_back(from + (to - from) * i / members);
    return chain(frame, points, up);
}

/// The space frame of fig 8 as reconstructed (tests/references.md, "SF-1"): a cube of side 0.25 m, load +x at a top
/// corner.
struct SpaceFrame : Frame {
    int foot[4], top[4], loaded;
    SpaceFrame(ModelOptions options, double load_x, double yield_stress, int elements_per_member = 2,
               History history = {})
        : Frame(options) {
        section = square(0.02);
        material = steel(yield_stress);
        elements = elements_per_member;
        const double side = 0.25, xy[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        for (int i = 0; i < 4; ++i) {
            foot[i] = Frame::foot(side * xy[i][0], side * xy[i][1], 0);
            top[i] = node(side * xy[i][0], side * xy[i][1], side);
        }
        for (int i = 0; i < 4; ++i) {
            member(foot[i], top[i]);
            member(top[i], top[(i + 1) % 4]);
        }
        loaded = top[0];
        load(loaded, {load_x, 0, 0}, Vec3::Zero(), std::move(history));
    }
};

/// Bars of 1 m: one along x, clamped or free, and one that falls on it from `above`, crossing it at `angle` degrees,
/// `along` m from its middle and `along_b` m from its own.
inline void falling_on(Frame& frame, bool clamped, double above, double angle, double along, double along_b,
                       double speed) {
    const Vec3 d(std::cos(angle * pi / 180), std::sin(angle * pi / 180), 0),
        middle = Vec3(along, 0, above) - along_b * d;
    const std::uint8_t fixed = clamped ? 63 : 0;
    frame.member(frame.foot(-0.5, 0, 0, fixed), frame.foot(0.5, 0, 0, fixed));
    const int b1 = frame.node(middle - 0.5 * d), b2 = frame.node(middle + 0.5 * d);
    frame.member(b1, b2);
    for (int b : {b1, b2}) frame.model->set_velocity(b, {0, 0, -speed}, Vec3::Zero());
}

inline ContactRule surface(double friction = 0) {
    return {.settings = {.rule = contact::ContactRuleKind::surface, .friction = friction}};
}
/// Breaks where an element is bent by that much, 1/m, about either axis.
inline FractureRule bent_by(double curvature) { return {{.curvature_x = curvature, .curvature_y = curvature}}; }

// ---- runs -----------------------------------------------------------------------------------------------------------

inline std::unique_ptr<Statics> statics(const std::shared_ptr<const Structure>& structure,
                                        StaticSettings settings = {}) {
    auto run = std::make_unique<Statics>(structure, initial_state(*structure), settings);
    while (run->advance()) {}
    return run;
}
inline Dynamics dynamics(const std::shared_ptr<const Structure>& structure, const DynamicSettings& settings) {
    return Dynamics(structure, initial_state(*structure), settings);
}
/// Runs to the end of the duration; a run that does not come there fails the test.
inline void complete(Run& run) {
    while (run.advance()) {}
    INFO(run.reason());
    REQUIRE(run.verdict() == Verdict::completed);
}

/// Displacement control: the load factor where `component` of `node` has reached `value`, in that many steps.
inline StaticSettings driven(int node, int component, double value, int steps) {
    return {.steps = steps, .control = Control::displacement, .node = node, .component = component, .target = value};
}

/// Stiffness or mass of the free degrees of freedom as a dense matrix, put together from the engine's element matrices.
inline Eigen::MatrixXd dense(const Structure& structure, double mass_factor, double stiffness_factor,
                             std::vector<int>* free_components = nullptr) {
    const State state = initial_state(structure);
    ThreadPool alone;
    EffectiveStiffness op(structure, alone, mass_factor, stiffness_factor, false, MatrixStorage::direct);
    const int n = 6 * int(structure.position().size());
    Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(n, n);
    for (std::size_t i = 0; i < structure.elements().size(); ++i) {
        const Element& e = structure.elements()[i];
        const Mat12 part = op.part(int(i), state, state, {}).A;
        for (int a = 0; a < 2; ++a)
            for (int b = 0; b < 2; ++b)
                whole.block<6, 6>(6 * e.node[a], 6 * e.node[b]) += part.block<6, 6>(6 * a, 6 * b);
    }
    std::vector<int> free;
    for (int i = 0; i < n; ++i)
        if (!(state.held[i / 6] >> (i % 6) & 1)) free.push_back(i);
    if (free_components) *free_components = free;
    return whole(free, free);
}

/// Breaks `element` at `end` (1 or 2) in a state by itself, as a run does it at the end of a step.
inline BreakReport break_element(const Structure& structure, State& state, int element, int end) {
    std::vector<Vec6> impulse(structure.position().size(), Vec6::Zero());
    BreakReport report = break_off(structure, state, element, end, impulse);
    Mass mass(structure, state);
    report.kinetic += pass_on(state, mass, impulse);
    return report;
}

/// How far momenta have changed, as parts of what they were.
inline double linear_change(const Momentum& from, const Momentum& to) {
    return (to.linear - from.linear).norm() / from.linear.norm();
}
inline double angular_change(const Momentum& from, const Momentum& to) {
    return (to.angular - from.angular).norm() / from.angular.norm();
}
inline double momentum_change(const Momentum& from, const Momentum& to) {
    return largest_of(off(to.mass, from.mass), linear_change(from, to), angular_change(from, to));
}

/// Runs a body's free flight to its end: the largest deviations, as parts of what there was at the start.
struct Flight {
    double energy = 0, linear = 0, angular = 0;
};
inline Flight worst_of_flight(Dynamics& run) {
    const Momentum before = momentum(run.structure(), run.state());
    Flight worst;
    while (run.advance()) {
        if (run.steps_done() % 10) continue;
        const Energy e = run.energy();
        const Momentum now = momentum(run.structure(), run.state());
        worst.energy = largest_of(worst.energy, std::abs(e.error) / e.initial);
        worst.linear = largest_of(worst.linear, linear_change(before, now));
        worst.angular = largest_of(worst.angular, angular_change(before, now));
    }
    complete(run);
    return worst;
}

}  // namespace hinge::test
