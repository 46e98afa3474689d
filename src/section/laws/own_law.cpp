// What a section's flow does to its strength, as a function of the script's own: a factor on the yield surface, and
// back resultants by which it moves. The function is asked in every round of the return of a section that flows, with
// what the round before found. Back resultants that grow in proportion to the flow are found in the first round.
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "section/laws/laws.h"

namespace hinge::beam {
namespace {

constexpr double slope_step = 1e-6;  ///< part of a step by which the slope is found
/// Parts of a step that the function is asked for at once: its end and the slope there, or its middle.
constexpr std::array at_end_of_step{1.0, 1 + slope_step};
constexpr std::array at_middle{0.5};

class OwnLaw : public MaterialLaw {
public:
    OwnLaw(SectionRule rule, int variables) : rule_(std::move(rule)), variables_(variables) {
        std::vector<double> none(variables_, 0.0);
        initial_ = one({}, none.data()).strength;
    }

    const char* name() const override { return "law"; }
    std::string words() const override { return "a law of the script"; }
    void save(Writer& to) const override { to(initial_, variables_); }
    bool calls_script() const override { return true; }

    int history_size() const override { return first + variables_; }
    void start(bool end_of_member, double* history) const override {
        history[at_end] = end_of_member;
        keep(one({.at_end = end_of_member}, history + first), history);
    }
    bool moves_surface() const override { return true; }
    double initial() const override { return initial_; }

    bool follows_rotation() const override { return true; }
    Turned turned(const PlasticZone& zone, const double* history, const Vec4& e, double work) const override {
        const double now = history ? history[strength] : initial_;
        if (!(work > 0)) return {now, 0};
        const std::vector<SectionAnswer>& at = ask(zone, history, e, work);
        return {at[0].strength, (at[1].strength - at[0].strength) / (slope_step * work)};
    }
    /// By Simpson's rule over the step.
    double mean_turned(const PlasticZone& zone, const double* history, const Vec4& e, double work) const override {
        const double now = history ? history[strength] : initial_;
        if (!(work > 0)) return now;
        return (now + 4 * ask(zone, history, e, work, at_middle)[0].strength +
                ask(zone, history, e, work)[0].strength) /
               6;
    }

    bool back_follows_flow() const override { return true; }
    void add_back(const PlasticZone& zone, const double* history, double strain, const Vec4& e, Vec4& back,
                  Vec4& modulus) const override {
        const Vec4 start = history ? Vec4(history[moved], history[moved + 1], history[moved + 2], history[moved + 3])
                                   : Vec4(Vec4::Zero());
        back += start.cwiseProduct(zone.per_strength);
        if (e.isZero(0)) return;
        const Vec4 change =
            (ask(zone, history, e, strain * zone.energy)[0].back - start).cwiseProduct(zone.per_strength);
        for (int c = 0; c < 4; ++c) {
            const double slope = change[c] / e[c];
            if (slope >= 0 && std::abs(e[c]) > 1e-9 * e.norm()) modulus[c] += slope;
            else back[c] += change[c];
        }
    }

    void commit(const PlasticZone& zone, const Vec4& e, double strain, double, double* history) const override {
        keep(ask(zone, history, e, strain * zone.energy)[0], history);
    }

private:
    /// History variables: the strength and the back resultants (N m, N) at the end of the step before, 1 at the ends of
    /// the member, then those of the function.
    enum { strength, moved, at_end = moved + 4, first };

    SectionAnswer one(const SectionFlow& flow, const double* history) const {
        return rule_(std::span(&flow, 1), history)[0];
    }

    /// A call of the function, and its answers. A round asks again what the round before has found.
    struct Question {
        Vec4 e = Vec4::Zero();
        double work = 0;
        std::span<const double> parts;
        bool at_end = true;
        std::vector<double> history;
        std::vector<SectionAnswer> answers;
    };

    /// The answers at `parts` of a step with e that does `work`.
    const std::vector<SectionAnswer>& ask(const PlasticZone& zone, const double* history, const Vec4& e, double work,
                                          std::span<const double> parts = at_end_of_step) const {
        std::vector<double> start(std::size_t(variables_), 0.0);
        if (history) std::copy_n(history + first, variables_, start.begin());
        const bool end = !history || history[at_end] > 0;
        for (const Question& q : asked_)
            if (q.work == work && q.e == e && q.parts.data() == parts.data() && q.at_end == end && q.history == start &&
                !q.answers.empty())
                return q.answers;
        std::vector<SectionFlow> flows(parts.size());
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const Vec4 d = parts[i] * e.cwiseProduct(zone.per_strength);
            flows[i] = {d[0], d[1], d[2], d[3], parts[i] * work / zone.energy, end};
        }
        Question& q = asked_[next_++ % asked_.size()];
        q.answers.clear();
        q.answers = rule_(flows, start.data());
        q.e = e, q.work = work, q.parts = parts, q.at_end = end, q.history = std::move(start);
        return q.answers;
    }
    void keep(const SectionAnswer& answer, double* history) const {
        history[strength] = answer.strength;
        for (int c = 0; c < 4; ++c) history[moved + c] = answer.back[c];
        for (std::size_t i = 0; i < answer.history.size(); ++i) history[first + i] = answer.history[i];
    }

    SectionRule rule_;
    int variables_;
    double initial_ = 1;
    mutable std::array<Question, 4> asked_;  ///< the last ones; a run that calls the script has one thread
    mutable std::size_t next_ = 0;
};

}  // namespace

std::shared_ptr<const MaterialLaw> own_law(SectionRule rule, int variables) {
    return std::make_shared<OwnLaw>(std::move(rule), variables);
}

}  // namespace hinge::beam
