#include "model/history.h"

#include <algorithm>

namespace hinge {
namespace {

constexpr double rounding = 1e-6;  ///< of a step: a jump so near to its end is at its end

double up_to(const History::Points& points, double t) {
    if (t <= points.front().first) return points.front().second;
    for (std::size_t i = 1; i < points.size(); ++i)
        if (t <= points[i].first) {
            const double share = (t - points[i - 1].first) / (points[i].first - points[i - 1].first);
            return (1 - share) * points[i - 1].second + share * points[i].second;
        }
    return points.back().second;
}

}  // namespace

History::History(Points points) : points_(std::make_shared<const Points>(std::move(points))) {
    function_ = [points = points_](double t) { return up_to(*points, t); };
}

double History::from(double t) const {
    if (!points_) return function_(t);
    for (std::size_t i = points_->size(); i-- > 0;)
        if ((*points_)[i].first == t) return (*points_)[i].second;
    return function_(t);
}

History::Over History::over(double begin, double end) const {
    if (!points_) return {function_(begin), function_(end)};
    const double tolerance = rounding * (end - begin);
    double first = function_(begin), last = function_(end);
    bool broken = false, jumps_at_end = false;
    for (std::size_t i = 1; i < points_->size(); ++i) {
        const auto &a = (*points_)[i - 1], &b = (*points_)[i];
        const auto within = [&](double t) { return t > begin + tolerance && t < end - tolerance; };
        if (a.second == b.second || a.first > end + tolerance || b.first < begin - tolerance) continue;
        broken = broken || within(a.first) || within(b.first);  // a kink, or one end of a jump
        if (b.first - a.first > 2 * tolerance) continue;
        if (b.first <= begin + tolerance) first = b.second;
        else if (a.first >= end - tolerance) last = jumps_at_end ? last : a.second, jumps_at_end = true;
    }
    if (!broken) return {first, last};
    const double all = mean(begin, end);
    return {all, all};
}

double History::mean(double begin, double end) const {
    double sum = 0, from = begin;
    for (std::size_t i = 0; i <= points_->size() && from < end; ++i) {
        const double to = i < points_->size() ? std::clamp((*points_)[i].first, begin, end) : end;
        if (to <= from) continue;
        // within a straight piece the value in its middle is the mean
        sum += (to - from) * function_(0.5 * (from + to));
        from = to;
    }
    return sum / (end - begin);
}

bool History::may_jump_in(double dt) const {
    if (!points_) return false;
    for (std::size_t i = 1; i < points_->size(); ++i) {
        const auto &a = (*points_)[i - 1], &b = (*points_)[i];
        if (a.second != b.second && b.first - a.first < (1 - 2 * rounding) * dt) return true;
    }
    return false;
}

bool History::bends_within(double begin, double end) const {
    if (!points_) return false;
    return std::any_of(points_->begin(), points_->end(),
                       [&](const auto& p) { return p.first > begin && p.first <= end; });
}

}  // namespace hinge
