// Suggests a known name for a mistyped one.
#pragma once

#include <string>
#include <vector>

namespace hinge {

/// The nearest of `names` to a mistyped one, as " (did you mean 'x'?)", or "".
std::string did_you_mean(const std::string& typed, const std::vector<std::string>& names);

}  // namespace hinge
