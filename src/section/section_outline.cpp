#include "section/section_outline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <vector>

#include "core/errors.h"
#include "core/text.h"

namespace hinge::beam {

std::array<double, 2> SectionOutline::axial_range() const {
    const double N0 = domain()->strength()[2], middle = domain()->centre()[2];
    return {N0 * (middle - 1), N0 * (middle + 1)};
}

double SectionOutline::largest_moment(int axis) const {
    const double there = domain()->contour(0, axis * std::numbers::pi / 2)[axis],
                 back = domain()->contour(0, std::numbers::pi * (1 + axis / 2.0))[axis];
    return domain()->strength()[axis] * std::max(std::abs(there), std::abs(back));
}

Eigen::Vector2d SectionOutline::moments(double N, double angle) const {
    const Vec3 strength = domain()->strength();
    const double normalised = std::atan2(strength[1] * std::sin(angle), strength[0] * std::cos(angle));
    return domain()->contour(N / strength[2], normalised).cwiseProduct(strength.head<2>());
}

namespace {

/// Least part of the strength about the middle of the domain that must be left about zero.
constexpr double least_strength = 1e-3;

std::string text(double value) { return number_text(value, 10); }

bool odd_crossings(const std::vector<Eigen::Vector2d>& corners, const Eigen::Vector2d& at) {
    bool odd = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Eigen::Vector2d &a = corners[i], &b = corners[(i + 1) % corners.size()];
        if ((a.y() > at.y()) != (b.y() > at.y()) &&
            at.x() < a.x() + (at.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
            odd = !odd;
    }
    return odd;
}

double distance(const std::vector<Eigen::Vector2d>& corners, const Eigen::Vector2d& at) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Eigen::Vector2d &a = corners[i], side = corners[(i + 1) % corners.size()] - a;
        const double length = side.squaredNorm(),
                     along = length > 0 ? std::clamp((at - a).dot(side) / length, 0.0, 1.0) : 0;
        least = std::min(least, (at - a - along * side).norm());
    }
    return least;
}

bool holds(const Outline& outline, const Eigen::Vector2d& at, double radius) {
    bool in = false;
    for (const auto& c : outline.circles) {
        const double off = (at - c.centre).norm();
        if (c.hole && off < c.radius + radius) return false;
        in |= !c.hole && off <= c.radius - radius;
    }
    for (const auto& p : outline.polygons) {
        const bool inside = odd_crossings(p.corners, at), clear = distance(p.corners, at) >= radius;
        if (p.hole && (inside || !clear)) return false;
        in |= !p.hole && inside && clear;
    }
    return in;
}

void check_parts(const Outline& outline, const std::string& what) {
    for (std::size_t i = 0; i < outline.polygons.size(); ++i) {
        const std::string part = what + ", outline, polygon " + std::to_string(i + 1);
        const std::size_t corners = outline.polygons[i].corners.size();
        if (corners < 3)
            throw InputError(part + ": field 'corners' has " + std::to_string(corners) +
                             " corners; must be a list of three or more, each {x, y} in m");
        Outline alone;
        alone.polygons = {{outline.polygons[i].corners}};
        if (!(alone.area() > 0)) throw InputError(part + ": its area is 0 m^2; its corners are on one line");
    }
    for (std::size_t i = 0; i < outline.circles.size(); ++i)
        if (!(outline.circles[i].radius > 0))
            throw FieldError(what + ", outline, circle " + std::to_string(i + 1), "diameter", "0 m; must be above 0 m");
    if (!(outline.area() > 0))
        throw FieldError(what, "outline",
                         "with an area of " + text(outline.area()) +
                             " m^2; the area must be above 0: a hole (hole = true) lies within a part that is none");
}

void check_strains(const ConcreteStrains& s, const std::string& what) {
    const auto complain = [&](const char* field, double value, const char* unit, const std::string& allowed) {
        throw FieldError(what, field, text(value) + unit + "; " + allowed);
    };
    if (s.bars < 1e9) complain("bars", s.bars, " Pa", "E of the bars: must be 1e9 Pa or more");
    if (!(s.ultimate >= s.peak && s.ultimate < 0.1))
        complain("ultimate", s.ultimate, "", "must be at least `peak`, " + text(s.peak) + ", and below 0.1");
    if (!(s.exponent >= 1)) complain("exponent", s.exponent, "", "must be 1 or more");
    if (!(s.block < s.peak))
        complain("block", s.block, "", "must be below `peak`, " + text(s.peak) + ", where all is pressed");
}

void check_bars(const Reinforcement& concrete, const Outline& outline, const std::string& what) {
    if (concrete.bars.empty())
        throw FieldError(what, "bars",
                         "empty; must be a list of bars: { { x, y, area =, tension =, compression = }, ... }; without "
                         "bars the section has no strength in tension");
    for (std::size_t i = 0; i < concrete.bars.size(); ++i) {
        const Reinforcement::Bar& bar = concrete.bars[i];
        const std::string its = what + ", bar " + std::to_string(i + 1);
        if (!(bar.compression >= concrete.concrete))
            throw FieldError(its, "compression",
                             text(bar.compression) + " Pa; a bar must be as strong as the concrete it displaces, " +
                                 text(concrete.concrete) + " Pa");
        const std::string place = "{" + text(bar.centre.x()) + ", " + text(bar.centre.y()) + "} m";
        if (!holds(outline, bar.centre, (1 - 1e-9) * bar.radius()))
            throw InputError(its + " at " + place + " is not within the outline; its radius is " + text(bar.radius()) +
                             " m, and all of the bar must be in the concrete");
        for (std::size_t k = 0; k < i; ++k)
            if ((concrete.bars[k].centre - bar.centre).norm() < (1 - 1e-9) * (concrete.bars[k].radius() + bar.radius()))
                throw InputError(its + " at " + place + " overlaps bar " + std::to_string(k + 1) +
                                 "; two bars must be apart by the sum of their radii");
    }
}

/// All numbers of an outline with its bars.
std::vector<double> numbers_of(const Outline& outline, const Reinforcement& concrete) {
    std::vector<double> all = {concrete.concrete};
    for (const auto& p : outline.polygons) {
        all.insert(all.end(), {double(p.corners.size()), double(p.hole)});
        for (const auto& c : p.corners) all.insert(all.end(), {c.x(), c.y()});
    }
    for (const auto& c : outline.circles)
        all.insert(all.end(), {-1.0, c.centre.x(), c.centre.y(), c.radius, double(c.hole)});
    for (const auto& b : concrete.bars)
        all.insert(all.end(), {-2.0, b.centre.x(), b.centre.y(), b.area, b.tension, b.compression});
    if (const auto& s = concrete.strains)
        all.insert(all.end(), {-3.0, s->peak, s->ultimate, s->exponent, s->block, s->bars});
    return all;
}

/// An outline with bars: the same object for equal ones that are in use. Its domain takes up to 0.2 s.
std::shared_ptr<const SectionOutline> share(Outline outline, Reinforcement concrete) {
    static std::mutex mutex;
    static std::map<std::vector<double>, std::weak_ptr<const SectionOutline>> made;
    const std::lock_guard lock(mutex);
    std::erase_if(made, [](const auto& entry) { return entry.second.expired(); });
    auto& known = made[numbers_of(outline, concrete)];
    auto found = known.lock();
    if (!found) known = found = std::make_shared<const SectionOutline>(std::move(outline), std::move(concrete));
    return found;
}

}  // namespace

std::shared_ptr<const SectionOutline> make_section_outline(Outline outline, std::optional<Reinforcement> concrete,
                                                           const std::string& what) {
    check_parts(outline, what);
    if (concrete && concrete->strains) check_strains(*concrete->strains, what + ", reinforcement, strains");
    if (concrete) check_bars(*concrete, outline, what + ", reinforcement");
    const Eigen::Vector2d centroid = outline.centroid();
    outline.move(-centroid);
    if (!concrete) return std::make_shared<const SectionOutline>(std::move(outline));
    for (auto& bar : concrete->bars) bar.centre -= centroid;
    const auto made = share(std::move(outline), std::move(*concrete));
    if (!(made->domain()->ellipsoid().minCoeff() > least_strength))
        throw FieldError(what, "reinforcement",
                         "too little; the bars leave less than " + text(least_strength) +
                             " of the strength in some direction of N, Mx and My; give more of them, on more sides");
    return made;
}

}  // namespace hinge::beam
