// Output folders and their owners. run.json has the owner: script, case, parameters, hinge's version.
#pragma once

#include <string>
#include <vector>

#include "record/context.h"

namespace hinge {

/// The output folder of a run by `owner` (JSON without a version): `wanted`, or, if that holds a run with another
/// script or other parameters, the first of wanted-2, wanted-3, ... that does not.
std::string free_folder(const std::string& wanted, const std::string& owner);

/// Makes the folder of a file that is to be written. A script that is not trusted stays inside its output folder,
/// whatever links are there; InputError for a file elsewhere, and for a name with line breaks.
void prepare_folder(const Context& c, const std::string& file);

/// Makes the output folder and writes run.json into it, once. Prints a notice if another run was in it.
void take_folder(Context& c);

/// hinge history: prints a paragraph for each folder with a run, in `folders` or one level below. False if there is
/// none.
bool print_history(const std::vector<std::string>& folders);

}  // namespace hinge
