#include "contact/shared_spring.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace hinge::contact {

namespace {

/// Sets of contacts, each named by its first. Two that overlap and were not one contact a step ago are never joined:
/// one spring in the place of two would drop half of the energy stored.
class Sets {
public:
    explicit Sets(const std::vector<SurfaceContact>& contacts) : above_(contacts.size()), held_(contacts.size(), -1) {
        std::iota(above_.begin(), above_.end(), 0);
        std::map<int, int> first_of;  // what overlaps as one contact stays one, also where a break has cut a chain
        for (int i = 0; i < int(contacts.size()); ++i) {
            if (contacts[i].group < 0 || !(contacts[i].penetration_before > 0)) continue;
            const int first = first_of.insert({contacts[i].group, i}).first->second;
            above_[i] = first;
            held_[first] = contacts[i].group;
        }
    }
    int of(int i) {
        while (above_[i] != i) i = above_[i] = above_[above_[i]];
        return i;
    }
    void join(int i, int j) {
        const int a = of(i), b = of(j);
        if (a == b || (held_[a] >= 0 && held_[b] >= 0)) return;
        const int first = std::min(a, b);
        held_[first] = std::max(held_[a], held_[b]);
        above_[std::max(a, b)] = first;
    }

private:
    std::vector<int> above_;
    std::vector<int> held_;  ///< of a first one: the number of the contact that its set was a step ago; -1: none
};

/// A contact near an end of a chain's element, where another chain may go on.
struct NearJoint {
    int joint, contact, side;
};

std::vector<NearJoint> near_joints(const std::vector<SurfaceContact>& contacts) {
    std::vector<NearJoint> list;
    for (int i = 0; i < int(contacts.size()); ++i) {
        const SurfaceContact& c = contacts[i];
        for (int side : {0, 1})
            for (int end : {0, 1}) {
                const double away = (end == 0 ? c.at[side] : 1 - c.at[side]) * c.length[side];
                if (c.joint[2 * side + end] >= 0 && away <= 0.5 * (c.radius[0] + c.radius[1]))
                    list.push_back({c.joint[2 * side + end], i, side});
            }
    }
    std::stable_sort(list.begin(), list.end(),
                     [](const NearJoint& p, const NearJoint& q) { return p.joint < q.joint; });
    return list;
}

void join_by_chains(const std::vector<SurfaceContact>& contacts, Sets& sets) {
    std::vector<int> order(contacts.size());
    std::iota(order.begin(), order.end(), 0);
    const auto key = [&](int i) { return std::minmax(contacts[i].chain[0], contacts[i].chain[1]); };
    std::stable_sort(order.begin(), order.end(), [&](int i, int j) { return key(i) < key(j); });
    for (std::size_t n = 1; n < order.size(); ++n)
        if (key(order[n]) == key(order[n - 1])) sets.join(order[n], order[n - 1]);
}

void join_at_joints(const std::vector<SurfaceContact>& contacts, Sets& sets) {
    const std::vector<NearJoint> list = near_joints(contacts);
    const auto also_near = [&](int joint, int contact, int side) {
        return std::any_of(list.begin(), list.end(), [&](const NearJoint& n) {
            return n.joint == joint && n.contact == contact && n.side == side;
        });
    };
    for (std::size_t first = 0, end; first < list.size(); first = end) {
        for (end = first; end < list.size() && list[end].joint == list[first].joint;) ++end;
        for (std::size_t i = first; i < end; ++i)
            for (std::size_t j = i + 1; j < end; ++j) {
                const NearJoint &p = list[i], &q = list[j];
                const int other_p = 1 - p.side, other_q = 1 - q.side;
                bool one = contacts[p.contact].chain[other_p] == contacts[q.contact].chain[other_q];
                for (const NearJoint& n : list)
                    one =
                        one || (n.contact == p.contact && n.side == other_p && also_near(n.joint, q.contact, other_q));
                if (one) sets.join(p.contact, q.contact);
            }
    }
}

template <class Contacts, class F>
void each_of(Contacts& contacts, int first, const F& f) {
    for (int i = first; i >= 0; i = contacts[i].next) f(contacts[i]);
}

/// The factors of d(force) = sqrt(k_i k_j) (alpha (i == j) - beta) dg_j of n pairs that press.
struct Tangent {
    double alpha = 1 / own_part, beta;
    explicit Tangent(int n) : beta((1 - own_part) / (own_part * (own_part + n * (1 - own_part)))) {}
};

/// Rows over the nodes of several contacts, and what they are multiplied by: K = sum of factor row row^T.
class Rows {
public:
    void add(const SurfaceContact& contact, const Row& row, double scale, double factor) {
        std::vector<Vec6> full(nodes_.size(), Vec6::Zero());
        for (int i = 0; i < 4; ++i) {
            const std::size_t place = place_of(contact.end[i].node);
            if (place >= full.size()) full.resize(place + 1, Vec6::Zero());
            full[place] += scale * row[i];
        }
        add(std::move(full), factor);
    }
    void add(std::vector<Vec6> row, double factor) {
        rows_.push_back(std::move(row));
        factors_.push_back(factor);
    }
    std::vector<Vec6> sum() const {
        std::vector<Vec6> all(nodes_.size(), Vec6::Zero());
        for (const auto& row : rows_)
            for (std::size_t i = 0; i < row.size(); ++i) all[i] += row[i];
        return all;
    }
    /// A node's own block goes with its first pair.
    void give(const AddStiffness& add) const {
        const auto block = [&](std::size_t a, std::size_t b) {
            Mat6 sum = Mat6::Zero();
            for (std::size_t r = 0; r < rows_.size(); ++r)
                if (a < rows_[r].size() && b < rows_[r].size())
                    sum += factors_[r] * rows_[r][a] * rows_[r][b].transpose();
            return sum;
        };
        std::vector<char> own_done(nodes_.size(), 0);
        for (std::size_t a = 0; a < nodes_.size(); ++a)
            for (std::size_t b = a + 1; b < nodes_.size(); ++b) {
                Mat12 K = Mat12::Zero();
                K.block<6, 6>(0, 6) = block(a, b);
                K.block<6, 6>(6, 0) = K.block<6, 6>(0, 6).transpose();
                if (!own_done[a]) K.block<6, 6>(0, 0) = block(a, a);
                if (!own_done[b]) K.block<6, 6>(6, 6) = block(b, b);
                own_done[a] = own_done[b] = 1;
                add(nodes_[a], nodes_[b], K);
            }
    }

private:
    std::size_t place_of(int node) {
        const auto at = std::find(nodes_.begin(), nodes_.end(), node);
        if (at != nodes_.end()) return std::size_t(at - nodes_.begin());
        nodes_.push_back(node);
        return nodes_.size() - 1;
    }

    std::vector<int> nodes_;
    std::vector<std::vector<Vec6>> rows_;
    std::vector<double> factors_;
};

}  // namespace

void group_contacts(std::vector<SurfaceContact>& contacts) {
    Sets sets(contacts);
    if (contacts.size() > 1) {
        join_by_chains(contacts, sets);
        join_at_joints(contacts, sets);
    }
    std::vector<int> last(contacts.size());
    for (int i = 0; i < int(contacts.size()); ++i) {
        const int first = sets.of(i);
        contacts[i].group = first;
        contacts[i].next = -1;
        if (first != i) contacts[last[first]].next = i;
        last[first] = i;
    }
    // a pair that comes to a contact has no part of its friction yet
    for (int first = 0; first < int(contacts.size()); ++first) {
        if (contacts[first].group != first || contacts[first].next < 0) continue;
        bool pressed = false;
        each_of(contacts, first, [&](const SurfaceContact& c) { pressed = pressed || c.depth_before > 0; });
        each_of(contacts, first, [&](SurfaceContact& c) {
            if (pressed && !(c.depth_before > 0)) c.share = 0;
        });
    }
}

void share_depth(std::vector<SurfaceContact>& contacts, int first) {
    if (contacts[first].next < 0) {
        contacts[first].depth = std::max(0.0, contacts[first].penetration);
        return;
    }
    std::vector<std::pair<double, SurfaceContact*>> order;
    each_of(contacts, first, [&](SurfaceContact& c) {
        c.depth = 0;
        if (c.penetration > 0) order.push_back({std::sqrt(c.stiffness) * c.penetration, &c});
    });
    std::stable_sort(order.begin(), order.end(), [](const auto& p, const auto& q) { return p.first > q.first; });

    // The deepest press: as many as are deeper than the shared spring.
    double sum = 0, shared = 0;
    std::size_t n = 0;
    for (; n < order.size() && order[n].first > shared; ++n) {
        sum += order[n].first;
        shared = (1 - own_part) * sum / (own_part + double(n + 1) * (1 - own_part));
    }
    for (std::size_t i = 0; i < n; ++i) {
        SurfaceContact& c = *order[i].second;
        c.depth = n == 1 ? c.penetration : (order[i].first - shared) / own_part / std::sqrt(c.stiffness);
    }
}

void add_shared_stiffness(const std::vector<SurfaceContact>& contacts, int first, const std::vector<Quat>& rotation,
                          const AddStiffness& add) {
    int n = 0;
    each_of(contacts, first, [&](const SurfaceContact& c) { n += c.depth > 0; });
    if (n == 0) return;
    const Tangent tangent(n);
    Rows rows;
    each_of(contacts, first, [&](const SurfaceContact& c) {
        if (c.depth > 0) rows.add(c, normal_row(c, rotation), std::sqrt(c.stiffness), tangent.alpha);
    });
    rows.add(rows.sum(), -tangent.beta);
    each_of(contacts, first, [&](const SurfaceContact& c) {
        if (!(c.depth > 0 && c.friction > 0 && !c.slides && c.share > 0)) return;
        const Vec3 across = c.normal.unitOrthogonal();
        const double k = c.stiffness * c.share;
        rows.add(c, slip_row(c, rotation, across), 1, k);
        rows.add(c, slip_row(c, rotation, c.normal.cross(across)), 1, k);
    });
    rows.give(add);
}

double missed_by_group(const std::vector<SurfaceContact>& contacts, int first, double dt,
                       const std::vector<Quat>& rotation, std::vector<Vec6>& impulse) {
    double work = 0, way = 0, force = 0, stored = 0;
    bool changed = false;
    each_of(contacts, first, [&](const SurfaceContact& c) {
        if (!(c.depth > 0 || c.depth_before > 0)) return;
        changed = changed || (c.depth > 0) != (c.depth_before > 0);
        work += 0.5 * c.stiffness * (c.depth * c.penetration_before - c.depth_before * c.penetration);
        way += std::pow(c.penetration - c.penetration_before, 2);
        force += 0.5 * c.stiffness * (c.depth + c.depth_before);
        stored += 0.5 * c.stiffness * (c.depth * c.penetration + c.depth_before * c.penetration_before);
    });
    const bool regrouped = std::abs(work) > 1e-9 * stored;
    if (!(changed || regrouped) || !(way > 0)) return 0;
    double factor = dt * work / way;
    const double most = dt * force / std::sqrt(way);
    factor = std::clamp(factor, -most, most);
    double done = 0;
    each_of(contacts, first, [&](const SurfaceContact& c) {
        if (!(c.depth > 0 || c.depth_before > 0)) return;
        const double moved = c.penetration - c.penetration_before;
        add_row(c, normal_row(c, rotation), factor * moved, impulse);
        done -= factor * moved * moved / dt;
    });
    return done;
}

double share_slip(std::vector<SurfaceContact>& contacts, int first) {
    double shares = 0, before = 0, force = 0, after = 0;
    Vec3 mean = Vec3::Zero();
    each_of(contacts, first, [&](const SurfaceContact& c) {
        shares += c.share;
        mean += c.share * c.slip_before;
        before += 0.5 * c.stiffness * c.share * c.slip_before.squaredNorm();
        force += c.stiffness * c.depth;
    });
    if (shares > 0) mean /= shares;
    each_of(contacts, first, [&](SurfaceContact& c) {
        c.share = force > 0 ? c.stiffness * c.depth / force : 1;
        if (force > 0) after += 0.5 * c.stiffness * c.share * mean.squaredNorm();
    });
    // parts of a contact that has split keep the energy that they had
    if (after > before) mean *= std::sqrt(before / after), after = before;
    if (!(force > 0)) mean.setZero();
    each_of(contacts, first, [&](SurfaceContact& c) { c.slip = c.slip_before = mean; });
    return std::max(0.0, before - after);
}

}  // namespace hinge::contact
