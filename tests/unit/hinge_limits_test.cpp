// Limits of the rotation of a hinge: each axis alone, either sign, just below and at the limit.
#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "section/fracture_limits.h"

using namespace hinge;

namespace {

beam::LimitReached reached(double x, double y, const beam::FractureLimits& limits) {
    const double rotation[2] = {x, y};
    return beam::rotation_reached(rotation, limits);
}

}  // namespace

TEST_CASE("hinge limits: a rotation breaks at its limit and not just below, of either sign, each axis alone",
          "[fracture]") {
    beam::FractureLimits limits;
    limits.hinge_rotation_x = 0.05, limits.hinge_rotation_y = 0.03;
    for (const double sign : {1.0, -1.0}) {
        CHECK(reached(sign * 0.05, 0, limits).which == beam::Limit::hinge_rotation_x);
        CHECK(reached(sign * 0.05, 0, limits).strain == sign * 0.05);
        CHECK(reached(0, sign * 0.03, limits).which == beam::Limit::hinge_rotation_y);
        CHECK(reached(sign * std::nextafter(0.05, 0), sign * std::nextafter(0.03, 0), limits).which ==
              beam::Limit::rule);
    }
    // both: the one that is further beyond
    CHECK(reached(0.06, 0.035, limits).which == beam::Limit::hinge_rotation_x);
    CHECK(reached(0.06, 0.045, limits).which == beam::Limit::hinge_rotation_y);
}

TEST_CASE("hinge limits: a limit that is not given is never reached", "[fracture]") {
    beam::FractureLimits limits;
    CHECK(limits.none());
    CHECK(reached(1e300, -1e300, limits).which == beam::Limit::rule);
    limits.hinge_rotation_y = 0.03;
    CHECK_FALSE(limits.none());
    CHECK(limits.no_strains());
    CHECK(reached(1e300, 0, limits).which == beam::Limit::rule);
    limits = {};
    limits.elongation = 0.1;
    CHECK_FALSE(limits.none());
    CHECK_FALSE(limits.no_hinges());
    // a limit of strain leaves those of hinges alone
    limits = {};
    limits.curvature_x = 1;
    CHECK(limits.no_hinges());
    CHECK_FALSE(limits.no_strains());
}
