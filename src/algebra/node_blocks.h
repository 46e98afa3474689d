// Blocks of one node or of two that effects add to the left side of eq 15.
#pragma once

#include <cstdint>
#include <vector>

#include "core/types.h"

namespace hinge {

/// Damping in proportion to an element's matrices, C = of_mass M + of_stiffness K; 1/s, s. `of_joints`: that of K of
/// joints and connectors at its nodes.
struct ElementDamping {
    double of_mass = 0, of_stiffness = 0, of_joints = 0;
};

/// Stiffness, 12x12, that an effect adds between two nodes.
struct Coupling {
    int a, b;
    Mat12 K;
    /// It joins the translations of the two nodes alone.
    bool is_light() const {
        return K.block<3, 3>(0, 9).isZero(0) && K.block<3, 6>(3, 6).isZero(0) && K.block<3, 3>(6, 3).isZero(0) &&
               K.block<3, 6>(9, 0).isZero(0);
    }
    template <class Self, class A>
    static void fields(Self& s, A& archive) {
        archive(s.a, s.b, s.K);
    }
};

/// An element's part of the effective stiffness, order [u1 t1 u2 t2], and the block between the two outer ends of its
/// pair: row of its own end, column of its partner's; zero without a pair.
struct ElementPart {
    Mat12 A;
    Mat6 bridge;
};

/// Stiffness of a joint that has reached its strength: what its curve has at the rotation, which rounding decides where
/// a step ends (the tangent of a step, renewed as it is iterated); that of unloading, elastic; or that of going on.
enum class Yielded : std::uint8_t { at_rotation, unloads, goes_on };

/// Blocks of effects in the left side, (1 - alpha) M + gamma dt C + beta dt^2 K in dynamics, K in statics.
class Blocks {
public:
    /// `of_damping`: gamma / (beta dt); 0 in statics, where nothing moves. Without stiffness: damping alone.
    explicit Blocks(double of_damping = 0, bool with_stiffness = true, Yielded as = Yielded::at_rotation)
        : yielded(as), of_damping_(of_damping), with_stiffness_(with_stiffness) {}
    /// Empties the lists, which keep their memory.
    void begin(double of_damping) { pairs.clear(), nodes.clear(), of_damping_ = of_damping; }
    /// Adds d(force)/d(displacement) of two nodes, order [u1 t1 u2 t2], or of one to ground; N/m, N, N m.
    void stiffness(int a, int b, const Mat12& K) {
        if (with_stiffness_) pairs.push_back({a, b, K});
    }
    void stiffness(int node, const Mat6& K) {
        if (with_stiffness_) nodes.push_back({node, K});
    }
    /// Adds d(force)/d(velocity), N s/m, N s, N m s.
    void damping(int a, int b, const Mat12& C) {
        if (of_damping_ != 0) pairs.push_back({a, b, of_damping_ * C});
    }
    void damping(int node, const Mat6& C) {
        if (of_damping_ != 0) nodes.push_back({node, of_damping_ * C});
    }

    struct Node {
        int node;
        Mat6 K;
        template <class Self, class A>
        static void fields(Self& s, A& a) {
            a(s.node, s.K);
        }
    };
    std::vector<Coupling> pairs;
    std::vector<Node> nodes;
    Yielded yielded;

private:
    double of_damping_;
    bool with_stiffness_;
};

}  // namespace hinge
