// What a run has seen on its way that its results do not show: a cause and numbers. Its text is made in
// advice/run_notices.cpp.
#pragma once

namespace hinge {

struct Notice {
    enum class Kind : int {
        starts_beyond_yield,  ///< by heat or prestress at once: element, the first of `count`; value: J of plastic work
        snap,                 ///< node, component; value: m that it moves; times: as far as under such a load at first
        left_branch,          ///< a static run may have leapt to another branch of equilibria
        leans,                ///< node, component; member: the one that holds the structure; from: load factor
    };
    Kind kind = Kind::snap;
    int node = -1, component = 0, element = -1, member = -1;
    long count = 0;
    double value = 0, times = 0;
    double from = 0, to = 0;  ///< load factors between which it happened
    bool plastic = false;     ///< hinges have formed
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.kind, s.node, s.component, s.element, s.member, s.count, s.value, s.times, s.from, s.to, s.plastic);
    }
};

}  // namespace hinge
