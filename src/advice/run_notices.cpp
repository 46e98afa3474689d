// What runs have seen on their way (run/notice.h), and how they ended, in words.
#include <cmath>
#include <cstdio>

#include "advice/adviser.h"
#include "core/text.h"
#include "run/dynamics.h"
#include "run/statics.h"

namespace hinge {
namespace {

Warning warning_of(const Notice& n, const Structure& s) {
    using Kind = Notice::Kind;
    const std::string name = "member " + std::to_string(n.member + 1),
                      between = "between load factors " + number_text(n.from) + " and " + number_text(n.to) + " ";
    const auto of_snap = [&](const std::string& what) -> Warning {
        return {Warning::Kind::stability, between + what,
                "a limit load may lie there, or a snap, at which a static run with other steps may end; control by "
                "displacement or arc length follows the path" +
                    std::string(n.plastic ? ", displacement = 'small' gives the plastic limit load whatever the steps"
                                          : "")};
    };
    switch (n.kind) {
        case Kind::starts_beyond_yield:
            return {Warning::Kind::loads,
                    "heat or prestress acts at once where the run begins and brings " + count_text(n.count, "element") +
                        " beyond yield, first " + s.element_name(n.element) +
                        "; the run begins on the yield surface, with " + number_text(n.value, 4) + " J of plastic work",
                    "a static run before it (from = ...) applies them step by step"};
        case Kind::snap:
            return of_snap(component_name(n.component) + (" of " + s.node_name(n.node)) + " changes by " +
                           number_text(n.value, 3) + " m, and the structure moves " +
                           number_text(std::round(n.times), 9) + " times as far as under such a load at first");
        case Kind::left_branch: return of_snap("the run may have leapt to another branch of equilibria");
        default:
            return {Warning::Kind::stability,
                    "beyond load factor " + number_text(n.from) + " " + name +
                        " and others that carry one sign of N alone are slack, and nothing holds " +
                        s.node_name(n.node) + " upright, " + component_name(n.component) +
                        ": the structure leans over until " + name + " holds it",
                    "a perfect structure may lean either way; a small load across, or model:imperfection { sway = }, "
                    "says which",
                    line_of_member(s.model(), n.member)};
    }
}

class RunNotices : public Adviser {
public:
    RunNotices(const Run& run, WarningLog& log) : log_(log) { after_step(run); }
    void after_step(const Run& run) override {
        for (; told_ < run.notices().size(); ++told_) log_.add(warning_of(run.notices()[told_], run.structure()));
    }
    void save(Writer& to) const override { to(told_); }
    void restore(Reader& from) override { from(told_); }
    bool goes_on() const override { return false; }

private:
    WarningLog& log_;
    std::size_t told_ = 0;
};

class RunEnd : public Adviser {
public:
    explicit RunEnd(WarningLog& log) : log_(log) {}
    void finish(const Run& run) override {
        if (run.verdict() != Verdict::completed) return;
        if (const auto* statics = run.statics()) warn_if_nothing_acts(*statics);
        if (const auto* dynamics = run.dynamics()) warn_of_energy_error(*dynamics);
    }

private:
    /// A run whose results are all 0, since a load or a load case was forgotten.
    void warn_if_nothing_acts(const Statics& run) {
        for (std::size_t i = 0; i < run.state().displacement.size(); ++i)
            if (!run.displacement(int(i)).isZero(0) || !run.load_on(int(i)).isZero(0)) return;
        for (const Vec6& p : run.state().force)
            if (!p.isZero(0)) return;
        log_.add({Warning::Kind::loads, "nothing acts in this run: no load, no weight, no settlement, no heat",
                  "declare a load with model:load, or the weight with model:gravity, and see that its load case is "
                  "among those of the run"});
    }
    /// Whatever energy_tolerance is: a run that completes with a large energy error, or had one on its way.
    void warn_of_energy_error(const Dynamics& run) {
        if (run.structure().model().options().shift == Shift::elastic_and_plastic) return;
        const double share = run.energy_error_share();
        const LargestError& worst = run.largest_error();
        const bool large = !(std::abs(share) <= large_error);
        if (!large && std::abs(worst.share) <= large_error) return;
        char what[160];
        if (large)
            std::snprintf(what, sizeof what, "the energy error at the end of the run is %.3g %% of the largest energy",
                          100 * share);
        else
            std::snprintf(what, sizeof what,
                          "the energy error at t = %.4g s was %.3g %% of the largest energy up to then (at the end of "
                          "the run %.3g %%)",
                          worst.time, 100 * worst.share, 100 * share);
        log_.add({Warning::Kind::energy, what,
                  "a shorter dt, dt = \"auto\" or more elements a member may make it smaller; see step_control"});
    }

    WarningLog& log_;
};

}  // namespace

std::unique_ptr<Adviser> advise_of_notices(const Run& run, WarningLog& log) {
    return std::make_unique<RunNotices>(run, log);
}

std::unique_ptr<Adviser> advise_of_ends(const Run&, WarningLog& log) { return std::make_unique<RunEnd>(log); }

}  // namespace hinge
