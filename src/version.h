// Text of hinge --version.
#pragma once

#include <string>

namespace hinge {

/// "hinge 1.2.3", alone in the first line; then how this program was built, and which libraries it uses and where.
std::string version_text();

}  // namespace hinge
