// Numbers and vectors as messages show them.
#pragma once

#include <cstdio>
#include <string>

#include "core/types.h"

namespace hinge {

inline std::string number_text(double v, int digits = 6) {
    char text[40];
    std::snprintf(text, sizeof text, "%.*g", digits, v);
    return text;
}

inline std::string vector_text(const Vec3& v, int digits = 6) {
    return "{" + number_text(v.x(), digits) + ", " + number_text(v.y(), digits) + ", " + number_text(v.z(), digits) +
           "}";
}

}  // namespace hinge
