// The colours of f_y, told apart by readers with each kind of sight.
#include <catch2/catch.hpp>

#include <array>
#include <cmath>

#include "output/colours.h"

using namespace hinge::output;

namespace {

using Numbers = std::array<double, 3>;
using Matrix = std::array<Numbers, 3>;

Numbers times(const Matrix& m, const Numbers& v) {
    Numbers out{};
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) out[i] += m[i][k] * v[k];
    return out;
}

/// sRGB to linear light (IEC 61966-2-1).
Numbers linear(const Colour& c) {
    Numbers out;
    for (int i = 0; i < 3; ++i) {
        const double x = c[i] / 255.0;
        out[i] = x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
    }
    return out;
}

/// CIE L*a*b* of linear sRGB, white point D65.
Numbers lab(Numbers light) {
    for (double& x : light) x = x < 0 ? 0 : x > 1 ? 1 : x;
    const Numbers xyz = times({{{0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}}}, light);
    const Numbers white_point = {0.9505, 1, 1.089};
    Numbers f;
    for (int i = 0; i < 3; ++i) {
        const double t = xyz[i] / white_point[i];
        f[i] = t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116;
    }
    return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

// Severity 1 of Machado, Oliveira and Fernandes, "A physiologically-based model for simulation of color vision
// deficiency", IEEE Trans. Visualization and Computer Graphics 15 (2009).
const std::pair<const char*, Matrix> kinds_of_sight[] = {
    {"normal", {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}},
    {"protanopia",
     {{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}}},
    {"deuteranopia",
     {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}}},
    {"tritanopia",
     {{{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}}}};

double difference(const Matrix& sight, const Colour& a, const Colour& b) {
    const Numbers p = lab(times(sight, linear(a))), q = lab(times(sight, linear(b)));
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

}  // namespace

TEST_CASE("colours of f_y, of broken elements, of shares and of both sides of a diagram differ for every kind of sight",
          "[output]") {
    for (const auto& [name, sight] : kinds_of_sight) {
        for (int i = 0; i < n_classes; ++i)
            for (int k = 0; k < i; ++k) {
                INFO(name << ": colours " << k << " and " << i);
                CHECK(difference(sight, class_colours[i], class_colours[k]) > 20);
            }
        INFO(name);
        CHECK(difference(sight, plus_fill, minus_fill) > 20);
        CHECK(difference(sight, plus_line, minus_line) > 20);
        for (int i = 0; i < n_shares; ++i)
            for (int k = 0; k < i; ++k) CHECK(difference(sight, share_colours[i], share_colours[k]) > 20);
    }
    // Shares are read in grey, too: each is darker than the one before.
    for (int k = 1; k < n_shares; ++k)
        CHECK(lab(linear(share_colours[k - 1]))[0] - lab(linear(share_colours[k]))[0] > 15);
    // What the measure is worth: the colours of version 0.1 were 11 apart for tritanopia (light blue and green).
    CHECK(difference(kinds_of_sight[3].second, {82, 176, 214}, {92, 184, 112}) < 12);
    // White and black are 100 apart.
    CHECK(std::abs(difference(kinds_of_sight[0].second, {255, 255, 255}, {0, 0, 0}) - 100) < 0.1);
}
