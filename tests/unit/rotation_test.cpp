// Rotations of nodes, eight at once, against one by one.
#include "core/rotation.h"

#include "helpers.h"
#include "state/rotate.h"

using namespace hinge;
using namespace hinge::test;

namespace {

/// Quaternions of nodes before and after rotation vectors of about this size, rad.
struct Nodes {
    std::vector<Quat> before, after;
    std::vector<Vec3> by;
    Nodes(int count, double size, Dice& dice) {
        for (int i = 0; i < count; ++i) {
            const auto some = [&] { return Vec3(dice(-1, 1), dice(-1, 1), dice(-1, 1)); };
            before.push_back(rotated(3 * some(), Quat::Identity()));
            by.push_back(size * some());
            after.push_back(rotated(by.back(), before.back()));
            if (i % 3 == 0) after.back().coeffs() *= -1;  // the same rotation
        }
    }
};

}  // namespace

TEST_CASE("rotation vectors of eight nodes at once are those of each") {
    Dice dice(7);
    for (const double size : {1e-9, 1e-4, 0.03, 0.06, 0.3, 1.5}) {
        const Nodes nodes(203, size, dice);
        std::vector<Vec3> found(nodes.by.size(), Vec3::Constant(std::nan("")));
        find_rotations(nodes.before, nodes.after, found, 0, 100);
        find_rotations(nodes.before, nodes.after, found, 100, found.size());
        double off = 0, off_scalar = 0;
        for (std::size_t i = 0; i < found.size(); ++i) {
            off = largest_of(off, (found[i] - nodes.by[i]).norm());
            off_scalar = largest_of(off_scalar,
                                    (found[i] - rotation_vector(nodes.after[i] * nodes.before[i].conjugate())).norm());
        }
        INFO("rotations of up to " << size << " rad");
        CHECK_FIGURE("against what they were rotated by, rad", off, 1e-14);  // some roundings of quaternions
        CHECK_FIGURE("against one node at a time, rad", off_scalar, 1e-14);
    }
}
