// A warning: a likely mistake in what was declared, or what a run cannot show or has passed over.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/model.h"

namespace hinge {

struct Warning {
    enum class Kind : int {
        units,      ///< a number looks as if it were in another unit: all results may be meaningless
        value,      ///< likewise, of a number on which not all results depend
        geometry,   ///< nodes and members: not joined, overlapping, tiny, without use
        support,    ///< a part of the model is a mechanism
        loads,      ///< loads, weights and load cases: missing, idle, counted twice
        buckling,   ///< a member is near Euler's load in a linear solution
        stability,  ///< the structure may buckle, snap or lean in a way that the run does not show
        strength,   ///< sections that never yield, or are found too strong
        elements,   ///< too few elements for what happens in a member
        time_step,  ///< dt is too long for what the model does
        damping,
        contact,  ///< members or bodies that nothing stops, or that overlap
        fracture,
        energy,
        chain,  ///< the run goes on from one that did not reach its end
    };
    Kind kind = Kind::geometry;
    std::string what = {};  ///< "member 3 ...", with the culprit's name, its value and its unit
    std::string advice = {};
    std::string asked_at = {};  ///< the script's line, "" where it is not known
    int more = 0;               ///< further ones of the same kind
    int tells_of = 1;           ///< equal objects that it describes
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.kind, s.what, s.advice, s.asked_at, s.more, s.tells_of);
    }
};

/// "what (line, and 3 more like it); advice"
std::string warning_text(const Warning& w);

/// The script's line that declared a member; "" for none (-1).
std::string line_of_member(const Model& model, int member);

/// The first warning about units, if any: results from such numbers are meaningless.
std::optional<Warning> of_units(const std::vector<Warning>& list);

}  // namespace hinge
