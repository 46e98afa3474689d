#include "contact/surface_contact.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/rotation.h"

namespace hinge::contact {

namespace {

/// A direction in the space of the four ends' nodes: how a length changes with their translations and rotations.
using Row = std::array<Vec6, 4>;

double share(int end, const double at[2]) {
    const double x = at[end / 2];
    return end % 2 == 0 ? 1 - x : x;
}

Vec3 arm_of(const End& end, const std::vector<Quat>& rotation) { return rotation[end.node] * end.arm; }

// Which part of the way from axis to axis lies in this end's bar.
double depth_share(const SurfaceContact& touch, int end) {
    return touch.radius[end / 2] / (touch.radius[0] + touch.radius[1]);
}

// How n . (q - p) changes.
Row normal_row(const SurfaceContact& touch, const std::vector<Quat>& rotation) {
    Row row;
    for (int i = 0; i < 4; ++i) {
        const Vec3 f = (i < 2 ? -1 : 1) * share(i, touch.at) * touch.side;
        row[i] << f, arm_of(touch.end[i], rotation).cross(f);
    }
    return row;
}

// How the touching points of the two surfaces shift along `direction`.
Row slip_row(const SurfaceContact& touch, const std::vector<Quat>& rotation, const Vec3& direction) {
    Row row;
    for (int i = 0; i < 4; ++i) {
        const double part = share(i, touch.at_before);
        const Vec3 f = (i < 2 ? -part : part) * direction;
        row[i] << f,
            arm_of(touch.end[i], rotation).cross(f) - part * depth_share(touch, i) * touch.between.cross(direction);
    }
    return row;
}

void points_of(const SurfaceContact& touch, const std::vector<Vec3>& position, const std::vector<Quat>& rotation,
               Vec3 (&point)[4]) {
    for (int i = 0; i < 4; ++i) point[i] = position[touch.end[i].node] + arm_of(touch.end[i], rotation);
}

Vec3 between_points(const Vec3 (&point)[4], const double at[2]) {
    return (1 - at[1]) * point[2] + at[1] * point[3] - (1 - at[0]) * point[0] - at[0] * point[1];
}

void add_row(const SurfaceContact& touch, const Row& row, double factor, std::vector<Vec6>& into) {
    for (int i = 0; i < 4; ++i) into[touch.end[i].node] += factor * row[i];
}

}  // namespace

double surface_stiffness(double ea_a, double ea_b, double length, double depths) {
    return 2 * ea_a * ea_b / (ea_a + ea_b) / std::max(length, depths);
}

double signed_distance(const Vec3 (&point)[4], Closest& closest, Vec3& side) {
    closest = closest_points(point[0], point[1], point[2], point[3]);
    if (closest.kind == Nearness::crossing) {
        Vec3 normal = (point[1] - point[0]).cross(point[3] - point[2]).normalized();
        if (normal.dot(side) < 0) normal = -normal;
        side = normal;
        return closest.between.dot(normal);
    }
    if (closest.distance < 1e-9 * ((point[1] - point[0]).norm() + (point[3] - point[2]).norm())) return 0;
    const Vec3 direction = closest.between / closest.distance;
    const bool passed = direction.dot(side) < 0;
    side = passed ? Vec3(-direction) : direction;
    return passed ? -closest.distance : closest.distance;
}

void look(SurfaceContact& touch, const std::vector<Vec3>& position, const std::vector<Quat>& rotation) {
    Vec3 point[4];
    points_of(touch, position, rotation, point);
    Closest closest;
    touch.side = touch.side_before;
    const double depths = touch.radius[0] + touch.radius[1], k = touch.stiffness;
    touch.overlap = depths - signed_distance(point, closest, touch.side);
    touch.at[0] = closest.s;
    touch.at[1] = closest.t;
    touch.energy = touch.overlap > 0 ? 0.5 * k * touch.overlap * touch.overlap : 0;
    if (touch.friction == 0) return;

    // how far the two surfaces have moved past each other since the step began
    touch.between = between_points(point, touch.at_before);
    Vec3 moved = Vec3::Zero();
    if (touch.overlap_before > 0) {
        Vec3 turn = Vec3::Zero();
        for (int i = 0; i < 4; ++i)
            turn += share(i, touch.at_before) * depth_share(touch, i) *
                    rotation_vector(rotation[touch.end[i].node] * touch.turn_before[i].conjugate());
        moved = touch.between - touch.between_before - turn.cross(touch.between);
    }
    Vec3 trial = touch.slip_before + moved;
    trial -= trial.dot(touch.side) * touch.side;
    const double length = trial.norm(), most = touch.friction * std::max(0.0, touch.overlap);
    touch.slides = length > most;
    touch.slip = touch.slides ? Vec3(most / length * trial) : trial;
    // the step moved the surfaces against the mean of the forces at its two ends
    const double stored = 0.5 * k * touch.slip.squaredNorm();
    touch.heat =
        0.5 * k * (touch.slip + touch.slip_before).dot(moved) + 0.5 * k * touch.slip_before.squaredNorm() - stored;
    touch.energy += stored;
}

void add_contact_forces(const SurfaceContact& touch, const std::vector<Quat>& rotation, std::vector<Vec6>& force) {
    if (touch.overlap <= 0) return;
    add_row(touch, normal_row(touch, rotation), -touch.stiffness * touch.overlap, force);
    const double stretch = touch.slip.norm();
    if (stretch > 0) add_row(touch, slip_row(touch, rotation, touch.slip / stretch), touch.stiffness * stretch, force);
}

void add_contact_stiffness(const SurfaceContact& now, const std::vector<Quat>& rotation, const AddStiffness& add) {
    if (now.overlap <= 0) return;
    std::vector<Row> rows{normal_row(now, rotation)};
    if (now.friction > 0 && !now.slides) {
        const Vec3 across = now.side.unitOrthogonal();
        rows.push_back(slip_row(now, rotation, across));
        rows.push_back(slip_row(now, rotation, now.side.cross(across)));
    }

    // ends that hang on one node are one; a node's own block goes with its first pair
    int nodes[4], count = 0, place[4];
    for (int i = 0; i < 4; ++i) {
        place[i] = int(std::find(nodes, nodes + count, now.end[i].node) - nodes);
        if (place[i] == count) nodes[count++] = now.end[i].node;
    }
    for (Row& row : rows) {
        Row summed;
        for (Vec6& v : summed) v.setZero();
        for (int i = 0; i < 4; ++i) summed[place[i]] += row[i];
        row = summed;
    }
    bool own_done[4] = {};
    for (int i = 0; i < count; ++i)
        for (int j = i + 1; j < count; ++j) {
            Mat12 K = Mat12::Zero();
            for (const Row& row : rows) {
                K.block<6, 6>(0, 6) += row[i] * row[j].transpose();
                if (!own_done[i]) K.block<6, 6>(0, 0) += row[i] * row[i].transpose();
                if (!own_done[j]) K.block<6, 6>(6, 6) += row[j] * row[j].transpose();
            }
            K.block<6, 6>(6, 0) = K.block<6, 6>(0, 6).transpose();
            own_done[i] = own_done[j] = true;
            add(nodes[i], nodes[j], now.stiffness * K);
        }
}

void settle(SurfaceContact& touch, const std::vector<Vec3>& position, const std::vector<Quat>& rotation) {
    touch.overlap_before = touch.overlap;
    touch.side_before = touch.side;
    if (touch.friction == 0) return;
    Vec3 point[4];
    points_of(touch, position, rotation, point);
    std::copy(touch.at, touch.at + 2, touch.at_before);
    touch.between_before = touch.between = between_points(point, touch.at);
    touch.slip_before = touch.slip;
    for (int i = 0; i < 4; ++i) touch.turn_before[i] = rotation[touch.end[i].node];
}

double missed_impulse(const SurfaceContact& touch, double dt, const std::vector<Quat>& rotation,
                      std::vector<Vec6>& impulse) {
    const double before = touch.overlap_before, now = touch.overlap;
    if ((before > 0) == (now > 0)) return 0;
    const double most = std::max(before, now), least = std::min(before, now);
    const double missing =
        0.5 * dt * touch.stiffness * most * least / (most - least);  // towards each other: least <= 0
    add_row(touch, normal_row(touch, rotation), missing, impulse);
    return missing * (before - now) / dt;
}

}  // namespace hinge::contact
