// Output folders: whose each is. run.json says it: script, case, parameters, hinge's version.
#pragma once

#include <string>
#include <vector>

#include "script/lua/objects.h"

namespace hinge::script {

/// The output folder of a run by `owner` (JSON without a version): `wanted`, or, where that holds a run with another
/// script or other parameters, the first of wanted-2, wanted-3, ... that does not.
std::string free_folder(const std::string& wanted, const std::string& owner);

/// Makes the output folder and writes run.json into it, once. Says so where it held a run of something else.
void take_folder(Context& c);

/// hinge history: a paragraph for each folder in `folders`, or in those that they hold, that a run was written to.
/// False where there is none.
bool print_history(const std::vector<std::string>& folders);

}  // namespace hinge::script
