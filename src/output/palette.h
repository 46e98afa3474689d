// The colours of a GIF: at most 255 for all of its pictures.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace hinge::output {

using Rgb = std::array<std::uint8_t, 3>;

/// How often each colour occurs, to six bits a channel.
class Histogram {
public:
    static constexpr int bits = 6;
    static constexpr std::size_t size = std::size_t(1) << (3 * bits);

    void add(std::span<const unsigned char> rgb);
    void add(const Histogram& other);

    static std::size_t bin(const unsigned char* rgb) {
        constexpr int drop = 8 - bits;
        return std::size_t(rgb[0] >> drop) << (2 * bits) | std::size_t(rgb[1] >> drop) << bits |
               std::size_t(rgb[2] >> drop);
    }
    struct Bin {
        std::uint64_t count = 0;
        std::array<std::uint64_t, 3> sum = {};
    };
    const std::vector<Bin>& bins() const { return bins_; }

private:
    std::vector<Bin> bins_ = std::vector<Bin>(size);
};

/// Colours that stand for all in a histogram, and which of them stands for each of its bins.
struct Palette {
    std::vector<Rgb> colours;          ///< at most `most`
    std::vector<std::uint8_t> of_bin;  ///< 0 for bins where there is nothing
    static constexpr std::size_t most = 255;
};

/// By median cut: the box of colours that spreads most, weighed by the root of its count, is halved again and again.
Palette make_palette(const Histogram& histogram);

}  // namespace hinge::output
