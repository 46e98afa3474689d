// What is to be said of joints and damping, from the facts that their effects have of the run.
#include "advice/adviser.h"
#include "core/text.h"
#include "effects/effect_list.h"
#include "effects/facts.h"
#include "model/member_text.h"

namespace hinge {
namespace {

/// Statics breaks no joint. In dynamics the order in which they break may hang on the settings.
class JointWarnings : public Adviser {
public:
    void list_findings(const Run& run, std::vector<Warning>& list) const override {
        const JointBreaks& joints = *run.effect_list().facts<JointBreaks>();
        const auto add = [&](std::string what, std::string advice, int member) {
            list.push_back({Warning::Kind::fracture, std::move(what), std::move(advice),
                            line_of_member(run.structure().model(), member)});
        };
        if (const JointBreaks::Close close = joints.close_breaks(); close.times > 0)
            add(close.broke + " broke at t = " + number_text(close.time, 4) + " s, when " + close.other + " had " +
                    number_text(100 * close.part, 3) + " % of its capacity" +
                    (close.times > 1 ? ", and so " + std::to_string(close.times - 1) + " more times" : "") +
                    ": which of them breaks first may hang on dt, the integrator and the elements, and "
                    "what follows with it",
                "compare with another integrator, and with twice the elements", close.member);
        if (run.workspace().kind.dynamic) return;
        for (const JointBreaks::Beyond& b : joints.beyond_capacity())
            add(b.joint + " is beyond its capacity: " + b.reached + "; statics breaks no joint",
                "a dynamic run that goes on from here breaks it", b.member);
    }
};

class DampingWarnings : public Adviser {
public:
    void list_findings(const Run& run, std::vector<Warning>& list) const override {
        const WholeRates::Counts of = run.effect_list().facts<WholeRates>()->whole_rates();
        if (of.elements == 0) return;
        const Structure& structure = run.structure();
        const int member = structure.elements()[std::size_t(of.first)].member;
        list.push_back({Warning::Kind::damping,
                        "the damping by beta of " + count_text(of.elements, "element") + ", the first of " +
                            member_text(structure.model(), member) + ", acted on plastic hinges, too, in up to " +
                            number_text(100 * of.most_part, 2) +
                            " % of the steps in which they turned: without that it would have "
                            "made energy, since the hinges turn to and fro from step to step",
                        "for blows damp by alpha alone, or give a smaller beta",
                        line_of_member(structure.model(), member)});
    }
};

}  // namespace

std::unique_ptr<Adviser> advise_of_joints(const Run& run, WarningLog&) {
    if (!run.effect_list().facts<JointBreaks>()) return nullptr;
    return std::make_unique<JointWarnings>();
}

std::unique_ptr<Adviser> advise_of_damping(const Run& run, WarningLog&) {
    if (!run.effect_list().facts<WholeRates>()) return nullptr;
    return std::make_unique<DampingWarnings>();
}

}  // namespace hinge
