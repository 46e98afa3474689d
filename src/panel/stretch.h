// Symmetric tensors in a plane, and the stretch that belongs to Green's strain.
#pragma once

#include <cmath>

#include "core/types.h"

namespace hinge::panel {

/// [a, c; c, b].
struct Symmetric {
    double a = 1, b = 1, c = 0;
    static Symmetric of_strain(const Vec3& e) { return {e[0], e[1], 0.5 * e[2]}; }
    static Symmetric of_stress(const Vec3& s) { return {s[0], s[1], s[2]}; }
    Vec3 strain() const { return {a, b, 2 * c}; }
    Vec3 stress() const { return {a, b, c}; }
    double determinant() const { return a * b - c * c; }
    Symmetric operator*(double f) const { return {f * a, f * b, f * c}; }
    Symmetric operator+(const Symmetric& o) const { return {a + o.a, b + o.b, c + o.c}; }
};

/// X U + U X, symmetric; twice the symmetric part of a product.
inline Symmetric both_ways(const Symmetric& X, const Symmetric& U) {
    return {2 * (X.a * U.a + X.c * U.c), 2 * (X.b * U.b + X.c * U.c), X.c * (U.a + U.b) + U.c * (X.a + X.b)};
}

/// X of U X + X U = A for many A. As a linear map of A it is its own transpose.
class HalfOf {
public:
    explicit HalfOf(const Symmetric& U)
        : other_{U.b, U.a, -U.c}, det_(U.determinant()), by_(0.5 / ((U.a + U.b) * det_)) {}
    Symmetric operator()(const Symmetric& A) const {  // (det A + other A other) / (2 trace det)
        const auto& [p, q, r] = other_;
        const double x = p * A.a + r * A.c, y = p * A.c + r * A.b, z = r * A.c + q * A.b;
        return {by_ * (det_ * A.a + x * p + y * r), by_ * (det_ * A.b + (r * A.a + q * A.c) * r + z * q),
                by_ * (det_ * A.c + x * r + y * q)};
    }

private:
    Symmetric other_;
    double det_, by_;
};

/// U of U^2 = I + 2 E.
inline Symmetric stretch_of(const Symmetric& E) {
    const Symmetric C{1 + 2 * E.a, 1 + 2 * E.b, 2 * E.c};
    const double root = std::sqrt(C.determinant()), by = 1 / std::sqrt(C.a + C.b + 2 * root);
    return {by * (C.a + root), by * (C.b + root), by * C.c};
}

}  // namespace hinge::panel
