// What a round of a return to the yield surface holds constant, where the strength follows the rotation of a hinge or
// the back resultants follow the flow: the flow and the factor of the round before (flow_return.h).
#pragma once

#include <cmath>

#include "core/types.h"

namespace hinge::beam {

/// The factor that follows the rotation, from round to round. A round that takes the factor s leads to a rotation whose
/// factor is F(s). A falling strength: F(s) rises, and the next round takes F(s); so s comes down to the first s that
/// is F(s). A rising one: F(s) falls, and s may jump to and fro; then it is looked for between the two.
class FactorSearch {
public:
    double next(double s, double F) {
        const double off = F - s, ratio = rounds_ > 0 && last_off_ != 0 ? off / last_off_ : 0;
        (off > 0 ? low_ : high_) = s;
        double out = F;
        if (low_ < high_ && std::isfinite(low_) && std::isfinite(high_)) {
            if (rounds_ > 0 && off != last_off_) out = s - off * (s - last_) / (off - last_off_);
            if (!(out > low_ && out < high_)) out = 0.5 * (low_ + high_);
        } else if (rounds_ > 6 && rounds_ % 4 == 0 && ratio > 0 && ratio < 0.95) {
            out = s + off / (1 - ratio);  // where rounds that shrink alike come to
        }
        // the other end changes what F is
        if (++rounds_ % 12 == 0 || high_ - low_ < 1e-12) low_ = -INFINITY, high_ = INFINITY;
        last_ = s, last_off_ = off;
        return out;
    }

private:
    double low_ = -INFINITY, high_ = INFINITY, last_ = 0, last_off_ = 0;
    int rounds_ = 0;
};

/// Of the two sections of an element.
struct HeldRound {
    struct Section {
        double strain = 0;  ///< growth of the mean plastic strain
        Vec4 e = Vec4::Zero();
        double factor = 0;  ///< of the rounds after the first
        FactorSearch search;
    } of[2];
    bool first = true;  ///< the factors are those of the start of the step
};

}  // namespace hinge::beam
