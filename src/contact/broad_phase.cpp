#include "contact/broad_phase.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hinge::contact {

namespace {

// The axis along which fewest boxes overlap, estimated from a histogram of where they begin.
int best_axis(const std::vector<Box>& boxes) {
    constexpr int bins = 64;
    int best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        float low = boxes[0].low[axis], high = low;
        for (const Box& box : boxes) {
            low = std::min(low, box.low[axis]);
            high = std::max(high, box.low[axis]);
        }
        const float scale = high > low ? (bins - 1) / (high - low) : 0.0f;
        const auto bin = [&](float x) {
            const float place = (x - low) * scale;  // not a number where boxes reach beyond all bounds
            return place > 0 ? static_cast<int>(std::min(place, bins - 1.0f)) : 0;
        };
        std::array<int, bins + 1> begun{};
        for (const Box& box : boxes) ++begun[bin(box.low[axis]) + 1];
        for (int i = 0; i < bins; ++i) begun[i + 1] += begun[i];
        double tests = 0;
        for (const Box& box : boxes) tests += begun[bin(box.high[axis]) + 1] - begun[bin(box.low[axis])];
        if (tests < least) {
            least = tests;
            best = axis;
        }
    }
    return best;
}

/// The pairs in the order in which a sweep along the best axis comes upon them.
std::vector<IndexPair> swept(const std::vector<Box>& boxes, const std::function<bool(int, int)>& wanted) {
    std::vector<IndexPair> pairs;
    const int n = static_cast<int>(boxes.size());
    const int x = best_axis(boxes), y = (x + 1) % 3, z = (x + 2) % 3;

    struct Begin {
        float at;
        int box;
    };
    std::vector<Begin> begin(n);
    for (int i = 0; i < n; ++i) begin[i] = {boxes[i].low[x], i};
    std::sort(begin.begin(), begin.end(),
              [](const Begin& p, const Begin& q) { return p.at < q.at || (p.at == q.at && p.box < q.box); });

    // The other two axes lie side by side in the order of the sweep, so that the inner loop runs through memory.
    struct Face {
        float begins, low_y, high_y, low_z, high_z;
    };
    std::vector<Face> face(n);
    for (int i = 0; i < n; ++i) {
        const Box& box = boxes[begin[i].box];
        face[i] = {begin[i].at, box.low[y], box.high[y], box.low[z], box.high[z]};
    }
    // Every test writes, and only a hit moves on: in a frame out of plumb a branch here is a coin toss, at half the
    // speed.
    std::vector<int> hit(n);
    for (int i = 0; i < n; ++i) {
        const Face here = face[i];
        const float end = boxes[begin[i].box].high[x];
        int hits = 0;
        for (int j = i + 1; j < n && face[j].begins <= end; ++j) {
            const Face& other = face[j];
            hit[hits] = begin[j].box;
            hits += static_cast<int>(other.low_y <= here.high_y) & static_cast<int>(other.high_y >= here.low_y) &
                    static_cast<int>(other.low_z <= here.high_z) & static_cast<int>(other.high_z >= here.low_z);
        }
        for (int k = 0; k < hits; ++k)
            if (wanted(begin[i].box, hit[k]))
                pairs.push_back({std::min(begin[i].box, hit[k]), std::max(begin[i].box, hit[k])});
    }
    return pairs;
}

}  // namespace

Box::Box(const Vec3& lowest, const Vec3& highest) {
    constexpr float far = std::numeric_limits<float>::infinity();
    for (int c = 0; c < 3; ++c) {
        // what is not a number is everywhere: a run that comes to this is ended by the solver, which names the place
        low[c] = std::isnan(lowest[c]) ? -far : std::nextafter(static_cast<float>(lowest[c]), -far);
        high[c] = std::isnan(highest[c]) ? far : std::nextafter(static_cast<float>(highest[c]), far);
    }
}

std::vector<IndexPair> overlapping(const std::vector<Box>& boxes, const std::function<bool(int, int)>& wanted) {
    if (boxes.size() < 2) return {};
    const std::vector<IndexPair> pairs = swept(boxes, wanted);
    const int n = static_cast<int>(boxes.size());

    // Sorted by a in one pass over counts, then each short run by b: cheaper than one long sort.
    std::vector<int> first(n + 1, 0);
    for (const IndexPair& pair : pairs) ++first[pair.a + 1];
    for (int i = 0; i < n; ++i) first[i + 1] += first[i];
    std::vector<IndexPair> sorted(pairs.size());
    std::vector<int> next(first.begin(), first.end() - 1);
    for (const IndexPair& pair : pairs) sorted[next[pair.a]++] = pair;
    for (int i = 0; i < n; ++i) std::sort(sorted.begin() + first[i], sorted.begin() + first[i + 1]);
    return sorted;
}

}  // namespace hinge::contact
