#include "output/palette.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hinge::output {
namespace {

struct BinEntry {
    std::array<double, 3> colour;  ///< the mean of the bin
    double weight;                 ///< the root of the count: paper must not take all colours, nor a speck one
    std::size_t bin;
};

/// A range of entries, and what halving it would gain.
struct Box {
    std::size_t first, end;
    double spread = 0;  ///< weight times variance, along its longest axis
    int axis = 0;
};

Box measured(const std::vector<BinEntry>& entries, std::size_t first, std::size_t end) {
    Box box{first, end};
    for (int c = 0; c < 3; ++c) {
        double weight = 0, sum = 0, squares = 0;
        for (std::size_t i = first; i < end; ++i) {
            const BinEntry& e = entries[i];
            weight += e.weight, sum += e.weight * e.colour[c], squares += e.weight * e.colour[c] * e.colour[c];
        }
        const double spread = squares - sum * sum / weight;
        if (spread > box.spread) box.spread = spread, box.axis = c;
    }
    return box;
}

/// Where the entries, sorted along the box's axis, are halved by weight; both halves hold at least one.
std::size_t half(std::vector<BinEntry>& entries, const Box& box) {
    const auto at = [&](std::size_t i) { return entries.begin() + static_cast<std::ptrdiff_t>(i); };
    std::sort(at(box.first), at(box.end), [&](const BinEntry& a, const BinEntry& b) {
        return a.colour[box.axis] != b.colour[box.axis] ? a.colour[box.axis] < b.colour[box.axis] : a.bin < b.bin;
    });
    double all = 0, before = 0;
    for (std::size_t i = box.first; i < box.end; ++i) all += entries[i].weight;
    std::size_t i = box.first;
    while (i + 1 < box.end && before + entries[i].weight <= all / 2) before += entries[i++].weight;
    return std::max(i, box.first + 1);
}

Rgb mean(const std::vector<BinEntry>& entries, const std::vector<Histogram::Bin>& bins, const Box& box) {
    std::uint64_t count = 0;
    std::array<std::uint64_t, 3> sum = {};
    for (std::size_t i = box.first; i < box.end; ++i) {
        const Histogram::Bin& bin = bins[entries[i].bin];
        count += bin.count;
        for (int c = 0; c < 3; ++c) sum[c] += bin.sum[c];
    }
    Rgb colour;
    for (int c = 0; c < 3; ++c) colour[c] = static_cast<std::uint8_t>((sum[c] + count / 2) / count);
    return colour;
}

std::size_t nearest(const std::vector<Rgb>& colours, const std::array<double, 3>& wanted) {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < colours.size(); ++i) {
        double distance = 0;
        for (int c = 0; c < 3; ++c) distance += (colours[i][c] - wanted[c]) * (colours[i][c] - wanted[c]);
        if (distance < least) least = distance, best = i;
    }
    return best;
}

}  // namespace

void Histogram::add(std::span<const unsigned char> rgb) {
    for (std::size_t i = 0; i + 2 < rgb.size(); i += 3) {
        Bin& b = bins_[bin(&rgb[i])];
        ++b.count;
        for (std::size_t c = 0; c < 3; ++c) b.sum[c] += rgb[i + c];
    }
}

void Histogram::add(const Histogram& other) {
    for (std::size_t i = 0; i < size; ++i) {
        bins_[i].count += other.bins_[i].count;
        for (std::size_t c = 0; c < 3; ++c) bins_[i].sum[c] += other.bins_[i].sum[c];
    }
}

Palette make_palette(const Histogram& histogram) {
    const auto& bins = histogram.bins();
    std::vector<BinEntry> entries;
    for (std::size_t i = 0; i < bins.size(); ++i)
        if (const double n = double(bins[i].count); n > 0)
            entries.push_back({{bins[i].sum[0] / n, bins[i].sum[1] / n, bins[i].sum[2] / n}, std::sqrt(n), i});
    Palette palette;
    palette.of_bin.assign(Histogram::size, 0);
    if (entries.empty()) return palette;
    std::vector<Box> boxes = {measured(entries, 0, entries.size())};
    while (boxes.size() < Palette::most) {
        const auto widest = std::max_element(boxes.begin(), boxes.end(),
                                             [](const Box& a, const Box& b) { return a.spread < b.spread; });
        if (widest->end - widest->first < 2 || !(widest->spread > 0)) break;
        const Box whole = *widest;
        const std::size_t middle = half(entries, whole);
        *widest = measured(entries, whole.first, middle);
        boxes.push_back(measured(entries, middle, whole.end));
    }
    for (const Box& box : boxes) palette.colours.push_back(mean(entries, bins, box));
    for (const BinEntry& e : entries) palette.of_bin[e.bin] = std::uint8_t(nearest(palette.colours, e.colour));
    return palette;
}

}  // namespace hinge::output
