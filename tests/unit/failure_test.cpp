// Failures as values: each cause has a word and a text of its own, and what no run can have is refused.
#include <set>

#include "advice/remedies.h"
#include "helpers.h"
#include "run/failure_check.h"

using namespace hinge;
using namespace hinge::test;

namespace {

std::shared_ptr<const Structure> bar() {
    Frame frame(small_displacement(Formulation::conventional));
    frame.elements = 1;
    straight(frame, Vec3::Zero(), Vec3(2, 0, 0), 2);
    return std::make_shared<const Structure>(frame.model, MassKind::consistent);
}

/// A failure with all that its text may need.
Failure with_all(Cause cause) { return {.cause = cause, .node = 1, .element = 1, .other = 0, .component = 2}; }

}  // namespace

TEST_CASE("failure: each cause has a word and a sentence of its own") {
    const auto structure = bar();
    std::set<std::string> words, texts;
    for (int i = 1; i < cause_count; ++i) {
        words.insert(word(Cause(i)));
        texts.insert(text_of(with_all(Cause(i)), *structure));
    }
    CHECK(words.size() == std::size_t(cause_count - 1));
    CHECK(texts.size() == std::size_t(cause_count - 1));
    CHECK(words.count("") == 0);
    CHECK(texts.count("") == 0);
    CHECK(std::string(word(Cause::none)).empty());
    CHECK(!Failure{});
}

TEST_CASE("failure: remarks follow the sentence, and a brief text has none of them") {
    const auto structure = bar();
    RunFailure f{with_all(Cause::element_folded)};
    f.what.step = 3, f.what.time = 0.5;
    f.remarks.push_back({Remark::Kind::halved, {.value = 1e-6}});
    f.remarks.push_back({Remark::Kind::before, with_all(Cause::energy_error)});
    const std::string whole = text_of(f, *structure), sentence = text_of(f.what, *structure);
    INFO(whole);
    CHECK(sentence.starts_with("step 3, t = 0.5 s: an end of element 1 of member 2"));
    CHECK(whole == sentence +
                       "; more elements a member may help; dt was halved down to 1e-06 s, and no shorter step is tried"
                       "; before it, step 0, t = 0 s: the energy balance no longer closes, its error is 0 % of the "
                       "largest energy (energy_tolerance 0 %)");
    CHECK(text_of_rest(f, *structure, true).empty());
    f.remarks.push_back({Remark::Kind::path_turns});
    CHECK(text_of_rest(f, *structure, true) == ": the path turns too sharply or ends there");
}

TEST_CASE("failure: nodes, elements and kinds that do not exist are refused, as in a damaged checkpoint") {
    const auto structure = bar();
    const auto good = [&](const RunFailure& f) { return makes_sense(f, *structure); };
    CHECK(good({}));
    for (int i = 1; i < cause_count; ++i) CHECK(good({with_all(Cause(i))}));
    CHECK(!good({with_all(Cause(cause_count))}));
    CHECK(!good({with_all(Cause(-1))}));
    const auto changed = [&](auto change) {
        RunFailure f{with_all(Cause::load_not_finite)};
        f.remarks.push_back({Remark::Kind::limit_point, f.what});
        REQUIRE(good(f));
        change(f);
        return good(f);
    };
    CHECK(!changed([](RunFailure& f) { f.what.node = 3; }));
    CHECK(!changed([](RunFailure& f) { f.what.node = -1; }));
    CHECK(!changed([](RunFailure& f) { f.what.element = 2; }));
    CHECK(!changed([](RunFailure& f) { f.what.other = -2; }));
    CHECK(!changed([](RunFailure& f) { f.what.component = 6; }));
    CHECK(!changed([](RunFailure& f) { f.remarks[0].of.node = -1; }));
    CHECK(!changed([](RunFailure& f) { f.remarks[0].of.component = -1; }));
    CHECK(!changed([](RunFailure& f) { f.remarks[0].kind = Remark::Kind(99); }));
}

TEST_CASE("failure: advice names the setting that held, and one that does not exist is refused") {
    const auto structure = bar();
    const Advice holds{.kind = Advice::Kind::holds, .from = 0.25, .to = 1, .remedies = {{Remedy::Kind::direct_solver}}};
    CHECK(text_of(holds, *structure) == "; solver = 'direct' holds: tried from t = 0.25 s to 1 s");
    const auto changed = [&](auto change) {
        Advice a{.kind = Advice::Kind::more_nodes, .element = 0, .remedies = {{Remedy::Kind::dt}}};
        REQUIRE(makes_sense(a, *structure));
        change(a);
        return makes_sense(a, *structure);
    };
    CHECK(!changed([](Advice& a) { a.element = -1; }));
    CHECK(!changed([](Advice& a) { a.kind = Advice::Kind(9); }));
    CHECK(!changed([](Advice& a) { a.why = Advice::Untried(9); }));
    CHECK(!changed([](Advice& a) { a.remedies[0].kind = Remedy::Kind(99); }));
}
