#include "contact/surface_contact.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/rotation.h"

namespace hinge::contact {

namespace {

double share(int end, const double at[2]) {
    const double x = at[end / 2];
    return end % 2 == 0 ? 1 - x : x;
}

Vec3 arm_of(const End& end, const std::vector<Quat>& rotation) { return rotation[end.node] * end.arm; }

// Which part of the way from axis to axis lies in this end's bar.
double depth_share(const SurfaceContact& contact, int end) {
    return contact.radius[end / 2] / (contact.radius[0] + contact.radius[1]);
}

void points_of(const SurfaceContact& contact, const std::vector<Vec3>& position, const std::vector<Quat>& rotation,
               Vec3 (&point)[4]) {
    for (int i = 0; i < 4; ++i) point[i] = position[contact.end[i].node] + arm_of(contact.end[i], rotation);
}

Vec3 between_points(const Vec3 (&point)[4], const double at[2]) {
    return (1 - at[1]) * point[2] + at[1] * point[3] - (1 - at[0]) * point[0] - at[0] * point[1];
}

}  // namespace

Row normal_row(const SurfaceContact& contact, const std::vector<Quat>& rotation) {
    Row row;
    for (int i = 0; i < 4; ++i) {
        const Vec3 f = (i < 2 ? -1 : 1) * share(i, contact.at) * contact.normal;
        row[i] << f, arm_of(contact.end[i], rotation).cross(f);
    }
    return row;
}

Row slip_row(const SurfaceContact& contact, const std::vector<Quat>& rotation, const Vec3& direction) {
    Row row;
    for (int i = 0; i < 4; ++i) {
        const double part = share(i, contact.at_before);
        const Vec3 f = (i < 2 ? -part : part) * direction;
        row[i] << f, arm_of(contact.end[i], rotation).cross(f) -
                         part * depth_share(contact, i) * contact.between.cross(direction);
    }
    return row;
}

void add_row(const SurfaceContact& contact, const Row& row, double factor, std::vector<Vec6>& into) {
    for (int i = 0; i < 4; ++i) into[contact.end[i].node] += factor * row[i];
}

double surface_stiffness(double ea_a, double ea_b, double length, double depths) {
    return 2 * ea_a * ea_b / (ea_a + ea_b) / std::max(length, depths);
}

double signed_distance(const Vec3 (&point)[4], Closest& closest, Vec3& normal) {
    closest = closest_points(point[0], point[1], point[2], point[3]);
    if (closest.kind == Nearness::crossing) {
        const Vec3 across = (point[1] - point[0]).cross(point[3] - point[2]).normalized();
        normal = across.dot(normal) < 0 ? Vec3(-across) : across;
        return closest.between.dot(normal);
    }
    if (closest.distance < 1e-9 * ((point[1] - point[0]).norm() + (point[3] - point[2]).norm())) return 0;
    const Vec3 direction = closest.between / closest.distance;
    const bool passed = direction.dot(normal) < 0;
    normal = passed ? Vec3(-direction) : direction;
    return passed ? -closest.distance : closest.distance;
}

void update(SurfaceContact& contact, const std::vector<Vec3>& position, const std::vector<Quat>& rotation) {
    measure_penetration(contact, position, rotation);
    contact.depth = std::max(0.0, contact.penetration);
    update_friction(contact, position, rotation);
}

void measure_penetration(SurfaceContact& contact, const std::vector<Vec3>& position,
                         const std::vector<Quat>& rotation) {
    Vec3 point[4];
    points_of(contact, position, rotation, point);
    Closest closest;
    contact.normal = contact.normal_before;
    const double depths = contact.radius[0] + contact.radius[1];
    contact.penetration = depths - contact.level - signed_distance(point, closest, contact.normal);
    contact.at[0] = closest.s;
    contact.at[1] = closest.t;
}

void update_friction(SurfaceContact& contact, const std::vector<Vec3>& position, const std::vector<Quat>& rotation) {
    const double k = contact.stiffness;
    contact.energy = contact.depth > 0 ? 0.5 * k * contact.depth * contact.penetration : 0;
    if (contact.friction == 0) return;

    // how far the two surfaces have moved past each other since the step began
    Vec3 point[4];
    points_of(contact, position, rotation, point);
    contact.between = between_points(point, contact.at_before);
    Vec3 moved = Vec3::Zero();
    if (contact.penetration_before > 0) {
        Vec3 rolled = Vec3::Zero();
        for (int i = 0; i < 4; ++i)
            rolled += share(i, contact.at_before) * depth_share(contact, i) *
                      rotation_vector(rotation[contact.end[i].node] * contact.rotation_before[i].conjugate());
        moved = contact.between - contact.between_before - rolled.cross(contact.between);
    }
    Vec3 trial = contact.slip_before + moved;
    trial -= trial.dot(contact.normal) * contact.normal;
    const double length = trial.norm(), part = contact.share;
    const double most = part > 0 ? contact.friction * contact.depth / part : length;
    contact.slides = length > most;
    contact.slip = contact.slides ? Vec3(most / length * trial) : trial;
    // the step moved the surfaces against the mean of the forces at its two ends
    const double stored = 0.5 * k * part * contact.slip.squaredNorm();
    const double work = 0.5 * k * part * (contact.slip + contact.slip_before).dot(moved);
    contact.heat =
        std::max(0.0, work + 0.5 * k * part * contact.slip_before.squaredNorm() - stored);  // else made: an error
    contact.energy += stored;
}

void add_contact_forces(const SurfaceContact& contact, const std::vector<Quat>& rotation, std::vector<Vec6>& force) {
    if (contact.depth > 0) add_row(contact, normal_row(contact, rotation), -contact.stiffness * contact.depth, force);
    const double stretch = contact.slip.norm();
    if (stretch > 0 && contact.share > 0)
        add_row(contact, slip_row(contact, rotation, contact.slip / stretch),
                contact.stiffness * contact.share * stretch, force);
}

void add_contact_stiffness(const SurfaceContact& now, const std::vector<Quat>& rotation, const AddStiffness& add) {
    if (now.depth <= 0) return;
    std::vector<Row> rows{normal_row(now, rotation)};
    if (now.friction > 0 && !now.slides) {
        const Vec3 across = now.normal.unitOrthogonal();
        rows.push_back(slip_row(now, rotation, across));
        rows.push_back(slip_row(now, rotation, now.normal.cross(across)));
    }

    // ends that follow one node are one; a node's own block goes with its first pair
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

void end_step(SurfaceContact& contact, const std::vector<Vec3>& position, const std::vector<Quat>& rotation) {
    contact.penetration_before = contact.penetration;
    contact.depth_before = contact.depth;
    contact.normal_before = contact.normal;
    if (contact.friction == 0) return;
    Vec3 point[4];
    points_of(contact, position, rotation, point);
    std::copy(contact.at, contact.at + 2, contact.at_before);
    contact.between_before = contact.between = between_points(point, contact.at);
    contact.slip_before = contact.slip;
    for (int i = 0; i < 4; ++i) contact.rotation_before[i] = rotation[contact.end[i].node];
}

double missed_impulse(const SurfaceContact& contact, double dt, const std::vector<Quat>& rotation,
                      std::vector<Vec6>& impulse) {
    const double before = contact.penetration_before, now = contact.penetration;
    if ((before > 0) == (now > 0)) return 0;
    const double most = std::max(before, now), least = std::min(before, now);
    const double missing =
        0.5 * dt * contact.stiffness * most * least / (most - least);  // towards each other: least <= 0
    add_row(contact, normal_row(contact, rotation), missing, impulse);
    return missing * (before - now) / dt;
}

}  // namespace hinge::contact
