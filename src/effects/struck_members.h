// Warns of members whose elements are too long for the blows that they took.
#pragma once

#include <map>
#include <vector>

#include "contact/member_contacts.h"
#include "effects/reports.h"
#include "model/structure.h"
#include "state/state.h"

namespace hinge {

/// Compares the elements of struck members with the bending wave that a blow sends out.
///
/// A blow that lasts tau has the frequency omega = pi / tau. At it a beam carries bending waves of the length
///   lambda = 2 pi sqrt(sqrt(EI / rho A) / omega) = 2 sqrt(pi tau sqrt(EI / rho A)).
/// Elements longer than lambda / 4 answer with the lumps of their nodes in the place of the wave: of a mass that falls
/// on a beam, against the modal series, the energy and the momentum passed are right to 2 % with elements up to lambda
/// / 4, to 10 % up to 1.5 times that, and off by 14 % at 1.8, 40 % at 3 times (tests/script/effects/contact_test.lua).
/// Of EI the smaller one counts: the shorter wave.
///
/// A member that is struck between its joints and yields there forms its hinge at a node, beside the place of the blow:
/// its plastic work may be far off with few elements.
class StruckMembers {
public:
    explicit StruckMembers(const Structure& structure);
    /// After each step: adds what contacts have passed in it.
    void add_step(const Structure& structure, const State& state, const contact::Contact& contact, double time,
                  double dt);
    /// One warning, of the member whose elements are longest beside its wave. Members that got less than a tenth of the
    /// largest impulse do not count, nor those that got more than half of theirs by blows that last long enough. Where
    /// none has: one of the member with the fewest elements that yielded where it was struck between its joints; else
    /// one of the member that misses most of the moment of blows inside its elements.
    void check_run(const Structure& structure, const State& state, std::vector<RunWarning>& list) const;

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.struck_);
    }

private:
    /// Blows that a member took, and the one that goes on.
    struct Struck {
        int member = -1;
        double since = -1, last = -1, impulse_now = 0;  ///< s, s, N s
        double impulse = 0, brief = 0;                  ///< N s, of all blows, of those too brief for its elements
        double brief_time = 0;                          ///< N s s, impulse times duration of the brief ones
        double missed = 0, moment = 0;  ///< N m s, over time: moments F a b / l, and those at the ends of its element
        double between = 0;             ///< N s, of blows between its joints

        template <class Self, class A>
        static void fields(Self& s, A& a) {
            a(s.member, s.since, s.last, s.impulse_now, s.impulse, s.brief, s.brief_time, s.missed, s.moment,
              s.between);
        }
    };
    struct Blow {
        double impulse = 0, missed = 0, moment = 0;  ///< N s, N m s, N m s, of one step
        double between = 0;                          ///< N s, away from the member's joints
    };
    void add(int member, const Blow& blow, double time, double dt);
    void end_blow(Struck& of) const;
    const Struck* most_missed(const std::vector<Struck>& ended, double largest) const;
    RunWarning warning_of_waves(const Structure& structure, const Struck& worst, int count) const;
    /// Of one that yielded with few elements; false where there is none.
    bool warn_of_hinges(const Structure& structure, const State& state, const std::vector<Struck>& ended,
                        double largest, std::vector<RunWarning>& list) const;
    RunWarning warning_of_place(const Structure& structure, const Struck& worst) const;

    std::vector<double> wave_speed_;  ///< sqrt(EI / rho A) of each member, m^2/s
    std::vector<double> element_;     ///< m, its longest element
    std::vector<double> length_;      ///< m, of each member
    std::vector<double> from_;        ///< m, where each element begins on its member
    std::vector<Struck> struck_;      ///< sorted by member
};

}  // namespace hinge
