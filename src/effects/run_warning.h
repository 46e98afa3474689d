// What a user should know of a run, as effects and runs say it.
#pragma once

#include <string>
#include <vector>

namespace hinge {

/// What a user should know of a run, as it is told by hinge run: "member 3 ...", and what can be done about it.
struct RunWarning {
    std::string what, advice;
    int member = -1;
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.what, s.advice, s.member);
    }
};

/// Role of an effect that checks a run as a whole: it is asked where the run ends, and whenever a script reads
/// run.warnings.
class ChecksRun {
public:
    virtual ~ChecksRun() = default;
    virtual void check_run(std::vector<RunWarning>& list) const = 0;
};

}  // namespace hinge
