#include "contact/broad_phase.h"

#include <algorithm>
#include <array>
#include <limits>

namespace hinge::contact {

namespace {

// The axis along which fewest boxes overlap, estimated from a histogram of where they begin.
int best_axis(const std::vector<Box>& boxes) {
    constexpr int bins = 64;
    int best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        double low = boxes[0].low[axis], high = low;
        for (const Box& box : boxes) {
            low = std::min(low, box.low[axis]);
            high = std::max(high, box.low[axis]);
        }
        const double scale = high > low ? (bins - 1) / (high - low) : 0.0;
        const auto bin = [&](double x) { return static_cast<int>(std::min(std::max((x - low) * scale, 0.0), bins - 1.0)); };
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

struct Begin {
    double at;
    int box;
};

// Into as many bins as there are boxes, then by insertion: a third of the time of std::sort, whose branches are hard to foresee.
void sort_by_place(std::vector<Begin>& begin) {
    const int n = static_cast<int>(begin.size());
    double low = begin[0].at, high = low;
    for (const Begin& b : begin) {
        low = std::min(low, b.at);
        high = std::max(high, b.at);
    }
    const double scale = high > low ? (n - 1) / (high - low) : 0.0;
    std::vector<int> first(n + 1, 0);
    const auto bin = [&](double x) { return static_cast<int>((x - low) * scale); };
    for (const Begin& b : begin) ++first[bin(b.at) + 1];
    for (int i = 0; i < n; ++i) first[i + 1] += first[i];
    std::vector<Begin> sorted(n);
    std::vector<int> next(first.begin(), first.end() - 1);
    for (const Begin& b : begin) sorted[next[bin(b.at)]++] = b;
    const auto before = [](const Begin& p, const Begin& q) { return p.at < q.at || (p.at == q.at && p.box < q.box); };
    for (int i = 0; i < n; ++i)
        if (first[i + 1] - first[i] > 1) std::sort(sorted.begin() + first[i], sorted.begin() + first[i + 1], before);
    begin.swap(sorted);
}

}  // namespace

std::vector<IndexPair> overlapping(const std::vector<Box>& boxes) {
    std::vector<IndexPair> pairs;
    if (boxes.size() < 2) return pairs;
    const int n = static_cast<int>(boxes.size());
    const int x = best_axis(boxes), y = (x + 1) % 3, z = (x + 2) % 3;

    std::vector<Begin> begin(n);
    for (int i = 0; i < n; ++i) begin[i] = {boxes[i].low[x], i};
    sort_by_place(begin);

    // The other two axes lie side by side in the order of the sweep, so that the inner loop runs through memory.
    struct Face {
        double begins, low_y, high_y, low_z, high_z;
    };
    std::vector<Face> face(n);
    for (int i = 0; i < n; ++i) {
        const Box& box = boxes[begin[i].box];
        face[i] = {begin[i].at, box.low[y], box.high[y], box.low[z], box.high[z]};
    }
    for (int i = 0; i < n; ++i) {
        const Face here = face[i];
        const double end = boxes[begin[i].box].high[x];
        for (int j = i + 1; j < n && face[j].begins <= end; ++j) {
            const Face& other = face[j];
            if ((other.low_y <= here.high_y) & (other.high_y >= here.low_y) & (other.low_z <= here.high_z) & (other.high_z >= here.low_z))
                pairs.push_back({std::min(begin[i].box, begin[j].box), std::max(begin[i].box, begin[j].box)});
        }
    }

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
