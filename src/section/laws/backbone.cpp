// Backbone of a plastic hinge: its strength over its plastic rotation, as tests of beams and columns give it.
//
// The rotation counts, not a strain: the hinge at the end of a member is the same however many elements the member has.
// Only the ends of a member are such hinges. Sections between them have the greatest strength of the backbone, without
// a fall: the hinge of a member that softens stays at its end.
//
// A hinge follows the backbone at the largest plastic rotation that it has had, |(rotation about x, about y)|, in
// either direction. Each cycle wears it as well, as far as `wear` is given (Ibarra, Medina and Krawinkler 2005, with
// the exponent 1). There an excursion of the plastic work dE takes dE / (Et - E) of the strength in its own direction,
// with Et = wear My. Each direction has half of the work of a cycle, so that the strength falls by the factor
// sqrt(1 - E / Et), down to the residual one: over the rotation in a straight line, for E falls with it.
//
// Their stiffness in unloading falls in the same way, but with the work of both directions: to the part 1 - E / Et of
// 6 EI / L, the stiffness of an end of the member in double curvature. It stays where the strength is the residual one,
// and at a tenth. What is lost is a spring in series with the member (elastic_pair.h). What the spring turns by while
// it grows softer is part of the rotation of the step, as the plastic rotation is.
#include <algorithm>
#include <cmath>

#include "core/errors.h"
#include "core/text.h"
#include "section/laws/laws.h"

namespace hinge::beam {
namespace {

class BackboneLaw : public MaterialLaw {
public:
    explicit BackboneLaw(const Backbone& b) : of_(b) {
        for (const auto& p : of_.points) greatest_ = std::max(greatest_, p.strength);
    }

    const Backbone& of() const { return of_; }
    const char* name() const override { return "backbone"; }
    std::string words() const override {
        std::string text;
        for (const auto& p : of_.points)
            text += (text.empty() ? "" : ", ") + number_text(p.strength) +
                    (p.rotation > 0 ? " at " + number_text(p.rotation) + " rad" : "");
        if (of_.wear > 0) text += "; wear " + number_text(of_.wear) + " rad";
        if (of_.wears_stiffness) text += " of strength and stiffness";
        if (of_.wear > 0 && of_.residual > 0) text += " down to " + number_text(of_.residual);
        return "backbone (" + text + ")";
    }
    void save(Writer& to) const override {
        for (const auto& p : of_.points) to(p.rotation, p.strength);
        to(of_.wear, of_.residual);
        if (of_.wears_stiffness) to(of_.wears_stiffness);
    }

    int history_size() const override { return 5; }
    void start(bool end_of_member, double* history) const override { history[inside] = end_of_member ? 0 : 1; }
    bool moves_surface() const override { return true; }
    double initial() const override { return of_.points.front().strength; }

    bool wears_stiffness() const override { return of_.wears_stiffness; }
    double softness(const PlasticZone& zone, const double* history, const Vec4& e) const override {
        if (!of_.wears_stiffness || history[inside] > 0) return 0;
        const double least = std::max(of_.residual / of_.points.front().strength, std::sqrt(least_stiffness)),
                     left = std::max(std::min(least, 1.0), step(zone, history, e).worn_to);
        return 1 / (left * left) - 1;
    }

    bool follows_rotation() const override { return true; }
    Turned turned(const PlasticZone& zone, const double* history, const Vec4& e, double work) const override {
        if (history && history[inside] > 0) return {greatest_, 0};
        const Step s = step(zone, history, e);
        Turned out;
        const double floor = floor_of(s);
        out.factor = std::max(floor, s.strength * s.worn_to);
        if (out.factor > floor && work > 0) {
            if (s.largest_to > s.largest_from) out.slope = s.slope * s.worn_to * s.to.dot(s.by) / s.to.norm() / work;
            if (of_.wear > 0) out.slope -= s.strength * s.worn_by / work;
        }
        return out;
    }
    double mean_turned(const PlasticZone& zone, const double* history, const Vec4& e, double) const override {
        if (history && history[inside] > 0) return greatest_;
        const Step s = step(zone, history, e);
        return std::max(floor_of(s), 0.5 * s.mean * (s.worn_from + s.worn_to));
    }
    void commit(const PlasticZone& zone, const Vec4& e, double, double, double* history) const override {
        if (history[inside] > 0) return;
        const Step s = step(zone, history, e);
        history[about_x] = s.to[0], history[about_y] = s.to[1];
        history[largest] = s.largest_to;
        history[worn] = 1 - s.worn_to;
    }

private:
    /// History variables. worn: the part of the strength that cycles have taken.
    enum { inside, about_x, about_y, largest, worn };
    static constexpr double least_strength = 0.01, least_stiffness = 0.1;

    struct Step {
        Eigen::Vector2d by, to;           ///< plastic rotation, rad
        double largest_from, largest_to;  ///< rad
        double strength, slope, mean;     ///< of the backbone at the end, over the rotation, mean of the step
        double worn_from, worn_to;        ///< factors
        double worn_by = 0;               ///< half of the step's plastic work over wear My, were nothing worn
    };
    double floor_of(const Step& s) const { return std::max(least_strength, std::min(of_.residual, s.strength)); }
    Step step(const PlasticZone& zone, const double* history, const Vec4& e) const {
        Step s;
        s.by = Eigen::Vector2d(e[0], e[1]).cwiseProduct(zone.per_strength.head<2>());
        s.to = s.by;
        if (history) s.to += Eigen::Vector2d(history[about_x], history[about_y]);
        s.largest_from = history ? history[largest] : 0, s.largest_to = std::max(s.largest_from, s.to.norm());
        s.mean = strength_at(s.largest_from), s.strength = strength_at(s.largest_to, &s.slope);
        const double turn = s.by.norm(), new_part = s.largest_to - s.largest_from;
        if (new_part > 0) {  // of the step's rotation
            const double part = std::min(1.0, new_part / turn);
            s.mean += part * ((area(s.largest_to) - area(s.largest_from)) / new_part - s.mean);
        }
        s.worn_from = s.worn_to = 1 - (history ? history[worn] : 0);
        if (of_.wear > 0) {
            s.worn_by = 0.5 * turn * s.mean / of_.points.front().strength / of_.wear;
            s.worn_to = std::max(0.0, s.worn_to - s.worn_by);
        }
        return s;
    }

    /// Strength at a largest rotation; `slope`: over it, 1/rad.
    double strength_at(double rotation, double* slope = nullptr) const {
        if (slope) *slope = 0;
        const auto& p = of_.points;
        for (std::size_t i = 1; i < p.size(); ++i) {
            if (rotation > p[i].rotation) continue;
            const double s = (p[i].strength - p[i - 1].strength) / (p[i].rotation - p[i - 1].rotation);
            if (slope) *slope = s;
            return p[i - 1].strength + s * (rotation - p[i - 1].rotation);
        }
        return p.back().strength;
    }
    /// Integral of the strength over the rotation from 0 on.
    double area(double rotation) const {
        double sum = 0, from = 0;
        const auto& p = of_.points;
        for (std::size_t i = 1; i < p.size() && from < rotation; ++i) {
            const double to = std::min(rotation, p[i].rotation);
            sum += 0.5 * (to - from) * (strength_at(from) + strength_at(to)), from = to;
        }
        return sum + (rotation - from) * p.back().strength;
    }

    Backbone of_;
    double greatest_ = 0;
};

}  // namespace

std::shared_ptr<const MaterialLaw> backbone_law(const Backbone& b) {
    if (b.points.empty() || b.points.front().rotation != 0)
        throw InputError("a backbone begins at a plastic rotation of 0 rad");
    for (std::size_t i = 0; i < b.points.size(); ++i) {
        const auto& p = b.points[i];
        if (!(std::isfinite(p.rotation) && (i == 0 || p.rotation > b.points[i - 1].rotation)))
            throw InputError("the plastic rotations of a backbone must rise from point to point");
        if (!(std::isfinite(p.strength) && p.strength >= 0.01))
            throw InputError("the strengths of a backbone must be 0.01 or more");
    }
    if (!(std::isfinite(b.residual) && b.residual >= 0)) throw InputError("the residual strength must be 0 or more");
    if (!(std::isfinite(b.wear) && b.wear >= 0)) throw InputError("wear must be 0 rad or more");
    if (b.wears_stiffness && b.wear == 0) throw InputError("wear of stiffness needs wear, in rad");
    return std::make_shared<BackboneLaw>(b);
}

const Backbone* backbone_of(const MaterialLaw& law) {
    const auto* backbone = dynamic_cast<const BackboneLaw*>(&law);
    return backbone ? &backbone->of() : nullptr;
}

}  // namespace hinge::beam
