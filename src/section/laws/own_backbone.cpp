// A backbone as a function of the script's own: the strength of the ends of a member over what their hinges have gone
// through. It is used as the backbone of section/laws/backbone.cpp is: the end of the member alone follows it, the
// factor is looked for in rounds, and it may fall.
#include <algorithm>
#include <cmath>

#include "section/laws/laws.h"

namespace hinge::beam {
namespace {

constexpr double far_rotation = 0.5, apart = 0.005;  ///< rad: where the greatest strength is looked for
constexpr double difference = 1e-6;                  ///< part of a step by which the slope is found

class OwnBackbone : public MaterialLaw {
public:
    explicit OwnBackbone(BackboneRule rule) : rule_(std::move(rule)) {
        initial_ = rule_({});
        for (double r = 0; r <= far_rotation; r += apart) greatest_ = std::max(greatest_, rule_({r, 0, r, 0}));
    }

    const char* name() const override { return "backbone"; }
    std::string words() const override { return "backbone (a function of the script)"; }
    void save(Writer& to) const override { to(initial_, greatest_); }
    bool calls_script() const override { return true; }

    int history_size() const override { return 5; }
    void start(bool end_of_member, double* history) const override { history[inside] = end_of_member ? 0 : 1; }
    bool moves_surface() const override { return true; }
    double initial() const override { return initial_; }

    bool follows_rotation() const override { return true; }
    /// The mean is that of Simpson's rule over the step.
    Turned turned(const PlasticZone& zone, const double* history, const Vec4& e, double work) const override {
        if (history && history[inside] > 0) return {greatest_, 0, greatest_};
        const auto factor = [&](double part) { return rule_(after(zone, history, part * e, part * work)); };
        Turned out;
        out.factor = factor(1);
        out.mean = work > 0 ? (factor(0) + 4 * factor(0.5) + out.factor) / 6 : out.factor;
        if (work > 0) out.slope = (factor(1 + difference) - out.factor) / (difference * work);
        return out;
    }
    void commit(const PlasticZone& zone, const Vec4& e, double strain, double, double* history) const override {
        if (history[inside] > 0) return;
        const HingePast now = after(zone, history, e, strain * zone.energy);
        history[about_x] = now.x, history[about_y] = now.y, history[largest] = now.largest,
        history[work_done] = now.work;
    }

private:
    enum { inside, about_x, about_y, largest, work_done };  ///< history variables

    static HingePast after(const PlasticZone& zone, const double* history, const Vec4& e, double work) {
        HingePast past;
        if (history) past = {history[largest], history[work_done], history[about_x], history[about_y]};
        past.x += e[0] * zone.per_strength[0], past.y += e[1] * zone.per_strength[1];
        past.largest = std::max(past.largest, std::hypot(past.x, past.y));
        past.work += work;
        return past;
    }

    BackboneRule rule_;
    double initial_ = 0, greatest_ = 0;
};

}  // namespace

std::shared_ptr<const MaterialLaw> backbone_law(BackboneRule rule) {
    return std::make_shared<OwnBackbone>(std::move(rule));
}

}  // namespace hinge::beam
