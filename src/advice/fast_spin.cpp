// Free bodies that spin so fast that Newmark's method loses their angle. It follows a rotation in chords: with steps of
// omega dt radians it lags behind by about (omega dt)^2 / 12 of the angle, and by more where a body tumbles. The
// energy-momentum method (run/energy_momentum.h) keeps angular momentum and energy in steps of any length.
#include <Eigen/Eigenvalues>

#include "advice/adviser.h"
#include "core/text.h"
#include "effects/joined_bodies.h"
#include "run/dynamics.h"

namespace hinge {
namespace {

/// rad. A frame of 2 m that tumbles at 14 rad/s for 3.5 s in steps of 1 ms is at 7e-4 and 2 mm off; at 55 rad/s in
/// steps of 0.25 ms at 3e-3 and 44 mm; at 55 rad/s in steps of 1 ms its run fails before the end.
constexpr double most_lost = 2e-3;

/// Of the distance of a body from the origin: nodes no further apart stand at one place, but for rounding.
constexpr double one_place = 1e-9;

/// A body's mean angular velocity, rad/s: its angular momentum over its inertia, with its mass at the nodes. About the
/// axis of a straight bar, where its nodes have no inertia, and of a body whose mass is at one node: zero.
class Spin {
public:
    void add_mass(double m, const Vec3& x, const Vec3& v) { mass_ += m, at_ += m * x, momentum_ += m * v; }
    void add_inertia(double m, const Vec3& x, const Vec3& v) {
        const Vec3 r = x - at_ / mass_;
        angular_ += m * r.cross(v - momentum_ / mass_);
        inertia_ += m * (r.squaredNorm() * Mat3::Identity() - r * r.transpose());
    }
    double size() const {
        const Eigen::SelfAdjointEigenSolver<Mat3> axes(inertia_);
        const Vec3 along = axes.eigenvectors().transpose() * angular_;
        double square = 0;
        const double least = std::max(1e-6 * axes.eigenvalues()[2], (one_place * at_).squaredNorm() / mass_);
        for (int c : {0, 1, 2})
            if (axes.eigenvalues()[c] > least) square += std::pow(along[c] / axes.eigenvalues()[c], 2);
        return std::sqrt(square);
    }

private:
    double mass_ = 0;
    Vec3 at_ = Vec3::Zero(), momentum_ = Vec3::Zero(), angular_ = Vec3::Zero();
    Mat3 inertia_ = Mat3::Zero();
};

class FastSpin : public Adviser {
public:
    explicit FastSpin(WarningLog& log) : log_(log) {}
    void after_step(const Run& run) override {
        if (is_time_to_check(run)) add_lost(run.structure(), run.state(), static_cast<const Dynamics&>(run).dt());
    }
    void save(Writer& to) const override { to(told_, asked_, lost_, turned_, last_); }
    void restore(Reader& from) override { from(told_, asked_, lost_, turned_, last_); }

private:
    void add_lost(const Structure& structure, const State& state, double dt);

    WarningLog& log_;
    bool told_ = false, asked_ = false;
    double lost_ = 0, turned_ = 0;  ///< rad
    double last_ = 0;               ///< s
};

/// Adds what has been lost since the last time, of the fastest of the bodies that no support holds. `dt`: s, of the
/// steps since then.
void FastSpin::add_lost(const Structure& structure, const State& state, double dt) {
    const double since = asked_ ? state.time - last_ : 0;
    asked_ = true, last_ = state.time;
    if (told_ || !(since > 0)) return;
    const Bodies bodies = joined_bodies(structure, state);
    std::vector<char> free(bodies.count, 1);
    for (std::size_t n = 0; n < bodies.of_node.size(); ++n)
        if (bodies.of_node[n] >= 0 && state.held[n]) free[bodies.of_node[n]] = 0;
    std::vector<Spin> spins(bodies.count);
    const auto for_each_mass = [&](auto add) {
        for (std::size_t i = 0; i < structure.elements().size(); ++i) {
            const Element& e = structure.elements()[i];
            const int body = bodies.of_node[e.node[0]];
            if (state.broken[i] || body < 0 || !free[body]) continue;
            const double half = 0.5 * e.mass();
            for (const int node : e.node) add(body, half, node);
        }
        for (std::size_t n = 0; n < state.offset_mass.size(); ++n)
            if (const int body = bodies.of_node[n]; state.offset_mass[n].mass > 0 && body >= 0 && free[body])
                add(body, state.offset_mass[n].mass, int(n));
    };
    const auto x = [&](int node) { return Vec3(structure.position()[node] + state.displacement[node]); };
    const auto v = [&](int node) { return Vec3(state.velocity[node].head<3>()); };
    for_each_mass([&](int body, double m, int node) { spins[body].add_mass(m, x(node), v(node)); });
    for_each_mass([&](int body, double m, int node) { spins[body].add_inertia(m, x(node), v(node)); });
    double fastest = 0;
    int at = -1;
    for (int i = 0; i < bodies.count; ++i)
        if (const double spin = free[i] ? spins[i].size() : 0; spin > fastest) fastest = spin, at = i;
    turned_ += fastest * since;
    lost_ += std::pow(fastest * dt, 2) / 12 * fastest * since;
    if (at < 0 || !(lost_ > most_lost)) return;
    told_ = true;
    int member = -1;  // of a node that is left alone: that of the offset mass
    for (std::size_t i = 0; i < structure.elements().size() && member < 0; ++i) {
        const Element& e = structure.elements()[i];
        if (bodies.of_node[e.node[state.broken[i] == 1 ? 1 : 0]] == at) member = e.member;
    }
    log_.add({Warning::Kind::time_step,
              "the free body of member " + std::to_string(member + 1) + " spins at " + number_text(fastest, 3) +
                  " rad/s at t = " + number_text(state.time, 4) + " s, by " + number_text(fastest * dt, 2) +
                  " rad a step; over " + number_text(turned_, 3) +
                  " rad of rotation so far Newmark's method has lost about " + number_text(lost_, 2) +
                  " rad, and more where a body tumbles",
              "give integrator = \"energy-momentum\", or a shorter dt, where the place of that body matters",
              line_of_member(structure.model(), member)});
}

}  // namespace

std::unique_ptr<Adviser> advise_of_spin(const Run& run, WarningLog& log) {
    const auto* dynamics = run.dynamics();
    if (!dynamics || dynamics->explicit_steps() || dynamics->settings().conserving || !run.structure().large())
        return nullptr;
    return std::make_unique<FastSpin>(log);
}

}  // namespace hinge
