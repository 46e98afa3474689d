// Formats numbers, vectors, counts and times for messages.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>

#include "core/types.h"

namespace hinge {

inline std::string number_text(double v, int digits = 6) {
    char text[40];
    std::snprintf(text, sizeof text, "%.*g", digits, v);
    return text;
}

/// A number in a sentence.
inline std::string digits(double v, int n = 4) { return number_text(v, n); }

inline std::string vector_text(const Vec3& v, int digits = 6) {
    return "{" + number_text(v.x(), digits) + ", " + number_text(v.y(), digits) + ", " + number_text(v.z(), digits) +
           "}";
}

/// Sixteen hexadecimal digits: checksums.
inline std::string hex_text(std::uint64_t v) {
    char text[20];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(v));
    return text;
}

/// "1 member", "2 members"
inline std::string count_text(long n, const std::string& what) {
    return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

/// A time with a suitable unit: "2 ms", "30.5 us"
inline std::string time_text(double s, int digits = 3) {
    const double size = s < 0 ? -s : s;
    if (size == 0 || size >= 0.9995) return number_text(s, digits) + " s";
    if (size >= 0.9995e-3) return number_text(1e3 * s, digits) + " ms";
    return size >= 0.9995e-6 ? number_text(1e6 * s, digits) + " us" : number_text(1e9 * s, digits) + " ns";
}

/// "12 s", "3 min 20 s", "2 h 5 min"
inline std::string duration_text(double s) {
    const long whole = std::lround(s);
    const auto two = [](long a, const char* large, long b, const char* small) {
        return std::to_string(a) + large + (b > 0 ? " " + std::to_string(b) + small : "");
    };
    if (whole < 120) return std::to_string(whole) + " s";
    return whole < 7200 ? two(whole / 60, " min", whole % 60, " s")
                        : two(whole / 3600, " h", whole % 3600 / 60, " min");
}

}  // namespace hinge
