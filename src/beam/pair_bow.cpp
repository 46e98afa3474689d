#include "beam/pair_bow.h"

#include <algorithm>
#include <cmath>

namespace hinge::beam {

double bow_of_even_load(double p) {
    if (std::abs(p) < 1e-3) return p / 24;
    const double u = std::sqrt(std::abs(p)), T = p > 0 ? u * std::tan(0.5 * u) : -u * std::tanh(0.5 * u);
    return T / p - 0.5;
}

double bow_of_force(double p, double x) {
    const double xi = 1 - std::abs(x);
    if (std::abs(p) < 1e-3) return 0;  // less than 1e-4 of P l
    const double u = std::sqrt(std::abs(p));
    const auto of = [&](double z) { return p > 0 ? std::cos(u * z) : std::cosh(u * z); };
    const double middle = 1 - of(xi), ends = of(x) - of(1), over = p > 0 ? u * std::sin(u) : -u * std::sinh(u);
    return 0.5 * ((middle + ends) / over - xi);
}

double bow_of_couple(double p, double x) {
    if (std::abs(p) < 1e-3) return 0;
    const double side = x > 0 ? 1 : x < 0 ? -1 : 0, xi = 1 - std::abs(x), u = std::sqrt(std::abs(p));
    const auto of = [&](double z) { return p > 0 ? std::sin(u * z) : std::sinh(u * z); };
    return 0.5 * (side - (side * of(xi) + of(x)) / of(1));
}

}  // namespace hinge::beam
