// What a step solves with: M by itself, the operator by conjugate gradients, the pool of threads. Each against dense
// matrices or the same thing done by one.
#include <Eigen/Cholesky>
#include <numeric>

#include "beam/element_mass.h"
#include "helpers.h"
#include "state/breaking.h"

using namespace hinge;
using namespace hinge::test;

namespace {

/// A triangle of members of 3, 2 and 1 elements on a post of 4, with an arm of 2 and one of 1 that end free. Node 1 may
/// not move along x nor rotate about z; the post's foot is held.
struct Odd : Frame {
    int corner[3], foot, free_end[2];
    Odd() : Frame({.formulation = Formulation::asi}) {
        corner[0] = node(0, 0, 1);
        corner[1] = Frame::foot(1, 0.2, 1, 0b100001);
        corner[2] = node(0.3, 0.9, 1.2);
        foot = Frame::foot(0, 0, 0);
        free_end[0] = node(-0.8, 0.1, 1.1);
        free_end[1] = node(0.4, 1.6, 1.0);
        const std::tuple<int, int, int> members[] = {{corner[0], corner[1], 3},   {corner[1], corner[2], 2},
                                                     {corner[2], corner[0], 1},   {foot, corner[0], 4},
                                                     {corner[0], free_end[0], 2}, {corner[2], free_end[1], 1}};
        for (const auto& [a, b, count] : members) elements = count, member(a, b);
    }
};

/// Each degree of freedom measured by the square root of A's diagonal: N and N m are alike then.
double scaled_norm(const Eigen::VectorXd& v, const Eigen::MatrixXd& A) {
    return (v.array() / A.diagonal().array().sqrt()).matrix().norm();
}

std::vector<int> free_degrees_of_freedom(const std::vector<std::uint8_t>& held) {
    std::vector<int> free;
    for (int i = 0; i < 6 * int(held.size()); ++i)
        if (!(held[i / 6] >> (i % 6) & 1)) free.push_back(i);
    return free;
}

Eigen::VectorXd flat(const std::vector<Vec6>& v) {
    Eigen::VectorXd out(6 * v.size());
    for (std::size_t i = 0; i < v.size(); ++i) out.segment<6>(6 * i) = v[i];
    return out;
}

std::vector<int> all_elements(const Structure& structure) {
    std::vector<int> all(structure.elements().size());
    std::iota(all.begin(), all.end(), 0);
    return all;
}

// ---- M

/// A straight lumped element of which one of its pair is broken, whole or not, at one of its nodes: that of a rigid bar
/// there (`other`: 0), or what Radau's points leave on its outer node (1) and on its inner one (2), `span` from it.
Mat6 of_broken_pair(const Element& e, const Vec3& span, int what) {
    const double m = e.mass(), polar = e.length * (e.rigidity.rhoIx + e.rigidity.rhoIy);
    const Mat3 square = span.squaredNorm() * Mat3::Identity() - span * span.transpose(), one = Mat3::Identity();
    if (what == 1) return beam::offset_mass_matrix(m / 4, Vec3::Zero(), polar / 2 * one);
    if (what == 2) return beam::offset_mass_matrix(0.75 * m, m / 4 * span, polar / 2 * one + m / 12 * square);
    return beam::offset_mass_matrix(m, m / 2 * span, polar * one + m / 3 * square);
}

/// M of all nodes as a dense matrix, of a structure that has been rotated by Q as a whole; `end[e]`: 0, or where e is
/// broken.
Eigen::MatrixXd dense_mass(const Structure& structure, const Quat& Q, const std::vector<int>& end) {
    Eigen::MatrixXd M = Eigen::MatrixXd::Zero(6 * structure.position().size(), 6 * structure.position().size());
    for (std::size_t i = 0; i < structure.elements().size(); ++i) {
        const Element& e = structure.elements()[i];
        const Mat3 axes = (Q * e.axes).toRotationMatrix();
        if (end[i]) {
            const int carrier = e.node[end[i] == 2 ? 0 : 1];
            const Vec3 span = (end[i] == 2 ? 1 : -1) * (Q * e.chord);
            const beam::RigidOffset s = beam::rigid_offset(e.rigidity, span, axes);
            Mat6 bar = beam::offset_mass_matrix(s.mass, s.moment, s.inertia);
            if (structure.lumped() && e.partner >= 0) bar = of_broken_pair(e, span, 0);
            else if (structure.lumped()) {  // its two lumps
                const Mat12 m = structure.inertia(int(i)).matrix(axes);
                const int far = end[i] == 2 ? 6 : 0;
                Mat6 follow = Mat6::Identity();
                follow.topRightCorner<3, 3>() = -skew(span);
                bar = m.block<6, 6>(6 - far, 6 - far) + follow.transpose() * m.block<6, 6>(far, far) * follow;
            }
            M.block<6, 6>(6 * carrier, 6 * carrier) += bar;
            continue;
        }
        if (structure.lumped() && e.partner >= 0 && end[e.partner]) {
            const int inner = int(i) < e.partner ? 1 : 0;
            const Vec3 span = (inner == 0 ? 1 : -1) * (Q * e.chord);
            for (int a : {0, 1})
                M.block<6, 6>(6 * e.node[a], 6 * e.node[a]) += of_broken_pair(e, span, a == inner ? 2 : 1);
            continue;
        }
        const Mat12 m = structure.inertia(int(i)).matrix(axes);
        for (int a : {0, 1})
            for (int b : {0, 1}) M.block<6, 6>(6 * e.node[a], 6 * e.node[b]) += m.block<6, 6>(6 * a, 6 * b);
    }
    return M;
}

/// The structure at rest, rotated by Q about the origin.
State rotated_state(const Structure& structure, const Quat& Q) {
    State state = initial_state(structure);
    for (std::size_t i = 0; i < state.displacement.size(); ++i) {
        state.displacement[i] = Q * structure.position()[i] - structure.position()[i];
        state.rotation[i] = Q;
    }
    return state;
}

/// Nothing is left where a degree of freedom is held.
void check_held(const std::vector<Vec6>& x, const State& state) {
    for (std::size_t i = 0; i < x.size(); ++i)
        for (int c = 0; c < 6; ++c)
            if (state.held[i] >> c & 1) CHECK(x[i][c] == 0);
}

double mass_error(const Structure& structure, const State& state, Mass& mass, const Eigen::MatrixXd& M, unsigned seed) {
    Dice dice(seed);
    std::vector<Vec6> b(structure.position().size()), x;
    for (Vec6& v : b) v << dice.vector(100), dice.vector(0.1);
    mass.solve(b, x, state, 1e-13);
    const std::vector<int> free = free_degrees_of_freedom(state.held);
    const Eigen::MatrixXd part = M(free, free);
    const Eigen::VectorXd all = flat(x), right = flat(b)(free);
    check_held(x, state);
    return scaled_norm(part * all(free) - right, part) / scaled_norm(right, part);
}

// ---- the operator

Mat12 spring(Dice& dice, double size) {  // semidefinite: of rank 9
    Eigen::Matrix<double, 12, 9> F;
    for (int i = 0; i < F.size(); ++i) F.data()[i] = dice(-1, 1);
    for (int i = 0; i < 12; ++i)
        if (i % 6 > 2) F.row(i) *= 0.02;  // m: moments are smaller than forces
    return size * F * F.transpose();
}

/// Everything that A is made of, put together densely.
struct Dense {
    Eigen::MatrixXd A;
    std::vector<int> free;
    Dense(const Structure& structure, const State& state, double k, const std::vector<Coupling>& couplings,
          const std::vector<int>& removed, int offset_node, const Mat6& offset) {
        ThreadPool alone;
        EffectiveStiffness parts(structure, alone, 1, k, false, MatrixStorage::direct);
        const int n = 6 * int(structure.position().size());
        A = Eigen::MatrixXd::Zero(n, n);
        const auto add = [&](int a, int b, const Mat12& m) {
            const int at[2] = {a, b};
            for (int i : {0, 1})
                for (int j : {0, 1}) A.block<6, 6>(6 * at[i], 6 * at[j]) += m.block<6, 6>(6 * i, 6 * j);
        };
        for (int i : all_elements(structure))
            if (std::find(removed.begin(), removed.end(), i) == removed.end())
                add(structure.elements()[i].node[0], structure.elements()[i].node[1],
                    parts.part(i, state, state, {}).A);
        for (const Coupling& c : couplings) add(c.a, c.b, k * c.K);
        if (offset_node >= 0) A.block<6, 6>(6 * offset_node, 6 * offset_node) += offset;
        free = free_degrees_of_freedom(state.held);
    }
    /// |x - A^-1 b| in the norm of A, relative.
    double error(const std::vector<Vec6>& b, const std::vector<Vec6>& x) const {
        const Eigen::MatrixXd part = A(free, free);
        const Eigen::VectorXd right = flat(b), got = flat(x), exact = part.ldlt().solve(Eigen::VectorXd(right(free)));
        const Eigen::VectorXd e = got(free) - exact;
        return std::sqrt(e.dot(part * e) / exact.dot(part * exact));
    }
};

std::vector<Vec6> right_side(const State& state, unsigned seed) {
    Dice dice(seed);
    std::vector<Vec6> b(state.held.size());
    for (std::size_t i = 0; i < b.size(); ++i) {
        b[i] << dice.vector(1000), dice.vector(20);
        for (int c = 0; c < 6; ++c)
            if (state.held[i] >> c & 1) b[i][c] = 0;
    }
    return b;
}

SolverSettings tight() { return {.tolerance = 1e-12}; }

std::vector<Vec6> answer(EffectiveStiffness& op, const std::vector<Vec6>& b) {
    std::vector<Vec6> x(b.size(), Vec6::Constant(7));  // what was there before must not matter
    op.assemble();
    CHECK(op.solve(b, x, tight()).converged);
    return x;
}

// beta dt^2 of 10 us, in which an axial wave comes a part of the way through an element, so that inertia rules; and of
// 1 ms
constexpr double short_step = 0.25 * 1e-5 * 1e-5, long_step = 0.25 * 1e-3 * 1e-3;

struct Way {
    MatrixStorage keeping;
    double k, limit;
    const char* name;
};
// single precision: 6e-8 of each entry, and not much more of the answer where inertia rules A
constexpr Way ways[] = {{MatrixStorage::iterative, short_step, 1e-9, "double, short step"},
                        {MatrixStorage::iterative, long_step, 1e-9, "double, long step"},
                        {MatrixStorage::single_precision, short_step, 1e-6, "single, short step"}};

struct Solving {
    Odd frame;
    std::shared_ptr<const Structure> structure = frame.build();
    State state = initial_state(*structure);
    ThreadPool pool{1};
    Dice dice{31};
    int inner(int i) const { return 6 + i; }  // the declared nodes come first
    std::unique_ptr<EffectiveStiffness> fresh(const Way& way) {
        auto op = std::make_unique<EffectiveStiffness>(*structure, pool, 1, way.k, false, way.keeping);
        op->build(all_elements(*structure), state, state, {});
        return op;
    }
};

}  // namespace

// 1e-10: its tolerance is 1e-13.
TEST_CASE("solver: M by itself is undone, of both kinds, with offset masses and held degrees of freedom") {
    for (MassKind kind : {MassKind::consistent, MassKind::lumped}) {
        const std::string name = kind == MassKind::lumped ? "lumped" : "consistent";
        const Odd frame;
        const Structure structure(frame.model, kind);
        const Quat Q(Eigen::AngleAxisd(0.7, Vec3(1, -2, 0.5).normalized()));
        State state = rotated_state(structure, Q);
        std::vector<int> end(structure.elements().size(), 0);
        Mass mass(structure, state);
        CHECK_FIGURE(name + " M, whole", mass_error(structure, state, mass, dense_mass(structure, Q, end), 1), 1e-10);

        // offset masses on a joint, on an inner node, and on the node that is held in part
        int at_joint = -1, at_partly_held = -1, inside = -1;
        for (int i : all_elements(structure)) {
            const Element& e = structure.elements()[i];
            if (e.node[0] == frame.corner[2] || e.node[1] == frame.corner[2]) at_joint = i;
            if (e.node[0] == frame.corner[1] && at_partly_held < 0) at_partly_held = i;
            if (e.node[0] >= 6 && e.node[1] >= 6 && inside < 0) inside = i;
        }
        REQUIRE(at_joint >= 0);
        REQUIRE(at_partly_held >= 0);
        REQUIRE(inside >= 0);
        const auto carried_by = [&](int element, int node) {
            return structure.elements()[element].node[0] == node ? 2 : 1;
        };
        const std::pair<int, int> breaks[] = {{at_joint, carried_by(at_joint, frame.corner[2])},
                                              {inside, 1},
                                              {at_partly_held, carried_by(at_partly_held, frame.corner[1])}};
        for (const auto& [element, where] : breaks) {
            break_element(structure, state, element, where);
            end[element] = where;
            const int partner = structure.elements()[element].partner;
            mass.renew(partner < 0 ? std::vector<int>{element} : std::vector<int>{element, partner}, state, state);
            const Eigen::MatrixXd M = dense_mass(structure, Q, end);
            CHECK_FIGURE(name + " M, element " + std::to_string(element) + " broken",
                         mass_error(structure, state, mass, M, 2), 1e-10);
            Mass anew(structure, state);
            CHECK_FIGURE(name + " M, made anew", mass_error(structure, state, anew, M, 3), 1e-10);
        }
        // the offset masses rotate with their nodes, and M with them
        const Quat other = Quat(Eigen::AngleAxisd(1.1, Vec3(0.3, 1, 1).normalized()));
        State turned = rotated_state(structure, other);
        turned.offset_mass = state.offset_mass;
        turned.broken = state.broken;
        turned.offset_arm = state.offset_arm;
        turned.held = state.held;
        if (kind == MassKind::lumped) {
            mass.rotate_offset_masses(turned, turned);
            CHECK_FIGURE("lumped M, offset masses rotated alone",
                         mass_error(structure, turned, mass, dense_mass(structure, other, end), 4), 1e-10);
        }
        mass.renew(all_elements(structure), turned, turned);
        CHECK_FIGURE(name + " M, all rotated",
                     mass_error(structure, turned, mass, dense_mass(structure, other, end), 5), 1e-10);
    }
}

TEST_CASE("solver: an offset mass is that of its element where that moves as a rigid body, of both kinds (rounding)") {
    const Odd frame;
    const Structure structure(frame.model);
    const Element& e = structure.elements()[1];
    const Mat3 axes = e.axes.toRotationMatrix();
    Eigen::Matrix<double, 12, 6> follow = Eigen::Matrix<double, 12, 6>::Zero();  // both nodes as the first one bids
    for (int i : {0, 6}) follow.block<6, 6>(i, 0).setIdentity();
    follow.block<3, 3>(6, 3) = -skew(e.chord);
    const Mat12 lumped = beam::lumped_inertia(e.rigidity, e.length, 0.3).matrix(axes);
    const Mat12 consistent = beam::linear_inertia(e.rigidity, e.length).matrix(axes);
    const std::tuple<const char*, Mat12, beam::RigidOffset> kinds[] = {
        {"consistent", consistent, beam::rigid_offset(e.rigidity, e.chord, axes)},
        {"lumped", lumped,
         beam::lumped_rigid_offset(lumped.topLeftCorner<6, 6>(), lumped.bottomRightCorner<6, 6>(), e.chord)}};
    for (const auto& [name, mass, rigid] : kinds) {
        const Mat6 element = follow.transpose() * mass * follow,
                   offset = beam::offset_mass_matrix(rigid.mass, rigid.moment, rigid.inertia);
        CHECK_FIGURE(std::string("offset mass, ") + name, (element - offset).norm() / element.norm(), 1e-14);
    }
}

TEST_CASE(
    "solver: the lumps of a member have its mass, centre and moment of inertia, with 1 to 12 elements (rounding)") {
    for (int n = 1; n <= 12; ++n) {
        Frame frame({.formulation = Formulation::asi});
        frame.elements = n;
        frame.member(frame.node(0, 0, 0), frame.node(1, 2, 2));
        const auto structure = std::make_shared<const Structure>(frame.model, MassKind::lumped);
        double mass = 0, first = 0, second = 0, whole = 0;
        for (const Element& e : structure->elements()) {
            whole += e.mass();
            for (int end : {0, 1}) {
                const double at = structure->position()[e.node[end]].norm() / 3, lump = e.inertia.own[end];
                CHECK(lump > 0.24 * e.mass());
                mass += lump, first += lump * at, second += lump * (at - 0.5) * (at - 0.5);
            }
        }
        const std::string name = std::to_string(n) + " elements: ";
        CHECK_FIGURE(name + "mass", std::abs(mass / whole - 1), 1e-14);
        CHECK_FIGURE(name + "centre", std::abs(2 * first / whole - 1), 1e-14);
        CHECK_FIGURE(name + "moment of inertia", std::abs(second / whole - (n == 1 ? 3 : 1) / 12.0), 1e-14);
    }
}

TEST_CASE("solver: the lumped inverse is the diagonal's, nothing where a degree of freedom is held (rounding)") {
    const Odd frame;
    const Structure structure(frame.model, MassKind::lumped);
    const State state = initial_state(structure);
    const Mass mass(structure, state);
    const Eigen::MatrixXd M = dense_mass(structure, Quat::Identity(), std::vector<int>(structure.elements().size(), 0));
    double worst = 0;
    for (int i = 0; i < M.rows(); ++i) {
        const double inverse = mass.lumped_inverse()[i / 6][i % 6];
        if (state.held[i / 6] >> (i % 6) & 1) CHECK(inverse == 0);
        else worst = largest_of(worst, std::abs(inverse * M(i, i) - 1));
    }
    CHECK_FIGURE("lumped inverse", worst, 1e-14);
}

// Limits of these three: `ways`.
TEST_CASE("solver: conjugate gradients give what dense factors give, on a frame with an odd cycle") {
    for (const Way& way : ways) {
        Solving s;
        auto op = s.fresh(way);
        const auto b = right_side(s.state, 5);
        const auto x = answer(*op, b);
        CHECK_FIGURE(std::string("no couplings, ") + way.name,
                     Dense(*s.structure, s.state, way.k, {}, {}, -1, {}).error(b, x), way.limit);
        check_held(x, s.state);
    }
}

TEST_CASE("solver: couplings between inner nodes and between joints, as they come, change and go") {
    for (const Way& way : ways) {
        Solving s;
        auto op = s.fresh(way);
        const auto b = right_side(s.state, 6);
        const double stiff = 2e8;  // N/m: that of a touch, which is as stiff as its softer element
        const std::vector<Vec6> before = answer(*op, b);
        const int joint = s.frame.corner[0], other = s.frame.corner[2], held_in_part = s.frame.corner[1];
        const std::vector<std::pair<const char*, std::vector<Coupling>>> sets = {
            {"two neighbours inside a member", {{s.inner(0), s.inner(1), spring(s.dice, stiff)}}},
            {"inner nodes of two members", {{s.inner(0), s.inner(4), spring(s.dice, stiff)}}},
            {"the same nodes, another spring", {{s.inner(0), s.inner(4), spring(s.dice, stiff)}}},
            {"two joints", {{joint, other, spring(s.dice, stiff)}}},
            {"a free end and a node held in part", {{s.frame.free_end[1], held_in_part, spring(s.dice, stiff)}}},
            {"all of them at once, two on one node",
             {{s.inner(1), s.inner(3), spring(s.dice, stiff)},
              {joint, other, spring(s.dice, stiff)},
              {joint, s.inner(6), spring(s.dice, stiff)},
              {s.frame.free_end[0], s.inner(5), spring(s.dice, stiff)}}},
            {"one of them left", {{joint, s.inner(6), spring(s.dice, stiff)}}},
        };
        for (const auto& [name, couplings] : sets) {
            op->set_couplings(couplings);
            const Dense all(*s.structure, s.state, way.k, couplings, {}, -1, {});
            const auto x = answer(*op, b);
            CHECK_FIGURE(std::string(name) + ", " + way.name, all.error(b, x), way.limit);
            CHECK(all.error(b, before) > 100 * way.limit);  // the coupling is felt
            auto fresh = s.fresh(way);
            fresh->set_couplings(couplings);
            CHECK(flat(answer(*fresh, b)) == flat(x));
        }
        op->set_couplings({});
        CHECK(flat(answer(*op, b)) == flat(before));
    }
}

TEST_CASE("solver: elements rebuilt, removed and attached while nodes are coupled") {
    for (const Way& way : ways) {
        Solving s;
        auto op = s.fresh(way);
        const auto b = right_side(s.state, 7);
        const std::vector<Coupling> couplings = {{s.inner(0), s.inner(4), spring(s.dice, 2e8)}};
        op->set_couplings(couplings);
        answer(*op, b);
        std::vector<int> removed;
        int inside = -1, last = -1;
        for (int i : all_elements(*s.structure)) {
            const Element& e = s.structure->elements()[i];
            if (e.node[0] == s.inner(0) || e.node[1] == s.inner(0)) inside = i;
            if (e.node[1] == s.frame.free_end[0] || e.node[0] == s.frame.free_end[0]) last = i;
        }
        REQUIRE(inside >= 0);
        REQUIRE(last >= 0);
        op->remove(inside);
        removed.push_back(inside);
        CHECK_FIGURE(std::string("removed beside a coupled node, ") + way.name,
                     Dense(*s.structure, s.state, way.k, couplings, removed, -1, {}).error(b, answer(*op, b)),
                     way.limit);
        op->set_couplings({});
        CHECK_FIGURE(std::string("coupling gone, ") + way.name,
                     Dense(*s.structure, s.state, way.k, {}, removed, -1, {}).error(b, answer(*op, b)), way.limit);

        // the last element of an arm breaks: an offset mass on the node before, and its end leaves the solve
        op->remove(last);
        removed.push_back(last);
        const Element& e = s.structure->elements()[last];
        const int at = e.node[1] == s.frame.free_end[0] ? 0 : 1, carrier = e.node[at];
        const beam::RigidOffset offset =
            beam::rigid_offset(e.rigidity, (at == 0 ? 1 : -1) * e.chord, e.axes.toRotationMatrix());
        const Mat6 attached = beam::offset_mass_matrix(offset.mass, offset.moment, offset.inertia);
        op->set_offset_mass(carrier, attached);
        s.state.held[s.frame.free_end[0]] = 63;
        op->set_held(s.state.held);
        const auto b2 = right_side(s.state, 8);
        const auto x = answer(*op, b2);
        CHECK(x[s.frame.free_end[0]].isZero(0));
        CHECK_FIGURE(std::string("an offset mass in its place, ") + way.name,
                     Dense(*s.structure, s.state, way.k, {}, removed, carrier, attached).error(b2, x), way.limit);
    }
}

TEST_CASE("solver: conjugate gradients give the same bits with any number of threads") {
    // long enough for several pieces of 256 rows in each colour
    Frame frame;
    std::vector<std::vector<int>> grid(40, std::vector<int>(40));
    for (int i = 0; i < 40; ++i)
        for (int j = 0; j < 40; ++j) grid[i][j] = i == 0 ? frame.foot(i, j, 0) : frame.node(i, j, 0);
    for (int i = 0; i < 40; ++i)
        for (int j = 0; j < 40; ++j) {
            if (i + 1 < 40) frame.member(grid[i][j], grid[i + 1][j]);
            if (j + 1 < 40) frame.member(grid[i][j], grid[i][j + 1]);
        }
    const auto structure = frame.build();
    const State state = initial_state(*structure);
    const auto b = right_side(state, 9);
    Dice dice(32);
    const std::vector<Coupling> couplings = {{grid[3][3], grid[20][20], spring(dice, 1e8)},
                                             {1700, 1900, spring(dice, 1e8)}};
    for (MatrixStorage keeping : {MatrixStorage::iterative, MatrixStorage::single_precision}) {
        Eigen::VectorXd first;
        for (int threads : {1, 2, 3}) {
            ThreadPool pool(threads);
            EffectiveStiffness op(*structure, pool, 1, short_step, false, keeping);
            op.build(all_elements(*structure), state, state, {});
            op.set_couplings(couplings);
            const Eigen::VectorXd x = flat(answer(op, b));
            if (threads == 1) first = x;
            CHECK(x == first);
        }
    }
}

TEST_CASE("solver: a matrix that is not positive definite is said to be so, with the nodes that make it so") {
    for (const Way& way : ways) {
        INFO(way.name);
        Solving s;
        const int joint = s.frame.corner[2], inside = s.inner(2);
        // each node's own block stays as it is; where one moves with the other, the force is a multiple of inertia's
        Mat12 K = Mat12::Zero();
        const double size = 1e4 * s.structure->elements()[0].mass() / way.k;
        K.topRightCorner<6, 6>() = K.bottomLeftCorner<6, 6>() = size * Mat6::Identity();
        Blocks between;
        between.stiffness(joint, inside, K);
        auto op = s.fresh(way);
        op->set_blocks(between);
        op->assemble();
        std::vector<Vec6> x(s.state.held.size());
        const SolveReport report = op->solve(right_side(s.state, 5), x, tight());
        CHECK(!report.converged);
        CHECK(report.indefinite);
        CHECK(report.iterations < tight().max_iterations);
        const EffectiveStiffness::Weakest weakest = op->weakest_part();
        CHECK((weakest.node == joint || weakest.node == inside));
        CHECK(weakest.node + weakest.other == joint + inside);
        CHECK(weakest.element == -1);
    }
}

TEST_CASE("solver: M by itself says where it finds no answer") {
    const Odd frame;
    const Structure structure(frame.model, MassKind::consistent);
    State state = initial_state(structure);
    Mass mass(structure, state);
    std::vector<Vec6> b = right_side(state, 5), x;
    CHECK(mass.solve(b, x, state, 1e-13).converged);
    b[0][0] = std::nan("");
    CHECK(!mass.solve(b, x, state, 1e-13).converged);
    std::vector<Vec6> impulse = right_side(state, 6);
    impulse[0][1] = std::nan("");
    const std::vector<Vec6> velocity = state.velocity;
    CHECK(std::isnan(pass_on(state, mass, impulse)));
    CHECK(state.velocity == velocity);
}
