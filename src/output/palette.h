// Colour palette of a GIF: at most 255 colours for all of its pictures.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace hinge::output {

using Rgb = std::array<std::uint8_t, 3>;

/// Histogram of colours, with six bits a channel.
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

/// Representative colours of a histogram, and the index of the one for each of its bins.
struct Palette {
    std::vector<Rgb> colours;          ///< at most `most`
    std::vector<std::uint8_t> of_bin;  ///< 0 for bins where there is nothing
    static constexpr std::size_t most = 255;
};

/// Computes a palette by median cut: halves the box of colours with the largest spread times the root of its count.
Palette make_palette(const Histogram& histogram);

}  // namespace hinge::output
