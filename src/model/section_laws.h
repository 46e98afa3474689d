// Laws of the sections of a model that a run may do without: hinge cost measures what they change.
#pragma once

#include <string>
#include <vector>

namespace hinge {

class Model;
class Structure;

/// A law that a model does without, by name: "hardening" and whatever else MaterialLaw::name gives; "exact": sections
/// with that interaction have eq 14 in its place; "eq 14": sections whose outline is known have the exact interaction.
struct OmittedLaw {
    std::string name;
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.name);
    }
};

/// Name of these declarations in a model.
inline constexpr const char* omitted_laws = "omitted section laws";

/// Names of the laws of a structure's sections that can be left out; none where no section can yield.
std::vector<std::string> optional_laws(const Structure& structure);

/// Leaves out the law of this name. Nothing happens where the model has none.
void leave_out_law(const std::string& name, Model& model);

}  // namespace hinge
